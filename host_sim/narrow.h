/*
 * The smallest tables that say exactly the same: what `fixcast bake` writes instead of the tables that the simulator renders from.
 */
#ifndef FIXCAST_HOST_NARROW_H
#define FIXCAST_HOST_NARROW_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "to_core.h"

namespace host {

/* The shift with which 16 bits a coordinate hold every vertex of the scene (fc_short_vec3); nothing when they do not, or there are no triangles.
 * One wide mesh makes all wide, as readers for both would take more flash than they save. */
std::optional<std::uint8_t> short_vertex_shift(const CoreScene &core);

/* An image's texels in the format with the fewest bytes. */
struct NarrowTexels {
  enum class Format {
    rgb888,
    rgb565,
    grey8,
    palette
  };
  Format format = Format::rgb888;
  std::vector<std::uint8_t> bytes;   /* of all formats but rgb565 */
  std::vector<std::uint16_t> packed; /* of rgb565 */
  std::vector<std::uint8_t> colours; /* of a palette, three bytes each, in the order of their first use */
  std::size_t size() const { return bytes.size() + 2 * packed.size() + colours.size(); }
};
NarrowTexels narrow_texels(const CoreLayers &layers);

} // namespace host

#endif
