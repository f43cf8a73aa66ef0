/* From a linear colour to a pixel's bytes. */
#ifndef FC_PIXEL_H
#define FC_PIXEL_H

#include <stdint.h>

#include "fixcast/framebuffer.h"
#include "fixcast/scene.h"

/* Writes one pixel of a format at `to`. */
void fc_pixel_put(uint8_t format, const uint8_t rgb[3], uint8_t *to);

/* round(255 reflectance light), halves up, clamped to 255: reflectance Q15 up to 1.99, light Q24 up to 2^31. */
uint8_t fc_pixel_level(uint16_t reflectance_q15, uint32_t light_q24);

#endif
