/* Phong's highlight by fast forms: the power in the log2 domain, from squares that are followed along a row. */
#include "coat.h"

/* log2(1 + i / 256) - i / 256, Q19. */
static const uint16_t log_table[257] FC_ROM = {
    0, 901, 1790, 2668, 3535, 4391, 5235, 6069, 6891, 7703, 8504, 9294, 10074, 10843, 11601, 12350, 13088, 13815,
    14533, 15241, 15938, 16626, 17303, 17971, 18630, 19278, 19917, 20547, 21167, 21777, 22379, 22971, 23554, 24127,
    24692, 25248, 25795, 26333, 26862, 27382, 27894, 28397, 28891, 29377, 29855, 30324, 30785, 31237, 31681, 32117,
    32545, 32965, 33377, 33781, 34177, 34565, 34945, 35317, 35682, 36039, 36389, 36730, 37065, 37392, 37711, 38023,
    38328, 38625, 38915, 39198, 39474, 39743, 40004, 40259, 40506, 40747, 40981, 41208, 41428, 41641, 41847, 42047,
    42240, 42427, 42607, 42780, 42947, 43107, 43261, 43409, 43550, 43685, 43814, 43936, 44053, 44163, 44266, 44364,
    44456, 44542, 44621, 44695, 44763, 44825, 44881, 44931, 44975, 45014, 45047, 45074, 45095, 45111, 45121, 45126,
    45125, 45118, 45106, 45089, 45066, 45038, 45004, 44965, 44921, 44871, 44816, 44756, 44691, 44620, 44545, 44464,
    44378, 44287, 44191, 44090, 43984, 43873, 43757, 43636, 43510, 43380, 43244, 43104, 42959, 42809, 42654, 42495,
    42331, 42162, 41988, 41810, 41628, 41440, 41249, 41052, 40851, 40646, 40436, 40222, 40003, 39780, 39552, 39320,
    39084, 38843, 38598, 38349, 38096, 37838, 37576, 37310, 37039, 36765, 36486, 36203, 35917, 35626, 35330, 35031,
    34728, 34421, 34110, 33795, 33476, 33153, 32826, 32495, 32160, 31821, 31479, 31132, 30782, 30428, 30070, 29709,
    29344, 28975, 28602, 28226, 27845, 27462, 27074, 26683, 26288, 25890, 25488, 25083, 24674, 24261, 23845, 23426,
    23002, 22576, 22146, 21712, 21275, 20835, 20391, 19944, 19493, 19039, 18582, 18122, 17658, 17190, 16720, 16246,
    15769, 15289, 14805, 14318, 13828, 13335, 12838, 12339, 11836, 11330, 10821, 10309, 9794, 9275, 8754, 8229, 7701,
    7171, 6637, 6100, 5561, 5018, 4472, 3923, 3372, 2817, 2260, 1699, 1136, 569, 0};

/* 2^-(i / 64), Q15. */
static const uint16_t exp_table[65] FC_ROM = {
    32768, 32415, 32066, 31720, 31379, 31041, 30706, 30376, 30048, 29725, 29405, 29088, 28774, 28464, 28158, 27855,
    27554, 27258, 26964, 26674, 26386, 26102, 25821, 25543, 25268, 24995, 24726, 24460, 24196, 23936, 23678, 23423,
    23170, 22921, 22674, 22430, 22188, 21949, 21713, 21479, 21247, 21019, 20792, 20568, 20347, 20127, 19911, 19696,
    19484, 19274, 19066, 18861, 18658, 18457, 18258, 18061, 17867, 17674, 17484, 17296, 17109, 16925, 16743, 16562,
    16384};

/* log2(v) in Q20 for v > 0: within 2^-18.4, and never more than 2^-20 above: chords of a concave curve, 2^-18.5 below it at most. */
FC_INLINE int32_t log_of(uint32_t v) {
  const uint8_t up = fc_clz32(v);
  const uint16_t *entry;
  uint32_t part, from;
  int32_t rise;
  v <<= up;
  entry = log_table + (v >> 23 & 255);
  part = v >> 7 & 0xffffu;
  from = fc_read_table(entry);
  rise = (int32_t)fc_read_table(entry + 1) - (int32_t)from; /* within 2^10: 26 bits */
  return ((int32_t)(31 - up) << 20) + (int32_t)(v >> 11 & 0xfffffu) + 2 * (int32_t)from + fc_floor_shift32(rise * (int32_t)part, 15);
}

