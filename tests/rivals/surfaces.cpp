/* Hidden surfaces of triangles without rays (other shapes are left out): z-buffer, painter's algorithm, BSP tree, Warnock's subdivision. */
#include <algorithm>
#include <memory>

#include "picture.h"

namespace {

/* A convex polygon in camera space with its primitive. */
template <typename T>
struct Polygon {
  std::vector<Vector<T>> corners;
  uint16_t primitive;
};

/* On the screen: pixels, and 1 / z, which is affine there. */
template <typename T>
struct Corner {
  T x, y, w;
};
template <typename T>
struct Flat {
  std::vector<Corner<T>> corners; /* counter-clockwise or clockwise */
  uint16_t primitive;
  T w0, wx, wy; /* 1 / z = w0 + wx x + wy y */
};

const double near_z = 1.0 / 64;

/* What is in front of the near plane (Sutherland and Hodgman). */
template <typename T>
Polygon<T> clip_near(const Polygon<T> &p) {
  Polygon<T> kept = {{}, p.primitive};
  const T limit = T(near_z);
  for (size_t i = 0; i < p.corners.size(); i++) {
    Vector<T> a = p.corners[i], b = p.corners[(i + 1) % p.corners.size()];
    if (a.z >= limit) kept.corners.push_back(a);
    if ((a.z < limit) != (b.z < limit)) kept.corners.push_back(a + (b - a) * ((limit - a.z) / (b.z - a.z)));
  }
  return kept;
}

template <typename T>
std::vector<Polygon<T>> polygons_of(const Picture &picture) {
  std::vector<Polygon<T>> all;
  for (size_t i = 0; i < picture.shapes.size(); i++) {
    const Shape &s = picture.shapes[i];
    if (s.kind != Shape::triangle) continue;
    all.push_back({{in<T>(s.a), in<T>(s.b), in<T>(s.c)}, static_cast<uint16_t>(i)});
  }
  return all;
}

/* Projected; false when nothing is left or it is seen edge-on. */
template <typename T>
bool flatten(const Picture &picture, const Polygon<T> &polygon, Flat<T> *flat) {
  Polygon<T> front = clip_near(polygon);
  flat->corners.clear();
  flat->primitive = polygon.primitive;
  if (front.corners.size() < 3) return false;
  const T half_focal = T(picture.focal / 2), middle_x = T(picture.width / 2.0),
          middle_y = T(picture.height / 2.0);
  for (Vector<T> c : front.corners)
    flat->corners.push_back(
        {middle_x + c.x * half_focal / c.z, middle_y - c.y * half_focal / c.z, T(1.0) / c.z});
  /* the plane n . p = k gives 1 / z = (n.x x + n.y y + n.z) / k along (x, y, 1) */
  const Vector<T> e = polygon.corners[1] - polygon.corners[0], f = polygon.corners[2] - polygon.corners[0],
                  n = cross(e, f);
  const T k = dot(n, polygon.corners[0]);
  if (k >= T(0.0) && k <= T(0.0)) return false;
  flat->wx = n.x / k / half_focal;
  flat->wy = -n.y / k / half_focal;
  flat->w0 = n.z / k - flat->wx * middle_x - flat->wy * middle_y;
  return true;
}

/* On which side of each edge; edges themselves count as inside, whoever comes first or nearest keeps the pixel. */
template <typename T>
bool covers(const Flat<T> &flat, T x, T y) {
  bool left = false, right = false;
  for (size_t i = 0; i < flat.corners.size(); i++) {
    const Corner<T> &a = flat.corners[i], &b = flat.corners[(i + 1) % flat.corners.size()];
    const T side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    left = left || side > T(0.0);
    right = right || side < T(0.0);
  }
  return !(left && right);
}

template <typename T, typename Draw>
void each_pixel(const Picture &picture, const Flat<T> &flat, Draw draw) {
  T low_x = flat.corners[0].x, high_x = low_x, low_y = flat.corners[0].y, high_y = low_y;
  for (const Corner<T> &c : flat.corners) {
    if (c.x < low_x) low_x = c.x;
    if (c.x > high_x) high_x = c.x;
    if (c.y < low_y) low_y = c.y;
    if (c.y > high_y) high_y = c.y;
  }
  for (int y = 0; y < picture.height; y++) {
    const T cy = T(y + 0.5);
    if (cy < low_y || cy > high_y) continue;
    for (int x = 0; x < picture.width; x++) {
      const T cx = T(x + 0.5);
      if (cx < low_x || cx > high_x || !covers(flat, cx, cy)) continue;
      draw(static_cast<size_t>(y) * static_cast<size_t>(picture.width) + static_cast<size_t>(x),
           flat.w0 + flat.wx * cx + flat.wy * cy);
    }
  }
}

template <typename T>
void fill(const Picture &picture, const Polygon<T> &polygon, Pixels *pixels) {
  Flat<T> flat;
  if (flatten(picture, polygon, &flat))
    each_pixel(picture, flat, [&](size_t at, T) { (*pixels)[at] = polygon.primitive; });
}

template <typename T>
double as_double(T v) {
  return static_cast<double>(v);
}
#ifdef __SIZEOF_INT128__
template <>
double as_double(Fixed v) {
  return static_cast<double>(v.v) / 65536;
}
#endif

Pixels empty(const Picture &picture) {
  return Pixels(static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height),
                static_cast<uint16_t>(nothing));
}

} // namespace

