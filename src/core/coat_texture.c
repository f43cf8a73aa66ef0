/* Bilinear images on planes and triangles by fast forms: texel coordinates are quotients of affine forms. */
#include "coat.h"

#include "fixcast/error.h"
#include "texture.h"

/* The levels that white is worth: unlit, and a cosine in Q16; times 256 / 255, as texels count to 255. False when they are too bright. */
static FC_COLD bool light_of(const fc_scan *scan, bool modulate, fc_coat_texture *texture) {
  uint16_t ambient[3];
  uint8_t i;
  fc_channels(&scan->frame->scene.ambient, ambient);
  for (i = 0; i < 3; i++) {
    const uint8_t top = scan->tint.transfer != NULL ? 255 : scan->tint.most[i];
    uint32_t slope = scan->tint.slope[i], base = scan->tint.base[i] - (scan->tint.transfer != NULL ? 0 : UINT32_C(1) << (FC_TINT_BITS - 1));
    if (!modulate) {
      slope = fc_scan_slope(scan, FC_ONE_Q15, i);
      if (slope >= UINT32_C(0x8000) || ambient[i] > FC_ONE_Q15) return false;
      base = ((uint32_t)ambient[i] << 8) * top; /* 15 + 8 + 8 bits */
    }
    base += base >> 8;   /* 256 / 255 within 2^-16 */
    slope += (slope + 128) >> 8;
    if (slope >= UINT32_C(0x8000) || base + (slope << 16) < base) return false;
    if (texture != NULL) {
      texture->base[i] = base;
      texture->slope[i] = slope;
    }
  }
  return true;
}

static FC_COLD void open_data(const void *data, fc_texture *texture, fc_mapping *mapping, fc_mapping_kind *kind, fc_image *image) {
  FC_READ(texture, data, sizeof *texture);
  FC_READ_ONE(mapping, texture->mapping);
  FC_READ_ONE(kind, mapping->kind);
  FC_READ(image, texture->pattern_data, sizeof *image);
}

static FC_COLD bool fits(const fc_scan *scan, const void *data) {
  const fc_kind *shape = fc_kind_of(scan->at);
  fc_texture texture;
  fc_mapping mapping;
  fc_mapping_kind kind;
  fc_image image;
  FC_READ(&texture, data, sizeof texture);
  if (texture.pattern != &fc_texture_image) return false;
  open_data(data, &texture, &mapping, &kind, &image);
  return (shape->weights != NULL || shape->bounds == NULL) && kind.forms != NULL && image.bilinear && image.format == FC_TEXEL_RGB888 &&
         light_of(scan, texture.modulate != 0, NULL);
}

/* A form of the pixel in 64 bits. */
typedef fc_coat_wide wide_form;

/* m.D / 2^32 over the tile: below 2^62. D's x moves along a row and its y along a column. */
static FC_COLD void set_wide(wide_form *form, const int64_t m[3], const int64_t d[3], int64_t step) {
  form->at = fc_smul64hi(m[0], (int32_t)d[0]) + fc_smul64hi(m[1], (int32_t)d[1]) + fc_smul64hi(m[2], (int32_t)d[2]);
  form->dx = fc_smul64hi(m[0], (int32_t)step);
  form->dy = fc_smul64hi(m[1], (int32_t)-step);
}

/* v m / 2^33 / 2^down. */
static FC_COLD int64_t scaled(int64_t v, uint32_t m, uint8_t down) { return fc_floor_shift64(fc_smul64hi(v, (int32_t)(m >> 1)), down); }

static FC_COLD uint8_t bits_in_tile(const fc_scan *scan, const wide_form *f) {
  const int64_t right = f->dx * (scan->columns - 1), down = f->dy * (scan->rows - 1);
  return fc_bits64(fc_abs64(f->at) | fc_abs64(f->at + right) | fc_abs64(f->at + down) | fc_abs64(f->at + right + down));
}

/* v 2^(32 - cut), modulo 2^64: its upper word is v / 2^cut. */
static uint64_t placed(int64_t v, uint8_t cut) { return cut <= 32 ? (uint64_t)v << (32 - cut) : (uint64_t)fc_floor_shift64(v, (uint8_t)(cut - 32)); }

