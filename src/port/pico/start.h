/* Start-up: the reset handler and how much of the stack has been used. */
#ifndef FIXCAST_PORT_PICO_START_H
#define FIXCAST_PORT_PICO_START_H

#include <stdint.h>

void fcp_reset(void);

/* Bytes of RAM in use: variables, and the most of core 0's stack since reset. */
uint32_t fcp_ram_bytes(void *context);

#endif
