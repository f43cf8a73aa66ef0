/*
 * Short arithmetic for inner loops: 32-bit products, and reciprocals by a table and one Newton step.
 *
 * Values and filters only: what is decided here is decided with the stated errors in mind. No division, no
 * instruction that a Cortex-M0 lacks; the same bits on every machine.
 */
#ifndef FC_QUICK_H
#define FC_QUICK_H

#include <stdbool.h>
#include <stdint.h>

#include "bits.h"
#include "fixcast/config.h"

/* Chips whose multiplier has no high word: 64-bit products from four short ones. */
#if !defined(FC_SHORT_MULTIPLIER) && (defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__))
#define FC_SHORT_MULTIPLIER 1
#endif

/* a * b. */
FC_INLINE uint64_t fc_mul32(uint32_t a, uint32_t b) {
#ifdef FC_SHORT_MULTIPLIER
  uint32_t a0 = a & 0xffffu, a1 = a >> 16, b0 = b & 0xffffu, b1 = b >> 16;
  uint32_t low = a0 * b0, m1 = a1 * b0, m2 = a0 * b1, high = a1 * b1;
  uint64_t middle = (uint64_t)m1 + m2;
  return (((uint64_t)high << 32) | low) + (middle << 16);
#else
  return (uint64_t)a * b;
#endif
}

static inline int64_t fc_smul32(int32_t a, int32_t b) {
#ifdef FC_SHORT_MULTIPLIER
  /* halves, the upper ones signed: |high low| < 2^31, and a carry below 2^16 still fits */
  int32_t a1 = fc_floor_shift32(a, 16), b1 = fc_floor_shift32(b, 16);
  uint32_t a0 = (uint32_t)a & 0xffffu, b0 = (uint32_t)b & 0xffffu, low = a0 * b0;
  int32_t m = a1 * (int32_t)b0 + (int32_t)(low >> 16), n = (int32_t)a0 * b1 + (int32_t)((uint32_t)m & 0xffffu);
  int32_t high = a1 * b1 + fc_floor_shift32(m, 16) + fc_floor_shift32(n, 16);
  return fc_to_i64(((uint64_t)(uint32_t)high << 32) | (((uint32_t)n << 16) | (low & 0xffffu)));
#else
  return (int64_t)a * b;
#endif
}

/* The same. Where it takes four short products, a function: in line they want more registers than there are. */
#ifdef FC_SHORT_MULTIPLIER
int64_t fc_product(int32_t a, int32_t b);
#else
static inline int64_t fc_product(int32_t a, int32_t b) { return (int64_t)a * b; }
#endif

/* floor(a b / 2^32). */
static inline uint32_t fc_mulhi32(uint32_t a, uint32_t b) {
#ifdef FC_SHORT_MULTIPLIER
  uint32_t a0 = a & 0xffffu, a1 = a >> 16, b0 = b & 0xffffu, b1 = b >> 16;
  uint32_t m = a1 * b0 + ((a0 * b0) >> 16); /* (2^16-1)^2 + 2^16-1 < 2^32 */
  uint32_t n = a0 * b1 + (m & 0xffffu);
  return a1 * b1 + (m >> 16) + (n >> 16);
#else
  return (uint32_t)(((uint64_t)a * b) >> 32);
#endif
}

static inline int32_t fc_smulhi32(int32_t a, uint32_t b) {
#ifdef FC_SHORT_MULTIPLIER
  int32_t a1 = fc_floor_shift32(a, 16), b0 = (int32_t)(b & 0xffffu);
  uint32_t a0 = (uint32_t)a & 0xffffu, b1 = b >> 16;
  /* a1 b1 fits, a0 b1 does not when signed: the upper words are summed as unsigned */
  int32_t m = a1 * b0 + (int32_t)((a0 * (uint32_t)b0) >> 16);
  uint32_t n = a0 * b1 + ((uint32_t)m & 0xffffu);
  return a1 * (int32_t)b1 + fc_floor_shift32(m, 16) + (int32_t)(n >> 16);
#else
  return fc_to_i32((uint32_t)(uint64_t)fc_floor_shift64((int64_t)a * b, 32));
#endif
}

/* floor(a b / 2^32) for a up to 63 bits: the sum of the parts fits when |a b| < 2^95. */
static inline int64_t fc_smul64hi(int64_t a, int32_t b) {
  uint32_t low = (uint32_t)(uint64_t)a;
  int32_t high = fc_to_i32((uint32_t)((uint64_t)a >> 32));
  /* low * b with b signed: floor of its high word */
  uint32_t p = fc_mulhi32(low, (uint32_t)b);
  if (b < 0) p -= low;
  return fc_smul32(high, b) + fc_to_i32(p);
}

/* a n, modulo 2^64. */
static inline uint64_t fc_times(uint64_t a, uint32_t n) {
  return fc_mul32((uint32_t)a, n) + ((uint64_t)((uint32_t)(a >> 32) * n) << 32);
}

extern const uint16_t fc_rsqrt_table[192], fc_recip_table[128];