/* 2^-t for t in Q16, Q16: within 2^-15. */
static uint32_t power_of_half(uint32_t t) {
  const uint32_t whole = t >> 16, part = t & 1023;
  const uint16_t *entry = exp_table + (t >> 10 & 63);
  const uint32_t from = fc_read_table(entry), to = fc_read_table(entry + 1);
  return whole > 16 ? 0 : (2 * from - ((from - to) * part >> 9)) >> whole;
}

/*
 * c^n in Q16 from log2(1 / c^2) in Q20. Where it is off by d, c^n is off by n / 2 ln 2 d of itself: four logarithms' errors, 2^-16.5 in all, cost
 * 0.35 n 2^-16.5: 2^-10.1 for n = 256.
 */
static uint32_t highlight(const fc_coat_phong *phong, int32_t loss) {
  if (loss <= 0) return 65536;
  if ((uint32_t)loss >= phong->most) return 0;
  /* n in Q8 and Q19; n loss is at most 25.5: below 2^32; half of it in Q16 */
  return power_of_half(phong->shininess_q8 * ((uint32_t)loss >> 1) >> 12);
}

static FC_COLD bool fits(const fc_scan *scan, const void *data) {
  fc_phong layer;
  uint16_t specular[3];
  uint8_t i;
  FC_READ(&layer, data, sizeof layer);
  fc_channels(&layer.specular, specular);
  for (i = 0; i < 3; i++)
    if (fc_scan_slope(scan, specular[i], i) >= UINT32_C(0x8000)) return false;
  return layer.shininess_q8 >= 256 && layer.shininess_q8 <= UINT32_C(65536);
}

static FC_COLD void start(fc_coat *coat, const void *data) {
  fc_coat_phong *phong = &coat->phong;
  fc_phong layer;
  uint16_t specular[3];
  uint32_t t;
  uint8_t i;
  FC_READ(&layer, data, sizeof layer);
  fc_channels(&layer.specular, specular);
  for (i = 0; i < 3; i++) phong->slope[i] = fc_scan_slope(coat->scan, specular[i], i);
  phong->shininess_q8 = layer.shininess_q8;
  /* c^n < 2^-12 where log2(1 / c^2) > 24 / n: 1 and more in Q8, so 24 2^24 / n is below 24 2^16 */
  t = (uint32_t)fc_quick_times(fc_quick_recip(fc_quick_from(layer.shininess_q8, 0)), INT64_C(24) << 24, 0);
  phong->most = 16 * t + t;
  t = power_of_half(t);
  /* the test's own products are cut by less than 2^-8 */
  phong->least = t - (t >> 7);
  phong->row = 0;
}

/* X of a plane: r.v is -(W'.D) / (|W'| |D|) with W' = (n.D)(P - L'), L' the light's mirror image in the plane: W - 2 g n / |n|. */
static FC_COLD void planar_start(fc_coat *coat, const void *data) {
  const fc_planar *planar = coat->planar;
  const fc_cosine *g = coat->cosine;
  fc_sheaf d, mirrored;
  uint8_t i;
  if (!coat->lit) return;
  start(coat, data);
  fc_coat_directions(coat->scan, &d);
  for (i = 0; i < 3; i++) {
    /* |W'| = |W|: components below 2^30 */
    mirrored.at[i] = (int32_t)fc_floor_shift64(fc_smul32(g->at, planar->unit[i]) + (INT64_C(1) << 28), 29) - planar->w.at[i];
    mirrored.dx[i] = (int32_t)fc_floor_shift64(fc_smul32(g->dx, planar->unit[i]) + (INT64_C(1) << 28), 29) - planar->w.dx[i];
    mirrored.dy[i] = (int32_t)fc_floor_shift64(fc_smul32(g->dy, planar->unit[i]) + (INT64_C(1) << 28), 29) - planar->w.dy[i];
  }
  fc_square_set(&coat->phong.x, &mirrored, &d);
  fc_square_set(&coat->phong.d, &d, &d);
}

/*
 * Pixels of a run. c^2 = X^2 / (Y |D|^2) with X in 2^29, Y = W.W in 2^30 and
 * |D|^2 in 2^28. Where even 16-bit products say that c^n is below 2^-12, the pixel keeps its colour.
 */
static FC_HOT void planar_pixels(const fc_coat_phong *phong, const fc_tint *tint, fc_steps x, fc_steps y, fc_steps d, int32_t g, int32_t dg,
                                 uint32_t bits, uint8_t *to, uint8_t pixel_bytes) {
  const uint32_t least = phong->least;
  for (; bits != 0; bits >>= 1, to += pixel_bytes) {
    if ((bits & 1) && !(x.at >> 31)) {
      const uint32_t high = (x.at >> 16) + 1;                           /* up to 2^15 */
      if (high * high >= ((y.at >> 16) * (d.at >> 16) >> 16) * least) { /* 14 + 16 bits; 14 + 16 */
        const int32_t loss = log_of(y.at) + log_of(d.at) - 2 * log_of(x.at | 1);
        fc_coat_put(tint, phong->slope, fc_cosine_of(y.at, g), highlight(phong, loss), to);
      }
    }
    fc_steps_next(&x);
    fc_steps_next(&y);
    fc_steps_next(&d);
    g += dg;
  }
}

