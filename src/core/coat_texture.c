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
    if (modulate && base >= (uint32_t)top << FC_TINT_BITS) return false; /* the tint was cut there */
    base += base >> 8;                                                   /* 256 / 255 within 2^-16 */
    slope += (slope + 128) >> 8;
    if (slope >= UINT32_C(0x8000) || base + (slope << 16) < base) return false;
    if (texture != NULL) {
      texture->base[i] = base;
      texture->slope[i] = slope;
    }
  }
  return true;
}

/* Whether white in full light is less than half a level too bright for RGB565 as it is. */
static FC_COLD bool plain(const fc_scan *scan, const fc_coat_texture *texture) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    const uint32_t most = ((texture->base[i] + (texture->slope[i] << 16)) >> 16) * 65280; /* 16 + 16 bits */
    if (most >= ((uint32_t)scan->tint.most[i] << FC_TINT_BITS) + (UINT32_C(1) << (FC_TINT_BITS - 1))) return false;
  }
  return scan->tint.format == FC_RGB565_BE && scan->tint.transfer == NULL;
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
  fc_texture_kind pattern;
  fc_mapping mapping;
  fc_mapping_kind kind;
  fc_image image;
  FC_READ(&texture, data, sizeof texture);
  FC_READ_ONE(&pattern, texture.pattern);
  if (pattern.put == NULL) return false;
  open_data(data, &texture, &mapping, &kind, &image);
  return (shape->weights != NULL || shape->bounds == NULL) && kind.forms != NULL && image.bilinear &&
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

/*
 * A coordinate is u = scale (m.D) / (n.D) for vectors of the tile (fc_mapping_kind.forms). In texels from the centre of texel 0 that is
 * X = A / Q, both affine in the pixel. A is short of the truth by 2^-26 of what it is from the mapping's origin.
 */
static FC_COLD bool set_axis(const wide_form *q, const wide_form *u, fc_quick scale, uint16_t size, fc_coat_axis *axis) {
  const int32_t down = 24 - 33 - scale.e;
  if (down < 0 || down > 60 || scale.m == 0) return false;
  axis->a.at = scaled(u->at, scale.m, (uint8_t)down) - fc_floor_shift64(q->at, 1);
  axis->a.dx = scaled(u->dx, scale.m, (uint8_t)down) - fc_floor_shift64(q->dx, 1);
  axis->a.dy = scaled(u->dy, scale.m, (uint8_t)down) - fc_floor_shift64(q->dy, 1);
  axis->size = size;
  axis->inverse = fc_quick_recip(fc_quick_from(size, 0));
  return true;
}

static FC_COLD void planar_start(fc_coat *coat, const void *data) {
  const fc_scan *scan = coat->scan;
  fc_coat_texture *to = &coat->texture;
  fc_texture texture;
  fc_texture_kind pattern;
  fc_mapping mapping;
  fc_mapping_kind kind;
  fc_image image;
  fc_mapping_forms forms;
  int64_t d[3], step;
  wide_form q, u;
  uint8_t i;
  coat->textured = coat->cosines = true;
  to->sure = false;
  open_data(data, &texture, &mapping, &kind, &image);
  (void)light_of(scan, texture.modulate != 0, to);
  FC_READ_ONE(&pattern, texture.pattern);
  pattern.open(texture.pattern_data, to);
  to->pattern = texture.pattern;
  to->width = image.width;
  to->clamp = image.clamp != 0;
  to->mask[0] = image.width - 1u;
  to->mask[1] = image.height - 1u;
  to->masked = !to->clamp && (image.width & to->mask[0]) == 0 && (image.height & to->mask[1]) == 0;
  to->plain = to->masked && plain(scan, to);
  if (!kind.forms(coat, &mapping, &forms)) return;
  fc_scan_direction(scan, d, &step);
  set_wide(&q, forms.n, d, step);
  q.at = fc_floor_shift64(q.at, 24);
  q.dx = fc_floor_shift64(q.dx, 24);
  q.dy = fc_floor_shift64(q.dy, 24);
  to->q = q;
  for (i = 0; i < 2; i++) {
    const uint16_t size = i == 0 ? image.width : image.height;
    const fc_quick scale =
        fc_quick_mul(forms.scale[i], fc_quick_from((uint64_t)size * (i == 0 ? mapping.repeat_u : mapping.repeat_v), 0));
    set_wide(&u, forms.m[i], d, step);
    if (!set_axis(&q, &u, scale, size, &to->axis[i])) return;
  }
  to->sure = true;
}

