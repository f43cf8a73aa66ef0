/*
 * Animated GIF (GIF89a): frames with a palette each, endless loop. The same frames give the same bytes on every run.
 */
#ifndef FIXCAST_HOST_GIF_H
#define FIXCAST_HOST_GIF_H

#include <string>
#include <vector>

#include "image.h"

namespace host {

/* The bytes of a GIF file. Frames are of one size, at least one. A frame of at most 256 colours is kept exactly; of more, each colour becomes
 * the mean of its box in a median cut. `centiseconds`: how long a frame is shown, 1..65535. The metadata goes into a comment. */
std::string encode_gif(const std::vector<Image8> &frames, int centiseconds, const Metadata &metadata);

} // namespace host

#endif