/* Whether no pixel of the next `count` may shine: by X's greatest and the others' least. X lies below its chord, or by count^2 / 8 of its
 * second difference above. */
static FC_NOINLINE bool is_dull(const fc_coat_phong *phong, const fc_steps *x, uint32_t least_y, const fc_steps *d, uint8_t count) {
  const int32_t bend = fc_to_i32(x->dxx), last = fc_to_i32(x->at + x->dx * count + x->dxx * ((uint32_t)count * (count - 1u) / 2));
  int64_t most = last > fc_to_i32(x->at) ? last : fc_to_i32(x->at);
  fc_cosine_row row;
  uint32_t high;
  if (bend < 0) most += (int64_t)(fc_mul32(fc_abs32(bend), (uint32_t)count * count) >> 3);
  if (most < 0) return true;
  if (most >> 31 != 0) return false;
  row.q = d->at >> 1; /* as a positive number */
  row.dq = (uint32_t)fc_floor_shift32(fc_to_i32(d->dx), 1);
  row.ddq = d->dxx >> 1;
  high = ((uint32_t)most >> 16) + 1;
  return high * high < ((least_y >> 16) * (fc_cosine_least(&row, count) >> 15) >> 16) * phong->least;
}

static FC_NOINLINE void planar_run(fc_coat *coat, const void *data) {
  fc_coat_phong *phong = &coat->phong;
  const fc_scan *scan = coat->scan;
  const fc_coat_run *run = &coat->run;
  uint32_t bits = run->bits;
  uint16_t at = run->column;
  uint8_t length = 32;
  (void)data;
  for (; phong->row < run->row; phong->row++) {
    fc_square_next_row(&phong->x);
    fc_square_next_row(&phong->d);
  }
  while (bits != 0) {
    fc_steps x, y, d;
    fc_cosine_row row;
    uint32_t least;
    for (; !(bits & 1); bits >>= 1) at++;
    fc_steps_start(&phong->x, at, 29, &x);
    fc_steps_start(run->square, at, 30, &y);
    fc_steps_start(&phong->d, at, 28, &d);
    row.q = y.at;
    row.dq = y.dx;
    row.ddq = y.dxx;
    least = fc_cosine_least(&row, 32);
    /* Y is within 265 after 32 pixels, 18 after 8: c^n is off by n / 2 of that over Y: 2^-11 and less */
    length = least >= phong->shininess_q8 << 10 ? 32 : 8;
    if (least < phong->shininess_q8 << 6 || least < UINT32_C(1) << 22) {
      fc_scan_shade_slowly(scan, run->row, at, bits);
      return;
    }
    if (length == 32 && is_dull(phong, &x, least, &d, (uint8_t)(32 - fc_clz32(bits)))) return;
    planar_pixels(phong, &scan->tint, x, y, d, coat->cosine->at + at * coat->cosine->dx + run->row * coat->cosine->dy, coat->cosine->dx,
                  length == 32 ? bits : bits & 255, fc_scan_pixel(scan, run->row, at), scan->pixel_bytes);
    if (length == 32) return;
    bits >>= 8;
    at = (uint16_t)(at + 8);
  }
}

