/* A display's bus by the Pico SDK: SPI0 with D/C, CS, reset and backlight, and DMA. The pins are those of src/port/pico/pins.h. */
#ifndef SDK_BUS_H
#define SDK_BUS_H

#include "fixcast/bus.h"

enum {
  PIN_DC = 16,
  PIN_CS = 17,
  PIN_SCK = 18,
  PIN_MOSI = 19,
  PIN_RESET = 20,
  PIN_BACKLIGHT = 21
};

/* Sets up the pins, SPI0, a DMA channel and its interrupt. Once. */
fc_bus sdk_bus_start(void);

#endif