/* What finds a run's texels: X less `base` is a 2^less / q; below 2^31 and 2^29. */
typedef struct texel_run {
  uint32_t q, q_dx;
  int32_t a[2], a_dx[2], base[2];
  uint8_t less[2];
  bool near; /* X less base is within 8 texels */
} texel_run;

/*
 * X in Q16 of a run's pixels, less base. q and a are rounded once and at each step: within 17 after 32 pixels. With m = q 2^up normalised,
 * up at most 4, q is within 2^-22.9 of itself: times X, below 2^12 where it is not near, 2^-10.9 of a texel. Near ones have a reciprocal
 * within 2^-15 and X in 2^-11; others within 2^-26. Returns those that are too rough.
 */
static FC_HOT uint32_t find_near(const texel_run *of, uint8_t first, uint8_t count, int32_t *xy) {
  uint32_t q = of->q + of->q_dx * first, rough = 0, bit = UINT32_C(1) << first;
  uint32_t a = (uint32_t)of->a[0] + (uint32_t)of->a_dx[0] * first; /* a step past the run wraps */
  uint32_t b = (uint32_t)of->a[1] + (uint32_t)of->a_dx[1] * first;
  const uint32_t q_dx = of->q_dx;
  const uint32_t a_dx = (uint32_t)of->a_dx[0], b_dx = (uint32_t)of->a_dx[1];
  const uint8_t a_down = (uint8_t)(16 - of->less[0]), b_down = (uint8_t)(16 - of->less[1]);
  uint8_t up = 1;
  xy += 2 * first;
  do {
    uint32_t m = q << up;
    int32_t r;
    while (!(m >> 31)) {
      if (up == 5) break;
      m <<= 1;
      up++;
    }
    while (m >> up != q) m = q << --up;
    if (up > 4 || !(m >> 31)) {
      rough |= bit;
      up = 1;
    } else {
      /* a / 2^15 r is X 2^(31 + up - less - ...): a 2^(less + 16) / q = (a / 2^15) r 2^(less + up - 16) */
      r = (int32_t)fc_recip_q31(m >> 16);
      xy[0] = fc_floor_shift32(fc_floor_shift32(fc_to_i32(a), 15) * r, (uint8_t)(a_down - up));
      xy[1] = fc_floor_shift32(fc_floor_shift32(fc_to_i32(b), 15) * r, (uint8_t)(b_down - up));
    }
    xy += 2;
    bit <<= 1;
    q += q_dx;
    a += a_dx;
    b += b_dx;
  } while (--count != 0);
  return rough;
}

/* X of a pixel by Newton's step on the reciprocal; false where it would be too rough. */
static FC_HOT bool find_at(const texel_run *of, uint32_t q, uint32_t a, uint32_t b, int32_t *to) {
  uint8_t up = 0;
  uint32_t r;
  int32_t e;
  while (!(q >> 31)) { /* once or twice */
    if (up == 4) return false;
    q <<= 1;
    up++;
  }
  if (up == 0 || of->less[0] + up > 14 || of->less[1] + up > 14) return false;
  r = fc_recip_q31(q >> 16) << 15; /* 2^62 / q, and a step of Newton's */
  e = (int32_t)(UINT32_C(1) << 30) - (int32_t)fc_mulhi32(q, r);
  r += (uint32_t)fc_floor_shift32((int32_t)(r >> 16) * fc_floor_shift32(e, 2), 12);
  to[0] = fc_floor_shift32(fc_smulhi32(fc_to_i32(a), r), (uint8_t)(14 - of->less[0] - up));
  to[1] = fc_floor_shift32(fc_smulhi32(fc_to_i32(b), r), (uint8_t)(14 - of->less[1] - up));
  return true;
}

