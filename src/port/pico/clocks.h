/* The clock tree: crystal, PLL, and what runs from them. */
#ifndef FIXCAST_PORT_PICO_CLOCKS_H
#define FIXCAST_PORT_PICO_CLOCKS_H

#include <stdint.h>

enum {
  FCP_CRYSTAL_HZ = 12000000,
  FCP_SYSTEM_HZ = 125000000 /* clk_sys and clk_peri */
};

/* From the ring oscillator, as the ROM leaves it, to FCP_SYSTEM_HZ; starts the 1 MHz tick of the timer. */
void fcp_clocks_start(void);

/* Takes peripherals (RESETS_ bits) through reset and waits until they are ready. */
void fcp_reset_peripherals(uint32_t bits);

#endif
