/* Arithmetic of positive values. */
#include "num.h"

#include "bits.h"
#include "quick.h"

FC_COLD void fc_num_set(fc_num *r, uint64_t v, int32_t exponent) {
  uint8_t s;
  r->m = 0;
  r->e = 0;
  if (v == 0) return;
  s = fc_clz64(v);
  r->m = v << s >> 1;
  r->e = exponent - s + 1;
}

FC_COLD void fc_num_set_abs(fc_num *r, const fc_i128 *v) {
  fc_i128 a = fc_i128_abs(*v);
  uint8_t s;
  if (a.hi == 0) {
    fc_num_set(r, a.lo, 0);
    return;
  }
  /* a.hi below 2^63 */
  s = fc_clz64(a.hi);
  fc_num_set(r, (a.hi << s) | (a.lo >> (64 - s)), 64 - s);
}

FC_COLD void fc_num_times(fc_num *r, const fc_num *b) {
  /* 2^62..2^63 squared: 2^124 .. 2^126; from the top word's highest bit on, 63 bits */
  fc_i128 p = fc_i128_mul_u64(r->m, b->m);
  uint8_t s;
  if (p.hi == 0) { /* a factor is 0 */
    fc_num_set(r, 0, 0);
    return;
  }
  s = (uint8_t)(2 - (p.hi >> 61));
  r->m = (p.hi << s) | (p.lo >> (64 - s));
  r->e += b->e + 64 - s;
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
    rest = (rest << k) - fc_times(b, digit);
  }
  return rest >= b ? q + 1 : q;
}

FC_COLD void fc_num_over(fc_num *r, const fc_num *b) {
  uint64_t rest = r->m;
  if (rest == 0) return;
  r->e -= b->e + 63;
  if (rest >= b->m) {
    /* 1 and a fraction, of which a bit less */
    r->e++;
    r->m = (UINT64_C(1) << 62) + (quotient(rest - b->m, b->m, 21, 3) >> 1);
  } else {
    r->m = quotient(rest, b->m, 21, 3);
  }
}

/* b cut to the places of a.m; 0 when it is below them, UINT64_MAX when it is above. */
static FC_COLD uint64_t aligned(const fc_num *b, const fc_num *a) {
  int32_t s = a->e - b->e;
  if (b->m == 0 || s > 63) return 0;
  return s < 0 ? UINT64_MAX : b->m >> s;
}

FC_COLD void fc_num_plus(fc_num *r, const fc_num *b) {
  const fc_num *high = r, *low = b;
  if (fc_num_order_of(r, b) < 0) {
    high = b;
    low = r;
  }
  fc_num_set(r, high->m + aligned(low, high), high->e); /* below 2^64 */
}

FC_COLD void fc_num_minus(fc_num *r, const fc_num *b) {
  uint64_t m = aligned(b, r);
  fc_num_set(r, m < r->m ? r->m - m : 0, r->e);
}

FC_COLD void fc_num_times_u64(fc_num *r, uint64_t v) {
  fc_num b;
  fc_num_set(&b, v, 0);
  fc_num_times(r, &b);
}

FC_COLD void fc_num_over_u64(fc_num *r, uint64_t v) {
  fc_num b;
  fc_num_set(&b, v, 0);
  fc_num_over(r, &b);
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

FC_COLD void fc_num_root(fc_num *r) {
  /* An even exponent: m in 2^62 .. 2^64. r0 = floor(sqrt m) >= 2^31, rest = m - r0^2 <= 2 r0 < 2^33. The exact root is
   * r0 + f with f = rest/(2 r0) - f^2/(2 r0), so the next 31 bits by one division are off by less than
   * 2^31 / (2 r0) <= 1/2 plus truncation: relative error below 2^-61. */
  uint64_t m = r->m, r0, half;
  int32_t e = r->e;
  if (m == 0) return;
  if (e & 1) {
    m <<= 1;
    e--;
  }
  r0 = fc_sqrt64(m);
  half = (m - fc_mul32((uint32_t)r0, (uint32_t)r0)) << 30; /* of the rest, below r0 2^31 but where the fraction is all ones */
  r0 <<= 31;
  if (half >= r0) half = r0 - 1;
  fc_num_set(r, r0 + (quotient(half, r0, 16, 2) >> 1), e / 2 - 31);
}

FC_COLD int8_t fc_num_order_of(const fc_num *a, const fc_num *b) {
  if (a->m == 0 || b->m == 0) return (int8_t)((a->m != 0) - (b->m != 0));
  if (a->e != b->e) return a->e < b->e ? -1 : 1;
  return (int8_t)((a->m > b->m) - (a->m < b->m));
}

FC_COLD uint64_t fc_num_rounded(const fc_num *r, int32_t shift) {
  int32_t s = -(r->e + shift); /* bits to drop; 64: below 2^63/2^64 = 1/2 */
  if (r->m == 0 || s > 63) return 0;
  if (s < -1) return UINT64_MAX;
  if (s <= 0) return r->m << -s;
  return ((r->m >> (s - 1)) + 1) >> 1;
}