/* Those from `first` on, one by one. */
static FC_NOINLINE uint32_t find_far(const texel_run *of, uint8_t first, uint8_t count, int32_t *xy) {
  uint32_t q = of->q + of->q_dx * first, rough = 0;
  uint32_t a = (uint32_t)of->a[0] + (uint32_t)of->a_dx[0] * first, b = (uint32_t)of->a[1] + (uint32_t)of->a_dx[1] * first;
  for (; count != 0; count--, first++) {
    if (!find_at(of, q, a, b, xy + 2 * first)) rough |= UINT32_C(1) << first;
    q += of->q_dx; /* a step past the run wraps */
    a += (uint32_t)of->a_dx[0];
    b += (uint32_t)of->a_dx[1];
  }
  return rough;
}

static uint32_t find_single(const texel_run *of, uint8_t first, uint8_t count, int32_t *xy) {
  return of->near ? find_near(of, first, count, xy) : find_far(of, first, count, xy);
}

/*
 * Pixels of the parabola through three points h = 4 or 2 apart: t steps on it is x0 + t d / h + t (t - h) b / (2 h^2), d the first difference
 * and b the second. In Q20, from 0, as what is added up is below 2^27 (bends). Steps are off by 2^-21: after seven by 2^-18.
 */
static FC_HOT void bend(const int32_t *from, const int32_t *middle, const int32_t *to, uint8_t h, int32_t *xy) {
  uint8_t axis, i;
  for (axis = 0; axis < 2; axis++) {
    const int32_t start = *from++, d = *middle - start, b = *to++ - *middle - d, bow = h == 4 ? b : 4 * b;
    int32_t step = h == 4 ? 4 * d - fc_floor_shift32(3 * b, 1) : 8 * d - 2 * b, at = 0, *put = xy++;
    middle++;
    for (i = h; i != 0; i--) {
      put[0] = start + fc_floor_shift32(at, 4);
      at += step;
      step += bow;
      put[2] = start + fc_floor_shift32(at, 4);
      at += step;
      step += bow;
      put += 4;
    }
  }
}

/*
 * Where a parabola is near enough. X = whole + D / Q along a row, so its third difference is 6 X' e^2 with e = Q' / Q, and a parabola through
 * points h apart is off by 0.385 h^3 X' e^2. X' is v / 2h (1 + 2h e) at most, v the difference of the ends; e <= 2^-5: 3.9 v e^2 for h = 4
 * and 0.87 v e^2 for h = 2. v in Q8 times e^2 in Q26 is the bound in Q34, 2^23: 2^-11 of a texel before the factor 3.9, or 2^25 and 0.87.
 */
static bool bends(const int32_t *from, const int32_t *to, uint32_t square, uint32_t bound) {
  const uint32_t v0 = fc_abs32(to[0] - from[0]), v1 = fc_abs32(to[1] - from[1]), v = (v0 > v1 ? v0 : v1) >> 8;
  return v < UINT32_C(1) << 14 && (v + 1) * square <= bound; /* 14 + 17 bits */
}

