// A C++ program that draws S1 and looks at what the headers give it; prints the scene's golden line.
#include <cstdint>
#include <cstdio>
#include <vector>

#include "fixcast/fixcast.h"
#include "fixcast/volume_extra.h"

extern "C" {
extern const fc_scene s1;
extern const fc_camera s1_camera;
}

static const fc_material matte[] = {FC_MATTE(FC_RGB8(255, 0, 0))}; // the macros of scenes, in C++

int main() {
  const std::uint16_t width = 128, height = 128;
  int error = FC_OK;
  std::vector<std::int64_t> memory(fc_frame_memory(&s1, &error) / sizeof(std::int64_t) + 1);
  std::vector<std::uint8_t> pixels(2 * width * height);
  std::vector<std::uint16_t> depth(width * height);
  fc_frame frame;
  fc_target target = fc_target();
  target.pixels = pixels.data();
  target.pitch_bytes = 2 * width;
  target.format = FC_RGB565_BE;
  target.depth = depth.data();
  if (error == FC_OK)
    error = fc_frame_setup(&frame, &s1, &s1_camera, nullptr, width, height, memory.data(),
                           memory.size() * sizeof memory[0]);
  if (error == FC_OK) error = fc_render_rows(&frame, 0, height, &target);
  if (error != FC_OK || fc_scene_check(&s1) != FC_OK) {
    std::printf("%s\n", fc_error_text(error));
    return 1;
  }
  std::uint32_t crc = 0xffffffffu;
  for (std::uint8_t byte : pixels) {
    crc ^= byte;
    for (int bit = 0; bit < 8; bit++) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
  }
  std::printf("s1 128x128 0x%08lx\n", static_cast<unsigned long>(crc ^ 0xffffffffu));
  return fc_cos_q30(0) == INT32_C(1) << 30 && matte[0].diffuse.r > 0 ? 0 : 1;
}
