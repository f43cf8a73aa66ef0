/* fixcast compare: one frame by the core, measured against the oracle. */
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "compare.h"
#include "depth_format.h"
#include "edge_distance.h"
#include "frame_file.h"
#include "frame_run.h"
#include "heat.h"
#include "image.h"
#include "progress.h"
#include "report.h"
#include "scene_options.h"

namespace host {
namespace {

struct CompareOptions : SceneOptions {
  bool verbose = false, check = false;
  std::string depth_format, frame, output;
};

double per_million(std::size_t count, std::size_t of) { return of == 0 ? 0 : 1e6 * static_cast<double>(count) / static_cast<double>(of); }

std::string json_text(const Comparison &c) {
  return ", \"wrong_id\": " + std::to_string(c.wrong_id) + ", \"wrong_shadow\": " + std::to_string(c.wrong_shadow) +
         ", \"colour_rmse\": " + number_text(c.colour_rmse) + ", \"colour_max\": " + number_text(c.colour_max) +
         ", \"depth_rel_max\": " + number_text(c.depth_rel_max) +
         ", \"false_shadow_ppm\": " + number_text(per_million(c.false_shadows, c.light_tests)) +
         ", \"leak_ppm\": " + number_text(per_million(c.leaks, c.light_tests));
}

std::string summary(const Comparison &c) {
  char text[120];
  (void)std::snprintf(text, sizeof text, "; colour error %.3f RMSE, %.3f largest (8-bit levels); depth error %.3g\n", c.colour_rmse,
                      c.colour_max, c.depth_rel_max);
  return count_text(c.wrong_id, "wrong id") + ", " + count_text(c.wrong_shadow, "wrong shadow") + text +
         number_text(per_million(c.false_shadows, c.light_tests)) + " false shadows and " +
         number_text(per_million(c.leaks, c.light_tests)) + " leaks per million pixels and lights\n";
}

/* --depth-format: what a z-buffer of that format would do without the exact tie rule. */
std::string depth_text(const CompareOptions &options, const Oracle &oracle, const LoadedScene &scene) {
  if (options.depth_format.empty()) return "";
  for (const NamedDepthFormat &named : depth_formats()) {
    if (options.depth_format != named.name) continue;
    const WrongOrder wrong = wrong_order(oracle, scene.width, scene.height, named.format);
    if (options.json) return ", \"depth_format\": \"" + options.depth_format + "\", \"wrong_order\": " + std::to_string(wrong.pixels);
    char range[80];
    (void)std::snprintf(range, sizeof range, " (depths %.4g to %.4g)\n", wrong.near, wrong.far);
    return "a z-buffer of " + options.depth_format + " without a tie rule: " + count_text(wrong.pixels, "pixel") + " in the wrong order" +
           range;
  }
  return "";
}

std::vector<std::string> depth_format_names() {
  std::vector<std::string> names;
  for (const NamedDepthFormat &named : depth_formats()) names.push_back(named.name);
  return names;
}

std::string distance_text(double px) {
  char text[40];
  if (std::isinf(px))
    (void)std::snprintf(text, sizeof text, "more than %.3g px", edge_distance_max_px);
  else
    (void)std::snprintf(text, sizeof text, "%s%.3g px", px <= edge_distance_min_px ? "at most " : "", px);
  return text;
}

/* One line a wrong pixel. */
void list_wrong_pixels(std::FILE *to, const Oracle &oracle, const Comparison &comparison, std::size_t lights) {
  std::string text = std::to_string(comparison.escalated) + " pixels needed the oracle's 256-bit intervals, " +
                     std::to_string(comparison.ties) + " are exact ties\n";
  {
    Progress progress("measuring wrong pixels", comparison.wrong.size());
    std::size_t done = 0;
    for (const WrongPixel &p : comparison.wrong) {
      text += std::string(p.wrong_id ? "wrong id" : "wrong shadow") + " at " + std::to_string(p.x) + " " + std::to_string(p.y) +
              ": core object " + std::to_string(p.core_object) + " lit " + hex_text(p.core_lit) + ", oracle object " +
              std::to_string(p.oracle_object) + " lit " + hex_text(p.oracle_lit) + ", true edge " +
              distance_text(edge_distance_px(oracle, p, lights)) + " away\n";
      progress.update(++done);
    }
  }
  for (const WrongColour &p : comparison.off) {
    char line[160];
    (void)std::snprintf(line, sizeof line, "wrong colour at %d %d: core %d %d %d, oracle %.2f %.2f %.2f\n", p.x, p.y, p.core[0],
                        p.core[1], p.core[2], p.oracle[0], p.oracle[1], p.oracle[2]);
    text += line;
  }
  (void)std::fputs(text.c_str(), to);
}

/* Errors as a heat map, with what is simply wrong in colours that no heat map has. */
Image8 error_picture(const LoadedScene &scene, const Comparison &comparison) {
  Image8 picture = heat_map(scene.width, scene.height, comparison.error);
  for (const WrongPixel &wrong : comparison.wrong) {
    const std::size_t at =
        3 * (static_cast<std::size_t>(wrong.y) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(wrong.x));
    picture.rgb[at] = wrong.wrong_id ? 255 : 0;
    picture.rgb[at + 1] = wrong.wrong_id ? 0 : 255;
    picture.rgb[at + 2] = wrong.wrong_id ? 255 : 0;
  }
  return picture;
}

int run_compare(const CompareOptions &options) {
  if (!options.output.empty()) check_not_same_file(options.scene, options.output);
  const LoadedScene scene = load_scene(options);
  const CoreFrame frame(scene.file, scene.core, scene.options, scene.width, scene.height);
  Pictures pictures;
  if (options.frame.empty())
    pictures = render(frame, Sampling(), 16); /* any height gives the same bits; short ones show progress */
  else
    pictures.rgb888 = pictures.rgb565 = read_frame_file(options.frame, scene.width, scene.height);
  const FrameCounts counts = count(pictures.rgb565);
  const Oracle oracle(scene.file, scene.width, scene.height);
  const Comparison comparison = compare(scene.file, oracle, frame, pictures.rgb888);
  const std::string depth = depth_text(options, oracle, scene);
  const std::string text = options.json ? "{" + frame_json(scene, counts) + json_text(comparison) + depth + "}\n"
                                        : frame_summary(scene, counts) + summary(comparison) + depth;
  (void)std::fputs(text.c_str(), stdout);
  if (!options.output.empty()) {
    const std::string written = write_image(
        options.output,
        side_by_side({{scene.width, scene.height, pictures.rgb888.pixels}, comparison.truth, error_picture(scene, comparison)}));
    (void)std::fprintf(options.json ? stderr : stdout, "wrote %s: core, oracle, colour error (wrong ids magenta, wrong shadows green)\n",
                       written.c_str());
  }
  if (options.verbose) /* stdout stays one JSON object */
    list_wrong_pixels(options.json ? stderr : stdout, oracle, comparison, scene.file.lights.size());
  const bool good = comparison.wrong_id == 0 && comparison.wrong_shadow == 0 && comparison.colour_max <= 1;
  return options.check && !good ? 1 : 0;
}

} // namespace

void add_compare_command(CLI::App &app, Action &action) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App *command = app.add_subcommand("compare", "Render a scene and count every error against the oracle");
  add_scene_options(*command, *options);
  add_offset_option(*command, *options);
  add_profile_option(*command, *options);
  add_transfer_option(*command, *options);
  command->add_flag("-v,--verbose", options->verbose,
                    "list each wrong pixel and its distance from the true edge");
  command
      ->add_option("--depth-format", options->depth_format,
                   "also count the pixels that a z-buffer of this format alone would get wrong")
      ->check(CLI::IsMember(depth_format_names()));
  command
      ->add_option("--frame", options->frame,
                   "measure the frame in this file instead of one by the core; nine bytes a pixel: object id (2) "
                   "and light mask (4), low byte first, red, green, blue; the CRC is then of red, green, blue")
      ->type_name("FILE");
  command
      ->add_option("-o,--output", options->output,
                   "write the core's picture, the oracle's and a heat map of the colour errors side by side")
      ->type_name("COMPARE.png");
  command->add_flag("--check", options->check, "exit with 1 unless ids and shadows are right and colours within 1");
  add_json_option(*command, *options);
  command->callback([&action, options] { action = [options] { return run_compare(*options); }; });
}

} // namespace host
