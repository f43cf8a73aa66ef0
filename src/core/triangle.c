/* Triangles: watertight edge signs, homogeneous in the vertices, so nothing is clipped. */
#include "bits.h"
#include "kind.h"
#include "mesh.h"
#include "mesh_world.h"
#include "scan_kinds.h"
#include "tally.h"
#include "view.h"

static inline void fc_read_world(const fc_shapes *shapes, uint16_t index, fc_vec3 *v) { fc_read_vertex(shapes, index, v); }

void fc_triangle_fetch(const fc_group *group, uint16_t index, fc_form *form) { fetch(group, index, form); }

static uint8_t next(uint8_t i) { return i == 2 ? 0 : (uint8_t)(i + 1); }

static void subtract(const int64_t a[3], const int64_t b[3], int64_t r[3]) {
  r[0] = a[0] - b[0];
  r[1] = a[1] - b[1];
  r[2] = a[2] - b[2];
}

/* (B - A) x (C - A): edges below 2^31, so each component is below 2^63. */
void fc_face_normal(const fc_form *form, int64_t n[3]) {
  int64_t ab[3], ac[3];
  subtract(form->u.triangle.vertex[1], form->u.triangle.vertex[0], ab);
  subtract(form->u.triangle.vertex[2], form->u.triangle.vertex[0], ac);
  fc_cross(ab, ac, n);
}

/* n shrunk to at most 30 bits by floor; *shift is what was dropped. */
static void shrink(const int64_t n[3], int64_t r[3], uint8_t *shift) {
  uint8_t bits = fc_vector_bits(n), i;
  *shift = bits > 30 ? (uint8_t)(bits - 30) : 0;
  for (i = 0; i < 3; i++) r[i] = fc_floor_shift64(n[i], *shift);
}

void fc_triangle_prepare(const fc_form *form, const int64_t origin[3], fc_prepared *prepared) {
  int64_t v[3][3];
  uint8_t i, j;
  for (i = 0; i < 3; i++) subtract(form->u.triangle.vertex[i], origin, v[i]); /* below 2^31 */
  for (i = 0; i < 3; i++) {
    int64_t small[3];
    uint8_t shift;
    fc_cross(v[i], v[next(i)], prepared->u.triangle.edge[i]); /* below 2^63 */
    shrink(prepared->u.triangle.edge[i], small, &shift);
    for (j = 0; j < 3; j++) prepared->u.triangle.filter[i][j] = (int32_t)small[j];
  }
  fc_face_normal(form, prepared->u.triangle.normal);
  prepared->u.triangle.hidden = form->u.triangle.hidden;
  prepared->u.triangle.side = fc_i128_dot(prepared->u.triangle.normal, v[0]); /* 63 + 31 + 2 bits */
}

/* The sign of N . D; 0 is settled by nudging D by (e, e^2, e^3) with e infinitely small, which is the same for both
 * triangles that share the edge: one of them owns the ray. */
static int8_t edge_sign(const fc_prepared *prepared, uint8_t i, const int64_t d[3], int64_t reach) {
  /* Filter: floor(N / 2^s) is short of N / 2^s by less than 1 a component, so the sum is off by less than |D|_1.
   * 30 + 30 bits, three terms: below 2^62. */
  const int32_t *f = prepared->u.triangle.filter[i];
  const int64_t *n = prepared->u.triangle.edge[i];
  int64_t quick = f[0] * d[0] + f[1] * d[1] + f[2] * d[2];
  bool certain = quick >= reach || quick <= -reach;
  int8_t sign;
  FC_TALLY(FC_DECIDE_EDGE, !certain);
  if (certain) return fc_sign64(quick);
  sign = fc_i128_sign(fc_i128_dot(n, d)); /* 63 + 30 + 2 bits */
  if (sign == 0) sign = fc_sign64(n[0]);
  if (sign == 0) sign = fc_sign64(n[1]);
  if (sign == 0) sign = fc_sign64(n[2]);
  return sign;
}

