/*
 * Sitronix ST7789: colour TFT controllers of 240x320 pixels, under glass of that size or a smaller one.
 *
 * Facts: ST7789V data sheet V1.3 (2014-03), sections in brackets; the write cycle of 16 ns is that of the ST7789VW, V1.0 (2017-09) 7.4.3,
 * which is on the small IPS modules that are sold today. (The ST7789V has 66 ns: for it, set fc_panel_options.pixel_hz to 15 MHz.)
 */
#include "fixcast/panel.h"

static const uint8_t init[] FC_ROM = {
    0x01, 0 | FC_PANEL_DELAY, 24, /* software reset [9.1.2]: 120 ms until sleep out */
    0x11, 0 | FC_PANEL_DELAY, 24, /* sleep out [9.1.12]: 120 ms until the supplies are stable */
    0x3A, 1, 0x55,                /* COLMOD [9.1.32]: 16 bits a pixel */
    0x21, 0,                      /* inversion on [9.1.16]: IPS glass is normally black */
    0x13, 0,                      /* normal display mode on [9.1.14] */
    0x29, 0,                      /* display on [9.1.19] */
    FC_PANEL_END};
static const uint8_t off[] FC_ROM = {
    0x28, 0,                     /* display off [9.1.18] */
    0x10, 0 | FC_PANEL_DELAY, 1, /* sleep in [9.1.11]: 5 ms until the next command */
    FC_PANEL_END};
static const uint8_t twelve_bits[] FC_ROM = {0x3A, 1, 0x53, FC_PANEL_END}; /* COLMOD: 12 bits a pixel */
/* MADCTL [9.1.28]: rows and columns as they come, or MY and MX: both the other way */
static const uint8_t upright[] FC_ROM = {0x36, 1, 0x00, FC_PANEL_END};
static const uint8_t turned[] FC_ROM = {0x36, 1, 0xC0, FC_PANEL_END};

/* All that these panels share: reset is held for 10 us [7.4.5], after it 5 ms until the first command. Bits are taken as the clock rises,
 * however it idles [7.4.3]; of the modes 0 and 3, some SPI controllers (PL022) pause between words in the first. */
#define ST7789 \
  .init = init, .off = off, .window = FC_WINDOW_MIPI, .format = FC_DISPLAY_RGB565, .spi_mode = 3, .init_hz = 10000000, .pixel_hz = 62500000, \
  .reset_low_us = 10, .reset_wait_us = 5000

static const char name_240[] FC_ROM = "st7789-240", name_135[] FC_ROM = "st7789-135", name_320[] FC_ROM = "st7789-320",
                             name_170[] FC_ROM = "st7789-170";

/* The glass shows the first 240 rows of memory; turned, that is the last 240 of 320. */
const fc_panel fc_panel_st7789_240 FC_ROM = {
    ST7789, .name = name_240, .width = 240, .height = 240, .turn = {{0, 0, upright}, {0, 80, turned}}, .format12 = twelve_bits};

/* 135 of 240 columns, from 52 (turned: 240 - 135 - 52 = 53), and 240 of 320 rows, from 40. An odd width has no whole bytes a row in 12 bits. */
const fc_panel fc_panel_st7789_135 FC_ROM = {
    ST7789, .name = name_135, .width = 135, .height = 240, .turn = {{52, 40, upright}, {53, 40, turned}}, .format12 = NULL};

const fc_panel fc_panel_st7789_320 FC_ROM = {
    ST7789, .name = name_320, .width = 240, .height = 320, .turn = {{0, 0, upright}, {0, 0, turned}}, .format12 = twelve_bits};

/* 170 of 240 columns, from 35 on both ways up. */
const fc_panel fc_panel_st7789_170 FC_ROM = {
    ST7789, .name = name_170, .width = 170, .height = 320, .turn = {{35, 0, upright}, {35, 0, turned}}, .format12 = twelve_bits};
