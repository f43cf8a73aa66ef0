/* Arithmetic of positive values. */
#include "num.h"

#include "bits.h"
#include "quick.h"

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

/*
 * floor(2^(k n) rest / b) for rest < b, b in 2^62 .. 2^63 - 1, n digits of k <= 21 bits; what is left of rest is dropped. A digit
 * is estimated from the first 31 bits of rest and a reciprocal of the first 32 of b, which is rounded down: too small by less
 * than 2^21 (2^-25 + 2^-30) + 1 < 1 + 2^-3, so rest stays below b (1 + 2^-3) < 2^64, and differences that wrap on the way are
 * right.
 */
static FC_COLD uint64_t quotient(uint64_t rest, uint64_t b, uint8_t k, uint8_t n) {
  const fc_quick r = fc_quick_recip(fc_quick_from(b >> 31, 0)); /* within 2^-26 */
  const uint32_t inverse = r.m - (r.m >> 25) - 1;
  uint64_t q = 0;
  for (; n != 0; n--) {
    /* rest / b = 2 (rest / 2^32) / (b / 2^31) */
    uint32_t digit = fc_mulhi32((uint32_t)(rest >> 32), inverse) >> (-r.e - 33 - k);
    q = (q << k) + digit;
    rest = (rest << k) - (fc_mul32((uint32_t)b, digit) + ((uint64_t)((uint32_t)(b >> 32) * digit) << 32));
  }
  return rest >= b ? q + 1 : q;
}

FC_COLD fc_num fc_num_div(fc_num a, fc_num b) {
  fc_num r = {0, 0};
  uint64_t rest = a.m;
  if (a.m == 0) return r;
  r.e = a.e - b.e - 63;
  if (rest >= b.m) {
    /* 1 and a fraction, of which a bit less */
    r.e++;
    r.m = (UINT64_C(1) << 62) + (quotient(rest - b.m, b.m, 21, 3) >> 1);
  } else {
    r.m = quotient(rest, b.m, 21, 3);
  }
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
  /* normalised to 2^62 .. 2^64 - 1: 1 / root within 2^-26, so the root within 2^7, and after a step by what is left within 1 */
  uint8_t s;
  fc_quick y;
  uint64_t m, root;
  int64_t rest;
  uint32_t r;
  if (v == 0) return 0;
  s = (uint8_t)(fc_clz64(v) / 2);
  m = v << (2 * s);
  y = fc_quick_rsqrt(fc_quick_from(m >> 32, 0)); /* y.m 2^y.e = 1 / sqrt(m / 2^32), 2^31 .. 2^32 times 2^-47 or 2^-46 */
  root = fc_mul32((uint32_t)(m >> 32), y.m) >> (-y.e - 16);
  r = root >> 32 != 0 ? UINT32_MAX : (uint32_t)root;
  rest = fc_to_i64(m - fc_mul32(r, r)); /* below 2^41 */
  /* + rest y / 2 */
  root = r + (uint64_t)fc_floor_shift64(fc_floor_shift64(rest, 10) * (int64_t)(y.m >> 16), (uint8_t)(-y.e - 9));
  r = root >> 32 != 0 ? UINT32_MAX : (uint32_t)root;
  while (fc_mul32(r, r) > m) r--;
  while (m - fc_mul32(r, r) > 2 * (uint64_t)r) r++;
  return r >> s;
}

FC_COLD fc_num fc_num_sqrt(fc_num a) {
  /* An even exponent: m in 2^62 .. 2^64. r0 = floor(sqrt m) >= 2^31, rest = m - r0^2 <= 2 r0 < 2^33. The exact root is
   * r0 + f with f = rest/(2 r0) - f^2/(2 r0), so the next 31 bits by one division are off by less than
   * 2^31 / (2 r0) <= 1/2 plus truncation: relative error below 2^-61. */
  uint64_t m = a.m, r0, half;
  int32_t e = a.e;
  if (m == 0) return a;
  if (e & 1) {
    m <<= 1;
    e--;
  }
  r0 = fc_sqrt64(m);
  half = (m - fc_mul32((uint32_t)r0, (uint32_t)r0)) << 30; /* of the rest, below r0 2^31 but where the fraction is all ones */
  if (half >= r0 << 31) half = (r0 << 31) - 1;
  return fc_num_from_u64((r0 << 31) + (quotient(half, r0 << 31, 16, 2) >> 1), e / 2 - 31);
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
