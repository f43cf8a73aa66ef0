/* Mirror directions. */
#include "fixcast/reflect.h"

#include <stdbool.h>
#include <stddef.h>

#include "bits.h"
#include "i128.h"
#include "num.h"
#include "segment.h"

static FC_COLD bool load(int64_t to[3], const fc_vec3 *v) {
  const uint32_t most = UINT32_C(1) << 30;
  to[0] = v->x;
  to[1] = v->y;
  to[2] = v->z;
  return fc_abs32(v->x) <= most && fc_abs32(v->y) <= most && fc_abs32(v->z) <= most;
}

/* Moves r by single units along the normal's largest axis until n . r has the sign of `side`. Rounding moved n . r by at most 1/2 + 2^-30 of
 * |n|_1, 3/2 of the largest component and a bit: two steps do. |r| at most 2^30 + 2. */
static FC_COLD void turn_out(int64_t r[3], const int64_t n[3], int8_t side) {
  uint8_t largest = 0, i;
  for (i = 1; i < 3; i++)
    if (fc_abs64(n[i]) > fc_abs64(n[largest])) largest = i;
  while (fc_sign64(fc_dot(n, r)) != side) r[largest] += (n[largest] < 0) == (side < 0) ? 1 : -1;
}

FC_COLD int fc_reflect(fc_vec3 *reflected, const fc_vec3 *direction, const fc_vec3 *normal) {
  int64_t d[3], n[3], r[3], along, n2;
  fc_i128 exact[3]; /* n^2 R */
  fc_num part[3], length2;
  int32_t shift;
  uint8_t i;
  if (reflected == NULL || direction == NULL || normal == NULL) return FC_ERR_NULL;
  if (!load(d, direction) || !load(n, normal)) return FC_ERR_COORDINATE;
  if (fc_vector_bits(d) == 0) return FC_ERR_DIRECTION;
  if (fc_vector_bits(n) == 0) return FC_ERR_NORMAL;
  along = fc_dot(n, d); /* both: three of 2^60, below 2^62 */
  n2 = fc_dot(n, n);
  length2 = fc_num_from_u64((uint64_t)n2, 0);
  shift = INT32_MAX;
  for (i = 0; i < 3; i++) {
    fc_i128 back = fc_i128_mul(2 * along, n[i]); /* 63 + 30 bits */
    exact[i] = fc_i128_sub(fc_i128_mul(n2, d[i]), back);
    part[i] = fc_num_div(fc_num_from_abs(exact[i]), length2);
    /* below 2^(e + 63) */
    if (part[i].m != 0 && -33 - part[i].e < shift) shift = -33 - part[i].e;
  }
  for (;; shift--) { /* again with a bit less when there is no room: once at most */
    for (i = 0; i < 3; i++) {
      r[i] = (int64_t)fc_num_rounded(&part[i], shift);
      if (fc_i128_sign(exact[i]) < 0) r[i] = -r[i];
    }
    if (along != 0) turn_out(r, n, along < 0 ? 1 : -1);
    if (fc_abs64(r[0]) <= (uint64_t)FC_COORDINATE_MAX && fc_abs64(r[1]) <= (uint64_t)FC_COORDINATE_MAX &&
        fc_abs64(r[2]) <= (uint64_t)FC_COORDINATE_MAX)
      break;
  }
  reflected->x = (int32_t)r[0];
  reflected->y = (int32_t)r[1];
  reflected->z = (int32_t)r[2];
  return FC_OK;
}
