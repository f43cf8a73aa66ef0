/* Spheres: exact discriminant, both roots, occlusion and facing. */
#include "bits.h"
#include "fixcast/error.h"
#include "kind.h"
#include "quick.h"
#include "scan_kinds.h"
#include "tally.h"
#include "view.h"

static void read_item(const fc_shapes *shapes, uint16_t index, fc_sphere *sphere) {
  FC_READ(sphere, (const fc_sphere *)shapes->items + index, sizeof *sphere);
}

static FC_COLD int check(const fc_scene *scene, const fc_shapes *shapes) {
  uint16_t i;
  for (i = 0; i < shapes->count; i++) {
    fc_sphere s;
    read_item(shapes, i, &s);
    if (fc_abs32(s.center.x) > (uint32_t)FC_COORDINATE_MAX || fc_abs32(s.center.y) > (uint32_t)FC_COORDINATE_MAX ||
        fc_abs32(s.center.z) > (uint32_t)FC_COORDINATE_MAX || s.radius > FC_COORDINATE_MAX)
      return FC_ERR_COORDINATE;
    if (s.radius <= 0) return FC_ERR_RADIUS;
    if (s.material >= scene->material_count) return FC_ERR_INDEX;
  }
  return FC_OK;
}

static FC_COLD size_t memory(const fc_shapes *shapes) { return (size_t)shapes->count * sizeof(fc_placed_sphere); }

/* |offset| + radius 2^fine, within 2^-23. */
static fc_quick quick_reach(const int64_t offset[3], uint64_t radius, uint8_t fine) {
  fc_quick square, sum = {0, 0};
  uint8_t i, bits = fc_vector_bits(offset), shift = bits > 30 ? (uint8_t)(bits - 30) : 0;
  uint64_t squares = 0;
  for (i = 0; i < 3; i++) {
    uint64_t a = fc_abs64(offset[i]) >> shift; /* below 2^30 */
    squares += fc_mul32((uint32_t)a, (uint32_t)a);
  }
  square = fc_quick_from(squares, 0);
  if (squares != 0) sum = fc_quick_mul(square, fc_quick_rsqrt(square));
  return fc_quick_add(fc_quick_scale(sum, (int16_t)shift), fc_quick_from(radius, (int16_t)fine));
}

static FC_COLD fc_num extent(const fc_view *view, const fc_shapes *shapes) {
  /* the reach of each to 2^-23 first; then exactly those that may be the farthest */
  fc_num most = {0, 0};
  fc_quick farthest = {0, 0};
  uint8_t pass;
  for (pass = 0; pass < 2; pass++) {
    uint16_t i;
    for (i = 0; i < shapes->count; i++) {
      fc_sphere s;
      int64_t offset[3];
      fc_quick quick;
      read_item(shapes, i, &s);
      fc_view_offset(view, &s.center, offset);
      quick = quick_reach(offset, (uint64_t)s.radius, view->fine);
      if (pass == 0) {
        if (fc_quick_less(farthest, quick)) farthest = quick;
      } else {
        /* 2^-20 more is more than the values' errors */
        quick.m = quick.m > UINT32_MAX - (quick.m >> 20) - 1 ? UINT32_MAX : quick.m + (quick.m >> 20) + 1;
        if (!fc_quick_less(quick, farthest)) {
          fc_num reach = fc_num_add(fc_length(offset), fc_num_from_u64((uint64_t)s.radius, view->fine));
          if (fc_num_compare(reach, most) > 0) most = reach;
        }
      }
    }
  }
  return most;
}

static FC_COLD void place(const fc_view *view, const fc_shapes *shapes, void *to) {
  fc_placed_sphere *placed = to;
  uint16_t i;
  for (i = 0; i < shapes->count; i++) {
    fc_sphere s;
    int64_t center[3];
    read_item(shapes, i, &s);
    (void)fc_view_point(view, &s.center, 0, center); /* within range: the grid was chosen for it */
    placed[i].center[0] = (int32_t)center[0];
    placed[i].center[1] = (int32_t)center[1];
    placed[i].center[2] = (int32_t)center[2];
    placed[i].radius = (int32_t)fc_num_round(fc_num_from_u64((uint64_t)s.radius, view->fine), -view->shift);
  }
}

