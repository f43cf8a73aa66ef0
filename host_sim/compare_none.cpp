/* fixcast compare in a program that was built without the oracle: it says so. */
#include <string>

#include "commands.h"
#include "scene_file.h"

namespace host {

void add_compare_command(CLI::App &app, Action &action) {
  CLI::App *command = app.add_subcommand("compare", "Not in this program: it was built without the oracle (FIXCAST_ORACLE=OFF)");
  command->allow_extras();
  command->callback([&action] {
    action = []() -> int { throw UserError("compare needs the oracle, and this program was built without (FIXCAST_ORACLE=OFF); run it on a PC"); };
  });
}

} // namespace host
