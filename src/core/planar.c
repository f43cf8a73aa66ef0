/* Lights and shadows on planar receivers. */
#include "planar.h"

#include "bits.h"
#include "coat.h"
#include "search.h"
#include "tally.h"

/* 1 / |n|, and n / |n| in Q30. */
static fc_quick normalise(const int64_t n[3], int32_t unit[3]) {
  /* below 2^30: a sum of squares below 2^62 */
  fc_quick inverse = fc_quick_rsqrt(fc_quick_from((uint64_t)fc_dot(n, n), 0));
  uint8_t i;
  for (i = 0; i < 3; i++) unit[i] = fc_quick_times(inverse, n[i], 30);
  return inverse;
}

/* round(v / 2^shift) */
static int32_t nearest(int64_t v, uint8_t shift) {
  return (int32_t)fc_floor_shift64(v + (INT64_C(1) << (shift - 1)), shift);
}

/* The largest component, in steps from a tile's first pixel to its farthest. */
static uint64_t reach_of(int64_t at, int64_t dx, int64_t dy, const fc_scan *scan) {
  /* |at| below 2^61; W is below that at the last column too, so the steps to it are below 2^62 */
  return fc_abs64(at) + fc_abs64(dx) * scan->columns + fc_abs64(dy) * scan->rows;
}

