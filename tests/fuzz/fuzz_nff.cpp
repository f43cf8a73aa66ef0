/* NFF of any bytes: refused with one clean line, or converted and rendered. */
#include "scene_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t count) {
  fuzz::check_reader(data, count, "scene.nff", [](std::string_view text) { return host::read_nff_text("scene.nff", text); });
  return 0;
}