static FC_COLD void place(fc_coat_form *form, const wide_form *f, uint8_t cut) {
  form->at = placed(f->at, cut);
  form->dx = placed(f->dx, cut);
  form->dy = placed(f->dy, cut);
}

/*
 * A coordinate is u = scale (m.D) / (n.D) for vectors of the tile (fc_mapping_kind.forms). In texels from the centre of the tile's texel 0 that is
 * X = A / Q, both affine in the pixel; whole images are taken out of A where the middle of the tile lies, so that what is left is short.
 * A is short of the truth by 2^-26 of what it is from the mapping's origin, at most 2^14 texels: 2^-12 of a texel.
 */
static FC_COLD bool set_axis(const fc_scan *scan, const wide_form *q, const wide_form *u, fc_quick scale, uint16_t size, bool clamp, uint8_t q_cut,
                             fc_coat_axis *axis) {
  const int32_t down = 24 - 33 - scale.e, column = scan->columns / 2, row = scan->rows / 2;
  wide_form a;
  uint8_t bits;
  if (down < 0 || down > 60 || scale.m == 0) return false;
  a.at = scaled(u->at, scale.m, (uint8_t)down) - fc_floor_shift64(q->at, 1);
  a.dx = scaled(u->dx, scale.m, (uint8_t)down) - fc_floor_shift64(q->dx, 1);
  a.dy = scaled(u->dy, scale.m, (uint8_t)down) - fc_floor_shift64(q->dy, 1);
  {
    const int64_t middle = a.at + a.dx * column + a.dy * row, q_middle = q->at + q->dx * column + q->dy * row;
    int64_t whole;
    fc_quick far;
    if (q_middle <= 0) return false;
    far = fc_quick_mul(fc_quick_from(fc_abs64(middle), 0), fc_quick_recip(fc_quick_from((uint64_t)q_middle, 0)));
    whole = fc_quick_to_int(far, 0);
    if (whole >> 14 != 0) return false;
    if (!clamp) {
      whole = fc_quick_to_int(fc_quick_mul(far, fc_quick_recip(fc_quick_from(size, 0))), 0) * (int64_t)size;
      if (middle < 0) whole = -whole - size;
      a.at -= whole * q->at; /* 15 bits and 38 */
      a.dx -= whole * q->dx;
      a.dy -= whole * q->dy;
    }
  }
  bits = bits_in_tile(scan, &a);
  axis->less = bits > 29 + q_cut ? (uint8_t)(bits - 29 - q_cut) : 0;
  if (axis->less > 14) return false;
  axis->size = size;
  place(&axis->form, &a, (uint8_t)(q_cut + axis->less));
  return true;
}

static FC_COLD void planar_start(fc_coat *coat, const void *data) {
  const fc_scan *scan = coat->scan;
  fc_coat_texture *to = &coat->texture;
  fc_texture texture;
  fc_mapping mapping;
  fc_mapping_kind kind;
  fc_image image;
  fc_mapping_forms forms;
  int64_t d[3], step;
  wide_form q, u;
  uint8_t i, bits, q_cut;
  coat->textured = coat->cosines = true;
  to->sure = false;
  open_data(data, &texture, &mapping, &kind, &image);
  (void)light_of(scan, texture.modulate != 0, to);
  to->texels = image.texels;
  to->clamp = image.clamp != 0;
  to->width = image.width;
  if (!kind.forms(coat, &mapping, &forms)) return;
  fc_scan_direction(scan, d, &step);
  set_wide(&q, forms.n, d, step);
  q.at = fc_floor_shift64(q.at, 24);
  q.dx = fc_floor_shift64(q.dx, 24);
  q.dy = fc_floor_shift64(q.dy, 24);
  bits = bits_in_tile(scan, &q); /* at most 38 */
  if (bits < 31) return;
  q_cut = (uint8_t)(bits - 31);
  place(&to->q, &q, q_cut);
  for (i = 0; i < 2; i++) {
    const uint16_t size = i == 0 ? image.width : image.height;
    const fc_quick scale =
        fc_quick_mul(forms.scale[i], fc_quick_from((uint64_t)size * (i == 0 ? mapping.repeat_u : mapping.repeat_v), 0));
    set_wide(&u, forms.m[i], d, step);
    if (!set_axis(scan, &q, &u, scale, size, to->clamp, q_cut, &to->axis[i])) return;
  }
  to->sure = true;
}