uint8_t fc_triangle_test(const fc_prepared *prepared, const int64_t direction[3], fc_root *root) {
  int64_t reach = fc_small_norm1(direction);
  int8_t side = fc_i128_sign(prepared->u.triangle.side);
  fc_i128 along;
  if (side == 0 || side == prepared->u.triangle.hidden || edge_sign(prepared, 0, direction, reach) != side ||
      edge_sign(prepared, 1, direction, reach) != side ||
      edge_sign(prepared, 2, direction, reach) != side)
    return 0;
  /* The edge forms add up to normal . direction, which therefore has the sign of `side` too. */
  along = fc_i128_dot(prepared->u.triangle.normal, direction);
  if (fc_i128_sign(along) != side) return 0;
  root->p = fc_i128_abs(prepared->u.triangle.side);
  root->m = fc_i128_abs(along);
  root->d = root->c = fc_i128_from(0);
  root->q = 0;
  return 1;
}

/* One axis: coordinates of 30 bits and a sign. */
static inline void bound(const fc_form *form, uint8_t axis, int64_t low[3], int64_t high[3]) {
  const int32_t a = (int32_t)form->u.triangle.vertex[0][axis], b = (int32_t)form->u.triangle.vertex[1][axis],
                c = (int32_t)form->u.triangle.vertex[2][axis];
  int32_t least = a < b ? a : b, most = a < b ? b : a;
  if (c < least) least = c;
  if (c > most) most = c;
  low[axis] = least;
  high[axis] = most;
}

void fc_triangle_bounds(const fc_form *form, int64_t low[3], int64_t high[3]) {
  bound(form, 0, low, high);
  bound(form, 1, low, high);
  bound(form, 2, low, high);
}

/* 63 + 62 bits, three products below 2^127. */
FC_COLD int8_t fc_triangle_side(const fc_form *form, const int64_t point[3]) {
  int64_t n[3], a[3];
  fc_face_normal(form, n);
  subtract(point, form->u.triangle.vertex[0], a);
  return fc_i128_sign(fc_i128_dot(n, a));
}

/* Edge signs of the line from the light L through the point P = t D: is it inside the closed triangle? */
static FC_COLD bool pierced(const fc_form *form, fc_segment *segment) {
  /* N.(P - L) with N = (A - L) x (B - A): 0 .. 2 A - L, 3 .. 5 B - A, 6 .. 8 D, 9 .. 11 L */
  static const uint8_t program[] FC_ROM = {
      FC_SUM(1, 1), FC_TIMES(1, 5), FC_TIMES(2, 4), /* 12 .. 14: N */
      FC_SUM(1, 1), FC_TIMES(2, 3), FC_TIMES(0, 5), FC_SUM(1, 1), FC_TIMES(0, 4), FC_TIMES(1, 3),
      FC_SUM(0, 3), FC_TIMES(12, 9), FC_TIMES(13, 10), FC_TIMES(14, 11),
      FC_SUM(3, 0), FC_TIMES(12, 6), FC_TIMES(13, 7), FC_TIMES(14, 8),
      FC_SUM(1, 1), FC_TIMES(3, 3), FC_TIMES(3, 3), 0};
  int8_t seen = 0;
  uint8_t i, j, k;
  for (i = 0; i < 3; i++) {
    int64_t v[2][3];
    fc_wide *w = &segment->wide;
    int8_t sign;
    subtract(form->u.triangle.vertex[i], segment->light, v[0]);
    subtract(form->u.triangle.vertex[next(i)], form->u.triangle.vertex[i], v[1]);
    fc_wide_start(w);
    for (j = 0; j < 4; j++)
      for (k = 0; k < 3; k++) fc_wide_push64(w, (j < 2 ? v[j] : j == 2 ? fc_segment_direction(segment)
                                                                       : segment->light)[k]);
    fc_wide_run(w, program);
    sign = fc_segment_sign(segment, FC_DECIDE_PIERCE);
    if (sign * seen < 0) return false;
    if (sign != 0) seen = sign;
  }
  return true;
}

