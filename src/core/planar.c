/* Lights and shadows on planar receivers. */
#include "planar.h"

#include "bits.h"
#include "search.h"
#include "tally.h"

static fc_i128 scaled(fc_i128 a, int64_t b) { return fc_i128_scale(a, b); }

/* k D - (n.D) L an axis: k below 2^95, D 2^30; n.D 2^95, L 2^30: below 2^127. */
static fc_i128 along(fc_i128 k, int64_t d, fc_i128 nd, int64_t light) {
  return fc_i128_sub(scaled(k, d), scaled(nd, light));
}

static int32_t cut(fc_i128 v, uint8_t shift) { return (int32_t)fc_i128_to_i64(fc_i128_floor_shift(v, shift)); }

static uint64_t magnitude(fc_i128 v, uint8_t shift) {
  return fc_abs64(fc_i128_to_i64(fc_i128_floor_shift(v, shift))) + 1;
}

/* The cosine's numerator (k - n.L) (n.D) / |n| in the unit of W: affine too. */
typedef struct cosine {
  int32_t at, dx, dy;
} cosine;

/* |v| to 2^-30. */
static fc_quick quick_of(fc_i128 v) {
  fc_i128 a = fc_i128_abs(v);
  uint8_t bits = fc_i128_bits(a);
  return bits <= 64 ? fc_quick_from(a.lo, 0) : fc_quick_from(fc_i128_floor_shift(a, (uint8_t)(bits - 64)).lo, (int16_t)(bits - 64));
}

static int32_t value_of(fc_quick factor, fc_i128 nd) {
  int32_t v = fc_quick_to_int(fc_quick_mul(factor, quick_of(nd)), 0);
  return fc_i128_sign(nd) < 0 ? -v : v;
}

/* 1 / |n|, and n / |n| in Q30. */
static fc_quick normalise(fc_planar *planar) {
  const int64_t *n = planar->normal;
  /* cut to 30 bits: 2^-29, and a sum of squares below 2^62 */
  uint8_t bits = fc_vector_bits(n), shift = bits > 30 ? (uint8_t)(bits - 30) : 0, i;
  int64_t small[3];
  fc_quick inverse;
  for (i = 0; i < 3; i++) {
    small[i] = fc_floor_shift64(n[i], shift);
    planar->small[i] = (int32_t)small[i];
  }
  planar->small_k = fc_i128_to_i64(fc_i128_floor_shift(planar->k, shift));
  inverse = fc_quick_rsqrt(fc_quick_from((uint64_t)fc_small_dot(small, small), 0));
  for (i = 0; i < 3; i++) planar->unit[i] = fc_quick_times(inverse, small[i], 30);
  return fc_quick_scale(inverse, (int16_t)-shift);
}

/* W and the cosine's numerator over the tile. */
static void set_forms(const fc_scan *scan, fc_planar *planar, cosine *g) {
  const int64_t *light = scan->frame->lights;
  int64_t d[3], step;
  fc_i128 nd, ndx, ndy, at[3], dx[3], dy[3];
  fc_quick factor;
  uint64_t most = 0;
  uint8_t i, bits = 0, shift;
  fc_scan_direction(scan, d, &step);
  nd = fc_i128_dot(planar->normal, d);
  ndx = fc_i128_mul(planar->normal[0], step);
  ndy = fc_i128_mul(planar->normal[1], -step);
  for (i = 0; i < 3; i++) {
    uint8_t b;
    at[i] = along(planar->k, d[i], nd, light[i]);
    dx[i] = along(planar->k, i == 0 ? step : 0, ndx, light[i]);
    dy[i] = along(planar->k, i == 1 ? -step : 0, ndy, light[i]);
    b = fc_i128_bits(at[i]);
    if (b > bits) bits = b;
  }
  /* |W| anywhere in the tile, in units of 2^shift, is below 2^30: measured in units 2^14 times as coarse */
  shift = bits > 40 ? (uint8_t)(bits - 40) : 0;
  for (i = 0; i < 3; i++) {
    uint64_t sum = magnitude(at[i], shift) + magnitude(dx[i], shift) * scan->columns + magnitude(dy[i], shift) * scan->rows;
    if (sum > most) most = sum;
  }
  i = fc_bits64(most);
  shift = (uint8_t)(shift + i > 30 ? shift + i - 30 : 0);
  for (i = 0; i < 3; i++) {
    planar->w.at[i] = cut(at[i], shift);
    planar->w.dx[i] = cut(dx[i], shift);
    planar->w.dy[i] = cut(dy[i], shift);
  }
  planar->w.error = (uint32_t)scan->columns + scan->rows + 1;
  factor = fc_quick_scale(fc_quick_mul(quick_of(planar->height), normalise(planar)), (int16_t)-shift);
  g->at = value_of(factor, nd);
  g->dx = value_of(factor, ndx);
  g->dy = value_of(factor, ndy);
}

