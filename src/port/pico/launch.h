/* How the boot ROM's loop on core 1 is told what to run (RP2040 data sheet 2.8.2). */
#ifndef FIXCAST_PORT_PICO_LAUNCH_H
#define FIXCAST_PORT_PICO_LAUNCH_H

#include <stdint.h>

/* Returns when core 1 has taken it all: addresses of a vector table, of the end of a stack, and of code (bit 0 set). */
void fcp_launch(uint32_t vectors, uint32_t stack_end, uint32_t code);

#endif
