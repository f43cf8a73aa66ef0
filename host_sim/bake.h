/*
 * A scene as C: const tables that firmware compiles in and hands to fc_frame_setup.
 */
#ifndef FIXCAST_HOST_BAKE_H
#define FIXCAST_HOST_BAKE_H

#include <string>

#include "scene_facts.h"
#include "to_core.h"

namespace host {

/* The scene's C name from its file name: letters, digits and '_', such as "s1" from "scenes/s1.nff". */
std::string c_name_of(const std::string &path);

/* Whether `name` may name a C object of firmware: an identifier, no keyword, not in the core's fc_ space. */
bool is_c_name(const std::string &name);

/* The C99 source that defines `const fc_scene NAME` and `const fc_camera NAME_camera`. The same scene gives
 * the same bytes on every run. The head comment says what `facts` says. */
std::string bake(const CoreScene &core, const SceneFacts &facts, const std::string &name);

/* The C99 header that declares the two; `facts` as above. */
std::string bake_header(const SceneFacts &facts, const std::string &name);

} // namespace host

#endif
