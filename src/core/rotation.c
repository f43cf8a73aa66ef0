/* Unit quaternions: made, multiplied, kept at unit length. */
#include "fixcast/rotation.h"

#include <stddef.h>

#include "bits.h"
#include "i128.h"
#include "num.h"
#include "unit.h"

FC_COLD bool fc_unit_excess(int64_t *excess_q60, const fc_rotation *q) {
  const uint32_t most = UINT32_C(1) << 30;
  if (fc_abs32(q->w) > most || fc_abs32(q->x) > most || fc_abs32(q->y) > most || fc_abs32(q->z) > most) return false;
  /* four squares of 2^30: at most 2^62 */
  *excess_q60 = (int64_t)q->w * q->w + (int64_t)q->x * q->x + (int64_t)q->y * q->y + (int64_t)q->z * q->z -
                (INT64_C(1) << 60);
  return fc_abs64(*excess_q60) <= UINT64_C(1) << 33;
}

/* Each coordinate within +-2^30, so that unit vectors in Q30 may come, and not all 0: FC_OK or what is wrong. */
static FC_COLD int check_direction(const fc_vec3 *v) {
  const uint32_t most = UINT32_C(1) << 30;
  if (fc_abs32(v->x) > most || fc_abs32(v->y) > most || fc_abs32(v->z) > most) return FC_ERR_COORDINATE;
  return (v->x | v->y | v->z) == 0 ? FC_ERR_DIRECTION : FC_OK;
}

/* |v|^2, three squares of 2^30: below 2^62 */
static uint64_t square_of(const fc_vec3 *v) {
  return (uint64_t)((int64_t)v->x * v->x + (int64_t)v->y * v->y + (int64_t)v->z * v->z);
}

/* round(v q 2^30), q <= 1 / |v|: symmetric in the sign of v. */
static FC_COLD int32_t share(int64_t v, const fc_num *q) {
  fc_num part = fc_num_from_u64(fc_abs64(v), 0);
  int32_t m;
  fc_num_times(&part, q);
  m = (int32_t)fc_num_rounded(&part, 30);
  return v < 0 ? -m : m;
}

FC_COLD int fc_rotation_about(fc_rotation *rotation, const fc_vec3 *axis, uint16_t angle) {
  const uint32_t half = (uint32_t)angle << 15;
  fc_num scale, length;
  int error;
  if (rotation == NULL || axis == NULL) return FC_ERR_NULL;
  error = check_direction(axis);
  if (error != FC_OK) return error;
  /* half the angle is below half a turn: its sine is not negative */
  scale = fc_num_from_u64((uint64_t)fc_sin_q30(half), -30);
  length = fc_num_sqrt(fc_num_from_u64(square_of(axis), 0));
  fc_num_over(&scale, &length);
  rotation->w = fc_cos_q30(half);
  rotation->x = share(axis->x, &scale);
  rotation->y = share(axis->y, &scale);
  rotation->z = share(axis->z, &scale);
  return FC_OK;
}

/* Half a turn about an axis across v. */
static FC_COLD int half_turn_across(fc_rotation *rotation, const fc_vec3 *v) {
  fc_vec3 across = {0, 0, 0};
  if (v->x == 0 && v->y == 0) {
    across.x = 1;
  } else {
    across.x = -v->y;
    across.y = v->x;
  }
  return fc_rotation_about(rotation, &across, UINT16_C(1) << 15);
}

FC_COLD int fc_rotation_between(fc_rotation *rotation, const fc_vec3 *from, const fc_vec3 *to) {
  int64_t cross[3], cosine;
  fc_i128 cross2;
  fc_num w, turn, length;
  int error;
  if (rotation == NULL || from == NULL || to == NULL) return FC_ERR_NULL;
  error = check_direction(from);
  if (error == FC_OK) error = check_direction(to);
  if (error != FC_OK) return error;
  /* sums of two and three products of 2^30: below 2^62 */
  cross[0] = (int64_t)from->y * to->z - (int64_t)from->z * to->y;
  cross[1] = (int64_t)from->z * to->x - (int64_t)from->x * to->z;
  cross[2] = (int64_t)from->x * to->y - (int64_t)from->y * to->x;
  cosine = (int64_t)from->x * to->x + (int64_t)from->y * to->y + (int64_t)from->z * to->z;
  cross2 = fc_i128_dot(cross, cross); /* three squares of 2^61: below 2^124 */
  if (cosine < 0 && fc_i128_sign(cross2) == 0) return half_turn_across(rotation, from);
  /* |a||b| + a.b, which is |a x b|^2 / (|a||b| - a.b): whichever does not cancel */
  w = fc_num_sqrt(fc_num_from_abs(fc_i128_mul_u64(square_of(from), square_of(to))));
  w = fc_num_add(w, fc_num_from_u64(fc_abs64(cosine), 0));
  turn = fc_num_from_abs(cross2);
  if (cosine < 0) w = fc_num_div(turn, w);
  length = fc_num_sqrt(fc_num_add(fc_num_mul(w, w), turn));
  w = fc_num_div(w, length);
  rotation->w = (int32_t)fc_num_rounded(&w, 30);
  turn = fc_num_div(fc_num_from_u64(1, 0), length);
  rotation->x = share(cross[0], &turn);
  rotation->y = share(cross[1], &turn);
  rotation->z = share(cross[2], &turn);
  return FC_OK;
}

FC_COLD int fc_rotation_compose(fc_rotation *result, const fc_rotation *second, const fc_rotation *first) {
  int64_t excess_a, excess_b, w, x, y, z;
  int32_t change;
  if (result == NULL || second == NULL || first == NULL) return FC_ERR_NULL;
  if (!fc_unit_excess(&excess_a, second) || !fc_unit_excess(&excess_b, first)) return FC_ERR_ROTATION;
  /* Hamilton's product; four products of 2^60: below 2^63 */
  w = (int64_t)second->w * first->w - (int64_t)second->x * first->x - (int64_t)second->y * first->y -
      (int64_t)second->z * first->z;
  x = (int64_t)second->w * first->x + (int64_t)second->x * first->w + (int64_t)second->y * first->z -
      (int64_t)second->z * first->y;
  y = (int64_t)second->w * first->y - (int64_t)second->x * first->z + (int64_t)second->y * first->w +
      (int64_t)second->z * first->x;
  z = (int64_t)second->w * first->z + (int64_t)second->x * first->y - (int64_t)second->y * first->x +
      (int64_t)second->z * first->w;
  /* |product|^2 = 1 + excess_a + excess_b within 2^-54, and 1 / sqrt(1 + e) = 1 - e / 2 within 2^-53 */
  change = fc_unit_change(excess_a + excess_b, 1);
  result->w = fc_unit_round(w, change);
  result->x = fc_unit_round(x, change);
  result->y = fc_unit_round(y, change);
  result->z = fc_unit_round(z, change);
  return FC_OK;
}

FC_COLD int fc_rotation_invert(fc_rotation *result, const fc_rotation *rotation) {
  int64_t excess;
  if (result == NULL || rotation == NULL) return FC_ERR_NULL;
  if (!fc_unit_excess(&excess, rotation)) return FC_ERR_ROTATION;
  result->w = rotation->w;
  result->x = -rotation->x;
  result->y = -rotation->y;
  result->z = -rotation->z;
  return FC_OK;
}
