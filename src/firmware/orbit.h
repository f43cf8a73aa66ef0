/* A camera that goes round a vertical axis in 60 steps, in integers: the same views on every machine. */
#ifndef FIXCAST_FIRMWARE_ORBIT_H
#define FIXCAST_FIRMWARE_ORBIT_H

#include <stdint.h>

#include "fixcast/camera.h"

#define FC_ORBIT_STEPS 60 /* of a turn: 6 degrees each */

/* `start` (read through FC_READ) with eye and target turned about the vertical line through (x, z), in the camera's coordinates, by `step` % 60
 * steps, counter-clockwise seen from above; up must be vertical. Step 0 is `start` itself. Eye and target are rounded to the nearest coordinate
 * of a rotation by sines of Q15, away from 0 when halfway. Distances from the axis are below 2^30. */
void fc_orbit(const fc_camera *start, int32_t x, int32_t z, uint16_t step, fc_camera *to);

#endif
