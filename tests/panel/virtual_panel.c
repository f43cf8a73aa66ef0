/* What all virtual controllers share: wires, time, commands with their parameters, the window, and the verdict. */
#include "virtual_panel.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void virtual_complain(virtual_panel *panel, const char *format, ...) {
  if (panel->errors++ == 0) {
    va_list arguments;
    int n = snprintf(panel->error, sizeof panel->error, "%s: ", panel->model->name);
    va_start(arguments, format);
    vsnprintf(panel->error + n, sizeof panel->error - (size_t)n, format, arguments);
    va_end(arguments);
  }
}

void virtual_open(virtual_panel *panel, const virtual_model *model) {
  uint32_t i, noise = 1;
  memset(panel, 0, sizeof *panel);
  panel->model = model;
  for (i = 0; i < VIRTUAL_MEMORY_MAX; i++) {
    noise = noise * UINT32_C(1664525) + UINT32_C(1013904223);
    panel->memory[i] = noise >> 8;
  }
  model->family->reset(panel);
}

void virtual_time(virtual_panel *panel, uint32_t us) { panel->now_us += us; }

void virtual_clock(virtual_panel *panel, uint32_t hz, uint8_t spi_mode) {
  panel->hz = hz;
  panel->spi_mode = spi_mode;
}

void virtual_reset(virtual_panel *panel, bool active) {
  const virtual_model *model = panel->model;
  if (active) {
    if (!panel->in_reset) panel->reset_since_us = panel->now_us;
    panel->in_reset = true;
    return;
  }
  if (!panel->in_reset) return;
  panel->in_reset = false;
  if (panel->now_us - panel->reset_since_us < model->reset_low_us) {
    virtual_complain(panel, "reset was held for %lu us, the data sheet asks for %lu",
                     (unsigned long)(panel->now_us - panel->reset_since_us),
                     (unsigned long)model->reset_low_us);
  }
  panel->command_open = false;
  panel->parts = 0;
  model->family->reset(panel);
  panel->ready_at_us = panel->now_us + model->reset_wait_us;
  panel->wake_at_us = panel->now_us + 120000;
}

void virtual_whole_pixels(virtual_panel *panel) {
  if (panel->parts != 0)
    virtual_complain(panel, "%u odd byte%s after pixel %lu", panel->parts, panel->parts > 1 ? "s" : "",
                     panel->pixels);
  panel->parts = 0;
}

/* A new command, or the end: was the last one complete? */
static void close_command(virtual_panel *panel) {
  if (panel->command_open && panel->wanted != VIRTUAL_PIXELS && panel->got < panel->wanted) {
    virtual_complain(panel, "command %02X got %u parameters, it takes %u", panel->command, panel->got,
                     panel->wanted);
  }
  virtual_whole_pixels(panel);
  panel->command_open = false;
}

void virtual_finish(virtual_panel *panel) { close_command(panel); }

static void check_wires(virtual_panel *panel, bool data, uint8_t byte) {
  const char *what = data ? "data byte" : "command";
  if (panel->in_reset) virtual_complain(panel, "%s %02X while reset is active", what, byte);
  if (panel->hz == 0) virtual_complain(panel, "%s %02X before the clock was configured", what, byte);
  if (panel->hz > panel->model->hz_max) {
    virtual_complain(panel, "%s %02X at %lu Hz, the data sheet allows %lu", what, byte,
                     (unsigned long)panel->hz, (unsigned long)panel->model->hz_max);
  } else if (panel->hz > 10000000 && !panel->on) {
    virtual_complain(panel, "%s %02X at %lu Hz before the display is on: initialise at 10 MHz at most", what,
                     byte, (unsigned long)panel->hz);
  }
  if (panel->spi_mode != 0 && panel->spi_mode != 3) {
    virtual_complain(panel, "%s %02X in SPI mode %u: bits are taken as the clock rises, mode 0 or 3", what,
                     byte, panel->spi_mode);
  }
}

static void finish_parameters(virtual_panel *panel) {
  if (panel->got == panel->wanted) panel->model->family->execute(panel, panel->command, panel->parameters);
}

static void begin_command(virtual_panel *panel, uint8_t byte) {
  const virtual_command *entry = panel->model->commands;
  close_command(panel);
  panel->commands++;
  if (panel->now_us < panel->ready_at_us) {
    virtual_complain(panel, "command %02X comes %lu us too early after a reset, sleep in or sleep out", byte,
                     (unsigned long)(panel->ready_at_us - panel->now_us));
  }
  for (; entry->first <= entry->last; entry++) {
    if (byte >= entry->first && byte <= entry->last) break;
  }
  panel->command = byte;
  panel->got = 0;
  panel->wanted = entry->count;
  if (entry->first > entry->last) {
    virtual_complain(panel, "unknown command %02X", byte);
    panel->wanted = 0;
    return;
  }
  panel->command_open = true;
  if (panel->wanted == VIRTUAL_PIXELS)
    panel->model->family->execute(panel, byte, panel->parameters);
  else
    finish_parameters(panel);
}

void virtual_feed(virtual_panel *panel, bool data, uint8_t byte) {
  const virtual_family *family = panel->model->family;
  const bool parameter = panel->command_open && panel->wanted != VIRTUAL_PIXELS && panel->got < panel->wanted;
  check_wires(panel, data, byte);
  if (parameter && data != family->parameters_as_commands) {
    panel->parameters[panel->got++] = byte;
    finish_parameters(panel);
  } else if (!data) {
    begin_command(panel, byte);
  } else if (parameter) {
    virtual_complain(panel, "data byte %02X, but command %02X still waits for %u parameters", byte,
                     panel->command, panel->wanted - panel->got);
  } else if (family->pixels_without_command || (panel->command_open && panel->wanted == VIRTUAL_PIXELS)) {
    family->pixel_byte(panel, byte);
  } else if (panel->command_open) {
    virtual_complain(panel, "data byte %02X after command %02X, which takes %u parameters", byte,
                     panel->command, panel->wanted);
  } else {
    virtual_complain(panel, "data byte %02X without a command", byte);
  }
}

void virtual_window(virtual_panel *panel) {
  panel->x = panel->x0;
  panel->y = panel->y0;
  panel->window_full = false;
  virtual_whole_pixels(panel);
}

void virtual_next(virtual_panel *panel) {
  if (panel->x++ != panel->x1) return;
  panel->x = panel->x0;
  if (panel->y++ != panel->y1) return;
  panel->y = panel->y0;
  panel->window_full = true;
}

bool virtual_writable(virtual_panel *panel) {
  if (panel->window_full) {
    virtual_complain(panel, "pixels go on past the end of the window (%u..%u, %u..%u)", panel->x0, panel->x1,
                     panel->y0, panel->y1);
    return false;
  }
  return true;
}

uint32_t virtual_shown(const virtual_panel *panel, uint16_t x, uint16_t y) {
  if (panel->in_reset || !panel->on) return 0;
  return panel->model->family->shown(panel, x, y);
}
