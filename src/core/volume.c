/* Arguments of the volume tests, read and checked. */
#include "volume.h"

#include <stddef.h>

#include "bits.h"
#include "segment.h"
#include "view.h"

FC_COLD int fc_volume_load(int64_t to[3], const fc_vec3 *point) {
  if (point == NULL) return FC_ERR_NULL;
  return fc_load(point, to) ? FC_OK : FC_ERR_COORDINATE;
}

FC_COLD int fc_volume_load_direction(int64_t to[3], const fc_vec3 *direction) {
  int error = fc_volume_load(to, direction);
  return error == FC_OK && fc_vector_bits(to) == 0 ? FC_ERR_DIRECTION : error;
}

FC_COLD int fc_volume_load_box(int64_t low[3], int64_t high[3], const fc_aabb *box) {
  if (box == NULL) return FC_ERR_NULL;
  if (!fc_load(&box->low, low) || !fc_load(&box->high, high)) return FC_ERR_COORDINATE;
  return low[0] <= high[0] && low[1] <= high[1] && low[2] <= high[2] ? FC_OK : FC_ERR_COORDINATE;
}

FC_COLD int fc_volume_check_sphere(const fc_sphere *sphere) {
  int64_t center[3];
  if (sphere == NULL) return FC_ERR_NULL;
  if (sphere->radius < 1) return FC_ERR_RADIUS;
  return fc_load(&sphere->center, center) && sphere->radius <= FC_COORDINATE_MAX ? FC_OK : FC_ERR_COORDINATE;
}

FC_COLD int fc_volume_check_plane(const fc_plane *plane) {
  int64_t n[3];
  if (plane == NULL) return FC_ERR_NULL;
  if (!fc_load(&plane->normal, n) || fc_abs32(plane->d) > (uint32_t)FC_COORDINATE_MAX) return FC_ERR_COORDINATE;
  if (plane->d_exponent < 0 || plane->d_exponent > 32) return FC_ERR_EXPONENT;
  return fc_vector_bits(n) == 0 ? FC_ERR_NORMAL : FC_OK;
}

FC_COLD int64_t fc_plane_value(const fc_plane *plane, const int64_t point[3]) {
  int64_t n[3];
  (void)fc_load(&plane->normal, n);
  return fc_dot(n, point) + plane->d * (INT64_C(1) << plane->d_exponent); /* three of 30 + 30 bits, and 30 + 32 */
}

FC_COLD void fc_box_extremes(int64_t least[3], int64_t greatest[3], const int64_t low[3], const int64_t high[3], const int64_t axis[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    least[i] = axis[i] < 0 ? high[i] : low[i];
    greatest[i] = axis[i] < 0 ? low[i] : high[i];
  }
}
