/* Where the camera is in each frame of a sequence. */
#include "camera_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "key_frames.h"

namespace host {
namespace {

/* 2^n in decimal digits, any n >= 0. */
std::string power_of_two(int n) {
  std::string digits = "1"; /* lowest first */
  for (; n > 0; n--) {
    int carry = 0;
    for (char &digit : digits) {
      const int twice = 2 * (digit - '0') + carry;
      digit = static_cast<char>('0' + twice % 10);
      carry = twice / 10;
    }
    if (carry > 0) digits += '1';
  }
  return {digits.rbegin(), digits.rend()};
}

IntVector components(const fc_vec3 &v) { return {v.x, v.y, v.z}; }

IntVector sum(const IntVector &a, const IntVector &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

IntVector difference(const IntVector &a, const IntVector &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/* Times 2^exponent, rounded; exponent at most 0. */
IntVector regridded(const IntVector &v, int exponent) {
  IntVector result{};
  for (std::size_t i = 0; i < 3; i++) result[i] = std::llround(std::ldexp(static_cast<long double>(v[i]), exponent));
  return result;
}

/* A difference of two points in 2^30, its direction alone being wanted. Short ones keep all their bits. */
IntVector halved(const IntVector &v) {
  const bool large = std::any_of(v.begin(), v.end(), [](std::int64_t c) { return c > 1 << 30 || c < -(1 << 30); });
  return large ? IntVector{v[0] / 2, v[1] / 2, v[2] / 2} : v;
}

/* A grid of world coordinates times 2^exponent, in world units. */
int grid_of(const CoreScene &core, int exponent) { return core.scene.exponent - 16 + exponent; }

/* The middle of the box around everything finite, in world coordinates; `fallback` when there is nothing. */
IntVector middle(const CoreScene &core, const IntVector &fallback) {
  IntVector low{}, high{};
  bool any = false;
  const auto include = [&](const fc_vec3 &at, std::int64_t radius) {
    const IntVector v = components(at);
    for (std::size_t i = 0; i < 3; i++) {
      low[i] = any ? std::min(low[i], v[i] - radius) : v[i] - radius;
      high[i] = any ? std::max(high[i], v[i] + radius) : v[i] + radius;
    }
    any = true;
  };
  for (const fc_sphere &sphere : core.spheres) include(sphere.center, sphere.radius);
  for (const fc_vec3 &vertex : core.vertices) include(vertex, 0);
  if (!any) return fallback;
  return {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
}

/* The whole view turns about a vertical line through the pivot. Frame 0 is the scene as it is. */
class Turn : public CameraPath {
public:
  Turn(const SceneFile &file, const CoreScene &core, bool lights_too) : file_(file), lights_too_(lights_too) {
    /* --world-scale stays in the file: coordinates are taken before it. */
    if (file.scale_numerator != 1 || file.scale_denominator != 1)
      throw UserError("--path and --world-scale exclude each other; scale the scene file");
    axis_ = unit_q30(components(core.camera.up));
    view_ = view_axis(core);
    grid_ = grid_of(core, view_.exponent);
    for (const fc_light &light : core.lights) lights_.push_back({components(light.position), grid_of(core, light.exponent)});
  }

  SceneFile at(int frame, int frames) const override {
    SceneFile file = file_;
    if (frame == 0) return file;
    const SineCosine angle = sine_cosine(frame, frames);
    file.camera.from = about(view_.pivot, view_.eye, angle, grid_);
    file.camera.at = about(view_.pivot, view_.target, angle, grid_);
    if (!lights_too_) return file;
    for (std::size_t i = 0; i < lights_.size(); i++) {
      /* On the coarser of the two grids. */
      const int grid = std::max(grid_, lights_[i].grid);
      file.lights[i].position =
          about(regridded(view_.pivot, grid_ - grid), regridded(lights_[i].position, lights_[i].grid - grid), angle, grid);
    }
    return file;
  }

private:
  struct GridPoint {
    IntVector position;
    int grid;
  };

  Vector about(const IntVector &pivot, const IntVector &point, const SineCosine &angle, int grid) const {
    return grid_vector(sum(pivot, turned(difference(point, pivot), axis_, angle)), grid);
  }

  SceneFile file_;
  int grid_ = 0;
  bool lights_too_;
  ViewAxis view_;
  IntVector axis_{};
  std::vector<GridPoint> lights_;
};

class Keyed : public CameraPath {
public:
  Keyed(SceneFile file, KeyFrames keys) : file_(std::move(file)), keys_(std::move(keys)) {}

  SceneFile at(int frame, int) const override {
    SceneFile file = file_;
    const CameraKey key = keys_.at(frame);
    file.camera.from = grid_vector(key.from, keys_.exponent);
    file.camera.at = grid_vector(key.at, keys_.exponent);
    return file;
  }

private:
  SceneFile file_;
  KeyFrames keys_;
};

} // namespace

Number grid_number(std::int64_t value, int exponent) {
  if (value == 0) return Number{};
  while (value % 2 == 0 && exponent < 0) value /= 2, exponent++;
  Number number;
  number.value = std::ldexp(static_cast<long double>(value), exponent);
  if (exponent >= 0) {
    for (; exponent > 0 && std::llabs(value) < INT64_MAX / 2; exponent--) value *= 2;
    if (exponent > 0) throw UserError("a camera too far away for exact numbers; write the scene in larger units");
  }
  number.text = std::to_string(value) + (exponent < 0 ? "/" + power_of_two(-exponent) : "");
  return number;
}

Vector grid_vector(const IntVector &value, int exponent) {
  return {grid_number(value[0], exponent), grid_number(value[1], exponent), grid_number(value[2], exponent)};
}

ViewAxis view_axis(const CoreScene &core) {
  ViewAxis axis;
  /* The camera's grid may be finer than the scene's, on which everything else is, but then also too fine for that. */
  axis.exponent = std::max<int>(core.camera.exponent, 0);
  axis.eye = regridded(components(core.camera.eye), core.camera.exponent - axis.exponent);
  axis.target = regridded(components(core.camera.target), core.camera.exponent - axis.exponent);
  const IntVector view = unit_q30(halved(difference(axis.target, axis.eye)));
  const IntVector to_centre = difference(regridded(middle(core, axis.target), -axis.exponent), axis.eye);
  std::int64_t along = 0; /* three products of 2^31 and 2^30, rounded down before they are added */
  for (std::size_t i = 0; i < 3; i++) along += (to_centre[i] * view[i]) >> 30;
  axis.pivot = axis.target;
  if (along > 0)
    for (std::size_t i = 0; i < 3; i++) axis.pivot[i] = axis.eye[i] + (along / 2 * view[i] >> 29);
  return axis;
}

std::unique_ptr<CameraPath> make_camera_path(const std::string &name, const SceneFile &file, const CoreScene &core) {
  if (name == "orbit") return std::make_unique<Turn>(file, core, false);
  if (name == "turntable") return std::make_unique<Turn>(file, core, true);
  return std::make_unique<Keyed>(file, read_key_frames(name));
}

} // namespace host
