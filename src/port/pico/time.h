/* Time: microseconds by the timer, processor cycles by SysTick. */
#ifndef FIXCAST_PORT_PICO_TIME_H
#define FIXCAST_PORT_PICO_TIME_H

#include <stdint.h>

/* Starts counting cycles, from 0. fcp_clocks_start() started the timer. */
void fcp_cycles_start(void);

/* Microseconds since the clocks were started. Both cores and interrupts may ask. */
uint64_t fcp_time_us(void);

/* The same, going round after 2^32 us. */
uint32_t fcp_microseconds(void *context);

/* At least `us` microseconds. */
void fcp_delay_us(uint32_t us);

/* Cycles of core 0 since fcp_cycles_start(): wraps after 34 s at 125 MHz. Core 0 only; interrupts may ask. */
uint32_t fcp_cycles(void *context);

void fcp_systick(void); /* the SysTick interrupt */

#endif
