/* A camera that is moved by hand. */
#include "view_camera.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace host {
namespace {

constexpr int most_steps = 44; /* 1.1^44 = 66 */

void must(int error) {
  if (error < 0) throw UserError(std::string("the view cannot turn: ") + fc_error_text(error));
}

IntVector cross_q30(const IntVector &a, const IntVector &b) {
  return {(a[1] * b[2] - a[2] * b[1]) / FC_ONE_Q30, (a[2] * b[0] - a[0] * b[2]) / FC_ONE_Q30, (a[0] * b[1] - a[1] * b[0]) / FC_ONE_Q30};
}

fc_vec3 to_vec3(const IntVector &v) {
  return {static_cast<std::int32_t>(v[0]), static_cast<std::int32_t>(v[1]), static_cast<std::int32_t>(v[2])};
}

/* 1.1^steps times v. */
IntVector scaled(IntVector v, int steps) {
  for (; steps > 0; steps--)
    for (std::int64_t &c : v) c = c * 10 / 11;
  for (; steps < 0; steps++)
    for (std::int64_t &c : v) c = c * 11 / 10;
  return v;
}

} // namespace

ViewCamera::ViewCamera(const CoreScene &core) : first_(core.camera), axis_(view_axis(core)) {
  IntVector to_eye{};
  for (std::size_t i = 0; i < 3; i++) to_eye[i] = (axis_.eye[i] - axis_.target[i]) / 2;
  if (length_of(to_eye) < 1 << 20) /* halving would cost a short view too much */
    for (std::size_t i = 0; i < 3; i++) to_eye[i] = axis_.eye[i] - axis_.target[i];
  back_ = unit_q30(to_eye);
  right_ = unit_q30(cross_q30(unit_q30({first_.up.x, first_.up.y, first_.up.z}), back_));
  above_ = unit_q30(cross_q30(back_, right_));
}

/* From screen axes (right, up, towards the viewer), Q30, to the world's. */
IntVector ViewCamera::world(const fc_vec3 &s) const {
  IntVector v{};
  for (std::size_t i = 0; i < 3; i++) v[i] = (s.x * right_[i] + s.y * above_[i] + s.z * back_[i]) / FC_ONE_Q30; /* below 2^62 */
  return v;
}

/* The scene turns, so what belongs to the camera turns the other way. Components up to 2^31: sums below 2^63. */
IntVector ViewCamera::looked(const IntVector &v) const {
  fc_rotation back{};
  fc_matrix matrix{};
  must(fc_rotation_invert(&back, &turn_));
  must(fc_rotation_matrix(&matrix, &back));
  IntVector result{};
  for (std::size_t i = 0; i < 3; i++) {
    std::int64_t sum = FC_ONE_Q30 / 2;
    for (std::size_t j = 0; j < 3; j++) sum += matrix.row[i][j] * v[j];
    result[i] = sum >> 30;
  }
  return result;
}

fc_camera ViewCamera::camera() const {
  if (turn_.w == FC_ONE_Q30 && nearer_ == 0 && moved_ == IntVector{}) return first_;
  IntVector offset{}, view{};
  for (std::size_t i = 0; i < 3; i++) {
    offset[i] = axis_.eye[i] - axis_.pivot[i];
    view[i] = axis_.target[i] - axis_.eye[i];
  }
  /* Nearer first: the turn takes no more than 2^31. */
  offset = looked(scaled(offset, std::max(nearer_, 0)));
  offset = scaled(offset, std::min(nearer_, 0));
  view = looked(view);
  IntVector eye{}, target{};
  std::int64_t largest = 0;
  for (std::size_t i = 0; i < 3; i++) {
    eye[i] = axis_.pivot[i] + moved_[i] + offset[i];
    target[i] = eye[i] + view[i];
    for (const std::int64_t c : {eye[i], target[i]}) largest = std::max(largest, c < 0 ? -c : c);
  }
  fc_camera camera = first_;
  int shift = 0;
  while (largest >> shift > FC_COORDINATE_MAX - 1) shift++;
  for (std::size_t i = 0; i < 3; i++) eye[i] >>= shift, target[i] >>= shift;
  camera.eye = to_vec3(eye);
  camera.target = to_vec3(target);
  camera.exponent = static_cast<std::int8_t>(std::min(axis_.exponent + shift, 31));
  camera.up = to_vec3(looked({first_.up.x, first_.up.y, first_.up.z}));
  return camera;
}

void ViewCamera::begin_drag() { before_drag_ = turn_; }

void ViewCamera::roll(int x0, int y0, int x, int y, int width, int height) {
  /* Half pixels from the middle, up being positive. */
  const int radius = std::min(width, height);
  fc_vec3 from{}, to{};
  must(fc_trackball_point(&from, 2 * x0 - width, height - 2 * y0, radius));
  must(fc_trackball_point(&to, 2 * x - width, height - 2 * y, radius));
  const fc_vec3 from_world = to_vec3(world(from)), to_world = to_vec3(world(to));
  fc_rotation drag{};
  must(fc_rotation_between(&drag, &from_world, &to_world));
  must(fc_rotation_compose(&turn_, &drag, &before_drag_));
}

void ViewCamera::pan(int dx, int dy, int width, int height) {
  IntVector offset{};
  for (std::size_t i = 0; i < 3; i++) offset[i] = axis_.eye[i] - axis_.pivot[i];
  const std::int64_t distance = length_of(scaled(offset, std::max(nearer_, 0)));
  const std::int64_t tangent_q16 = (std::int64_t{first_.tan_half_fov_numerator} << 16) / first_.tan_half_fov_denominator;
  const std::int64_t side = std::min(width, height);
  const IntVector right = looked(right_), above = looked(above_);
  /* A pixel is 2 tan / side of the distance; 2^32 * 2^13 fits, and so does that / side * tan. */
  const std::int64_t h = (distance * 2 * dx / side * tangent_q16) >> 16, v = (distance * 2 * dy / side * tangent_q16) >> 16;
  constexpr std::int64_t limit = std::int64_t{1} << 31;
  for (std::size_t i = 0; i < 3; i++) {
    const std::int64_t step = -(std::clamp(h, -limit, limit) / 2 * right[i] >> 29) + (std::clamp(v, -limit, limit) / 2 * above[i] >> 29);
    moved_[i] = std::clamp(moved_[i] + step, -limit, limit);
  }
}

void ViewCamera::dolly(int steps) { nearer_ = std::clamp(nearer_ + steps, -most_steps, most_steps); }

void ViewCamera::spin(std::uint16_t angle) {
  fc_rotation turn{};
  must(fc_rotation_about(&turn, &first_.up, angle));
  must(fc_rotation_compose(&turn_, &turn, &turn_));
}

void ViewCamera::reset() {
  turn_ = FC_ROTATION_NONE;
  moved_ = {};
  nearer_ = 0;
}

} // namespace host
