/* The virtual trackball: places of a mouse as points of a ball. */
#include <stddef.h>

#include "bits.h"
#include "fixcast/rotation.h"
#include "num.h"

/* round(v q 2^30) with the sign of v. */
static FC_COLD int32_t scaled(int32_t v, fc_num q) {
  int32_t m;
  fc_num_times_u64(&q, fc_abs32(v));
  m = (int32_t)fc_num_rounded(&q, 30);
  return v < 0 ? -m : m;
}

FC_COLD int fc_trackball_point(fc_vec3 *point_q30, int32_t x, int32_t y, int32_t radius) {
  uint64_t d2, r2, reach2;
  fc_num scale, z; /* point = (x scale, y scale, z) */
  if (point_q30 == NULL) return FC_ERR_NULL;
  if (fc_abs32(x) > FC_TRACKBALL_MAX || fc_abs32(y) > FC_TRACKBALL_MAX || radius < 1 || radius > FC_TRACKBALL_MAX)
    return FC_ERR_SIZE;
  d2 = (uint64_t)((int64_t)x * x) + (uint64_t)((int64_t)y * y); /* below 2^33 */
  r2 = (uint64_t)((int64_t)radius * radius);
  if (2 * d2 <= r2) {
    scale = fc_num_div(fc_num_from_u64(1, 0), fc_num_from_u64((uint64_t)radius, 0));
    z = fc_num_sqrt(fc_num_from_u64(r2 - d2, 0));
    fc_num_over_u64(&z, (uint64_t)radius);
  } else {
    /* (x/d 2 D^2, y/d 2 D^2, r^2) / sqrt(4 D^4 + r^4), D the distance within reach, D^2 below 2^40 */
    fc_num length, flat;
    reach2 = (uint64_t)FC_TRACKBALL_REACH * FC_TRACKBALL_REACH * r2;
    flat = fc_num_from_u64(2 * (d2 < reach2 ? d2 : reach2), 0);
    z = fc_num_from_u64(r2, 0);
    length = fc_num_sqrt(fc_num_add(fc_num_mul(flat, flat), fc_num_mul(z, z)));
    z = fc_num_div(z, length);
    scale = fc_num_div(flat, fc_num_mul(length, fc_num_sqrt(fc_num_from_u64(d2, 0))));
  }
  point_q30->x = scaled(x, scale);
  point_q30->y = scaled(y, scale);
  point_q30->z = (int32_t)fc_num_rounded(&z, 30);
  return FC_OK;
}

FC_COLD int fc_trackball_drag(fc_rotation *rotation, int32_t from_x, int32_t from_y, int32_t to_x, int32_t to_y, int32_t radius) {
  fc_vec3 from, to;
  int error;
  if (rotation == NULL) return FC_ERR_NULL;
  error = fc_trackball_point(&from, from_x, from_y, radius);
  if (error == FC_OK) error = fc_trackball_point(&to, to_x, to_y, radius);
  return error != FC_OK ? error : fc_rotation_between(rotation, &from, &to);
}
