/* The keys of the view, in words. */
#include "view_window.h"

namespace host {

const char *const view_keys =
    "Mouse: drag rolls the scene, right drag moves it, the wheel brings it nearer.\n"
    "Keys: 1 color  2 depth  3 normal  4 id  5 shadow  6 error (asks the oracle)\n"
    "      + - zoom  g pixel grid  d panel  p profile  r reset\n"
    "      o shadow offset  z depth bits  t transfer (gamma)  m samples a pixel\n"
    "      space turn or pause  n one step  s screenshot  h this text  q quit\n"
    "      arrows move, page up and page down bring nearer and farther\n";

} // namespace host
