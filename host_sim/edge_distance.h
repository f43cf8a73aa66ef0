/*
 * How far a wrong pixel is from being right: the distance from its centre to the true edge.
 */
#ifndef FIXCAST_HOST_EDGE_DISTANCE_H
#define FIXCAST_HOST_EDGE_DISTANCE_H

#include <cstddef>

#include "compare.h"
#include "oracle.h"

namespace host {

constexpr double edge_distance_min_px = 1e-9, edge_distance_max_px = 1.5;

/* In pixels, to three digits: the smallest radius at which, in one of 32 directions, the oracle gives the
 * core's answer. edge_distance_min_px: that or less. Infinity: none up to edge_distance_max_px. */
double edge_distance_px(const Oracle &oracle, const WrongPixel &pixel, std::size_t lights);

} // namespace host

#endif
