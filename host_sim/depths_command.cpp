/* fixcast depths: what each 16-bit depth format makes of a depth range. */
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "depth_format.h"

namespace host {
namespace {

/* Largest |decoded - z| / z over depths spread evenly in log z, both ends included. */
double worst_relative_error(DepthFormat format, double ratio) {
  constexpr int samples = 1 << 20;
  double worst = 0;
  for (int i = 0; i <= samples; i++) {
    const double z = std::pow(ratio, static_cast<double>(i) / samples);
    const double back = depth_decode(format, depth_encode(format, z, 1, ratio), 1, ratio);
    worst = std::max(worst, std::fabs(back - z) / z);
  }
  return worst;
}

int run_depths() {
  const std::vector<double> ratios = {10, 100, 1000, 10000};
  std::printf("Largest relative depth error, as a power of two, by far/near ratio\n%-10s", "format");
  for (double ratio : ratios) std::printf("%10.0f", ratio);
  std::printf("\n");
  for (const NamedDepthFormat &named : depth_formats()) {
    std::printf("%-10s", named.name);
    for (double ratio : ratios) std::printf("%10.2f", std::log2(worst_relative_error(named.format, ratio)));
    std::printf("\n");
  }
  return 0;
}

} // namespace

void add_depths_command(CLI::App &app, Action &action) {
  CLI::App *command = app.add_subcommand("depths", "Compare 16-bit depth formats over ranges of depth");
  command->callback([&action] { action = [] { return run_depths(); }; });
}

} // namespace host
