/* From a linear colour to a pixel's bytes. */
#ifndef FC_PIXEL_H
#define FC_PIXEL_H

#include <stdint.h>

#include "fixcast/framebuffer.h"
#include "fixcast/scene.h"

/* Greatest level of each channel. */
void fc_pixel_most(uint8_t format, uint8_t most[3]);

/* Writes one pixel of a format at `to`: levels up to fc_pixel_most. */
void fc_pixel_put(uint8_t format, const uint8_t level[3], uint8_t *to);

/* round(most reflectance light), halves up, clamped: reflectance Q15 up to 1.99, light Q24 up to 2^31. */
uint8_t fc_pixel_level(uint16_t reflectance_q15, uint8_t most, uint32_t light_q24);

/* The pixel where nothing is. */
void fc_pixel_background(const fc_scene *scene, uint8_t format, uint8_t *to);

#endif
