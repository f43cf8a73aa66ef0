/*
 * Which objects are closed meshes whose back faces no eye outside can see, so that the core may leave them out.
 *
 * An object counts as one when each edge belongs to exactly two of its triangles, which run along it in opposite directions;
 * each connected part encloses a positive volume (counter-clockwise seen from outside); no edge meets a triangle
 * that it shares no corner with; and the eye is outside the box around it. All on the core's integers.
 *
 * It is convex when it has one part and each corner lies below each face that it is no corner of, by the margin of fc_shapes.cull.
 */
#ifndef FIXCAST_HOST_CLOSED_MESH_H
#define FIXCAST_HOST_CLOSED_MESH_H

#include <array>
#include <cstdint>
#include <vector>

#include "fixcast/fixcast.h"

namespace host {

/* For each triangle, what fc_shapes.cull may be for its object. `eye` in world coordinates. */
std::vector<std::uint8_t> cull_values(const std::vector<fc_vec3> &vertices, const std::vector<fc_triangle> &triangles,
                                      const std::array<long double, 3> &eye);

} // namespace host

#endif
