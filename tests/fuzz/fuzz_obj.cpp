/* Wavefront OBJ of any bytes: refused with one clean line, or framed, lit, converted and rendered. */
#include "auto_view.h"
#include "obj.h"
#include "scene_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t count) {
  fuzz::check_reader(data, count, "scene.obj", [](std::string_view text) {
    host::SceneFile file = host::read_obj_text("scene.obj", text, "");
    host::frame_all(file, 30, 20);
    host::light_up(file);
    return file;
  });
  return 0;
}
