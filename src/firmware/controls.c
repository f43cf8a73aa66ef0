#include "controls.h"

#include "firmware.h"
#include "orbit.h"

void fc_controls_start(fc_controls *controls) {
  const fc_controls start = {.stride = 1};
  *controls = start;
}

void fc_controls_buttons(fc_controls *controls, uint8_t now) {
  const uint8_t held = (uint8_t)(now & controls->seen_released), pressed = (uint8_t)(held & (0xffu ^ controls->held));
  controls->seen_released = (uint8_t)(controls->seen_released | (0xffu ^ now));
  controls->held = held;
  controls->pattern = (held & FC_BUTTON_PATTERN) != 0;
  if ((pressed & FC_BUTTON_PAUSE) != 0) controls->paused = !controls->paused;
  if ((pressed & FC_BUTTON_REVERSE) != 0) controls->reverse = !controls->reverse;
  if ((pressed & FC_BUTTON_FASTER) != 0 && controls->stride < 8) controls->stride = (uint8_t)(controls->stride * 2u);
  if ((pressed & FC_BUTTON_SLOWER) != 0 && controls->stride > 1) controls->stride = (uint8_t)(controls->stride / 2u);
}

void fc_controls_advance(fc_controls *controls) {
  const uint8_t by = controls->reverse ? (uint8_t)(FC_ORBIT_STEPS - controls->stride) : controls->stride;
  if (!controls->paused) controls->step = (uint8_t)((controls->step + by) % FC_ORBIT_STEPS);
}
