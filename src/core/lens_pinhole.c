/* The frame's own camera as a lens. */
#include "bits.h"
#include "fixcast/error.h"
#include "sample.h"

static int prepare(fc_lens_state *state, fc_frame *frame, const void *data) {
  (void)state;
  (void)frame;
  (void)data;
  return FC_OK;
}

static FC_COLD bool ray(const fc_lens_state *state, const fc_frame *frame, const int32_t place_q16[2], int64_t origin[3],
                        int64_t direction[3]) {
  int64_t offset[2];
  uint8_t i;
  (void)state;
  fc_lens_offset(frame, place_q16, offset);
  /* Half pixels times 2^pixel_shift are below 2^29, with a tent's reach below 2^30; 16 bits more on the way. Centres are whole. */
  for (i = 0; i < 2; i++)
    direction[i] = fc_floor_shift64(offset[i] * (INT64_C(1) << frame->view.pixel_shift) + FC_PLACE_HALF, 16);
  direction[2] = frame->view.focal;
  origin[0] = origin[1] = origin[2] = 0;
  return true;
}

const fc_lens_kind fc_lens_pinhole FC_ROM = {prepare, ray};
