/*
 * More volumes, and volumes that move: convex bodies, slabs in any direction, spheres swept over a time step. Decided exactly.
 *
 * Conventions, ranges and errors are volume.h's: closed sets, touching counts, 1 or 0 or an error. These live in src/extra, apart from the
 * core: for the programs of hosts and larger chips. Arguments are in RAM.
 */
#ifndef FIXCAST_VOLUME_EXTRA_H
#define FIXCAST_VOLUME_EXTRA_H

#include <stdint.h>

#include "fixcast/error.h"
#include "fixcast/rotation.h"
#include "fixcast/scene.h"
#include "fixcast/vec3.h"
#include "fixcast/volume.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- convex bodies ---- */

/*
 * The hull of some points, with all of its faces and edges: three vertices of each face that are not in line, in any order, and the two
 * ends of each edge. It may be flat (a polygon with one face and its edges), a segment (no face, one edge) or a point. Convexity and
 * completeness are the author's word.
 */
typedef struct fc_polytope {
  const fc_vec3 *vertices;
  const uint16_t (*faces)[3];
  const uint16_t (*edges)[2];
  uint16_t vertex_count, face_count, edge_count; /* vertex_count at least 1, or FC_ERR_COUNT */
} fc_polytope;

/* By separating axes (lecture "Sampling and Object intersection"; Gottschalk 1996): normals of faces, cross products of an edge of each,
 * and, for what is flat, the axes and their cross products with edges. FC_ERR_INDEX: a face or an edge names a vertex that does not
 * exist. Work is the product of the numbers of edges times the number of vertices. */
int fc_convex_convex(const fc_polytope *a, const fc_polytope *b);

/* ---- slabs: oriented boxes and k-DOPs ---- */

/* The points with low <= normal . p <= high. normal: any length but 0, each component within +-2^30 (unit axes in Q30 may come); bounds within
 * +-2^62; low above high is FC_ERR_COORDINATE. */
typedef struct fc_slab {
  fc_vec3 normal;
  int64_t low, high;
} fc_slab;

/* A ray against what lies in all of count slabs, 1..255: an oriented box has 3, a k-DOP k / 2 (Kay and Kajiya 1986; Klosowski 1998). Exact. A
 * volume that is open along the ray has leave_of = 0. FC_ERR_COUNT: no slab. */
int fc_ray_slabs(const fc_vec3 *origin, const fc_vec3 *direction, const fc_slab *slabs, uint8_t count, fc_span *span);

/* Whether a point lies within all of the slabs, borders included: 1 or 0. FC_ERR_COUNT: no slab. */
int fc_point_slabs(const fc_vec3 *point, const fc_slab *slabs, uint8_t count);

/* Whether two volumes' slabs of the same normals, in the same order, all overlap. 0 says for certain that the volumes do not meet; 1 is
 * what bounding volumes say. FC_ERR_NORMAL: the normals differ. */
int fc_slabs_slabs(const fc_slab *a, const fc_slab *b, uint8_t count);

/* Sets low and high of slabs whose normals are given to the least k-DOP around some points, at least one. FC_OK or an error. */
int fc_slabs_fit(fc_slab *slabs, uint8_t count, const fc_vec3 *points, uint16_t point_count);

/* The box of three slabs that reaches half a side from its center to both sides along each row of a matrix: |row . (p - center)| <= half 2^30.
 * half: 0..FC_COORDINATE_MAX on each axis. The box is these slabs, exactly; rows are unit vectors within what rotation.h says. */
int fc_slabs_of_box(fc_slab slabs[3], const fc_vec3 *center, const fc_vec3 *half, const fc_matrix *axes);

/* ---- spheres over a time step ---- */

/*
 * Things move in a straight line from where they are to `to` while t goes from 0 to 1. Do they touch in 0 <= t <= 1? Decided exactly. *t_q16, when
 * not NULL and the answer is 1, is the first of the ticks k / 2^16 at or before which there was contact: the time of contact is in
 * (k - 1, k] / 2^16, at tick k - 1 everything was still apart, and 0 means in contact from the start. Exact too, by bisection
 * of the decision: 17 of them.
 */
int fc_sweep_sphere_plane(const fc_sphere *sphere, const fc_vec3 *to, const fc_plane *plane, uint32_t *t_q16);

/* Both move. |p + t v| against r1 + r2, p and v relative. */
int fc_sweep_sphere_sphere(const fc_sphere *a, const fc_vec3 *a_to, const fc_sphere *b, const fc_vec3 *b_to, uint32_t *t_q16);

/* The capsule that the sphere sweeps against the triangle, inside and edges (Ericson 2005, 5.5): the path crosses the face, or an end of
 * it is within r of the face, or the path is within r of an edge. */
int fc_sweep_sphere_triangle(const fc_sphere *sphere, const fc_vec3 *to, const fc_vec3 triangle[3], uint32_t *t_q16);

#ifdef __cplusplus
}
#endif

#endif
