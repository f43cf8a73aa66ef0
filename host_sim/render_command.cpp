/* fixcast render: frames by the core, as pictures and as counts. */
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "atomic_file.h"
#include "camera_path.h"
#include "commands.h"
#include "error_layer.h"
#include "filtered_frame.h"
#include "frame_layers.h"
#include "frame_run.h"
#include "gif.h"
#include "image.h"
#include "panel_list.h"
#include "panel_view.h"
#include "pnm.h"
#include "progress.h"
#include "report.h"
#include "scene_options.h"
#include "sequence.h"
#include "version.h"

namespace host {
namespace {

struct RenderOptions : SceneOptions {
  SamplingOptions sampling;
  std::string frame_path, depth_path, samples_path, panel_path, show = "color", path, display;
  std::vector<std::string> layers;
  int strip_rows = FC_SIZE_MAX, frames = 0, bits = 8, fps = 20;
  bool dither = false;

  bool shows(const std::string &layer) const { return show == layer || std::find(layers.begin(), layers.end(), layer) != layers.end(); }
};

/* Depth codes as greys for people, in the order of the codes and by their ranks: a floor that goes on to the horizon has most of the codes, and
 * would leave one white for all that stands on it. The farthest surface is a dark grey; nothing there is black. */
std::vector<std::uint16_t> depth_greys(std::vector<std::uint16_t> codes) {
  constexpr std::uint64_t darkest = 6000, white = 65535;
  std::map<std::uint16_t, std::uint64_t> pixels;
  std::uint64_t all = 0, below = 0;
  for (const std::uint16_t code : codes) {
    if (code == 0) continue;
    pixels[code]++;
    all++;
  }
  std::map<std::uint16_t, std::uint16_t> grey;
  for (const auto &[code, count] : pixels) {
    grey[code] = static_cast<std::uint16_t>(darkest + (white - darkest) * (2 * below + count) / (2 * all));
    below += count;
  }
  for (std::uint16_t &code : codes)
    if (code != 0) code = grey[code];
  return codes;
}

/* Rays a pixel as greys: the pixel that took most is white. */
std::vector<std::uint16_t> sample_greys(std::vector<std::uint16_t> counts) {
  constexpr std::uint32_t white = 65535;
  std::uint32_t most = 1;
  for (std::uint32_t count : counts) most = std::max(most, count);
  for (std::uint16_t &count : counts) count = static_cast<std::uint16_t>((count * white + most / 2) / most);
  return counts;
}

/* A frame, rendered, and the oracle's opinion of it where it was asked for. */
struct RenderedFrame {
  LoadedScene scene;
  std::unique_ptr<CoreFrame> frame; /* keeps a reference to the scene: neither is moved any more */
  Pictures pictures;
  FrameCounts counts;
  std::vector<float> error;
  std::uint64_t rays = 0; /* that --samples took */
};

void render_into(RenderedFrame &to, const RenderOptions &options, bool quiet) {
  Sampling sampling;
  set_sampling(sampling, options.sampling, to.scene.core);
  if (sampling.wanted && to.scene.options.profile != FC_PROFILE_EXACT)
    throw UserError("--profile " + options.profile + ": --samples, --filter and --lens trace exact rays; leave --profile out");
  to.frame = std::make_unique<CoreFrame>(to.scene.file, to.scene.core, to.scene.options, to.scene.width, to.scene.height);
  Sampling centres; /* what a kernel leaves of the frame: depth, objects and shadows at the pixels' centres */
  centres.wanted = true;
  centres.how.lens = sampling.how.lens;
  to.pictures = render(*to.frame, sampling.kernel ? centres : sampling, options.strip_rows, quiet);
  if (sampling.kernel) filter_frame(to.pictures, to.scene.core, to.scene.options, sampling, quiet);
  if (sampling.wanted)
    for (std::uint16_t samples : to.pictures.rgb888.samples) to.rays += samples;
  if (options.dither) to.pictures.rgb565.pixels = dithered565(to.pictures.rgb888);
  to.counts = count(to.pictures.rgb565);
  if (options.shows("error")) to.error = error_layer(to.scene, *to.frame, to.pictures.rgb888);
}

/* Where a picture comes from; the same for the same scene on every machine. */
Metadata metadata_of(const RenderOptions &options, const RenderedFrame &frame) {
  return {{"fixcast:version", version},
          {"fixcast:scene", std::filesystem::path(options.scene).filename().string()},
          {"fixcast:crc32", hex_text(frame.counts.crc32)},
          {"fixcast:profile", options.profile}};
}

Raster layers_of(const RenderedFrame &frame, const std::vector<std::string> &wanted) {
  return frame_layers(*frame.frame, frame.scene.core, frame.pictures.rgb888, frame.error, wanted);
}

Image8 picture_of(const RenderOptions &options, const RenderedFrame &frame) {
  if (!options.display.empty()) return panel_picture(find_panel(options.display), frame.pictures.rgb565);
  if (options.show == "color") return {frame.scene.width, frame.scene.height, frame.pictures.rgb888.pixels};
  return layer_picture(layers_of(frame, {options.show}), options.show);
}

/* What was written, a line each. */
std::string write_files(const RenderOptions &options, const RenderedFrame &frame, int number) {
  const Metadata metadata = metadata_of(options, frame);
  std::string written;
  if (!options.frame_path.empty()) {
    const std::string path = sequence_name(options.frame_path, number), extension = image_extension(path);
    if (extension == ".exr")
      written += write_raster(path, layers_of(frame, options.layers), metadata);
    else if (extension == ".gif")
      write_file(path, encode_gif({picture_of(options, frame)}, 100, metadata)), written += path;
    else if (options.bits == 16)
      written += write_image16(path, picture_of(options, frame), metadata);
    else
      written += write_image(path, picture_of(options, frame), metadata);
    written = "wrote " + written + "\n";
  }
  if (!options.depth_path.empty())
    written += "wrote " +
               write_depth(sequence_name(options.depth_path, number),
                           {frame.scene.width, frame.scene.height, depth_greys(frame.pictures.rgb565.depth)}, metadata) +
               "\n";
  if (!options.panel_path.empty()) {
    const std::string path = sequence_name(options.panel_path, number);
    write_file(path, std::string(frame.pictures.rgb565.pixels.begin(), frame.pictures.rgb565.pixels.end()));
    written += "wrote " + path + "\n";
  }
  if (!options.samples_path.empty())
    written += "wrote " +
               write_depth(sequence_name(options.samples_path, number),
                           {frame.scene.width, frame.scene.height, sample_greys(frame.pictures.rgb888.samples)}, metadata) +
               "\n";
  if (frame.rays > 0) written = std::to_string(frame.rays) + " rays make the pixels\n" + written;
  return written;
}

int run_one(const RenderOptions &options) {
  RenderedFrame frame;
  frame.scene = load_scene(options);
  render_into(frame, options, false);
  const std::string written = write_files(options, frame, 0);
  const std::string rays = frame.rays > 0 ? ", \"rays\": " + std::to_string(frame.rays) : "";
  const std::string text = options.json ? "{" + frame_json(frame.scene, frame.counts) + rays + "}\n"
                                        : frame_summary(frame.scene, frame.counts) + written;
  (void)std::fputs(text.c_str(), stdout);
  return 0;
}

/* Frames along a path: into files of their own, or all into one animation. */
int run_sequence(const RenderOptions &options) {
  const bool animation = image_extension(options.frame_path) == ".gif" && !is_sequence_name(options.frame_path);
  const LoadedScene first = load_scene(options);
  const std::unique_ptr<CameraPath> path = make_camera_path(options.path, first.file, first.core);
  std::vector<Image8> pictures;
  Metadata metadata;
  std::string json, lines;
  {
    Progress progress("rendering frames", static_cast<std::size_t>(options.frames));
    for (int i = 0; i < options.frames; i++) {
      RenderedFrame frame;
      frame.scene = prepare_scene(options, path->at(i, options.frames));
      render_into(frame, options, true);
      if (animation) {
        if (i == 0) metadata = metadata_of(options, frame);
        pictures.push_back(picture_of(options, frame));
      } else {
        lines += write_files(options, frame, i);
      }
      json += (i > 0 ? ", \"" : "\"") + hex_text(frame.counts.crc32) + "\"";
      progress.update(static_cast<std::size_t>(i + 1));
    }
  }
  if (animation) {
    write_file(options.frame_path, encode_gif(pictures, std::max(1, 100 / options.fps), metadata));
    lines += "wrote " + options.frame_path + ", " + count_text(pictures.size(), "frame") + "\n";
  }
  if (options.json) lines = "{\"crc32s\": [" + json + "]}\n";
  (void)std::fputs(lines.c_str(), stdout);
  return 0;
}

/* What can be said before anything is rendered. */
void check(const RenderOptions &options) {
  const std::pair<const char *, const std::string &> files[] = {{"-o", options.frame_path},
                                                                {"--depth", options.depth_path},
                                                                {"--rgb565", options.panel_path},
                                                                {"--samples-image", options.samples_path}};
  for (const auto &[option, path] : files) {
    if (path.empty()) continue;
    check_not_same_file(options.scene, path);
    for (const auto &[other_option, other] : files) {
      if (&other == &path) break;
      if (other == path) throw UserError(path + ": " + other_option + " and " + option + " name the same file; choose two");
    }
  }
  if (!options.samples_path.empty() && options.sampling.samples.empty())
    throw UserError("--samples-image needs --samples: without it every pixel has one ray");
  const std::string extension = image_extension(options.frame_path);
  if (options.bits == 16 && extension != ".png" && extension != ".tif" && extension != ".tiff")
    throw UserError("--bits 16 needs -o with a name that ends in .png or .tif");
  if (options.dither && options.display.empty() && options.panel_path.empty())
    throw UserError("--dither is about a display's 16 bits a pixel; give --display PANEL or --rgb565 FRAME.bin with it");
  if (options.dither && !options.display.empty() && find_panel(options.display).format != FC_DISPLAY_RGB565)
    throw UserError("--dither: what " + options.display + " shows is dithered always; leave it out");
  if (!options.display.empty() && options.show != "color") throw UserError("--display and --show exclude each other; choose one");
  const bool sequence = is_sequence_name(options.frame_path);
  if (options.path.empty()) {
    if (options.frames > 1) throw UserError("--frames without a path would draw the same frame again; add --path orbit");
    for (const auto &[option, path] : files)
      if (!path.empty() && is_sequence_name(path)) throw UserError(path + ": a name for many frames; add --path orbit, or take the % out");
    return;
  }
  if (!sequence && extension != ".gif")
    throw UserError("--path draws many frames; let -o be a name such as frame_%04d.png or turn.gif");
  for (const auto &[option, path] : files)
    if (&path != &options.frame_path && !path.empty() && (!is_sequence_name(path) || !sequence))
      throw UserError(std::string(option) + " with --path needs names with a number's place, such as depth_%04d.png, here and in -o");
}

} // namespace

void add_render_command(CLI::App &app, Action &action) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App *command = app.add_subcommand("render", "Render a scene and report what is in the frame");
  add_scene_options(*command, *options);
  command
      ->add_option("-o,--output", options->frame_path,
                   "write the frame: .png, .ppm, .gif and others in 8 bits a channel; .exr with all layers as channels; with --path "
                   "frame_%04d.png or an animated .gif")
      ->type_name("FRAME.png");
  command->add_option("--depth", options->depth_path, "write the depth codes by rank as 16-bit greys, nearer is brighter")
      ->type_name("DEPTH.png");
  command->add_option("--bits", options->bits, "bits a channel of a .png or .tif: 8 (default) or 16")
      ->check(CLI::IsMember({8, 16}))
      ->type_name("BITS");
  command->add_option("--show", options->show, "write this layer in colours instead of the frame")
      ->check(CLI::IsMember(layer_names()))
      ->type_name("LAYER");
  command->add_option("--display", options->display, "write what this panel would show: its size, pixel format and dither")
      ->check(CLI::IsMember(panel_names()))
      ->type_name("PANEL");
  command
      ->add_option("--layers", options->layers,
                   "layers in an .exr, with commas between; default: all but error, which asks the oracle at every pixel")
      ->delimiter(',')
      ->check(CLI::IsMember(layer_names()))
      ->type_name("LAYER,...");
  command
      ->add_option("--path", options->path,
                   "draw many frames: orbit (the camera goes around), turntable (the scene turns) or a file of key frames, lines "
                   "FRAME from X Y Z at X Y Z")
      ->type_name("PATH");
  command->add_option("--frames", options->frames, "how many with --path; default 36")
      ->type_name("N")
      ->check(CLI::Range(1, 9999));
  command->add_option("--fps", options->fps, "frames a second of an animated .gif; default 20")
      ->type_name("N")
      ->check(CLI::Range(1, 100));
  command
      ->add_option("--rgb565", options->panel_path,
                   "write the pixels as a panel gets them: two bytes each, high byte first, rows from the top, no header")
      ->type_name("FRAME.bin");
  command->add_flag("--dither", options->dither,
                    "let --display and --rgb565 show the frame's 8 bits a channel in 5, 6 and 5 by ordered dither, without bands");
  add_offset_option(*command, *options);
  add_profile_option(*command, *options);
  add_transfer_option(*command, *options);
  add_depth_option(*command, *options);

  add_sampling_options(*command, options->sampling);
  command
      ->add_option("--samples-image", options->samples_path, "write how many rays each pixel took, as 16-bit greys: most is white")
      ->type_name("FILE.png");
  command
      ->add_option("--strip", options->strip_rows,
                   "render in strips of so many rows; default: the whole frame")
      ->type_name("ROWS")
      ->check(CLI::Range(1, static_cast<int>(FC_SIZE_MAX)));
  add_json_option(*command, *options);
  command->callback([&action, options] {
    action = [options] {
      if (options->layers.empty()) options->layers = {"color", "depth", "normal", "id", "samples", "shadow"};
      if (!options->path.empty() && options->frames == 0) options->frames = 36;
      if (!options->display.empty() && options->size.empty()) {
        const fc_panel &panel = find_panel(options->display);
        options->size = std::to_string(panel.width) + "x" + std::to_string(panel.height);
      }
      check(*options);
      return options->path.empty() ? run_one(*options) : run_sequence(*options);
    };
  });
}

} // namespace host
