/* fixcast bake: a scene as C tables for firmware. */
#include <cstdio>
#include <memory>
#include <string>

#include "atomic_file.h"
#include "bake.h"
#include "commands.h"
#include "scene_facts.h"
#include "scene_options.h"

namespace host {
namespace {

struct BakeOptions : SceneOptions {
  std::string output, name, header;
};

int run_bake(const BakeOptions &options) {
  const std::string name = options.name.empty() ? c_name_of(options.scene) : options.name;
  if (!is_c_name(name)) throw UserError("--name " + name + " cannot name a C object; use letters, digits and _, starting with a letter");
  for (const std::string &path : {options.output, options.header})
    if (!path.empty()) check_not_same_file(options.scene, path);
  if (options.output == options.header) throw UserError(options.output + ": -o and --header name the same file; choose two");
  const LoadedScene scene = load_scene(options);
  const SceneFacts facts = scene_facts(scene);
  write_file(options.output, bake(scene.core, facts, name));
  if (!options.header.empty()) write_file(options.header, bake_header(facts, name));
  (void)std::printf("wrote %s: fc_scene %s, fc_camera %s_camera\n", options.output.c_str(), name.c_str(), name.c_str());
  if (!options.header.empty()) (void)std::printf("wrote %s\n", options.header.c_str());
  for (const std::string &line : fact_lines(facts)) (void)std::printf("%s\n", line.c_str());
  return 0;
}

} // namespace

void add_bake_command(CLI::App &app, Action &action) {
  const auto options = std::make_shared<BakeOptions>();
  CLI::App *command = app.add_subcommand("bake", "Write a scene as constant C tables for firmware");
  command->add_option("scene", options->scene, "scene file: NFF, or a Wavefront model .obj")->required()->type_name("SCENE");
  command->add_option("-o,--output", options->output, "the C file to write")->required()->type_name("scene.c");
  command->add_option("--header", options->header, "also write a header that declares the scene and its camera")->type_name("scene.h");
  command->add_option("--name", options->name, "C name of the scene; default: the scene's file name")->type_name("NAME");
  add_bvh_option(*command, *options);
  add_view_options(*command, *options);
  command->callback([&action, options] { action = [options] { return run_bake(*options); }; });
}

} // namespace host
