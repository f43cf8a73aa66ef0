/* From world to camera: orthonormal rows in Q30 and one rounding a coordinate. */
#ifndef FC_VIEW_H
#define FC_VIEW_H

#include <stdbool.h>
#include <stdint.h>

#include "fixcast/render.h"
#include "i128.h"
#include "num.h"
#include "root.h"

/* Rows, eye and pixel directions from a camera (view->shift is set later); FC_OK or an error. */
int fc_view_from_camera(fc_view *view, const fc_camera *camera, uint16_t width, uint16_t height);

/* Whether a camera's field of view is within its range. */
bool fc_view_tangent_valid(const fc_camera *camera);

/* The world point v * 2^exponent in camera space, rounded to the camera grid; false when beyond 2^62 units. */
bool fc_view_point(const fc_view *view, const fc_vec3 *v, int8_t exponent, int64_t point[3]);

/* A world vector in camera axes, times 2^30: components up to 2^30, or longer ones whose length is below 2^32. */
void fc_view_turn(const fc_view *view, const int64_t world[3], int64_t camera[3]);

/* The point t * direction of camera space in world coordinates, rounded, clamped to the coordinates' range. */
void fc_view_to_world(const fc_view *view, fc_num t, const int64_t direction[3], fc_vec3 *v);

/* The eye's offset to a world point in units of 2^-fine world coordinates, exact. */
void fc_view_offset(const fc_view *view, const fc_vec3 *v, int64_t offset[3]);

/* The far limit is scene.far_limit * 2^this in camera grid units. */
static inline int16_t fc_view_far_exponent(const fc_frame *frame) {
  return (int16_t)(frame->scene.far_exponent + frame->view.fine - frame->view.shift);
}

/* Whether a primary hit is beyond the scene's far limit. */
bool fc_too_far_in(fc_wide *w, const fc_frame *frame, const fc_root *root, const int64_t direction[3]);
bool fc_too_far(const fc_frame *frame, const fc_root *root, const int64_t direction[3]);

/* Three coordinates; whether they are within +-FC_COORDINATE_MAX. */
bool fc_load(const fc_vec3 *v, int64_t r[3]);

/* |v| as a value. */
void fc_length_to(fc_num *length, const int64_t v[3]);

static inline fc_num fc_length(const int64_t v[3]) {
  fc_num length;
  fc_length_to(&length, v);
  return length;
}

/* The frame's size as its owner sees it. */
static inline uint16_t fc_view_columns(const fc_frame *frame) {
  return frame->options.profile == FC_PROFILE_HALF ? (uint16_t)(2 * frame->width - (frame->odd & 1)) : frame->width;
}

static inline uint16_t fc_view_rows(const fc_frame *frame) {
  return frame->options.profile == FC_PROFILE_HALF ? (uint16_t)(2 * frame->height - (frame->odd >> 1)) : frame->height;
}

/* Direction of the ray through pixel (x, y). */
void fc_view_direction(const fc_frame *frame, uint16_t x, uint16_t y, int64_t direction[3]);

/* floor of the column (axis 0, to the right) or row (axis 1, downwards) in which camera coordinates (a, z), z > 0, are
 * seen, in pixels; within one pixel; clamped to -2 .. 2^20. a below 2^32. */
int32_t fc_view_project(const fc_frame *frame, uint8_t axis, int64_t a, int64_t z);

#endif
