/* What the interactive view shows. */
#include "viewer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "compare.h"
#include "counted.h"
#include "depth_format.h"
#include "frame_layers.h"
#include "frame_run.h"
#include "panel_view.h"
#include "report.h"

namespace host {
namespace {

constexpr std::array<const char *, 4> profile_names = {"exact", "fast", "half", "interlaced"};
constexpr std::array<const char *, 3> offset_names = {"exact shadows", "shadows without offset", "shadows with an epsilon"};
constexpr std::array<const char *, 3> transfer_names = {"linear", "sRGB", "gamma 2.2"};
const std::array<const fc_transfer *, 3> transfers = {nullptr, &fc_transfer_srgb, &fc_transfer_gamma22};
constexpr std::array<const char *, 3> sample_names = {"", "regular:2", "quincunx"};
constexpr int whole_frame = FC_SIZE_MAX;

} // namespace

Viewer::Viewer(LoadedScene scene, const fc_panel *panel)
    : scene_(std::move(scene)), panel_(panel), on_panel_(panel != nullptr), camera_(scene_.core) {
  if (scene_.file.scale_numerator != 1 || scene_.file.scale_denominator != 1)
    throw UserError("view and --world-scale exclude each other; the picture would be the same");
  const CoreScene &core = scene_.core;
  transfer_ = static_cast<int>(std::find(transfers.begin(), transfers.end(), scene_.options.transfer) - transfers.begin());
  const std::size_t first = core.shapes.size() - core.triangle_tables.size();
  for (std::size_t i = 0; i < core.triangle_tables.size(); i++) {
    const TriangleTable &table = core.triangle_tables[i];
    if (table.cull == 0) continue;
    Box box{first + i, {INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}, table.cull};
    for (std::size_t v = table.vertex; v < table.vertex + table.vertices; v++) {
      const std::array<std::int64_t, 3> at = {core.vertices[v].x, core.vertices[v].y, core.vertices[v].z};
      for (std::size_t k = 0; k < 3; k++) box.low[k] = std::min(box.low[k], at[k]), box.high[k] = std::max(box.high[k], at[k]);
    }
    closed_.push_back(box);
  }
}

void Viewer::next_profile() {
  samples_ = 0;
  scene_.options.profile = static_cast<std::uint8_t>((scene_.options.profile + 1) % profile_names.size());
}

void Viewer::next_offset() {
  offset_ = (offset_ + 1) % static_cast<int>(offset_names.size());
  scene_.options.offset_rule = static_cast<std::uint8_t>(offset_ == 0   ? FC_OFFSET_EXACT
                                                         : offset_ == 1 ? FC_OFFSET_NONE
                                                                        : FC_OFFSET_EPSILON);
  scene_.options.epsilon = offset_ == 2 ? FC_COORDINATE_MAX / 256 : 0;
  scene_.options.epsilon_exponent = 0;
}

void Viewer::next_depth() {
  const std::uint8_t bits = scene_.options.depth_exponent_bits;
  scene_.options.depth_exponent_bits = static_cast<std::uint8_t>(bits == 0 ? 2 : bits == 4 ? 0
                                                                                           : bits + 1);
}

void Viewer::next_transfer() {
  transfer_ = (transfer_ + 1) % static_cast<int>(transfers.size());
  scene_.options.transfer = transfers.at(static_cast<std::size_t>(transfer_));
}

void Viewer::next_samples() {
  samples_ = (samples_ + 1) % static_cast<int>(sample_names.size());
  scene_.options.profile = FC_PROFILE_EXACT;
}

void Viewer::toggle_panel() { on_panel_ = panel_ != nullptr && !on_panel_; }

/* An eye within the box of a closed mesh might be inside the mesh, and then sees its back faces. */
void Viewer::guard_back_faces() {
  const fc_camera &camera = scene_.core.camera;
  const std::array<std::int32_t, 3> eye = {camera.eye.x, camera.eye.y, camera.eye.z};
  for (const Box &box : closed_) {
    bool outside = false;
    for (std::size_t k = 0; k < 3; k++) {
      const double at = std::ldexp(eye[k], camera.exponent);
      outside = outside || at < static_cast<double>(box.low[k]) - 1 || at > static_cast<double>(box.high[k]) + 1;
    }
    scene_.core.shapes[box.shape].cull = outside ? box.cull : 0;
  }
}

/* The oracle knows no transfer function, so none is taken; it takes the camera as numbers, and these are the core's, exactly. */
Image8 Viewer::draw_error() {
  fc_options options = scene_.options;
  options.transfer = nullptr;
  const CoreFrame frame(scene_.file, scene_.core, options, scene_.width, scene_.height);
  const Picture picture = render_format(frame, Sampling(), FC_RGB888, whole_frame);
  SceneFile file = scene_.file;
  const fc_camera &camera = scene_.core.camera;
  const int grid = scene_.core.scene.exponent - 16 + camera.exponent;
  file.camera.from = grid_vector({camera.eye.x, camera.eye.y, camera.eye.z}, grid);
  file.camera.at = grid_vector({camera.target.x, camera.target.y, camera.target.z}, grid);
  file.camera.up = grid_vector({camera.up.x, camera.up.y, camera.up.z}, 0);
  const Oracle oracle(file, scene_.width, scene_.height);
  const Comparison comparison = compare(file, oracle, frame, picture);
  const NamedDepthFormat &depth = depth_formats().at(static_cast<std::size_t>(std::max<int>(frame.get().depth_exponent_bits, 2) - 2));
  status_ += ": " + count_text(comparison.wrong_id, "wrong id") + ", " + count_text(comparison.wrong_shadow, "wrong shadow") +
             ", colour error " + number_text(std::round(comparison.colour_max * 100) / 100) + "; depth codes alone would confuse " +
             count_text(wrong_order(oracle, scene_.width, scene_.height, depth.format).pixels, "pixel");
  return layer_picture(frame_layers(frame, scene_.core, picture, comparison.error, {layer_}), layer_);
}

/* How the picture differs from the exact profile's. */
std::string Viewer::cost_of_profile(const Picture &picture) const {
  if (scene_.options.profile == FC_PROFILE_EXACT) return "";
  fc_options options = scene_.options;
  options.profile = FC_PROFILE_EXACT;
  const CoreFrame frame(scene_.file, scene_.core, options, scene_.width, scene_.height);
  const Picture exact = render_format(frame, Sampling(), FC_RGB888, whole_frame);
  std::size_t pixels = 0;
  int most = 0;
  for (std::size_t i = 0; i < exact.pixels.size(); i += 3) {
    int difference = 0;
    for (std::size_t k = i; k < i + 3; k++) difference = std::max(difference, std::abs(exact.pixels[k] - picture.pixels[k]));
    pixels += difference > 0;
    most = std::max(most, difference);
  }
  return ": " + count_text(pixels, "pixel") + " unlike exact, by " + count_text(static_cast<std::size_t>(most), "level") + " at most";
}

Image8 Viewer::draw() {
  scene_.core.camera = camera_.camera();
  guard_back_faces();
  if (layer_ == "error") return draw_error();
  Sampling sampling;
  SamplingOptions samples;
  samples.samples = sample_names.at(static_cast<std::size_t>(samples_));
  set_sampling(sampling, samples, scene_.core);
  const CoreFrame frame(scene_.file, scene_.core, scene_.options, scene_.width, scene_.height);
  if (on_panel_ && layer_ == "color") return panel_picture(*panel_, render_format(frame, sampling, FC_RGB565_BE, whole_frame));
  Picture picture = render_format(frame, sampling, FC_RGB888, whole_frame);
  status_ += cost_of_profile(picture);
  if (layer_ == "color") return {picture.width, picture.height, std::move(picture.pixels)};
  return layer_picture(frame_layers(frame, scene_.core, picture, {}, {layer_}), layer_);
}

std::string Viewer::describe() const {
  const std::string file = std::filesystem::path(scene_.file.path).filename().string();
  std::string text = file + " " + std::to_string(scene_.width) + "x" + std::to_string(scene_.height) + ", " +
                     (on_panel_ && layer_ == "color" ? panel_->name : layer_);
  if (samples_ > 0) text += ", " + std::string(sample_names.at(static_cast<std::size_t>(samples_)));
  if (transfer_ > 0 && layer_ == "color") text += ", " + std::string(transfer_names.at(static_cast<std::size_t>(transfer_)));
  if (scene_.options.depth_exponent_bits > 0) text += ", e" + std::to_string(scene_.options.depth_exponent_bits) + " depth";
  return text + ", " + offset_names.at(static_cast<std::size_t>(offset_)) + ", " + profile_names.at(scene_.options.profile) + " profile (" +
         counted_text(file, profile_names.at(scene_.options.profile)) + ")";
}

const Image8 &Viewer::render() {
  status_ = describe();
  try {
    picture_ = draw();
  } catch (const UserError &error) {
    if (picture_.rgb.empty()) throw;
    status_ = error.what();
  }
  return picture_;
}

} // namespace host
