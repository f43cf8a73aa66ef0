/*
 * Rows of 16-bit pixels in the formats of displays that have less, by ordered dither.
 *
 * All exact, so that it can be redone from this text. A value v of 0..m becomes the level, of 0..n, that bayer.h defines from its place.
 * RGB444: red, green and blue, m = 31, 63, 31, each to n = 15 with the pixel's one B.
 * GREY4, MONO8: v = 41 red + 39 green + 16 blue of the 5, 6 and 5 bits, m = 4224, to n = 15 or 1. The weights of full red, green and blue
 * are 0.3009, 0.5817, 0.1174: ITU-R BT.601's 0.299, 0.587, 0.114 within 0.006, such that m / 128 is whole and all fits 16 bits.
 */
#include <stdbool.h>

#include "bayer.h"
#include "fixcast/display.h"
#include "fixcast/error.h"

enum {
  LUMA_MAX = 41 * 31 + 39 * 63 + 16 * 31 /* 4224 = 128 * 33 */
};

static uint16_t luma(uint16_t pixel) {
  return (uint16_t)(41u * (pixel >> 11) + 39u * ((pixel >> 5) & 63u) + 16u * (pixel & 31u));
}

/*
 * floor(n v / m) without a division, which small chips do in software: v times k / 2^s, a little more than n / m. It is exact as long as the excess,
 * v (k / 2^s - n / m), stays below the least distance of an n v / m to the integer above: 1 / m, cancelled down.
 *   15 v / 31: k = 124, s = 8, excess at most 0.0157 < 1 / 31.   15 v / 63: k = 61, s = 8, 0.0118 < 1 / 21.
 *   w / 11 for w up to 175: k = 187, s = 11, 0.071 < 1 / 11.
 */

/* floor(15 v / 4224 + (2 B + 1) / 128) is floor((5 v + 22 B + 11) / 1408), and 1408 is 128 * 11. The numerator is below 2^15; `add` is 22 B + 11. */
static uint8_t grey4(uint16_t pixel, uint16_t add) {
  const uint16_t sum = (uint16_t)(205u * (pixel >> 11) + 195u * ((pixel >> 5) & 63u) + 80u * (pixel & 31u) + add);
  return (uint8_t)((uint16_t)((sum >> 7) * 187u) >> 11);
}

static bool white(uint16_t pixel, uint8_t b) { return luma(pixel) >= LUMA_MAX / 128u * fc_bayer_missing(b); }

/* The level that floor(15 v / m) is, or the next; the remainder is below m, times 128 at most 7936. */
static uint8_t raised(uint8_t level, uint8_t value, uint8_t max, uint8_t b) {
  const uint16_t rest = (uint16_t)(15u * value - (uint16_t)level * max);
  return (uint8_t)(level + (rest * 128u >= (uint16_t)fc_bayer_missing(b) * max));
}
static uint8_t from5(uint8_t value, uint8_t b) { return raised((uint8_t)(value * 124u >> 8), value, 31, b); }
static uint8_t from6(uint8_t value, uint8_t b) { return raised((uint8_t)(value * 61u >> 8), value, 63, b); }

static uint16_t rgb444(uint16_t pixel, uint8_t b) {
  const uint8_t red = from5((uint8_t)(pixel >> 11), b), green = from6((pixel >> 5) & 63u, b),
                blue = from5(pixel & 31u, b);
  return (uint16_t)(((uint16_t)red << 8) | ((uint16_t)green << 4) | blue);
}

/* One row. `b`: the matrix's row, turned so that b[i & 7] belongs to pixel i. Each reads a pixel before it writes where that was. */

static void copy_row(const uint8_t *from, uint8_t *to, uint16_t width) {
  size_t i;
  if (from == to) return;
  for (i = 0; i < (size_t)width * 2u; i++) to[i] = from[i];
}

static uint16_t pixel_at(const uint8_t *from, uint16_t i) {
  return (uint16_t)(((uint16_t)from[2u * (size_t)i] << 8) | from[2u * (size_t)i + 1u]);
}

static void grey4_row(const uint8_t *from, uint8_t *to, uint16_t width, const uint8_t *b) {
  uint16_t add[8], i;
  for (i = 0; i < 8; i++) add[i] = (uint16_t)(22u * b[i] + 11u);
  for (i = 0; i + 1u < width; i = (uint16_t)(i + 2u)) {
    const uint8_t left = grey4(pixel_at(from, i), add[i & 6u]);
    const uint8_t right = grey4(pixel_at(from, (uint16_t)(i + 1u)), add[(i & 6u) + 1u]);
    *to++ = (uint8_t)((left << 4) | right);
  }
  if (i < width) *to = (uint8_t)(grey4(pixel_at(from, i), add[i & 6u]) << 4);
}

static void rgb444_row(const uint8_t *from, uint8_t *to, uint16_t width, const uint8_t *b) {
  uint16_t i;
  for (i = 0; i < width; i++) {
    const uint16_t pixel = rgb444(pixel_at(from, i), b[i & 7u]);
    if (i & 1u) {
      to[0] = (uint8_t)(to[0] | (pixel >> 8));
      to[1] = (uint8_t)pixel;
      to += 2;
    } else {
      to[0] = (uint8_t)(pixel >> 4);
      to[1] = (uint8_t)(pixel << 4);
      to++;
    }
  }
}

/* Bit `bit` of each byte; the others stay. */
static void mono_row(const uint8_t *from, uint8_t *to, uint16_t width, const uint8_t *b, uint8_t bit) {
  const uint8_t mask = (uint8_t)(1u << bit);
  uint16_t i;
  for (i = 0; i < width; i++) {
    to[i] = (uint8_t)(white(pixel_at(from, i), b[i & 7u]) ? to[i] | mask : to[i] & ~mask);
  }
}

static void clear(uint8_t *to, uint16_t count) {
  while (count > 0) to[--count] = 0;
}

int fc_display_convert(uint8_t format, uint16_t x, uint16_t y, uint16_t width, uint16_t rows,
                       const void *from, size_t from_pitch_bytes, void *to, size_t to_pitch_bytes) {
  const uint8_t *source = from;
  uint8_t *target = to;
  uint16_t row;
  if (from == NULL || to == NULL) return FC_ERR_NULL;
  if (format > FC_DISPLAY_MONO8) return FC_ERR_FORMAT;
  if (width == 0 || rows == 0) return FC_ERR_AREA;
  if (from_pitch_bytes < fc_display_row_bytes(FC_DISPLAY_RGB565, width)) return FC_ERR_AREA;
  if (to_pitch_bytes < fc_display_row_bytes(format, width)) return FC_ERR_AREA;
  if (format == FC_DISPLAY_MONO8 && rows != 1 && y % 8u != 0) return FC_ERR_AREA;
  for (row = 0; row < rows; row++) {
    const uint8_t line = (uint8_t)((y + row) & 7u);
    uint8_t b[8];
    fc_bayer_row(b, x, line);
    switch (format) {
      case FC_DISPLAY_RGB565: copy_row(source, target, width); break;
      case FC_DISPLAY_RGB444: rgb444_row(source, target, width, b); break;
      case FC_DISPLAY_GREY4: grey4_row(source, target, width, b); break;
      default:
        if (rows != 1 && line == 0)
          clear(target, width); /* a last page of fewer than 8 rows is black below them */
        mono_row(source, target, width, b, line);
        break;
    }
    source += from_pitch_bytes;
    if (format != FC_DISPLAY_MONO8 || line == 7) target += to_pitch_bytes;
  }
  return FC_OK;
}
