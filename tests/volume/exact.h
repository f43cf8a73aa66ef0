/* Exact geometry in fractions (GMP), by formulas that the core does not use: points tried, polygons clipped. */
#ifndef VOLUME_EXACT_H
#define VOLUME_EXACT_H

#include <gmpxx.h>

#include <vector>

#include "vec.h"

namespace exact {

using Q = mpq_class;

struct Point {
  Q x[3];
};

inline Q whole(int64_t v) { return Q(static_cast<long>(v)); }
inline Point point(Vec v) { return {{whole(v.x), whole(v.y), whole(v.z)}}; }
inline Point operator+(const Point &a, const Point &b) {
  return {{a.x[0] + b.x[0], a.x[1] + b.x[1], a.x[2] + b.x[2]}};
}
inline Point operator-(const Point &a, const Point &b) {
  return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
}
inline Point operator*(const Point &a, const Q &k) { return {{a.x[0] * k, a.x[1] * k, a.x[2] * k}}; }
inline Q dot(const Point &a, const Point &b) { return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2]; }
inline Point cross(const Point &a, const Point &b) {
  return {{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2],
           a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}

/* A closed half-space n . p <= k. */
struct Half {
  Point n;
  Q k;
};

/* What is left of a convex polygon (or segment or point) in a half-space: Sutherland and Hodgman 1974. */
inline std::vector<Point> clip(const std::vector<Point> &polygon, const Half &half) {
  std::vector<Point> kept;
  for (size_t i = 0; i < polygon.size(); i++) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    Q at_a = dot(half.n, a) - half.k, at_b = dot(half.n, b) - half.k;
    if (sgn(at_a) <= 0) kept.push_back(a);
    if (sgn(at_a) * sgn(at_b) < 0) kept.push_back(a + (b - a) * Q(at_a / (at_a - at_b)));
  }
  return kept;
}

/* The six half-spaces of low <= p <= high. */
inline std::vector<Half> box(Vec low, Vec high) {
  std::vector<Half> halves;
  for (int i = 0; i < 3; i++) {
    Vec axis = {0, 0, 0};
    axis[i] = 1;
    halves.push_back({point(axis), whole(high[i])});
    halves.push_back({point(-axis), whole(-low[i])});
  }
  return halves;
}

inline bool polygon_meets(std::vector<Point> polygon, const std::vector<Half> &halves) {
  for (const Half &half : halves) polygon = clip(polygon, half);
  return !polygon.empty();
}

/* The t >= 0 at which a ray is inside all half-spaces: entry and exit are among 0 and the crossings, so try them all. Unbounded
 * volumes are not for this one. */
inline bool ray_meets(Vec origin, Vec direction, const std::vector<Half> &halves, Q *enter, Q *leave) {
  Point o = point(origin), d = point(direction);
  std::vector<Q> tries = {Q(0)};
  for (const Half &half : halves) {
    Q speed = dot(half.n, d);
    if (sgn(speed) != 0) tries.push_back(Q((half.k - dot(half.n, o)) / speed));
  }
  bool met = false;
  for (const Q &t : tries) {
    if (sgn(t) < 0) continue;
    Point p = o + d * t;
    bool inside = true;
    for (const Half &half : halves) inside = inside && dot(half.n, p) <= half.k;
    if (!inside) continue;
    if (!met || t < *enter) *enter = t;
    if (!met || t > *leave) *leave = t;
    met = true;
  }
  return met;
}

} // namespace exact

#endif
