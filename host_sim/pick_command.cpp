/* fixcast pick: what one pixel shows. */
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "commands.h"
#include "frame_run.h"
#include "report.h"
#include "scene_options.h"

namespace host {
namespace {

struct PickOptions : SceneOptions {
  int x = 0, y = 0;
};

/* Three numbers, each times 2^exponent, with `separator` between them. */
std::string vector_text(const fc_vec3 &v, int exponent, const char *separator) {
  return number_text(std::ldexp(v.x, exponent)) + separator + number_text(std::ldexp(v.y, exponent)) +
         separator + number_text(std::ldexp(v.z, exponent));
}

/* Numbers of the lights that reach the point; the mask's last bit stands for every further light. */
std::string lights_text(std::uint32_t lit, const char *separator) {
  std::string text;
  for (int i = 0; i < 32; i++)
    if (lit >> i & 1) text += (text.empty() ? "" : separator) + std::to_string(i);
  return text;
}

std::string json_text(const fc_hit &hit, std::uint32_t lit, int exponent) {
  return "{\"id\": " + std::to_string(hit.object) + ", \"primitive\": " + std::to_string(hit.primitive) +
         ", \"position\": [" + vector_text(hit.position, exponent, ", ") + "], \"normal\": [" +
         vector_text(hit.normal_q30, -30, ", ") + "], \"inside\": " + (hit.inside ? "true" : "false") +
         ", \"lit\": [" + lights_text(lit, ", ") + "]}\n";
}

std::string words(const fc_hit &hit, std::uint32_t lit, int exponent) {
  return "object " + std::to_string(hit.object) + ", primitive " + std::to_string(hit.primitive) +
         (hit.inside ? ", seen from inside or behind" : "") + "\nposition " +
         vector_text(hit.position, exponent, " ") + "\nnormal " + vector_text(hit.normal_q30, -30, " ") +
         (lit != 0 ? "\nlit by light " + lights_text(lit, ", ") : std::string("\nlit by no light")) + "\n";
}

int run_pick(const PickOptions &options) {
  const LoadedScene scene = load_scene(options);
  if (options.x < 0 || options.x >= scene.width || options.y < 0 || options.y >= scene.height)
    throw UserError("pixel " + std::to_string(options.x) + " " + std::to_string(options.y) +
                    " is outside the frame; x is 0 to " + std::to_string(scene.width - 1) + " and y 0 to " +
                    std::to_string(scene.height - 1));
  const CoreFrame frame(scene.file, scene.core, scene.options, scene.width, scene.height);
  fc_hit hit{};
  std::uint32_t lit = 0;
  const int result = fc_pick(&frame.get(), static_cast<std::uint16_t>(options.x),
                             static_cast<std::uint16_t>(options.y), &hit, &lit);
  if (result < 0) throw UserError(scene.file.path + ": " + fc_error_text(result));
  const int exponent = scene.core.scene.exponent - 16;
  std::string text;
  if (result == 0)
    text = options.json ? "{\"id\": 0, \"primitive\": null, \"position\": null, \"normal\": null, "
                          "\"inside\": false, \"lit\": []}\n"
                        : "background\n";
  else
    text = options.json ? json_text(hit, lit, exponent) : words(hit, lit, exponent);
  (void)std::fputs(text.c_str(), stdout);
  return 0;
}

} // namespace

void add_pick_command(CLI::App &app, Action &action) {
  const auto options = std::make_shared<PickOptions>();
  CLI::App *command =
      app.add_subcommand("pick", "Say what one pixel shows: object, position, normal, lights");
  add_scene_options(*command, *options);
  command->add_option("x", options->x, "column, 0 at the left")->required()->type_name("X");
  command->add_option("y", options->y, "row, 0 at the top")->required()->type_name("Y");
  add_profile_option(*command, *options);
  add_json_option(*command, *options);
  command->callback([&action, options] { action = [options] { return run_pick(*options); }; });
}

} // namespace host
