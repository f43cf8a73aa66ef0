/* Slabs in any direction: oriented boxes and k-DOPs. */
#include <stddef.h>

#include "bits.h"
#include "fixcast/volume_extra.h"
#include "segment.h"
#include "volume.h"

#define BOUND (INT64_C(1) << 62)

/* Normal of a slab; FC_OK or what is wrong with it. */
static int load_normal(int64_t n[3], const fc_slab *slab) {
  const uint32_t most = UINT32_C(1) << 30;
  n[0] = slab->normal.x;
  n[1] = slab->normal.y;
  n[2] = slab->normal.z;
  if (fc_abs32(slab->normal.x) > most || fc_abs32(slab->normal.y) > most || fc_abs32(slab->normal.z) > most)
    return FC_ERR_COORDINATE;
  return fc_vector_bits(n) == 0 ? FC_ERR_NORMAL : FC_OK;
}

static int load_slab(int64_t n[3], const fc_slab *slab) {
  if (slab->low > slab->high || slab->low < -BOUND || slab->high > BOUND) return FC_ERR_COORDINATE;
  return load_normal(n, slab);
}

int fc_ray_slabs(const fc_vec3 *origin, const fc_vec3 *direction, const fc_slab *slabs, uint8_t count, fc_span *span) {
  int64_t o[3], d[3], n[3];
  fc_span inside;
  uint8_t i;
  int error = fc_volume_load(o, origin);
  if (error == FC_OK) error = fc_volume_load_direction(d, direction);
  if (error == FC_OK && slabs == NULL) error = FC_ERR_NULL;
  if (error == FC_OK && count == 0) error = FC_ERR_COUNT;
  for (i = 0; i < count && error == FC_OK; i++) error = load_slab(n, slabs + i);
  if (error != FC_OK) return error;
  fc_span_start(&inside);
  for (i = 0; i < count; i++) {
    int64_t at;
    (void)load_normal(n, slabs + i);
    at = fc_dot(n, o); /* three of 2^60, and bounds of 2^62: below 2^63 */
    if (!fc_span_cut(&inside, slabs[i].low - at, slabs[i].high - at, fc_dot(n, d))) return 0;
  }
  if (span != NULL) *span = inside;
  return 1;
}

int fc_point_slabs(const fc_vec3 *point, const fc_slab *slabs, uint8_t count) {
  int64_t p[3], n[3];
  uint8_t i;
  int met = 1, error = fc_volume_load(p, point);
  if (error == FC_OK && slabs == NULL) error = FC_ERR_NULL;
  if (error == FC_OK && count == 0) error = FC_ERR_COUNT;
  for (i = 0; i < count && error == FC_OK; i++) {
    error = load_slab(n, slabs + i);
    if (error == FC_OK && (fc_dot(n, p) < slabs[i].low || fc_dot(n, p) > slabs[i].high)) met = 0;
  }
  return error != FC_OK ? error : met;
}

int fc_slabs_slabs(const fc_slab *a, const fc_slab *b, uint8_t count) {
  int64_t m[3], n[3];
  uint8_t i;
  int met = 1, error = a == NULL || b == NULL ? FC_ERR_NULL : count == 0 ? FC_ERR_COUNT
                                                                         : FC_OK;
  for (i = 0; i < count && error == FC_OK; i++) {
    error = load_slab(m, a + i);
    if (error == FC_OK) error = load_slab(n, b + i);
    if (error == FC_OK && (m[0] != n[0] || m[1] != n[1] || m[2] != n[2])) error = FC_ERR_NORMAL;
    if (error == FC_OK && (a[i].low > b[i].high || b[i].low > a[i].high)) met = 0;
  }
  return error != FC_OK ? error : met;
}

int fc_slabs_fit(fc_slab *slabs, uint8_t count, const fc_vec3 *points, uint16_t point_count) {
  int64_t p[3], n[3];
  uint16_t j;
  uint8_t i;
  int error = slabs == NULL || points == NULL ? FC_ERR_NULL : count == 0 || point_count == 0 ? FC_ERR_COUNT
                                                                                             : FC_OK;
  for (i = 0; i < count && error == FC_OK; i++) error = load_normal(n, slabs + i);
  for (j = 0; j < point_count && error == FC_OK; j++) error = fc_volume_load(p, points + j);
  if (error != FC_OK) return error;
  for (i = 0; i < count; i++) {
    (void)load_normal(n, slabs + i);
    for (j = 0; j < point_count; j++) {
      int64_t at;
      (void)fc_volume_load(p, points + j);
      at = fc_dot(n, p); /* below 2^62 */
      if (j == 0 || at < slabs[i].low) slabs[i].low = at;
      if (j == 0 || at > slabs[i].high) slabs[i].high = at;
    }
  }
  return FC_OK;
}

int fc_slabs_of_box(fc_slab slabs[3], const fc_vec3 *center, const fc_vec3 *half, const fc_matrix *axes) {
  int64_t c[3], h[3];
  fc_slab box[3];
  uint8_t i;
  int error = fc_volume_load(c, center);
  if (error == FC_OK) error = fc_volume_load(h, half);
  if (error == FC_OK && (slabs == NULL || axes == NULL)) error = FC_ERR_NULL;
  if (error != FC_OK) return error;
  for (i = 0; i < 3; i++) {
    int64_t n[3], at;
    box[i].normal.x = axes->row[i][0];
    box[i].normal.y = axes->row[i][1];
    box[i].normal.z = axes->row[i][2];
    error = load_normal(n, box + i);
    if (error != FC_OK) return error;
    if (h[i] < 0) return FC_ERR_COORDINATE;
    at = fc_dot(n, c);
    /* 3 * 2^60 and 2^60 */
    box[i].low = at - h[i] * (INT64_C(1) << 30);
    box[i].high = at + h[i] * (INT64_C(1) << 30);
  }
  for (i = 0; i < 3; i++) slabs[i] = box[i];
  return FC_OK;
}
