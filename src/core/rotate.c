/* Matrices of rotations, and points that they turn. */
#include <stdbool.h>
#include <stddef.h>

#include "bits.h"
#include "fixcast/rotation.h"
#include "unit.h"

FC_COLD int fc_rotation_matrix(fc_matrix *matrix, const fc_rotation *rotation) {
  int64_t excess, ww, xx, yy, zz, xy, yz, zx, wx, wy, wz;
  int32_t change;
  if (matrix == NULL || rotation == NULL) return FC_ERR_NULL;
  if (!fc_unit_excess(&excess, rotation)) return FC_ERR_ROTATION;
  ww = (int64_t)rotation->w * rotation->w;
  xx = (int64_t)rotation->x * rotation->x;
  yy = (int64_t)rotation->y * rotation->y;
  zz = (int64_t)rotation->z * rotation->z;
  xy = (int64_t)rotation->x * rotation->y;
  yz = (int64_t)rotation->y * rotation->z;
  zx = (int64_t)rotation->z * rotation->x;
  wx = (int64_t)rotation->w * rotation->x;
  wy = (int64_t)rotation->w * rotation->y;
  wz = (int64_t)rotation->w * rotation->z;
  /* this is |q|^2 times a rotation, exactly; the sums are below 2^62 */
  change = fc_unit_change(excess, 0);
  matrix->row[0][0] = fc_unit_round(ww + xx - yy - zz, change);
  matrix->row[0][1] = fc_unit_round(2 * (xy - wz), change);
  matrix->row[0][2] = fc_unit_round(2 * (zx + wy), change);
  matrix->row[1][0] = fc_unit_round(2 * (xy + wz), change);
  matrix->row[1][1] = fc_unit_round(ww - xx + yy - zz, change);
  matrix->row[1][2] = fc_unit_round(2 * (yz - wx), change);
  matrix->row[2][0] = fc_unit_round(2 * (zx - wy), change);
  matrix->row[2][1] = fc_unit_round(2 * (yz + wx), change);
  matrix->row[2][2] = fc_unit_round(ww - xx - yy + zz, change);
  return FC_OK;
}

static bool in_range(int64_t v) { return v >= -FC_COORDINATE_MAX && v <= FC_COORDINATE_MAX; }

/* Whether a point is in range before and after. */
static FC_COLD bool turn(fc_vec3 *to, const fc_vec3 *from, const fc_matrix *m, const fc_vec3 *pivot) {
  int64_t d[3], r[3];
  uint8_t i;
  if (!in_range(from->x) || !in_range(from->y) || !in_range(from->z)) return false;
  d[0] = (int64_t)from->x - pivot->x;
  d[1] = (int64_t)from->y - pivot->y;
  d[2] = (int64_t)from->z - pivot->z;
  for (i = 0; i < 3; i++) /* three products of 30 + 31 bits: below 2^63 */
    r[i] = fc_floor_shift64(m->row[i][0] * d[0] + m->row[i][1] * d[1] + m->row[i][2] * d[2] + (INT64_C(1) << 29), 30);
  r[0] += pivot->x;
  r[1] += pivot->y;
  r[2] += pivot->z;
  if (!in_range(r[0]) || !in_range(r[1]) || !in_range(r[2])) return false;
  to->x = (int32_t)r[0];
  to->y = (int32_t)r[1];
  to->z = (int32_t)r[2];
  return true;
}

FC_COLD int fc_rotate_points(fc_vec3 *to, const fc_vec3 *from, uint16_t count, const fc_matrix *matrix, const fc_vec3 *pivot) {
  fc_vec3 centre = {0, 0, 0}, turned;
  uint16_t i;
  uint8_t k;
  if (matrix == NULL || (count > 0 && (to == NULL || from == NULL))) return FC_ERR_NULL;
  if (pivot != NULL) centre = *pivot;
  if (!in_range(centre.x) || !in_range(centre.y) || !in_range(centre.z)) return FC_ERR_COORDINATE;
  for (k = 0; k < 9; k++)
    if (fc_abs32(matrix->row[k / 3][k % 3]) > UINT32_C(1) << 30) return FC_ERR_ROTATION;
  for (i = 0; i < count; i++) /* look first, write then */
    if (!turn(&turned, from + i, matrix, &centre)) return FC_ERR_COORDINATE;
  for (i = 0; i < count; i++) (void)turn(to + i, from + i, matrix, &centre);
  return FC_OK;
}
