/* Products and shifts of two-word integers. */
#include "i128.h"

#include "bits.h"
#include "quick.h"

FC_COLD void fc_i128_plus(fc_i128 *r, const fc_i128 *b) {
  uint64_t lo = r->lo + b->lo;
  r->hi += b->hi + (lo < r->lo);
  r->lo = lo;
}

FC_COLD void fc_i128_negate(fc_i128 *r) {
  r->lo = 0u - r->lo;
  r->hi = ~r->hi + (r->lo == 0);
}

FC_COLD void fc_i128_minus(fc_i128 *r, const fc_i128 *b) {
  fc_i128 less = *b;
  fc_i128_negate(&less);
  fc_i128_plus(r, &less);
}

FC_COLD void fc_i128_set_product_u64(fc_i128 *r, uint64_t a, uint64_t b) {
  uint32_t a0 = (uint32_t)a, a1 = (uint32_t)(a >> 32), b0 = (uint32_t)b, b1 = (uint32_t)(b >> 32);
  r->hi = 0;
  r->lo = fc_mul32(a0, b0);
  if ((a1 | b1) != 0) { /* most numbers are short, or one of two is */
    uint64_t m = b1 == 0 ? fc_mul32(a1, b0) : fc_mul32(a0, b1);
    /* up to three terms below 2^32 each: no carry out of 64 bits */
    uint64_t middle = (r->lo >> 32) + (uint32_t)m;
    r->hi = m >> 32;
    if (a1 != 0 && b1 != 0) {
      m = fc_mul32(a1, b0);
      middle += (uint32_t)m;
      r->hi += fc_mul32(a1, b1) + (m >> 32);
    }
    r->lo = (middle << 32) | (uint32_t)r->lo;
    r->hi += middle >> 32;
  }
}

FC_COLD void fc_i128_set_product(fc_i128 *r, int64_t a, int64_t b) {
  fc_i128_set_product_u64(r, fc_abs64(a), fc_abs64(b));
  if ((a < 0) != (b < 0)) fc_i128_negate(r);
}

FC_COLD fc_i128 fc_i128_scale(fc_i128 a, int64_t b) {
  /* modulo 2^128, where a product with the high word is one of 64 bits */
  fc_i128 r = fc_i128_mul_u64(a.lo, (uint64_t)b);
  r.hi += a.hi * (uint64_t)b;
  if (b < 0) r.hi -= a.lo;
  return r;
}

FC_COLD fc_i128 fc_i128_dot(const int64_t a[3], const int64_t b[3]) {
  fc_i128 r = {0, 0}, term;
  uint8_t i;
  for (i = 0; i < 3; i++) {
    fc_i128_set_product(&term, a[i], b[i]);
    fc_i128_plus(&r, &term);
  }
  return r;
}

FC_COLD int8_t fc_i128_compare(fc_i128 a, fc_i128 b) { return fc_i128_sign(fc_i128_sub(a, b)); }

FC_COLD fc_i128 fc_i128_shift_left(fc_i128 a, uint8_t s) {
  if (s >= 64) {
    a.hi = a.lo;
    a.lo = 0;
  }
  s &= 63;
  if (s != 0) {
    a.hi = a.hi << s | a.lo >> (64 - s);
    a.lo <<= s;
  }
  return a;
}

FC_COLD fc_i128 fc_i128_floor_shift(fc_i128 a, uint8_t s) {
  int64_t hi = fc_to_i64(a.hi);
  if (s >= 64) {
    a.lo = a.hi;
    hi = -(hi < 0);
  }
  s &= 63;
  if (s != 0) {
    a.lo = a.lo >> s | (uint64_t)hi << (64 - s);
    hi = fc_floor_shift64(hi, s);
  }
  a.hi = (uint64_t)hi;
  return a;
}

FC_COLD fc_i128 fc_i128_round_shift(fc_i128 a, uint8_t s) {
  if (s == 0) return a;
  a = fc_i128_floor_shift(a, (uint8_t)(s - 1));
  if (++a.lo == 0) a.hi++;
  return fc_i128_floor_shift(a, 1);
}

FC_COLD void fc_i128_move(fc_i128 *r, int16_t s) {
  *r = s >= 0 ? fc_i128_shift_left(*r, (uint8_t)s) : fc_i128_round_shift(*r, (uint8_t)-s);
}

FC_COLD uint8_t fc_i128_bits(fc_i128 a) {
  fc_i128 m = fc_i128_abs(a);
  return m.hi != 0 ? (uint8_t)(64 + fc_bits64(m.hi)) : fc_bits64(m.lo);
}
