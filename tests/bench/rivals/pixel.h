/* How a rival writes a pixel: RGB565 with the high byte first or, for the comparison with the oracle, what that takes. */
#ifndef FIXCAST_BENCH_RIVAL_PIXEL_H
#define FIXCAST_BENCH_RIVAL_PIXEL_H

#include "renderer.h"

/* The largest value of each channel. */
#ifdef DUMP
enum {
  RED_MAX = 255,
  GREEN_MAX = 255,
  BLUE_MAX = 255
};
#else
enum {
  RED_MAX = 31,
  GREEN_MAX = 63,
  BLUE_MAX = 31
};
#endif

static inline uint32_t pack(int red, int green, int blue) {
#ifdef DUMP
  return (uint32_t)(red << 16 | green << 8 | blue);
#else
  return (uint32_t)(red << 11 | green << 5 | blue);
#endif
}

/* `i` counts the strip's pixels. */
static inline void put_pixel(const strip *to, size_t i, uint32_t colour, uint16_t object, int lit) {
#ifdef DUMP
  to->pixels[3 * i] = (uint8_t)(colour >> 16);
  to->pixels[3 * i + 1] = (uint8_t)(colour >> 8);
  to->pixels[3 * i + 2] = (uint8_t)colour;
  to->object[i] = object;
  to->lit[i] = (uint32_t)lit;
#else
  to->pixels[2 * i] = (uint8_t)(colour >> 8);
  to->pixels[2 * i + 1] = (uint8_t)colour;
  (void)object;
  (void)lit;
#endif
}

#endif
