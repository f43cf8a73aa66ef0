/*
 * Values: positive numbers with a 63-bit mantissa and a power-of-two exponent.
 *
 * Decisions never rest on them alone: each operation truncates with a relative error below FC_NUM_ULP = 2^-61
 * and the users state their sum. A wide mantissa keeps colours, positions and depths free of overflow analysis.
 */
#ifndef FC_NUM_H
#define FC_NUM_H

#include <stdint.h>

#include "i128.h"

/* m * 2^e with m in 2^62 .. 2^63-1, or m == 0. */
typedef struct fc_num {
  uint64_t m;
  int32_t e;
} fc_num;

fc_num fc_num_from_u64(uint64_t v, int32_t exponent);
fc_num fc_num_from_abs(fc_i128 v); /* |v| */
fc_num fc_num_mul(fc_num a, fc_num b);
fc_num fc_num_div(fc_num a, fc_num b); /* b != 0 */
fc_num fc_num_add(fc_num a, fc_num b);
fc_num fc_num_sub(fc_num a, fc_num b); /* a >= b; relative error grows with cancellation */
fc_num fc_num_sqrt(fc_num a);
int8_t fc_num_compare(fc_num a, fc_num b);
fc_num fc_num_scale(fc_num a, int32_t exponent); /* a * 2^exponent, exact */

/* round(a * 2^shift) to nearest, halves up; UINT64_MAX when it does not fit. */
uint64_t fc_num_round(fc_num a, int32_t shift);

/* floor(sqrt(v)). */
uint32_t fc_sqrt64(uint64_t v);

#endif
