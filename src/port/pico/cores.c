/* See cores.h. What the chip is asked for stands in core1.h, so that a test may stand in for it. */
#include "cores.h"

#include "core1.h"
#include "fixcast/error.h"

typedef struct half {
  const fc_frame *frame;
  fc_target target;
  uint16_t y, rows;
  int error;
} half;

static fc_scratch of_core1; /* core 0 draws in the firmware's: their stacks have 2.5 KB */
static half lower;          /* core 0 writes it before the word that starts core 1, core 1 before the word that answers */

void fcp_cores_serve(void) {
  for (;;) {
    (void)fcp_core_take();
    lower.error = fc_render_rows_in(&of_core1, lower.frame, lower.y, lower.rows, &lower.target);
    fcp_core_give(1);
  }
}

void fcp_cores_start(void) {
  fcp_core1_reset();
  fcp_core1_start(fcp_cores_serve);
}

int fcp_cores_render(void *context, fc_scratch *scratch, const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target) {
  const uint16_t upper = (uint16_t)(rows - rows / 2);
  const size_t skipped = (size_t)upper * frame->width;
  int error;
  (void)context;
  if (rows < 2) return fc_render_rows_in(scratch, frame, y, rows, target);
  lower.frame = frame;
  lower.y = (uint16_t)(y + upper);
  lower.rows = (uint16_t)(rows - upper);
  lower.target = *target;
  lower.target.pixels = (uint8_t *)target->pixels + (size_t)upper * target->pitch_bytes;
  lower.target.depth = target->depth + skipped;
  if (target->primitive != NULL) lower.target.primitive = target->primitive + skipped;
  if (target->lit != NULL) lower.target.lit = target->lit + skipped;
  fcp_core_give(1);
  error = fc_render_rows_in(scratch, frame, y, upper, target);
  (void)fcp_core_take();
  return error != FC_OK ? error : lower.error;
}
