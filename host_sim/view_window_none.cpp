/* No window: built without SDL2. */
#include "view_window.h"

namespace host {

int run_window(Viewer &, const WindowOptions &) {
  throw UserError("built without SDL2, so there is no window; install it and build again, or use render");
}

} // namespace host
