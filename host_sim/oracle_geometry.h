/*
 * The oracle's geometric predicates, written once for both number types.
 *
 * Points on surfaces stay homogeneous (numerators and a positive denominator), so that a tie in a scene of
 * short binary numbers gives an exact zero and not a quotient that merely encloses one.
 */
#ifndef FIXCAST_HOST_ORACLE_GEOMETRY_H
#define FIXCAST_HOST_ORACLE_GEOMETRY_H

#include <array>
#include <cstddef>
#include <vector>

#include "oracle_number.h"

namespace host::oracle {

template <class T>
struct Vec {
  T x, y, z;
};

template <class T>
Vec<T> operator+(const Vec<T> &a, const Vec<T> &b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec<T> operator-(const Vec<T> &a, const Vec<T> &b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vec<T> operator*(const Vec<T> &a, const T &s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
T dot(const Vec<T> &a, const Vec<T> &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec<T> cross(const Vec<T> &a, const Vec<T> &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
Vec<T> vec(long double x, long double y, long double z) {
  return {T(x), T(y), T(z)};
}

/* The answer of a yes/no question. When not certain, `value` is what the tie rule says if every open sign is
 * exactly zero, and the other answer is possible too. */
struct Verdict {
  bool value = false;
  bool certain = true;
};

/* Applies a rule on signs, trying all values of the open ones: doubt counts only if it changes the answer. */
template <std::size_t N, class Rule>
Verdict judge(const std::array<Sign, N> &signs, Rule rule) {
  std::array<int, N> s{};
  std::size_t cases = 1;
  for (std::size_t i = 0; i < N; ++i) {
    s[i] = signs[i].value;
    if (signs[i].open) cases *= 3;
  }
  const bool by_rule = rule(s);
  for (std::size_t c = 0; cases > 1 && c < cases; ++c) {
    std::size_t rest = c;
    for (std::size_t i = 0; i < N; ++i) {
      if (signs[i].open) {
        s[i] = static_cast<int>(rest % 3) - 1;
        rest /= 3;
      }
    }
    if (rule(s) != by_rule) return {by_rule, false};
  }
  return {by_rule, true};
}

enum class Kind {
  sphere,
  plane,
  polygon
};

/* A sphere uses center and radius2; plane and polygon use normal and d; eye_side is |eye-center|^2 - radius^2
 * for a sphere and normal . eye + d for the others. */
template <class T>
struct Shape {
  Kind kind = Kind::sphere;
  Vec<T> center;
  T radius2;
  Vec<T> normal;
  T d;
  T eye_side;
  std::vector<Vec<T>> vertices;
};

/* Fixed vectors in no special direction, small integers to keep products exact. */
constexpr int auxiliary_count = 3;
template <class T>
Vec<T> auxiliary(int k) {
  static constexpr int table[auxiliary_count][3] = {
      {10691, -7537, 8713}, {-6173, 9241, 12799}, {14639, 5197, -9463}};
  return vec<T>(table[k][0], table[k][1], table[k][2]);
}

/* The line through apex along dir. With a nudge it is the line along dir + epsilon * nudge, epsilon positive
 * and smaller than everything else: a way to ask what lies to one side of an exact tie. */
template <class T>
struct Line {
  Vec<T> apex, dir;
  Vec<T> across; /* dir x auxiliary(0) */
  bool nudged = false;
  Vec<T> nudge;

  Line(const Vec<T> &through, const Vec<T> &along)
      : apex(through), dir(along), across(cross(along, auxiliary<T>(0))) {}
};

/* Does the line meet the polygon? Looking along the line, it is a point and the polygon a plane figure; the
 * point is inside if a half-line from it crosses an odd number of edges. The half-line lies in h = 0, where
 * h = vertex . across; an edge i -> j crosses the full line h = 0 if h_i and h_j differ in sign, and the side
 * it crosses on is the sign of dir . (v_i x v_j) times the sign of h_j - h_i. Vertices behind the apex need
 * no special care. Touching an edge or a vertex gives an uncertain yes. */
template <class T>
Verdict pierces(const Line<T> &line, const std::vector<Vec<T>> &vertices) {
  const std::size_t n = vertices.size();
  std::vector<Vec<T>> v;
  v.reserve(n);
  for (const Vec<T> &vertex : vertices)
    v.push_back(vertex - line.apex);
  std::vector<int> side(n);
  /* A vertex at h = 0 says nothing about the answer; another half-line avoids it unless the line itself
   * passes through the vertex. */
  for (int k = 0; k < auxiliary_count; ++k) {
    const Vec<T> across = k == 0 ? line.across : cross(line.dir, auxiliary<T>(k));
    std::size_t i = 0;
    for (; i < n; ++i) {
      side[i] = sign_of(dot(v[i], across)).value;
      if (side[i] == 0 && line.nudged) side[i] = sign_of(dot(v[i], cross(line.nudge, auxiliary<T>(k)))).value;
      if (side[i] == 0) break;
    }
    if (i < n) continue;
    bool inside = false;
    for (i = 0; i < n; ++i) {
      const std::size_t j = i + 1 < n ? i + 1 : 0;
      if (side[i] == side[j]) continue;
      const Vec<T> wedge = cross(v[i], v[j]);
      int turn = sign_of(dot(line.dir, wedge)).value;
      if (turn == 0 && line.nudged) turn = sign_of(dot(line.nudge, wedge)).value;
      if (turn == 0) return {true, false};
      if (turn == side[j]) inside = !inside;
    }
    return {inside, true};
  }
  return {true, false};
}

/* Where the eye ray meets a surface: at t = num / den, both positive. */
template <class T>
struct Hit {
  T num, den;
};

template <class T>
Sign compare(const Hit<T> &a, const Hit<T> &b) {
  return sign_of(a.num * b.den - b.num * a.den);
}

/* A point on a surface: position x / w with w > 0. */
template <class T>
struct Point {
  Vec<T> x;
  T w;
};

template <class T>
Point<T> point_at(const Line<T> &ray, const Hit<T> &hit) {
  return {ray.apex * hit.den + ray.dir * hit.num, hit.den};
}

/* Does the ray meet the sphere, or the plane (also a polygon's, whose outline is `pierces`), at t > 0? The
 * quotients avoid the subtraction of nearly equal numbers. */
template <class T>
Verdict reaches(const Shape<T> &shape, Sign eye_side, const Line<T> &ray, Hit<T> &hit) {
  if (shape.kind == Kind::sphere) {
    const T along = dot(ray.dir, shape.center - ray.apex);
    const Sign ahead = sign_of(along);
    const T dir2 = dot(ray.dir, ray.dir);
    if (eye_side.value == 0) {
      hit = {along + along, dir2};
      return judge<1>({ahead}, [](const auto &s) { return s[0] > 0; });
    }
    const T discriminant = along * along - dir2 * shape.eye_side;
    if (eye_side.value > 0) {
      const Verdict met =
          judge<2>({ahead, sign_of(discriminant)}, [](const auto &s) { return s[0] > 0 && s[1] >= 0; });
      if (met.value || !met.certain) hit = {shape.eye_side, along + root(discriminant)};
      return met;
    }
    if (ahead.value > 0)
      hit = {along + root(discriminant), dir2};
    else
      hit = {-shape.eye_side, root(discriminant) - along};
    return {true, true};
  }
  if (eye_side.value == 0) return {false, true};
  const T approach = eye_side.value > 0 ? -dot(shape.normal, ray.dir) : dot(shape.normal, ray.dir);
  const Sign toward = sign_of(approach);
  hit = {eye_side.value > 0 ? shape.eye_side : -shape.eye_side, approach};
  /* Parallel to the surface: there is no point to shade on the other side of this tie. */
  if (T::is_final && toward.value == 0) return {false, true};
  return judge<1>({toward}, [](const auto &s) { return s[0] > 0; });
}

/* Is the surface point p turned to the light? `to_light` is w * (light - p). */
template <class T>
Verdict faces(const Shape<T> &shape, Sign eye_side, Sign light_side, const Point<T> &p,
              const Vec<T> &to_light) {
  if (shape.kind != Kind::sphere)
    return judge<2>({eye_side, light_side}, [](const auto &s) { return s[0] * s[1] > 0; });
  if (eye_side.value <= 0) /* an eye on the sphere sees the inside of its far side */
    return judge<2>({light_side, sign_of(dot(to_light, to_light))},
                    [](const auto &s) { return s[0] <= 0 && s[1] > 0; });
  return judge<1>({sign_of(dot(p.x - shape.center * p.w, to_light))}, [](const auto &s) { return s[0] > 0; });
}

/* Does the sphere meet the open segment between p and the light? */
template <class T>
Verdict sphere_blocks(const Shape<T> &shape, Sign light_side, const Point<T> &p, const Vec<T> &to_light) {
  const Vec<T> to_center = shape.center * p.w - p.x;
  const T along = dot(to_center, to_light);
  const T length2 = dot(to_light, to_light);
  const T point_side = dot(to_center, to_center) - shape.radius2 * (p.w * p.w);
  const T discriminant = along * along - length2 * point_side;
  return judge<5>(
      {light_side, sign_of(point_side), sign_of(discriminant), sign_of(along), sign_of(length2 - along)},
      [](const auto &s) {
        if (s[0] * s[1] < 0) return true;
        if (s[0] == 0 && s[1] == 0) return false; /* a chord: the open segment is inside */
        return s[0] >= 0 && s[1] >= 0 && s[2] >= 0 && s[3] > 0 && s[4] > 0;
      });
}

/* Are p and the light on opposite sides of the plane? */
template <class T>
Verdict plane_separates(const Shape<T> &shape, Sign light_side, const Point<T> &p) {
  const Sign point_side = sign_of(dot(shape.normal, p.x) + shape.d * p.w);
  return judge<2>({light_side, point_side}, [](const auto &s) { return s[0] * s[1] < 0; });
}

/* `line` runs from the light through p. The outline is tested before the sides: p often lies exactly in the
 * plane of a neighbouring tile, which matters only if the line also meets that tile. */
template <class T>
Verdict blocks(const Shape<T> &shape, Sign light_side, const Line<T> &line, const Point<T> &p,
               const Vec<T> &to_light) {
  if (shape.kind == Kind::sphere) return sphere_blocks(shape, light_side, p, to_light);
  Verdict outline{true, true};
  if (shape.kind == Kind::polygon) outline = pierces(line, shape.vertices);
  if (!outline.value && outline.certain) return outline;
  const Verdict sides = plane_separates(shape, light_side, p);
  if (!sides.value && sides.certain) return sides;
  return {outline.value && sides.value, outline.certain && sides.certain};
}

} // namespace host::oracle

#endif
