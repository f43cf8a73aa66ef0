/* What the volume tests share: arguments read and checked, spans of rays, corners of boxes. */
#ifndef FC_VOLUME_H
#define FC_VOLUME_H

#include <stdbool.h>
#include <stdint.h>

#include "fixcast/volume.h"

/* Coordinates of an argument; FC_OK or what is wrong with it, as the public header says. */
int fc_volume_load(int64_t to[3], const fc_vec3 *point);
int fc_volume_load_direction(int64_t to[3], const fc_vec3 *direction);
int fc_volume_load_box(int64_t low[3], int64_t high[3], const fc_aabb *box);
int fc_volume_check_sphere(const fc_sphere *sphere);
int fc_volume_check_plane(const fc_plane *plane);

/* n . p + d of a checked plane and a point in range: 3 * 2^60 + 2^62, below 2^63. */
int64_t fc_plane_value(const fc_plane *plane, const int64_t point[3]);

/* All t >= 0. */
void fc_span_start(fc_span *span);

/* Keeps the t with low <= speed t <= high, all below 2^63; false when none is left. */
bool fc_span_cut(fc_span *span, int64_t low, int64_t high, int64_t speed);

/* The box's corners with the least and the greatest projection on an axis: the diagonal most aligned with it. */
void fc_box_extremes(int64_t least[3], int64_t greatest[3], const int64_t low[3], const int64_t high[3], const int64_t axis[3]);

#endif
