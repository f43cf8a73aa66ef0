/* What a Linux board offers a display, as text. */
#include <cstdio>
#include <string>

#include "linux_probe.h"
#include "wire.h"

namespace host {
namespace {

struct Listing {
  std::string spi, chips;
};

std::string node_text(const fc_linux_node &node) {
  char mode[8];
  (void)std::snprintf(mode, sizeof mode, "%04o", node.mode);
  return std::string(node.path) + "  " + node.owner + ":" + node.group + " " + mode +
         (node.may_open ? "  you may open it" : "  you may not open it (only root and, as the mode says, its group)") + "\n";
}

void add_spi(void *context, const fc_linux_node *node) { static_cast<Listing *>(context)->spi += "  " + node_text(*node); }

void add_chip(void *context, const fc_linux_node *node, const char *label, unsigned lines) {
  std::string &text = static_cast<Listing *>(context)->chips;
  text += "  " + node_text(*node);
  if (label != nullptr) text += "    label '" + std::string(label) + "', " + std::to_string(lines) + " lines\n";
}

void add_line(void *context, unsigned offset, const char *name, const char *consumer, bool used, bool output) {
  char text[192];
  (void)std::snprintf(text, sizeof text, "    %3u  %-20s %s  %s%s\n", offset, name[0] != '\0' ? name : "-", output ? "out" : "in ",
                      used ? "held by " : "free", !used ? "" : consumer[0] != '\0' ? consumer
                                                                                   : "the kernel");
  static_cast<Listing *>(context)->chips += text;
}

} // namespace

std::string describe_board() {
  Listing listing;
  const fc_linux_probe_calls calls = {add_spi, add_chip, add_line};
  fc_linux_probe(&calls, &listing);
  if (listing.spi.empty()) listing.spi = "  none: switch SPI on (Raspberry Pi: dtparam=spi=on in config.txt, then boot)\n";
  if (listing.chips.empty()) listing.chips = "  none: this kernel has no GPIO driver for the board\n";
  return "SPI devices (--spi)\n" + listing.spi + "GPIO chips and lines (--dc, --reset: a line's name, or LABEL:OFFSET), libgpiod " +
         fc_linux_gpio_version() + "\n" + listing.chips;
}

} // namespace host
