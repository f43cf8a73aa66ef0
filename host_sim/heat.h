/* Heat maps and pictures next to one another: how differences are shown. */
#ifndef FIXCAST_HOST_HEAT_H
#define FIXCAST_HOST_HEAT_H

#include <array>
#include <cstdint>
#include <vector>

#include "image.h"

namespace host {

/* From black (0) over blue, red and yellow to white (255 and more): in steps of the logarithm, so that a difference of one level of 8 bits
 * is seen. `levels` is 0 or more; infinite and undefined values are white. */
std::array<std::uint8_t, 3> heat_colour(double levels);

Image8 heat_map(int width, int height, const std::vector<float> &levels);

/* Pictures of one height from left to right, with a grey gap between them. */
Image8 side_by_side(const std::vector<Image8> &pictures);

/* Each pixel as a square of `zoom` pixels, zoom >= 1. */
Image8 zoomed(const Image8 &image, int zoom);

} // namespace host

#endif
