/* What the start-up code knows of memory. */
#ifndef FIXCAST_LM3S6965_START_H
#define FIXCAST_LM3S6965_START_H

#include <stdint.h>

/* Bytes of RAM used until now: variables, and the stack at its deepest, which was painted at the start. */
uint32_t start_ram_bytes(void *context);

#endif