uint8_t fc_ball_to_plane(const int64_t n[3], int64_t a, int64_t radius) {
  /* (k - n.C)^2 against r^2 n.n: below 2^124 and 2^122 */
  fc_i128 have = fc_i128_mul(a, a), touch = fc_i128_mul(radius * radius, fc_small_dot(n, n));
  if (fc_i128_compare(have, touch) >= 0) return FC_BALL_CLEAR;
  /* a >= r |n| (1 - 2^-12) if a^2 >= r^2 n^2 (1 - 2^-12) */
  touch = fc_i128_sub(touch, fc_i128_floor_shift(touch, 12));
  return fc_i128_compare(have, touch) >= 0 ? FC_BALL_DIPS : FC_BALL_CUTS;
}

bool fc_planar_faces_ball(const fc_scan *scan, const fc_planar *receiver, const int64_t center[3], int64_t radius,
                          fc_window *doubt) {
  fc_i128 above = fc_i128_sub(receiver->k, fc_i128_dot(receiver->normal, center));
  fc_num length, r = fc_num_from_u64((uint64_t)radius, 0), rise, dip, reach, foot;
  int64_t t[3], to_light[3];
  uint8_t i;
  bool front = fc_i128_sign(above) > 0;
  doubt->x0 = doubt->y0 = 1;
  doubt->x1 = doubt->y1 = 0;
  if (fc_vector_bits(receiver->normal) <= 30 && fc_i128_bits(above) <= 62) {
    /* (k - n.C)^2 against r^2 n.n, exact: 124 bits against 60 + 62 */
    const int64_t *n = receiver->normal;
    int64_t a = fc_i128_to_i64(above);
    uint8_t how = fc_ball_to_plane(n, a, radius);
    if (how == FC_BALL_CLEAR) return front;
    if (how == FC_BALL_DIPS && front) {
      /* |L - T| / h below 2^q; the reach is then below r / 16 + 2^(q + 1) 2^-12 r */
      int16_t q;
      for (i = 0; i < 3; i++) {
        t[i] = center[i] + fc_floor_shift64((int64_t)receiver->unit[i] * radius, 30);
        to_light[i] = t[i] - scan->frame->lights[i];
      }
      q = (int16_t)(fc_vector_bits(to_light) + 1 + fc_vector_bits(n) + 1 - fc_i128_bits(receiver->height) + 1);
      if (q <= 7) {
        (void)fc_ball_window(scan->frame, t, (radius >> 4) + (radius >> (11 - (q < 0 ? 0 : q))) + 4, doubt);
        return true;
      }
    }
  }
  length = fc_length(receiver->normal);
  rise = fc_num_div(fc_num_from_abs(above), length); /* of the center over the plane, or below it */
  if (front) {
    dip = fc_num_compare(r, rise) > 0 ? fc_num_sub(r, rise) : fc_num_from_u64(0, 0);
    /* clear of the plane by more than the values' errors */
    if (dip.m == 0 && fc_num_compare(fc_num_sub(rise, r), fc_num_scale(r, -40)) > 0) return true;
  } else {
    if (fc_num_compare(rise, r) > 0 && fc_num_compare(fc_num_sub(rise, r), fc_num_scale(r, -40)) > 0) return false;
    dip = fc_num_add(r, rise);
  }
  dip = fc_num_add(dip, fc_num_scale(r, -40));
  /* T = C + n (k - n.C) / n.n, rounded */
  foot = fc_num_div(rise, length);
  for (i = 0; i < 3; i++) {
    int64_t move = (int64_t)fc_num_round(fc_num_mul(foot, fc_num_from_u64(fc_abs64(receiver->normal[i]), 0)), 0);
    t[i] = center[i] + ((receiver->normal[i] < 0) == front ? -move : move);
    to_light[i] = t[i] - scan->frame->lights[i];
  }
  reach = fc_num_scale(fc_num_sqrt(fc_num_mul(fc_num_scale(r, 1), dip)), 1);
  foot = fc_num_div(fc_num_mul(fc_num_mul(dip, fc_length(to_light)), length), fc_num_from_abs(receiver->height));
  reach = fc_num_add(reach, fc_num_scale(foot, 1));
  if (fc_num_compare(reach, fc_num_from_u64(1, 31)) >= 0 || fc_vector_bits(t) > 31)
    reach = fc_num_from_u64(1, 32); /* everywhere */
  (void)fc_ball_window(scan->frame, t, (int64_t)fc_num_round(reach, 0) + 4, doubt);
  return true;
}

