/* Radiance of layered surfaces in long double. */
#include "oracle_radiance.h"

#include <algorithm>
#include <cmath>

#include "triangulate.h"

namespace host::oracle {
namespace {

Real3 real(const Vector &v) {
  return {v.x.value, v.y.value, v.z.value};
}
Real3 real(const Rgb &c) {
  return {c.r.value, c.g.value, c.b.value};
}
Real3 operator+(const Real3 &a, const Real3 &b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Real3 operator-(const Real3 &a, const Real3 &b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Real3 operator*(const Real3 &a, long double s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}
Real3 times(const Real3 &a, const Real3 &b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}
long double dot(const Real3 &a, const Real3 &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Real3 cross(const Real3 &a, const Real3 &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real3 unit(const Real3 &v) {
  return v * (1 / std::sqrt(dot(v, v)));
}

const long double pi = std::acos(-1.0L);

/* Barycentric weights of a point in a triangle's plane. */
template <typename T>
Real3 weights(const T &t, const Real3 &p) {
  const Real3 n = cross(t.vertex[1] - t.vertex[0], t.vertex[2] - t.vertex[0]);
  const long double area = dot(n, n);
  const long double a = dot(cross(t.vertex[1] - p, t.vertex[2] - p), n) / area;
  const long double b = dot(cross(t.vertex[2] - p, t.vertex[0] - p), n) / area;
  return {a, b, 1 - a - b};
}

/* The triangle that holds the point best, for rounding may have put it outside all of them. */
template <typename T>
const T *holder(const std::vector<T> &triangles, const Real3 &p, Real3 &weight) {
  const T *best = nullptr;
  long double least = 0;
  for (const T &t : triangles) {
    const Real3 w = weights(t, p);
    const long double inside = std::min({w[0], w[1], w[2]});
    if (std::isnan(inside) || (best != nullptr && inside <= least)) continue;
    best = &t;
    least = inside;
    weight = w;
  }
  return best;
}

} // namespace

struct Radiance::Look {
  const Material *material;
  Real3 flat, normal; /* unit, to the ray's side; `normal` is what light sees */
  Real3 outwards;     /* of a sphere, from its centre; of others the flat normal */
  std::array<long double, 2> uv{};
  bool inside = false;
  Real3 reflectance;
};

Radiance::Radiance(const SceneFile &scene)
    : scene_(scene),
      scale_(static_cast<long double>(scene.scale_numerator) / static_cast<long double>(scene.scale_denominator)) {
  for (std::size_t i = 0; i < scene.spheres.size(); i++) {
    const Sphere &s = scene.spheres[i];
    things_.push_back({{ShapeOf::Kind::sphere, i}, s.material, {real(s.center) * scale_, s.radius.value * scale_}, {}, {}});
  }
  for (std::size_t i = 0; i < scene.planes.size(); i++) {
    const Plane &p = scene.planes[i];
    const long double length = std::sqrt(dot(real(p.normal), real(p.normal)));
    things_.push_back({{ShapeOf::Kind::plane, i}, p.material, {}, {real(p.normal) * (1 / length), p.d.value * scale_ / length}, {}});
  }
  for (std::size_t i = 0; i < scene.polygons.size(); i++) {
    const Polygon &p = scene.polygons[i];
    Thing thing{{ShapeOf::Kind::polygon, i}, p.material, {}, {}, {}};
    for (const std::array<int, 3> &corner : triangulate(p)) {
      Triangle3 t{};
      t.smooth = !p.normals.empty();
      for (std::size_t k = 0; k < 3; k++) {
        const auto v = static_cast<std::size_t>(corner[k]);
        t.vertex[k] = real(p.vertices[v]) * scale_;
        if (t.smooth) t.normal[k] = unit(real(p.normals[v]));
        if (!p.uvs.empty()) t.uv[k] = {p.uvs[v][0].value, p.uvs[v][1].value};
      }
      thing.triangles.push_back(t);
    }
    things_.push_back(std::move(thing));
  }
  const long double n = static_cast<long double>(scene.lights.size());
  for (const Light &l : scene.lights) {
    Real3 colour = l.colour ? real(*l.colour) : Real3{1 / std::sqrt(n), 1 / std::sqrt(n), 1 / std::sqrt(n)};
    if (scene.falloff == Falloff::inverse_square && !l.directional) colour = colour * (scale_ * scale_);
    lights_.push_back({l.directional ? unit(real(l.position)) : real(l.position) * scale_, colour, l.directional});
  }
  ambient_ = real(scene.ambient);
  background_ = real(scene.background);
  if (scene.far) far_ = scene.far->value * scale_;
}

bool Radiance::layered(const Material &m, bool has_normals) {
  return has_normals || m.mirror || m.emission || m.texture || (m.ks.value > 0 && m.shine.value > 0);
}

Real3 Radiance::background(const Real3 &direction) const {
  if (!scene_.gradient) return background_;
  const long double cosine = dot(unit(direction), unit(real(scene_.gradient->up)));
  return background_ + (real(scene_.gradient->top) - background_) * ((1 + cosine) / 2);
}

/* `leaving`: the ray starts on the thing, so a root at 0 is not one. */
bool Radiance::meets(const Thing &thing, const Real3 &origin, const Real3 &direction, bool leaving, long double &t) const {
  switch (thing.shape.kind) {
    case ShapeOf::Kind::sphere: {
      const Real3 oc = origin - thing.sphere.center;
      const long double a = dot(direction, direction), b = dot(oc, direction);
      const long double c = leaving ? 0 : dot(oc, oc) - thing.sphere.radius * thing.sphere.radius;
      const long double disc = b * b - a * c;
      if (disc < 0) return false;
      if (leaving) {
        t = -2 * b / a;
        return b < 0;
      }
      const long double root = std::sqrt(disc);
      t = (-b - root) / a;
      if (t <= 0) t = (-b + root) / a;
      return t > 0;
    }
    case ShapeOf::Kind::plane: {
      const long double slope = dot(thing.plane.normal, direction);
      if (leaving || slope == 0) return false;
      t = -(dot(thing.plane.normal, origin) + thing.plane.d) / slope;
      return t > 0;
    }
    case ShapeOf::Kind::polygon: break;
  }
  if (leaving) return false;
  for (const Triangle3 &triangle : thing.triangles) {
    const Real3 n = cross(triangle.vertex[1] - triangle.vertex[0], triangle.vertex[2] - triangle.vertex[0]);
    const long double slope = dot(n, direction);
    if (slope == 0) continue;
    t = dot(n, triangle.vertex[0] - origin) / slope;
    if (!(t > 0)) continue;
    const Real3 w = weights(triangle, origin + direction * t);
    if (w[0] >= 0 && w[1] >= 0 && w[2] >= 0) return true;
  }
  return false;
}

const Radiance::Thing *Radiance::nearest(const Real3 &origin, const Real3 &direction, const Thing *from, long double &t) const {
  const Thing *best = nullptr;
  for (const Thing &thing : things_) {
    long double here = 0;
    if (meets(thing, origin, direction, &thing == from, here) && (best == nullptr || here < t)) {
      best = &thing;
      t = here;
    }
  }
  return best;
}

bool Radiance::blocked(const Real3 &point, const Real3 &to, long double length, const Thing *receiver) const {
  return std::any_of(things_.begin(), things_.end(), [&](const Thing &thing) {
    long double t = 0;
    return &thing != receiver && meets(thing, point, to, false, t) && (length == 0 || t < length);
  });
}

Radiance::Look Radiance::look(const Thing &thing, const Real3 &point, const Real3 &direction) const {
  Look look{};
  look.material = &scene_.materials[static_cast<std::size_t>(thing.material)];
  if (thing.shape.kind == ShapeOf::Kind::sphere) {
    look.outwards = unit(point - thing.sphere.center);
  } else if (thing.shape.kind == ShapeOf::Kind::plane) {
    look.outwards = thing.plane.normal;
  }
  look.flat = look.outwards;
  Real3 smooth{};
  bool is_smooth = false;
  if (thing.shape.kind == ShapeOf::Kind::polygon) {
    Real3 w{};
    const Triangle3 *t = holder(thing.triangles, point, w);
    look.outwards = look.flat = unit(cross(t->vertex[1] - t->vertex[0], t->vertex[2] - t->vertex[0]));
    is_smooth = t->smooth;
    for (std::size_t i = 0; i < 3; i++) {
      smooth = smooth + t->normal[i] * w[i];
      look.uv[0] += t->uv[i][0] * w[i];
      look.uv[1] += t->uv[i][1] * w[i];
    }
  }
  look.inside = dot(look.flat, direction) > 0;
  if (look.inside) look.flat = look.flat * -1;
  look.normal = look.flat;
  if (is_smooth && dot(smooth, smooth) > 0) look.normal = unit(dot(smooth, look.flat) < 0 ? smooth * -1 : smooth);
  look.reflectance = real(look.material->colour) * look.material->kd.value;
  if (look.material->texture) {
    const Real3 colour = textured(*look.material->texture, look, point);
    look.reflectance = look.material->texture->modulate ? times(look.reflectance, colour) : colour;
  }
  return look;
}

Real3 Radiance::textured(const Texture &texture, const Look &look, const Real3 &point) const {
  const Mapping &m = texture.mapping;
  long double u = look.uv[0], v = look.uv[1];
  if (m.kind == Mapping::Kind::planar) {
    const Real3 offset = point - real(m.origin) * scale_, au = real(m.u) * scale_, av = real(m.v) * scale_;
    u = dot(offset, au) / dot(au, au);
    v = dot(offset, av) / dot(av, av);
  } else if (m.kind == Mapping::Kind::spherical) {
    u = std::atan2(look.outwards[0], look.outwards[2]) / (2 * pi);
    if (u < 0) u += 1;
    v = std::acos(std::min(std::max(look.outwards[1], -1.0L), 1.0L)) / pi;
  }
  u *= m.repeat_u;
  v *= m.repeat_v;
  if (!texture.texels) {
    const long double square = std::floor(2 * u) + std::floor(2 * v);
    return real(texture.checker[std::fmod(std::fabs(square), 2) == 1 ? 1 : 0]);
  }
  const auto wrap = [&](long double at, int size) {
    if (texture.clamp) return static_cast<std::size_t>(std::min(std::max(at, 0.0L), size - 1.0L));
    return static_cast<std::size_t>(at - std::floor(at / size) * size);
  };
  const auto texel = [&](long double x, long double y) {
    const std::size_t at = 3 * (wrap(y, texture.height) * static_cast<std::size_t>(texture.width) + wrap(x, texture.width));
    const std::vector<std::uint8_t> &t = *texture.texels;
    return Real3{t[at] / 255.0L, t[at + 1] / 255.0L, t[at + 2] / 255.0L};
  };
  const long double x = u * texture.width, y = v * texture.height;
  if (!texture.bilinear) return texel(std::floor(x), std::floor(y));
  const long double left = std::floor(x - 0.5L), top = std::floor(y - 0.5L), fx = x - 0.5L - left, fy = y - 0.5L - top;
  return (texel(left, top) * (1 - fx) + texel(left + 1, top) * fx) * (1 - fy) +
         (texel(left, top + 1) * (1 - fx) + texel(left + 1, top + 1) * fx) * fy;
}

/* All but what a mirror shows. */
Real3 Radiance::own_radiance(const Look &look, const Real3 &point, const Real3 &direction, const std::vector<bool> &lit) const {
  Real3 arriving = ambient_, added{};
  const Material &m = *look.material;
  const Real3 view = unit(direction) * -1;
  for (std::size_t i = 0; i < lights_.size(); i++) {
    if (!lit[i]) continue;
    const Light3 &light = lights_[i];
    const Real3 towards = light.directional ? light.position : light.position - point;
    const long double square = dot(towards, towards);
    if (square == 0) continue;
    const Real3 l = towards * (1 / std::sqrt(square));
    const bool falls = scene_.falloff == Falloff::inverse_square && !light.directional;
    const Real3 colour = light.colour * (falls ? 1 / square : 1);
    const long double cosine = dot(look.normal, l);
    if (cosine > 0) arriving = arriving + colour * cosine;
    if (m.ks.value > 0 && m.shine.value > 0 && cosine > 0 && dot(look.normal, view) > 0) {
      const long double along = dot(look.normal * (2 * cosine) - l, view);
      if (along > 0) added = added + colour * (m.ks.value * std::pow(along, m.shine.value));
    }
  }
  if (m.emission) added = added + real(*m.emission);
  return times(look.reflectance, arriving) + added;
}

std::vector<bool> Radiance::lit_at(const Look &look, const Real3 &point, const Thing &thing) const {
  std::vector<bool> lit(lights_.size());
  for (std::size_t i = 0; i < lights_.size(); i++) {
    const Light3 &light = lights_[i];
    const Real3 to = light.directional ? light.position : light.position - point;
    lit[i] = dot(to, look.flat) > 0 && !blocked(point, to, light.directional ? 0 : 1, &thing);
  }
  return lit;
}

Real3 Radiance::surface(const ShapeOf &shape, const Real3 &point, const Real3 &direction, const std::vector<bool> &lit) const {
  const Thing *thing = &*std::find_if(things_.begin(), things_.end(), [&](const Thing &t) {
    return t.shape.kind == shape.kind && t.shape.index == shape.index;
  });
  Look here = look(*thing, point, direction);
  Real3 sum = own_radiance(here, point, direction, lit), weight{1, 1, 1}, p = point, d = direction;
  if (!here.material->mirror) return sum;
  const int bounces = here.material->mirror->bounces;
  for (int bounce = 1;; bounce++) {
    weight = times(weight, real(here.material->mirror->reflectance));
    d = unit(d);
    d = d - here.normal * (2 * dot(d, here.normal));
    long double t = 0;
    /* leaving a sphere's outside, or one side of a plane, it is not met again; from within a sphere it is */
    const Thing *next = nearest(p, d, thing, t);
    if (next == nullptr || (far_ > 0 && t > far_)) return sum + times(weight, background(d));
    p = p + d * t;
    here = look(*next, p, d);
    sum = sum + times(weight, own_radiance(here, p, d, lit_at(here, p, *next)));
    if (!here.material->mirror || bounce == bounces) return sum;
    thing = next;
  }
}

} // namespace host::oracle
