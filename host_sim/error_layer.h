/* What the oracle thinks of a frame, a pixel at a time; no_oracle.cpp stands in where there is none. */
#ifndef FIXCAST_HOST_ERROR_LAYER_H
#define FIXCAST_HOST_ERROR_LAYER_H

#include <vector>

#include "frame_run.h"
#include "scene_options.h"

namespace host {

/* The largest error of a colour channel of each pixel, 8-bit levels. Throws UserError without an oracle. */
std::vector<float> error_layer(const LoadedScene &scene, const CoreFrame &frame, const Picture &rgb888);

} // namespace host

#endif
