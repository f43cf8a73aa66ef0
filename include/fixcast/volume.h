/*
 * Primitives and bounding volumes against each other, decided exactly.
 *
 * Every answer is that of exact arithmetic on the integers given, for all coordinates within +-FC_COORDINATE_MAX: no epsilon, nothing
 * is rounded. All sets are closed: what touches in a single point meets. Volumes have their insides; a triangle without area is the
 * segment or the point that is left of it, and a box may be flat.
 *
 * Functions return 1 (they meet), 0 (they do not), an fc_side, or an error: FC_ERR_NULL; FC_ERR_COORDINATE, beyond +-FC_COORDINATE_MAX or
 * a box whose low exceeds its high; FC_ERR_RADIUS, below 1; FC_ERR_NORMAL, a plane's normal of zero; FC_ERR_EXPONENT, d_exponent outside
 * 0..32; FC_ERR_DIRECTION, a ray's direction of zero. Each function links on its own; arguments are in RAM. A hierarchy of a scene does
 * not use them (bvh.h): these are for the program around it, for picking, culling and collisions.
 *
 * Formulas are those of the lecture "Sampling and Object intersection" (Doggett) unless a source is named; bits stand at each product in
 * src/core/volume_*.c.
 */
#ifndef FIXCAST_VOLUME_H
#define FIXCAST_VOLUME_H

#include <stdint.h>

#include "fixcast/error.h"
#include "fixcast/scene.h"
#include "fixcast/vec3.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An axis-aligned box: low <= p <= high on each axis. */
typedef struct fc_aabb {
  fc_vec3 low, high;
} fc_aabb;

/* Where a ray is inside: enter / enter_of <= t <= leave / leave_of, exact; both denominators positive, fractions not reduced. t is measured
 * in lengths of the direction, as in ray.h. */
typedef struct fc_span {
  int64_t enter, enter_of, leave, leave_of;
} fc_span;

/* Which side of a plane n . p + d = 0 something is on; n points to the front. */
typedef enum fc_side {
  FC_SIDE_ON = 0, /* on it, across it, or touching it */
  FC_SIDE_FRONT = 1,
  FC_SIDE_BACK = 2
} fc_side;

/* The ray origin + t direction, t >= 0, against a box by slabs (Kay and Kajiya 1986): of each axis (low - o) / d <= t <= (high - o) / d or the
 * other way about, keep the greatest entry and the least exit; a ray parallel to an axis is between its two planes or misses. *span may be
 * NULL; written on a hit alone. From inside, the entry is 0. */
int fc_ray_aabb(const fc_vec3 *origin, const fc_vec3 *direction, const fc_aabb *box, fc_span *span);

/* The sign of n . p + d. */
int fc_point_plane(const fc_vec3 *point, const fc_plane *plane);

/* |n . c + d| against r |n|, as squares. */
int fc_sphere_plane(const fc_sphere *sphere, const fc_plane *plane);

/* The two corners on the diagonal that is most aligned with the normal are farthest in front and behind (Haines and Wallace 1991). */
int fc_aabb_plane(const fc_aabb *box, const fc_plane *plane);

/* |c1 - c2|^2 against (r1 + r2)^2. */
int fc_sphere_sphere(const fc_sphere *a, const fc_sphere *b);

/* Intervals overlap on each axis. */
int fc_aabb_aabb(const fc_aabb *a, const fc_aabb *b);

/* By separating axes (Akenine-Moller 2001): the box's 3, the triangle's normal, and 9 cross products of an axis and an edge. */
int fc_triangle_aabb(const fc_vec3 triangle[3], const fc_aabb *box);

#ifdef __cplusplus
}
#endif

#endif
