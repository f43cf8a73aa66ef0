/* Points, spheres and boxes against planes. */
#include "bits.h"
#include "i128.h"
#include "segment.h"
#include "view.h"
#include "volume.h"

static fc_side side_of(int64_t value) { return value == 0 ? FC_SIDE_ON : value > 0 ? FC_SIDE_FRONT
                                                                                   : FC_SIDE_BACK; }

FC_COLD int fc_point_plane(const fc_vec3 *point, const fc_plane *plane) {
  int64_t p[3];
  int error = fc_volume_load(p, point);
  if (error == FC_OK) error = fc_volume_check_plane(plane);
  return error != FC_OK ? error : (int)side_of(fc_plane_value(plane, p));
}

FC_COLD int fc_sphere_plane(const fc_sphere *sphere, const fc_plane *plane) {
  int64_t c[3], n[3], value;
  fc_i128 reach2;
  int error = fc_volume_check_sphere(sphere);
  if (error == FC_OK) error = fc_volume_check_plane(plane);
  if (error != FC_OK) return error;
  (void)fc_load(&sphere->center, c);
  (void)fc_load(&plane->normal, n);
  value = fc_plane_value(plane, c);                                             /* 63 bits with sign; its square below 2^126 */
  reach2 = fc_i128_mul((int64_t)sphere->radius * sphere->radius, fc_dot(n, n)); /* 60 + 62 bits */
  return fc_i128_compare(fc_i128_mul(value, value), reach2) <= 0 ? (int)FC_SIDE_ON : (int)side_of(value);
}

FC_COLD int fc_aabb_plane(const fc_aabb *box, const fc_plane *plane) {
  int64_t low[3], high[3], n[3], least[3], greatest[3];
  int error = fc_volume_load_box(low, high, box);
  if (error == FC_OK) error = fc_volume_check_plane(plane);
  if (error != FC_OK) return error;
  (void)fc_load(&plane->normal, n);
  fc_box_extremes(least, greatest, low, high, n);
  if (fc_plane_value(plane, least) > 0) return FC_SIDE_FRONT;
  return fc_plane_value(plane, greatest) < 0 ? FC_SIDE_BACK : FC_SIDE_ON;
}