/* What find_texels follows along a row. */
typedef struct texel_run {
  uint64_t q, q_dx, a[2], a_dx[2];
  uint8_t less[2];
} texel_run;

/*
 * Texel coordinates in Q16 of a run's pixels, from the tile's texel 0; returns those that are too rough. With q = Q's upper word, below 2^31, and m = q 2^up
 * normalised, r = 2^62 / m is within 2^-26; X = a 2^(less + 16) / q in Q16 is a r / 2^32 / 2^(14 - less - up). q is floored, 2^(up - 31) of itself, and X
 * below 2^(less + up - 2): together less than 2^-11 of a texel where less + 2 up <= 22; a's floor costs 2^(less + up - 15) in Q16.
 */
static FC_HOT uint32_t find_texels(const texel_run *of, uint8_t count, int32_t *x, int32_t *y) {
  uint64_t q = of->q, a = of->a[0], b = of->a[1];
  const uint8_t a_less = of->less[0], b_less = of->less[1], less = a_less > b_less ? a_less : b_less;
  uint32_t rough = 0, bit = 1;
  do {
    const uint32_t word = (uint32_t)(q >> 32);
    uint8_t up = 0;
    if (word - 1 < UINT32_C(0x7fffffff)) {
      up = fc_clz32(word);
      if (less + up <= 14 && less + 2 * up <= 22) {
        const uint32_t m = word << up;
        uint32_t r = fc_recip_q31(m >> 16) << 15;
        const int32_t e = (int32_t)(UINT32_C(1) << 30) - (int32_t)fc_mulhi32(m, r);
        r += (uint32_t)fc_floor_shift32((int32_t)(r >> 16) * fc_floor_shift32(e, 2), 12);
        *x = fc_floor_shift32(fc_smulhi32(fc_high_word(fc_to_i64(a)), r), (uint8_t)(14 - a_less - up));
        *y = fc_floor_shift32(fc_smulhi32(fc_high_word(fc_to_i64(b)), r), (uint8_t)(14 - b_less - up));
      } else {
        rough |= bit;
      }
    } else {
      rough |= bit;
    }
    x++;
    y++;
    bit <<= 1;
    q += of->q_dx;
    a += of->a_dx[0];
    b += of->a_dx[1];
  } while (--count != 0);
  return rough;
}

/* x into 0 .. size - 1: *base, a multiple of size, follows it. */
FC_INLINE int32_t tiled(int32_t x, int32_t size, int32_t *base) {
  x -= *base;
  while (x < 0) {
    x += size;
    *base -= size;
  }
  while (x >= size) {
    x -= size;
    *base += size;
  }
  return x;
}

/* Two neighbours along an axis. */
typedef struct texel_pair {
  int32_t base;
  uint32_t first, second;
} texel_pair;

FC_INLINE void pair_at(texel_pair *pair, int32_t x, int32_t size, bool clamp) {
  if (clamp) {
    pair->first = (uint32_t)(x < 0 ? 0 : x >= size ? size - 1 : x);
    pair->second = (uint32_t)(x + 1 < 0 ? 0 : x + 1 >= size ? size - 1 : x + 1);
  } else {
    pair->first = (uint32_t)tiled(x, size, &pair->base);
    pair->second = pair->first + 1 == (uint32_t)size ? 0 : pair->first + 1;
  }
}

/* One channel of four texels: weights in Q16 that add up to 1, so 24 bits. */
FC_INLINE uint32_t mixed(const uint8_t *const texel[4], const uint32_t weight[4], uint8_t channel) {
  uint8_t i, v;
  uint32_t sum = 0;
  for (i = 0; i < 4; i++) {
    FC_READ_ONE(&v, texel[i] + channel);
    sum += v * weight[i];
  }
  return sum;
}

