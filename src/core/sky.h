/* What a kind of sky can do. */
#ifndef FC_SKY_H
#define FC_SKY_H

#include "fixcast/framebuffer.h"
#include "fixcast/render.h"

struct fc_sky_kind {
  /* Checks the data: FC_OK or an error. */
  int (*check)(const fc_sky *sky);
  /* The radiance along a camera-space direction, components below 2^30. */
  void (*radiance)(const fc_frame *frame, const fc_sky *sky, const int64_t direction[3], uint64_t radiance_q39[3]);
  /* Fills rows of a target that hold nothing yet. */
  void (*fill)(const fc_frame *frame, const fc_sky *sky, uint16_t y, uint16_t rows, const fc_target *target);
};

#endif
