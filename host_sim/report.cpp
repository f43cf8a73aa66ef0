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

std::string count_text(std::size_t count, const std::string &noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string frame_summary(const LoadedScene &scene, const FrameCounts &counts) {
  const CoreScene &core = scene.core;
  std::size_t objects = 0, surface = 0;
  for (const auto &[id, pixels] : counts.pixels_by_id) {
    if (id != 0) objects++, surface += pixels;
  }
  return scene.file.path + ": " + count_text(core.spheres.size(), "sphere") + ", " +
         count_text(core.planes.size(), "plane") + ", " + count_text(core.triangles.size(), "triangle") +
         ", " + count_text(core.lights.size(), "light") + "\n" + std::to_string(scene.width) + "x" +
         std::to_string(scene.height) + ", CRC-32 " + hex_text(counts.crc32) + ", " +
         count_text(objects, "object") + " in " + count_text(surface, "pixel") + ", " +
         std::to_string(counts.unlit_pixels) + " of them unlit\n";
}

} // namespace host
