/*
 * Solomon Systech SSD0323: OLED controller, 128x80 pixels of 4-bit grey, here under glass of 128x64 (Osram Pictiva, as on TI's LM3S6965 board).
 *
 * Facts: SSD0323 data sheet Rev 2.1, sections 9 (commands) and 13 (AC characteristics); voltages and timings of the glass: Osram application note
 * AN018, as TI's driver for that board has them. Commands and their data are sent with D/C low.
 */
#include "fixcast/panel.h"

static const uint8_t init[] FC_ROM = {
    0xAE, 0,                                                 /* display off */
    0x81, 1, 50,                                             /* contrast */
    0x85, 0,                                                 /* half current range */
    0xA1, 1, 0x00,                                           /* start line */
    0xA4, 0,                                                 /* normal display */
    0xA8, 1, 63,                                             /* multiplex ratio: 64 rows */
    0xB1, 1, 0x22,                                           /* phase lengths */
    0xB2, 1, 70,                                             /* row period */
    0xB3, 1, 0xF1,                                           /* clock divider, oscillator */
    0xBF, 1, 0x0D,                                           /* VSL */
    0xBE, 1, 0x02,                                           /* VCOMH */
    0xBC, 1, 0x10,                                           /* pre-charge voltage */
    0xB8, 8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76, /* pulse widths of the 15 grey levels: linear */
    0xAD, 1, 0x03,                                           /* DC-DC converter on */
    0xAF, 0,                                                 /* display on */
    FC_PANEL_END};
static const uint8_t off[] FC_ROM = {
    0xAE, 0,       /* display off */
    0xAD, 1, 0x02, /* DC-DC converter off */
    FC_PANEL_END};
/* The glass is on commons 12 to 75 of 80, the upper end on top. Re-map (A0): commons split, as the glass is wired; upright, commons and
 * nibbles are re-mapped, so that the high half of a byte is on the left; turned, columns. Offset (A2): -4, or -12, of 80. */
static const uint8_t upright[] FC_ROM = {0xA0, 1, 0x52, 0xA2, 1, 76, FC_PANEL_END};
static const uint8_t turned[] FC_ROM = {0xA0, 1, 0x41, 0xA2, 1, 68, FC_PANEL_END};
static const char name[] FC_ROM = "ssd0323";

/* Serial clock cycle 250 ns. SPI mode 3: the clock is idle high, bits are taken as it rises. */
const fc_panel fc_panel_ssd0323 FC_ROM = {.name = name,
                                          .init = init,
                                          .off = off,
                                          .width = 128,
                                          .height = 64,
                                          .turn = {{0, 0, upright}, {0, 0, turned}},
                                          .window = FC_WINDOW_SSD0323,
                                          .format = FC_DISPLAY_GREY4,
                                          .spi_mode = 3,
                                          .data_as_commands = 1,
                                          .format12 = NULL,
                                          .init_hz = 4000000,
                                          .pixel_hz = 4000000,
                                          .reset_low_us = 10,
                                          .reset_wait_us = 100};
