/*
 * Solomon Systech SSD1306: OLED controller, 128x64 pixels of one bit, under glass of that size (the 0.96 inch modules).
 *
 * Facts: SSD1306 data sheet Rev 1.1 (2008-04), sections 9 and 10 (commands), 13 (AC characteristics: serial clock cycle 100 ns) and its
 * appendix (charge pump). Commands and their data are sent with D/C low.
 */
#include "fixcast/panel.h"

static const uint8_t init[] FC_ROM = {
    0xAE, 0,       /* display off */
    0xD5, 1, 0x80, /* clock divider 1, oscillator as after reset */
    0xA8, 1, 63,   /* multiplex ratio: 64 rows */
    0xD3, 1, 0,    /* offset */
    0x40, 0,       /* start line 0 */
    0x8D, 1, 0x14, /* charge pump on: the glass's voltage is made from 3.3 V */
    0x20, 1, 0x00, /* addresses run along a page, then to the next */
    0xDA, 1, 0x12, /* commons alternate, not swapped: as the glass is wired */
    0x81, 1, 0xCF, /* contrast */
    0xD9, 1, 0xF1, /* pre-charge period */
    0xDB, 1, 0x40, /* VCOMH */
    0xA4, 0,       /* show memory */
    0xA6, 0,       /* not inverted */
    0xAF, 0,       /* display on */
    FC_PANEL_END};
static const uint8_t off[] FC_ROM = {
    0xAE, 0,       /* display off */
    0x8D, 1, 0x10, /* charge pump off */
    FC_PANEL_END};
/* Segment re-map and scan direction: modules carry the controller below the picture, so that upright is both the other way. */
static const uint8_t upright[] FC_ROM = {0xA1, 0, 0xC8, 0, FC_PANEL_END};
static const uint8_t turned[] FC_ROM = {0xA0, 0, 0xC0, 0, FC_PANEL_END};
static const char name[] FC_ROM = "ssd1306";

/* Reset is held for 3 us; the 100 ms are for the supply of a module that is switched on together with the chip. */
const fc_panel fc_panel_ssd1306 FC_ROM = {.name = name,
                                          .init = init,
                                          .off = off,
                                          .width = 128,
                                          .height = 64,
                                          .turn = {{0, 0, upright}, {0, 0, turned}},
                                          .window = FC_WINDOW_SSD1306,
                                          .format = FC_DISPLAY_MONO8,
                                          .spi_mode = 0,
                                          .data_as_commands = 1,
                                          .format12 = NULL,
                                          .init_hz = 10000000,
                                          .pixel_hz = 10000000,
                                          .reset_low_us = 10,
                                          .reset_wait_us = 100000};
