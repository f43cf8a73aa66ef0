/* The panels by name. */
#include "panel_list.h"

#include <cstdio>

#include "scene_file.h"

namespace host {

std::vector<std::string> panel_names() {
  std::vector<std::string> names;
  for (const fc_panel *const *panel = fc_panels; *panel != nullptr; panel++) names.emplace_back((*panel)->name);
  return names;
}

const fc_panel &find_panel(const std::string &name) {
  std::string known;
  for (const fc_panel *const *panel = fc_panels; *panel != nullptr; panel++) {
    if (name == (*panel)->name) return **panel;
    known += (known.empty() ? "" : ", ") + std::string((*panel)->name);
  }
  throw UserError("--panel " + name + ": there is no such panel; there are " + known);
}

const char *format_name(std::uint8_t format) {
  switch (format) {
    case FC_DISPLAY_RGB565: return "rgb565";
    case FC_DISPLAY_RGB444: return "rgb444";
    case FC_DISPLAY_GREY4: return "grey4";
    default: return "mono";
  }
}

std::string list_panels() {
  std::string text;
  for (const fc_panel *const *panel = fc_panels; *panel != nullptr; panel++) {
    const fc_panel &p = **panel;
    char line[160], size[16];
    (void)std::snprintf(size, sizeof size, "%ux%u", static_cast<unsigned>(p.width), static_cast<unsigned>(p.height));
    (void)std::snprintf(line, sizeof line, "%-14s %-8s %-7s pixels at %4.1f MHz at most, commands at %4.1f MHz%s\n", p.name, size,
                        format_name(p.format), p.pixel_hz / 1e6, p.init_hz / 1e6, p.format12 != nullptr ? "; --twelve-bit" : "");
    text += line;
  }
  return text;
}

} // namespace host