/* W and the cosine's numerator over the tile; false when W is so small that its cuts would tell. */
static FC_COLD bool set_forms(const fc_scan *scan, fc_planar *planar, fc_cosine *g) {
  const int64_t *n = planar->normal, *light = scan->frame->lights;
  /* the direction, its steps, and their products with n, for W's three forms */
  int64_t d[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, step, nd[3], form[3][3];
  fc_quick factor;
  uint64_t most = 0;
  uint8_t i, j, shift;
  fc_scan_direction(scan, d[0], &step);
  d[1][0] = step;
  d[2][1] = -step;
  for (j = 0; j < 3; j++) nd[j] = fc_dot(n, d[j]); /* 30 + 29 bits, three terms */
  for (i = 0; i < 3; i++) {
    uint64_t reach;
    /* k D - (n.D) L in units of 2^32: 62 + 30 bits each, so below 2^61; each within 2 */
    for (j = 0; j < 3; j++) form[j][i] = fc_smul64hi(planar->k, (int32_t)d[j][i]) - fc_smul64hi(nd[j], (int32_t)light[i]);
    reach = reach_of(form[0][i], form[1][i], form[2][i], scan);
    if (reach > most) most = reach;
  }
  i = fc_bits64(most);
  /* units of 2^32, so that n cut to 30 bits moves W by up to 2^29: 2^-10 of 2^42 where W is least */
  if (i < (planar->slack != 0 ? 46 : 34)) return false;
  shift = (uint8_t)(i - 29); /* a bit is left for the roundings */
  for (i = 0; i < 3; i++) {
    planar->w.at[i] = nearest(form[0][i], shift);
    planar->w.dx[i] = nearest(form[1][i], shift);
    planar->w.dy[i] = nearest(form[2][i], shift);
  }
  /* each form is within 1/2 + 2^-5 of its rounding, and a cut normal moves W by less than 3 (2^30 2^29 + 2^29 2^30) */
  planar->w.error = ((uint32_t)scan->columns + scan->rows) / 2 + 3;
  planar->w.error += planar->w.error / 16 + 1;
  if (planar->slack != 0) planar->w.error += (UINT32_C(6) << 28 >> shift) + 1;
  factor = fc_quick_mul(fc_quick_from(fc_abs64(planar->height), (int16_t)(-32 - shift)), normalise(n, planar->unit));
  g->at = fc_quick_times(factor, nd[0], 0);
  g->dx = fc_quick_times(factor, nd[1], 0);
  g->dy = fc_quick_times(factor, nd[2], 0);
  return true;
}

FC_COLD int64_t fc_ball_foot(const int64_t n[3], const int32_t unit[3], int64_t above, const int64_t center[3], int64_t radius,
                             int64_t foot[3]) {
  /* |n| below 2^31 and at least 1, so 1 / |n| times |above| is within 2^-25 and 1: 2^-24 r + 2 where it is about r */
  int64_t square = fc_dot(n, n), margin = fc_ball_margin(radius), dip;
  int64_t rise = fc_quick_times(fc_quick_rsqrt(fc_quick_from((uint64_t)square, 0)), above, 0); /* INT32_MAX: farther */
  uint8_t i;
  for (i = 0; i < 3; i++) foot[i] = center[i] + fc_floor_shift64(unit[i] * rise, 30); /* 31 + 31 bits */
  dip = radius - (int64_t)fc_abs64(rise) + margin;
  if (dip > 0 && dip <= 2 * margin) {
    /* balls rest on planes: above^2 against r^2 n.n, below 2^124 and 2^122 */
    fc_i128 have = fc_i128_mul(above, above), touch = fc_i128_mul(radius * radius, square);
    if (have.hi != touch.hi ? have.hi > touch.hi : have.lo >= touch.lo) return 0;
  }
  return dip;
}

FC_COLD bool fc_planar_faces_ball(const fc_scan *scan, const fc_planar *receiver, const int64_t center[3], int64_t radius,
                                  fc_window *doubt) {
  const int64_t *n = receiver->normal;
  int64_t above = receiver->k - fc_dot(n, center), t[3], to_light[3], margin = fc_ball_margin(radius), dip, reach;
  fc_quick lever;
  uint8_t i;
  doubt->x0 = doubt->y0 = 1;
  doubt->x1 = doubt->y1 = 0;
  dip = fc_ball_foot(n, receiver->unit, above, center, radius, t);
  if (receiver->slack != 0) {
    /* |n| is at least 2^29 then: the exact plane lies within 16 */
    dip += 17;
    margin += 17;
  }
  if (dip <= 0) return above > 0; /* clear of the plane */
  if (above <= 0) dip = 2 * (radius + margin) - dip;
  for (i = 0; i < 3; i++) to_light[i] = t[i] - scan->frame->lights[i]; /* below 2^33 */
  if (receiver->height > 2 * receiver->slack && fc_vector_bits(t) <= 30) {
    /* 2 dip |L - T| / (h / |n|), twice that for the height's own slack; the sum of three axes is more than the length */
    lever = fc_quick_mul(fc_quick_from((uint64_t)dip, receiver->slack != 0 ? 2 : 1),
                         fc_quick_from((uint64_t)fc_small_norm1(to_light), 0));
    lever = fc_quick_mul(lever, fc_quick_recip(fc_quick_from((uint64_t)receiver->height, 0)));
    lever = fc_quick_mul(lever, fc_quick_from((uint64_t)fc_small_norm1(n), 0));
    if (lever.e <= 0) {
      /* 31 + 32 bits; lever below 2^32 and within 2^-24; T within 2 margin + 1 an axis */
      reach = 2 * ((int64_t)fc_sqrt64(2 * (uint64_t)(radius * dip)) + 1) + (int64_t)fc_quick_to_u64(lever);
      (void)fc_ball_window(scan->frame, t, reach + (reach >> 24) + 4 * margin + 4, doubt);
      return true;
    }
  }
  doubt->x0 = doubt->y0 = 0; /* everywhere */
  doubt->x1 = scan->frame->width - 1;
  doubt->y1 = scan->frame->height - 1;
  return true;
}

/* Where the ray through a pixel of the tile meets the plane, or the one of its cut normal; false when it does not, or too far
 * away. */
static FC_COLD bool foot(const fc_scan *scan, const fc_planar *planar, uint16_t row, uint16_t column, int64_t point[3]) {
  static const int64_t eye[3] = {0, 0, 0};
  int64_t d[3], nd;
  fc_num t;
  fc_view_direction(scan->frame, (uint16_t)(scan->x + column), (uint16_t)(scan->y + row), d);
  nd = fc_dot(planar->normal, d);
  if (planar->slack != 0 && nd >> 50 == 0) return false;
  if (nd <= 0) return false;
  fc_num_set(&t, (uint64_t)planar->k, 0);
  fc_num_over_u64(&t, (uint64_t)nd);
  return fc_point_at(t, eye, d, point);
}

FC_COLD bool fc_planar_blocked(const fc_scan *scan, const fc_planar *receiver, uint16_t row, uint16_t column, const fc_kind *kind,
                               const fc_form *occluder) {
  int64_t wide[3];
  if (kind->hides != NULL && receiver->slack == 0 && foot(scan, receiver, row, column, wide) && fc_vector_bits(wide) <= 30) {
    int32_t point[3];
    int8_t hides;
    uint8_t i;
    for (i = 0; i < 3; i++) point[i] = (int32_t)wide[i];
    hides = kind->hides(occluder, scan->frame->lights, point, 1);
    if (hides >= 0) return hides > 0;
  }
  return fc_scan_blocked(scan, row, column, kind, occluder);
}

FC_COLD void fc_planar_ask(fc_scan *scan, const fc_kind *kind, const fc_form *occluder) {
  uint16_t row, column;
  for (row = scan->first_row; row <= scan->last_row; row++)
    for (column = 0; column < scan->columns; column++) {
      uint32_t *bits = &scan->mask[row * scan->words + column / 32], bit = UINT32_C(1) << (column % 32);
      if ((*bits & bit) && fc_scan_blocked(scan, row, column, kind, occluder)) fc_planar_darken(scan, row, column, bit);
    }
}

/* Rows whose ends are taken at a time where the rectangle will not do. */
#define HULL_ROWS 4

/* What a tile of a planar receiver is lit in. */
typedef struct planar_work {
  fc_planar planar;
  fc_cosine g;
  fc_form occluder;
  fc_reach reach;
  fc_space space;
  int64_t hull[6 * HULL_ROWS];
} planar_work;

typedef char planar_work_fits[sizeof(planar_work) <= FC_SCAN_WORK * sizeof(int64_t) ? 1 : -1];

static FC_COLD bool cast_one(void *context, const fc_cursor *at, uint16_t index) {
  fc_scan *scan = context;
  planar_work *work = (void *)scan->work;
  if ((uint16_t)(at->group.first + index) == scan->primitive) return false;
  if (fc_kind_of(at)->casts != NULL && !fc_kind_of(at)->casts(&at->group, index)) return false;
  fc_kind_of(at)->fetch(&at->group, index, &work->occluder);
  fc_kind_of(at)->shadow(scan, &work->planar, fc_kind_of(at), &work->occluder);
  return false;
}

/* First and last pixel of a row's mask; false when it is empty. */
static FC_COLD bool row_ends(const fc_scan *scan, uint16_t row, uint16_t ends[2]) {
  const uint32_t *mask = scan->mask + row * scan->words;
  uint16_t first = 0, last = (uint16_t)(32 * scan->words - 1);
  while (first < last && mask[first / 32] == 0) first = (uint16_t)(first + 32);
  if (first > last) return false;
  while (mask[last / 32] == 0) last = (uint16_t)(last - 32);
  while (!(mask[first / 32] >> (first % 32) & 1)) first++;
  while (!(mask[last / 32] >> (last % 32) & 1)) last--;
  ends[0] = first;
  ends[1] = last;
  return true;
}

/* Tiles of fewer pixels are taken as they are. */
#define SMALL_TILE 64

/* The rectangle that a tile's mask shows; false when it is empty. */
static FC_COLD bool find_rectangle(const fc_scan *scan, fc_planar *planar) {
  uint16_t row, ends[2];
  bool any = false;
  if (scan->columns * scan->rows < SMALL_TILE) {
    planar->left = 0;
    planar->right = (uint16_t)(scan->columns - 1);
    planar->top = scan->first_row;
    planar->bottom = scan->last_row;
    return true;
  }
  for (row = scan->first_row; row <= scan->last_row; row++) {
    if (!row_ends(scan, row, ends)) continue;
    if (!any) {
      planar->top = row;
      planar->left = ends[0];
      planar->right = ends[1];
      any = true;
    }
    planar->bottom = row;
    if (ends[0] < planar->left) planar->left = ends[0];
    if (ends[1] > planar->right) planar->right = ends[1];
  }
  return any;
}

/* The corners of a tile's rectangle on the plane; false where one lies beyond the horizon, or too far away. Lines of pixels are
 * lines on the plane, so hulls are hulls. */
static FC_COLD bool find_hull_corners(const fc_scan *scan, const fc_planar *planar, int64_t points[12]) {
  uint8_t i;
  for (i = 0; i < 4; i++)
    if (!foot(scan, planar, i & 1 ? planar->top : planar->bottom, i & 2 ? planar->left : planar->right, points + 3 * i)) return false;
  return true;
}

/* Corners around what some rows of the mask show: their ends. Their number; 0 where there are none, or where they are too far away: then
 * *far is set. */
static FC_COLD uint8_t find_ends(const fc_scan *scan, const fc_planar *planar, uint16_t row, int64_t points[6 * HULL_ROWS], bool *far) {
  uint16_t end = (uint16_t)(row + HULL_ROWS), ends[2];
  uint8_t count = 0, i;
  for (; row < end && row <= planar->bottom; row++) {
    if (!row_ends(scan, row, ends)) continue;
    for (i = 0; i < 2; i++, count++)
      if (!foot(scan, planar, row, ends[i], points + 3 * count)) {
        *far = true;
        return 0;
      }
  }
  return count;
}

/* Hands those who may stand between the light and the hull to cast_one. */
static FC_COLD void cast_from(fc_scan *scan, planar_work *work, const int64_t *hull, uint8_t corners, int64_t radius) {
  work->space = scan->space;
  work->space.entered = scan->frame->casters;
  work->reach.from = scan->frame->lights;
  work->reach.to = hull;
  work->reach.corners = corners;
  work->reach.radius = radius;
  work->reach.limited = false;
  (void)fc_space_search(&work->space, corners > 0 ? &work->reach : NULL, cast_one, scan);
}

/* From all that the tile shows: the rectangle, or rows, a few at a time. */
static FC_COLD void cast_from_tile(fc_scan *scan, planar_work *work) {
  const fc_planar *planar = &work->planar;
  uint16_t row;
  bool far = false;
  if (find_hull_corners(scan, planar, work->hull)) {
    cast_from(scan, work, work->hull, 4, 1); /* corners are rounded */
    return;
  }
  for (row = planar->top; row <= planar->bottom && !far; row = (uint16_t)(row + HULL_ROWS)) {
    const uint8_t corners = find_ends(scan, planar, row, work->hull, &far);
    if (corners > 0 || far) cast_from(scan, work, work->hull, corners, 1); /* 0: everybody is asked */
  }
}

/*
 * The same for a polygon that may be much larger than what the tile shows of it: the corners of the rectangle. When the normal
 * is cut, k is off by `slack` <= 2^33 and n.D by 3 * 2^30: with both at least 2^50, points move by less than 2^-16 of themselves. False when
 * that does not hold.
 */
static FC_COLD bool cast_from_part(fc_scan *scan, planar_work *work) {
  const fc_planar *planar = &work->planar;
  int64_t *points = work->hull, radius = 1;
  uint8_t i, bits = 0;
  if (planar->slack != 0 && planar->k >> 50 == 0) return false;
  for (i = 0; i < 4; i++) {
    uint8_t b;
    if (!foot(scan, planar, i & 1 ? planar->top : planar->bottom, i & 2 ? planar->left : planar->right, points + 3 * i))
      return false;
    b = fc_vector_bits(points + 3 * i);
    if (b > bits) bits = b;
  }
  if (bits > 30) return false;
  if (planar->slack != 0) radius += INT64_C(1) << (bits > 16 ? bits - 16 : 0);
  cast_from(scan, work, points, 4, radius);
  return true;
}

/* floor((2^32 - 1) / n), 0 for 0: bit by bit, as small chips divide by a function that nothing else here needs. */
static FC_COLD uint32_t per_step(uint16_t n) {
  uint32_t q = 0, rest = 0; /* below 2^17 */
  uint8_t i;
  if (n == 0) return 0;
  for (i = 0; i < 32; i++) {
    q <<= 1;
    rest = 2 * rest + 1;
    if (rest >= n) {
      rest -= n;
      q++;
    }
  }
  return q;
}

FC_COLD void fc_planar_find_corners(fc_planar *planar) {
  const uint16_t columns = (uint16_t)(planar->right - planar->left), rows = (uint16_t)(planar->bottom - planar->top);
  uint8_t i, j;
  for (j = 0; j < 3; j++) {
    const int32_t w = planar->w.at[j] + planar->w.dx[j] * planar->left + planar->w.dy[j] * planar->top;
    const int32_t right = planar->w.dx[j] * columns, down = planar->w.dy[j] * rows;
    for (i = 0; i < 4; i++)
      planar->corner[i][j] = (int16_t)fc_floor_shift32(w + (i & 1 ? right : 0) + (i & 2 ? down : 0) + 0x8000, 16);
  }
  planar->corners_known = true;
}

FC_COLD void fc_planar_find_steps(fc_planar *planar) {
  planar->per_column = per_step((uint16_t)(planar->right - planar->left));
  planar->per_row = per_step((uint16_t)(planar->bottom - planar->top));
  planar->steps_known = true;
}

/* Tables that cast as a whole. */
static FC_COLD void cast_tables(fc_scan *scan, fc_planar *planar) {
  const fc_space space = fc_space_of_frame(scan->frame);
  fc_cursor at;
  fc_cursor_start(&at, &space);
  while (fc_cursor_next(&at))
    if (fc_kind_of(&at)->cast != NULL) fc_kind_of(&at)->cast(scan, planar, fc_kind_of(&at), &at.group);
}

/* Candidates for occluders, each asked to darken what it can. */
static void cast_shadows(fc_scan *scan, planar_work *work, const int64_t *hull, uint8_t corners) {
  const bool sieve = scan->frame->scene.bvh != NULL;
  fc_planar *planar = &work->planar;
  if (scan->clear || !find_rectangle(scan, planar)) return;
  planar->corners_known = planar->edges_known = planar->steps_known = false;
  cast_tables(scan, planar);
  if (corners == 0 && sieve)
    cast_from_tile(scan, work);
  else if (!sieve || scan->columns * scan->rows < SMALL_TILE || !cast_from_part(scan, work))
    cast_from(scan, work, hull, corners, 1);
}

FC_COLD uint64_t fc_dot32(const int32_t a[3], const int32_t b[3]) {
  uint64_t sum = 0;
  uint8_t i;
  for (i = 0; i < 3; i++)
    if (a[i] != 0 && b[i] != 0) sum += (uint64_t)fc_smul32(a[i], b[i]);
  return sum;
}

static void set_square(const fc_sheaf *w, fc_square *s) {
  uint64_t xx = fc_dot32(w->dx, w->dx), yy = fc_dot32(w->dy, w->dy);
  s->at = fc_dot32(w->at, w->at);
  s->dx = 2 * fc_dot32(w->at, w->dx) + xx;
  s->dy = 2 * fc_dot32(w->at, w->dy) + yy;
  s->dxx = 2 * xx;
  s->dyy = 2 * yy;
  s->dxy = 2 * fc_dot32(w->dx, w->dy);
}

FC_NOINLINE void fc_cosine_start(const fc_square *s, const fc_cosine *g, uint16_t row, uint16_t column, fc_cosine_row *r) {
  /* q below 2^32; over 128 columns the rounded differences add up to an error below 2^14 */
  uint64_t at = s->at, dx = s->dx;
  if (column != 0) {
    at += fc_times(dx + fc_times(s->dxx >> 1, (uint16_t)(column - 1u)), column); /* dxx is even */
    dx += fc_times(s->dxx, column);
  }
  r->q = (uint32_t)(at >> 30);
  r->dq = (uint32_t)(dx >> 30); /* 34 bits are left: the sign's too */
  r->ddq = (uint32_t)(s->dxx >> 30);
  r->g = g->at + column * g->dx + row * g->dy;
}

/* Lights the pixels in `bits` from where the forms stand. */
static FC_HOT void shade_run(const fc_tint *restrict tint, fc_cosine_row *restrict r, int32_t dg, uint8_t count,
                             uint32_t bits, uint8_t *restrict to,
                             uint8_t pixel_bytes) {
  for (; count != 0; count--, bits >>= 1, to += pixel_bytes) {
    if (bits & 1) fc_tint_put(tint, fc_cosine_of(r->q, r->g), to);
    r->q += r->dq;
    r->dq += r->ddq;
    r->g += dg;
  }
}

/*
 * The same 2^s pixels at a time, levels in between by the chord. The cosine is a component of the unit vector W / |W|, and W moves
 * along a line. Seen under an angle a from the line's nearest point the unit vector bends by
 * (|dW| / |W|)^2 cos a sqrt(cos^2 a + 4 sin^2 a) a column, at most 1.16 (|dW| / |W|)^2. A chord over m columns is off by at most
 * m^2 / 8 of that: 2^-8, a quarter of a level in 63, when |W| >= 6.1 m |dW| at its least; ddq is twice |dW|^2.
 */
typedef struct chord_ends {
  uint32_t rb; /* red and blue, 5.11 bits each */
  uint32_t g;
} chord_ends;

static inline chord_ends levels_at(const fc_tint *tint, uint32_t c) {
  chord_ends l;
  l.rb = ((tint->base[0] + tint->slope[0] * c) << (27 - FC_TINT_BITS) & UINT32_C(0xffff0000)) |
         (tint->base[2] + tint->slope[2] * c) >> (FC_TINT_BITS - 11);
  l.g = tint->base[1] + tint->slope[1] * c;
  return l;
}

static inline void put_levels(uint32_t rb, uint32_t g, uint8_t *to) {
  uint32_t packed = ((rb >> 27 << 6 | g >> FC_TINT_BITS) << 5) | (rb & 0xffffu) >> 11;
  to[0] = (uint8_t)(packed >> 8);
  to[1] = (uint8_t)packed;
}

/* Red and blue are cut to 2^-11 at a chord's ends and so are their steps, downwards: at most 17 2^-11 of a level off in all, and
 * never above both ends; never below 0, as the rounding half is in them. */
static FC_HOT void shade_chords(const fc_tint *restrict tint, fc_cosine_row *restrict r, int32_t dg, uint8_t count,
                                uint32_t bits, uint8_t *restrict to, uint8_t s) {
  /* s steps at once: q by m dq + m (m - 1) / 2 ddq */
  const uint32_t q_bend = (r->ddq << (2 * s - 1)) - (r->ddq << (s - 1)), chunk = (UINT32_C(1) << (1 << s)) - 1;
  chord_ends end = levels_at(tint, fc_cosine_of(r->q, r->g));
  while (count != 0) {
    uint32_t rb = end.rb, g = end.g, d_rb, d_g, some = bits & chunk;
    uint8_t *at = to;
    if (r->g <= -dg * (INT32_C(1) << s)) { /* a chord must not cross the horizon, where cosines are cut to 0 */
      shade_run(tint, r, dg, count, bits, to, 2);
      return;
    }
    to += 2 << s;
    r->q += (r->dq << s) + q_bend;
    r->dq += r->ddq << s;
    r->g += dg * (INT32_C(1) << s);
    end = levels_at(tint, fc_cosine_of(r->q, r->g));
    /* differences of levels below 2^29 and 2^16 */
    d_g = (uint32_t)fc_floor_shift32(fc_to_i32(end.g - g), s);
    d_rb = ((uint32_t)fc_floor_shift32((int32_t)(end.rb >> 16) - (int32_t)(rb >> 16), s) << 16) +
           (uint32_t)fc_floor_shift32((int32_t)(end.rb & 0xffffu) - (int32_t)(rb & 0xffffu), s);
    if (some == chunk) {
      do { /* two at a time: a chord has an even number */
        put_levels(rb, g, at);
        rb += d_rb;
        g += d_g;
        put_levels(rb, g, at + 2);
        rb += d_rb;
        g += d_g;
        at += 4;
      } while (at != to);
    } else {
      for (; some != 0; some >>= 1, at += 2) {
        if (some & 1) put_levels(rb, g, at);
        rb += d_rb;
        g += d_g;
      }
    }
    bits >>= 1 << s;
    count = (uint8_t)(count <= 1 << s ? 0 : count - (1 << s));
  }
}

/* The least q of the columns from where the forms stand to n on: q is a parabola, so it falls by n |dq| / 2 at most where it
 * rises again at the end, and by what its differences add up to where it does not. */
uint32_t fc_cosine_least(const fc_cosine_row *r, uint8_t n) {
  uint32_t fall = 0u - r->dq;
  uint64_t drop; /* below 2^38 */
  if (fc_to_i32(r->dq) >= 0) return r->q;
  drop = fc_mul32(fall, n);
  if (fc_mul32(r->ddq, n) >= fall)
    drop = (drop >> 1) + 1;
  else
    drop -= fc_mul32(r->ddq, (uint32_t)n * (n - 1u) / 2); /* n |dq| > n^2 ddq */
  return drop < r->q ? r->q - (uint32_t)drop : 0;
}

FC_HOT void fc_planar_colour(fc_scan *scan, const fc_planar *planar, const fc_cosine *g) {
  /* chords twice as long are off four times as far: 2^-6 of a cosine, four levels in 255 */
  const uint8_t fast = fc_scan_guesses(scan);
  fc_square square;
  uint16_t row;
  uint8_t word;
  set_square(&planar->w, &square);
  for (row = 0; row <= scan->last_row; row++, fc_square_next_row(&square)) {
    fc_cosine_row forms = {0, 0, 0, 0};
    uint16_t next = UINT16_MAX, column = 0; /* the column that the forms stand at */
    if (row < scan->first_row) continue;
    for (word = 0; word < scan->words; word++, column = (uint16_t)(column + 32)) {
      uint32_t bits = scan->mask[row * scan->words + word];
      uint16_t at = column;
      uint8_t count, chord;
      uint32_t least = 0;
      if (bits == 0) continue;
      while (!(bits & 1)) {
        bits >>= 1;
        at++;
      }
      count = (uint8_t)(32 - fc_clz32(bits)); /* what lies behind the last is not needed */
      /* q is within 2^14, which costs the cosine 2^-11 of itself from 2^24 on; where the forms were just set up it is within
       * 2^10, and 2^20 is enough. A chord's end may lie 15 columns further. */
      if (at == next && word % 4 != 0) least = fc_cosine_least(&forms, (uint8_t)(count + 14));
      if (at != next || word % 4 == 0 || least < UINT32_C(1) << 24) {
        fc_cosine_start(&square, g, row, at, &forms);
        least = fc_cosine_least(&forms, (uint8_t)(count + 14));
      }
      if (least < UINT32_C(1) << 20) {
        fc_scan_shade_slowly(scan, row, at, bits);
        next = UINT16_MAX;
        continue;
      }
      fc_scan_lit(scan, row, at, bits);
      chord = scan->tint.plain ? fc_chord_of(least, forms.ddq) : 0;
      if (chord != 0 && chord < 4) chord = (uint8_t)(chord + fast);
      if (chord != 0) {
        shade_chords(&scan->tint, &forms, g->dx, count, bits, fc_scan_pixel(scan, row, at), chord);
        next = count % (1 << chord) == 0 ? (uint16_t)(at + count) : UINT16_MAX;
      } else {
        shade_run(&scan->tint, &forms, g->dx, count, bits, fc_scan_pixel(scan, row, at), scan->pixel_bytes);
        next = (uint16_t)(at + count);
      }
    }
  }
}

/* The plane turned to the eye, and cut to 30 bits. */
static void set_plane(const fc_scan *scan, fc_planar *planar, const int64_t normal[3], fc_i128 k, const int64_t *point) {
  uint8_t bits = fc_vector_bits(normal), cut = bits > 30 ? (uint8_t)(bits - 30) : 0, i;
  bool away = fc_i128_sign(k) < 0;
  planar->exact_k = k;
  if (away) fc_i128_negate(&planar->exact_k);
  for (i = 0; i < 3; i++) {
    planar->exact[i] = away ? -normal[i] : normal[i];
    planar->normal[i] = fc_floor_shift64(planar->exact[i], cut);
  }
  planar->k = cut == 0 ? fc_i128_to_i64(planar->exact_k) : fc_dot(planar->normal, point);
  /* an axis of the normal is off by up to 1, of p - point by up to 2^31; and |n| times a radius by up to 2^31 */
  planar->slack = cut == 0 ? 0 : INT64_C(4) << 31;
  planar->height = planar->k - fc_dot(planar->normal, scan->frame->lights);
}

FC_COLD int8_t fc_planar_side(const fc_planar *planar, const int64_t p[3]) {
  int64_t side = planar->k - fc_dot(planar->normal, p);
  fc_i128 height, along;
  if (planar->slack == 0 || (int64_t)fc_abs64(side) > planar->slack) return fc_sign64(side);
  height = planar->exact_k;
  along = fc_i128_dot(planar->exact, p); /* 63 + 30 bits */
  fc_i128_minus(&height, &along);
  return fc_i128_sign(height);
}

FC_COLD uint8_t fc_planar_reach(fc_scan *scan, const int64_t normal[3], fc_i128 k, const int64_t *hull, uint8_t corners,
                                const fc_planar **on, const fc_cosine **g) {
  planar_work *work = (void *)scan->work;
  fc_planar *planar = &work->planar;
  uint16_t row;
  uint8_t word;
  bool any = false, lit = true, known = false, slow = false;
  for (row = scan->first_row; row <= scan->last_row; row++) {
    for (word = 0; word < scan->words; word++) {
      uint32_t *bits = &scan->mask[row * scan->words + word];
      if (*bits == 0) continue;
      if (!fc_scan_wants_light(scan, row, (uint16_t)(32 * word), *bits)) continue;
      if (!known) {
        set_plane(scan, planar, normal, k, hull);
        lit = fc_planar_side(planar, scan->frame->lights) > 0;
        /* the eye, or W, too close to the plane for the forms */
        slow = lit && (planar->k <= planar->slack || !set_forms(scan, planar, &work->g));
        known = true;
      }
      if (!lit)
        fc_scan_unlit(scan, row, (uint16_t)(32 * word), *bits);
      else if (slow)
        fc_scan_shade_slowly(scan, row, (uint16_t)(32 * word), *bits);
      else
        any = true;
    }
  }
  *on = planar;
  *g = &work->g;
  if (!any) return slow ? FC_PLANAR_SLOW : FC_PLANAR_DARK;
  cast_shadows(scan, work, hull, corners);
  return FC_PLANAR_LIT;
}

FC_COLD void fc_planar_light(fc_scan *scan, const int64_t normal[3], fc_i128 k, const int64_t *hull, uint8_t corners) {
  const fc_planar *planar;
  const fc_cosine *g;
  if (scan->coat != NULL) {
    fc_coat_kind kind;
    FC_READ_ONE(&kind, scan->coat);
    kind.planar(scan, normal, k, hull, corners);
    return;
  }
  if (fc_planar_reach(scan, normal, k, hull, corners, &planar, &g) == FC_PLANAR_LIT) fc_planar_colour(scan, planar, g);
}
