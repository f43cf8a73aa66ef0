/*
 * Ilitek ILI9341: colour TFT controller, 240x320 pixels, under glass of that size.
 *
 * Facts: ILI9341 data sheet V1.11 (2011-06), sections in brackets. The write cycle is 100 ns by it [19.3.4]; most modules are run at 24 to
 * 40 MHz by their sellers' own examples: fc_panel_options.pixel_hz, at one's own risk.
 */
#include "fixcast/panel.h"

static const uint8_t init[] FC_ROM = {
    0x01, 0 | FC_PANEL_DELAY, 24, /* software reset [8.2.2]: 120 ms until sleep out */
    0xC0, 1, 0x23,                /* power control 1 [8.3.16]: GVDD 4.6 V */
    0xC1, 1, 0x10,                /* power control 2 [8.3.17]: step-up factors */
    0xC5, 2, 0x3E, 0x28,          /* VCOM control 1 [8.3.18]: VCOMH 4.25 V, VCOML -1.5 V */
    0xC7, 1, 0x86,                /* VCOM control 2 [8.3.19]: offset */
    0x3A, 1, 0x55,                /* COLMOD [8.2.33]: 16 bits a pixel */
    0xB1, 2, 0x00, 0x1B,          /* frame rate [8.3.2]: 70 Hz */
    0x26, 1, 0x01,                /* gamma curve [8.2.17] */
    0x11, 0 | FC_PANEL_DELAY, 24, /* sleep out [8.2.12]: 120 ms until the supplies are stable */
    0x29, 0,                      /* display on [8.2.19] */
    FC_PANEL_END};
static const uint8_t off[] FC_ROM = {
    0x28, 0,                     /* display off [8.2.18] */
    0x10, 0 | FC_PANEL_DELAY, 1, /* sleep in [8.2.11]: 5 ms until the next command */
    FC_PANEL_END};
/* MADCTL [8.2.29]: the glass's filter is blue, green, red; upright, columns run the other way, turned, rows do. */
static const uint8_t upright[] FC_ROM = {0x36, 1, 0x48, FC_PANEL_END};
static const uint8_t turned[] FC_ROM = {0x36, 1, 0x88, FC_PANEL_END};
static const char name[] FC_ROM = "ili9341";

/* Reset: 10 us, then 5 ms until the first command [15.4]. No 12 bits: its serial interface takes 16 or 18 [7.6.3]. */
const fc_panel fc_panel_ili9341 FC_ROM = {.name = name,
                                          .init = init,
                                          .off = off,
                                          .width = 240,
                                          .height = 320,
                                          .turn = {{0, 0, upright}, {0, 0, turned}},
                                          .window = FC_WINDOW_MIPI,
                                          .format = FC_DISPLAY_RGB565,
                                          .spi_mode = 0,
                                          .data_as_commands = 0,
                                          .format12 = NULL,
                                          .init_hz = 10000000,
                                          .pixel_hz = 10000000,
                                          .reset_low_us = 10,
                                          .reset_wait_us = 5000};
