/* From a linear colour to a pixel's bytes. */
#ifndef FC_PIXEL_H
#define FC_PIXEL_H

#include <stdint.h>

#include "fixcast/framebuffer.h"
#include "fixcast/scene.h"
#include "fixcast/transfer.h"

/* Greatest level of each channel. */
void fc_pixel_most(uint8_t format, uint8_t most[3]);

/* Writes one pixel of a format at `to`: levels up to fc_pixel_most. */
void fc_pixel_put(uint8_t format, const uint8_t level[3], uint8_t *to);

/* The level of a linear value in Q39: round(most value), halves up, or what the transfer function (NULL: none) makes of it; clamped. Values
 * up to 2^48. */
uint8_t fc_pixel_level(const fc_transfer *transfer, uint64_t value_q39, uint8_t most);

/* The greatest level whose threshold, times `scale` (below 2^8), is at most twice `value`. */
uint8_t fc_pixel_transfer(const fc_transfer *transfer, uint32_t value, uint8_t scale, uint8_t most);

#endif
