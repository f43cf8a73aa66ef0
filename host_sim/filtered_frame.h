/* A frame whose pixels are made by a kernel that reaches beyond them. */
#ifndef FIXCAST_HOST_FILTERED_FRAME_H
#define FIXCAST_HOST_FILTERED_FRAME_H

#include "frame_run.h"

namespace host {

/* Draws `sampling.side` x `sampling.side` rays a pixel, each by the core as a pixel of a larger frame, and replaces the colours of `pictures`, the same frame without
 * filter, by what sampling.kernel makes of them. The core gives 8 bits of a sample, in the display's transfer function, so a pixel is within
 * the kernel's absolute integral (1 for gaussian, 1.14 for mitchell) + 1/2 levels of what exact samples would give, and much nearer where they differ among themselves.
 * Throws UserError when the larger frame would be more than the core's largest. */
void filter_frame(Pictures &pictures, const CoreScene &core, const fc_options &options, const Sampling &sampling, bool quiet);

} // namespace host

#endif
