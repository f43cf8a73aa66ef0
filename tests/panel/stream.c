/*
 * Prints, for panels, a hash of all that a start, a frame and a stop send over the bus, delays included, and of what dither makes of 4096 pixels:
 * the same on a PC and on chips, whose int may have 16 bits and whose tables may be in program memory.
 *
 * -DONLY=fc_panel_ssd1306: that panel alone, named directly, so that the others are not linked.
 */
#include "fixcast/panel.h"

#include "fixcast/error.h"

#ifdef FIXCAST_BAREMETAL
#include "semihost.h"
#define PUT(c) semihost_char(c)
#else
#include <stdio.h>
#define PUT(c) ((void)putchar(c))
#endif

enum {
  ROW_BYTES = 512
};
static uint8_t row[ROW_BYTES];
static fc_panel_state state; /* its size is read off the program's symbols */

/* FNV-1a, a word at a time: an emulated AVR does this for each byte. */
static void mix(uint32_t *hash, uint32_t value) { *hash = (*hash ^ value) * UINT32_C(16777619); }

static int configure(void *context, uint32_t hz, uint8_t spi_mode) {
  mix(context, hz);
  mix(context, spi_mode);
  return FC_OK;
}
static int send(void *context, uint32_t what, const uint8_t *bytes, size_t count) {
  size_t i;
  for (i = 0; i < count; i++) mix(context, what | bytes[i]);
  return FC_OK;
}
static int command(void *context, const uint8_t *bytes, size_t count) {
  return send(context, 0, bytes, count);
}
static int data(void *context, const uint8_t *bytes, size_t count) {
  return send(context, 0x100, bytes, count);
}
static int reset(void *context, bool active) {
  mix(context, active ? 0x201 : 0x200);
  return FC_OK;
}
static void delay_us(void *context, uint32_t us) { mix(context, UINT32_C(0x80000000) | us); }

static const fc_bus_ops ops = {
    .configure = configure, .command = command, .data = data, .reset = reset, .delay_us = delay_us};

static void put_line(const char *rom_name, uint32_t hash) {
  int8_t digit;
  char c;
  do {
    FC_READ(&c, rom_name++, 1);
    PUT(c != '\0' ? c : ' ');
  } while (c != '\0');
  for (digit = 28; digit >= 0; digit = (int8_t)(digit - 4)) PUT("0123456789abcdef"[hash >> digit & 15]);
  PUT('\n');
}

static int run(const fc_panel *panel, uint8_t half_turn, uint8_t twelve_bit) {
  uint32_t hash = UINT32_C(2166136261);
  const fc_bus bus = {&ops, &hash};
  const fc_panel_options options = {0, half_turn, twelve_bit};
  fc_display display;
  fc_display_capabilities can;
  fc_panel record;
  fc_area off = {0, 0, 8, 0};
  uint16_t y;
  int error = fc_panel_start(&state, panel, &bus, &options, &display);
  if (error != FC_OK) return error;
  fc_display_capabilities_get(&display, &can);
  off.x = can.width, off.height = can.y_align;
  if (fc_display_write(&display, &off, row, ROW_BYTES) != FC_ERR_AREA)
    return FC_ERR_AREA; /* with an int of 16 bits too */
  for (y = 0; error == FC_OK && y < can.height; y = (uint16_t)(y + can.y_align)) {
    const fc_area area = {0, y, can.width, can.y_align};
    uint16_t i;
    for (i = 0; i < ROW_BYTES; i++) row[i] = (uint8_t)(y * 31u + i * 7u);
    error = fc_display_write(&display, &area, row, fc_display_row_bytes(can.format, can.width));
  }
  if (error == FC_OK) error = fc_panel_stop(&state);
  FC_READ(&record, panel, sizeof record);
  put_line(record.name, hash);
  return error;
}

#ifndef ONLY
/* Every sixteenth pixel value. */
static int run_dither(uint8_t format) {
  static const char name[] FC_ROM = "dither";
  uint32_t hash = UINT32_C(2166136261);
  uint8_t y, x;
  int error = FC_OK;
  for (y = 0; error == FC_OK && y < 64; y++) {
    uint8_t to[128];
    for (x = 0; x < 64; x++) {
      const uint16_t pixel = (uint16_t)((y * 64u + x) * 16u + y % 16u);
      row[2 * x] = (uint8_t)(pixel >> 8), row[2 * x + 1] = (uint8_t)pixel;
    }
    for (x = 0; x < sizeof to; x++) to[x] = 0;
    error = fc_display_convert(format, 3, y, 64, 1, row, 128, to, sizeof to);
    for (x = 0; x < sizeof to; x++) mix(&hash, to[x]);
  }
  put_line(name, hash);
  return error;
}

/* All values of a channel at all rows of the matrix. */
static int run_dither565(void) {
  static const char name[] FC_ROM = "dither565";
  uint32_t hash = UINT32_C(2166136261);
  uint8_t y, x;
  int error = FC_OK;
  for (y = 0; error == FC_OK && y < 32; y++) {
    uint8_t to[128];
    for (x = 0; x < 192; x++) row[x] = (uint8_t)(y * 8u + x * 67u);
    error = fc_display_dither565(3, y, 64, 1, row, 192, to, sizeof to);
    for (x = 0; x < sizeof to; x++) mix(&hash, to[x]);
  }
  put_line(name, hash);
  return error;
}
#endif

int main(void) {
  int error = FC_OK;
#ifdef ONLY
  extern const fc_panel ONLY;
  error = run(&ONLY, 0, 0);
#else
  uint8_t i, way;
  for (i = 0;; i++) {
    const fc_panel *panel;
    fc_panel record;
    FC_READ(&panel, &fc_panels[i], sizeof panel);
    if (panel == NULL) break;
    FC_READ(&record, panel, sizeof record);
    for (way = 0; error == FC_OK && way < 2; way++) error = run(panel, way, 0);
    if (error == FC_OK && record.format12 != NULL) error = run(panel, 0, 1);
  }
  for (i = FC_DISPLAY_RGB565; error == FC_OK && i <= FC_DISPLAY_MONO8; i++) error = run_dither(i);
  if (error == FC_OK) error = run_dither565();
#endif
#ifdef FIXCAST_BAREMETAL
  semihost_exit(error == FC_OK ? 0 : 1);
#endif
  return error == FC_OK ? 0 : 1;
}
