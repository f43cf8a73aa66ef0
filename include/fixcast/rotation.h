/*
 * Integer rotations for things that turn: from an angle, from two directions, and from a mouse that drags a ball.
 *
 * A rotation is a unit quaternion w + x i + y j + z k in Q30 (Hamilton 1843): the turn by 2 acos(w) about (x, y, z), counter-clockwise
 * when seen against that axis. q and -q are the same rotation. No floating point, no table of the machine's: the same bits everywhere.
 *
 * Stated bounds (radians and ratios; tests: volume_rotation, volume_trackball):
 *   sine          within 2^-30 of the real one, exact at whole quarter turns, odd and symmetric to the last bit
 *   length        | |q| - 1 | <= 2^-29 for what these functions return, after any number of compositions
 *   composition   each adds at most 2^-29 radians to the angle that separates the result from the exact product
 *   matrix        each entry within 2^-30 of the rotation that q / |q| stands for; |M M' - I| <= 2^-29 an entry
 *   points        each coordinate within 1/2 + 2^-30 (|dx| + |dy| + |dz|) of the exact rotation of the distance d from the pivot
 */
#ifndef FIXCAST_ROTATION_H
#define FIXCAST_ROTATION_H

#include <stdint.h>

#include "fixcast/error.h"
#include "fixcast/vec3.h"

#ifdef __cplusplus
extern "C" {
#endif

/* 1.0 of a rotation's or matrix's component. */
#define FC_ONE_Q30 (INT32_C(1) << 30)

/* Each component within +-2^30; functions refuse what is not of unit length within 2^-28 (FC_ERR_ROTATION). */
typedef struct fc_rotation {
  int32_t w, x, y, z; /* Q30 */
} fc_rotation;

/* For initialisers: no rotation at all. */
#define FC_ROTATION_NONE \
  { FC_ONE_Q30, 0, 0, 0 }

/* Rows times a column vector: to_i = sum over j of row[i][j] from_j. */
typedef struct fc_matrix {
  int32_t row[3][3]; /* Q30, within +-2^30 */
} fc_matrix;

/* sin(2 pi angle / 2^32), Q30: 17 sines from 0 to a quarter turn and the addition theorem with Taylor's series in between. */
int32_t fc_sin_q30(uint32_t angle_q32);
static inline int32_t fc_cos_q30(uint32_t angle_q32) { return fc_sin_q30(angle_q32 + (UINT32_C(1) << 30)); }

/* The turn by angle / 2^16 of a whole turn about an axis of any length but 0: (cos a/2, sin a/2 axis / |axis|) (Euler, Rodrigues
 * 1840), each component within 2^-29. FC_ERR_DIRECTION: the axis is zero; FC_ERR_COORDINATE: a coordinate of it is beyond +-2^30. */
int fc_rotation_about(fc_rotation *rotation, const fc_vec3 *axis, uint16_t angle);

/* The shortest turn that takes one direction to another, both of any length but 0: (|a||b| + a.b, a x b) made unit, each component
 * within 2^-30. Opposite directions: half a turn about an axis across them. From b to a it is the exact inverse. Errors as above. */
int fc_rotation_between(fc_rotation *rotation, const fc_vec3 *from, const fc_vec3 *to);

/* First one, then the other: result = second * first, made unit again. result may be either of them. */
int fc_rotation_compose(fc_rotation *result, const fc_rotation *second, const fc_rotation *first);

/* The way back, exact to the bit. */
int fc_rotation_invert(fc_rotation *result, const fc_rotation *rotation);

/* The matrix that turns column vectors as the rotation does. FC_ERR_ROTATION, FC_ERR_NULL. */
int fc_rotation_matrix(fc_matrix *matrix, const fc_rotation *rotation);

/*
 * Turns points about a pivot: to[i] = pivot + M (from[i] - pivot), rounded to nearest.
 *
 * `from` is a model at rest, read as plain memory (flash too, where that is in the data address space; not through FC_READ): turn all of it for
 * each frame, so that errors do not add up. `to` may be `from`. `pivot` NULL: the origin (for directions). FC_ERR_COORDINATE: a point is out of
 * range, before or after; nothing is written then. FC_ERR_ROTATION: an entry of the matrix is beyond +-2^30.
 */
int fc_rotate_points(fc_vec3 *to, const fc_vec3 *from, uint16_t count, const fc_matrix *matrix, const fc_vec3 *pivot);

/*
 * The virtual trackball: a glass ball behind the screen that the mouse rolls (lecture "Sampling, Virtual Trackball, Hidden Surfaces", Munzner;
 * Chen, Mountford, Sellen 1988).
 *
 * A mouse position is a place on the screen, counted from the ball's centre: x to the right, y up, in any unit (half pixels, say); the
 * third axis points at the viewer. Up to radius / sqrt(2) it lies on the sphere, z = sqrt(r^2 - d^2), and beyond on the hyperbola
 * z = r^2 / (2 d), which goes on where the sphere's rim ends, without a kink (Bell; Holroyd 2008). Farther than FC_TRACKBALL_REACH
 * radii counts as FC_TRACKBALL_REACH radii: the ball then turns about the line of sight alone.
 */
#define FC_TRACKBALL_MAX INT32_C(65535) /* of |x|, |y| and the radius */
/* In radii, how far out the trackball still tilts. */
#define FC_TRACKBALL_REACH 16

/* The point of the ball under the mouse, unit length in Q30, each component within 2^-30. FC_ERR_SIZE: x or y beyond
 * FC_TRACKBALL_MAX, or a radius outside 1..FC_TRACKBALL_MAX. */
int fc_trackball_point(fc_vec3 *point_q30, int32_t x, int32_t y, int32_t radius);

/*
 * What dragging the mouse from one place to another does: the turn that takes the one point of the ball to the other, about p1 x p2.
 * Components within 2^-29 / cos(angle / 2); back again is the exact inverse; staying is no rotation at all. A view that follows the mouse
 * composes it with what it had when the button went down, so that dragging there and back restores that to the bit.
 */
int fc_trackball_drag(fc_rotation *rotation, int32_t from_x, int32_t from_y, int32_t to_x, int32_t to_y, int32_t radius);

#ifdef __cplusplus
}
#endif

#endif
