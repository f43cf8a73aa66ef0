/* Turning integer vectors about an axis by any part of a turn, rounded in integers, so that every machine gives the same bits. */
#ifndef FIXCAST_HOST_TURN_H
#define FIXCAST_HOST_TURN_H

#include <array>
#include <cstdint>

namespace host {

/* Components up to 2^31. */
using IntVector = std::array<std::int64_t, 3>;

/* Sine and cosine of numerator / denominator of a full turn, Q30, within 2^-29; exact at quarter turns. The denominator is 1..2^30. */
struct SineCosine {
  std::int64_t sine = 0, cosine = 0;
};
SineCosine sine_cosine(std::int64_t numerator, std::int64_t denominator);

/* The vector's direction with length 1 in Q30, a component within 2 units; (0, 0, 0) stays. Components up to 2^30. */
IntVector unit_q30(const IntVector &vector);

/* Rounded down; components up to 2^31. */
std::int64_t length_of(const IntVector &vector);

/* `vector`, turned about `axis_q30` (length 1), counter-clockwise seen from the axis' tip; rounded to whole numbers. */
IntVector turned(const IntVector &vector, const IntVector &axis_q30, const SineCosine &angle);

} // namespace host

#endif
