/*
 * Solomon Systech SSD1322: OLED controller, 480x128 pixels of 4-bit grey, here under glass of 256x64 in the middle of its columns
 * (Newhaven NHD-3.12-25664 and its like).
 *
 * Facts: SSD1322 data sheet Rev 1.2, sections 9 and 10 (commands) and 13 (AC characteristics: serial clock cycle 100 ns); voltages and timings of the
 * glass: NHD-3.12-25664UCY2 data sheet. Columns are addressed four pixels at a time.
 */
#include "fixcast/panel.h"

static const uint8_t init[] FC_ROM = {
    0xFD, 1, 0x12,       /* command lock: unlock */
    0xAE, 0,             /* display off (sleep) */
    0xB3, 1, 0x91,       /* clock divider 2, oscillator */
    0xCA, 1, 63,         /* multiplex ratio: 64 rows */
    0xA2, 1, 0,          /* offset */
    0xA1, 1, 0,          /* start line */
    0xAB, 1, 0x01,       /* internal VDD regulator */
    0xB4, 2, 0xA0, 0xFD, /* display enhancement A: external VSL, enhanced low grey levels */
    0xC1, 1, 0x9F,       /* contrast */
    0xC7, 1, 0x0F,       /* master contrast: full */
    0xB9, 0,             /* linear grey scale */
    0xB1, 1, 0xE2,       /* phase lengths */
    0xD1, 2, 0xA2, 0x20, /* display enhancement B: normal */
    0xBB, 1, 0x1F,       /* pre-charge voltage 0.6 VCC */
    0xB6, 1, 0x08,       /* second pre-charge period */
    0xBE, 1, 0x07,       /* VCOMH 0.86 VCC */
    0xA9, 0,             /* no partial display */
    0xA6, 0,             /* normal display */
    0xAF, 0,             /* display on */
    FC_PANEL_END};
static const uint8_t off[] FC_ROM = {0xAE, 0, FC_PANEL_END};
/* Re-map, and two commons at a time: nibbles re-mapped (the high half of a byte is on the left); upright, commons too, turned, columns. */
static const uint8_t upright[] FC_ROM = {0xA0, 2, 0x14, 0x11, FC_PANEL_END};
static const uint8_t turned[] FC_ROM = {0xA0, 2, 0x06, 0x11, FC_PANEL_END};
static const char name[] FC_ROM = "ssd1322";

/* The first column is 28 * 4 = 112; turned, 480 - 112 - 256, which is the same. */
const fc_panel fc_panel_ssd1322 FC_ROM = {.name = name,
                                          .init = init,
                                          .off = off,
                                          .width = 256,
                                          .height = 64,
                                          .turn = {{112, 0, upright}, {112, 0, turned}},
                                          .window = FC_WINDOW_SSD1322,
                                          .format = FC_DISPLAY_GREY4,
                                          .spi_mode = 0,
                                          .data_as_commands = 0,
                                          .format12 = NULL,
                                          .init_hz = 10000000,
                                          .pixel_hz = 10000000,
                                          .reset_low_us = 10,
                                          .reset_wait_us = 100};
