/* fixcast render: one frame by the core, as pictures and as counts. */
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "frame_run.h"
#include "image.h"
#include "report.h"
#include "scene_options.h"

namespace host {
namespace {

struct RenderOptions : SceneOptions {
  SamplingOptions sampling;
  std::string frame_path, depth_path, samples_path;
  int strip_rows = FC_SIZE_MAX;
};

/* Depth codes as greys for people: stretched so that the farthest surface is a dark grey and the nearest white, in the order
 * of the codes; nothing there is black. */
std::vector<std::uint16_t> depth_greys(std::vector<std::uint16_t> codes) {
  constexpr std::uint32_t darkest = 6000, white = 65535;
  std::uint32_t low = white, high = 0;
  for (std::uint32_t code : codes) {
    if (code == 0) continue;
    low = std::min(low, code);
    high = std::max(high, code);
  }
  for (std::uint16_t &code : codes) {
    if (code == 0) continue;
    const std::uint32_t range = std::max(high - low, 1u);
    code = static_cast<std::uint16_t>(darkest + ((code - low) * (white - darkest) + range / 2) / range);
  }
  return codes;
}

/* Rays a pixel as greys: the pixel that took most is white. */
std::vector<std::uint16_t> sample_greys(std::vector<std::uint16_t> counts) {
  constexpr std::uint32_t white = 65535;
  std::uint32_t most = 1;
  for (std::uint32_t count : counts) most = std::max(most, count);
  for (std::uint16_t &count : counts) count = static_cast<std::uint16_t>((count * white + most / 2) / most);
  return counts;
}

int run_render(const RenderOptions &options) {
  if (!options.frame_path.empty() && options.frame_path == options.depth_path)
    throw UserError(options.frame_path + ": -o and --depth name the same file; choose two");
  if (!options.samples_path.empty() && (options.samples_path == options.frame_path || options.samples_path == options.depth_path))
    throw UserError(options.samples_path + ": --samples-image names a file that is written already; choose another");
  if (!options.samples_path.empty() && options.sampling.samples.empty())
    throw UserError("--samples-image needs --samples: without it every pixel has one ray");
  for (const std::string &path : {options.frame_path, options.depth_path, options.samples_path})
    if (!path.empty()) check_not_same_file(options.scene, path);

  const LoadedScene scene = load_scene(options);
  Sampling sampling;
  set_sampling(sampling, options.sampling, scene.core);
  if (sampling.wanted && scene.options.profile != FC_PROFILE_EXACT)
    throw UserError("--profile " + options.profile + ": --samples, --filter and --lens trace exact rays; leave --profile out");
  const CoreFrame frame(scene.file, scene.core, scene.options, scene.width, scene.height);
  const Pictures pictures = render(frame, sampling, options.strip_rows);
  const FrameCounts counts = count(pictures.rgb565);
  std::string written;
  if (!options.frame_path.empty())
    written += "wrote " +
               write_image(options.frame_path, {scene.width, scene.height, pictures.rgb888.pixels}) + "\n";
  if (!options.depth_path.empty())
    written +=
        "wrote " +
        write_depth(options.depth_path, {scene.width, scene.height, depth_greys(pictures.rgb565.depth)}) +
        "\n";
  if (!options.samples_path.empty())
    written += "wrote " +
               write_depth(options.samples_path, {scene.width, scene.height, sample_greys(pictures.rgb888.samples)}) + "\n";
  std::uint64_t rays = 0;
  for (std::uint16_t samples : pictures.rgb888.samples) rays += samples;
  const std::string rays_json = sampling.wanted ? ", \"rays\": " + std::to_string(rays) : "";
  if (sampling.wanted) written = std::to_string(rays) + " rays make the pixels\n" + written;
  const std::string text =
      options.json ? "{" + frame_json(scene, counts) + rays_json + "}\n" : frame_summary(scene, counts) + written;
  (void)std::fputs(text.c_str(), stdout);
  return 0;
}

} // namespace

void add_render_command(CLI::App &app, Action &action) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App *command = app.add_subcommand("render", "Render a scene and report what is in the frame");
  add_scene_options(*command, *options);
  command->add_option("-o,--output", options->frame_path, "write the frame, 8 bits a channel")
      ->type_name("FRAME.png");
  command
      ->add_option("--depth", options->depth_path,
                   "write the depth codes stretched to 16-bit greys, nearer is brighter")
      ->type_name("DEPTH.png");
  add_offset_option(*command, *options);
  add_profile_option(*command, *options);
  add_sampling_options(*command, options->sampling);
  command
      ->add_option("--samples-image", options->samples_path, "write how many rays each pixel took, as 16-bit greys: most is white")
      ->type_name("FILE.png");
  command
      ->add_option("--strip", options->strip_rows,
                   "render in strips of so many rows; default: the whole frame")
      ->type_name("ROWS")
      ->check(CLI::Range(1, static_cast<int>(FC_SIZE_MAX)));
  add_json_option(*command, *options);
  command->callback([&action, options] { action = [options] { return run_render(*options); }; });
}

} // namespace host
