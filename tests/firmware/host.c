/*
 * The firmware of all boards on a board of software: a virtual panel on a virtual bus (tests/panel), a clock that moves when it is looked at.
 *
 * firmware_host PANEL FRAMES ROWS sync|async|async12|queue GLASS [WIDTH HEIGHT [BUTTONS]]
 *
 * Prints the firmware's text. GLASS gets what the eye sees after each `pattern` and `frame` line: all the panel's pixels, three bytes each,
 * red first.
 * BUTTONS: what each look at the buttons finds, FC_BUTTON_ bits as hexadecimal digits, two a look; then none is held.
 * Exit code: 0; 1 after an error of the firmware, 2 for bad arguments, 3 when the panel complains of what came over the wires.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "firmware.h"
#include "virtual_bus.h"

enum {
  CLOCK_STEP_US = 100, /* a look at the clock lasts that long */
  MEMORY_BYTES = 1 << 20
};

typedef struct host {
  virtual_panel *panel;
  FILE *glass;
  char line[256];
  size_t used;
  uint32_t now_us;
  const char *buttons;
} host;

static void dump(const host *self) {
  const virtual_model *model = self->panel->model;
  uint16_t x, y;
  for (y = 0; y < model->height; y++) {
    for (x = 0; x < model->width; x++) {
      const uint32_t colour = virtual_shown(self->panel, x, y);
      (void)fputc((int)(colour >> 16 & 0xffu), self->glass);
      (void)fputc((int)(colour >> 8 & 0xffu), self->glass);
      (void)fputc((int)(colour & 0xffu), self->glass);
    }
  }
}

static void put(void *context, char c) {
  host *self = context;
  (void)putchar(c);
  if (c != '\n') {
    if (self->used < sizeof self->line - 1) self->line[self->used++] = c;
    return;
  }
  self->line[self->used] = '\0';
  self->used = 0;
  if (strncmp(self->line, "pattern ", 8) == 0 || strncmp(self->line, "frame ", 6) == 0) dump(self);
}

static uint32_t microseconds(void *context) {
  host *self = context;
  self->now_us += CLOCK_STEP_US;
  return self->now_us;
}

static uint8_t buttons(void *context) {
  host *self = context;
  char digits[3] = {0};
  if (strlen(self->buttons) < 2) return 0;
  memcpy(digits, self->buttons, 2);
  self->buttons += 2;
  return (uint8_t)strtoul(digits, NULL, 16);
}

/* A whole number of an argument, or exit. */
static uint16_t number(const char *text, const char *what) {
  char *end;
  const unsigned long value = strtoul(text, &end, 10);
  if (*text == '\0' || *end != '\0' || value > 4096) {
    fprintf(stderr, "firmware_host: %s is '%s': say a whole number up to 4096\n", what, text);
    exit(2);
  }
  return (uint16_t)value;
}

static const fc_panel *find_panel(const char *name) {
  const fc_panel *const *panel;
  for (panel = fc_panels; *panel != NULL; panel++) {
    if (strcmp((*panel)->name, name) == 0) return *panel;
  }
  fprintf(stderr, "firmware_host: there is no panel '%s'\n", name);
  exit(2);
}

int main(int count, char **arguments) {
  static virtual_panel panel;
  static int64_t memory[MEMORY_BYTES / 8];
  static virtual_bus bus;
  host self = {.panel = &panel, .buttons = ""};
  fc_firmware_board board = {.name = "host",
                             .context = &self,
                             .put = put,
                             .microseconds = microseconds,
                             .buttons = buttons,
                             .cpu_hz = 50000000,
                             .pattern_ms = 5,
                             .memory = memory,
                             .memory_bytes = sizeof memory};
  int error;
  if (count != 6 && count != 8 && count != 9) {
    fprintf(stderr, "usage: firmware_host PANEL FRAMES ROWS sync|async|async12|queue GLASS [WIDTH HEIGHT [BUTTONS]]\n");
    return 2;
  }
  board.panel = find_panel(arguments[1]);
  board.frames = number(arguments[2], "FRAMES");
  board.strip_rows = number(arguments[3], "ROWS");
  board.options.twelve_bit = strcmp(arguments[4], "async12") == 0;
  if (count >= 8) {
    board.width = number(arguments[6], "WIDTH");
    board.height = number(arguments[7], "HEIGHT");
  }
  if (count == 9) self.buttons = arguments[8];
  if (strcmp(arguments[4], "queue") == 0) {
    board.buffers = 3;
    board.alternate = 1;
  }
  /* No more than a board would give. */
  if (board.width != 0 && board.strip_rows != 0) {
    board.memory_bytes = FC_FIRMWARE_MEMORY(board.width, board.strip_rows);
    if (board.buffers == 3) board.memory_bytes += FC_FIRMWARE_MEMORY_BUFFER(board.width, board.strip_rows);
  }
  self.glass = fopen(arguments[5], "wb");
  if (self.glass == NULL) {
    fprintf(stderr, "firmware_host: cannot write %s\n", arguments[5]);
    return 2;
  }
  virtual_open(&panel, virtual_model_named(arguments[1]));
  virtual_bus_open(&bus, &panel, strcmp(arguments[4], "sync") != 0);
  board.bus = bus.bus;
  error = fc_firmware_run(&board);
  virtual_finish(&panel);
  virtual_bus_close(&bus);
  if (fclose(self.glass) != 0) {
    fprintf(stderr, "firmware_host: cannot write %s\n", arguments[5]);
    return 2;
  }
  if (panel.errors != 0) {
    fprintf(stderr, "firmware_host: the panel complains: %s\n", panel.error);
    return 3;
  }
  return error < 0 ? 1 : 0;
}
