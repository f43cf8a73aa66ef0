/* The words for patterns, filters and lenses. */
#include "sampling.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "scene_file.h"

namespace host {
namespace {

/* A word, and the numbers behind its colons. */
struct Choice {
  std::string name;
  std::vector<int> numbers; /* plain decimal integers of up to 6 digits, -1 for what is not one */

  bool none() const {
    return numbers.empty();
  }

  /* The only one, 0 when there is none or more. */
  int number() const {
    return numbers.size() == 1 ? numbers[0] : 0;
  }
};

Choice split(const std::string &text) {
  Choice choice;
  std::size_t colon = text.find(':');
  choice.name = text.substr(0, colon);
  while (colon != std::string::npos) {
    const std::size_t next = text.find(':', colon + 1);
    const std::string digits = text.substr(colon + 1, next == std::string::npos ? next : next - colon - 1);
    const bool plain = !digits.empty() && digits.size() <= 6 && digits.find_first_not_of("0123456789") == std::string::npos;
    choice.numbers.push_back(plain ? std::stoi(digits) : -1);
    colon = next;
  }
  return choice;
}

[[noreturn]] void refuse_samples(const std::string &text) {
  throw UserError("--samples " + text +
                  " is not a pattern; give one, regular:N (N x N cells, 1 to 64), random:N (1 to 4096), "
                  "jitter:N (a square: 1, 4, 9 .. 4096) or quincunx[:DEPTH[:LEVELS]] (0 to 5; 0 to 255)");
}

void set_pattern(fc_sampling &how, const std::string &text) {
  const Choice choice = split(text);
  const int number = choice.number();
  if (choice.name == "one" && choice.none()) {
    how.pattern = &fc_pattern_one;
  } else if (choice.name == "regular" && number >= 1 && number <= FC_SAMPLE_SIDE_MAX) {
    how.pattern = &fc_pattern_regular;
    how.count = static_cast<std::uint16_t>(number);
  } else if (choice.name == "random" && number >= 1 && number <= FC_SAMPLE_COUNT_MAX) {
    how.pattern = &fc_pattern_random;
    how.count = static_cast<std::uint16_t>(number);
  } else if (choice.name == "jitter" && number >= 1) {
    int side = 1;
    while (side * side < number) side++;
    if (side * side != number || side > FC_SAMPLE_SIDE_MAX) refuse_samples(text);
    how.pattern = &fc_pattern_jittered;
    how.count = static_cast<std::uint16_t>(side);
  } else if (choice.name == "quincunx" && choice.numbers.size() <= 2) {
    const int depth = choice.none() ? 3 : choice.numbers[0], levels = choice.numbers.size() < 2 ? 6 : choice.numbers[1];
    if (depth < 0 || depth > FC_QUINCUNX_DEPTH_MAX || levels < 0 || levels > 255) refuse_samples(text);
    how.pattern = &fc_pattern_quincunx;
    how.depth = static_cast<std::uint8_t>(depth);
    how.threshold_q15 = FC_CHANNEL8(levels);
  } else {
    refuse_samples(text);
  }
}

/* A size in world units as the core's span; nothing when it is not one. */
std::optional<fc_orthographic> span_of(const std::string &text, const fc_scene &scene) {
  double size = 0;
  const char *end = text.data() + text.size();
  const auto [rest, problem] = std::from_chars(text.data(), end, size, std::chars_format::fixed);
  if (problem != std::errc() || rest != end || !(size > 0)) return std::nullopt;
  int exponent = 0;
  const long double fraction = std::frexp(size / world_unit(scene), &exponent);
  exponent -= 29;
  if (exponent < -31 || exponent > 32) return std::nullopt;
  fc_orthographic lens{};
  lens.span = static_cast<std::int32_t>(std::lround(std::ldexp(fraction, 29)));
  lens.span_exponent = static_cast<std::int8_t>(exponent);
  return lens;
}

void set_lens(Sampling &sampling, const std::string &text, const CoreScene &core) {
  const Choice choice = split(text);
  fc_lens &lens = sampling.how.lens;
  const std::string stated = text.substr(std::min(text.size(), choice.name.size() + 1));
  if (choice.name == "pinhole" && choice.none()) {
    lens = {&fc_lens_pinhole, nullptr};
  } else if (choice.name == "orthographic" && choice.none()) {
    const int error = fc_orthographic_of_camera(&sampling.orthographic, &core.camera);
    if (error < 0) throw UserError(std::string("--lens orthographic: ") + fc_error_text(error));
    lens = {&fc_lens_orthographic, &sampling.orthographic};
  } else if (const auto span = span_of(stated, core.scene); choice.name == "orthographic" && span) {
    sampling.orthographic = *span;
    lens = {&fc_lens_orthographic, &sampling.orthographic};
  } else if (choice.name == "fisheye" && (choice.none() || (choice.number() >= 1 && choice.number() <= 360))) {
    const std::uint32_t degrees = choice.none() ? 180u : static_cast<std::uint32_t>(choice.number());
    sampling.fisheye.angle_q16 = (degrees * 65536u + 180u) / 360u;
    lens = {&fc_lens_fisheye, &sampling.fisheye};
  } else if (choice.name == "panorama" && choice.none()) {
    lens = {&fc_lens_panorama, nullptr};
  } else {
    throw UserError("--lens " + text +
                    " is not a lens; give pinhole, orthographic[:SIZE] (world units, such as 2.5), "
                    "fisheye[:DEGREES] (1 to 360) or panorama");
  }
}

} // namespace

void add_sampling_options(CLI::App &command, SamplingOptions &options) {
  command
      .add_option("--samples", options.samples,
                  "rays a pixel: one, regular:N (N x N), random:N, jitter:N (N a square) or quincunx[:DEPTH[:LEVELS]] "
                  "(adaptive: halved up to DEPTH times, default 3, where objects differ or a channel by more than LEVELS of 255, default 6)")
      ->type_name("PATTERN");
  command
      .add_option("--filter", options.filter,
                  "how they become a pixel: box (default) or tent; gaussian or mitchell with regular:N, in the simulator only")
      ->type_name("FILTER");
  command
      .add_option("--lens", options.lens,
                  "pinhole (default), orthographic[:SIZE] (world units across the shorter side; default: as the pinhole frames what it "
                  "looks at), fisheye[:DEGREES] (default 180) or "
                  "panorama (360 x 180 degrees)")
      ->type_name("LENS");
  command.add_option("--seed", options.seed, "of random and jitter: another seed, other places; default: 0")->type_name("N");
}

void set_sampling(Sampling &sampling, const SamplingOptions &options, const CoreScene &core) {
  sampling.wanted = !options.samples.empty() || !options.filter.empty() || !options.lens.empty();
  if (!options.samples.empty()) set_pattern(sampling.how, options.samples);
  if (!options.lens.empty()) set_lens(sampling, options.lens, core);
  sampling.how.seed = options.seed;
  if (options.filter == "tent")
    sampling.how.filter = FC_FILTER_TENT;
  else if (options.filter == "gaussian" || options.filter == "mitchell")
    sampling.kernel = options.filter == "gaussian" ? Kernel::gaussian : Kernel::mitchell;
  else if (!options.filter.empty() && options.filter != "box")
    throw UserError("--filter takes box, tent, gaussian or mitchell, not \"" + options.filter + "\"");
  if (sampling.kernel && sampling.how.pattern != &fc_pattern_regular)
    throw UserError("--filter " + options.filter + " weighs a regular grid of rays; add --samples regular:N");
  if (sampling.how.pattern == &fc_pattern_quincunx && sampling.how.filter != FC_FILTER_BOX)
    throw UserError("--filter tent: quincunx weighs its rays by area, which is the box; choose another pattern");
}

} // namespace host
