/* A frame that another renderer drew, from a file. */
#include "frame_file.h"

#include <cstdio>

#include "scene_file.h"

namespace host {
namespace {

constexpr std::size_t pixel_bytes = 9;

std::vector<std::uint8_t> read_bytes(const std::string &path, std::size_t size) {
  std::FILE *file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) throw UserError(path + ": cannot open; --frame names a file that a renderer wrote");
  std::vector<std::uint8_t> bytes(size + 1); /* one more, to notice a longer file */
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
  std::fclose(file);
  return bytes;
}

} // namespace

Picture read_frame_file(const std::string &path, int width, int height) {
  Picture p;
  p.width = width;
  p.height = height;
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::vector<std::uint8_t> bytes = read_bytes(path, size * pixel_bytes);
  if (bytes.size() != size * pixel_bytes)
    throw UserError(path + ": not a frame of " + std::to_string(width) + "x" + std::to_string(height) +
                    ", nine bytes a pixel; check --size");
  p.pixels.reserve(3 * size);
  p.object.resize(size);
  p.surface.resize(size);
  p.lit.resize(size);
  for (std::size_t i = 0; i < size; i++) {
    const std::uint8_t *at = &bytes[i * pixel_bytes];
    p.object[i] = static_cast<std::uint16_t>(at[0] | at[1] << 8);
    p.surface[i] = p.object[i] != 0;
    for (unsigned k = 0; k < 4; k++) p.lit[i] |= static_cast<std::uint32_t>(at[2 + k]) << (8 * k);
    p.pixels.insert(p.pixels.end(), at + 6, at + 9);
  }
  return p;
}

} // namespace host
