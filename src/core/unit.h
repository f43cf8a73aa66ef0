/* How far a quaternion is from unit length, and numbers corrected for that in their last rounding. */
#ifndef FC_UNIT_H
#define FC_UNIT_H

#include <stdbool.h>
#include <stdint.h>

#include "bits.h"
#include "fixcast/rotation.h"

/* |q|^2 - 1 in Q60; false when q is not of unit length within 2^-28. */
bool fc_unit_excess(int64_t *excess_q60, const fc_rotation *q);

/* -excess / 2^halve in Q44: at most 18 bits for two excesses. */
static inline int32_t fc_unit_change(int64_t excess_q60, uint8_t halve) {
  return (int32_t)-fc_floor_shift64(excess_q60, (uint8_t)(16 + halve));
}

/* round(v (1 + change)) from Q60 to Q30: symmetric in the sign of v; |v| below 2^62. 2^32 times 2^18: far below 2^63. */
static inline int32_t fc_unit_round(int64_t v_q60, int32_t change_q44) {
  const uint64_t m = fc_abs64(v_q60);
  const int64_t corrected = (int64_t)m + fc_floor_shift64((int64_t)(m >> 30) * change_q44, 14);
  const int32_t r = (int32_t)((corrected + (INT64_C(1) << 29)) >> 30); /* not negative */
  return v_q60 < 0 ? -r : r;
}

#endif
