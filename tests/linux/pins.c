/*
 * What an emulated board's pins do, told to a virtual panel: QEMU's trace of a PL061 on standard input, what the panel makes of it on
 * standard output.
 *
 * pins PANEL SCK MOSI CS DC RESET LIGHT DIRECTORY      (the numbers of the lines)
 *   device PATH           first: the PL061 in QEMU's tree of objects
 *   reset                 the reset line was released
 *   frame N               the last pixel of a whole frame has come: DIRECTORY/frame-N holds what the eye sees, as RGB565, high byte first
 *   light L               the backlight line changed
 *   wrong SENTENCE        what no data sheet allows, on the wires (SPI mode 0 or 3, whole bytes, D/C steady within a byte) or in what they say
 *   state on=. awake=. commands=. last=XXXX pixels=.     before each reset and at the end: of the panel, since the reset before
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "../panel/virtual_panel.h"

enum {
  SCK,
  MOSI,
  CS,
  DC,
  RESET,
  LIGHT,
  WIRES
};

static int line_of[WIRES];
static bool level[WIRES];
static const char *directory;
static virtual_panel panel;
static unsigned told_errors, frames, bits, value, last_commands;
static bool dc_at_first_bit, seen_reset, idle; /* idle: level of the clock between bytes, low in SPI mode 0 and high in 3 */
static unsigned long commands_before, pixels_before, frame_began;
static double told_us; /* what the panel knows of the time */

static void wrong(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  fputs("wrong ", stdout);
  vprintf(format, arguments);
  putchar('\n');
  va_end(arguments);
}

static void tell_panel_errors(void) {
  if (panel.errors > told_errors) wrong("%s", panel.error);
  told_errors = panel.errors;
}

static void tell_state(void) {
  printf("state on=%d awake=%d commands=%lu last=%04X pixels=%lu\n", panel.on, panel.awake, panel.commands - commands_before, last_commands & 0xffff,
         panel.pixels - pixels_before);
  commands_before = panel.commands;
  pixels_before = panel.pixels;
}

static void write_frame(void) {
  char path[512];
  FILE *file;
  const virtual_model *model = panel.model;
  snprintf(path, sizeof path, "%s/frame-%u", directory, frames);
  file = fopen(path, "wb");
  if (file == NULL) {
    perror(path);
    exit(2);
  }
  for (uint16_t y = 0; y < model->height; y++) {
    for (uint16_t x = 0; x < model->width; x++) {
      const uint32_t colour = virtual_shown(&panel, x, y);
      const unsigned pixel = (colour >> 8 & 0xf800) | (colour >> 5 & 0x07e0) | (colour >> 3 & 0x001f);
      putc((int)(pixel >> 8), file);
      putc((int)(pixel & 0xff), file);
    }
  }
  if (fclose(file) != 0) exit(2);
  printf("frame %u\n", frames++);
}

static void byte(bool data, uint8_t b) {
  const unsigned long whole = (unsigned long)panel.model->width * panel.model->height;
  if (!data) {
    last_commands = last_commands << 8 | b;
    if (b == 0x2C) frame_began = panel.pixels;
  }
  virtual_feed(&panel, data, b);
  tell_panel_errors();
  if (data && panel.parts == 0 && panel.pixels == frame_began + whole) {
    write_frame();
    frame_began = panel.pixels;
  }
}

static void clock_rises(void) {
  if (level[CS]) return; /* another device's, or the clock on its way to its idle level */
  if (bits == 0) dc_at_first_bit = level[DC];
  if (level[DC] != dc_at_first_bit) wrong("D/C changes within a byte");
  value = value << 1 | level[MOSI];
  if (++bits == 8) {
    bits = 0;
    byte(level[DC], (uint8_t)value);
  }
}

static void set(int wire, bool high) {
  if (level[wire] == high) return;
  level[wire] = high;
  switch (wire) {
    case SCK:
      if (high) clock_rises();
      break;
    case MOSI:
      if (!level[CS] && level[SCK] && bits != 0) wrong("data changes while the clock is high: neither SPI mode 0 nor 3");
      break;
    case CS:
      if (high && level[SCK] != idle) wrong("the chip select rises while the clock is not idle");
      idle = level[SCK];
      if (high && bits != 0) wrong("the chip select rises after %u bits of a byte", bits);
      bits = 0;
      break;
    case RESET:
      if (!high) {
        if (seen_reset) tell_state();
        seen_reset = true;
      }
      virtual_reset(&panel, !high);
      tell_panel_errors();
      if (high) puts("reset");
      break;
    case LIGHT: printf("light %d\n", high); break;
    default: break;
  }
}

/* A line of the trace, without its end: "4711@1700000000.123456:pl061_set_output /machine/... setting output 3 to 1". */
static void trace_line(const char *text) {
  static const char before[] = " setting output ";
  static bool told_device;
  const char *at = strchr(text, '@'), *path = strstr(text, "pl061_set_output "), *output = path != NULL ? strstr(path, before) : NULL;
  int line;
  if (output == NULL) return;
  if (!told_device) {
    path = strchr(path, ' ') + 1;
    printf("device %.*s\n", (int)(output - path), path);
    fflush(stdout);
    told_device = true;
  }
  if (at != NULL && at < output) { /* host time, which no delay of the guest can outrun */
    const double now_us = 1e6 * atof(at + 1);
    if (told_us == 0) told_us = now_us;
    if (now_us - told_us >= 1) {
      virtual_time(&panel, (uint32_t)(now_us - told_us));
      told_us = now_us;
    }
  }
  output += sizeof before - 1;
  line = output[0] - '0'; /* a PL061 has eight */
  for (int wire = 0; wire < WIRES; wire++)
    if (line_of[wire] == line) set(wire, output[sizeof "0 to " - 1] != '0');
}

/* All lines of standard input. Read in large pieces, and seldom: each write of QEMU would wake this program up. */
static void trace(void) {
  static char buffer[1 << 20];
  size_t used = 0;
  for (;;) {
    const struct timespec pause = {0, 2000000};
    const ssize_t count = read(STDIN_FILENO, buffer + used, sizeof buffer - used);
    char *from = buffer, *end;
    if (count <= 0) return;
    used += (size_t)count;
    while ((end = memchr(from, '\n', used - (size_t)(from - buffer))) != NULL) {
      *end = '\0';
      trace_line(from);
      from = end + 1;
    }
    used -= (size_t)(from - buffer);
    memmove(buffer, from, used);
    nanosleep(&pause, NULL);
  }
}

int main(int count, char **words) {
  const virtual_model *model = count == WIRES + 3 ? virtual_model_named(words[1]) : NULL;
  if (model == NULL) {
    fputs("usage: pins PANEL SCK MOSI CS DC RESET LIGHT DIRECTORY\n", stderr);
    return 2;
  }
  for (int wire = 0; wire < WIRES; wire++) line_of[wire] = atoi(words[2 + wire]);
  directory = words[WIRES + 2];
  level[CS] = level[RESET] = true;
  virtual_open(&panel, model);
  virtual_clock(&panel, 10000000, 0); /* bit-banging is far slower */
  trace();
  virtual_finish(&panel);
  tell_panel_errors();
  tell_state();
  return fflush(stdout) != 0 ? 2 : 0;
}
