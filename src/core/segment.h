/*
 * The open segment from a surface point to a light.
 *
 * The point is t times a direction from the eye, which is at 0, with t a root; `point` is its rounding. Decisions are signs of
 * polynomials in t (root.h), so the rounding only helps to leave out what is far away.
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
  uint32_t point_error;     /* per axis; 0: the point is exact; UINT32_MAX: `point` is useless, nothing is left to values and boxes */
  bool outside;             /* the point is outside every closed mesh: what stops the light there stops it with a back face */
  const fc_root *root;      /* NULL: `point` is the exact point */
  const int64_t *direction; /* with root */
  fc_quick t;               /* the root's value, by fc_segment_prepare; 0 without a useful point */
  fc_wide wide;             /* where its decisions are worked out */
} fc_segment;

/* The eye of camera space, where segments are seen from. */
extern const int64_t fc_eye[3];

/* The segment from where a ray from the eye meets a surface to a light; root and direction have to last. */
void fc_segment_from(fc_segment *segment, const fc_root *root, const int64_t direction[3], const int64_t light[3]);

/* Call it whenever light, point or root have changed. */
void fc_segment_prepare(fc_segment *segment);

/* Whether a box low .. high cannot touch the segment: cheap, and most primitives are far off. */
bool fc_segment_apart(const fc_segment *segment, const int64_t low[3], const int64_t high[3]);

/* The point is t times this. */
const int64_t *fc_segment_direction(const fc_segment *segment);

/* fc_root_sign at the segment's point, of the list in segment->wide. */
int8_t fc_segment_sign(fc_segment *segment, fc_decision decision);

/* Rounds origin + t direction to the grid for a t within 2^-24; returns a bound of each coordinate's error, UINT32_MAX beyond 2^53
 * units: then the point is only a stand-in far out in the right direction. Directions below 2^30. */
uint32_t fc_point_near(fc_quick t, const int64_t origin[3], const int64_t direction[3], int64_t point[3]);

/* Rounds origin + t direction to the grid. Returns false when it lies beyond 2^56 units: then the point is only
 * a stand-in far out in the right direction. */
bool fc_point_at(fc_num t, const int64_t origin[3], const int64_t direction[3], int64_t point[3]);

/* Sign of k - n . P for a plane n . x = k: which side the point is on. */
int8_t fc_side_of_point(fc_segment *segment, const int64_t n[3], fc_i128 k);

/* |a.x| + |a.y| + |a.z|, and the dot product, for components up to 2^31 and 2^30: below 2^63. */
int64_t fc_small_norm1(const int64_t a[3]);

/* a . b modulo 2^64. */
int64_t fc_dot(const int64_t a[3], const int64_t b[3]);

static inline int64_t fc_small_dot(const int64_t a[3], const int64_t b[3]) { return fc_dot(a, b); }

void fc_cross(const int64_t a[3], const int64_t b[3], int64_t r[3]);

/* Bits of the largest component. */
uint8_t fc_vector_bits(const int64_t a[3]);

/* v floored to at most 30 bits; returns the shift. */
uint8_t fc_shrink(const int64_t v[3], int64_t r[3]);

#endif