void fc_planar_ask(fc_scan *scan, const fc_kind *kind, const fc_form *occluder) {
  uint16_t row, column;
  for (row = 0; row < scan->rows; row++)
    for (column = 0; column < scan->columns; column++) {
      uint32_t *bits = &scan->mask[row * scan->words + column / 32], bit = UINT32_C(1) << (column % 32);
      if ((*bits & bit) && fc_scan_blocked(scan, row, column, kind, occluder)) fc_planar_darken(scan, row, column, bit);
    }
}

typedef struct caster {
  fc_scan *scan;
  const fc_planar *planar;
} caster;

static bool cast_one(void *context, const fc_cursor *at, uint16_t index) {
  const caster *c = context;
  fc_form form;
  if ((uint16_t)(at->group.first + index) == c->scan->primitive) return false;
  fc_kind_of(at)->fetch(&at->group, index, &form);
  fc_kind_of(at)->shadow(c->scan, c->planar, fc_kind_of(at), &form);
  return false;
}

/* Candidates for occluders, each asked to darken what it can. */
static void cast_shadows(fc_scan *scan, const fc_planar *planar, const int64_t *hull, uint8_t corners) {
  fc_space space = fc_space_of_frame(scan->frame);
  caster c;
  fc_reach reach;
  c.scan = scan;
  c.planar = planar;
  reach.from = scan->frame->lights;
  reach.to = hull;
  reach.corners = corners;
  reach.radius = 0;
  reach.limited = false;
  (void)fc_space_search(&space, corners > 0 ? &reach : NULL, cast_one, &c);
}

/* What cosines need of a row: W.W / 2^30 and its differences, and the numerator. */
typedef struct cosine_row {
  uint32_t q, dq, ddq;
  int32_t g;
} cosine_row;

