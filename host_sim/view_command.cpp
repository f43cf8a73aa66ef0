/* fixcast view: a scene in a window, to be turned by hand. */
#include <memory>
#include <string>
#include <utility>

#include "commands.h"
#include "panel_list.h"
#include "scene_options.h"
#include "sequence.h"
#include "view_window.h"
#include "viewer.h"

namespace host {
namespace {

struct ViewCommandOptions : SceneOptions {
  WindowOptions window;
  std::string display;
};

int run_view(ViewCommandOptions options) {
  if (!is_sequence_name(options.window.shots))
    throw UserError("--shots " + options.window.shots + " has no place for a number; write it as in view_%04d.png");
  const fc_panel *const panel = options.display.empty() ? nullptr : &find_panel(options.display);
  if (panel != nullptr && options.size.empty()) options.size = std::to_string(panel->width) + "x" + std::to_string(panel->height);
  Viewer viewer(load_scene(options), panel);
  viewer.render(); /* what the core refuses is said before a window opens */
  return run_window(viewer, options.window);
}

} // namespace

void add_view_command(CLI::App &app, Action &action) {
  const auto options = std::make_shared<ViewCommandOptions>();
  CLI::App *command = app.add_subcommand("view", "Show a scene in a window, to be turned by hand");
  add_scene_options(*command, *options);
  add_offset_option(*command, *options);
  add_profile_option(*command, *options);
  add_transfer_option(*command, *options);
  add_depth_option(*command, *options);
  command->add_option("--display", options->display, "show what this panel would: its size, pixel format and dither")
      ->check(CLI::IsMember(panel_names()))
      ->type_name("PANEL");
  command->add_option("--zoom", options->window.zoom, "screen pixels a pixel; default: as many as fit well")
      ->check(CLI::Range(1, 32))
      ->type_name("N");
  command->add_flag("--spin", options->window.spin, "let the scene turn from the start");
  command->add_option("--frames", options->window.frames, "quit after so many pictures of the turning scene, and say how fast they were")
      ->check(CLI::Range(1, 1000000))
      ->type_name("N");
  command->add_flag("--log", options->window.log, "print a line for each picture: its CRC-32 and what it shows");
  command->add_option("--shots", options->window.shots, "names of screenshots; default view_%04d.png")->type_name("NAME");
  command->footer(view_keys);
  command->callback([&action, options] { action = [options] { return run_view(*options); }; });
}

} // namespace host