FC_INLINE uint16_t fc_read_table(const uint16_t *entry) {
  uint16_t v;
  FC_READ_ONE(&v, entry);
  return v;
}

/* 1 / sqrt(x) for x = m / 2^32 in [1/4, 1): Q15 in 32768..65536; relative error below 2^-14. */
FC_INLINE uint32_t fc_rsqrt_q15(uint32_t m) {
  uint32_t y = fc_read_table(&fc_rsqrt_table[(m >> 24) - 64]);
  /* y (3 - x y^2) / 2: y^2 Q30, kept as Q14; x Q16: x y^2 below 1.03, Q30 */
  uint32_t xyy = (m >> 16) * ((y * y) >> 16);
  return (y * (((UINT32_C(3) << 30) + 0x8000u - xyy) >> 16)) >> 15;
}

/* 2^31 / m for m in 2^15 .. 2^16-1, relative error below 2^-15: 32768 .. 65536. */
FC_INLINE uint32_t fc_recip_q31(uint32_t m) {
  uint32_t r = fc_read_table(&fc_recip_table[(m >> 8) - 128]);
  /* r (2 - m r): m r within 1 +- 2^-8 of 2^31 */
  uint32_t rest = 0x8000u - m * r; /* (2 - m r) Q31 and a rounding; wraps to about 2^31 */
  return (r * (rest >> 16) + (1u << 14)) >> 15;
}

/* sqrt(x) for x = m / 2^32 in [1/4, 1): Q32 (2^31 .. 2^32-1), off by less than 2^7. */
FC_INLINE uint32_t fc_sqrt_q32(uint32_t m) {
  uint32_t y = fc_rsqrt_q15(m), s = ((m >> 16) * y) >> 15; /* Q16 */
  int32_t rest;
  if (s >> 16) s = 0xffffu;
  rest = fc_to_i32(m - s * s); /* |rest| < 2^32 * 2 * 2^-12.5 */
  /* + rest y / 2: Q32 * Q15 / 2, the factor cut by 2^4 to keep 32 bits */
  return (s << 16) + (uint32_t)(fc_floor_shift32(fc_floor_shift32(rest, 4) * (int32_t)y, 12));
}

/*
 * Values m * 2^e with m in 2^31 .. 2^32-1, or 0: num.h's little sister for what need not be better than 2^-25. Relative
 * errors: conversion and product below 2^-30, root and reciprocal below 2^-26.
 */
typedef struct fc_quick {
  uint32_t m;
  int32_t e;
} fc_quick;

/* What comes back in registers is shorter to use than what comes back in memory: m + 2^32 e. */
uint64_t fc_packed_from(uint64_t v, int32_t e);
uint64_t fc_packed_mul(fc_quick a, fc_quick b);
uint64_t fc_packed_add(fc_quick a, fc_quick b);
uint64_t fc_packed_rsqrt(fc_quick a);
uint64_t fc_packed_recip(fc_quick a);

static inline fc_quick fc_quick_unpack(uint64_t packed) {
  fc_quick r;
  r.m = (uint32_t)packed;
  r.e = fc_to_i32((uint32_t)(packed >> 32));
  return r;
}

static inline uint64_t fc_quick_pack(uint32_t m, int32_t e) { return (uint64_t)(uint32_t)e << 32 | m; }

static inline fc_quick fc_quick_from(uint64_t v, int32_t e) { return fc_quick_unpack(fc_packed_from(v, e)); }
static inline fc_quick fc_quick_mul(fc_quick a, fc_quick b) { return fc_quick_unpack(fc_packed_mul(a, b)); }
static inline fc_quick fc_quick_rsqrt(fc_quick a) { return fc_quick_unpack(fc_packed_rsqrt(a)); }
static inline fc_quick fc_quick_recip(fc_quick a) { return fc_quick_unpack(fc_packed_recip(a)); }

/* Relative error below 2^-30. */
static inline fc_quick fc_quick_add(fc_quick a, fc_quick b) { return fc_quick_unpack(fc_packed_add(a, b)); }

static inline bool fc_quick_less(fc_quick a, fc_quick b) {
  if (a.m == 0 || b.m == 0) return a.m < b.m;
  return a.e != b.e ? a.e < b.e : a.m < b.m;
}

static inline fc_quick fc_quick_scale(fc_quick a, int16_t e) {
  a.e = (int16_t)(a.e + e);
  return a;
}

/* floor(a 2^e), INT32_MAX when it does not fit. */
int32_t fc_quick_to_int(fc_quick a, int16_t e);

/* floor(a), for values below 2^64. */
static inline uint64_t fc_quick_to_u64(fc_quick a) {
  return a.m == 0 || a.e < -31 ? 0 : a.e < 0 ? a.m >> -a.e
                                             : (uint64_t)a.m << a.e;
}

/* v a 2^e, cut towards 0; within +-INT32_MAX. */
int32_t fc_quick_times(fc_quick a, int64_t v, int16_t e);

#endif