static FC_COLD void fetch(const fc_group *group, uint16_t index, fc_form *form) {
  fc_sphere s;
  read_item(&group->shapes, index, &s);
  form->material = s.material;
  form->object = s.object;
  if (group->memory != NULL) {
    const fc_placed_sphere *placed = (const fc_placed_sphere *)group->memory + index;
    form->u.sphere.center[0] = placed->center[0];
    form->u.sphere.center[1] = placed->center[1];
    form->u.sphere.center[2] = placed->center[2];
    form->u.sphere.radius = placed->radius;
  } else {
    form->u.sphere.center[0] = s.center.x;
    form->u.sphere.center[1] = s.center.y;
    form->u.sphere.center[2] = s.center.z;
    form->u.sphere.radius = s.radius;
  }
}

/* |v|^2 - r^2 for v below 2^62, exact. */
static fc_i128 power(const int64_t v[3], int64_t radius) {
  return fc_i128_sub(fc_i128_dot(v, v), fc_i128_mul(radius, radius));
}

static FC_COLD void prepare(const fc_form *form, const int64_t origin[3], fc_prepared *prepared) {
  uint8_t i;
  for (i = 0; i < 3; i++) prepared->u.sphere.oc[i] = form->u.sphere.center[i] - origin[i];
  prepared->u.sphere.c = power(prepared->u.sphere.oc, form->u.sphere.radius);
}

static FC_COLD uint8_t test(const fc_prepared *prepared, const int64_t direction[3], fc_root root[2]) {
  /* t = (b -+ sqrt(b^2 - a c)) / a with b = direction . oc (the half coefficient's negative).
   * direction 30 bits, oc 31: b < 3 * 2^61 < 2^63; a < 3 * 2^60; |c| < 2^64: a c < 2^126, b^2 < 2^126 (Lagrange:
   * b^2 <= a |oc|^2), so the difference is below 2^127. */
  const int64_t *oc = prepared->u.sphere.oc;
  int64_t b = direction[0] * oc[0] + direction[1] * oc[1] + direction[2] * oc[2];
  int64_t a = direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2];
  int8_t outside = fc_i128_sign(prepared->u.sphere.c);
  fc_i128 d;
  if (outside >= 0 && b <= 0) return 0;
  d = fc_i128_sub(fc_i128_mul(b, b), fc_i128_scale(prepared->u.sphere.c, a));
  if (fc_i128_sign(d) < 0) return 0;
  root[0].p = fc_i128_from(b);
  root[0].m = fc_i128_from(a);
  root[0].d = d;
  root[0].c = fc_i128_abs(prepared->u.sphere.c);
  root[0].q = outside > 0 ? -1 : 1;
  if (outside <= 0) return 1;
  root[1] = root[0];
  root[1].q = 1;
  return fc_i128_sign(d) > 0 ? 2 : 1;
}

/* A vector shrunk to below 2^bits by floor division with 2^shift. */
static void shrink(const int64_t v[3], uint8_t shift, int64_t r[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) r[i] = fc_floor_shift64(v[i], shift);
}

static fc_wide wide_of(int64_t v) {
  fc_wide w;
  fc_wide_from_i64(&w, v);
  return w;
}

/* x + y sqrt(d) with the point's d. */
typedef struct surd {
  fc_wide x, y;
} surd;

/* m^2 times |C - P|^2 - r^2. */
static int8_t exact_power_sign(const fc_form *form, const fc_exact_point *p) {
  fc_wide g[3], x, y, term;
  uint8_t i;
  for (i = 0; i < 3; i++) {
    fc_wide_mul_i64(&g[i], &p->m, form->u.sphere.center[i]);
    fc_wide_sub(&g[i], &g[i], &p->u[i]);
  }
  fc_wide_dot(&x, g, g);
  fc_wide_dot(&term, p->v, p->v);
  fc_wide_mul(&term, &term, &p->d);
  fc_wide_add(&x, &x, &term);
  fc_wide_mul_i64(&term, &p->m, form->u.sphere.radius);
  fc_wide_mul(&term, &term, &term);
  fc_wide_sub(&x, &x, &term);
  fc_wide_dot(&y, g, p->v);
  fc_wide_add(&y, &y, &y);
  fc_wide_neg(&y);
  return fc_surd_sign(&x, &y, &p->d);
}

