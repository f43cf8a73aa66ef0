/*
 * Solomon Systech SSD1327: OLED controller, 128x128 pixels of 4-bit grey, under glass of that size (the 1.5 inch modules).
 *
 * Facts: SSD1327 data sheet Rev 1.1, sections 9 and 10 (commands) and 13 (AC characteristics: serial clock cycle 100 ns). Commands and
 * their data are sent with D/C low. Windows are those of the SSD0323: columns of two pixels.
 */
#include "fixcast/panel.h"

static const uint8_t init[] FC_ROM = {
    0xFD, 1, 0x12, /* command lock: unlock */
    0xAE, 0,       /* display off (sleep) */
    0xA8, 1, 127,  /* multiplex ratio: 128 rows */
    0xA1, 1, 0,    /* start line */
    0xA2, 1, 0,    /* offset */
    0xAB, 1, 0x01, /* internal VDD regulator */
    0x81, 1, 0x53, /* contrast */
    0xB1, 1, 0x51, /* phase lengths */
    0xB3, 1, 0x01, /* clock divider 2, oscillator */
    0xB9, 0,       /* linear grey scale */
    0xBC, 1, 0x08, /* pre-charge voltage VCOMH */
    0xBE, 1, 0x07, /* VCOMH 0.86 VCC */
    0xB6, 1, 0x01, /* second pre-charge period */
    0xD5, 1, 0x62, /* second pre-charge on, internal segment low voltage */
    0xA4, 0,       /* normal display */
    0xAF, 0,       /* display on */
    FC_PANEL_END};
static const uint8_t off[] FC_ROM = {0xAE, 0, FC_PANEL_END};
/* Re-map: commons split; upright, commons and columns run the other way; turned, as they come, and then the halves of bytes are re-mapped, so that
 * the high one is on the left. */
static const uint8_t upright[] FC_ROM = {0xA0, 1, 0x51, FC_PANEL_END};
static const uint8_t turned[] FC_ROM = {0xA0, 1, 0x42, FC_PANEL_END};
static const char name[] FC_ROM = "ssd1327";

const fc_panel fc_panel_ssd1327 FC_ROM = {.name = name,
                                          .init = init,
                                          .off = off,
                                          .width = 128,
                                          .height = 128,
                                          .turn = {{0, 0, upright}, {0, 0, turned}},
                                          .window = FC_WINDOW_SSD0323,
                                          .format = FC_DISPLAY_GREY4,
                                          .spi_mode = 0,
                                          .data_as_commands = 1,
                                          .format12 = NULL,
                                          .init_hz = 10000000,
                                          .pixel_hz = 10000000,
                                          .reset_low_us = 10,
                                          .reset_wait_us = 100};
