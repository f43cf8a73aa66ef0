/* The camera going round a scene. */
#include "orbit_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

extern "C" {
#include "orbit.h"
}

namespace host {
namespace {

constexpr std::int64_t room = std::int64_t(1) << 28; /* the orbit's distances stay below 2^30, its points within FC_COORDINATE_MAX */

using Coordinates = std::array<std::int64_t, 3>;

Coordinates array_of(const fc_vec3 &v) { return {v.x, v.y, v.z}; }

fc_vec3 vector_of(const Coordinates &c) {
  return {static_cast<std::int32_t>(c[0]), static_cast<std::int32_t>(c[1]), static_cast<std::int32_t>(c[2])};
}

/* The axes moved on so that `axis` becomes y: a rotation, so that left stays left. */
fc_vec3 upright(const fc_vec3 &v, int axis) {
  const Coordinates from = array_of(v);
  Coordinates to{};
  for (int i = 0; i < 3; i++) to[static_cast<std::size_t>(i)] = from[static_cast<std::size_t>((i + axis + 2) % 3)];
  return vector_of(to);
}

/* The other way. */
fc_vec3 back(const fc_vec3 &v, int axis) { return upright(v, 2 - axis); }

/* Coordinates times 2^exponent world coordinates from such times 2^0, rounded down. */
std::int64_t rescaled(std::int64_t value, int exponent) {
  if (exponent >= 0) return value >> std::min(exponent, 62);
  return value * (std::int64_t(1) << std::min(-exponent, 31));
}

/* The middle of the smallest box around all spheres and vertices; false: there are none. */
bool middle_of(const CoreScene &scene, Coordinates &middle) {
  Coordinates low, high;
  low.fill(std::numeric_limits<std::int64_t>::max());
  high.fill(std::numeric_limits<std::int64_t>::min());
  const auto add = [&](const fc_vec3 &point, std::int64_t radius) {
    const Coordinates c = array_of(point);
    for (std::size_t i = 0; i < 3; i++) {
      low[i] = std::min(low[i], c[i] - radius);
      high[i] = std::max(high[i], c[i] + radius);
    }
  };
  for (const fc_sphere &sphere : scene.spheres) add(sphere.center, sphere.radius);
  for (const fc_vec3 &vertex : scene.vertices) add(vertex, 0);
  if (low[0] > high[0]) return false;
  for (std::size_t i = 0; i < 3; i++) middle[i] = (low[i] + high[i]) / 2;
  return true;
}

std::int64_t largest(const Coordinates &c) { return std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2])}); }

} // namespace

OrbitCamera::OrbitCamera(const CoreScene &scene) : start_(scene.camera), turned_from_(scene.camera) {
  const Coordinates up = array_of(start_.up);
  for (int i = 0; i < 3; i++)
    if (std::abs(up[static_cast<std::size_t>(i)]) > std::abs(up[static_cast<std::size_t>(axis_)])) axis_ = i;

  Coordinates eye = array_of(start_.eye), target = array_of(start_.target), middle = target;
  int exponent = start_.exponent;
  if (middle_of(scene, middle))
    for (std::int64_t &c : middle) c = rescaled(c, exponent);
  while (std::max({largest(eye), largest(target), largest(middle)}) >= room && exponent < 31) {
    for (Coordinates *point : {&eye, &target, &middle})
      for (std::int64_t &c : *point) c >>= 1;
    exponent++;
  }
  turned_from_.exponent = static_cast<std::int8_t>(exponent);
  turned_from_.eye = upright(vector_of(eye), axis_);
  turned_from_.target = upright(vector_of(target), axis_);
  /* An up of any length, but turned: long enough to be rounded. */
  Coordinates long_up = up;
  while (largest(long_up) != 0 && largest(long_up) < room / 2)
    for (std::int64_t &c : long_up) c *= 2;
  while (largest(long_up) >= room)
    for (std::int64_t &c : long_up) c /= 2;
  turned_from_.up = upright(vector_of(long_up), axis_);
  middle_ = upright(vector_of(middle), axis_);
}

fc_camera OrbitCamera::at(unsigned step) const {
  if (step % FC_ORBIT_STEPS == 0) return start_;
  const std::uint16_t within = static_cast<std::uint16_t>(step % FC_ORBIT_STEPS);
  fc_camera camera{}, direction = turned_from_, up{};
  fc_orbit(&turned_from_, middle_.x, middle_.z, within, &camera);
  direction.eye = turned_from_.up; /* a direction turns about the origin */
  fc_orbit(&direction, 0, 0, within, &up);
  camera.eye = back(camera.eye, axis_);
  camera.target = back(camera.target, axis_);
  camera.up = back(up.eye, axis_);
  return camera;
}

} // namespace host
