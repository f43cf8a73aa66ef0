/*
 * A camera and lights for scenes that name none, and those that the command line names.
 */
#ifndef FIXCAST_HOST_AUTO_VIEW_H
#define FIXCAST_HOST_AUTO_VIEW_H

#include <string>
#include <vector>

#include "scene_file.h"

namespace host {

/* As typed; empty: not given. Points and colours are three numbers with commas between them. */
struct ViewOptions {
  std::string from, at, up, angle, look, ambient, background;
  std::vector<std::string> lights; /* X,Y,Z or X,Y,Z,R,G,B */

  bool empty() const;
};

/* Puts a camera into the file that sees everything finite from direction (azimuth, elevation), degrees: azimuth 0 from
 * +z, 90 from +x, elevation 90 from
 * above; y is up. The shape fills nine tenths of the picture, in whichever direction it is larger. Throws UserError
 * when there is nothing finite. */
void frame_all(SceneFile &file, double azimuth, double elevation);

/* A light from over the camera's left shoulder, ambient light and a background, for a scene that was framed by frame_all. */
void light_up(SceneFile &file);

/* What the command line says, over what the file says. Throws UserError. */
void apply(const ViewOptions &options, SceneFile &file);

} // namespace host

#endif
