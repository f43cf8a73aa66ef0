/*
 * A bounding volume hierarchy for scenes that gain from one, by the core's own builder.
 */
#ifndef FIXCAST_HOST_HIERARCHY_H
#define FIXCAST_HOST_HIERARCHY_H

#include <string>

#include "to_core.h"

namespace host {

/* Adds one to the scene by `choice`: "on", "off", or "auto", which is for lit scenes of more than 16 spheres and
 * triangles. Throws UserError. */
void add_hierarchy(CoreScene &core, const std::string &choice);

/* Its tables on a chip, in bytes. */
std::size_t hierarchy_bytes(const CoreScene &core);

} // namespace host

#endif
