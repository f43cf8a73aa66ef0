/* The 16-bit depth code: near / z as a small float, correctly rounded, so codes never contradict exact order. */
#ifndef FC_DEPTH_H
#define FC_DEPTH_H

#include <stdint.h>

#include "fixcast/render.h"
#include "root.h"

/* Code of a hit: 1 (far) .. 0xffff (near); worked out in *w. */
uint16_t fc_depth_code_in(fc_wide *w, const fc_frame *frame, const fc_root *root);
uint16_t fc_depth_code(const fc_frame *frame, const fc_root *root);

/* Chooses anchor and exponent bits for camera z in near .. far (grid units; near 0: may touch the eye's plane;
 * far UINT64_MAX: unbounded). */
void fc_depth_choose(fc_frame *frame, uint64_t near, uint64_t far);

#endif
