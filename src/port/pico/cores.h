/*
 * The second core: draws the lower half of a strip's rows while core 0 draws the upper half.
 *
 * Both read the same frame and write different rows of the same target, so there is no lock; words through the
 * FIFOs between the cores start and end each half. Core 1 takes no interrupts: the display's bus is core 0's alone. An option of the build
 * (main.c): 5 KB more RAM for the second stack and what core 1 draws in.
 */
#ifndef FIXCAST_PORT_PICO_CORES_H
#define FIXCAST_PORT_PICO_CORES_H

#include "fixcast/render.h"

/* Starts core 1, which waits in the boot ROM after any reset. Once, on core 0. */
void fcp_cores_start(void);

/* As fc_render_rows, on both cores; returns when both are done: the error of the upper half, else that of the lower one. Core 0 only.
 * `scratch` is core 0's, `context` is not used: this is fc_firmware_board.render. */
int fcp_cores_render(void *context, fc_scratch *scratch, const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target);

/* What core 1 does: for ever. */
void fcp_cores_serve(void);

#endif
