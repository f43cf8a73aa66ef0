/* The command line that all commands share. */
#include "scene_options.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "hierarchy.h"
#include "obj.h"
#include "report.h"

namespace host {
namespace {

bool is_obj(const std::string &path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension == ".obj";
}

/* A plain decimal integer in 1..limit. */
std::optional<int> positive(const std::string &text, int limit) {
  long long value = 0;
  for (char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    value = 10 * value + (c - '0');
    if (value > limit) return std::nullopt;
  }
  if (value < 1) return std::nullopt;
  return static_cast<int>(value);
}

void set_size(LoadedScene &scene, const std::string &text) {
  if (text.empty()) {
    const SceneFile &file = scene.file;
    const bool stated = file.width >= 1 && file.width <= FC_SIZE_MAX && file.height >= 1 && file.height <= FC_SIZE_MAX;
    scene.width = stated ? file.width : 128;
    scene.height = stated ? file.height : 128;
    return;
  }
  const std::size_t x = text.find('x');
  const std::optional<int> width = positive(text.substr(0, x), FC_SIZE_MAX);
  const std::optional<int> height = x == std::string::npos ? std::nullopt : positive(text.substr(x + 1), FC_SIZE_MAX);
  if (!width || !height) throw UserError("--size " + text + " is not a frame size; give WIDTHxHEIGHT, each 1 to 4096, such as 128x128");
  scene.width = *width;
  scene.height = *height;
}

std::uint8_t to_profile(const std::string &name) {
  if (name == "exact") return FC_PROFILE_EXACT;
  if (name == "fast") return FC_PROFILE_FAST;
  if (name == "half") return FC_PROFILE_HALF;
  if (name == "interlaced") return FC_PROFILE_INTERLACED;
  throw UserError("--profile takes exact, fast, half or interlaced, not \"" + name + "\"");
}

const fc_transfer *to_transfer(const std::string &name) {
  if (name == "linear") return nullptr;
  if (name == "srgb") return &fc_transfer_srgb;
  if (name == "gamma22") return &fc_transfer_gamma22;
  throw UserError("--transfer takes linear, srgb or gamma22, not \"" + name + "\"");
}

SceneFile read_scene(const SceneOptions &options) {
  if (!is_obj(options.scene)) {
    SceneFile file = read_nff(options.scene);
    apply(options.view, file);
    return file;
  }
  SceneFile file = read_obj(options.scene);
  frame_all(file, 30, 20);
  if (!options.view.look.empty()) apply(options.view, file); /* first, so that the light comes along */
  light_up(file);
  apply(options.view, file);
  return file;
}

void set_world_scale(SceneFile &file, const std::string &text) {
  constexpr int limit = 1 << 30;
  const std::size_t slash = text.find('/');
  const std::optional<int> numerator = positive(text.substr(0, slash), limit);
  const std::optional<int> denominator = slash == std::string::npos ? std::optional<int>(1) : positive(text.substr(slash + 1), limit);
  if (!numerator || !denominator) throw UserError("--world-scale " + text + " is not a scale; give N or N/D, each 1 to 2^30, such as 1/64");
  file.scale_numerator = *numerator;
  file.scale_denominator = *denominator;
}

} // namespace

void add_scene_options(CLI::App &command, SceneOptions &options) {
  add_plain_scene_options(command, options);
  command.add_option("--size", options.size, "frame size; default: the scene's resolution, or 128x128")
      ->type_name("WxH");
  command.add_option("--world-scale", options.world_scale, "multiply every length of the scene by N/D")
      ->type_name("N/D");
}

CLI::Option *add_plain_scene_options(CLI::App &command, SceneOptions &options) {
  CLI::Option *scene = command.add_option("scene", options.scene, "scene file: NFF, or a Wavefront model .obj")->required()->type_name("SCENE");
  add_bvh_option(command, options);
  add_view_options(command, options);
  return scene;
}

void add_view_options(CLI::App &command, SceneOptions &options) {
  ViewOptions &view = options.view;
  constexpr const char *group = "Camera and lights, over those of the scene";
  const auto add = [&](const char *name, std::string &to, const char *what, const char *type) {
    command.add_option(name, to, what)->type_name(type)->group(group);
  };
  add("--look", view.look, "see everything from this direction, degrees: 0,0 from +z, 90,0 from +x, 0,90 from above", "AZIMUTH,ELEVATION");
  add("--from", view.from, "where the eye is", "X,Y,Z");
  add("--at", view.at, "what it looks at", "X,Y,Z");
  add("--up", view.up, "what is up", "X,Y,Z");
  add("--angle", view.angle, "field of view across the shorter side", "DEGREES");
  command.add_option("--light", view.lights, "a light instead of the scene's; may be repeated")
      ->type_name("X,Y,Z[,R,G,B]")
      ->group(group)
      ->allow_extra_args(false);
  add("--ambient", view.ambient, "ambient light", "A or R,G,B");
  add("--background", view.background, "background colour, 0 to 1", "A or R,G,B");
}

void add_offset_option(CLI::App &command, SceneOptions &options) {
  command
      .add_option("--offset", options.offset,
                  "how shadow rays leave a surface: exact (default), residual, none or epsilon=N in world units")
      ->type_name("RULE");
}

void add_profile_option(CLI::App &command, SceneOptions &options) {
  command
      .add_option("--profile", options.profile,
                  "what the frame gives up for speed: exact (default: nothing), fast, half or interlaced (both fields of a "
                  "still scene)")
      ->type_name("PROFILE");
}

void add_transfer_option(CLI::App &command, SceneOptions &options) {
  command
      .add_option("--transfer", options.transfer,
                  "from light to levels: linear (default), srgb or gamma22 (a display that shows level^2.2)")
      ->type_name("FUNCTION");
}

void add_depth_option(CLI::App &command, SceneOptions &options) {
  command
      .add_option("--depth-bits", options.depth_bits,
                  "exponent bits of a depth code: 2, 3, 4, or auto (default: the least that the scene's range of depths takes); fewer are finer, and "
                  "take what is too far away as equally far")
      ->check(CLI::IsMember({"auto", "2", "3", "4"}))
      ->type_name("BITS");
}

void add_bvh_option(CLI::App &command, SceneOptions &options) {
  command
      .add_option("--bvh", options.bvh,
                  "a bounding volume hierarchy: on, off or auto (default: for lit scenes of more than 16 spheres and "
                  "triangles); it changes the time, never the picture")
      ->type_name("CHOICE");
}

void add_json_option(CLI::App &command, SceneOptions &options) { command.add_flag("--json", options.json, "print one JSON object"); }

LoadedScene load_scene(const SceneOptions &options) {
  LoadedScene unread;
  /* What is typed wrong is said before a large file is read, except for the size the file may state. */
  set_world_scale(unread.file, options.world_scale);
  (void)to_profile(options.profile);
  (void)to_transfer(options.transfer);
  if (!options.size.empty()) set_size(unread, options.size);
  LoadedScene scene = prepare_scene(options, read_scene(options));
  const MeshCounts &mesh = scene.core.mesh;
  if (mesh.dropped > 0)
    scene.file.warnings.push_back(count_text(mesh.dropped, "triangle") + " without area " + (mesh.dropped == 1 ? "was" : "were") +
                                  " left out");
  if (mesh.non_manifold_edges > 0 && is_obj(options.scene))
    scene.file.warnings.push_back(count_text(mesh.non_manifold_edges, "edge") +
                                  (mesh.non_manifold_edges == 1 ? " is" : " are") +
                                  " shared by more than two triangles; the model is no closed surface there");
  for (const std::string &warning : scene.file.warnings) (void)std::fprintf(stderr, "%s: %s\n", options.scene.c_str(), warning.c_str());
  return scene;
}

LoadedScene prepare_scene(const SceneOptions &options, SceneFile file) {
  LoadedScene scene;
  scene.file = std::move(file);
  set_world_scale(scene.file, options.world_scale);
  set_size(scene, options.size);
  scene.core = to_core(scene.file);
  add_hierarchy(scene.core, options.bvh);
  scene.options = to_options(options.offset, scene.core.scene);
  scene.options.profile = to_profile(options.profile);
  scene.options.transfer = to_transfer(options.transfer);
  scene.options.depth_exponent_bits = static_cast<std::uint8_t>(options.depth_bits == "auto" ? 0 : options.depth_bits[0] - '0');
  return scene;
}

void check_not_same_file(const std::string &input, const std::string &output) {
  std::error_code ignored;
  if (std::filesystem::equivalent(input, output, ignored))
    throw UserError(output + ": cannot write: this is the scene itself; choose another name");
}

} // namespace host
