#include "pattern.h"

#include <stdbool.h>

/* A head from a quarter of the height to half of it, as wide as the shorter side at most, and a shaft a quarter as wide below. */
static bool in_arrow(uint16_t width, uint16_t height, uint16_t x, uint16_t y) {
  const uint16_t size = width < height ? width : height, top = (uint16_t)(height / 2 - size / 4);
  const uint16_t right = (uint16_t)(2u * x + 1u), off = (uint16_t)(right > width ? right - width : width - right); /* in half pixels */
  if (y < top || y >= top + size / 2) return false;
  return y < top + size / 4 ? off <= 2u * (y - top) + 1u : off <= size / 8;
}

static uint16_t colour(uint16_t width, uint16_t height, uint16_t x, uint16_t y) {
  if (x == 0 || y == 0 || x == width - 1 || y == height - 1 || in_arrow(width, height, x, y)) return 0xffff;
  if (x < width / 3) return 0xf800;
  return x < width - width / 3 ? 0x07e0 : 0x001f;
}

void fc_pattern_rows(uint16_t width, uint16_t height, uint16_t y, uint16_t rows, uint8_t *pixels) {
  const uint32_t end = (uint32_t)y + rows;
  uint32_t row;
  uint16_t x;
  for (row = y; row < end; row++) {
    for (x = 0; x < width; x++) {
      const uint16_t value = colour(width, height, x, (uint16_t)row);
      *pixels++ = (uint8_t)(value >> 8);
      *pixels++ = (uint8_t)(value & 0xffu);
    }
  }
}
