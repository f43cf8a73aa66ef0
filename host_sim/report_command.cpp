/* fixcast report: hands over to host_sim/report/report.py, which arranges what the bench counted. */
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "scene_file.h"

namespace host {
namespace {

struct ReportOptions {
  std::string bench = FIXCAST_BUILD_DIR "/bench/bench.json";
  std::string output = FIXCAST_SOURCE_DIR "/docs/REPORT.md";
  bool stale = false;
};

/* Does not come back but for an error. */
int run_report(const ReportOptions &options) {
  std::vector<std::string> words = {"python3", FIXCAST_SOURCE_DIR "/host_sim/report/report.py",
                                    "--simulator", FIXCAST_BUILD_DIR "/fixcast",
                                    "--bench", options.bench,
                                    "--output", options.output};
  if (options.stale) words.push_back("--stale");
  std::vector<char *> arguments;
  for (std::string &word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  (void)execvp(arguments[0], arguments.data());
  throw UserError(std::string("cannot run python3: ") + std::strerror(errno));
}

} // namespace

void add_report_command(CLI::App &app, Action &action) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App *command =
      app.add_subcommand("report", "Rewrite docs/REPORT.md and its plots from what 'make bench' counted");
  command->add_option("--bench", options->bench, "what 'make bench' wrote")->type_name("bench.json");
  command->add_option("--output", options->output, "the report to write; its plots go to a directory beside it")
      ->type_name("FILE");
  command->add_flag("--stale", options->stale, "take figures of other sources than this tree's, and say so");
  command->callback([&action, options] { action = [options] { return run_report(*options); }; });
}

} // namespace host