/* Whether the line through light and point, seen from the light, comes within r of the center strictly between the
 * two. W = m (P - L) = w + v sqrt(d); q = |C - L|^2 - r^2. */
static bool exact_passes(const fc_form *form, const fc_segment *segment, const fc_exact_point *p, fc_i128 q) {
  fc_wide w[3], c[3], along_x, along_y, square_x, square_y, x, y, term;
  uint8_t i;
  for (i = 0; i < 3; i++) {
    fc_wide_mul_i64(&w[i], &p->m, segment->light[i]);
    fc_wide_sub(&w[i], &p->u[i], &w[i]);
    c[i] = wide_of(form->u.sphere.center[i] - segment->light[i]);
  }
  /* W.c > 0 */
  fc_wide_dot(&along_x, w, c);
  fc_wide_dot(&along_y, p->v, c);
  if (fc_surd_sign(&along_x, &along_y, &p->d) <= 0) return false;
  /* W.W - m W.c > 0 */
  fc_wide_dot(&square_x, w, w);
  fc_wide_dot(&term, p->v, p->v);
  fc_wide_mul(&term, &term, &p->d);
  fc_wide_add(&square_x, &square_x, &term);
  fc_wide_dot(&square_y, w, p->v);
  fc_wide_add(&square_y, &square_y, &square_y);
  fc_wide_mul(&term, &p->m, &along_x);
  fc_wide_sub(&x, &square_x, &term);
  fc_wide_mul(&term, &p->m, &along_y);
  fc_wide_sub(&y, &square_y, &term);
  if (fc_surd_sign(&x, &y, &p->d) <= 0) return false;
  /* (W.c)^2 - W.W q >= 0 */
  fc_wide_mul(&x, &along_x, &along_x);
  fc_wide_mul(&term, &along_y, &along_y);
  fc_wide_mul(&term, &term, &p->d);
  fc_wide_add(&x, &x, &term);
  fc_wide_mul(&y, &along_x, &along_y);
  fc_wide_add(&y, &y, &y);
  fc_wide_from(&term, q);
  fc_wide_mul(&square_x, &square_x, &term);
  fc_wide_mul(&square_y, &square_y, &term);
  fc_wide_sub(&x, &x, &square_x);
  fc_wide_sub(&y, &y, &square_y);
  return fc_surd_sign(&x, &y, &p->d) >= 0;
}

static FC_COLD bool exact_blocked(const fc_form *form, const fc_segment *segment, fc_i128 q_light) {
  fc_exact_point p;
  int8_t at_light = fc_i128_sign(q_light), at_point;
  fc_exact_point_of(&p, segment);
  at_point = exact_power_sign(form, &p);
  if (at_light * at_point < 0) return true;
  if (at_light < 0 || at_point < 0 || (at_light == 0 && at_point == 0)) return false;
  return exact_passes(form, segment, &p, q_light);
}

/* +1 or -1 when |value| exceeds its error, 0 when not. */
static int8_t certain_sign(fc_i128 value, fc_i128 error) {
  return fc_i128_compare(fc_i128_abs(value), error) > 0 ? fc_i128_sign(value) : 0;
}

static void bounds(const fc_form *form, int64_t low[3], int64_t high[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    low[i] = form->u.sphere.center[i] - form->u.sphere.radius;
    high[i] = form->u.sphere.center[i] + form->u.sphere.radius;
  }
}

