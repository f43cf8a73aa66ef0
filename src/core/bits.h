/* Shifts and bit counts that C99 leaves to the implementation, defined for every input used here. */
#ifndef FC_BITS_H
#define FC_BITS_H

#include <stdint.h>

#include "fixcast/config.h"

/* Inner loops stay functions of their own: a caller's variables would crowd them out of the registers. What runs once a
 * frame or once in a thousand pixels is kept small rather than fast, and out of the way; so is what only such functions
 * call, but for the loops that are hot. */
#if defined(__GNUC__)
#define FC_NOINLINE __attribute__((noinline))
#define FC_HOT __attribute__((noinline, hot))
#define FC_COLD __attribute__((noinline, cold))
#define FC_RARELY(condition) __builtin_expect((condition), 0)
#define FC_INLINE static inline __attribute__((always_inline)) /* what inner loops are made of */
#else
#define FC_NOINLINE
#define FC_HOT
#define FC_COLD
#define FC_RARELY(condition) (condition)
#define FC_INLINE static inline
#endif

/* Leading zeros of a non-zero word. */
static inline uint8_t fc_clz64(uint64_t v) {
#if defined(__GNUC__)
  return (uint8_t)__builtin_clzll(v);
#else
  uint8_t n = 0;
  while (!(v >> 63)) {
    v <<= 1;
    n++;
  }
  return n;
#endif
}

static inline uint8_t fc_clz32(uint32_t v) {
#if defined(__GNUC__) && __SIZEOF_INT__ == 4
  return (uint8_t)__builtin_clz(v);
#else
  return (uint8_t)(fc_clz64(v) - 32);
#endif
}

/* Bits of a word up to its highest one; 0 for 0. */
static inline uint8_t fc_bits64(uint64_t v) { return v == 0 ? 0 : (uint8_t)(64 - fc_clz64(v)); }

/* |v| without overflow at INT64_MIN. */
static inline uint64_t fc_abs64(int64_t v) { return v < 0 ? 0u - (uint64_t)v : (uint64_t)v; }

static inline uint32_t fc_abs32(int32_t v) { return v < 0 ? 0u - (uint32_t)v : (uint32_t)v; }

/* floor(v / 2^s), s 0..63. What >> does to a negative number C99 leaves to the compiler: where it is the floor, one
 * instruction is used, and the other form elsewhere. */
static inline int64_t fc_floor_shift64(int64_t v, uint8_t s) {
  if (INT64_C(-3) >> 1 == -2) return v >> s;
  return v < 0 ? -(int64_t)(~(uint64_t)v >> s) - 1 : (int64_t)((uint64_t)v >> s);
}

/* floor(v / 2^s), s 0..31. */
static inline int32_t fc_floor_shift32(int32_t v, uint8_t s) {
  if (INT32_C(-3) >> 1 == -2) return v >> s;
  return v < 0 ? -(int32_t)(~(uint32_t)v >> s) - 1 : (int32_t)((uint32_t)v >> s);
}

/* The two's complement value of a word. */
static inline int64_t fc_to_i64(uint64_t v) {
  return v >> 63 ? -(int64_t)(~v) - 1 : (int64_t)v;
}

static inline int32_t fc_to_i32(uint32_t v) {
  return v >> 31 ? -(int32_t)(~v) - 1 : (int32_t)v;
}

/* floor(v / 2^32). */
static inline int32_t fc_high_word(int64_t v) { return fc_to_i32((uint32_t)((uint64_t)v >> 32)); }

static inline int8_t fc_sign64(int64_t v) { return (int8_t)((v > 0) - (v < 0)); }

/* FC_READ of one object, both pointers to its type: an assignment where constant data is plain memory, as short ones need no
 * call. */
#ifdef FC_ROM_FAR
#define FC_READ_ONE(to, from) FC_READ((to), (from), sizeof *(to))
#else
#define FC_READ_ONE(to, from) ((void)(*(to) = *(from)))
#endif

#endif
