/* Values: square roots of whole numbers to the last bit, and the error in units of 2^-63 of every
 * operation (41). */
#include "trial.h"

using oracle::Q;
using oracle::Z;

namespace {

Z to_z(uint64_t v) { return static_cast<unsigned long>(v); }

/* |reported / exact - 1| < 2^-61, where exact^2 = square when root is set */
void check_value(const char *what, fc_num reported, const Q &exact, bool root, fc_num a, fc_num b) {
  Q r = to_z(reported.m);
  if (reported.e >= 0)
    r *= Q(Z(1) << static_cast<unsigned>(reported.e));
  else
    r /= Q(Z(1) << static_cast<unsigned>(-reported.e));
  if (root) r *= r;
  Q error = abs(Q(r / exact - 1)), bound(Z(1), Z(1) << (root ? 60 : 61)); /* a square is off twice as much */
  if (error > bound || !(reported.m >> 62 == 1))
    fail("%s: off by %.3f * 2^-63 (mantissa %#llx); a = %#llx * 2^%d, b = %#llx * 2^%d", what,
         error.get_d() * (root ? 0.5 : 1) * 9223372036854775808.0,
         static_cast<unsigned long long>(reported.m), static_cast<unsigned long long>(a.m), a.e,
         static_cast<unsigned long long>(b.m), b.e);
}

Q exact_of(fc_num a) {
  Q r = to_z(a.m);
  return a.e >= 0 ? Q(r * Q(Z(1) << static_cast<unsigned>(a.e)))
                  : Q(r / Q(Z(1) << static_cast<unsigned>(-a.e)));
}

fc_num random_num(Random &random) {
  /* long runs of zeros and ones as well: carries go far */
  uint64_t v = random.next();
  switch (random.within(0, 3)) {
    case 0: v &= random.next() & random.next(); break;
    case 1: v |= random.next() | random.next(); break;
    case 2: v = (UINT64_C(1) << random.within(0, 63)) + static_cast<uint64_t>(random.within(-2, 2)); break;
    default: break;
  }
  return fc_num_from_u64(v | (UINT64_C(1) << random.within(0, 63)),
                         static_cast<int32_t>(random.within(-200, 200)));
}

void check_floor_root(uint64_t v) {
  uint64_t r = fc_sqrt64(v);
  unsigned __int128 more = static_cast<unsigned __int128>(r + 1) * (r + 1);
  if (r * r > v || more <= v)
    fail("fc_sqrt64(%llu) = %llu", static_cast<unsigned long long>(v), static_cast<unsigned long long>(r));
}

/* fc_num's own division and square root, cheaply, in __int128: a quotient's and root's defining
 * inequalities. */
void check_small(uint64_t v) {
  fc_num a = fc_num_from_u64(v, 0), one = fc_num_from_u64(1, 0), inverse = fc_num_div(one, a),
         root = fc_num_sqrt(a);
  using Wide = unsigned __int128;
  /* m 2^e v = 1 within 2^-61, from below: 2^-e - m v < 2^-e-61, m v <= 2^-e, below 2^96 */
  Wide product = static_cast<Wide>(inverse.m) * v, whole = static_cast<Wide>(1) << -inverse.e;
  if (product > whole || whole - product > whole >> 61) fail("1 / %llu", static_cast<unsigned long long>(v));
  /* root^2 = v: m^2 against v 2^-2e, below 2^126 */
  Wide square = static_cast<Wide>(root.m) * root.m, exact = static_cast<Wide>(v) << (-2 * root.e);
  Wide difference = square > exact ? square - exact : exact - square;
  if (difference > exact >> 60) fail("sqrt(%llu)", static_cast<unsigned long long>(v));
}

uint64_t numbers(Random &random) {
  uint64_t checked = 0;
  /* the low bits of a seed are the trial's number: 2048 trials in a row visit every 16-bit input */
  for (uint64_t i = 0, first = (random.state & 2047) * 32; i < 32; i++) {
    uint64_t v = first + i;
    check_floor_root(v);
    if (v == 0) continue;
    check_small(v);
    check_floor_root(v * v);
    check_floor_root(v * v - 1);
  }
  /* 256 neighbours of 32 bits: 2^16 trials make 2^24 of them */
  uint64_t block = random.next() & 0xffffff00u;
  for (uint64_t i = 0; i < 256; i++) {
    uint64_t v = (block | i) == 0 ? 1 : block | i;
    check_floor_root(v);
    check_small(v);
    checked += 2;
  }
  static const uint64_t edges[] = {0,
                                   1,
                                   2,
                                   3,
                                   UINT64_MAX,
                                   UINT64_MAX - 1,
                                   UINT64_C(0xfffffffe00000001),
                                   UINT64_C(0xfffffffe00000000),
                                   UINT64_C(1) << 62,
                                   (UINT64_C(1) << 62) - 1,
                                   UINT64_C(1) << 63,
                                   (UINT64_C(1) << 63) - 1};
  for (uint64_t v : edges) check_floor_root(v);
  uint64_t r = random.next() >> 32;
  check_floor_root(r * r);
  if (r > 0) check_floor_root(r * r - 1);
  check_floor_root(random.next() >> random.within(0, 63));

  for (int i = 0; i < 4; i++) {
    fc_num a = random_num(random), b = random_num(random), one = fc_num_from_u64(1, 0);
    check_value("a b", fc_num_mul(a, b), Q(exact_of(a) * exact_of(b)), false, a, b);
    check_value("a / b", fc_num_div(a, b), Q(exact_of(a) / exact_of(b)), false, a, b);
    check_value("1 / a", fc_num_div(one, a), Q(1 / exact_of(a)), false, a, b);
    check_value("a + b", fc_num_add(a, b), Q(exact_of(a) + exact_of(b)), false, a, b);
    check_value("sqrt(a)", fc_num_sqrt(a), exact_of(a), true, a, b);
    /* two roundings */
    Q twice = Q(Z(1), Z(1) << 59);
    fc_num inverse = fc_num_div(one, fc_num_sqrt(a));
    Q square = exact_of(inverse) * exact_of(inverse) * exact_of(a);
    if (abs(Q(square - 1)) > twice) fail("1 / sqrt(%#llx * 2^%d)", static_cast<unsigned long long>(a.m), a.e);
    int order = cmp(exact_of(a), exact_of(b));
    if (fc_num_compare(a, b) != (order > 0) - (order < 0)) fail("fc_num_compare");
    int shift = static_cast<int>(random.within(-10, 70)) - a.e - 63;
    Q exact = exact_of(fc_num_scale(a, shift));
    Z half = (exact.get_num() * 2 + exact.get_den()) / (exact.get_den() * 2);
    uint64_t rounded = fc_num_round(a, shift);
    if (half >= Z(1) << 63 ? rounded != UINT64_MAX && to_z(rounded) != half : to_z(rounded) != half)
      fail("fc_num_round(%#llx * 2^%d, %d) = %llu", static_cast<unsigned long long>(a.m), a.e, shift,
           static_cast<unsigned long long>(rounded));
    checked += 8;
  }
  return checked;
}

} // namespace

const std::vector<Family> number_families = {
    {41, "roots and quotients", 131072, 150, numbers},
};
