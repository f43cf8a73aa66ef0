/* The fixcast program: finds the command on the command line, runs it, turns errors into exit code 2. */
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "commands.h"
#include "image.h"
#include "scene_file.h"
#include "version.h"

namespace {

/* Every failure is one line on stderr and exit code 2. */
int fail(std::string what) {
  for (char &c : what)
    if (c == '\n') c = ' ';
  (void)std::fprintf(stderr, "fixcast: %s\n", what.c_str());
  return 2;
}

int run(int argc, char **argv) {
  CLI::App app{"fixcast: an exact integer ray caster, simulated on the host.", "fixcast"};
  app.set_version_flag("--version",
                       std::string("fixcast ") + host::version + " (images: " + host::image_backend() + ")");
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  app.footer(
      "Exit code: 0 done, 1 a check failed, 2 bad input. 'fixcast COMMAND --help' lists a command's "
      "options.");
  host::Action action;
  host::add_render_command(app, action);
  host::add_compare_command(app, action);
  host::add_diff_command(app, action);
  host::add_pick_command(app, action);
  host::add_bake_command(app, action);
  host::add_view_command(app, action);
  host::add_stats_command(app, action);
  host::add_depths_command(app, action);
  host::add_report_command(app, action);
  host::add_show_command(app, action);
  host::add_panels_command(app, action);
  host::add_probe_command(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError &error) {
    if (error.get_exit_code() == 0) return app.exit(error); /* --help, --version */
    /* An unknown command would otherwise be reported as a missing one. */
    const std::vector<std::string> unknown = app.remaining();
    const std::string what = !app.get_subcommands().empty() || unknown.empty()
                                 ? error.what()
                                 : "'" + unknown.front() + "' is neither a command nor an option";
    return fail(what + "; see 'fixcast --help'");
  }
  const int code = action();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return fail("cannot write to standard output");
  return code;
}

} // namespace

int main(int argc, char **argv) {
  try {
    return run(argc, argv);
  } catch (const host::UserError &error) {
    return fail(error.what());
  } catch (const std::bad_alloc &) {
    return fail("out of memory; try a smaller --size");
  } catch (const std::exception &error) {
    return fail(std::string("internal error: ") + error.what());
  }
}
