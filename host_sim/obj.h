/* Wavefront OBJ models as scenes without a camera and without lights. */
#ifndef FIXCAST_HOST_OBJ_H
#define FIXCAST_HOST_OBJ_H

#include <string>
#include <string_view>

#include "scene_file.h"

namespace host {

/* Faces of any number of corners, concave ones too; each o or g is an object, counted from 1. Kd is the colour, 0.8
 * where there is no material. Normals are
 * kept. Throws UserError "FILE: what is wrong; what to do", with the line or the number of the face. */
SceneFile read_obj(const std::string &path);

/* The same from memory; materials are looked for in that directory, nowhere if it is "". */
SceneFile read_obj_text(const std::string &name, std::string_view text, const std::string &material_directory);

} // namespace host

#endif
