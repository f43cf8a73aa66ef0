/* The pinhole camera: an eye, a point it looks at, an up direction and a field of view. */
#ifndef FIXCAST_CAMERA_H
#define FIXCAST_CAMERA_H

#include <stdint.h>

#include "fixcast/vec3.h"

/* Which edges of the picture the field of view goes to. */
typedef enum fc_fov_rule {
  FC_FOV_EDGES = 0,  /* the angle runs between the outer edges of the outer pixels (default) */
  FC_FOV_CENTRES = 1 /* ... between the centres of the outer pixels (NFF) */
} fc_fov_rule;

/*
 * The picture looks from `eye` towards `target`; its right is (target - eye) x up. Pixel (x, y) of a W x H
 * picture, (0, 0) at the top left, looks through its centre: along
 *   ((2x+1-W) right + (H-2y-1) up') tan / S + forward,   S = min(W, H)   (FC_FOV_EDGES; S - 1, at least 1, with FC_FOV_CENTRES)
 * so the field of view spans the shorter side and pixels are square. Read through FC_READ: may live in flash.
 */
typedef struct fc_camera {
  fc_vec3 eye, target;               /* times 2^exponent, in world coordinates */
  fc_vec3 up;                        /* any length but 0, not parallel to the view */
  int8_t exponent;                   /* -31..31; 0: eye and target are plain world coordinates */
  uint8_t fov_rule;                  /* fc_fov_rule */
  uint32_t tan_half_fov_numerator;   /* tan(half the field of view) = numerator / denominator, */
  uint32_t tan_half_fov_denominator; /* between 2^-16 and 2^16 */
} fc_camera;

#endif
