/* Products and shifts of two-word integers. */
#include "i128.h"

#include "bits.h"
#include "quick.h"

FC_COLD fc_i128 fc_i128_mul_u64(uint64_t a, uint64_t b) {
  uint32_t a0 = (uint32_t)a, a1 = (uint32_t)(a >> 32), b0 = (uint32_t)b, b1 = (uint32_t)(b >> 32);
  uint64_t low = fc_mul32(a0, b0), m1 = fc_mul32(a1, b0), m2 = fc_mul32(a0, b1);
  /* three terms below 2^32 each: no carry out of 64 bits */
  uint64_t middle = (low >> 32) + (uint32_t)m1 + (uint32_t)m2;
  fc_i128 r;
  r.lo = (middle << 32) | (uint32_t)low;
  r.hi = fc_mul32(a1, b1) + (m1 >> 32) + (m2 >> 32) + (middle >> 32);
  return r;
}

FC_COLD fc_i128 fc_i128_mul(int64_t a, int64_t b) {
  fc_i128 r = fc_i128_mul_u64(fc_abs64(a), fc_abs64(b));
  return (a < 0) != (b < 0) ? fc_i128_neg(r) : r;
}

FC_COLD fc_i128 fc_i128_scale(fc_i128 a, int64_t b) {
  fc_i128 m = fc_i128_abs(a);
  uint64_t s = fc_abs64(b);
  fc_i128 r = fc_i128_mul_u64(m.lo, s);
  r.hi += m.hi * s;
  return (fc_i128_sign(a) < 0) != (b < 0) ? fc_i128_neg(r) : r;
}

FC_COLD fc_i128 fc_i128_dot(const int64_t a[3], const int64_t b[3]) {
  fc_i128 r = fc_i128_mul(a[0], b[0]);
  r = fc_i128_add(r, fc_i128_mul(a[1], b[1]));
  return fc_i128_add(r, fc_i128_mul(a[2], b[2]));
}

FC_COLD fc_i128 fc_i128_shift_left(fc_i128 a, uint8_t s) {
  fc_i128 r;
  if (s == 0) return a;
  if (s >= 64) {
    r.lo = 0;
    r.hi = a.lo << (s - 64);
  } else {
    r.lo = a.lo << s;
    r.hi = (a.hi << s) | (a.lo >> (64 - s));
  }
  return r;
}

/* The sign is shifted in by hand, as C99 does not promise it. */
FC_COLD fc_i128 fc_i128_floor_shift(fc_i128 a, uint8_t s) {
  uint64_t fill = a.hi >> 63 ? UINT64_MAX : 0;
  fc_i128 r;
  if (s == 0) return a;
  if (s >= 64) {
    uint8_t t = (uint8_t)(s - 64);
    r.lo = t == 0 ? a.hi : (a.hi >> t) | (fill << (64 - t));
    r.hi = fill;
  } else {
    r.lo = (a.lo >> s) | (a.hi << (64 - s));
    r.hi = (a.hi >> s) | (fill << (64 - s));
  }
  return r;
}

FC_COLD fc_i128 fc_i128_round_shift(fc_i128 a, uint8_t s) {
  if (s == 0) return a;
  return fc_i128_floor_shift(fc_i128_add(a, fc_i128_shift_left(fc_i128_from(1), (uint8_t)(s - 1))), s);
}

FC_COLD uint8_t fc_i128_bits(fc_i128 a) {
  fc_i128 m = fc_i128_abs(a);
  return m.hi != 0 ? (uint8_t)(64 + fc_bits64(m.hi)) : fc_bits64(m.lo);
}
