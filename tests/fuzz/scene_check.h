/* What the targets for scene files share: a scene that was read is converted, checked and rendered; a refusal is one clean line. */
#ifndef FIXCAST_FUZZ_SCENE_CHECK_H
#define FIXCAST_FUZZ_SCENE_CHECK_H

#include <memory>
#include <string>
#include <string_view>

#include "fuzz.h"
#include "scene_file.h"
#include "to_core.h"

namespace fuzz {

inline constexpr std::uint16_t size = 4;
inline constexpr std::size_t most_shadow_tests = 4000; /* primitives times lights: what is cheap enough to render */

/* Refusals that only the frame's set-up can find: rounding made a camera degenerate, or a light is far off. */
inline bool may_refuse(int error) {
  return error == FC_ERR_LIGHT || error == FC_ERR_CAMERA_TARGET || error == FC_ERR_CAMERA_UP ||
         error == FC_ERR_FIELD_OF_VIEW;
}

inline void render(const host::CoreScene &core) {
  int error = FC_OK;
  const std::size_t bytes = fc_frame_memory(&core.scene, &error);
  CHECK(error == FC_OK); /* tables that the core refuses are the conversion's fault */
  const std::size_t primitives = core.spheres.size() + core.planes.size() + core.triangles.size();
  if (primitives * (core.lights.size() + 1) > most_shadow_tests) return;
  const Exact<std::uint8_t> memory(bytes);
  fc_frame frame;
  error =
      fc_frame_setup(&frame, &core.scene, &core.camera, nullptr, size, size, memory.get(), memory.bytes());
  if (error != FC_OK) {
    CHECK(may_refuse(error));
    return;
  }
  const Exact<std::uint8_t> pixels(size * size * 3);
  const Exact<std::uint16_t> depth(size * size), primitive(size * size);
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

/* The file's name, perhaps ":LINE", and a sentence; printable, on one line. */
inline void check_message(std::string_view message, std::string_view file) {
  CHECK(message.substr(0, file.size()) == file && message.size() > file.size() + 5);
  for (const char c : message) CHECK(c >= 0x20 && c < 0x7f);
}

/* `read` makes a scene of a copy of the input of its own size: a reader must not look past the end. */
template <typename Read>
void check_reader(const std::uint8_t *data, std::size_t count, std::string_view file, const Read &read) {
  const std::unique_ptr<char[]> text(new char[count]);
  for (std::size_t i = 0; i < count; i++) text[i] = static_cast<char>(data[i]);
  try {
    render(host::to_core(read(std::string_view(text.get(), count))));
  } catch (const host::UserError &error) {
    check_message(error.what(), file);
  }
}

} // namespace fuzz

#endif
