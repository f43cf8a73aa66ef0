/*
 * All that is known of a frame's pixels, as named channels, and as pictures for people.
 *
 * R G B: colour as shown, 0..1. A: 1 on a surface, 0 on background. Z: distance along the viewing axis, world units, infinity on
 * background. N.X N.Y N.Z: unit normal towards the eye, world axes, 0 on background. id: the object. samples: camera rays
 * a pixel (1; 1/4 in the half profile; as many as --samples took).
 * shadow: the part of the lights, of the first 32, that does not reach the surface, 0..1; 0 on background.
 * error: largest difference of a colour channel to the exact colour, in 8-bit levels; only where the oracle was asked.
 */
#ifndef FIXCAST_HOST_FRAME_LAYERS_H
#define FIXCAST_HOST_FRAME_LAYERS_H

#include <string>
#include <vector>

#include "frame_run.h"
#include "image.h"
#include "raster.h"

namespace host {

/* Groups of channels by the names that the command line takes: "color", "depth", "normal", "id", "samples", "shadow", "error". */
const std::vector<std::string> &layer_names();

/* The channels of the wanted layers (names as above), in the order above. `picture` is the frame as FC_RGB888. `error` holds a value a pixel; it
 * is only looked at when "error" is wanted. */
Raster frame_layers(const CoreFrame &frame, const CoreScene &core, const Picture &picture, const std::vector<float> &error,
                    const std::vector<std::string> &wanted);

/* One layer in colours: color as it is; depth near bright, far dark (by rank between the nearest and the farthest); normal as
 * 128 + 127 N; id in colours that tell neighbours apart; samples and shadow as greys; error as a heat map (heat.h). The raster must hold
 * the layer's channels. */
Image8 layer_picture(const Raster &raster, const std::string &layer);

} // namespace host

#endif