/* t0 and t1 of `bright`, from the least |D| of the tile. */
static FC_COLD void set_test(fc_coat *coat, const fc_sheaf *d) {
  fc_coat_phong *phong = &coat->phong;
  const fc_ball_light *light = coat->light;
  uint64_t square = (uint64_t)fc_smul32(d->at[2], d->at[2]);
  const uint64_t whole = (UINT64_C(1) << 24) - (uint32_t)light->h;
  fc_quick scale, y;
  int32_t end;
  uint8_t i;
  for (i = 0; i < 2; i++) {
    const int32_t first = d->at[i], last = first + (i == 0 ? d->dx[0] * (coat->scan->columns - 1) : d->dy[1] * (coat->scan->rows - 1));
    int32_t near = fc_abs32(first) < fc_abs32(last) ? first : last;
    if ((first < 0) != (last < 0)) near = 0;
    square += (uint64_t)fc_smul32(near, near);
  }
  scale = fc_quick_mul(fc_quick_from(phong->least, -16), fc_quick_from(square, 0));
  if (scale.m != 0) scale = fc_quick_mul(scale, fc_quick_rsqrt(scale)); /* X below 2^30, in 2^16: */
  y = fc_quick_from((uint64_t)((INT32_C(1) << 25) - light->sum), -24);
  y = fc_quick_mul(y, fc_quick_rsqrt(y));
  phong->t0 = fc_quick_to_int(fc_quick_mul(scale, y), -16);
  end = fc_quick_to_int(fc_quick_mul(scale, fc_quick_from(whole, -24)), -16);
  end = phong->t0 - end + 1; /* at most 2^15; the quotient's below that: 1 / sqrt(1 - h^2) - ... < 1 */
  phong->t1 = (uint32_t)fc_quick_times(fc_quick_recip(fc_quick_from(whole, -24)), end, 0) + 1;
  /* what 16 bits of p and X's own are off by, in 2^-14 of X's greatest */
  phong->t0 -= (int32_t)((uint32_t)(light->margin == INT32_MAX ? light->fine_margin : light->margin) >> 9) + 6;
}

/*
 * A sphere. With the light at l of the center, h = r / l and s as in ball.h, n.v = w / |D| with w the root of the discriminant over r, so
 *   (l' / l) |D| c = (2 s - h) w + D.(L - C) / l = X,  Y = (l' / l)^2 = 1 + h^2 - 2 s h,
 * l' the light's distance from the point: c^2 = X^2 / (Y |D|^2).
 */
static FC_COLD void sphere_start(fc_coat *coat, const void *data) {
  fc_coat_phong *phong = &coat->phong;
  const fc_scan *scan = coat->scan;
  const fc_ball_light *light = coat->light;
  const int64_t *c = scan->form->u.sphere.center;
  int64_t d[3], l[3], step;
  fc_sheaf sheaf;
  fc_quick inverse, root;
  uint32_t s_error;
  uint8_t i;
  start(coat, data);
  fc_scan_direction(scan, d, &step);
  for (i = 0; i < 3; i++) l[i] = scan->frame->lights[i] - c[i]; /* below 2^31; D below 2^30 */
  inverse = fc_quick_rsqrt(fc_quick_from((uint64_t)(l[0] * l[0]) + (uint64_t)(l[1] * l[1]) + (uint64_t)(l[2] * l[2]), 0)) /* 3 * 2^62 */;
  phong->along = fc_quick_times(inverse, fc_dot(d, l), 0);
  phong->along_dx = fc_quick_times(inverse, l[0] * step, 0);
  phong->along_dy = fc_quick_times(inverse, -l[1] * step, 0);
  fc_coat_directions(scan, &sheaf);
  fc_square_set(&phong->d, &sheaf, &sheaf);
  /* near / z = p / 2^(30 + drop), and p less b is the discriminant's root times factor 2^exponent */
  root = fc_quick_recip(fc_quick_from(coat->placed->factor, (int32_t)coat->placed->exponent + 30 + coat->drop));
  root = fc_quick_mul(root, fc_quick_recip(fc_quick_from((uint64_t)scan->form->u.sphere.radius, 0)));
  phong->root = root.m;
  phong->root_up = (int8_t)(root.e < -92 ? -60 : root.e > 60 ? 92
                                                             : root.e + 32);
  /* s is within 2^-21 (|s0| + 1) where p is within 2^-22 of itself, and X within twice that: c^n within 2 n of it, which may be 2^-10. And p's error
   * times `root`, over |D| of 2^28 at least. */
  s_error = (uint32_t)((fc_abs32(light->away - light->h) + (UINT32_C(1) << 24)) >> 21) + 4;
  root = fc_quick_mul(root, fc_quick_from((uint64_t)coat->error + 2, -17));
  root = fc_quick_mul(root, fc_quick_from(phong->shininess_q8, -8));
  phong->rough = s_error >= (UINT32_C(1) << 21) / phong->shininess_q8 || !fc_quick_less(root, fc_quick_from(1, 0)) || phong->root_up > 8 ||
                 phong->root_up < -16;
  phong->root_down = (uint8_t)(phong->rough ? 15 : 15 - phong->root_up);
  phong->octave = (uint8_t)(22 + fc_bits64(coat->error));
  phong->h = (uint32_t)light->h;
  set_test(coat, &sheaf);
}

/*
 * Those of a run's pixels where c^n may be worth 2^-12, by 16 bits: X against the root of `least` Y |D|^2 / 2. Y = 1 - h^2 - 2 h e; over e = s - h in
 * 0 .. 1 - h its root is concave, so it lies above the chord t0 - t1 e.
 */
