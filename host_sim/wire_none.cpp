/* The board's pins in a program that was built without libgpiod: none. */
#include "scene_file.h"
#include "wire.h"

namespace host {
namespace {

[[noreturn]] void fail() {
  throw UserError(
      "this program was built without libgpiod, so it knows no board's pins; install its development files (Debian: libgpiod-dev) and "
      "build again; 'fixcast show --dry-run' works without");
}

} // namespace

std::unique_ptr<Wire> open_board(const Wiring &) { fail(); }

std::string describe_board() { fail(); }

} // namespace host