/* e^2 in Q26, rounded up, at the run's end with the least q; more than 2^16 where e is beyond 2^-5. */
static uint32_t bend_of(const texel_run *of, uint8_t steps) {
  const uint32_t last = of->q + of->q_dx * steps, least = last < of->q ? last : of->q;
  const uint32_t speed = fc_abs32(fc_to_i32(of->q_dx)) >> 10;
  const uint8_t up = fc_clz32(least | 1);
  uint32_t e;
  if (last >> 31 != 0 || up > 4 || speed >= UINT32_C(1) << 15) return UINT32_C(1) << 17; /* rounded below 0 */
  /* speed 2^10 / least, least = m 2^(16 - up), r = 2^31 / m: Q16 */
  e = ((speed + 1) * (fc_recip_q31((least << up) >> 16) + 2) >> (21 - up)) + 1;
  return e > 2048 ? UINT32_C(1) << 17 : (e * e >> 6) + 1;
}

/* Four pixels between points. */
static FC_NOINLINE uint32_t find_four(const texel_run *of, uint8_t first, uint8_t count, const int32_t *from, const int32_t *to, uint32_t square,
                                      uint32_t bound, int32_t *xy) {
  const uint32_t n = first + 2u;
  int32_t middle[2];
  if (first >= count) return 0;
  if (bends(from, to, square, bound) && find_at(of, of->q + of->q_dx * n, (uint32_t)of->a[0] + (uint32_t)of->a_dx[0] * n,
                                                (uint32_t)of->a[1] + (uint32_t)of->a_dx[1] * n, middle)) {
    bend(from, middle, to, 2, xy + 2 * first);
    return 0;
  }
  return find_single(of, first, (uint8_t)(count - first < 4 ? count - first : 4), xy);
}

/* Eight or four at a time where a parabola is near enough. The forms hold for a whole number of eights. */
static FC_HOT uint32_t find_bent(const texel_run *of, uint8_t count, uint32_t bound, int32_t *xy) {
  const uint32_t square = bend_of(of, (uint8_t)((count + 7) & ~7));
  uint32_t q = of->q, rough = 0, a = (uint32_t)of->a[0], b = (uint32_t)of->a[1];
  int32_t point[3][2];
  uint8_t first, i;
  bool sure = square <= UINT32_C(1) << 16 && find_at(of, q, a, b, point[0]);
  for (first = 0; first < count; first = (uint8_t)(first + 8)) {
    for (i = 1; i < 3 && sure; i++) {
      q += of->q_dx << 2;
      a += (uint32_t)of->a_dx[0] << 2;
      b += (uint32_t)of->a_dx[1] << 2;
      sure = find_at(of, q, a, b, point[i]);
    }
    if (!sure) return rough | find_single(of, first, (uint8_t)(count - first), xy);
    if (bends(point[0], point[2], square, bound)) {
      bend(point[0], point[1], point[2], 4, xy + 2 * first);
    } else {
      rough |= find_four(of, first, count, point[0], point[1], square, 4 * bound, xy);
      rough |= find_four(of, (uint8_t)(first + 4), count, point[1], point[2], square, 4 * bound, xy);
    }
    point[0][0] = point[2][0];
    point[0][1] = point[2][1];
  }
  return rough;
}

/* The word of v / 2^cut, cut -31 .. 60. */
static int32_t short_of(int64_t v, int8_t cut) {
  return (int32_t)(cut > 0 ? fc_floor_shift64(v + (INT64_C(1) << (cut - 1)), (uint8_t)cut) : v * (INT64_C(1) << -cut));
}

/* A form at a run's first pixel. */
static int64_t form_at(const wide_form *f, const fc_coat_run *run) {
  return fc_to_i64((uint64_t)f->at + fc_times((uint64_t)f->dx, run->column) + fc_times((uint64_t)f->dy, run->row));
}

/* v n for a small n. */
static int64_t small_times(int64_t v, int32_t n) {
  return fc_to_i64(n < 0 ? 0u - fc_times((uint64_t)v, (uint32_t)-n) : fc_times((uint64_t)v, (uint32_t)n));
}

