/* Arithmetic of positive values. */
#include "num.h"

#include "bits.h"

FC_COLD fc_num fc_num_from_u64(uint64_t v, int32_t exponent) {
  fc_num r = {0, 0};
  if (v >> 63) {
    r.m = v >> 1;
    r.e = exponent + 1;
  } else if (v != 0) {
    uint8_t s = (uint8_t)(fc_clz64(v) - 1);
    r.m = v << s;
    r.e = exponent - s;
  }
  return r;
}

FC_COLD fc_num fc_num_from_abs(fc_i128 v) {
  fc_i128 a = fc_i128_abs(v);
  uint8_t s;
  if (a.hi == 0) return fc_num_from_u64(a.lo, 0);
  /* a.hi < 2^63, so the shift keeps at least 64 significant bits in hi:lo before the cut */
  s = fc_clz64(a.hi);
  a = fc_i128_shift_left(a, s);
  return fc_num_from_u64(a.hi, 64 - s);
}

FC_COLD fc_num fc_num_mul(fc_num a, fc_num b) {
  /* 2^62..2^63 squared: 2^124 .. 2^126 */
  fc_i128 p = fc_i128_mul_u64(a.m, b.m);
  fc_num r = {0, 0};
  if (a.m == 0 || b.m == 0) return r;
  if (p.hi >> 61) {
    r.m = (p.hi << 1) | (p.lo >> 63);
    r.e = a.e + b.e + 63;
  } else {
    r.m = (p.hi << 2) | (p.lo >> 62);
    r.e = a.e + b.e + 62;
  }
  return r;
}

FC_COLD fc_num fc_num_div(fc_num a, fc_num b) {
  fc_num r = {0, 0};
  uint64_t rest = a.m, q = 0;
  uint8_t i, bits = 63;
  if (a.m == 0) return r;
  r.e = a.e - b.e - 62;
  if (rest < b.m) {
    /* quotient below 1: one bit more, so that the top bit is set */
    rest <<= 1;
    r.e--;
  }
  /* restoring division: rest < 2 b.m < 2^64 throughout */
  for (i = 0; i < bits; i++) {
    q <<= 1;
    if (rest >= b.m) {
      rest -= b.m;
      q |= 1;
    }
    rest <<= 1;
  }
  r.m = q;
  return r;
}

FC_COLD fc_num fc_num_add(fc_num a, fc_num b) {
  fc_num t;
  int32_t s;
  if (a.m == 0) return b;
  if (b.m == 0) return a;
  if (a.e < b.e) {
    t = a;
    a = b;
    b = t;
  }
  s = a.e - b.e;
  if (s < 64) a.m += b.m >> s; /* below 2^64 */
  return fc_num_from_u64(a.m, a.e);
}

FC_COLD fc_num fc_num_sub(fc_num a, fc_num b) {
  int32_t s = a.e - b.e;
  fc_num zero = {0, 0};
  if (b.m == 0) return a;
  if (s < 0) return zero;
  if (s < 64) {
    uint64_t m = b.m >> s;
    if (m >= a.m) return zero;
    a.m -= m;
  }
  return fc_num_from_u64(a.m, a.e);
}

FC_COLD uint32_t fc_sqrt64(uint64_t v) {
  uint64_t root = 0, bit = (uint64_t)1 << 62;
  while (bit != 0) {
    if (v >= root + bit) {
      v -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
    bit >>= 2;
  }
  return (uint32_t)root;
}

FC_COLD fc_num fc_num_sqrt(fc_num a) {
  /* An even exponent: m in 2^62 .. 2^64. r0 = floor(sqrt m) >= 2^31, rest = m - r0^2 <= 2 r0 < 2^33. The exact root is
   * r0 + f with f = rest/(2 r0) - f^2/(2 r0), so the next 31 bits by one division are off by less than
   * 2^31 / (2 r0) <= 1/2 plus truncation: relative error below 2^-61. */
  uint64_t m = a.m, r0, rest;
  int32_t e = a.e;
  if (m == 0) return a;
  if (e & 1) {
    m <<= 1;
    e--;
  }
  r0 = fc_sqrt64(m);
  rest = m - r0 * r0;
  return fc_num_from_u64((r0 << 31) + ((rest << 30) / r0), e / 2 - 31);
}

FC_COLD int8_t fc_num_compare(fc_num a, fc_num b) {
  if (a.m == 0 || b.m == 0) return (int8_t)((a.m != 0) - (b.m != 0));
  if (a.e != b.e) return a.e < b.e ? -1 : 1;
  return (int8_t)((a.m > b.m) - (a.m < b.m));
}

FC_COLD fc_num fc_num_scale(fc_num a, int32_t exponent) {
  if (a.m != 0) a.e += exponent;
  return a;
}

FC_COLD uint64_t fc_num_round(fc_num a, int32_t shift) {
  int32_t s = -(a.e + shift); /* bits to drop */
  if (a.m == 0 || s > 64) return 0;
  if (s < 0) return s == -1 ? a.m << 1 : UINT64_MAX;
  if (s == 0) return a.m;
  if (s == 64) return 0; /* below 2^63/2^64 = 1/2 */
  return ((a.m >> (s - 1)) + 1) >> 1;
}
