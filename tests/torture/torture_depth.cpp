/* Depth codes: correctly rounded, monotone, and decoded within the stated bound (36). */
#include "trial.h"

using oracle::Q;
using oracle::Z;

namespace {

/* Errors of what codes decode to: 2^-15, 2^-14, 2^-13 for 2, 3, 4 exponent bits. */
uint64_t depth_codes(Random &random) {
  fc_frame frame = {};
  int bits = static_cast<int>(random.within(2, 4)), octaves = 1 << bits;
  frame.depth_exponent_bits = static_cast<uint8_t>(bits);
  frame.depth_near = static_cast<uint32_t>(random.within(1, INT64_C(1) << random.within(0, 32)));
  if (frame.depth_near == 0) frame.depth_near = UINT32_MAX;
  frame.view.focal = static_cast<int32_t>(random.within(1, coordinate_max));

  /* a z = t focal around a chosen code, at or beside the boundary of two */
  uint16_t code = static_cast<uint16_t>(random.within(1, 0xffff));
  int m_bits = 16 - bits;
  Z near = static_cast<unsigned long>(frame.depth_near), focal = static_cast<long>(frame.view.focal);
  Z mantissa2 = 2 * Z((1ul << m_bits) + (code & ((1u << m_bits) - 1))) + 1; /* twice, and a half */
  /* t = near 2^(octaves + m_bits - octave + 1) / (mantissa2 focal), halves exactly; p may carry one more
   * unit */
  Z p = near << static_cast<unsigned>(octaves + m_bits - (code >> m_bits) + 1), m = mantissa2 * focal;
  Z scale = 1;
  size_t wide = mpz_sizeinbase(p.get_mpz_t(), 2);
  size_t m_wide = mpz_sizeinbase(m.get_mpz_t(), 2);
  if (m_wide > wide) wide = m_wide;
  if (wide < 90) scale = Z(1) << static_cast<unsigned>(random.within(0, static_cast<int64_t>(90 - wide)));
  p = p * scale + random.within(-1, 1);
  m = m * scale;
  if (p <= 0) return 0;
  auto core = [](const Z &v) {
    fc_i128 r = {static_cast<uint64_t>(Z(v & UINT64_MAX).get_ui()),
                 static_cast<uint64_t>(Z(v >> 64).get_ui())};
    return r;
  };
  oracle::Root exact = {p, m, 0, 0};
  fc_root root = {core(p), core(m), {0, 0}, {0, 0}, 0};
  if (random.within(0, 3) == 0) {
    /* the same as a root of a quadratic, p - sqrt(d): d a square or one more or less */
    Z s = random.within(1, INT64_C(1) << random.within(1, 45)), up = p + s, d = s * s + random.within(-1, 1);
    if (mpz_sizeinbase(up.get_mpz_t(), 2) < 63 && mpz_sizeinbase(m.get_mpz_t(), 2) < 62) {
      exact = {up, m, d, -1};
      Z c = up * up - d;
      /* |p^2 - d| / m must be whole: let m be 1, and the focal length carry it */
      if (c > 0) {
        frame.view.focal = 1 + static_cast<int32_t>(random.within(0, 1000));
        exact.m = 1;
        root = {core(up), core(Z(1)), core(d), core(c), -1};
        oracle::Q z = oracle::approximate(exact) * static_cast<long>(frame.view.focal);
        if (z * 2 > Z(1) << 32) return 0;
        frame.depth_near = static_cast<uint32_t>(Z(Q(z).get_num() / Q(z).get_den()).get_ui()) + 1;
        near = static_cast<unsigned long>(frame.depth_near);
      } else {
        exact = {p, m, 0, 0};
      }
    }
  }
  uint16_t reported = fc_depth_code(&frame, &root);
  if (!oracle::depth_code_holds(reported, bits, frame.depth_near, exact, frame.view.focal))
    fail("fc_depth_code: %u does not round near / z; near %lu, focal %ld, %d exponent bits, %s", reported,
         static_cast<unsigned long>(frame.depth_near), static_cast<long>(frame.view.focal), bits,
         oracle::text(exact).c_str());

  /* decode: against near 2^.. / mantissa, the mantissa within 2^-30, and the whole cell of the code within
   * its bound */
  int exponent = 0, exponent_next = 0;
  frame.view.shift = static_cast<int16_t>(random.within(-30, 34));
  frame.view.fine = static_cast<uint8_t>(random.within(0, 31));
  auto decoded = [&](uint16_t c, int *e) {
    uint32_t mantissa = fc_depth_z(&frame, c, e);
    if (mantissa < UINT32_C(0x80000000))
      fail("fc_depth_z(%u): mantissa %lu", c, static_cast<unsigned long>(mantissa));
    Q z = static_cast<unsigned long>(mantissa);
    int up = *e - frame.view.shift + frame.view.fine;
    if (up >= 0)
      z *= Q(Z(1) << static_cast<unsigned>(up));
    else
      z /= Q(Z(1) << static_cast<unsigned>(-up));
    return z; /* in grid units */
  };
  auto value = [&](uint32_t c) {
    Q v(Z((1ul << m_bits) + (c & ((1u << m_bits) - 1))) << (c >> m_bits),
        Z(1) << static_cast<unsigned>(octaves + m_bits));
    v.canonicalize();
    return v;
  };
  Q z = decoded(code, &exponent), ideal = Q(Q(near) / value(code));
  if (abs(Q(z / ideal - 1)) > Q(1, 1ul << 30))
    fail("fc_depth_z(%u) is off by %g; near %lu, %d exponent bits", code, Q(z / ideal - 1).get_d(),
         static_cast<unsigned long>(frame.depth_near), bits);
  if (code < 0xffff && decoded(static_cast<uint16_t>(code + 1), &exponent_next) >= z)
    fail("fc_depth_z(%u) is not nearer than %u's", code + 1, code);
  /* farthest and nearest z that round to this code */
  if (code > 1 && code < 0xffff) {
    Q bound = Q(1, 1ul << (17 - bits)) + Q(1, 1ul << 29);
    Q far = Q(near) / ((value(code - 1u) + value(code)) / 2),
      close = Q(near) / ((value(code) + value(code + 1u)) / 2);
    if (abs(Q(z / far - 1)) > bound || abs(Q(z / close - 1)) > bound)
      fail("code %u holds z beyond its stated error", code);
  }

  /* whole numbers of z in a row: codes never rise with z */
  uint64_t first = static_cast<uint64_t>(random.within(1, INT64_C(1) << random.within(1, 40)));
  uint16_t last = 0xffff;
  frame.view.focal = 1;
  for (uint64_t i = 0; i < 4; i++) {
    fc_root at = {fc_i128_from_u64(first + i), fc_i128_from_u64(1), {0, 0}, {0, 0}, 0};
    uint16_t now = fc_depth_code(&frame, &at);
    if (now > last || now == 0)
      fail("depth code %u at z = %llu after %u", now, static_cast<unsigned long long>(first + i), last);
    last = now;
  }
  return 6;
}

} // namespace

const std::vector<Family> depth_families = {
    {36, "depth codes", 1000000, 14, depth_codes},
};