/* Forms of a run, whose ends are seen; false when they tell too little. What X is in its middle is taken out, so that it is short. */
static FC_NOINLINE bool start_run(const fc_coat_texture *texture, const fc_coat_run *run, uint8_t steps, texel_run *to) {
  const int64_t q = form_at(&texture->q, run), last = q + small_times(texture->q.dx, steps);
  const int64_t most = q > last ? q : last;
  fc_quick inverse;
  uint8_t i, bits;
  int8_t cut;
  if (q <= 0 || last <= 0) return false;
  cut = (int8_t)(fc_bits64((uint64_t)most) - 31);
  if (cut < -8) return false; /* Q's own floors */
  to->q = (uint32_t)short_of(q, cut);
  to->q_dx = (uint32_t)short_of(texture->q.dx, cut);
  if (to->q >> 31 != 0) return false; /* rounded up */
  inverse = fc_quick_recip(fc_quick_from((uint64_t)(q + last), -1));
  to->near = true;
  for (i = 0; i < 2; i++) {
    const fc_coat_axis *axis = &texture->axis[i];
    int64_t a = form_at(&axis->a, run), dx = axis->a.dx, end = a + small_times(dx, steps);
    const int64_t middle = a + ((end - a) >> 1);
    const fc_quick far = fc_quick_mul(fc_quick_from(fc_abs64(middle), 0), inverse);
    int32_t whole = fc_quick_to_int(far, 0);
    if (whole >> 14 != 0) return false; /* 2^-26 of it are 2^-12 */
    if (middle < 0) whole = -whole;
    if (whole != 0) {
      a -= small_times(q, whole); /* 38 + 15 bits */
      dx -= small_times(texture->q.dx, whole);
      end -= small_times(last, whole);
    }
    bits = fc_bits64(fc_abs64(a) | fc_abs64(end));
    to->less[i] = bits > 29 + cut ? (uint8_t)(bits - 29 - cut) : 0;
    /* X less `whole` is a 2^less / q, a below 2^29 */
    if (to->less[i] > 12) return false;
    if (to->less[i] > 4) to->near = false;
    to->a[i] = short_of(a, (int8_t)(cut + to->less[i]));
    to->a_dx[i] = short_of(dx, (int8_t)(cut + to->less[i]));
    if (!texture->clamp) {
      /* modulo size: floor(whole / size) by a value within 2^-25, then right */
      int32_t images = fc_quick_to_int(fc_quick_mul(fc_quick_from(fc_abs32(whole), 0), axis->inverse), 0);
      whole -= (whole < 0 ? -images : images) * axis->size;
    }
    to->base[i] = whole;
  }
  return true;
}

static FC_NOINLINE void planar_run(fc_coat *coat, const void *data) {
  const fc_coat_texture *texture = &coat->texture;
  fc_coat_run *run = &coat->run;
  int32_t xy[64];
  texel_run at;
  fc_coat_span span;
  fc_texture_kind pattern;
  (void)data;
  if (!texture->sure) {
    run->slow = run->bits;
    return;
  }
  if (start_run(texture, run, (uint8_t)((run->count + 7) & ~7), &at)) {
    run->slow |= run->bits & find_bent(&at, run->count, texture->plain ? UINT32_C(1) << 23 : UINT32_C(1) << 21, xy);
  } else if (start_run(texture, run, (uint8_t)(run->count - 1), &at)) { /* the horizon may lie behind the run */
    run->slow |= run->bits & find_single(&at, 0, run->count, xy);
  } else {
    run->slow = run->bits;
    return;
  }
  span.scan = coat->scan;
  span.bits = run->bits & ~run->slow;
  span.base[0] = at.base[0];
  span.base[1] = at.base[1];
  span.xy = xy;
  span.cosine = run->cosine;
  span.to = fc_scan_pixel(coat->scan, run->row, run->column);
  FC_READ_ONE(&pattern, texture->pattern);
  pattern.put(texture, &span);
}

const fc_coat_layer fc_coat_layer_texture FC_ROM = {&fc_coat_layers, FC_COAT_COLOURS, fits, planar_start, NULL, planar_run, NULL, NULL, NULL};
