/* fixcast bake: a scene as C tables for firmware. */
#include <cstdio>
#include <memory>
#include <string>

#include "atomic_file.h"
#include "bake.h"
#include "commands.h"
#include "frame_run.h"
#include "scene_options.h"

namespace host {
namespace {

struct BakeOptions : SceneOptions {
  std::string output, name;
};

int run_bake(const BakeOptions &options) {
  const std::string name = options.name.empty() ? c_name_of(options.scene) : options.name;
  if (!is_c_name(name))
    throw UserError("--name " + name +
                    " cannot name a C object; use letters, digits and _, starting with a letter");
  check_not_same_file(options.scene, options.output);
  const LoadedScene scene = load_scene(options);
  /* Set up once, so that no table is written which the chip would refuse. */
  const CoreFrame frame(scene.file, scene.core, scene.options, scene.width, scene.height);
  write_file(options.output, bake(scene.core, frame.memory_bytes(), name, options.scene));
  (void)std::printf("wrote %s: fc_scene %s, fc_camera %s_camera\n", options.output.c_str(), name.c_str(),
                    name.c_str());
  return 0;
}

} // namespace

void add_bake_command(CLI::App &app, Action &action) {
  const auto options = std::make_shared<BakeOptions>();
  CLI::App *command = app.add_subcommand("bake", "Write a scene as constant C tables for firmware");
  command->add_option("scene", options->scene, "scene file: NFF, or a Wavefront model .obj")->required()->type_name("SCENE");
  command->add_option("-o,--output", options->output, "the C file to write")
      ->required()
      ->type_name("scene.c");
  command->add_option("--name", options->name, "C name of the scene; default: the scene's file name")
      ->type_name("NAME");
  add_bvh_option(*command, *options);
  add_view_options(*command, *options);
  command->callback([&action, options] { action = [options] { return run_bake(*options); }; });
}

} // namespace host
