/* Cones and cylinders as triangles. */
#include "cone_mesh.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace host {
namespace {

using Real = long double;
using Triple = std::array<Real, 3>;

constexpr Real pi = 3.14159265358979323846264338327950288L;
constexpr int most_corners = 1024;

Number decimal(Real value) {
  char text[40];
  (void)std::snprintf(text, sizeof text, "%.12Lg", value);
  Number number{text, std::strtold(text, nullptr)};
  return number.value == 0 ? Number{} : number;
}

Triple values(const Vector &v) { return {v.x.value, v.y.value, v.z.value}; }

Triple cross(const Triple &a, const Triple &b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }

Triple unit(Triple v) {
  const Real length = std::hypot(v[0], v[1], v[2]);
  for (Real &c : v) c /= length;
  return v;
}

/* A ring's corners; the centre alone for radius 0. `across` and `up` are perpendicular units. */
std::vector<Vector> ring(const Vector &centre, Real radius, int corners, const Triple &across, const Triple &up) {
  if (radius == 0) return {centre};
  const Triple middle = values(centre);
  std::vector<Vector> points;
  for (int i = 0; i < corners; i++) {
    const Real angle = 2 * pi * static_cast<Real>(i) / static_cast<Real>(corners);
    std::array<Number, 3> point;
    for (std::size_t k = 0; k < 3; k++) point[k] = decimal(middle[k] + radius * (std::cos(angle) * across[k] + std::sin(angle) * up[k]));
    points.push_back({point[0], point[1], point[2]});
  }
  return points;
}

} // namespace

int cone_corners(long double relative_error) {
  int corners = 3;
  while (corners < most_corners && 1 - std::cos(pi / static_cast<Real>(corners)) > relative_error) corners++;
  return corners;
}

std::vector<Polygon> cone_mesh(const Cone &cone, long double relative_error, const Polygon &pattern) {
  const Triple base = values(cone.base), apex = values(cone.apex);
  const Triple axis = unit({apex[0] - base[0], apex[1] - base[1], apex[2] - base[2]});
  /* The coordinate axis that is farthest from the cone's. */
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; k++)
    if (std::fabs(axis[k]) < std::fabs(axis[least])) least = k;
  Triple other{};
  other[least] = 1;
  const Triple across = unit(cross(axis, other)), up = cross(axis, across);
  const int corners = cone_corners(relative_error);
  const std::vector<Vector> low = ring(cone.base, cone.base_radius.value, corners, across, up);
  const std::vector<Vector> high = ring(cone.apex, cone.apex_radius.value, corners, across, up);
  std::vector<Polygon> mesh;
  const auto add = [&](const Vector &a, const Vector &b, const Vector &c) {
    mesh.push_back(pattern);
    mesh.back().vertices = {a, b, c};
  };
  const auto count = static_cast<std::size_t>(corners);
  for (std::size_t i = 0; i < count; i++) {
    const std::size_t next = (i + 1) % count;
    if (low.size() > 1) add(low[i], low[next], high[high.size() > 1 ? next : 0]);
    if (high.size() > 1) add(low[low.size() > 1 ? i : 0], high[next], high[i]);
  }
  return mesh;
}

} // namespace host
