/*
 * Several rays a pixel and other lenses: what is typed, and what the core is told.
 */
#ifndef FIXCAST_HOST_SAMPLING_H
#define FIXCAST_HOST_SAMPLING_H

#include <cstdint>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "kernel.h"
#include "to_core.h"

namespace host {

/* As typed. */
struct SamplingOptions {
  std::string samples, filter, lens;
  std::uint32_t seed = 0;
};

/* Lens data and what points to them: to be kept where it is made. */
struct Sampling {
  Sampling() = default;
  Sampling(const Sampling &) = delete;
  Sampling &operator=(const Sampling &) = delete;

  bool wanted = false; /* false: fc_render_profile draws the frame */
  fc_sampling how = FC_SAMPLING_ONE;
  std::optional<Kernel> kernel; /* a filter that the core has not: filter_frame draws the colours, of how.count x how.count rays a pixel */
  fc_orthographic orthographic{};
  fc_fisheye fisheye{};
};

/* --samples, --filter, --lens and --seed. */
void add_sampling_options(CLI::App &command, SamplingOptions &options);

/* Throws UserError. A lens named without a size is framed as the camera's pinhole frames its target. */
void set_sampling(Sampling &sampling, const SamplingOptions &options, const CoreScene &core);

} // namespace host

#endif
