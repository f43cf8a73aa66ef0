/*
 * What layered surfaces look like, in long double: highlights, mirrors, emission, textures, smooth normals, skies.
 *
 * The oracle's decisions at the first surface are exact (oracle.cpp); what a mirror shows is traced here, with decisions to the
 * precision of long double. Shares nothing with the core.
 */
#ifndef FIXCAST_HOST_ORACLE_RADIANCE_H
#define FIXCAST_HOST_ORACLE_RADIANCE_H

#include <array>
#include <cstddef>
#include <vector>

#include "scene_file.h"

namespace host::oracle {

using Real3 = std::array<long double, 3>;

/* A shape of a SceneFile. */
struct ShapeOf {
  enum class Kind {
    sphere,
    plane,
    polygon
  } kind = Kind::sphere;
  std::size_t index = 0;
};

class Radiance {
public:
  explicit Radiance(const SceneFile &scene);

  /* Whether a material needs this at all; Lambert's law and ambient light do not. */
  static bool layered(const Material &material, bool has_normals);

  /* Linear radiance of a shape's point along a ray of any length; lit[i] says whether light i reaches it. */
  Real3 surface(const ShapeOf &shape, const Real3 &point, const Real3 &direction, const std::vector<bool> &lit) const;

  /* What a ray sees that meets nothing. */
  Real3 background(const Real3 &direction) const;

private:
  struct Sphere3 {
    Real3 center;
    long double radius;
  };
  struct Plane3 {
    Real3 normal; /* unit */
    long double d;
  };
  struct Triangle3 {
    std::array<Real3, 3> vertex, normal;
    std::array<std::array<long double, 2>, 3> uv;
    bool smooth;
  };
  struct Thing {
    ShapeOf shape;
    int material;
    Sphere3 sphere;
    Plane3 plane;
    std::vector<Triangle3> triangles;
  };
  struct Light3 {
    Real3 position; /* or the direction towards it */
    Real3 colour;
    bool directional;
  };
  struct Look; /* a point with all that its material says */

  const Thing *nearest(const Real3 &origin, const Real3 &direction, const Thing *from, long double &t) const;
  bool meets(const Thing &thing, const Real3 &origin, const Real3 &direction, bool leaving, long double &t) const;
  bool blocked(const Real3 &point, const Real3 &to, long double length, const Thing *receiver) const;
  Look look(const Thing &thing, const Real3 &point, const Real3 &direction) const;
  Real3 own_radiance(const Look &look, const Real3 &point, const Real3 &direction, const std::vector<bool> &lit) const;
  std::vector<bool> lit_at(const Look &look, const Real3 &point, const Thing &thing) const;
  Real3 textured(const Texture &texture, const Look &look, const Real3 &point) const;

  const SceneFile &scene_;
  long double scale_;
  std::vector<Thing> things_;
  std::vector<Light3> lights_;
  Real3 ambient_, background_;
  long double far_ = 0; /* 0: none */
};

} // namespace host::oracle

#endif
