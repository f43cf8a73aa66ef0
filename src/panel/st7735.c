/*
 * Sitronix ST7735R: colour TFT controller, wired (GM = 3) to have 128x160 pixels of memory, under glass of that size (the 1.8 inch modules
 * with a black tab).
 *
 * Facts: ST7735R data sheet V0.2 (2009-08), sections in brackets; frame rate, voltages and gamma are those that the glass's maker gives for it.
 */
#include "fixcast/panel.h"

/* clang-format off */
static const uint8_t init[] FC_ROM = {
    0x01, 0 | FC_PANEL_DELAY, 24,             /* software reset [10.1.2]: 120 ms until sleep out */
    0x11, 0 | FC_PANEL_DELAY, 24,             /* sleep out [10.1.11]: 120 ms until the supplies are stable */
    0xB1, 3, 0x01, 0x2C, 0x2D,                /* frame rate, normal [10.2.1] */
    0xB4, 1, 0x07,                            /* inversion by columns [10.2.4] */
    0xC0, 3, 0xA2, 0x02, 0x84,                /* power control 1 [10.2.6]: AVDD 5 V, GVDD 4.6 V */
    0xC1, 1, 0xC5,                            /* power control 2 [10.2.7]: VGH 14.7 V, VGL -7.35 V */
    0xC2, 2, 0x0A, 0x00,                      /* power control 3 [10.2.8]: amplifiers, normal mode */
    0xC5, 1, 0x0E,                            /* VCOM [10.2.11] */
    0x3A, 1, 0x05,                            /* COLMOD [10.1.29]: 16 bits a pixel */
    0x20, 0,                                  /* inversion off [10.1.14] */
    0xE0, 16, 0x02, 0x1C, 0x07, 0x12, 0x37, 0x32, 0x29, 0x2D, 0x29, 0x25, 0x2B, 0x39, 0x00, 0x01, 0x03, 0x10, /* gamma + [10.2.17] */
    0xE1, 16, 0x03, 0x1D, 0x07, 0x06, 0x2E, 0x2C, 0x29, 0x2D, 0x2E, 0x2E, 0x37, 0x3F, 0x00, 0x00, 0x02, 0x10, /* gamma - [10.2.18] */
    0x13, 0,                                  /* normal display mode on [10.1.13] */
    0x29, 0,                                  /* display on [10.1.18] */
    FC_PANEL_END};
/* clang-format on */
static const uint8_t off[] FC_ROM = {
    0x28, 0,                      /* display off [10.1.17] */
    0x10, 0 | FC_PANEL_DELAY, 24, /* sleep in [10.1.10]: 120 ms, as the ST7735R asks more than its kin */
    FC_PANEL_END};
static const uint8_t twelve_bits[] FC_ROM = {0x3A, 1, 0x03, FC_PANEL_END}; /* COLMOD: 12 bits a pixel */
/* MADCTL [10.1.26]: upright, rows and columns run the other way; turned, as they come. */
static const uint8_t upright[] FC_ROM = {0x36, 1, 0xC0, FC_PANEL_END};
static const uint8_t turned[] FC_ROM = {0x36, 1, 0x00, FC_PANEL_END};
static const char name[] FC_ROM = "st7735-128";

/* Write cycle 66 ns [8.4]. Reset: 10 us, then 5 ms until the first command [8.7]. */
const fc_panel fc_panel_st7735_128 FC_ROM = {.name = name,
                                             .init = init,
                                             .off = off,
                                             .width = 128,
                                             .height = 160,
                                             .turn = {{0, 0, upright}, {0, 0, turned}},
                                             .window = FC_WINDOW_MIPI,
                                             .format = FC_DISPLAY_RGB565,
                                             .spi_mode = 0,
                                             .data_as_commands = 0,
                                             .format12 = twelve_bits,
                                             .init_hz = 10000000,
                                             .pixel_hz = 15000000,
                                             .reset_low_us = 10,
                                             .reset_wait_us = 5000};
