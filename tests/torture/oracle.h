/* What exact arithmetic says about rays, segments and depths: GMP integers, no code and no formula of the
 * core. */
#ifndef TORTURE_ORACLE_H
#define TORTURE_ORACLE_H

#include <gmpxx.h>

#include <string>
#include <vector>

#include "vec.h"

namespace oracle {

using Z = mpz_class;
using Q = mpq_class;

struct Shape {
  enum Kind {
    sphere,
    plane,
    triangle
  } kind;
  Vec a, b, c; /* center; normal; the three vertices */
  int64_t r;   /* radius; k of normal . p = k */
};

inline Shape sphere(Vec center, int64_t radius) {
  return {Shape::sphere, center, {0, 0, 0}, {0, 0, 0}, radius};
}
inline Shape plane(Vec normal, int64_t k) { return {Shape::plane, normal, {0, 0, 0}, {0, 0, 0}, k}; }
inline Shape triangle(Vec a, Vec b, Vec c) { return {Shape::triangle, a, b, c, 0}; }

/* Sign of x + y sqrt(d) + z sqrt(e) by enclosure, wide enough to tell 0 from the least non-zero value. */
int surd_sign(const Z &x, const Z &y, const Z &d, const Z &z, const Z &e);

/* t = (p + q sqrt(d)) / m, m > 0. */
struct Root {
  Z p, m, d;
  int q;
};
int compare(const Root &a, const Root &b);
/* Below the exact value by less than 2^-200. */
Q approximate(const Root &root);
/* Sign of t - value. */
int compare(const Root &root, const Q &value);

/* All t > 0, ascending, with the ties of the specification. */
std::vector<Root> roots(const Shape &shape, Vec origin, Vec direction);

/* Whether the ray passes exactly through an edge or vertex of a triangle (its nudge matters). */
bool is_tie(const Shape &triangle, Vec origin, Vec direction);

/* The first shape within t_min < t < t_max (Q32), or -1; endless: t_max does not count. */
int nearest(const std::vector<Shape> &shapes, Vec origin, Vec direction, uint64_t t_min_q32,
            uint64_t t_max_q32, Root *root, bool endless = false);

/* An exact point (u + v sqrt(d)) / m. */
struct Point {
  Z u[3], v[3], m, d;
};
Point point_of(Vec p);
Point point_at(const Root &root, Vec origin, Vec direction);

/* Whether the open segment meets the shape. */
bool blocked(const Shape &shape, const Point &point, Vec light);
/* Whether the side that a ray (origin, direction) sees at `point` faces the light. */
bool faces(const Shape &shape, Vec origin, Vec direction, const Point &point, Vec light);
/* Whether the ray meets the back: normal . direction > 0. */
bool from_inside(const Shape &shape, Vec direction, const Point &point);

/* Not rounded yet: the unit normal's component i as a fraction, towards the ray's side, error below
 * 2^-100. */
Q normal_component(const Shape &shape, Vec direction, const Point &point, int i);
/* Weight of triangle vertex i at the hit. */
Q weight(const Shape &triangle, Vec origin, Vec direction, int i);
/* Component i of the point, error below 2^-150. */
Q coordinate(const Point &point, int i);

/* Whether `code` is near / z correctly rounded, halves up, z = t focal. */
bool depth_code_holds(uint16_t code, int exponent_bits, uint32_t near, const Root &root, int64_t focal);

std::string text(const Shape &shape);
std::string text(Vec v);
std::string text(const Root &root);

} // namespace oracle

#endif
