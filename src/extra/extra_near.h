/* What is within a distance of what: points, segments and triangles of up to 47-bit coordinates, decided exactly. */
#ifndef FC_EXTRA_NEAR_H
#define FC_EXTRA_NEAR_H

#include <stdbool.h>
#include <stdint.h>

/* Coordinates below 2^47, distance r below 2^47; closed: at the distance is within it. */

/* A point and a segment. */
bool fc_point_near_segment(const int64_t p[3], const int64_t a[3], const int64_t b[3], int64_t r);

/* Two segments, where neither's nearest point is an end of it; false otherwise. */
bool fc_segments_near_inside(const int64_t a[3], const int64_t b[3], const int64_t c[3], const int64_t d[3], int64_t r);

/* A point and the face of a triangle, where its foot on the plane is in the triangle; false otherwise, and without area. `edge` are the
 * edges in any unit that leaves them 31 bits: edge[i] from vertex[i] to vertex[i + 1]. */
bool fc_point_near_face(const int64_t p[3], int64_t vertex[3][3], int64_t edge[3][3], int64_t r);

/* Whether a segment goes through a triangle from one side to the other; false where an end lies in the plane, and without area. */
bool fc_segment_pierces(const int64_t a[3], const int64_t b[3], int64_t vertex[3][3], int64_t edge[3][3]);

#endif
