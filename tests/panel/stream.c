/*
 * Prints, for panels, a hash of all that a start, a frame and a stop send over the bus, delays included: the same on a PC and on chips,
 * whose int may have 16 bits and whose tables may be in program memory.
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

/* FNV-1a. */
static void mix(uint32_t *hash, uint32_t value) {
  uint8_t i;
  for (i = 0; i < 4; i++) *hash = (*hash ^ (uint8_t)(value >> (8 * i))) * UINT32_C(16777619);
}

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
static int command(void *context, const uint8_t *bytes, size_t count) { return send(context, 0, bytes, count); }
static int data(void *context, const uint8_t *bytes, size_t count) { return send(context, 0x100, bytes, count); }
static int reset(void *context, bool active) {
  mix(context, active ? 0x201 : 0x200);
  return FC_OK;
}
static void delay_us(void *context, uint32_t us) { mix(context, UINT32_C(0x80000000) | us); }

static const fc_bus_ops ops = {.configure = configure, .command = command, .data = data, .reset = reset, .delay_us = delay_us};

static int run(const fc_panel *panel, uint8_t half_turn, uint8_t twelve_bit) {
  uint32_t hash = UINT32_C(2166136261);
  const fc_bus bus = {&ops, &hash};
  const fc_panel_options options = {0, half_turn, twelve_bit};
  fc_display display;
  fc_display_capabilities can;
  fc_panel record;
  uint16_t y;
  char c;
  int8_t digit;
  int error = fc_panel_start(&state, panel, &bus, &options, &display);
  if (error != FC_OK) return error;
  fc_display_capabilities_get(&display, &can);
  for (y = 0; error == FC_OK && y < can.height; y = (uint16_t)(y + can.y_align)) {
    const fc_area area = {0, y, can.width, can.y_align};
    uint16_t i;
    for (i = 0; i < ROW_BYTES; i++) row[i] = (uint8_t)(y * 31u + i * 7u);
    error = fc_display_write(&display, &area, row, fc_display_row_bytes(can.format, can.width));
  }
  if (error == FC_OK) error = fc_panel_stop(&state);
  FC_READ(&record, panel, sizeof record);
  do {
    FC_READ(&c, record.name++, 1);
    PUT(c != '\0' ? c : ' ');
  } while (c != '\0');
  for (digit = 28; digit >= 0; digit = (int8_t)(digit - 4)) PUT("0123456789abcdef"[hash >> digit & 15]);
  PUT('\n');
  return error;
}

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
#endif
#ifdef FIXCAST_BAREMETAL
  semihost_exit(error == FC_OK ? 0 : 1);
#endif
  return error == FC_OK ? 0 : 1;
}
