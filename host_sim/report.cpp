/* The words and the JSON by which commands report a frame. */
#include "report.h"

#include <cstdio>

namespace host {

std::string number_text(double value) {
  char text[40];
  (void)std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string hex_text(std::uint32_t value) {
  char text[16];
  (void)std::snprintf(text, sizeof text, "0x%08lx", static_cast<unsigned long>(value));
  return text;
}

std::string frame_json(const LoadedScene &scene, const FrameCounts &counts) {
  std::string ids;
  for (const auto &[id, pixels] : counts.pixels_by_id)
    ids += (ids.empty() ? "\"" : ", \"") + std::to_string(id) + "\": " + std::to_string(pixels);
  return "\"width\": " + std::to_string(scene.width) + ", \"height\": " + std::to_string(scene.height) +
         ", \"crc32\": \"" + hex_text(counts.crc32) + "\", \"pixels_by_id\": {" + ids +
         "}, \"unlit_pixels\": " + std::to_string(counts.unlit_pixels);
}

std::string frame_summary(const LoadedScene &scene, const FrameCounts &counts) {
  const CoreScene &core = scene.core;
  std::string text = scene.file.path + ": " + std::to_string(core.spheres.size()) + " spheres, " +
                     std::to_string(core.planes.size()) + " planes, " +
                     std::to_string(core.triangles.size()) + " triangles, " +
                     std::to_string(core.lights.size()) + " lights\n";
  text +=
      std::to_string(scene.width) + "x" + std::to_string(scene.height) + ", CRC-32 " + hex_text(counts.crc32);
  std::size_t objects = 0, surface = 0;
  for (const auto &[id, pixels] : counts.pixels_by_id) {
    if (id != 0) objects++, surface += pixels;
  }
  text += ", " + std::to_string(objects) + " objects in " + std::to_string(surface) + " pixels, " +
          std::to_string(counts.unlit_pixels) + " of them unlit\n";
  return text;
}

} // namespace host
