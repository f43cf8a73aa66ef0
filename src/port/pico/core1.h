/* Core 1 and the words between the cores, as the chip has them. Tests bring their own. */
#ifndef FIXCAST_PORT_PICO_CORE1_H
#define FIXCAST_PORT_PICO_CORE1_H

#include <stdint.h>

/* What runs on core 1: must not return. */
typedef void fcp_core1_program(void);

/* Takes core 1 through reset, into the boot ROM's loop: also when it still runs something after a reset of core 0 alone. */
void fcp_core1_reset(void);

/* Has the ROM's loop start a program, on a stack of its own (2.5 KB). After fcp_core1_reset(). */
void fcp_core1_start(fcp_core1_program *program);

/* A word to the other core: waits for room (8 words). All that was written before is seen by who takes it. */
void fcp_core_give(uint32_t word);

/* The next word from the other core: waits for it. */
uint32_t fcp_core_take(void);

/* Drops the words that wait to be taken, and wakes the other core. */
void fcp_core_drop(void);

#endif
