/*
 * A scene as C: const tables that firmware compiles in and hands to fc_frame_setup.
 */
#ifndef FIXCAST_HOST_BAKE_H
#define FIXCAST_HOST_BAKE_H

#include <cstddef>
#include <string>

#include "to_core.h"

namespace host {

/* The scene's C name from its file name: letters, digits and '_', such as "s1" from "scenes/s1.nff". */
std::string c_name_of(const std::string &path);

/* Whether `name` may name a C object of firmware: an identifier, no keyword, not in the core's fc_ space. */
bool is_c_name(const std::string &name);

/* The C99 source that defines `const fc_scene NAME` and `const fc_camera NAME_camera`. The same scene gives
 * the same bytes on every run. `source` is named in the head comment, without its directory. */
std::string bake(const CoreScene &core, std::size_t frame_memory_bytes, const std::string &name,
                 const std::string &source);

} // namespace host

#endif
