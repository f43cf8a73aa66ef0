/* Filtered frames: the larger frame, light from levels, levels from light. */
#include "filtered_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "progress.h"

namespace host {
namespace {

/* The light, 1 for white, that a display of 255 levels shows at a level. */
double light_of(std::size_t level, const fc_transfer *transfer) {
  const double signal = static_cast<double>(level) / 255;
  if (transfer == &fc_transfer_srgb) return signal <= 0.04045 ? signal / 12.92 : std::pow((signal + 0.055) / 1.055, 2.4);
  return transfer == &fc_transfer_gamma22 ? std::pow(signal, 2.2) : signal;
}

/* The level of 31, 63 or 255 that shows a light: as the core decides it. */
std::uint8_t level_of(double light, unsigned most, const fc_transfer *transfer) {
  if (transfer == nullptr) return static_cast<std::uint8_t>(std::lround(std::clamp(light, 0.0, 1.0) * most));
  const std::uint32_t *table = most == 31 ? transfer->level31 : most == 63 ? transfer->level63
                                                                           : transfer->level255;
  return static_cast<std::uint8_t>(std::upper_bound(table, table + most, std::ldexp(light, 24)) - table);
}

/* The camera of which a larger frame covers the same picture: NFF's rule goes by pixel centres, of which the larger frame has others. */
fc_camera between_edges(const fc_camera &of, int shorter) {
  fc_camera camera = of;
  if (of.fov_rule == FC_FOV_EDGES) return camera;
  std::uint64_t numerator = static_cast<std::uint64_t>(of.tan_half_fov_numerator) * static_cast<std::uint64_t>(shorter);
  std::uint64_t denominator = static_cast<std::uint64_t>(of.tan_half_fov_denominator) * static_cast<std::uint64_t>(std::max(shorter - 1, 1));
  while (std::max(numerator, denominator) > UINT32_MAX) { /* 32 bits at least stay of the larger one: below 2^-15 pixels */
    numerator = (numerator + 1) / 2;
    denominator = (denominator + 1) / 2;
  }
  camera.fov_rule = FC_FOV_EDGES;
  camera.tan_half_fov_numerator = static_cast<std::uint32_t>(numerator);
  camera.tan_half_fov_denominator = static_cast<std::uint32_t>(denominator);
  return camera;
}

/* The larger frame as FC_RGB888. */
std::vector<std::uint8_t> sampled(const CoreScene &core, const fc_options &options, const Sampling &sampling, int width, int height, int side,
                                  bool quiet) {
  const fc_camera camera = between_edges(core.camera, std::min(width, height));
  const int wide = width * side, high = height * side;
  if (wide > FC_SIZE_MAX || high > FC_SIZE_MAX)
    throw UserError("--filter: " + std::to_string(side) + " x " + std::to_string(side) + " rays for each of " + std::to_string(width) + "x" +
                    std::to_string(height) + " pixels are more than " + std::to_string(FC_SIZE_MAX) +
                    " in a row; give fewer rays or a smaller --size");
  int error = FC_OK;
  fc_frame frame{};
  std::vector<std::int64_t> memory(fc_frame_memory(&core.scene, &error) / sizeof(std::int64_t) + 1);
  if (error == FC_OK)
    error = fc_frame_setup(&frame, &core.scene, &camera, &options, static_cast<std::uint16_t>(wide), static_cast<std::uint16_t>(high),
                           memory.data(), memory.size() * sizeof(std::int64_t));
  fc_sampling how = FC_SAMPLING_ONE;
  how.lens = sampling.how.lens;
  const std::size_t pitch = 3 * static_cast<std::size_t>(wide);
  std::vector<std::uint8_t> pixels(pitch * static_cast<std::size_t>(high));
  Progress progress("sampling", quiet ? 0 : static_cast<std::size_t>(height));
  for (int row = 0; row < height && error == FC_OK; row++) {
    fc_target target{};
    target.pixels = pixels.data() + pitch * static_cast<std::size_t>(row) * static_cast<std::size_t>(side);
    target.pitch_bytes = pitch;
    target.format = FC_RGB888;
    error = fc_sample_rows(&frame, &how, static_cast<std::uint16_t>(row * side), static_cast<std::uint16_t>(side), &target, nullptr, nullptr, 0);
    if (!quiet) progress.update(static_cast<std::size_t>(row + 1));
  }
  if (error < 0) throw UserError(std::string("--filter: cannot sample: ") + fc_error_text(error));
  return pixels;
}

} // namespace

void filter_frame(Pictures &pictures, const CoreScene &core, const fc_options &options, const Sampling &sampling, bool quiet) {
  Picture &fine = pictures.rgb888, &coarse = pictures.rgb565;
  const auto width = static_cast<std::size_t>(fine.width), height = static_cast<std::size_t>(fine.height);
  const int side = sampling.how.count;
  const std::vector<std::uint8_t> levels = sampled(core, options, sampling, fine.width, fine.height, side, quiet);
  std::array<double, 256> light{};
  for (std::size_t level = 0; level < light.size(); level++) light[level] = light_of(level, options.transfer);
  std::array<std::vector<double>, 3> channels;
  for (std::size_t c = 0; c < channels.size(); c++) {
    std::vector<double> samples(levels.size() / 3);
    for (std::size_t i = 0; i < samples.size(); i++) samples[i] = light[levels[3 * i + c]];
    channels[c] = reconstruct(*sampling.kernel, side, width, height, samples);
  }
  for (std::size_t i = 0; i < width * height; i++) {
    std::array<unsigned, 3> few{};
    for (std::size_t c = 0; c < 3; c++) {
      fine.pixels[3 * i + c] = level_of(channels[c][i], 255, options.transfer);
      few[c] = level_of(channels[c][i], c == 1 ? 63 : 31, options.transfer);
    }
    const unsigned packed = few[0] << 11 | few[1] << 5 | few[2];
    coarse.pixels[2 * i] = static_cast<std::uint8_t>(packed >> 8);
    coarse.pixels[2 * i + 1] = static_cast<std::uint8_t>(packed);
    fine.samples[i] = coarse.samples[i] = static_cast<std::uint16_t>(side * side);
  }
}

} // namespace host
