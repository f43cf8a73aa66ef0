/*
 * Ear clipping with exact decisions; triangulate.h says what it promises.
 */
#include "triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <utility>

namespace host {
namespace {

/* Coordinates lie in 0..2^54, so a cross product needs 111 bits and the sum of 65535 of them 127. */
constexpr int snap_bits = 54;
__extension__ typedef __int128 Wide;

struct Point {
  std::int64_t x, y;
};

bool operator==(Point a, Point b) {
  return a.x == b.x && a.y == b.y;
}

/* Twice the area of a, b, c; positive when they turn left. */
Wide cross(Point a, Point b, Point c) {
  return Wide{b.x - a.x} * (c.y - a.y) - Wide{b.y - a.y} * (c.x - a.x);
}

Wide distance_squared(Point a, Point b) {
  return Wide{b.x - a.x} * (b.x - a.x) + Wide{b.y - a.y} * (b.y - a.y);
}

/* The polygon in its plane, turning left; empty when it has no area. */
std::vector<Point> project(const std::vector<Vector> &vertices) {
  using Coordinates = std::array<long double, 3>;
  std::vector<Coordinates> relative;
  Coordinates low{}, high{};
  for (const Vector &v : vertices) {
    const Vector &first = vertices[0];
    relative.push_back({v.x.value - first.x.value, v.y.value - first.y.value, v.z.value - first.z.value});
    for (std::size_t axis = 0; axis < 3; axis++) {
      low[axis] = std::min(low[axis], relative.back()[axis]);
      high[axis] = std::max(high[axis], relative.back()[axis]);
    }
  }
  const long double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  int exponent = 0;
  std::frexp(extent, &exponent); /* extent < 2^exponent */
  Coordinates normal{};
  for (std::size_t i = 0; i < relative.size(); i++) {
    for (long double &coordinate : relative[i]) {
      coordinate = std::ldexp(coordinate, -exponent);
    }
    if (i > 0) {
      const Coordinates &a = relative[i - 1], &b = relative[i];
      normal[0] += a[1] * b[2] - a[2] * b[1];
      normal[1] += a[2] * b[0] - a[0] * b[2];
      normal[2] += a[0] * b[1] - a[1] * b[0];
    }
  }
  std::size_t drop = 0;
  for (std::size_t axis = 1; axis < 3; axis++) {
    drop = std::fabs(normal[axis]) > std::fabs(normal[drop]) ? axis : drop;
  }
  const std::size_t u = (drop + 1) % 3, v = (drop + 2) % 3;
  const long double low_u = std::ldexp(low[u], -exponent), low_v = std::ldexp(low[v], -exponent);
  std::vector<Point> points;
  Wide area = 0;
  for (const Coordinates &c : relative) {
    points.push_back({std::llrint(std::ldexp(c[u] - low_u, snap_bits)),
                      std::llrint(std::ldexp(c[v] - low_v, snap_bits))});
    if (points.size() > 2) {
      area += cross(points[0], points[points.size() - 2], points.back());
    }
  }
  if (area == 0) {
    points.clear();
  } else if (area < 0) {
    for (Point &point : points) { /* a mirrored polygon has the same ears */
      point.x = (std::int64_t{1} << snap_bits) - point.x;
    }
  }
  return points;
}

/* The ring of vertices that are left, and the triangles cut from it so far. */
class Clipper {
public:
  explicit Clipper(std::vector<Point> points)
      : points_(std::move(points)), left_(size()), vertices_(points_.size()) {
    for (int i = 0; i < size(); i++) {
      at(i).previous = (i + size() - 1) % size();
      at(i).next = (i + 1) % size();
    }
  }

  std::vector<std::array<int, 3>> run() {
    for (int i = 0; i < size() && left_ > 3; i++) {
      if (point(i) == point(at(i).next)) {
        clip(i);
      }
    }
    for_each_left([this](int i) { classify(i); });
    for_each_left([this](int i) { consider(i); });
    /* Clipping changes only the two neighbours unless the polygon crosses itself; a few full rounds catch
     * what such a polygon can still offer without making it slow. */
    int full_rounds = 4;
    while (left_ > 3) {
      int tip = pop_ear();
      if (tip < 0 && full_rounds > 0) {
        full_rounds--;
        for_each_left([this](int i) { consider(i); });
        tip = pop_ear();
      }
      if (tip < 0) {
        tip = find_without_area();
      }
      if (tip < 0) {
        break;
      }
      const int previous = at(tip).previous, next = at(tip).next;
      clip(tip);
      classify(previous);
      classify(next);
      consider(previous);
      consider(next);
    }
    fan();
    return std::move(triangles_);
  }

private:
  struct Vertex {
    int previous = 0, next = 0;
    int version = 0; /* tells outdated entries of the queue */
    bool gone = false;
    bool convex = false; /* strictly */
    bool listed = false; /* in blockers_ */
  };