/* A channel of light, levels times 256 / 255, and a texel's: 17 bits, below 1.004 2^16, and 15; 2^-8 and 2^-7 of a level are cut. */
FC_INLINE uint32_t shaded(const fc_coat_texture *texture, uint8_t channel, uint32_t cosine, uint32_t texel) {
  return ((texture->base[channel] + texture->slope[channel] * cosine) >> 15) * (texel >> 9);
}

static FC_HOT void put_texels(const fc_coat *coat, uint32_t bits, const int32_t *x, const int32_t *y, const uint32_t *cosine, uint8_t *to,
                              uint8_t pixel_bytes) {
  const fc_coat_texture *texture = &coat->texture;
  const fc_tint *tint = &coat->scan->tint;
  const uint8_t *texels = texture->texels;
  const bool clamp = texture->clamp, plain = tint->format == FC_RGB565_BE && tint->transfer == NULL;
  texel_pair across = {0, 0, 0}, down = {0, 0, 0};
  for (; bits != 0; bits >>= 1, x++, y++, cosine++, to += pixel_bytes) {
    const uint8_t *texel[4];
    uint32_t weight[4], fx, fy, v[3];
    uint8_t i;
    if (!(bits & 1)) continue;
    pair_at(&across, fc_floor_shift32(*x, 16), texture->axis[0].size, clamp);
    pair_at(&down, fc_floor_shift32(*y, 16), texture->axis[1].size, clamp);
    fx = (uint32_t)*x & 0xffffu;
    fy = (uint32_t)*y & 0xffffu;
    weight[3] = fx * fy >> 16;
    weight[1] = fx - weight[3];
    weight[2] = fy - weight[3];
    weight[0] = 65536 - fx - weight[2];
    /* 12 + 12 bits, three bytes each */
    texel[0] = texels + 3 * (down.first * texture->width + across.first);
    texel[1] = texels + 3 * (down.first * texture->width + across.second);
    texel[2] = texels + 3 * (down.second * texture->width + across.first);
    texel[3] = texels + 3 * (down.second * texture->width + across.second);
    for (i = 0; i < 3; i++) v[i] = shaded(texture, i, *cosine, mixed(texel, weight, i));
    if (plain) {
      const uint32_t half = UINT32_C(1) << 22;
      uint32_t red = (v[0] + half) >> 23, green = (v[1] + half) >> 23, blue = (v[2] + half) >> 23;
      if (red > 31) red = 31;
      if (green > 63) green = 63;
      if (blue > 31) blue = 31;
      red = (red << 6 | green) << 5 | blue;
      to[0] = (uint8_t)(red >> 8);
      to[1] = (uint8_t)red;
    } else {
      fc_coat_put_levels(tint, v, to);
    }
  }
}

static FC_NOINLINE void planar_run(fc_coat *coat, const void *data) {
  const fc_coat_texture *texture = &coat->texture;
  fc_coat_run *run = &coat->run;
  int32_t x[32], y[32];
  texel_run at;
  uint8_t i;
  (void)data;
  if (!texture->sure) {
    run->slow = run->bits;
    return;
  }
  at.q = texture->q.at + fc_times(texture->q.dx, run->column) + fc_times(texture->q.dy, run->row);
  at.q_dx = texture->q.dx;
  for (i = 0; i < 2; i++) {
    const fc_coat_form *form = &texture->axis[i].form;
    at.a[i] = form->at + fc_times(form->dx, run->column) + fc_times(form->dy, run->row);
    at.a_dx[i] = form->dx;
    at.less[i] = texture->axis[i].less;
  }
  run->slow |= run->bits & find_texels(&at, run->count, x, y);
  put_texels(coat, run->bits & ~run->slow, x, y, run->cosine, fc_scan_pixel(coat->scan, run->row, run->column), coat->scan->pixel_bytes);
}

const fc_coat_layer fc_coat_layer_texture FC_ROM = {&fc_coat_layers, FC_COAT_COLOURS, fits, planar_start, NULL, planar_run, NULL, NULL};
