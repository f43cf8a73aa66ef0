/* Which lights reach a surface point, and what colour it has. */
#ifndef FC_SHADE_H
#define FC_SHADE_H

#include <stdbool.h>
#include <stdint.h>

#include "fixcast/render.h"
#include "space.h"

/* Whether a light at a camera-space position reaches a completed surface. */
bool fc_light_reaches(const fc_frame *frame, const fc_space *space, const fc_surface *surface, const int64_t position[3]);

/* Shades a completed surface: its colour in levels up to most[] a channel, and the mask of lights that reach it (bit 31 stands for light 31 and
 * all after it). */
void fc_shade(const fc_frame *frame, const fc_space *space, const fc_surface *surface, const uint8_t most[3],
              uint8_t level[3], uint32_t *lit);

/* A surface's rounded point moved by an offset rule; epsilon in the space's units. */
void fc_surface_offset(const fc_surface *surface, int rule, int64_t epsilon, int64_t point[3]);

#endif
