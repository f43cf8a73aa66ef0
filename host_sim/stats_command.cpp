/* fixcast stats: what a scene would cost on a chip. */
#include <cstdio>
#include <memory>
#include <string>

#include "commands.h"
#include "scene_facts.h"
#include "scene_options.h"

namespace host {
namespace {

int run_stats(const SceneOptions &options) {
  const SceneFacts facts = scene_facts(load_scene(options));
  std::string text;
  if (options.json)
    text = fact_json(facts);
  else
    for (const std::string &line : fact_lines(facts)) text += line + "\n";
  (void)std::fputs(text.c_str(), stdout);
  return 0;
}

} // namespace

void add_stats_command(CLI::App &app, Action &action) {
  const auto options = std::make_shared<SceneOptions>();
  CLI::App *command = app.add_subcommand("stats", "Say what a scene would cost on a chip: counts, flash, memory, parts of the core");
  add_scene_options(*command, *options);
  add_json_option(*command, *options);
  command->callback([&action, options] { action = [options] { return run_stats(*options); }; });
}

} // namespace host
