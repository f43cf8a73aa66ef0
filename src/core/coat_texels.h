/*
 * Colours runs by the four texels around each pixel: the inner loops of bilinear images.
 *
 * Included by each pattern that has fast forms, which says how it reads a texel.
 */
#ifndef FC_COAT_TEXELS_H
#define FC_COAT_TEXELS_H

#include "coat.h"

/* Red in the upper half, blue in the lower; and green. */
typedef struct texel {
  uint32_t rb, g;
} texel;

/* The includer's: the texel that is `at` of the rows. */
FC_INLINE texel texel_at(const fc_coat_texture *texture, uint32_t at);

/* What stands around a point, among the rows' texels. */
typedef struct texel_square {
  uint32_t a, b, c, d; /* b to the right of a, c below it */
} texel_square;

/* The includer's: whether the four are seen to be the same without a look at their colours. */
FC_INLINE bool is_flat(const fc_coat_texture *texture, const texel_square *at);

/* Column i and row j as they are, for clamped images and any size. *tile, multiples of the size, follow i and j. */
static FC_NOINLINE void around(const fc_coat_texture *texture, int32_t i, int32_t j, int32_t tile[2], texel_square *to) {
  int32_t at[2], next[2];
  uint8_t k;
  at[0] = i;
  at[1] = j;
  for (k = 0; k < 2; k++) {
    const int32_t size = texture->axis[k].size;
    int32_t v = at[k];
    if (texture->clamp) {
      next[k] = v < -1 ? 0 : v >= size - 1 ? size - 1 : v + 1;
      at[k] = v < 0 ? 0 : v >= size ? size - 1 : v;
      continue;
    }
    v -= tile[k];
    while (v < 0) {
      v += size;
      tile[k] -= size;
    }
    while (v >= size) {
      v -= size;
      tile[k] += size;
    }
    at[k] = v;
    next[k] = v + 1 == size ? 0 : v + 1;
  }
  /* 12 + 12 bits */
  at[1] *= texture->axis[0].size;
  next[1] *= texture->axis[0].size;
  to->a = (uint32_t)(at[1] + at[0]);
  to->b = (uint32_t)(at[1] + next[0]);
  to->c = (uint32_t)(next[1] + at[0]);
  to->d = (uint32_t)(next[1] + next[0]);
}

/* Around a point in Q16, for sizes that are powers of two. */
FC_INLINE void square_of(const fc_coat_texture *texture, uint32_t x, uint32_t y, texel_square *to) {
  const uint32_t right = texture->mask[0], bottom = texture->mask[1], width = texture->width;
  const uint32_t i = x >> 16 & right, j = y >> 16 & bottom;
  const uint32_t i1 = (i + 1) & right, top = j * width, below = ((j + 1) & bottom) * width;
  to->a = top + i;
  to->b = top + i1;
  to->c = below + i;
  to->d = below + i1;
}

/*
 * RGB565 without a clamp and tiles by masks, in words of two channels; without a call, which would cost registers. Coordinates are rounded
 * to 2^-8, and so are the weights, which add up to 256 and are not negative: (256 - wx) (256 - wy) / 256 and the like, all off by the same
 * half at most. So 255 x 256 at most in 16 bits: no carry.
 */
