/* The smallest tables that say exactly the same. */
#include "narrow.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

namespace host {
namespace {

constexpr std::uint8_t most_shift = 15;

/* The level as 5 or 6 bits, when the core makes the same level of them. */
std::optional<unsigned> exact_bits(unsigned level, unsigned most) {
  const unsigned bits = (level * most + 127) / 255;
  if ((bits * 255 + most / 2) / most != level) return std::nullopt;
  return bits;
}

std::vector<std::uint16_t> as_rgb565(const std::vector<std::uint8_t> &rgb) {
  std::vector<std::uint16_t> packed;
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    const std::optional<unsigned> r = exact_bits(rgb[i], 31), g = exact_bits(rgb[i + 1], 63), b = exact_bits(rgb[i + 2], 31);
    if (!r || !g || !b) return {};
    packed.push_back(static_cast<std::uint16_t>(*r << 11 | *g << 5 | *b));
  }
  return packed;
}

std::vector<std::uint8_t> as_grey(const std::vector<std::uint8_t> &rgb) {
  std::vector<std::uint8_t> grey;
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    if (rgb[i] != rgb[i + 1] || rgb[i] != rgb[i + 2]) return {};
    grey.push_back(rgb[i]);
  }
  return grey;
}

/* Nothing when there are more than 256 colours. */
std::optional<NarrowTexels> as_palette(const std::vector<std::uint8_t> &rgb) {
  std::map<std::array<std::uint8_t, 3>, std::uint8_t> known;
  NarrowTexels out;
  out.format = NarrowTexels::Format::palette;
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    const std::array<std::uint8_t, 3> colour = {rgb[i], rgb[i + 1], rgb[i + 2]};
    auto found = known.find(colour);
    if (found == known.end()) {
      if (known.size() == 256) return std::nullopt;
      found = known.insert({colour, static_cast<std::uint8_t>(known.size())}).first;
      out.colours.insert(out.colours.end(), colour.begin(), colour.end());
    }
    out.bytes.push_back(found->second);
  }
  return out;
}

} // namespace

std::optional<std::uint8_t> short_vertex_shift(const CoreScene &core) {
  std::uint32_t all = 0;
  for (const fc_vec3 &v : core.vertices)
    for (const std::int32_t c : {v.x, v.y, v.z}) all |= static_cast<std::uint32_t>(std::abs(c));
  if (core.vertices.empty()) return std::nullopt;
  for (const TriangleTable &table : core.triangle_tables)
    if (table.cull > 1) return std::nullopt; /* convex: its shadows' speed is worth more than half the vertices' flash */
  std::uint8_t shift = 0;
  while (shift < most_shift && (all >> shift & 1) == 0) shift++;
  if (all >> shift > INT16_MAX) return std::nullopt;
  return shift;
}

NarrowTexels narrow_texels(const CoreLayers &layers) {
  NarrowTexels least;
  least.bytes = layers.texels;
  const auto take = [&least](NarrowTexels other) {
    if (other.size() > 0 && other.size() < least.size()) least = std::move(other);
  };
  take({NarrowTexels::Format::rgb565, {}, as_rgb565(layers.texels), {}});
  take({NarrowTexels::Format::grey8, as_grey(layers.texels), {}, {}});
  if (std::optional<NarrowTexels> palette = as_palette(layers.texels)) take(std::move(*palette));
  return least;
}

} // namespace host
