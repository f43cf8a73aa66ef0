/* A whole frame from the core. */
#include "frame_run.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <string>
#include <utility>

#include <zlib.h>

#include "progress.h"

namespace host {
namespace {

/* The core knows no files; the camera is the one thing of which its error tells the line. */
[[noreturn]] void fail(const SceneFile &file, int error) {
  const bool camera =
      error == FC_ERR_CAMERA_TARGET || error == FC_ERR_CAMERA_UP || error == FC_ERR_FIELD_OF_VIEW;
  const std::string line = camera && file.camera.line > 0 ? ":" + std::to_string(file.camera.line) : "";
  throw UserError(file.path + line + ": " + fc_error_text(error));
}

/* One strip, as its profile or the sampling says. */
int render_strip(const fc_frame &frame, const Sampling &sampling, int y, int rows, const fc_target &target, std::uint16_t *samples,
                 std::vector<std::uint32_t> &scratch) {
  const auto first = static_cast<std::uint16_t>(y), count = static_cast<std::uint16_t>(rows);
  if (sampling.wanted)
    return fc_sample_rows(&frame, &sampling.how, first, count, &target, samples, scratch.data(), scratch.size() * sizeof scratch[0]);
  const int fields = frame.options.profile == FC_PROFILE_INTERLACED ? 2 : 1;
  int error = FC_OK;
  for (int field = 0; field < fields && error == FC_OK; field++)
    error = fc_render_profile(&frame, static_cast<std::uint8_t>(field), first, count, &target);
  return error;
}

/* `progress` may be null. */
Picture render_rows(const CoreFrame &frame, const Sampling &sampling, fc_format format, int strip_rows, Progress *progress) {
  Picture p;
  p.width = frame.width();
  p.height = frame.height();
  const std::size_t width = static_cast<std::size_t>(p.width);
  const std::size_t size = width * static_cast<std::size_t>(p.height);
  const std::size_t pitch = width * static_cast<std::size_t>(fc_format_bytes(format));
  std::vector<std::uint16_t> primitive(size);
  p.pixels.resize(pitch * static_cast<std::size_t>(p.height));
  p.depth.resize(size);
  p.lit.resize(size);
  std::vector<std::uint32_t> scratch;
  if (sampling.wanted) {
    int error = FC_OK;
    scratch.resize(fc_sample_scratch(&frame.get(), &sampling.how, &error) / sizeof scratch[0] + 1);
    if (error == FC_ERR_LENS) throw UserError("--lens: the frame would reach far beyond the scene; give a smaller orthographic size");
    if (error < 0) throw UserError(std::string("cannot sample: ") + fc_error_text(error));
    p.samples.resize(size);
  }
  for (int y = 0; y < p.height; y += strip_rows) {
    const std::size_t first = static_cast<std::size_t>(y) * width;
    fc_target target{};
    target.pixels = p.pixels.data() + static_cast<std::size_t>(y) * pitch;
    target.pitch_bytes = pitch;
    target.format = static_cast<std::uint8_t>(format);
    target.depth = p.depth.data() + first;
    target.primitive = primitive.data() + first;
    target.lit = p.lit.data() + first;
    const int rows = std::min(strip_rows, p.height - y);
    const int error = render_strip(frame.get(), sampling, y, rows, target,
                                   sampling.wanted ? p.samples.data() + first : nullptr, scratch);
    if (error < 0) throw UserError(std::string("cannot render: ") + fc_error_text(error));
    if (progress != nullptr) progress->update(static_cast<std::size_t>(y + rows));
  }
  p.object.resize(size);
  p.surface.resize(size);
  for (std::size_t i = 0; i < size; i++) {
    p.object[i] = fc_object(&frame.get(), primitive[i]);
    p.surface[i] = primitive[i] != 0xffff;
  }
  return p;
}

} // namespace

CoreFrame::CoreFrame(const SceneFile &file, const CoreScene &core, const fc_options &options, int width,
                     int height)
    : core_(core), width_(width), height_(height) {
  int error = FC_OK;
  memory_bytes_ = fc_frame_memory(&core.scene, &error);
  if (error < 0) fail(file, error);
  memory_.resize(memory_bytes_ / sizeof(std::int64_t) + 1);
  error = fc_frame_setup(&frame_, &core.scene, &core.camera, &options, static_cast<std::uint16_t>(width),
                         static_cast<std::uint16_t>(height), memory_.data(), memory_bytes_);
  if (error < 0) fail(file, error);
}

double CoreFrame::depth_z(std::uint16_t code) const {
  int exponent = 0;
  const double mantissa = fc_depth_z(&frame_, code, &exponent);
  return static_cast<double>(std::ldexp(mantissa * world_unit(core_.scene), exponent));
}

Pictures render(const CoreFrame &frame, const Sampling &sampling, int strip_rows, bool quiet) {
  std::future<Picture> rgb888 =
      std::async(std::launch::async, [&] { return render_rows(frame, sampling, FC_RGB888, strip_rows, nullptr); });
  Progress progress("rendering", static_cast<std::size_t>(frame.height()));
  Picture rgb565 = render_rows(frame, sampling, FC_RGB565_BE, strip_rows, quiet ? nullptr : &progress);
  return {rgb888.get(), std::move(rgb565)};
}

Picture render_format(const CoreFrame &frame, const Sampling &sampling, fc_format format, int strip_rows) {
  return render_rows(frame, sampling, format, strip_rows, nullptr);
}

FrameCounts count(const Picture &picture) {
  FrameCounts counts;
  counts.crc32 = static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), picture.pixels.data(), picture.pixels.size()));
  for (std::size_t i = 0; i < picture.object.size(); i++) {
    counts.pixels_by_id[picture.object[i]]++;
    if (picture.surface[i] && picture.lit[i] == 0) counts.unlit_pixels++;
  }
  return counts;
}

} // namespace host
