/* NFF of any bytes: refused with one clean line, or converted and rendered. */
#include <memory>
#include <string>
#include <string_view>

#include "fuzz.h"
#include "scene_file.h"
#include "to_core.h"

namespace {

constexpr std::uint16_t size = 4;
constexpr std::size_t most_shadow_tests = 4000; /* primitives times lights: what is cheap enough to render */

/* Refusals that only the frame's set-up can find: rounding made a camera degenerate, or a light is far off. */
bool may_refuse(int error) {
  return error == FC_ERR_LIGHT || error == FC_ERR_CAMERA_TARGET || error == FC_ERR_CAMERA_UP ||
         error == FC_ERR_FIELD_OF_VIEW;
}

void render(const host::CoreScene &core) {
  int error = FC_OK;
  const std::size_t bytes = fc_frame_memory(&core.scene, &error);
  CHECK(error == FC_OK); /* tables that the core refuses are the conversion's fault */
  const std::size_t primitives = core.spheres.size() + core.planes.size() + core.triangles.size();
  if (primitives * (core.lights.size() + 1) > most_shadow_tests) return;
  const fuzz::Exact<std::uint8_t> memory(bytes);
  fc_frame frame;
  error =
      fc_frame_setup(&frame, &core.scene, &core.camera, nullptr, size, size, memory.get(), memory.bytes());
  if (error != FC_OK) {
    CHECK(may_refuse(error));
    return;
  }
  const fuzz::Exact<std::uint8_t> pixels(size * size * 3);
  const fuzz::Exact<std::uint16_t> depth(size * size), primitive(size * size);
  fc_target target{};
  target.pixels = pixels.get();
  target.pitch_bytes = size * 3;
  target.format = FC_RGB888;
  target.depth = depth.get();
  target.primitive = primitive.get();
  CHECK(fc_render_rows(&frame, 0, size, &target) == FC_OK);
  for (std::size_t i = 0; i < primitive.count(); i++)
    CHECK(primitive[i] == 0xffff ? depth[i] == 0 : primitive[i] < primitives && depth[i] != 0);
}

/* "scene.nff", perhaps ":LINE", and a sentence; printable, on one line. */
void check_message(std::string_view message) {
  CHECK(message.substr(0, 9) == "scene.nff" && message.size() > 14);
  for (const char c : message) CHECK(c >= 0x20 && c < 0x7f);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t count) {
  /* a copy of its own size: the reader must not look past the end */
  const std::unique_ptr<char[]> text(new char[count]);
  for (std::size_t i = 0; i < count; i++) text[i] = static_cast<char>(data[i]);
  try {
    const host::SceneFile file = host::read_nff_text("scene.nff", std::string_view(text.get(), count));
    render(host::to_core(file));
  } catch (const host::UserError &error) {
    check_message(error.what());
  }
  return 0;
}
