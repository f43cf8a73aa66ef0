/* Which lights reach a surface point, and what colour it has. */
#ifndef FC_SHADE_H
#define FC_SHADE_H

#include <stdbool.h>
#include <stdint.h>

#include "fixcast/render.h"
#include "space.h"

/* Whether a light at a camera-space position reaches a completed surface. */
bool fc_light_reaches(const fc_frame *frame, const fc_space *space, const fc_surface *surface, const int64_t position[3]);

/* Radiance is cut to this: no format shows more than 2^39. */
#define FC_RADIANCE_MAX (UINT64_C(1) << 48)

/* Shades a completed surface: its linear radiance, Q39 a channel, and the mask of lights that reach it (bit 31 stands for light 31 and all after
 * it). */
void fc_shade(const fc_frame *frame, const fc_space *space, const fc_surface *surface, uint64_t radiance_q39[3], uint32_t *lit);

/* What a ray sees that meets nothing: a camera-space direction, components below 2^30. */
void fc_shade_background(const fc_frame *frame, const int64_t direction[3], uint64_t radiance_q39[3]);

/* A pixel of radiance. */
void fc_shade_put(const fc_frame *frame, const uint64_t radiance_q39[3], uint8_t format, uint8_t *to);

/* A surface's rounded point moved by an offset rule; epsilon in the space's units. */
void fc_surface_offset(const fc_surface *surface, int rule, int64_t epsilon, int64_t point[3]);

#endif