/* Blocked by filter: 1 yes, 0 no, -1 undecided. */
static int8_t quick_blocked(const fc_form *form, const fc_segment *segment, fc_i128 q_light) {
  int64_t c_light[3], c_point[3], w[3], wl[3];
  fc_i128 disc, error;
  int64_t along, square, q, r, e_along, e_square, e_q;
  int8_t at_light, at_point, sign;
  uint8_t i, bits, shift;
  for (i = 0; i < 3; i++) c_light[i] = form->u.sphere.center[i] - segment->light[i];
  at_light = fc_i128_sign(q_light);
  if (!segment->point_valid) return -1;
  for (i = 0; i < 3; i++) {
    c_point[i] = form->u.sphere.center[i] - segment->point[i];
    wl[i] = segment->point[i] - segment->light[i];
  }
  /* |C - P|^2 - r^2 with P off by at most 1 an axis: off by 2 |C - P|_1 + 3 */
  error = fc_i128_from(0);
  if (segment->point_error != 0) {
    error = fc_norm1(c_point);
    error = fc_i128_add(fc_i128_add(error, error), fc_i128_from(3));
  }
  disc = power(c_point, form->u.sphere.radius);
  at_point = certain_sign(disc, error);
  if (at_point == 0 && segment->point_error != 0) return -1;
  if (at_light * at_point < 0) return 1;
  if (at_light < 0 || at_point < 0 || (at_light == 0 && at_point == 0)) return 0; /* no surface between them */
  /* Both ends outside. Shrink to 30 bits: each component of c off by e_c = shift > 0, of w by e_w. */
  bits = fc_vector_bits(wl);
  if (fc_vector_bits(c_light) > bits) bits = fc_vector_bits(c_light);
  shift = bits > 30 ? (uint8_t)(bits - 30) : 0;
  shrink(c_light, shift, c_light);
  shrink(wl, shift, w);
  r = form->u.sphere.radius >> shift;
  {
    int64_t e_c = shift > 0, e_w = e_c + segment->point_error;
    /* components up to 2^30: sums of three products below 2^62 */
    along = fc_small_dot(w, c_light);
    square = fc_small_dot(w, w);
    q = fc_small_dot(c_light, c_light) - r * r;
    e_along = fc_small_norm1(w) * e_c + fc_small_norm1(c_light) * e_w + 3 * e_c * e_w;
    e_square = 2 * fc_small_norm1(w) * e_w + 3 * e_w * e_w;
    e_q = 2 * fc_small_norm1(c_light) * e_c + 3 * e_c + 2 * r * e_c + e_c;
  }
  if (along < -e_along || square - along < -(e_square + e_along)) return 0;
  /* along^2 - square q: 124 bits; off by 2 |along| e_along + e_along^2 + square e_q + |q| e_square + e_q e_square */
  disc = fc_i128_sub(fc_i128_mul(along, along), fc_i128_mul(square, q));
  error = fc_i128_add(fc_i128_mul(2 * e_along, (int64_t)fc_abs64(along)), fc_i128_mul(e_along, e_along));
  error = fc_i128_add(error, fc_i128_mul(square, e_q));
  error = fc_i128_add(error, fc_i128_mul((int64_t)fc_abs64(q), e_square));
  error = fc_i128_add(error, fc_i128_mul(e_q, e_square));
  sign = certain_sign(disc, error);
  if (sign < 0) return 0;
  if ((sign > 0 || fc_i128_sign(error) == 0) && along > e_along && square - along > e_square + e_along) return 1;
  return -1;
}

static FC_COLD bool blocked(const fc_form *form, const fc_segment *segment) {
  int64_t c_light[3], low[3], high[3];
  fc_i128 q_light;
  int8_t quick;
  uint8_t i;
  bounds(form, low, high);
  if (fc_segment_apart(segment, low, high)) return false;
  for (i = 0; i < 3; i++) c_light[i] = form->u.sphere.center[i] - segment->light[i];
  q_light = power(c_light, form->u.sphere.radius);
  quick = quick_blocked(form, segment, q_light);
  FC_TALLY(FC_DECIDE_PASS, quick < 0);
  return quick < 0 ? exact_blocked(form, segment, q_light) : quick > 0;
}

