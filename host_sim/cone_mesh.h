/*
 * NFF's cones and cylinders as triangles: the core has no such surface.
 *
 * Each ring is a regular polygon of N corners on the true circle, so that no point of the mesh is farther from the true surface than
 * (1 - cos(pi / N)) times the larger radius. N is the smallest of 3..1024 with which that is at most `relative_error`. The ends are open,
 * as NFF says.
 */
#ifndef FIXCAST_HOST_CONE_MESH_H
#define FIXCAST_HOST_CONE_MESH_H

#include <vector>

#include "scene_file.h"

namespace host {

inline constexpr long double default_cone_error = 0.005L; /* 32 corners */

/* A truncated cone: two ends on an axis, and the radius at each, 0 or more, not both 0; the ends differ. */
struct Cone {
  Vector base, apex;
  Number base_radius, apex_radius;
};

int cone_corners(long double relative_error);

/* Triangles with three vertices each, in the material, object and line of `pattern`. Coordinates have twelve digits,
 * which the core, the oracle and a baked
 * scene all take as they are. */
std::vector<Polygon> cone_mesh(const Cone &cone, long double relative_error, const Polygon &pattern);

} // namespace host

#endif
