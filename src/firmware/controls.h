/* What buttons do to the animation: which step of the orbit comes next, or the bring-up pattern. */
#ifndef FIXCAST_FIRMWARE_CONTROLS_H
#define FIXCAST_FIRMWARE_CONTROLS_H

#include <stdbool.h>
#include <stdint.h>

typedef struct fc_controls {
  uint8_t seen_released; /* FC_BUTTON_ bits: one that hangs, or is not there, does nothing */
  uint8_t held;
  uint8_t step;   /* of the orbit, 0..FC_ORBIT_STEPS - 1 */
  uint8_t stride; /* steps a frame: 1, 2, 4, 8 */
  bool reverse, paused, pattern;
} fc_controls;

void fc_controls_start(fc_controls *controls);

/* Once a frame, with the FC_BUTTON_ bits of now. A frame lasts longer than a button bounces. */
void fc_controls_buttons(fc_controls *controls, uint8_t now);

/* To the next step, unless paused. */
void fc_controls_advance(fc_controls *controls);

#endif