template <typename T>
Pixels z_buffer(const Picture &picture, int depth_bits) {
  Pixels pixels = empty(picture);
  std::vector<T> nearest(pixels.size(), T(0.0));
  std::vector<uint32_t> code(pixels.size(), 0);
  double nearest_z =
      1e9; /* the codes' range begins at the nearest thing there is, as it would be tuned by hand */
  for (const Shape &s : picture.shapes)
    nearest_z =
        std::min(nearest_z, s.kind == Shape::sphere ? s.a.z - s.r : std::min(s.a.z, std::min(s.b.z, s.c.z)));
  nearest_z = std::max(nearest_z, near_z);
  for (const Polygon<T> &polygon : polygons_of<T>(picture)) {
    Flat<T> flat;
    if (!flatten(picture, polygon, &flat)) continue;
    each_pixel(picture, flat, [&](size_t at, T w) {
      if (depth_bits == 0) {
        if (!(w > nearest[at])) return;
        nearest[at] = w;
      } else { /* near / z as a whole number of that many bits */
        const uint32_t now = static_cast<uint32_t>(std::min(as_double(w) * nearest_z, 1.0) *
                                                   ((UINT32_C(1) << depth_bits) - 1));
        if (now <= code[at]) return;
        code[at] = now;
      }
      pixels[at] = polygon.primitive;
    });
  }
  return pixels;
}

/* Far to near by the mean depth of their corners: wrong where triangles are long or go through each other. */
template <typename T>
Pixels painter(const Picture &picture) {
  std::vector<Polygon<T>> all = polygons_of<T>(picture);
  auto depth = [](const Polygon<T> &p) { return p.corners[0].z + p.corners[1].z + p.corners[2].z; };
  std::stable_sort(all.begin(), all.end(),
                   [&](const Polygon<T> &p, const Polygon<T> &q) { return depth(p) > depth(q); });
  Pixels pixels = empty(picture);
  for (const Polygon<T> &p : all) fill(picture, p, &pixels);
  return pixels;
}

namespace {

/* Fuchs, Kedem, Naylor 1980. */
template <typename T>
struct Node {
  Vector<T> n;
  T k;
  std::vector<Polygon<T>> here;
  std::unique_ptr<Node> front, back;
};

template <typename T>
std::unique_ptr<Node<T>> tree_of(std::vector<Polygon<T>> polygons) {
  if (polygons.empty()) return nullptr;
  std::unique_ptr<Node<T>> node(new Node<T>);
  const Polygon<T> &first = polygons[polygons.size() / 2];
  node->n = cross(first.corners[1] - first.corners[0], first.corners[2] - first.corners[0]);
  const T length = root(dot(node->n, node->n));
  const T epsilon = T(1.0 / 8192); /* the usual thickness of a plane: what is within counts as on it */
  if (length > T(0.0)) node->n = {node->n.x / length, node->n.y / length, node->n.z / length};
  node->k = dot(node->n, first.corners[0]);
  std::vector<Polygon<T>> front, back;
  const size_t own = polygons.size() / 2;
  for (size_t i = 0; i < polygons.size(); i++) {
    Polygon<T> &p = polygons[i];
    std::vector<T> at;
    bool ahead = false, behind = false;
    for (Vector<T> c : p.corners) {
      at.push_back(dot(node->n, c) - node->k);
      ahead = ahead || at.back() > epsilon;
      behind = behind || at.back() < -epsilon;
    }
    if (i == own || (!ahead && !behind)) {
      node->here.push_back(p);
    } else if (!behind) {
      front.push_back(p);
    } else if (!ahead) {
      back.push_back(p);
    } else {
      Polygon<T> one = {{}, p.primitive}, two = one;
      for (size_t c = 0; c < p.corners.size(); c++) {
        const size_t next = (c + 1) % p.corners.size();
        if (at[c] >= T(0.0)) one.corners.push_back(p.corners[c]);
        if (at[c] <= T(0.0)) two.corners.push_back(p.corners[c]);
        if ((at[c] > T(0.0) && at[next] < T(0.0)) || (at[c] < T(0.0) && at[next] > T(0.0))) {
          Vector<T> cut_at = p.corners[c] + (p.corners[next] - p.corners[c]) * (at[c] / (at[c] - at[next]));
          one.corners.push_back(cut_at);
          two.corners.push_back(cut_at);
        }
      }
      if (one.corners.size() > 2) front.push_back(one);
      if (two.corners.size() > 2) back.push_back(two);
    }
  }
  node->front = tree_of(std::move(front));
  node->back = tree_of(std::move(back));
  return node;
}

/* What is on the eye's far side of each plane first. */
template <typename T>
void draw_tree(const Picture &picture, const Node<T> *node, Pixels *pixels) {
  if (node == nullptr) return;
  const bool eye_in_front = node->k < T(0.0); /* n . 0 - k > 0 */
  draw_tree(picture, (eye_in_front ? node->back : node->front).get(), pixels);
  for (const Polygon<T> &p : node->here) fill(picture, p, pixels);
  draw_tree(picture, (eye_in_front ? node->front : node->back).get(), pixels);
}

} // namespace

