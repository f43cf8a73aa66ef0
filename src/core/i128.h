/* Two-word integers: the width of every primary decision (docs/SPEC.md, "Bit budgets"). */
#ifndef FC_I128_H
#define FC_I128_H

#include <stdint.h>

/* Two's complement, |value| < 2^127. */
typedef struct fc_i128 {
  uint64_t lo, hi;
} fc_i128;

static inline fc_i128 fc_i128_from_u64(uint64_t v) {
  fc_i128 r = {v, 0};
  return r;
}

static inline fc_i128 fc_i128_from(int64_t v) {
  fc_i128 r = {(uint64_t)v, v < 0 ? UINT64_MAX : 0};
  return r;
}

/* In place: r += b, r -= b, r = -r. */
void fc_i128_plus(fc_i128 *r, const fc_i128 *b);
void fc_i128_minus(fc_i128 *r, const fc_i128 *b);
void fc_i128_negate(fc_i128 *r);

/* The same by value. */
static inline fc_i128 fc_i128_add(fc_i128 a, fc_i128 b) {
  fc_i128_plus(&a, &b);
  return a;
}

static inline fc_i128 fc_i128_sub(fc_i128 a, fc_i128 b) {
  fc_i128_minus(&a, &b);
  return a;
}

static inline fc_i128 fc_i128_neg(fc_i128 a) {
  fc_i128_negate(&a);
  return a;
}

static inline int8_t fc_i128_sign(fc_i128 a) {
  if (a.hi >> 63) return -1;
  return (a.hi | a.lo) != 0;
}

static inline fc_i128 fc_i128_abs(fc_i128 a) { return fc_i128_sign(a) < 0 ? fc_i128_neg(a) : a; }

/* -1, 0 or 1 as a < b, a == b, a > b. */
int8_t fc_i128_compare(fc_i128 a, fc_i128 b);

/* Exact products: 64 x 64 bits -> 128, unsigned and signed. */
void fc_i128_set_product_u64(fc_i128 *r, uint64_t a, uint64_t b);
void fc_i128_set_product(fc_i128 *r, int64_t a, int64_t b);

static inline fc_i128 fc_i128_mul_u64(uint64_t a, uint64_t b) {
  fc_i128 r;
  fc_i128_set_product_u64(&r, a, b);
  return r;
}

static inline fc_i128 fc_i128_mul(int64_t a, int64_t b) {
  fc_i128 r;
  fc_i128_set_product(&r, a, b);
  return r;
}

/* a * b for |a * b| < 2^127. */
fc_i128 fc_i128_scale(fc_i128 a, int64_t b);

/* a.x b.x + a.y b.y + a.z b.z, for a sum within 2^127. */
fc_i128 fc_i128_dot(const int64_t a[3], const int64_t b[3]);

/* a * 2^s, s 0..127, for a result within 2^127. */
fc_i128 fc_i128_shift_left(fc_i128 a, uint8_t s);

/* floor(a / 2^s), s 0..127. */
fc_i128 fc_i128_floor_shift(fc_i128 a, uint8_t s);

/* round(a / 2^s), halves up, s 0..126. */
fc_i128 fc_i128_round_shift(fc_i128 a, uint8_t s);

/* r = round(r 2^s), halves up, s -126 .. 127, for a result within 2^127. */
void fc_i128_move(fc_i128 *r, int16_t s);

/* Bits of |a|; 0 for 0. */
uint8_t fc_i128_bits(fc_i128 a);

/* a as 64 bits; a must fit. */
static inline int64_t fc_i128_to_i64(fc_i128 a) {
  return fc_i128_sign(a) < 0 ? -(int64_t)(0u - a.lo - 1u) - 1 : (int64_t)a.lo;
}

#endif
