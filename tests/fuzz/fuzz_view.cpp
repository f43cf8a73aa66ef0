/* The options for camera and lights with any text, on a small scene: refused with one clean line, or rendered. */
#include "auto_view.h"
#include "scene_check.h"

namespace {

constexpr std::string_view scene =
    "v\nfrom 0 1.5 1\nat 0 1.5 0\nup 0 1 0\nangle 53\nb 0.4 0.6 0.8\nl -3 5 -1\nf 0.8 0.2 0.2 1 0 0 0 1\ns 0 1 -6 1\np 3\n0 0 -4\n1 0 -4\n0 1 -4\n";

} // namespace

/* The input's lines are the options' values, in the order of the fields. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t count) {
  host::ViewOptions options;
  std::string *const fields[] = {&options.from, &options.at, &options.up, &options.angle, &options.look, &options.ambient, &options.background};
  std::string_view text(reinterpret_cast<const char *>(data), count);
  for (std::size_t i = 0; !text.empty(); i++) {
    const std::size_t end = text.find('\n') == std::string_view::npos ? text.size() : text.find('\n');
    const std::string line(text.substr(0, end));
    if (i < sizeof fields / sizeof fields[0]) *fields[i] = line;
    else if (!line.empty()) options.lights.push_back(line);
    text.remove_prefix(end == text.size() ? end : end + 1);
  }
  host::SceneFile file = host::read_nff_text("scene.nff", scene);
  try {
    host::apply(options, file);
    fuzz::render(host::to_core(file));
  } catch (const host::UserError &error) {
    fuzz::check_message(error.what(), "");
  }
  return 0;
}