template <typename T>
Pixels bsp(const Picture &picture) {
  Pixels pixels = empty(picture);
  draw_tree(picture, tree_of(polygons_of<T>(picture)).get(), &pixels);
  return pixels;
}

namespace {

/* Warnock 1969: a window that nothing is in, or that the nearest of all covers, is filled; any other is cut into four, down to a pixel. */
template <typename T>
class Warnock {
public:
  Warnock(const Picture &picture) : picture_(picture), pixels(empty(picture)) {
    std::vector<const Flat<T> *> all;
    for (const Polygon<T> &p : polygons_of<T>(picture)) {
      Flat<T> flat;
      if (flatten(picture, p, &flat)) flats_.push_back(flat);
    }
    for (const Flat<T> &f : flats_) all.push_back(&f);
    window(0, 0, picture.width, picture.height, all);
  }

private:
  const Picture &picture_;
  std::vector<Flat<T>> flats_;

public:
  Pixels pixels;

private:
  T depth(const Flat<T> &f, T x, T y) const { return f.w0 + f.wx * x + f.wy * y; }

  /* Whether all centres of the window lie beyond one edge of it, or beside its box. */
  bool misses(const Flat<T> &f, const T x[4], const T y[4]) const {
    T middle_x = T(0.0), middle_y = T(0.0);
    for (const Corner<T> &c : f.corners) {
      middle_x = middle_x + c.x;
      middle_y = middle_y + c.y;
    }
    const T n = T(static_cast<double>(f.corners.size()));
    middle_x = middle_x / n;
    middle_y = middle_y / n;
    for (size_t i = 0; i < f.corners.size(); i++) {
      const Corner<T> &a = f.corners[i], &b = f.corners[(i + 1) % f.corners.size()];
      auto side = [&](T px, T py) { return (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x); };
      const bool positive = side(middle_x, middle_y) > T(0.0);
      int beyond = 0;
      for (int k = 0; k < 4; k++) beyond += positive ? side(x[k], y[k]) < T(0.0) : side(x[k], y[k]) > T(0.0);
      if (beyond == 4) return true;
    }
    return false;
  }

  void window(int x0, int y0, int x1, int y1, const std::vector<const Flat<T> *> &above) {
    if (x0 >= x1 || y0 >= y1) return;
    const T x[4] = {T(x0 + 0.5), T(x1 - 0.5), T(x0 + 0.5), T(x1 - 0.5)},
            y[4] = {T(y0 + 0.5), T(y0 + 0.5), T(y1 - 0.5), T(y1 - 0.5)};
    std::vector<const Flat<T> *> in_it;
    for (const Flat<T> *f : above)
      if (!misses(*f, x, y)) in_it.push_back(f);
    if (in_it.empty()) return;
    const Flat<T> *shown = nullptr;
    for (const Flat<T> *f : in_it) { /* one that surrounds the window and is nearest at its four corners */
      bool good = true;
      for (int k = 0; k < 4 && good; k++) good = covers(*f, x[k], y[k]);
      for (const Flat<T> *g : in_it)
        for (int k = 0; k < 4 && good; k++) good = depth(*f, x[k], y[k]) >= depth(*g, x[k], y[k]);
      if (good) {
        shown = f;
        break;
      }
    }
    /* a window of one pixel is its centre: what covers it nearest surrounds it, so one is shown */
    if (shown == nullptr && x1 - x0 == 1 && y1 - y0 == 1) return;
    if (shown != nullptr) {
      for (int row = y0; row < y1; row++)
        for (int column = x0; column < x1; column++)
          pixels[static_cast<size_t>(row) * static_cast<size_t>(picture_.width) +
                 static_cast<size_t>(column)] = shown->primitive;
      return;
    }
    const int mx = (x0 + x1 + 1) / 2, my = (y0 + y1 + 1) / 2;
    window(x0, y0, mx, my, in_it);
    window(mx, y0, x1, my, in_it);
    window(x0, my, mx, y1, in_it);
    window(mx, my, x1, y1, in_it);
  }
};

} // namespace

template <typename T>
Pixels warnock(const Picture &picture) {
  return Warnock<T>(picture).pixels;
}

#define FOR(T) \
  template Pixels z_buffer<T>(const Picture &, int); \
  template Pixels painter<T>(const Picture &); \
  template Pixels bsp<T>(const Picture &); \
  template Pixels warnock<T>(const Picture &);
FOR(float)
FOR(double)
#ifdef __SIZEOF_INT128__
FOR(Fixed)
#endif
