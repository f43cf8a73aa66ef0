/* The commands that ask the oracle, in a program that was built without it: they say so. */
#include <string>

#include "commands.h"
#include "error_layer.h"
#include "scene_file.h"

namespace host {
namespace {

void add_missing(CLI::App &app, Action &action, const std::string &name) {
  CLI::App *command = app.add_subcommand(name, "Not in this program: it was built without the oracle (FIXCAST_ORACLE=OFF)");
  command->allow_extras();
  command->callback([&action, name] {
    action = [name]() -> int {
      throw UserError(name + " needs the oracle, and this program was built without (FIXCAST_ORACLE=OFF); run it on a PC");
    };
  });
}

} // namespace

std::vector<float> error_layer(const LoadedScene &, const CoreFrame &, const Picture &) {
  throw UserError("the layer error needs the oracle, and this program was built without (FIXCAST_ORACLE=OFF); run it on a PC");
}

void add_compare_command(CLI::App &app, Action &action) { add_missing(app, action, "compare"); }

void add_depths_command(CLI::App &app, Action &action) { add_missing(app, action, "depths"); }

void add_view_command(CLI::App &app, Action &action) { add_missing(app, action, "view"); }

} // namespace host
