/* Spheres: exact discriminant, both roots, occlusion and facing. */
#include "bits.h"
#include "fixcast/error.h"
#include "kind.h"
#include "quick.h"
#include "scan_kinds.h"
#include "transform.h"
#include "view.h"

static FC_COLD void read_item(const fc_shapes *shapes, uint16_t index, fc_sphere *sphere) {
  FC_READ_ONE(sphere, (const fc_sphere *)shapes->items + index);
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

static FC_COLD uint32_t memory(const fc_shapes *shapes) { return shapes->count * (uint32_t)sizeof(fc_placed_sphere); }

/* |offset| + radius 2^fine, within 2^-12: the longest of all has 15 bits, each is less than 1 short, and so the sum less than 3. */
static FC_COLD fc_quick quick_reach(const int64_t offset[3], uint64_t radius, uint8_t fine) {
  fc_quick sum;
  uint64_t most = radius << fine; /* 30 + 31 bits */
  uint32_t square = 0;            /* below 3 2^30 */
  uint8_t i, shift;
  for (i = 0; i < 3; i++) most |= fc_abs64(offset[i]);
  shift = fc_bits64(most);
  shift = shift > 15 ? (uint8_t)(shift - 15) : 0;
  for (i = 0; i < 3; i++) {
    uint32_t a = (uint32_t)(fc_abs64(offset[i]) >> shift);
    square += a * a;
  }
  sum = fc_quick_from(square, 0);
  if (square != 0) sum = fc_quick_mul(sum, fc_quick_rsqrt(sum));
  return fc_quick_scale(fc_quick_add(sum, fc_quick_from((radius << fine) >> shift, 0)), shift);
}

static FC_COLD fc_num extent(const fc_view *view, const fc_shapes *shapes) {
  /* the reach of each to 2^-12 first; exactly where that may be the farthest so far, as the farthest of all may when its turn comes */
  fc_num most = {0, 0};
  fc_quick farthest = {0, 0};
  const fc_quick nearly_one = {UINT32_C(0xffc00000), -32}; /* 2^-10 less: more than two values' errors */
  uint16_t i;
  for (i = 0; i < shapes->count; i++) {
    fc_sphere s;
    int64_t offset[3];
    fc_quick quick;
    fc_num reach, radius;
    read_item(shapes, i, &s);
    fc_view_offset(view, &s.center, offset);
    quick = quick_reach(offset, (uint64_t)s.radius, view->fine);
    if (fc_quick_less(quick, farthest)) continue;
    quick = fc_quick_mul(quick, nearly_one);
    if (fc_quick_less(farthest, quick)) farthest = quick;
    fc_length_to(&reach, offset);
    fc_num_set(&radius, (uint64_t)s.radius, view->fine);
    fc_num_plus(&reach, &radius);
    if (fc_num_order_of(&reach, &most) > 0) most = reach;
  }
  return most;
}

static FC_COLD void place(const fc_view *view, const fc_shapes *shapes, void *to) {
  fc_placed_sphere *placed = to;
  fc_transform t;
  const bool quick = fc_transform_find(view, &t);
  uint16_t i;
  uint8_t j;
  for (i = 0; i < shapes->count; i++) {
    fc_sphere s;
    int64_t center[3];
    read_item(shapes, i, &s);
    if (quick) {
      fc_transform_point(view, &t, &s.center, placed[i].center);
    } else {
      (void)fc_view_point(view, &s.center, 0, center); /* within range: the grid was chosen for it */
      for (j = 0; j < 3; j++) placed[i].center[j] = (int32_t)center[j];
    }
    placed[i].radius = (int32_t)fc_num_round(fc_num_from_u64((uint64_t)s.radius, view->fine), -view->shift);
  }
}

static FC_COLD void fetch(const fc_group *group, uint16_t index, fc_form *form) {
  const fc_sphere *item = (const fc_sphere *)group->shapes.items + index;
  int32_t v[4];
  uint8_t i;
  if (group->memory != NULL) {
    const fc_placed_sphere *placed = (const fc_placed_sphere *)group->memory + index;
    v[0] = placed->center[0];
    v[1] = placed->center[1];
    v[2] = placed->center[2];
    v[3] = placed->radius;
  } else {
    fc_sphere s;
    read_item(&group->shapes, index, &s);
    v[0] = s.center.x;
    v[1] = s.center.y;
    v[2] = s.center.z;
    v[3] = s.radius;
  }
  for (i = 0; i < 3; i++) form->u.sphere.center[i] = v[i];
  form->u.sphere.radius = v[3];
  FC_READ_ONE(&form->material, &item->material);
  FC_READ_ONE(&form->object, &item->object);
}

static FC_COLD void prepare(const fc_form *form, const int64_t origin[3], fc_prepared *prepared) {
  int64_t *oc = prepared->u.sphere.oc, r = form->u.sphere.radius;
  uint64_t far, near = (uint64_t)(r * r);
  uint8_t i;
  for (i = 0; i < 3; i++) oc[i] = form->u.sphere.center[i] - origin[i];
  /* 31 bits each: the sum of squares is below 3 2^62, modulo 2^64 as it is */
  far = (uint64_t)fc_dot(oc, oc);
  prepared->u.sphere.c.lo = far - near;
  prepared->u.sphere.c.hi = far < near ? UINT64_MAX : 0;
}

static FC_COLD uint8_t test(const fc_prepared *prepared, const int64_t direction[3], fc_root *root) {
  /* t = (b -+ sqrt(b^2 - a c)) / a with b = direction . oc (the half coefficient's negative).
   * direction 30 bits, oc 31: b < 3 * 2^61 < 2^63; a < 3 * 2^60; |c| < 2^64: a c < 2^126, b^2 < 2^126 (Lagrange:
   * b^2 <= a |oc|^2), so the difference is below 2^127. */
  int64_t b = fc_dot(direction, prepared->u.sphere.oc), a = fc_dot(direction, direction);
  fc_i128 ac;
  int8_t outside = fc_i128_sign(prepared->u.sphere.c), sign;
  if (outside >= 0 && b <= 0) return 0;
  root->p = fc_i128_from(b);
  root->m = fc_i128_from(a);
  root->c = prepared->u.sphere.c;
  ac = fc_i128_scale(root->c, a);
  fc_i128_set_product(&root->d, b, b);
  fc_i128_minus(&root->d, &ac);
  root->q = outside > 0 ? -1 : 1;
  sign = fc_i128_sign(root->d);
  if (sign < 0) return 0;
  return outside > 0 && sign > 0 ? 2 : 1;
}

static FC_COLD int8_t side(const fc_form *form, const int64_t point[3]) {
  int64_t v[3];
  fc_i128 square;
  uint8_t i;
  for (i = 0; i < 3; i++) v[i] = point[i] - form->u.sphere.center[i];
  square = fc_i128_dot(v, v);
  return fc_i128_compare(square, fc_i128_from(form->u.sphere.radius * form->u.sphere.radius));
}

static FC_COLD void bounds(const fc_form *form, int64_t low[3], int64_t high[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    low[i] = form->u.sphere.center[i] - form->u.sphere.radius;
    high[i] = form->u.sphere.center[i] + form->u.sphere.radius;
  }
}

/*
 * Forms of the point P = t D, the light L and the center C, from their products: 0 DD, 1 DL, 2 DC, 3 LL, 4 LC, 5 CC, 6 r, 7 one.
 */
/* |P - C|^2 - r^2 */
static const uint8_t outside[] FC_ROM = {FC_SUM(1, 1), FC_TIMES(5, 7), FC_TIMES(6, 6), FC_SUM(0, 2), FC_TIMES(2, 7),
                                         FC_TIMES(2, 7), FC_SUM(1, 0), FC_TIMES(0, 7), 0};
/* (C - P).(L - P), negative where P faces the light; positive also says that C's foot on the line is beyond P, seen from L */
static const uint8_t away[] FC_ROM = {FC_SUM(1, 0), FC_TIMES(4, 7), FC_SUM(0, 2), FC_TIMES(1, 7), FC_TIMES(2, 7),
                                      FC_SUM(1, 0), FC_TIMES(0, 7), 0};
/* (P - L).(C - L) */
static const uint8_t ahead[] FC_ROM = {FC_SUM(1, 1), FC_TIMES(3, 7), FC_TIMES(4, 7), FC_SUM(1, 1), FC_TIMES(2, 7),
                                       FC_TIMES(1, 7), FC_NOTHING, 0};
/* ((P - L).(C - L))^2 - |P - L|^2 (|C - L|^2 - r^2): not negative where the line meets the sphere */
static const uint8_t met[] FC_ROM = {
    FC_SUM(2, 3), FC_TIMES(5, 7), FC_TIMES(3, 7), FC_TIMES(4, 7), FC_TIMES(4, 7), FC_TIMES(6, 6), /* 8: |C - L|^2 - r^2 */
    FC_SUM(1, 1), FC_TIMES(2, 7), FC_TIMES(1, 7),                                                 /* 9: D.(C - L) */
    FC_SUM(1, 1), FC_TIMES(4, 7), FC_TIMES(3, 7),                                                 /* 10: L.(C - L) */
    FC_SUM(1, 1), FC_TIMES(10, 10), FC_TIMES(8, 3),
    FC_SUM(2, 2), FC_TIMES(8, 1), FC_TIMES(8, 1), FC_TIMES(9, 10), FC_TIMES(9, 10),
    FC_SUM(1, 1), FC_TIMES(9, 9), FC_TIMES(8, 0), 0};

/* The sign of a form. */
static FC_COLD int8_t sign_of(const uint8_t *program, const fc_form *form, fc_segment *segment, fc_decision decision) {
  const int64_t *v[3];
  fc_wide *w = &segment->wide;
  uint8_t i, j;
  v[0] = fc_segment_direction(segment);
  v[1] = segment->light;
  v[2] = form->u.sphere.center;
  fc_wide_start(w);
  for (i = 0; i < 3; i++)
    for (j = i; j < 3; j++) {
      fc_i128 dot = fc_i128_dot(v[i], v[j]); /* factors of up to 62 bits */
      fc_wide_push(w, &dot);
    }
  fc_wide_push64(w, form->u.sphere.radius);
  fc_wide_push64(w, 1);
  fc_wide_run(w, program);
  return fc_segment_sign(segment, decision);
}

/* The same as blocked by the rounded point: 1, 0, or -1 when that leaves it open, as everything does far out. */
static FC_COLD int8_t hides_rounded(const fc_form *form, const fc_segment *segment) {
  int32_t point[3];
  uint8_t i;
  if (segment->point_error >> 20 != 0 || fc_vector_bits(segment->point) > 30 || fc_vector_bits(segment->light) > 30) return -1;
  for (i = 0; i < 3; i++) point[i] = (int32_t)segment->point[i];
  return fc_sphere_hides(form, segment->light, point, segment->point_error);
}

static FC_COLD bool blocked(const fc_form *form, fc_segment *segment) {
  int64_t low[3], high[3];
  int8_t light, point;
  bounds(form, low, high);
  if (fc_segment_apart(segment, low, high)) return false;
  light = hides_rounded(form, segment);
  if (light >= 0) return light > 0;
  light = side(form, segment->light);
  /* from outside or from the surface: not where the line turns away at once or misses the sphere */
  if (light >= 0 && (sign_of(ahead, form, segment, FC_DECIDE_PASS) <= 0 || sign_of(met, form, segment, FC_DECIDE_PASS) < 0))
    return false;
  point = sign_of(outside, form, segment, FC_DECIDE_PASS);
  if (light * point < 0) return true;
  /* both ends outside, at most one of them on the surface: between them iff the line's middle in the ball is */
  return light >= 0 && point >= 0 && light + point > 0 && sign_of(away, form, segment, FC_DECIDE_PASS) > 0;
}

static FC_COLD bool facing(const fc_form *form, fc_segment *segment) {
  int8_t turned = sign_of(away, form, segment, FC_DECIDE_FACING);
  if (side(form, fc_eye) > 0) return turned < 0;
  /* from inside (or on it, looking in), the light must be inside too, or the sphere itself is in the way */
  return turned > 0 && side(form, segment->light) <= 0;
}

static FC_COLD void normal(const fc_form *form, const int64_t point[3], int64_t n[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) n[i] = point[i] - form->u.sphere.center[i];
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
    check, memory, extent, place, fetch, prepare, test, blocked, facing, normal,
    side, NULL, depth_range, fc_sphere_project, fc_sphere_window, fc_sphere_draw, fc_sphere_shadow, fc_sphere_between,
    fc_sphere_hides,
    fc_sphere_strip, bounds, NULL, NULL, NULL};
