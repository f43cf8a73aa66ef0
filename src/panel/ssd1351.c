/*
 * Solomon Systech SSD1351: colour OLED controller, 128x128 pixels.
 *
 * Facts: SSD1351 data sheet Rev 1.5 (2011-01), sections 9 and 10 (commands) and 13 (AC characteristics). Its serial clock cycle is 220 ns
 * (table 13-4); Rev 1.3 still had 50 ns, and modules are widely run at 8 to 20 MHz: fc_panel_options.pixel_hz, at one's own risk.
 */
#include "fixcast/panel.h"

static const uint8_t init[] FC_ROM = {
    0xFD, 1, 0x12,             /* command lock: unlock */
    0xFD, 1, 0xB1,             /* command lock: the commands A2, B1, B3, BB, BE, C1 too */
    0xAE, 0,                   /* display off (sleep) */
    0xB3, 1, 0xF1,             /* clock divider 2, fastest oscillator */
    0xCA, 1, 127,              /* multiplex ratio: 128 rows */
    0xA1, 1, 0,                /* start line */
    0xA2, 1, 0,                /* offset (reset value: 96) */
    0xAB, 1, 0x01,             /* internal VDD regulator, serial interface */
    0xB1, 1, 0x32,             /* phase lengths */
    0xB4, 3, 0xA0, 0xB5, 0x55, /* segment low voltage: external */
    0xBB, 1, 0x17,             /* pre-charge voltage */
    0xB6, 1, 0x01,             /* second pre-charge period */
    0xBE, 1, 0x05,             /* VCOMH 0.82 VCC */
    0xC1, 3, 0xC8, 0x80, 0xC8, /* contrast of the three colours */
    0xC7, 1, 0x0F,             /* master contrast: full */
    0xB9, 0,                   /* linear grey scale */
    0xA6, 0,                   /* normal display */
    0xAF, 0,                   /* display on */
    FC_PANEL_END};
static const uint8_t off[] FC_ROM = {0xAE, 0, FC_PANEL_END};
/* Re-map: 65536 colours, commons split odd and even, colours swapped (red first); upright, commons re-mapped, turned, columns. */
static const uint8_t upright[] FC_ROM = {0xA0, 1, 0x74, FC_PANEL_END};
static const uint8_t turned[] FC_ROM = {0xA0, 1, 0x66, FC_PANEL_END};
static const char name[] FC_ROM = "ssd1351";

const fc_panel fc_panel_ssd1351 FC_ROM = {.name = name,
                                          .init = init,
                                          .off = off,
                                          .width = 128,
                                          .height = 128,
                                          .turn = {{0, 0, upright}, {0, 0, turned}},
                                          .window = FC_WINDOW_SSD1351,
                                          .format = FC_DISPLAY_RGB565,
                                          .spi_mode = 0,
                                          .data_as_commands = 0,
                                          .format12 = NULL,
                                          .init_hz = 4500000,
                                          .pixel_hz = 4500000,
                                          .reset_low_us = 10,
                                          .reset_wait_us = 100};
