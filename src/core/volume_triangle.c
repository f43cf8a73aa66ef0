/* Triangles against boxes, by separating axes. */
#include <stddef.h>

#include "bits.h"
#include "i128.h"
#include "segment.h"
#include "volume.h"

/* Whether triangle and box lie apart on an axis of at most two components below 2^31: projections below 2^62. */
static FC_COLD bool apart(int64_t vertex[3][3], const int64_t low[3], const int64_t high[3], const int64_t axis[3]) {
  int64_t least[3], greatest[3], from, to;
  uint8_t i, above = 0, below = 0;
  fc_box_extremes(least, greatest, low, high, axis);
  from = fc_dot(axis, least);
  to = fc_dot(axis, greatest);
  for (i = 0; i < 3; i++) {
    const int64_t at = fc_dot(axis, vertex[i]);
    above = (uint8_t)(above + (at > to));
    below = (uint8_t)(below + (at < from));
  }
  return above == 3 || below == 3;
}

/* Whether the box lies on one side of the triangle's plane; never when the triangle has no area. */
static FC_COLD bool apart_from_plane(int64_t vertex[3][3], int64_t edge[3][3], const int64_t low[3], const int64_t high[3]) {
  int64_t n[3], least[3], greatest[3];
  fc_i128 at;
  fc_cross(edge[0], edge[1], n); /* edges up to 2^31 - 2: products' difference at most 2 (2^31 - 2)^2 < 2^63 */
  fc_box_extremes(least, greatest, low, high, n);
  at = fc_i128_dot(n, vertex[0]); /* 3 * 63 + 30 bits */
  return fc_i128_compare(at, fc_i128_dot(n, least)) < 0 || fc_i128_compare(at, fc_i128_dot(n, greatest)) > 0;
}

/*
 * All 13 axes stay the right ones when box or triangle lose a dimension. A flat box is the limit of boxes a little larger, whose axes
 * are the same, and what closed sets meet in the limit they meet; a triangle that is a segment has no normal, and box against segment
 * needs the box's axes and the cross products only; a point the box's axes only.
 */
FC_COLD int fc_triangle_aabb(const fc_vec3 triangle[3], const fc_aabb *box) {
  int64_t vertex[3][3], edge[3][3], low[3], high[3], axis[3];
  uint8_t i, k;
  int error = triangle == NULL ? FC_ERR_NULL : fc_volume_load_box(low, high, box);
  for (i = 0; i < 3 && error == FC_OK; i++) error = fc_volume_load(vertex[i], triangle + i);
  if (error != FC_OK) return error;
  for (i = 0; i < 3; i++)
    for (k = 0; k < 3; k++) edge[i][k] = vertex[(i + 1) % 3][k] - vertex[i][k]; /* 31 bits */
  for (k = 0; k < 3; k++) {
    axis[0] = axis[1] = axis[2] = 0;
    axis[k] = 1;
    if (apart(vertex, low, high, axis)) return 0;
  }
  if (apart_from_plane(vertex, edge, low, high)) return 0;
  for (i = 0; i < 3; i++)
    for (k = 0; k < 3; k++) { /* unit vector k x edge i */
      axis[k] = 0;
      axis[(k + 1) % 3] = -edge[i][(k + 2) % 3];
      axis[(k + 2) % 3] = edge[i][(k + 1) % 3];
      if (apart(vertex, low, high, axis)) return 0;
    }
  return 1;
}
