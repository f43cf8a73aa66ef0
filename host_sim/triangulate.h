/*
 * Polygons into triangles: the one triangulation that every part of the host uses.
 *
 * The polygon is seen along the largest component of its (Newell) normal and ears are clipped, the
 * best-shaped one first (the largest area / longest edge^2 in steps of 1/65536; of equals the one whose tip
 * has the lowest index). The vertices are snapped to 2^-54 of the polygon's size first; every decision after
 * that is exact in integers.
 *
 * What holds for every polygon that does not cross itself, convex or concave:
 *  - n - 2 triangles, each with the polygon's winding, that cover it once and nothing else;
 *  - every edge of the polygon is an edge of exactly one triangle and no vertex lies inside another
 *    triangle's edge, so neighbours that share vertices stay watertight. A vertex in the middle of a straight
 *    side is therefore joined to the far side rather than cut off as a triangle without area;
 *  - a vertex repeated in a row gives one triangle without area.
 * A polygon that crosses itself, or has no area, gives n - 2 triangles too: ears as long as there are any,
 * then a fan from the lowest index left.
 */
#ifndef FIXCAST_HOST_TRIANGULATE_H
#define FIXCAST_HOST_TRIANGULATE_H

#include <array>
#include <vector>

#include "scene_file.h"

namespace host {

/* Indices into polygon.vertices, which has three or more entries. */
std::vector<std::array<int, 3>> triangulate(const Polygon &polygon);

} // namespace host

#endif