  struct Ear {
    int shape, tip, version;
    bool operator<(const Ear &other) const {
      return shape != other.shape ? shape < other.shape : tip > other.tip;
    }
  };

  int size() const { return static_cast<int>(points_.size()); }
  Vertex &at(int i) { return vertices_[static_cast<std::size_t>(i)]; }
  const Vertex &at(int i) const { return vertices_[static_cast<std::size_t>(i)]; }
  Point point(int i) const { return points_[static_cast<std::size_t>(i)]; }

  template <typename Action>
  void for_each_left(Action action) {
    for (int i = 0; i < size(); i++) {
      if (!at(i).gone) {
        action(i);
      }
    }
  }

  Wide area_at(int i) const { return cross(point(at(i).previous), point(i), point(at(i).next)); }

  void classify(int i) {
    at(i).convex = area_at(i) > 0;
    if (!at(i).convex && !at(i).listed) {
      at(i).listed = true;
      blockers_.push_back(i);
    }
  }

  /* Puts i into the queue if it is the tip of an ear. */
  void consider(int i) {
    at(i).version++;
    if (at(i).convex && !is_blocked(i)) {
      const Point a = point(at(i).previous), b = point(i), c = point(at(i).next);
      const Wide longest = std::max({distance_squared(a, b), distance_squared(b, c), distance_squared(c, a)});
      ears_.push({static_cast<int>(cross(a, b, c) / (longest / 65536 + 1)), i, at(i).version});
    }
  }

  int pop_ear() {
    while (!ears_.empty()) {
      const Ear ear = ears_.top();
      ears_.pop();
      if (!at(ear.tip).gone && at(ear.tip).version == ear.version) {
        return ear.tip;
      }
    }
    return -1;
  }

  /* Only vertices that are not strictly convex can reach into an ear first. One on the cut blocks as well:
   * cutting there would leave it in the middle of a triangle's edge. */
  bool is_blocked(int tip) {
    const Point a = point(at(tip).previous), b = point(tip), c = point(at(tip).next);
    const std::int64_t low_x = std::min({a.x, b.x, c.x}), high_x = std::max({a.x, b.x, c.x});
    const std::int64_t low_y = std::min({a.y, b.y, c.y}), high_y = std::max({a.y, b.y, c.y});
    std::size_t kept = 0;
    bool blocked = false;
    for (const int i : blockers_) {
      if (at(i).gone || at(i).convex) {
        at(i).listed = false;
        continue;
      }
      blockers_[kept++] = i;
      const Point p = point(i);
      if (blocked || p.x < low_x || p.x > high_x || p.y < low_y || p.y > high_y || p == a || p == c ||
          i == tip) {
        continue;
      }
      if (p == b) { /* the ring touches itself here: does its other branch run into the ear? */
        blocked = is_within(a, b, c, point(at(i).previous)) || is_within(a, b, c, point(at(i).next));
      } else {
        blocked = cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
      }
    }
    blockers_.resize(kept);
    return blocked;
  }

  /* p lies strictly between the legs of the convex angle a, b, c. */
  static bool is_within(Point a, Point b, Point c, Point p) {
    return cross(a, b, p) > 0 && cross(b, c, p) > 0;
  }

  int find_without_area() {
    int found = -1;
    for_each_left([&](int i) { found = found < 0 && area_at(i) == 0 ? i : found; });
    return found;
  }

  void clip(int i) {
    Vertex &vertex = at(i);
    triangles_.push_back({vertex.previous, i, vertex.next});
    at(vertex.previous).next = vertex.next;
    at(vertex.next).previous = vertex.previous;
    vertex.gone = true;
    left_--;
  }

  void fan() {
    int first = 0;
    while (at(first).gone) {
      first++;
    }
    for (int i = at(first).next; at(i).next != first; i = at(i).next) {
      triangles_.push_back({first, i, at(i).next});
    }
  }

  std::vector<Point> points_;
  int left_;
  std::vector<Vertex> vertices_;
  std::vector<int> blockers_; /* vertices that are not strictly convex, cleaned when read */
  std::priority_queue<Ear> ears_;
  std::vector<std::array<int, 3>> triangles_;
};

} // namespace

std::vector<std::array<int, 3>> triangulate(const Polygon &polygon) {
  const int count = static_cast<int>(polygon.vertices.size());
  if (count == 3) {
    return {{0, 1, 2}};
  }
  std::vector<Point> points = project(polygon.vertices);
  if (points.empty()) {
    std::vector<std::array<int, 3>> flat;
    for (int i = 1; i + 1 < count; i++) {
      flat.push_back({0, i, i + 1});
    }
    return flat;
  }
  return Clipper(std::move(points)).run();
}

} // namespace host