static FC_HOT uint32_t bright(const fc_coat_phong *phong, const uint32_t *p, const uint32_t *e, uint8_t count, uint32_t b, uint32_t b_step,
                              int32_t along, int32_t along_dx) {
  const uint32_t root = phong->root >> 16, h = phong->h, t1 = phong->t1;
  const int32_t t0 = phong->t0;
  const uint8_t down = phong->root_down;
  const uint32_t *end = p + count;
  uint32_t bits = 0, bit = 1;
  do {
    /* n.D below 2^30, 2 s - h in Q14 up to 2^15: 15 + 15 bits; what is not lit may wrap, and is not asked for */
    const uint32_t w = ((*p - b) >> 16) * root >> down, s = *e;
    const int32_t x = (int32_t)(((2 * s + h) >> 10) * w >> 15) + fc_floor_shift32(along, 16);
    if (x + (int32_t)((s >> 10) * t1 >> 14) >= t0) bits |= bit;
    bit <<= 1;
    b += b_step;
    along += along_dx;
    e++;
  } while (++p != end);
  return bits;
}

/* A pixel that may: s refined; false when p tells too little. */
static FC_NOINLINE bool shine(const fc_coat *coat, uint32_t p, uint32_t root, int32_t facing, int32_t along, uint32_t square, uint8_t *to) {
  const fc_coat_phong *phong = &coat->phong;
  const fc_ball_light *light = coat->light;
  const uint32_t whole = (UINT32_C(1) << 24) - (uint32_t)light->h;
  const uint8_t octave = (uint8_t)(31 - fc_clz32(p));
  uint32_t w, y, shown = 0;
  int32_t e, x;
  if (octave < phong->octave) return false;
  e = fc_ball_refined(light, facing, p, octave);
  if (e <= 0) return false;
  if ((uint32_t)e > whole) e = (int32_t)whole;
  w = fc_mulhi32(root, phong->root);
  w = phong->root_up >= 0 ? w << phong->root_up : w >> -phong->root_up;
  /* Q24 of up to 2^25 and 2^30: X below 2^31 */
  x = fc_smulhi32((2 * e + light->h) * 32, w) * 8 + along;
  /* Q29: Q31 of s and of h give twice their product */
  y = ((uint32_t)light->sum << 5) - fc_mulhi32(((uint32_t)e + (uint32_t)light->h) << 7, (uint32_t)light->h << 7);
  if (x > 0) shown = highlight(phong, log_of(y) + log_of(square) - 2 * log_of((uint32_t)x) - (INT32_C(1) << 20));
  if (shown != 0) fc_coat_put(&coat->scan->tint, phong->slope, fc_ball_cosine(light, (uint32_t)e), shown, to);
  return true;
}

static FC_NOINLINE void sphere_run(fc_coat *coat, const void *data) {
  fc_coat_phong *phong = &coat->phong;
  const fc_coat_run *run = &coat->run;
  const int32_t along = phong->along + phong->along_dx * run->column + phong->along_dy * run->row;
  const int32_t facing = coat->light->at + coat->light->dx * run->column + coat->light->dy * run->row;
  uint32_t bits;
  uint8_t i, square_at = 0;
  fc_steps d;
  (void)data;
  if (phong->rough) {
    fc_scan_shade_slowly(coat->scan, run->row, run->column, run->bits);
    return;
  }
  bits = run->bits & bright(phong, run->p, run->e, (uint8_t)(32 - fc_clz32(run->bits)), run->b, run->b_step, along, phong->along_dx);
  if (bits == 0) return;
  for (; phong->row < run->row; phong->row++) fc_square_next_row(&phong->d);
  fc_steps_start(&phong->d, run->column, 28, &d);
  for (i = 0; bits != 0; bits >>= 1, i++) {
    const uint16_t column = (uint16_t)(run->column + i);
    const uint32_t b = run->b + run->b_step * i;
    if (!(bits & 1)) continue;
    for (; square_at < i; square_at++) fc_steps_next(&d);
    if (!shine(coat, run->p[i], run->p[i] > b ? run->p[i] - b : 0, facing + coat->light->dx * i, along + phong->along_dx * i, d.at,
               fc_scan_pixel(coat->scan, run->row, column)))
      fc_scan_shade_slowly(coat->scan, run->row, column, 1);
  }
}

const fc_coat_layer fc_coat_layer_phong FC_ROM = {&fc_coat_layers, FC_COAT_ADDS, fits, planar_start, NULL,
                                                  planar_run, sphere_start, sphere_run, NULL};
