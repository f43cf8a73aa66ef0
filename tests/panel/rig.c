/* A panel under test: its record, bus, virtual glass, and pictures. */
#include "rig.h"

#include <stdio.h>
#include <string.h>

static virtual_panel glass; /* large */
static uint8_t picture[RIG_BYTES_MAX], buffers[2][RIG_BYTES_MAX];

void rig_open(rig *it, const fc_panel *record, bool asynchronous, bool half_turn, bool twelve_bit) {
  memset(it, 0, sizeof *it);
  memset(&it->state, 0xEE, sizeof it->state); /* as the stack leaves it */
  it->record = record;
  it->panel = &glass;
  it->picture = picture;
  it->options.half_turn = half_turn;
  it->options.twelve_bit = twelve_bit;
  virtual_open(&glass, virtual_model_named(record->name));
  virtual_bus_open(&it->bus, &glass, asynchronous);
}

int rig_start(rig *it) {
  const int error = fc_panel_start(&it->state, it->record, &it->bus.bus, &it->options, &it->display);
  if (error == FC_OK) fc_display_capabilities_get(&it->display, &it->can);
  return error;
}

void rig_close(rig *it) { virtual_bus_close(&it->bus); }

/* Bytes of a row of the display, and rows of bytes in it: of pixels, or pages. */
static size_t row_bytes(const rig *it) {
  const size_t width = it->can.width;
  switch (it->can.format) {
    case FC_DISPLAY_RGB565: return width * 2;
    case FC_DISPLAY_RGB444: return width * 3 / 2;
    case FC_DISPLAY_GREY4: return width / 2;
    default: return width;
  }
}

static uint16_t rows_a_step(const rig *it) { return it->can.format == FC_DISPLAY_MONO8 ? 8 : 1; }

void rig_noise(rig *it, uint32_t seed) {
  const size_t count = row_bytes(it) * (it->can.height / rows_a_step(it));
  uint32_t state = seed * UINT32_C(2654435761) + 12345;
  size_t i;
  for (i = 0; i < count; i++) {
    state = state * UINT32_C(1664525) + UINT32_C(1013904223);
    picture[i] = (uint8_t)(state >> 24);
  }
}

int rig_draw(rig *it, uint16_t strip_rows) {
  const size_t bytes = row_bytes(it);
  uint16_t y, rows;
  unsigned turn = 0;
  int error = FC_OK;
  for (y = 0; y < it->can.height && error == FC_OK; y = (uint16_t)(y + rows)) {
    const uint8_t *const from = picture + bytes * (y / rows_a_step(it));
    fc_area area = {0, y, it->can.width, 0};
    rows = (uint16_t)(it->can.height - y < strip_rows ? it->can.height - y : strip_rows);
    area.height = rows;
    if (it->can.asynchronous) {
      /* Only one strip is ever under way, so the buffer of the strip before the last is free. */
      uint8_t *const buffer = buffers[turn++ & 1];
      memcpy(buffer, from, bytes * (rows / rows_a_step(it)));
      error = fc_display_write_start(&it->display, &area, buffer, bytes, NULL, NULL);
    } else {
      error = fc_display_write(&it->display, &area, from, bytes);
    }
  }
  return error != FC_OK ? error : fc_display_wait(&it->display);
}

uint32_t rig_colour(const rig *it, uint16_t x, uint16_t y) {
  const uint8_t *const row = picture + row_bytes(it) * (y / rows_a_step(it));
  uint32_t r, g, b;
  switch (it->can.format) {
    case FC_DISPLAY_RGB565:
      r = row[2 * x] >> 3;
      g = (row[2 * x] & 7u) * 8 + (row[2 * x + 1] >> 5);
      b = row[2 * x + 1] & 31u;
      return (r * 33 / 4) << 16 | (g * 65 / 16) << 8 | b * 33 / 4;
    case FC_DISPLAY_RGB444: {
      uint32_t code[3], i;
      for (i = 0; i < 3; i++) { /* nibble number 3 x + i of the row */
        const uint32_t at = 3u * x + i;
        code[i] = at % 2 == 0 ? row[at / 2] / 16u : row[at / 2] % 16u;
      }
      return code[0] * UINT32_C(0x110000) + code[1] * UINT32_C(0x1100) + code[2] * 0x11;
    }
    case FC_DISPLAY_GREY4: return (x % 2 == 0 ? row[x / 2] / 16u : row[x / 2] % 16u) * UINT32_C(0x111111);
    default: return row[x] >> (y % 8) & 1 ? 0xFFFFFF : 0;
  }
}

const char *rig_verdict(rig *it) {
  static char text[400];
  uint16_t x, y;
  virtual_finish(&glass);
  if (glass.errors != 0) {
    snprintf(text, sizeof text, "%s (%u complaints)", glass.error, glass.errors);
    return text;
  }
  for (y = 0; y < it->can.height; y++) {
    for (x = 0; x < it->can.width; x++) {
      const uint16_t at_x = it->options.half_turn ? (uint16_t)(it->can.width - 1 - x) : x;
      const uint16_t at_y = it->options.half_turn ? (uint16_t)(it->can.height - 1 - y) : y;
      const uint32_t expected = rig_colour(it, x, y), seen = virtual_shown(&glass, at_x, at_y);
      if (expected != seen) {
        snprintf(text, sizeof text, "%s: the glass shows %06lX at (%u, %u), expected %06lX", it->record->name,
                 (unsigned long)seen, at_x, at_y, (unsigned long)expected);
        return text;
      }
    }
  }
  return NULL;
}
