/* The sky that is a gradient. */
#include "sky.h"

#include "bits.h"
#include "fixcast/error.h"
#include "layer.h"
#include "pixel.h"
#include "segment.h"
#include "shade.h"
#include "view.h"

static FC_COLD int check(const fc_sky *sky) {
  int64_t up[3];
  if (!fc_load(&sky->up, up)) return FC_ERR_COORDINATE;
  return (up[0] | up[1] | up[2]) == 0 ? FC_ERR_DIRECTION : FC_OK;
}

/* `up` in camera axes, 29 to 30 bits. */
static FC_COLD void set_up(const fc_frame *frame, const fc_sky *sky, int64_t up[3]) {
  int64_t world[3];
  (void)fc_load(&sky->up, world);
  fc_view_turn(&frame->view, world, up);
  (void)fc_shrink(up, up);
}

static FC_COLD void mix(const fc_frame *frame, const fc_sky *sky, const int64_t up[3], fc_quick up_scale, const int64_t direction[3],
                        uint64_t radiance_q39[3]) {
  const int32_t cosine_q24 = fc_quick_times(fc_quick_mul(up_scale, fc_inverse_length(direction)), fc_dot(up, direction), 24);
  const int32_t share_q24 = (INT32_C(1) << 23) + fc_floor_shift32(cosine_q24, 1);
  uint16_t low[3], high[3];
  uint8_t i;
  fc_channels(&frame->scene.background, low);
  fc_channels(&sky->top, high);
  /* 16 + 24 bits; the share may leave 0 .. 1 by a rounding */
  for (i = 0; i < 3; i++) {
    const int64_t v = (int64_t)low[i] * (INT32_C(1) << 24) + ((int64_t)high[i] - low[i]) * share_q24;
    radiance_q39[i] = v < 0 ? 0 : (uint64_t)v;
  }
}

static FC_COLD void radiance(const fc_frame *frame, const fc_sky *sky, const int64_t direction[3], uint64_t radiance_q39[3]) {
  int64_t up[3];
  set_up(frame, sky, up);
  mix(frame, sky, up, fc_inverse_length(up), direction, radiance_q39);
}

static FC_COLD void fill(const fc_frame *frame, const fc_sky *sky, uint16_t y, uint16_t rows, const fc_target *target) {
  const size_t pixel_bytes = target->format == FC_RGB888 ? 3 : 2;
  int64_t up[3];
  fc_quick up_scale;
  uint16_t px, py;
  set_up(frame, sky, up);
  up_scale = fc_inverse_length(up);
  for (py = 0; py < rows; py++) {
    uint8_t *to = (uint8_t *)target->pixels + (size_t)py * target->pitch_bytes;
    for (px = 0; px < frame->width; px++, to += pixel_bytes) {
      int64_t direction[3];
      uint64_t radiance_q39[3];
      fc_view_direction(frame, px, (uint16_t)(y + py), direction);
      mix(frame, sky, up, up_scale, direction, radiance_q39);
      fc_shade_put(frame, radiance_q39, target->format, to);
    }
  }
}

const fc_sky_kind fc_sky_gradient FC_ROM = {check, radiance, fill};
