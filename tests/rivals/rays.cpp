/* Closest hit a pixel, with textbook formulas for spheres and triangles. */
#include "picture.h"

namespace {

/* a t^2 + b t + c = 0 (lecture "Sampling and Object intersection", analytical). */
template <typename T>
bool sphere_by_algebra(Vector<T> d, Vector<T> center, T radius, T *t) {
  const Vector<T> o = Vector<T>{T(0.0), T(0.0), T(0.0)} - center;
  const T a = dot(d, d), b = T(2.0) * dot(o, d), c = dot(o, o) - radius * radius,
          disc = b * b - T(4.0) * a * c;
  if (disc < T(0.0)) return false;
  const T s = root(disc), near = (-b - s) / (T(2.0) * a), far = (-b + s) / (T(2.0) * a);
  *t = near > T(0.0) ? near : far;
  return *t > T(0.0);
}

/* By the foot of the center on the ray (Haines; Real-Time Rendering, "ray/sphere, optimized"); d is of unit length. */
template <typename T>
bool sphere_by_geometry(Vector<T> d, Vector<T> center, T radius, T *t) {
  const T along = dot(center, d), l2 = dot(center, center), r2 = radius * radius;
  if (along < T(0.0) && l2 > r2) return false;
  const T m2 = l2 - along * along;
  if (m2 > r2) return false;
  const T q = root(r2 - m2);
  *t = l2 > r2 ? along - q : along + q;
  return *t > T(0.0);
}

/* Cramer's rule (Moller and Trumbore 1997). */
template <typename T>
bool triangle_by_cramer(Vector<T> d, Vector<T> v0, Vector<T> v1, Vector<T> v2, T *t) {
  const Vector<T> e1 = v1 - v0, e2 = v2 - v0, p = cross(d, e2);
  const T a = dot(p, e1);
  if (a >= T(0.0) && a <= T(0.0)) return false;
  const Vector<T> s = Vector<T>{T(0.0), T(0.0), T(0.0)} - v0, q = cross(s, e1);
  const T u = dot(p, s) / a, v = dot(q, d) / a;
  if (u < T(0.0) || v < T(0.0) || u + v > T(1.0)) return false;
  *t = dot(q, e2) / a;
  return *t > T(0.0);
}

/* The plane first, then barycentrics of the point, with the normal's largest axis dropped. */
template <typename T>
bool triangle_by_plane(Vector<T> d, Vector<T> v0, Vector<T> v1, Vector<T> v2, T *t) {
  const Vector<T> n = cross(v1 - v0, v2 - v0);
  const T nd = dot(n, d);
  if (nd >= T(0.0) && nd <= T(0.0)) return false;
  *t = dot(n, v0) / nd;
  if (!(*t > T(0.0))) return false;
  const Vector<T> p = d * *t - v0, e1 = v1 - v0, e2 = v2 - v0;
  int k = 0;
  for (int i = 1; i < 3; i++)
    if (magnitude(n[i]) > magnitude(n[k])) k = i;
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const T det = n[k], u = (p[i] * e2[j] - p[j] * e2[i]) / det, v = (e1[i] * p[j] - e1[j] * p[i]) / det;
  return u >= T(0.0) && v >= T(0.0) && u + v <= T(1.0);
}

/* The ray passes all edges on the same side: signs of volumes. */
template <typename T>
bool triangle_by_edges(Vector<T> d, Vector<T> v0, Vector<T> v1, Vector<T> v2, T *t) {
  const T a = dot(cross(v0, v1), d), b = dot(cross(v1, v2), d), c = dot(cross(v2, v0), d);
  const bool front = a >= T(0.0) && b >= T(0.0) && c >= T(0.0),
             back = a <= T(0.0) && b <= T(0.0) && c <= T(0.0);
  if (!front && !back) return false;
  const Vector<T> n = cross(v1 - v0, v2 - v0);
  const T nd = dot(n, d);
  if (nd >= T(0.0) && nd <= T(0.0)) return false;
  *t = dot(n, v0) / nd;
  return *t > T(0.0);
}

} // namespace

template <typename T>
std::vector<Vector<T>> rays_of(const Picture &picture, double right, double down) {
  std::vector<Vector<T>> rays;
  for (int y = 0; y < picture.height; y++)
    for (int x = 0; x < picture.width; x++) {
      const Vector<double> whole = {2.0 * (x + right) + 1 - picture.width, picture.height - 2.0 * (y + down) - 1,
                                    picture.focal};
      rays.push_back(in<T>(whole * (1 / std::sqrt(dot(whole, whole)))));
    }
  return rays;
}

template <typename T>
Pixels closest_hit(const Picture &picture, const std::vector<Vector<T>> &rays, SphereBy sphere, TriangleBy triangle) {
  struct Held {
    Shape::Kind kind;
    Vector<T> a, b, c;
    T r;
  };
  std::vector<Held> shapes;
  for (const Shape &s : picture.shapes)
    shapes.push_back({s.kind, in<T>(s.a), in<T>(s.b), in<T>(s.c), T(s.r)});
  Pixels pixels;
  for (const Vector<T> &d : rays) {
    T best = T(picture.far), t = T(0.0);
    uint16_t seen = nothing;
    for (size_t i = 0; i < shapes.size(); i++) {
      const Held &s = shapes[i];
      bool hit = false;
      if (s.kind == Shape::sphere) {
        hit = sphere == SphereBy::algebra ? sphere_by_algebra(d, s.a, s.r, &t)
                                          : sphere_by_geometry(d, s.a, s.r, &t);
      } else if (s.kind == Shape::plane) {
        const T nd = dot(s.a, d);
        hit = !(nd >= T(0.0) && nd <= T(0.0));
        if (hit) t = -s.r / nd;
        hit = hit && t > T(0.0);
      } else {
        hit = triangle == TriangleBy::cramer              ? triangle_by_cramer(d, s.a, s.b, s.c, &t)
              : triangle == TriangleBy::plane_barycentric ? triangle_by_plane(d, s.a, s.b, s.c, &t)
                                                          : triangle_by_edges(d, s.a, s.b, s.c, &t);
      }
      if (hit && t < best) {
        best = t;
        seen = static_cast<uint16_t>(i);
      }
    }
    pixels.push_back(seen);
  }
  return pixels;
}

#define FOR(T) \
  template std::vector<Vector<T>> rays_of<T>(const Picture &, double, double); \
  template Pixels closest_hit<T>(const Picture &, const std::vector<Vector<T>> &, SphereBy, TriangleBy);
FOR(float)
FOR(double)
#ifdef __SIZEOF_INT128__
FOR(Fixed)
#endif
