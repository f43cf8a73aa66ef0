/*
 * fixcast: an exact integer ray caster for chips without floating point.
 *
 * Conventions, once for all headers (docs/SPEC.md has the bits):
 *   axes      world right-handed; camera x right, y up, z forward; pixel (0, 0) top left, pixel centres at +0.5
 *   numbers   int32_t world coordinates with one power-of-two exponent a scene; _q30 and the like name the fraction bits
 *   colour    linear, Q1.15; output rounds to nearest, through a transfer function if asked to
 *   errors    0 or positive: success; negative: fc_error
 *   memory    the caller owns every buffer; the core keeps no state and allocates nothing
 */
#ifndef FIXCAST_H
#define FIXCAST_H

#include "fixcast/bus.h"
#include "fixcast/bvh.h"
#include "fixcast/camera.h"
#include "fixcast/config.h"
#include "fixcast/display.h"
#include "fixcast/error.h"
#include "fixcast/framebuffer.h"
#include "fixcast/material.h"
#include "fixcast/panel.h"
#include "fixcast/ray.h"
#include "fixcast/reflect.h"
#include "fixcast/render.h"
#include "fixcast/rotation.h"
#include "fixcast/sample.h"
#include "fixcast/scene.h"
#include "fixcast/transfer.h"
#include "fixcast/vec3.h"
#include "fixcast/version.h"
#include "fixcast/volume.h"

#endif
