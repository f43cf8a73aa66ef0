/* Spheres against spheres, boxes against boxes. */
#include "bits.h"
#include "view.h"
#include "volume.h"

FC_COLD int fc_sphere_sphere(const fc_sphere *a, const fc_sphere *b) {
  int64_t p[3], q[3], reach;
  uint64_t distance2 = 0;
  uint8_t i;
  int error = fc_volume_check_sphere(a);
  if (error == FC_OK) error = fc_volume_check_sphere(b);
  if (error != FC_OK) return error;
  (void)fc_load(&a->center, p);
  (void)fc_load(&b->center, q);
  reach = (int64_t)a->radius + b->radius; /* 31 bits */
  for (i = 0; i < 3; i++) {               /* three squares below 2^62: below 2^64 without a sign */
    const uint64_t d = fc_abs64(p[i] - q[i]);
    distance2 += d * d;
  }
  return distance2 <= (uint64_t)(reach * reach);
}

FC_COLD int fc_aabb_aabb(const fc_aabb *a, const fc_aabb *b) {
  int64_t a_low[3], a_high[3], b_low[3], b_high[3];
  uint8_t i;
  int error = fc_volume_load_box(a_low, a_high, a);
  if (error == FC_OK) error = fc_volume_load_box(b_low, b_high, b);
  if (error != FC_OK) return error;
  for (i = 0; i < 3; i++)
    if (a_low[i] > b_high[i] || b_low[i] > a_high[i]) return 0;
  return 1;
}