static FC_HOT void put_plain(const fc_coat_texture *texture, const fc_coat_span *span) {
  const int32_t *xy = span->xy;
  const uint32_t *cosine = span->cosine;
  const uint32_t across = ((uint32_t)span->base[0] << 16) + 128, down = ((uint32_t)span->base[1] << 16) + 128;
  uint32_t bits = span->bits;
  uint8_t *to = span->to;
  for (; bits != 0; bits >>= 1, xy += 2, cosine++, to += 2) {
    texel_square at;
    texel t;
    uint32_t u, v, w, rb, g, c, packed;
    if (!(bits & 1)) continue;
    u = (uint32_t)xy[0] + across;
    v = (uint32_t)xy[1] + down;
    square_of(texture, u, v, &at);
    if (is_flat(texture, &at)) {
      t = texel_at(texture, at.a);
      rb = t.rb << 8;
      g = t.g << 8;
    } else {
      u = u >> 8 & 0xffu;
      v = v >> 8 & 0xffu;
      w = (u * v + 128) >> 8;
      t = texel_at(texture, at.d);
      rb = t.rb * w;
      g = t.g * w;
      w = u - w;
      t = texel_at(texture, at.b);
      rb += t.rb * w;
      g += t.g * w;
      w = 256 - u - (v - (u - w)); /* v - (u - w) is c's */
      t = texel_at(texture, at.a);
      rb += t.rb * w;
      g += t.g * w;
      w = 256 - u - w;
      t = texel_at(texture, at.c);
      rb += t.rb * w;
      g += t.g * w;
    }
    /* light in 2^-7 of a level, times 16 bits: 31 levels and a half, or 63 and a half, at most (coat_texture.c) */
    c = *cosine;
    packed = (((texture->base[0] + texture->slope[0] * c) >> 16) * (rb >> 16) + (UINT32_C(1) << 22)) >> 23 << 11;
    packed |= (((texture->base[1] + texture->slope[1] * c) >> 16) * g + (UINT32_C(1) << 22)) >> 23 << 5;
    packed |= (((texture->base[2] + texture->slope[2] * c) >> 16) * (rb & 0xffffu) + (UINT32_C(1) << 22)) >> 23;
    to[0] = (uint8_t)(packed >> 8);
    to[1] = (uint8_t)packed;
  }
}

/* A channel of light, levels times 256 / 255, and a texel's: 17 bits, below 1.004 2^16, and 15; 2^-8 and 2^-7 of a level are cut. */
FC_INLINE uint32_t shaded(const fc_coat_texture *texture, uint8_t channel, uint32_t cosine, uint32_t value) {
  return ((texture->base[channel] + texture->slope[channel] * cosine) >> 15) * (value >> 9);
}

/* Any format and light: weights in Q16 that add up to 1. */
static FC_NOINLINE void put_fine(const fc_coat_texture *texture, const fc_coat_span *span) {
  const fc_tint *tint = &span->scan->tint;
  const int32_t *xy = span->xy;
  const uint32_t *cosine = span->cosine;
  const uint32_t across = (uint32_t)span->base[0] << 16, down = (uint32_t)span->base[1] << 16;
  int32_t tile[2] = {0, 0};
  uint32_t bits = span->bits;
  uint8_t *to = span->to;
  for (; bits != 0; bits >>= 1, xy += 2, cosine++, to += span->scan->pixel_bytes) {
    texel_square at;
    texel a, b, c, d;
    uint32_t u, v, wa, wb, wc, wd, level[3];
    if (!(bits & 1)) continue;
    u = (uint32_t)xy[0] + across;
    v = (uint32_t)xy[1] + down;
    if (texture->masked)
      square_of(texture, u, v, &at);
    else
      around(texture, fc_floor_shift32(fc_to_i32(u), 16), fc_floor_shift32(fc_to_i32(v), 16), tile, &at);
    wb = u & 0xffffu;
    wc = v & 0xffffu;
    wd = wb * wc >> 16;
    wb -= wd;
    wc -= wd;
    wa = 65536 - wb - wc - wd;
    a = texel_at(texture, at.a);
    b = texel_at(texture, at.b);
    c = texel_at(texture, at.c);
    d = texel_at(texture, at.d);
    /* 24 bits */
    level[0] = shaded(texture, 0, *cosine, (a.rb >> 16) * wa + (b.rb >> 16) * wb + (c.rb >> 16) * wc + (d.rb >> 16) * wd);
    level[1] = shaded(texture, 1, *cosine, a.g * wa + b.g * wb + c.g * wc + d.g * wd);
    level[2] = shaded(texture, 2, *cosine, (a.rb & 0xffu) * wa + (b.rb & 0xffu) * wb + (c.rb & 0xffu) * wc + (d.rb & 0xffu) * wd);
    fc_coat_put_levels(tint, level, to);
  }
}

static void put(const fc_coat_texture *texture, const fc_coat_span *span) {
  if (texture->plain)
    put_plain(texture, span);
  else
    put_fine(texture, span);
}

#endif
