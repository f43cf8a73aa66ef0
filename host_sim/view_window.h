/* A window for the viewer. One of two sources implements it, as the build finds SDL2 or not: view_window_sdl.cpp, view_window_none.cpp. */
#ifndef FIXCAST_HOST_VIEW_WINDOW_H
#define FIXCAST_HOST_VIEW_WINDOW_H

#include <string>

#include "viewer.h"

namespace host {

struct WindowOptions {
  int zoom = 0;                        /* pixels a pixel; 0: as large as two thirds of the screen allow */
  bool spin = false;                   /* the scene turns from the start */
  bool log = false;                    /* a line on stdout for each picture */
  int frames = 0;                      /* quit after so many pictures of a turning scene; 0: when the user does */
  std::string shots = "view_%04d.png"; /* names of screenshots */
};

/* The keys and what they do, for --help and for 'h'. */
extern const char *const view_keys;

/* Runs until the window is closed. Throws UserError when there is no screen. */
int run_window(Viewer &viewer, const WindowOptions &options);

} // namespace host

#endif
