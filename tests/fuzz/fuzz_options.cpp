/* The options that commands share, any words: refused with one clean line, or a scene is drawn by them. */
#include <vector>

#include "sampling.h"
#include "scene_check.h"
#include "scene_options.h"

namespace {

constexpr std::string_view scene =
    "v\nfrom 0 1.5 1\nat 0 1.5 0\nup 0 1 0\nangle 53\nb 0.4 0.6 0.8\nl -3 5 -1\nf 0.8 0.2 0.2 1 0 0 0 1\ns 0 1 -6 1\np 3\n0 0 -4\n1 0 -4\n0 1 -4\n";
constexpr std::uint64_t most_rays = 64; /* a pixel: what is cheap enough to draw */

/* With what --samples, --filter and --lens say. */
void draw(const host::LoadedScene &loaded, const host::Sampling &sampling) {
  int error = FC_OK;
  const std::size_t bytes = fc_frame_memory(&loaded.core.scene, &error);
  CHECK(error == FC_OK);
  const fuzz::Exact<std::uint8_t> memory(bytes);
  fc_frame frame;
  error = fc_frame_setup(&frame, &loaded.core.scene, &loaded.core.camera, &loaded.options, fuzz::size, fuzz::size, memory.get(), memory.bytes());
  if (error != FC_OK) {
    CHECK(fuzz::may_refuse(error));
    return;
  }
  const fuzz::Exact<std::uint8_t> pixels(fuzz::size * fuzz::size * 3);
  const fuzz::Exact<std::uint16_t> depth(fuzz::size * fuzz::size), primitive(fuzz::size * fuzz::size);
  fc_target target{};
  target.pixels = pixels.get();
  target.pitch_bytes = fuzz::size * 3;
  target.format = FC_RGB888;
  target.depth = depth.get();
  target.primitive = primitive.get();
  if (!sampling.wanted || loaded.options.profile != FC_PROFILE_EXACT) {
    CHECK(fc_render_profile(&frame, 0, 0, fuzz::size, &target) == FC_OK);
    return;
  }
  const bool square = sampling.how.pattern == &fc_pattern_regular || sampling.how.pattern == &fc_pattern_jittered;
  const std::uint64_t count = sampling.how.count;
  if ((square ? count * count : count) > most_rays || sampling.how.depth > 2) return;
  const std::size_t scratch_bytes = fc_sample_scratch(&frame, &sampling.how, &error);
  if (error == FC_ERR_LENS) return;
  CHECK(error == FC_OK);
  const fuzz::Exact<std::uint8_t> scratch(scratch_bytes);
  error = fc_sample_rows(&frame, &sampling.how, 0, fuzz::size, &target, nullptr, scratch.get(), scratch.bytes());
  CHECK(error == FC_OK);
}

} // namespace

/* The input's lines are the words behind the command. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t count) {
  std::vector<std::string> words;
  std::string word;
  for (std::size_t i = 0; i < count; i++) {
    if (data[i] == '\n') words.push_back(word), word.clear();
    else if (data[i] != 0) word += static_cast<char>(data[i]);
  }
  if (!word.empty()) words.push_back(word);
  CLI::App app{"", "fixcast"};
  host::SceneOptions options;
  host::SamplingOptions samples;
  host::add_scene_options(app, options);
  host::add_offset_option(app, options);
  host::add_profile_option(app, options);
  host::add_transfer_option(app, options);
  host::add_depth_option(app, options);
  host::add_json_option(app, options);
  host::add_sampling_options(app, samples);
  try {
    std::reverse(words.begin(), words.end()); /* as CLI11 takes them */
    app.parse(words);
    host::SceneFile file = host::read_nff_text("scene.nff", scene);
    host::apply(options.view, file);
    const host::LoadedScene loaded = host::prepare_scene(options, std::move(file));
    CHECK(loaded.width >= 1 && loaded.width <= FC_SIZE_MAX && loaded.height >= 1 && loaded.height <= FC_SIZE_MAX);
    host::Sampling sampling;
    host::set_sampling(sampling, samples, loaded.core);
    draw(loaded, sampling);
  } catch (const CLI::ParseError &) {
  } catch (const host::UserError &error) {
    CHECK(error.what()[0] != '\0');
  }
  return 0;
}
