/* From light to a display's levels. Without a transfer function levels are proportional to light. */
#ifndef FIXCAST_TRANSFER_H
#define FIXCAST_TRANSFER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* For each number of levels, 31, 63 and 255, the least light (Q24: 2^24 is white) that shows as level 1, 2, ... up to the last: ascending. A
 * level is thus exact: no table's step is seen. The tables may live in flash. */
typedef struct fc_transfer {
  const uint32_t *level31, *level63, *level255;
} fc_transfer;

extern const fc_transfer fc_transfer_srgb;    /* IEC 61966-2-1 */
extern const fc_transfer fc_transfer_gamma22; /* light = signal^2.2 */

#ifdef __cplusplus
}
#endif

#endif
