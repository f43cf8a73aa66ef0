/* The display's bus: SPI0 with D/C, CS, reset and backlight, and DMA for strips that are sent while the next is drawn. */
#ifndef FIXCAST_PORT_PICO_SPI_BUS_H
#define FIXCAST_PORT_PICO_SPI_BUS_H

#include "fixcast/bus.h"

/*
 * Resets SPI0 and DMA, enables the DMA interrupt, and returns the bus (there is one; it lives as long as the program). After
 * fcp_clocks_start() and fcp_pins_start().
 *
 * Clocks are clk_peri / (even number): 62.5 MHz, 31.25, 20.83, 15.625, 12.5 ... and down to 2 kHz.
 * data_start: from a buffer that starts at an even address and is of even length, words of 16 bits go out: in SPI mode 0 the clock rests
 * between words, and so half as often. `ready` runs in the DMA interrupt, on the core that called this function, once the
 * last bit has left, and may start the next transfer; wait() returns when one transfer has ended, whatever `ready` has started.
 * Errors: FC_ERR_UNSUPPORTED (configure), FC_ERR_BUS (DMA met an address that does not exist, or did not finish in time).
 */
fc_bus fcp_spi_bus_start(void);

void fcp_dma_interrupt(void);

#endif
