/* Starting core 1, and words between the cores. */
#ifndef FIXCAST_PORT_PICO_CORE1_H
#define FIXCAST_PORT_PICO_CORE1_H

#include <stdint.h>

/* Takes core 1 through reset and has the boot ROM start `entry` there, on a stack of its own; `entry` must not return. */
void fcp_core1_launch(void (*entry)(void));

/* A word to the other core: waits for room (8 words). All that was written before is seen by who takes it. */
void fcp_core_give(uint32_t word);

/* The next word from the other core: waits for it. */
uint32_t fcp_core_take(void);

#endif
