/* Closed meshes: edges, parts, volumes, crossings; and how far they are convex. */
#include "closed_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

namespace host {
namespace {

__extension__ using Wide = __int128;
using Edge = std::pair<std::uint16_t, std::uint16_t>;

struct Box {
  std::array<std::int32_t, 3> low, high;
};

std::array<std::int32_t, 3> axes(const fc_vec3 &v) {
  return {v.x, v.y, v.z};
}

/* Above 0 when d is on the side from which a, b, c run clockwise: 32 bits, 3 factors, 6 terms: below 2^99. */
Wide orient(const fc_vec3 &a, const fc_vec3 &b, const fc_vec3 &c, const fc_vec3 &d) {
  const Wide bx = Wide(b.x) - a.x, by = Wide(b.y) - a.y, bz = Wide(b.z) - a.z;
  const Wide cx = Wide(c.x) - a.x, cy = Wide(c.y) - a.y, cz = Wide(c.z) - a.z;
  const Wide dx = Wide(d.x) - a.x, dy = Wide(d.y) - a.y, dz = Wide(d.z) - a.z;
  return bx * (cy * dz - cz * dy) + by * (cz * dx - cx * dz) + bz * (cx * dy - cy * dx);
}

int sign(Wide v) {
  return (v > 0) - (v < 0);
}

class Mesh {
public:
  Mesh(const std::vector<fc_vec3> &vertices, std::vector<std::array<std::uint16_t, 3>> faces)
      : vertices_(vertices), faces_(std::move(faces)) {}

  bool is_closed(const std::array<long double, 3> &eye) {
    return is_outside(eye) && pair_edges() && encloses_volume() && !crosses_itself();
  }

  /* log2 of the margin, floored; -1: below 1, or not convex. The margin is the least of a corner's distance from a face over one more
   * than the sum of the magnitudes of its barycentric weights there, and of a sixteenth of a face's least height. In long
   * doubles: within 2^-20 of itself, which is taken off. */
  int convex_margin() {
    long double least = std::ldexp(1.0L, 30);
    std::vector<std::uint16_t> corners;
    for (const auto &face : faces_)
      corners.insert(corners.end(), face.begin(), face.end());
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (std::size_t f = 0; f < faces_.size() && least >= 1; f++) {
      if (part_of(f) != part_of(0)) return -1;
      for (std::uint16_t v : corners)
        if (std::find(faces_[f].begin(), faces_[f].end(), v) == faces_[f].end())
          least = std::min(least, margin_below(f, vertices_[v]));
      least = std::min(least, least_height(f) / 16);
    }
    least -= std::ldexp(least, -20);
    return least < 1 ? -1 : std::ilogb(least);
  }

private:
  using Vector = std::array<long double, 3>;

  static Vector difference(const fc_vec3 &a, const fc_vec3 &b) {
    return {static_cast<long double>(a.x) - b.x, static_cast<long double>(a.y) - b.y, static_cast<long double>(a.z) - b.z};
  }

