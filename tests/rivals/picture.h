/* A scene in camera space for rivals, and the exact picture that they are held against. */
#ifndef RIVALS_PICTURE_H
#define RIVALS_PICTURE_H

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "number.h"

extern "C" {
#include "fixcast/fixcast.h"
}

constexpr int nothing = 0xffff;

struct Shape {
  enum Kind {
    sphere,
    plane,
    triangle
  } kind;
  Vector<double> a, b, c; /* center; normal; vertices: world units, x right, y up, z forward from the eye */
  double r;               /* radius; d of n . p + d = 0 */
};

/* A frame of a scene: shapes by their primitive numbers, focal length in half pixels of the shorter side. */
struct Picture {
  int width, height;
  double far;   /* what is farther along the ray is background */
  double focal; /* z of a pixel's direction (2x + 1 - w, h - 2y - 1, focal) */
  std::vector<Shape> shapes;
  std::vector<uint16_t> object; /* of each primitive */
  std::vector<uint16_t>
      exact;                  /* primitive of each pixel by the ray engine, whose exactness `fixcast compare` and torture hold */
  std::vector<uint16_t> ours; /* by the scan engine */
  bool has(Shape::Kind kind) const {
    for (const Shape &s : shapes)
      if (s.kind == kind) return true;
    return false;
  }
};

/* All but `exact` and `ours`, which take rendering. */
Picture shapes_of(const fc_scene &scene, const fc_camera &camera, int width, int height);
Picture picture_of(const fc_scene &scene, const fc_camera &camera, int width, int height);

template <typename T>
Vector<T> in(Vector<double> v) {
  return {T(v.x), T(v.y), T(v.z)};
}

/* What a rival shows: a primitive a pixel. */
using Pixels = std::vector<uint16_t>;
uint32_t crc_of(const Pixels &pixels); /* zlib's CRC-32, each number low byte first */

/* Ways to meet a sphere or a triangle, closest hit a pixel. */
enum class SphereBy {
  algebra,
  geometry
};
enum class TriangleBy {
  cramer,
  plane_barycentric,
  edges
};
/* Unit directions, a pixel each. (right, down): how far from the pixels' centres, in pixels. */
template <typename T>
std::vector<Vector<T>> rays_of(const Picture &picture, double right = 0, double down = 0);
template <typename T>
Pixels closest_hit(const Picture &picture, const std::vector<Vector<T>> &rays, SphereBy sphere, TriangleBy triangle);

/* Hidden surfaces of triangles. */
template <typename T>
Pixels z_buffer(const Picture &picture, int depth_bits); /* 0: depth as T */
template <typename T>
Pixels painter(const Picture &picture);
template <typename T>
Pixels bsp(const Picture &picture);
template <typename T>
Pixels warnock(const Picture &picture);

#endif
