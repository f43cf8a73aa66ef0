/*
 * What stands between the texels of an image: nearest or bilinear, tiled or clamped.
 *
 * Included by each pattern that is an image, which says how it reads a texel; its record begins with an fc_image.
 */
#ifndef FC_TEXTURE_TEXELS_H
#define FC_TEXTURE_TEXELS_H

#include "bits.h"
#include "fixcast/error.h"
#include "texture.h"

/* The includer's: red, green and blue of the texel that is `at` of the rows. */
static void read_texel(const void *data, const fc_image *image, uint32_t at, uint8_t bytes[3]);

static FC_COLD bool is_image(const fc_image *image) {
  return image->texels != NULL && image->width >= 1 && image->height >= 1 && image->width <= 4096 && image->height <= 4096 &&
         image->bilinear <= 1 && image->clamp <= 1;
}

/* v into 0 .. size - 1, by the image's rule. */
static FC_COLD uint16_t wrap(int64_t v, uint16_t size, uint8_t clamp) {
  int64_t rest;
  if (clamp) return v < 0 ? 0 : v >= size ? (uint16_t)(size - 1)
                                          : (uint16_t)v;
  rest = v % size;
  return (uint16_t)(rest < 0 ? rest + size : rest);
}

/* A texel's channels in Q8 of a level: 255 stands for 65280. */
static FC_COLD void fetch(const void *data, const fc_image *image, int64_t x, int64_t y, uint16_t channel[3]) {
  const uint32_t at = (uint32_t)wrap(y, image->height, image->clamp) * image->width + wrap(x, image->width, image->clamp); /* 24 bits */
  uint8_t bytes[3];
  read_texel(data, image, at, bytes);
  channel[0] = (uint16_t)(bytes[0] << 8);
  channel[1] = (uint16_t)(bytes[1] << 8);
  channel[2] = (uint16_t)(bytes[2] << 8);
}

/* Q8 of a level as Q15: v 2^15 / (255 2^8), rounded. */
static uint16_t to_q15(uint32_t v) { return (uint16_t)((v * 128 + 127) / 255); /* 16 + 7 bits */ }

static FC_COLD void colour(const void *data, const int64_t uv_q24[2], uint16_t to[3]) {
  fc_image image; /* first in the record */
  uint16_t channel[4][3];
  int64_t at_q24[2];
  uint16_t part[2];
  uint8_t i;
  FC_READ(&image, data, sizeof image);
  /* 58 bits by 12 would overflow: whole tiles go first, 24 + 12 bits are left; a clamped image needs the tiles next to it alone */
  for (i = 0; i < 2; i++) {
    int64_t tile = fc_floor_shift64(uv_q24[i], 24), rest = uv_q24[i] - tile * (INT64_C(1) << 24);
    const uint16_t size = i == 0 ? image.width : image.height;
    if (image.clamp && tile != 0) rest = tile < 0 ? -(INT64_C(1) << 24) : INT64_C(2) << 24;
    at_q24[i] = rest * size;
  }
  if (!image.bilinear) {
    fetch(data, &image, fc_floor_shift64(at_q24[0], 24), fc_floor_shift64(at_q24[1], 24), channel[0]);
    for (i = 0; i < 3; i++) to[i] = to_q15(channel[0][i]);
    return;
  }
  {
    /* texel centres are at halves */
    const int64_t x_q24 = at_q24[0] - (INT64_C(1) << 23), y_q24 = at_q24[1] - (INT64_C(1) << 23);
    const int64_t x = fc_floor_shift64(x_q24, 24), y = fc_floor_shift64(y_q24, 24);
    for (i = 0; i < 4; i++) fetch(data, &image, x + (i & 1), y + (i >> 1), channel[i]);
    part[0] = (uint16_t)(((uint64_t)x_q24 & 0xffffff) >> 9); /* Q15 */
    part[1] = (uint16_t)(((uint64_t)y_q24 & 0xffffff) >> 9);
  }
  for (i = 0; i < 3; i++) {
    /* 16 + 15 bits */
    const uint32_t top = ((uint32_t)channel[0][i] * (32768u - part[0]) + (uint32_t)channel[1][i] * part[0]) >> 15;
    const uint32_t bottom = ((uint32_t)channel[2][i] * (32768u - part[0]) + (uint32_t)channel[3][i] * part[0]) >> 15;
    to[i] = to_q15((top * (32768u - part[1]) + bottom * part[1]) >> 15);
  }
}

#endif