static void start_row(const fc_planar *planar, const cosine *g, uint16_t row, uint16_t column, cosine_row *r) {
  /* components below 2^30: sums of three products below 2^62, q below 2^32; over 128 columns the rounded differences add up
   * to an error below 2^14 */
  int64_t square = 0, cross = 0, step = 0;
  uint8_t i;
  for (i = 0; i < 3; i++) {
    int32_t w = planar->w.at[i] + column * planar->w.dx[i] + row * planar->w.dy[i], dw = planar->w.dx[i];
    square += fc_smul32(w, w);
    if (dw == 0) continue;
    cross += fc_smul32(w, dw);
    step += fc_smul32(dw, dw);
  }
  r->q = (uint32_t)((uint64_t)square >> 30);
  r->dq = (uint32_t)(uint64_t)fc_floor_shift64(2 * cross + step, 30);
  r->ddq = (uint32_t)(uint64_t)fc_floor_shift64(2 * step, 30);
  r->g = g->at + column * g->dx + row * g->dy;
}

/* The next `count` cosines. */
static void cosines(cosine_row *r, int32_t dg, uint8_t count, uint32_t *to) {
  uint32_t q = r->q, dq = r->dq, *end = to + count, low = UINT32_C(1) << 30;
  const uint32_t ddq = r->ddq;
  int32_t g = r->g;
  uint8_t a = 0; /* q 2^(2a) in 2^30 .. 2^32-1 */
  for (; to != end; to++) {
    uint32_t c = 0;
    while (q < low && a < 14) {
      low >>= 2;
      a++;
    }
    while (q >> 2 >= low) {
      low <<= 2;
      a--;
    }
    if (q >= low && g > 0) c = (((uint32_t)g >> (14 - a)) * fc_rsqrt_q15(q << (2 * a))) >> 16;
    *to = c > 65536 ? 65536 : c;
    q += dq;
    dq += ddq;
    g += dg;
  }
  r->q = q;
  r->dq = dq;
  r->g = g;
}

static void shade(fc_scan *scan, const fc_planar *planar, const cosine *g) {
  uint16_t row;
  uint8_t word;
  for (row = 0; row < scan->rows; row++) {
    cosine_row forms = {0, 0, 0, 0};
    uint16_t next = UINT16_MAX, column = 0; /* the column that the forms stand at */
    for (word = 0; word < scan->words; word++, column = (uint16_t)(column + 32)) {
      uint32_t bits = scan->mask[row * scan->words + word], c[32];
      uint16_t at = column;
      uint8_t count = 32;
      if (bits == 0) continue;
      while (!(bits & 1)) {
        bits >>= 1;
        at++;
        count--;
      }
      if (bits >> (count - 1) == 0) { /* what lies behind the last is not needed */
        count = 0;
        while (bits >> count != 0) count++;
      }
      if (at != next || word % 4 == 0) start_row(planar, g, row, at, &forms);
      cosines(&forms, g->dx, count, c);
      next = (uint16_t)(at + count);
      fc_scan_shade(scan, row, at, bits, c);
    }
  }
}

void fc_planar_light(fc_scan *scan, const int64_t normal[3], fc_i128 k, const int64_t *hull, uint8_t corners) {
  fc_planar planar;
  cosine g;
  uint16_t row;
  uint8_t word, i;
  bool any = false, away = fc_i128_sign(k) < 0, faces;
  for (i = 0; i < 3; i++) planar.normal[i] = away ? -normal[i] : normal[i];
  planar.k = away ? fc_i128_neg(k) : k;
  planar.height = fc_i128_sub(planar.k, fc_i128_dot(planar.normal, scan->frame->lights));
  faces = fc_i128_sign(planar.height) > 0;
  for (row = 0; row < scan->rows; row++) {
    for (word = 0; word < scan->words; word++) {
      uint32_t *bits = &scan->mask[row * scan->words + word];
      if (*bits == 0) continue;
      if (!fc_scan_wants_light(scan, row, (uint16_t)(32 * word), *bits))
        *bits = 0;
      else if (!faces)
        fc_scan_unlit(scan, row, (uint16_t)(32 * word), *bits);
      else
        any = true;
    }
  }
  if (!any || !faces) return;
  set_forms(scan, &planar, &g);
  cast_shadows(scan, &planar, hull, corners);
  shade(scan, &planar, &g);
}
