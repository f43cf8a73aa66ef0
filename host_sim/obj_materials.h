/* Wavefront materials (MTL) by tinyobjloader: their names and diffuse colours. */
#ifndef FIXCAST_HOST_OBJ_MATERIALS_H
#define FIXCAST_HOST_OBJ_MATERIALS_H

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <map>
#include <string>
#include <vector>

#include "text_lines.h"

namespace host {

/* Adds the file's materials, and their places by name; whether any has a texture, which is not read. tinyobjloader sees newmtl and Kd alone. Throws
 * UserError "PATH:LINE: what is wrong; what to do". */
bool read_materials(const std::string &path, TextLines &lines, std::vector<tinyobj::material_t> &materials, std::map<std::string, int> &index);

} // namespace host

#endif
