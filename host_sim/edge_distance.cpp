/* How far a wrong pixel is from being right. */
#include "edge_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace host {
namespace {

/* For a wrong id the light doesn't matter: the edge in question is the object's. */
bool gives_core_answer(const OraclePixel &truth, const WrongPixel &pixel, std::size_t lights) {
  return std::any_of(truth.answers.begin(), truth.answers.end(), [&](const OracleAnswer &answer) {
    return answer.object == pixel.core_object &&
           (pixel.wrong_id || same_light(pixel.core_lit, answer, lights));
  });
}

bool reached(const Oracle &oracle, const WrongPixel &pixel, std::size_t lights, double radius) {
  constexpr int directions = 32;
  constexpr double two_pi = 6.28318530717958647692;
  for (int i = 0; i < directions; i++) {
    const double angle = two_pi * i / directions;
    if (gives_core_answer(oracle.pixel(pixel.x, pixel.y, radius * std::cos(angle), radius * std::sin(angle)),
                          pixel, lights))
      return true;
  }
  return false;
}

} // namespace

double edge_distance_px(const Oracle &oracle, const WrongPixel &pixel, std::size_t lights) {
  constexpr double step = 1.5;
  double outside = edge_distance_min_px;
  if (reached(oracle, pixel, lights, outside)) return outside;
  for (;;) {
    if (outside >= edge_distance_max_px) return std::numeric_limits<double>::infinity();
    double inside = std::min(outside * step, edge_distance_max_px);
    if (!reached(oracle, pixel, lights, inside)) {
      outside = inside;
      continue;
    }
    for (int i = 0; i < 12; i++) { /* 1.5^(1/4096): three digits and to spare */
      const double middle = std::sqrt(outside * inside);
      (reached(oracle, pixel, lights, middle) ? inside : outside) = middle;
    }
    return inside;
  }
}

} // namespace host
