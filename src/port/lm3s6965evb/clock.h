/* The board's clocks: 50 MHz from the crystal by the PLL, and time by SysTick. */
#ifndef FIXCAST_LM3S6965_CLOCK_H
#define FIXCAST_LM3S6965_CLOCK_H

#include <stdint.h>

#define CPU_HZ UINT32_C(50000000)

/* Before anything whose speed matters. */
void clock_start(void);

/* Both go round after 2^32. */
uint32_t clock_cycles(void *context);
uint32_t clock_microseconds(void *context);

void clock_delay_us(void *context, uint32_t us);

/* The interrupt of SysTick. */
void clock_tick(void);

#endif
