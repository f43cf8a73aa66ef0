/* fixcast panels, fixcast probe: what a picture can be shown on, and what a board has to wire it to. */
#include <cstdio>

#include "commands.h"
#include "panel_list.h"
#include "wire.h"

namespace host {

void add_panels_command(CLI::App &app, Action &action) {
  CLI::App *command = app.add_subcommand("panels", "List the panels that 'fixcast show' knows");
  command->callback([&action] {
    action = [] {
      (void)std::fputs(list_panels().c_str(), stdout);
      return 0;
    };
  });
}

void add_probe_command(CLI::App &app, Action &action) {
  CLI::App *command = app.add_subcommand("probe", "List this board's SPI devices, GPIO chips and lines, and who may open them");
  command->callback([&action] {
    action = [] {
      (void)std::fputs(describe_board().c_str(), stdout);
      return 0;
    };
  });
}

} // namespace host
