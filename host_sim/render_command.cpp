/* fixcast render: one frame by the core, as pictures and as counts. */
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "atomic_file.h"
#include "commands.h"
#include "frame_run.h"
#include "image.h"
#include "report.h"
#include "scene_options.h"

namespace host {
namespace {

struct RenderOptions : SceneOptions {
  std::string frame_path, depth_path, panel_path;
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

int run_render(const RenderOptions &options) {
  const std::pair<const char *, const std::string &> files[] = {
      {"-o", options.frame_path}, {"--depth", options.depth_path}, {"--rgb565", options.panel_path}};
  for (const auto &[option, path] : files) {
    if (path.empty()) continue;
    check_not_same_file(options.scene, path);
    for (const auto &[other_option, other] : files) {
      if (&other == &path) break;
      if (other == path) throw UserError(path + ": " + other_option + " and " + option + " name the same file; choose two");
    }
  }

  const LoadedScene scene = load_scene(options);
  const CoreFrame frame(scene.file, scene.core, scene.options, scene.width, scene.height);
  const Pictures pictures = render(frame, options.strip_rows);
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
  if (!options.panel_path.empty()) {
    write_file(options.panel_path, std::string(pictures.rgb565.pixels.begin(), pictures.rgb565.pixels.end()));
    written += "wrote " + options.panel_path + "\n";
  }
  const std::string text =
      options.json ? "{" + frame_json(scene, counts) + "}\n" : frame_summary(scene, counts) + written;
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
  command
      ->add_option("--rgb565", options->panel_path,
                   "write the pixels as a panel gets them: two bytes each, high byte first, rows from the top, no header")
      ->type_name("FRAME.bin");
  add_offset_option(*command, *options);
  add_profile_option(*command, *options);
  command
      ->add_option("--strip", options->strip_rows,
                   "render in strips of so many rows; default: the whole frame")
      ->type_name("ROWS")
      ->check(CLI::Range(1, static_cast<int>(FC_SIZE_MAX)));
  add_json_option(*command, *options);
  command->callback([&action, options] { action = [options] { return run_render(*options); }; });
}

} // namespace host