/* Sign of (P - C) . (L - P). */
static int8_t outward_sign(const fc_form *form, const fc_segment *segment) {
  fc_exact_point p;
  fc_wide g[3], h[3], x, y, term;
  uint8_t i;
  if (segment->point_valid) {
    int64_t n[3], l[3];
    fc_i128 value, error = fc_i128_from(0);
    bool certain;
    for (i = 0; i < 3; i++) {
      n[i] = segment->point[i] - form->u.sphere.center[i];
      l[i] = segment->light[i] - segment->point[i];
    }
    value = fc_i128_dot(n, l);
    if (segment->point_error != 0) error = fc_i128_add(fc_i128_add(fc_norm1(n), fc_norm1(l)), fc_i128_from(3));
    certain = segment->point_error == 0 || certain_sign(value, error) != 0;
    FC_TALLY(FC_DECIDE_FACING, !certain);
    if (certain) return fc_i128_sign(value);
  }
  /* G = u - m C, H = m L - u; (G + v s).(H - v s) = G.H - d v.v + (v.H - G.v) s */
  fc_exact_point_of(&p, segment);
  for (i = 0; i < 3; i++) {
    fc_wide_mul_i64(&g[i], &p.m, form->u.sphere.center[i]);
    fc_wide_sub(&g[i], &p.u[i], &g[i]);
    fc_wide_mul_i64(&h[i], &p.m, segment->light[i]);
    fc_wide_sub(&h[i], &h[i], &p.u[i]);
  }
  fc_wide_dot(&x, g, h);
  fc_wide_dot(&term, p.v, p.v);
  fc_wide_mul(&term, &term, &p.d);
  fc_wide_sub(&x, &x, &term);
  fc_wide_dot(&y, p.v, h);
  fc_wide_dot(&term, g, p.v);
  fc_wide_sub(&y, &y, &term);
  return fc_surd_sign(&x, &y, &p.d);
}

static FC_COLD bool facing(const fc_form *form, const fc_prepared *prepared, const fc_segment *segment) {
  int64_t c_light[3];
  uint8_t i;
  if (fc_i128_sign(prepared->u.sphere.c) > 0) return outward_sign(form, segment) > 0;
  /* from inside (or on it, looking in), the light must be inside too, or the sphere itself is in the way */
  for (i = 0; i < 3; i++) c_light[i] = form->u.sphere.center[i] - segment->light[i];
  return fc_i128_sign(power(c_light, form->u.sphere.radius)) <= 0 && outward_sign(form, segment) < 0;
}

static FC_COLD bool normal(const fc_form *form, const fc_prepared *prepared, const int64_t point[3], int64_t n[3]) {
  uint8_t i;
  (void)prepared;
  for (i = 0; i < 3; i++) n[i] = point[i] - form->u.sphere.center[i];
  return false; /* which side is seen, the root knows */
}

static FC_COLD void step_off(const fc_form *form, bool inside, int64_t point[3]) {
  /* The point is within 1 unit an axis of the sphere, so a few unit steps along the normal's dominant axis cross it. */
  uint8_t axis = 0, i;
  int64_t v[3], step;
  for (i = 0; i < 3; i++) v[i] = point[i] - form->u.sphere.center[i];
  for (i = 1; i < 3; i++)
    if (fc_abs64(v[i]) > fc_abs64(v[axis])) axis = i;
  step = (v[axis] < 0) != inside ? -1 : 1;
  for (i = 0; i < 8; i++) {
    int8_t side = fc_i128_sign(power(v, form->u.sphere.radius));
    if (inside ? side < 0 : side > 0) break;
    v[axis] += step;
    point[axis] += step;
  }
}

static FC_COLD void depth_range(const fc_frame *frame, const fc_group *group, uint64_t *near, uint64_t *far) {
  uint16_t i;
  (void)frame;
  for (i = 0; i < group->shapes.count; i++) {
    fc_form form;
    int64_t z, r;
    fetch(group, i, &form);
    z = form.u.sphere.center[2];
    r = form.u.sphere.radius;
    if (z + r <= 0) continue;
    if (z - r <= 0 || (uint64_t)(z - r) < *near) *near = z - r > 0 ? (uint64_t)(z - r) : 0;
    if ((uint64_t)(z + r) > *far) *far = (uint64_t)(z + r);
  }
}

const fc_kind fc_kind_sphere FC_ROM = {
    check,    memory, extent,      place,             fetch,            prepare,        test,             blocked,         facing, normal,
    step_off, NULL,   depth_range, fc_sphere_project, fc_sphere_window, fc_sphere_draw, fc_sphere_shadow, fc_sphere_between,
    fc_sphere_hides,
    fc_scan_each, bounds, NULL};
