/*
 * The commands of the fixcast program: each adds itself to the command line.
 */
#ifndef FIXCAST_HOST_COMMANDS_H
#define FIXCAST_HOST_COMMANDS_H

#include <functional>

#include <CLI/CLI.hpp>

namespace host {

/* What the command line asks for, to be run once it is parsed; returns the exit code and throws UserError. */
using Action = std::function<int()>;

void add_render_command(CLI::App &app, Action &action);
void add_compare_command(CLI::App &app, Action &action);
void add_diff_command(CLI::App &app, Action &action);
void add_pick_command(CLI::App &app, Action &action);
void add_bake_command(CLI::App &app, Action &action);
void add_view_command(CLI::App &app, Action &action);
void add_stats_command(CLI::App &app, Action &action);
void add_depths_command(CLI::App &app, Action &action);
void add_report_command(CLI::App &app, Action &action);
void add_show_command(CLI::App &app, Action &action);
void add_panels_command(CLI::App &app, Action &action);
void add_probe_command(CLI::App &app, Action &action);

} // namespace host

#endif
