/* Convex bodies against each other, by separating axes. */
#include <stdbool.h>
#include <stddef.h>

#include "bits.h"
#include "fixcast/volume_extra.h"
#include "i128.h"
#include "segment.h"
#include "view.h"
#include "volume.h"

static int check(const fc_polytope *p) {
  int64_t v[3];
  uint16_t i;
  if (p == NULL || p->vertices == NULL || (p->face_count > 0 && p->faces == NULL) || (p->edge_count > 0 && p->edges == NULL))
    return FC_ERR_NULL;
  if (p->vertex_count == 0) return FC_ERR_COUNT;
  for (i = 0; i < p->vertex_count; i++)
    if (!fc_load(p->vertices + i, v)) return FC_ERR_COORDINATE;
  for (i = 0; i < p->face_count; i++)
    if (p->faces[i][0] >= p->vertex_count || p->faces[i][1] >= p->vertex_count || p->faces[i][2] >= p->vertex_count)
      return FC_ERR_INDEX;
  for (i = 0; i < p->edge_count; i++)
    if (p->edges[i][0] >= p->vertex_count || p->edges[i][1] >= p->vertex_count) return FC_ERR_INDEX;
  return FC_OK;
}

/* The least and the greatest projection on an axis of up to 64 bits: three products of 63 + 30 bits. */
static void project(fc_i128 *least, fc_i128 *greatest, const fc_polytope *p, const int64_t axis[3]) {
  int64_t v[3];
  uint16_t i;
  for (i = 0; i < p->vertex_count; i++) {
    fc_i128 at;
    (void)fc_load(p->vertices + i, v);
    at = fc_i128_dot(axis, v);
    if (i == 0 || fc_i128_compare(at, *least) < 0) *least = at;
    if (i == 0 || fc_i128_compare(at, *greatest) > 0) *greatest = at;
  }
}

static bool apart(const fc_polytope *a, const fc_polytope *b, const int64_t axis[3]) {
  fc_i128 a_least, a_greatest, b_least, b_greatest;
  project(&a_least, &a_greatest, a, axis);
  project(&b_least, &b_greatest, b, axis);
  return fc_i128_compare(a_greatest, b_least) < 0 || fc_i128_compare(b_greatest, a_least) < 0;
}

/* From one vertex to another: 31 bits. */
static void between(int64_t to[3], const fc_polytope *p, uint16_t from, uint16_t end) {
  int64_t a[3];
  uint8_t i;
  (void)fc_load(p->vertices + from, a);
  (void)fc_load(p->vertices + end, to);
  for (i = 0; i < 3; i++) to[i] -= a[i];
}

/* Axes of the one body alone: its faces' normals, and unit vectors times its edges. */
static bool apart_by_own(const fc_polytope *own, const fc_polytope *a, const fc_polytope *b) {
  int64_t u[3], v[3], axis[3];
  uint16_t i;
  uint8_t k;
  for (i = 0; i < own->face_count; i++) {
    between(u, own, own->faces[i][0], own->faces[i][1]);
    between(v, own, own->faces[i][0], own->faces[i][2]);
    fc_cross(u, v, axis); /* differences up to 2^31 - 2: at most 2 (2^31 - 2)^2 < 2^63 */
    if (apart(a, b, axis)) return true;
  }
  for (i = 0; i < own->edge_count; i++) {
    between(u, own, own->edges[i][0], own->edges[i][1]);
    for (k = 0; k < 3; k++) {
      axis[k] = 0;
      axis[(k + 1) % 3] = -u[(k + 2) % 3];
      axis[(k + 2) % 3] = u[(k + 1) % 3];
      if (apart(a, b, axis)) return true;
    }
  }
  return false;
}

/*
 * a and b meet iff 0 is in the body D of all differences. If D has a volume, its faces are parallel to a face of a or b, or to an edge of each.
 * If D is flat, its plane's normal is a face's or a cross product of two edges, and within the plane its sides are parallel to edges: the
 * plane through such a side and a unit vector off the plane separates what the side separates. If D is in line, the cross products with
 * the three unit vectors span what is across it, and one of the axes runs along it. Every axis asked is a right one for any body.
 */
int fc_convex_convex(const fc_polytope *a, const fc_polytope *b) {
  int64_t u[3], v[3], axis[3];
  uint16_t i, j;
  uint8_t k;
  int error = check(a);
  if (error == FC_OK) error = check(b);
  if (error != FC_OK) return error;
  for (k = 0; k < 3; k++) {
    axis[0] = axis[1] = axis[2] = 0;
    axis[k] = 1;
    if (apart(a, b, axis)) return 0;
  }
  if (apart_by_own(a, a, b) || apart_by_own(b, a, b)) return 0;
  for (i = 0; i < a->edge_count; i++) {
    between(u, a, a->edges[i][0], a->edges[i][1]);
    for (j = 0; j < b->edge_count; j++) {
      between(v, b, b->edges[j][0], b->edges[j][1]);
      fc_cross(u, v, axis); /* as above */
      if (apart(a, b, axis)) return 0;
    }
  }
  return 1;
}
