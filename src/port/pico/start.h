/* Start-up: the reset handler and how much of the stack has been used. */
#ifndef FIXCAST_PORT_PICO_START_H
#define FIXCAST_PORT_PICO_START_H

#include <stdint.h>

void fcp_reset(void);

/* The most bytes of core 0's stack that were in use since reset. */
uint32_t fcp_stack_used_bytes(void);

#endif
