/*
 * The command line that all commands share: which scene, at which size, at which world scale, by which rule.
 */
#ifndef FIXCAST_HOST_SCENE_OPTIONS_H
#define FIXCAST_HOST_SCENE_OPTIONS_H

#include <string>

#include <CLI/CLI.hpp>

#include "auto_view.h"
#include "scene_file.h"
#include "to_core.h"

namespace host {

/* As typed. */
struct SceneOptions {
  std::string scene, size, world_scale = "1", offset = "exact", bvh = "auto", profile = "exact", transfer = "linear", depth_bits = "auto";
  ViewOptions view;
  bool json = false;
};

/* A scene, ready for a frame to be set up. */
struct LoadedScene {
  SceneFile file;
  CoreScene core;
  fc_options options{};
  int width = 0, height = 0;
};

/* SCENE, --size, --world-scale, --bvh, and the camera and lights over those of the file. */
void add_scene_options(CLI::App &command, SceneOptions &options);
/* SCENE and what is not --size or --world-scale; returns SCENE, which may be made optional. */
CLI::Option *add_plain_scene_options(CLI::App &command, SceneOptions &options);
void add_offset_option(CLI::App &command, SceneOptions &options);
void add_profile_option(CLI::App &command, SceneOptions &options);
void add_transfer_option(CLI::App &command, SceneOptions &options);
void add_depth_option(CLI::App &command, SceneOptions &options);
void add_bvh_option(CLI::App &command, SceneOptions &options);
void add_view_options(CLI::App &command, SceneOptions &options);
void add_json_option(CLI::App &command, SceneOptions &options);

/* Reads and converts the scene, NFF or, by its name, OBJ; warnings go to stderr. Throws UserError. */
LoadedScene load_scene(const SceneOptions &options);

/* The same for a file that was read before, its camera or lights perhaps moved since. Throws UserError. */
LoadedScene prepare_scene(const SceneOptions &options, SceneFile file);

/* Throws UserError if writing `output` would replace the file `input`. */
void check_not_same_file(const std::string &input, const std::string &output);

} // namespace host

#endif
