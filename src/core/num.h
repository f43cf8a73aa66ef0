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

/* In place: a value is four words, and passing it on by address is the least of code. */
void fc_num_set(fc_num *r, uint64_t v, int32_t exponent); /* v 2^exponent */
void fc_num_set_abs(fc_num *r, const fc_i128 *v);         /* |v| */
void fc_num_times(fc_num *r, const fc_num *b);
void fc_num_over(fc_num *r, const fc_num *b); /* b != 0 */
void fc_num_plus(fc_num *r, const fc_num *b);
void fc_num_minus(fc_num *r, const fc_num *b); /* r >= b; relative error grows with cancellation; 0 when r < b */
void fc_num_root(fc_num *r);
int8_t fc_num_order_of(const fc_num *a, const fc_num *b); /* sign of a - b */

/* r v and r / v */
void fc_num_times_u64(fc_num *r, uint64_t v);
void fc_num_over_u64(fc_num *r, uint64_t v);

/* round(r * 2^shift) to nearest, halves up; UINT64_MAX when it does not fit. */
uint64_t fc_num_rounded(const fc_num *r, int32_t shift);

/* The same by value. */
static inline fc_num fc_num_from_u64(uint64_t v, int32_t exponent) {
  fc_num r;
  fc_num_set(&r, v, exponent);
  return r;
}

static inline fc_num fc_num_from_abs(fc_i128 v) {
  fc_num r;
  fc_num_set_abs(&r, &v);
  return r;
}

static inline fc_num fc_num_mul(fc_num a, fc_num b) {
  fc_num_times(&a, &b);
  return a;
}

static inline fc_num fc_num_div(fc_num a, fc_num b) {
  fc_num_over(&a, &b);
  return a;
}

static inline fc_num fc_num_add(fc_num a, fc_num b) {
  fc_num_plus(&a, &b);
  return a;
}

static inline fc_num fc_num_sub(fc_num a, fc_num b) {
  fc_num_minus(&a, &b);
  return a;
}

static inline fc_num fc_num_sqrt(fc_num a) {
  fc_num_root(&a);
  return a;
}

static inline int8_t fc_num_compare(fc_num a, fc_num b) { return fc_num_order_of(&a, &b); }

/* a * 2^exponent, exact. */
static inline fc_num fc_num_scale(fc_num a, int32_t exponent) {
  a.e += exponent; /* that of a 0 does not matter */
  return a;
}

static inline uint64_t fc_num_round(fc_num a, int32_t shift) { return fc_num_rounded(&a, shift); }

/* floor(sqrt(v)). */
uint32_t fc_sqrt64(uint64_t v);

#endif
