/* Turning integer vectors about an axis. */
#include "turn.h"

#include <cstddef>

namespace host {
namespace {

constexpr std::int64_t one = std::int64_t{1} << 30;
constexpr std::int64_t two_pi_q30 = 6746518852;

/* a * b / 2^30, rounded to nearest; |a * b| below 2^62. */
std::int64_t times(std::int64_t a, std::int64_t b) {
  return (a * b + one / 2) >> 30;
}

/* r - r^3/3! + r^5/5! - r^7/7! + r^9/9! for |r| <= pi/4: the next term is below 2^-29. */
std::int64_t sine_of(std::int64_t r) {
  const std::int64_t square = times(r, r);
  std::int64_t sum = one - square / 72;
  sum = one - times(square, sum) / 42;
  sum = one - times(square, sum) / 20;
  sum = one - times(square, sum) / 6;
  return times(r, sum);
}

/* 1 - r^2/2! + ... - r^10/10! */
std::int64_t cosine_of(std::int64_t r) {
  const std::int64_t square = times(r, r);
  std::int64_t sum = one - square / 90;
  sum = one - times(square, sum) / 56;
  sum = one - times(square, sum) / 30;
  sum = one - times(square, sum) / 12;
  return one - times(square, sum) / 2;
}

std::uint64_t root(std::uint64_t v) {
  std::uint64_t result = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1)
    if ((result + bit) * (result + bit) <= v) result += bit;
  return result;
}

} // namespace

SineCosine sine_cosine(std::int64_t numerator, std::int64_t denominator) {
  numerator %= denominator;
  if (numerator < 0) numerator += denominator;
  const std::int64_t quarter = (8 * numerator / denominator + 1) / 2; /* the nearest multiple of a quarter turn, 0..4 */
  const std::int64_t rest = 4 * numerator - quarter * denominator;    /* in quarters of 1/denominator turn, |rest| <= denominator / 2 */
  const std::int64_t r = rest * two_pi_q30 / (4 * denominator);       /* 2^29 * 2^33 at most */
  const std::int64_t s = sine_of(r), c = cosine_of(r);
  switch (quarter & 3) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
  }
}

IntVector unit_q30(const IntVector &vector) {
  std::uint64_t square = 0; /* at most 3 * 2^60 */
  for (const std::int64_t v : vector) square += static_cast<std::uint64_t>(v * v);
  if (square == 0) return vector;
  /* Small vectors first grow, or the root would be coarse. */
  int shift = 0;
  while (square < std::uint64_t{1} << 60) square <<= 2, shift++;
  const auto length = static_cast<std::int64_t>(root(square));
  IntVector unit{};
  for (std::size_t i = 0; i < 3; i++) {
    const std::int64_t scaled = vector[i] * (std::int64_t{1} << shift); /* at most 2^31 */
    unit[i] = (scaled * one + (scaled < 0 ? -length / 2 : length / 2)) / length;
  }
  return unit;
}

IntVector turned(const IntVector &v, const IntVector &axis, const SineCosine &angle) {
  /* Components of v up to 2^31, axis and sines up to 2^30: each product is below 2^61, three of them below 2^63. */
  const std::int64_t along = (axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2]) / one;
  IntVector result{};
  for (std::size_t i = 0; i < 3; i++) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const std::int64_t across = (axis[j] * v[k] - axis[k] * v[j]) / one;
    result[i] = times(v[i], angle.cosine) + times(across, angle.sine) + times(times(axis[i], along), one - angle.cosine);
  }
  return result;
}

} // namespace host
