/* Wavefront materials of any bytes: refused with one clean line, or read, each under its name. (Colours may be no numbers, such as 0e991: the
 * reader of models makes 0 of them.) */
#include "obj_materials.h"
#include "scene_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t count) {
  const std::unique_ptr<char[]> text(new char[count]);
  for (std::size_t i = 0; i < count; i++) text[i] = static_cast<char>(data[i]);
  try {
    std::vector<tinyobj::material_t> materials;
    std::map<std::string, int> index;
    host::TextLines lines(std::string_view(text.get(), count), host::LineEnd::any);
    (void)host::read_materials("scene.mtl", lines, materials, index);
    for (const auto &[name, at] : index) CHECK(!name.empty() && at >= 0 && static_cast<std::size_t>(at) < materials.size());
    CHECK(index.size() <= materials.size());
  } catch (const host::UserError &error) {
    fuzz::check_message(error.what(), "scene.mtl");
  }
  return 0;
}