  static Vector cross(const Vector &a, const Vector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  static long double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  /* Twice the area over the longest side; 0 without area. */
  long double least_height(std::size_t face) const {
    const Vector sides[3] = {difference(corner(face, 1), corner(face, 0)), difference(corner(face, 2), corner(face, 1)),
                             difference(corner(face, 0), corner(face, 2))};
    const Vector n = cross(sides[0], sides[1]);
    long double longest = 1;
    for (const Vector &side : sides)
      longest = std::max(longest, dot(side, side));
    return std::sqrt(dot(n, n) / longest);
  }

  /* Distance of a corner below a face, over what it takes; below 0 above it. */
  long double margin_below(std::size_t face, const fc_vec3 &v) const {
    const Wide below = -orient(corner(face, 0), corner(face, 1), corner(face, 2), v);
    if (below <= 0) return -1;
    const Vector ab = difference(corner(face, 1), corner(face, 0)), ac = difference(corner(face, 2), corner(face, 0));
    const Vector n = cross(ab, ac), av = difference(v, corner(face, 0));
    const long double square = dot(n, n);
    const long double second = dot(cross(av, ac), n) / square, third = dot(cross(ab, av), n) / square;
    const long double weights = std::fabs(1 - second - third) + std::fabs(second) + std::fabs(third);
    return static_cast<long double>(below) / std::sqrt(square) / (1 + weights);
  }

  const fc_vec3 &corner(std::size_t face, std::size_t i) const { return vertices_[faces_[face][i]]; }

  Box box_of(std::size_t face) const {
    Box box{axes(corner(face, 0)), axes(corner(face, 0))};
    for (std::size_t i = 1; i < 3; i++)
      for (std::size_t k = 0; k < 3; k++) {
        const std::int32_t v = axes(corner(face, i))[k];
        box.low[k] = std::min(box.low[k], v);
        box.high[k] = std::max(box.high[k], v);
      }
    return box;
  }

  bool is_outside(const std::array<long double, 3> &eye) {
    for (std::size_t f = 0; f < faces_.size(); f++)
      boxes_.push_back(box_of(f));
    for (std::size_t k = 0; k < 3; k++) {
      std::int32_t low = boxes_[0].low[k], high = boxes_[0].high[k];
      for (const Box &box : boxes_) {
        low = std::min(low, box.low[k]);
        high = std::max(high, box.high[k]);
      }
      if (eye[k] < low || eye[k] > high) return true;
    }
    return false;
  }

  std::size_t part_of(std::size_t face) {
    while (parent_[face] != face)
      face = parent_[face] = parent_[parent_[face]];
    return face;
  }

  /* Every directed edge occurs once, and so does its opposite. */
  bool pair_edges() {
    parent_.resize(faces_.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (std::size_t f = 0; f < faces_.size(); f++)
      for (std::size_t i = 0; i < 3; i++)
        if (!edges_.insert({{faces_[f][i], faces_[f][(i + 1) % 3]}, f}).second) return false;
    for (const auto &[edge, face] : edges_) {
      const auto other = edges_.find({edge.second, edge.first});
      if (edge.first == edge.second || other == edges_.end()) return false;
      parent_[part_of(face)] = part_of(other->second);
    }
    return true;
  }

  bool encloses_volume() {
    std::map<std::size_t, std::pair<long double, long double>> volumes; /* and the sum of sizes */
    for (std::size_t f = 0; f < faces_.size(); f++) {
      const std::size_t part = part_of(f);
      const auto v = static_cast<long double>(
          orient(corner(part, 0), corner(f, 0), corner(f, 1), corner(f, 2)));
      volumes[part].first += v;
      volumes[part].second += std::fabs(v);
    }
    return std::all_of(volumes.begin(), volumes.end(),
                       [](const auto &part) { return part.second.first > 1e-9L * part.second.second; });
  }

  /* Whether a segment meets a closed triangle. */
  bool meets(const fc_vec3 &p, const fc_vec3 &q, std::size_t face) const {
    const fc_vec3 &a = corner(face, 0), &b = corner(face, 1), &c = corner(face, 2);
    if (sign(orient(a, b, c, p)) * sign(orient(a, b, c, q)) > 0) return false;
    const int ab = sign(orient(p, q, a, b)), bc = sign(orient(p, q, b, c)), ca = sign(orient(p, q, c, a));
    return !((ab > 0 || bc > 0 || ca > 0) && (ab < 0 || bc < 0 || ca < 0));
  }

  bool crosses_itself() const {
    std::vector<std::size_t> order(faces_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [this](std::size_t a, std::size_t b) { return boxes_[a].low[0] < boxes_[b].low[0]; });
    for (std::size_t i = 0; i < order.size(); i++)
      for (std::size_t j = i + 1; j < order.size() && boxes_[order[j]].low[0] <= boxes_[order[i]].high[0]; j++)
        if (overlap(order[i], order[j]) && (pierces(order[i], order[j]) || pierces(order[j], order[i]))) return true;
    return false;
  }

  bool overlap(std::size_t f, std::size_t g) const {
    for (std::size_t k = 0; k < 3; k++)
      if (boxes_[f].low[k] > boxes_[g].high[k] || boxes_[g].low[k] > boxes_[f].high[k]) return false;
    return true;
  }

  bool pierces(std::size_t f, std::size_t g) const {
    for (std::size_t i = 0; i < 3; i++) {
      const std::uint16_t p = faces_[f][i], q = faces_[f][(i + 1) % 3];
      const auto shared = [&](std::uint16_t v) { return v == p || v == q; };
      if (std::none_of(faces_[g].begin(), faces_[g].end(), shared) && meets(vertices_[p], vertices_[q], g)) return true;
    }
    return false;
  }

  const std::vector<fc_vec3> &vertices_;
  std::vector<std::array<std::uint16_t, 3>> faces_;
  std::vector<Box> boxes_;
  std::vector<std::size_t> parent_;
  std::map<Edge, std::size_t> edges_;
};

} // namespace

std::vector<std::uint8_t> cull_values(const std::vector<fc_vec3> &vertices, const std::vector<fc_triangle> &triangles,
                                      const std::array<long double, 3> &eye) {
  std::map<std::uint16_t, std::vector<std::size_t>> objects;
  for (std::size_t i = 0; i < triangles.size(); i++)
    objects[triangles[i].object].push_back(i);
  std::vector<std::uint8_t> cull(triangles.size(), 0);
  for (const auto &[object, members] : objects) {
    if (members.size() < 4) continue;
    std::vector<std::array<std::uint16_t, 3>> faces;
    for (std::size_t i : members)
      faces.push_back({triangles[i].vertex[0], triangles[i].vertex[1], triangles[i].vertex[2]});
    Mesh mesh(vertices, std::move(faces));
    if (!mesh.is_closed(eye)) continue;
    const int margin = mesh.convex_margin();
    for (std::size_t i : members)
      cull[i] = static_cast<std::uint8_t>(margin < 0 ? 1 : 2 + margin);
  }
  return cull;
}

} // namespace host
