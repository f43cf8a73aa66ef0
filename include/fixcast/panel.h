/*
 * Display controllers as const data: what a panel needs to be told, and how it takes a window of pixels.
 *
 * One interpreter (src/panel/panel.c) replays a record over a bus; a new panel is a new record (docs/PORTING.md).
 */
#ifndef FIXCAST_PANEL_H
#define FIXCAST_PANEL_H

#include <stdint.h>

#include "fixcast/bus.h"
#include "fixcast/config.h"
#include "fixcast/display.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How a controller is told a window. */
typedef enum fc_panel_window {
  FC_WINDOW_MIPI = 0,    /* 2A x0 x1, 2B y0 y1, 2C: ends as 16-bit data, high byte first (ST7789, ILI9341, ST7735) */
  FC_WINDOW_SSD1351 = 1, /* 15 x0 x1, 75 y0 y1, 5C: ends as 8-bit data */
  FC_WINDOW_SSD0323 = 2, /* 15 x0 x1 75 y0 y1, all as commands; columns in units of two pixels; pixels follow as data (SSD1327 too) */
  FC_WINDOW_SSD1322 = 3, /* 15 x0 x1, 75 y0 y1, 5C: ends as 8-bit data, columns in units of four pixels */
  FC_WINDOW_SSD1306 = 4  /* 21 x0 x1 22 p0 p1, all as commands; rows in pages of eight; pixels follow as data */
} fc_panel_window;

/*
 * Commands are tables of bytes in constant memory (FC_ROM): command, count | FC_PANEL_DELAY if a delay follows, `count` data bytes (0..127), then
 * with the flag the delay in units of 5 ms, at most 255 (1.275 s). A table ends with FC_PANEL_END, which as a command is a no-operation in, or
 * unknown to, all controllers here.
 */
#define FC_PANEL_DELAY 0x80
/* Ends a record of commands. */
#define FC_PANEL_END 0x00

/* One way up: where the glass begins in the controller's memory, in pixels as the controller counts them after `direction`, a table of the
 * commands that choose the order in which memory is scanned (MADCTL, set re-map). */
typedef struct fc_panel_turn {
  uint16_t x_offset, y_offset;
  const uint8_t *direction;
} fc_panel_turn;

/* A panel. The record and all it points at are in constant memory: code reads them through FC_READ. */
typedef struct fc_panel {
  const char *name;       /* "st7789-240" */
  const uint8_t *init;    /* commands from reset to display on, without the direction, which is sent after them */
  const uint8_t *off;     /* commands that turn the panel off (display off, sleep in) */
  uint16_t width, height; /* of the glass, pixels */
  /* The right way up, and turned by half a circle. Quarter turns are the camera's (fc_camera's up): then the order in which rows are drawn and
   * shown is the same. */
  fc_panel_turn turn[2];
  uint8_t window;                       /* fc_panel_window */
  uint8_t format;                       /* fc_display_format after `init` */
  uint8_t spi_mode;                     /* 0 or 3 */
  uint8_t data_as_commands;             /* 1: data bytes of commands are sent with D/C low (SSD0323, SSD1306) */
  const uint8_t *format12;              /* commands that switch to FC_DISPLAY_RGB444 (COLMOD 3), or NULL; NULL too where the width is odd */
  uint32_t init_hz, pixel_hz;           /* fastest clocks for `init` (<= 10 MHz) and for pixels, from the data sheet (write cycle) */
  uint32_t reset_low_us, reset_wait_us; /* how long reset is held, and from its end to the first command */
} fc_panel;

extern const fc_panel fc_panel_st7789_240 FC_ROM; /* 240x240 of 240x320, 1.3" and 1.54" */
extern const fc_panel fc_panel_st7789_135 FC_ROM; /* 135x240, 1.14" */
extern const fc_panel fc_panel_st7789_320 FC_ROM; /* 240x320, 2.0" */
extern const fc_panel fc_panel_st7789_170 FC_ROM; /* 170x320, 1.9" */
extern const fc_panel fc_panel_ili9341 FC_ROM;    /* 240x320 */
extern const fc_panel fc_panel_st7735_128 FC_ROM; /* 128x160, 1.8" */
extern const fc_panel fc_panel_ssd1351 FC_ROM;    /* 128x128 colour OLED */
extern const fc_panel fc_panel_ssd0323 FC_ROM;    /* 128x64 grey OLED */
extern const fc_panel fc_panel_ssd1327 FC_ROM;    /* 128x128 grey OLED */
extern const fc_panel fc_panel_ssd1322 FC_ROM;    /* 256x64 grey OLED */
extern const fc_panel fc_panel_ssd1306 FC_ROM;    /* 128x64 monochrome OLED */

/* All of the above, in the order of `fixcast panels`; ends with NULL. Programs that name one panel do not link the others. */
extern const fc_panel *const fc_panels[] FC_ROM;

/* What a panel's user chooses. */
typedef struct fc_panel_options {
  uint32_t pixel_hz;  /* 0: the record's; else a slower or (at one's own risk) faster clock */
  uint8_t half_turn;  /* 1: upside down */
  uint8_t twelve_bit; /* 1: FC_DISPLAY_RGB444 where the panel has it */
} fc_panel_options;

/* A panel that is running. Owned by the caller; fields are private. */
typedef struct fc_panel_state {
  const fc_panel *panel;
  fc_bus bus;
  fc_panel_options options;
  uint16_t next_y; /* the row at which the open window goes on; UINT16_MAX: none is open */
  uint8_t busy;    /* data_start was called, and wait was not since */
} fc_panel_state;

/*
 * Resets and initialises a panel, at init_hz, and leaves the bus at pixel_hz. `options` may be NULL. On success *display is a sink that
 * writes to it, with *state as its context; both must live as long as it is used. The glass shows what its memory held: write a frame, then turn
 * the backlight on.
 * Errors: FC_ERR_NULL, FC_ERR_UNSUPPORTED (twelve_bit on a panel that has none), those of the bus. After an error, of this or of a write, it may be
 * called again: nothing of the past counts.
 */
int fc_panel_start(fc_panel_state *state, const fc_panel *panel, const fc_bus *bus, const fc_panel_options *options,
                   fc_display *display);

/* Backlight off where there is one, display off and to sleep. Tries all of it and returns the first error. The display must not be used
 * afterwards. */
int fc_panel_stop(fc_panel_state *state);

#ifdef __cplusplus
}
#endif

#endif