FC_COLD bool fc_triangle_blocked(const fc_form *form, fc_segment *segment) {
  int64_t n[3], low[3], high[3];
  int8_t light;
  fc_triangle_bounds(form, low, high);
  if (fc_segment_apart(segment, low, high)) return false;
  light = fc_triangle_side(form, segment->light);
  if (light == 0 || (form->u.triangle.hidden != 0 && segment->outside && light == form->u.triangle.hidden) ||
      !pierced(form, segment))
    return false;
  /* last: a point in the plane of a neighbour has no quick answer */
  fc_face_normal(form, n);
  return fc_side_of_point(segment, n, fc_i128_dot(n, form->u.triangle.vertex[0])) == light;
}

FC_COLD bool fc_triangle_facing(const fc_form *form, fc_segment *segment) {
  return fc_triangle_side(form, fc_eye) * fc_triangle_side(form, segment->light) > 0;
}

FC_COLD void fc_triangle_normal(const fc_form *form, const int64_t point[3], int64_t n[3]) {
  (void)point;
  fc_face_normal(form, n);
}

void fc_triangle_weights(const fc_prepared *prepared, const int64_t direction[3], uint32_t weight_q30[3]) {
  /* vertex i is opposite edge i + 1; the edge forms add up to normal . direction */
  fc_num whole = fc_num_from_abs(fc_i128_dot(prepared->u.triangle.normal, direction));
  uint8_t i;
  for (i = 0; i < 3; i++) {
    fc_num part = fc_num_from_abs(fc_i128_dot(prepared->u.triangle.edge[next(i)], direction));
    weight_q30[i] = (uint32_t)fc_num_round(fc_num_div(part, whole), 30);
  }
}

/* Of all vertices, if they are in front of the eye; false otherwise. */
static bool vertex_range(const fc_group *group, uint32_t *near, uint32_t *far) {
  const fc_placed_vertex *v = fc_mesh_vertices(group->memory), *end = v + group->shapes.vertex_count;
  int32_t low = INT32_MAX, high = 0;
  for (; v != end; v++) {
    if (v->p[2] < low) low = v->p[2];
    if (v->p[2] > high) high = v->p[2];
  }
  *near = (uint32_t)low;
  *far = (uint32_t)high;
  return low > 0;
}

void fc_triangle_depth_range(const fc_frame *frame, const fc_group *group, uint64_t *near, uint64_t *far) {
  const fc_placed_vertex *placed = fc_mesh_vertices(group->memory);
  uint32_t least, most;
  uint16_t i;
  (void)frame;
  if (group->shapes.count == 0) return;
  if (vertex_range(group, &least, &most)) {
    if (least < *near) *near = least;
    if (most > *far) *far = most;
    return;
  }
  for (i = 0; i < group->shapes.count; i++) {
    fc_triangle t;
    int32_t low, high;
    uint8_t j;
    fc_read_triangle(&group->shapes, i, &t);
    low = high = placed[t.vertex[0]].p[2];
    for (j = 1; j < 3; j++) {
      int32_t z = placed[t.vertex[j]].p[2];
      if (z < low) low = z;
      if (z > high) high = z;
    }
    if (high <= 0) continue;
    if (low <= 0 || (uint32_t)low < *near) *near = low > 0 ? (uint32_t)low : 0;
    if ((uint32_t)high > *far) *far = (uint32_t)high;
  }
}

const fc_kind fc_kind_triangle FC_ROM = FC_KIND_OF_TRIANGLES(check, extent, place, fc_triangle_fetch);

/* The same, but for its shadow (outline.c). */
const fc_kind fc_kind_convex FC_ROM = {check,
                                       fc_convex_memory,
                                       extent,
                                       place,
                                       fc_triangle_fetch,
                                       fc_triangle_prepare,
                                       fc_triangle_test,
                                       fc_triangle_blocked,
                                       fc_triangle_facing,
                                       fc_triangle_normal,
                                       fc_triangle_side,
                                       fc_triangle_weights,
                                       fc_triangle_depth_range,
                                       fc_convex_project,
                                       NULL, /* window, draw: strips are drawn whole */
                                       NULL,
                                       fc_triangle_shadow,
                                       fc_triangle_between,
                                       NULL,
                                       fc_convex_strip,
                                       fc_triangle_bounds,
                                       fc_triangle_casts,
                                       fc_convex_cast,
                                       fc_convex_settle};
