/*
 * The open segment from a surface point to a light, in a form that filters and exact fallbacks share.
 *
 * The point is exact as origin + t direction with t a root; `point` is its rounding. Only when a filter cannot
 * decide on the rounding is the exact point spelled out: m P = u + v sqrt(d) with whole numbers.
 */
#ifndef FC_SEGMENT_H
#define FC_SEGMENT_H

#include <stdbool.h>
#include <stdint.h>

#include "bits.h"
#include "root.h"
#include "wide.h"

/* Grid units throughout. */
typedef struct fc_segment {
  int64_t light[3];         /* exact, below 2^63 */
  int64_t point[3];         /* rounded, below 2^60 */
  uint8_t point_error;      /* per axis: 0 (the point is exact) or 1 */
  bool point_valid;         /* false: too far away for `point`; only the exact form holds */
  bool outside;             /* the point is outside every closed mesh: what stops the light there stops it with a back face */
  const fc_root *root;      /* NULL: `point` is the exact point */
  const int64_t *origin, *direction; /* with root */
  /* The filters' view of it, filled by fc_segment_prepare: */
  uint8_t unit;             /* in units of 2^unit, light and point are below 2^30 */
  int64_t w[3];             /* floor of point - light in those units, below 2^31 */
  int64_t length;           /* |w|_1 */
  int64_t low[3], high[3];  /* a box around the segment, its error included */
} fc_segment;

/* Fills the filters' part; call it whenever light or point have changed. */
void fc_segment_prepare(fc_segment *segment);

/* Whether a box low .. high cannot touch the segment: cheap, and most primitives are far off. */
static inline bool fc_segment_apart(const fc_segment *segment, const int64_t low[3], const int64_t high[3]) {
  return segment->point_valid &&
         (high[0] < segment->low[0] || low[0] > segment->high[0] || high[1] < segment->low[1] ||
          low[1] > segment->high[1] || high[2] < segment->low[2] || low[2] > segment->high[2]);
}

/* Rounds origin + t direction to the grid. Returns false when it lies beyond 2^56 units: then the point is only
 * a stand-in far out in the right direction. */
bool fc_point_at(fc_num t, const int64_t origin[3], const int64_t direction[3], int64_t point[3]);

/* m P = u + v sqrt(d). */
typedef struct fc_exact_point {
  fc_wide u[3], v[3], m, d;
} fc_exact_point;

void fc_exact_point_of(fc_exact_point *p, const fc_segment *segment);

/* Sign of k - n . P for a plane n . x = k: which side the point is on. */
int8_t fc_side_of_point(const fc_segment *segment, const int64_t n[3], fc_i128 k);

/* Moves a point within 1 unit an axis of the plane n . x = k to its front (n . x > k) or, with `behind`, its back, along
 * the dominant axis of n. |n| below 2^63, n . x below 2^97. */
void fc_step_off_plane(const int64_t n[3], fc_i128 k, bool behind, int64_t point[3]);

/* |a.x| + |a.y| + |a.z| */
fc_i128 fc_norm1(const int64_t a[3]);

/* The same, and the dot product, for components up to 2^31 and 2^30: below 2^63. */
static inline int64_t fc_small_norm1(const int64_t a[3]) {
  return (int64_t)(fc_abs64(a[0]) + fc_abs64(a[1]) + fc_abs64(a[2]));
}

static inline int64_t fc_small_dot(const int64_t a[3], const int64_t b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void fc_cross(const int64_t a[3], const int64_t b[3], int64_t r[3]);

/* Bits of the largest component. */
uint8_t fc_vector_bits(const int64_t a[3]);

#endif
