/* Turning integer vectors about an axis. */
#include "turn.h"

#include <cstddef>

#include "fixcast/rotation.h"

namespace host {
namespace {

constexpr std::int64_t one = std::int64_t{1} << 30;
/* a * b / 2^30, rounded to nearest; |a * b| below 2^62. */
std::int64_t times(std::int64_t a, std::int64_t b) { return (a * b + one / 2) >> 30; }

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
  const auto angle = static_cast<std::uint32_t>(((numerator << 33) / denominator + 1) / 2); /* wraps from a full turn to none */
  return {fc_sin_q30(angle), fc_cos_q30(angle)};
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

std::int64_t length_of(const IntVector &vector) {
  std::uint64_t square = 0; /* at most 3 * 2^62 */
  for (const std::int64_t v : vector) square += static_cast<std::uint64_t>(v * v);
  return static_cast<std::int64_t>(root(square));
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
