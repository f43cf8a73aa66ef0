/*
 * Where finished strips go: a display sink of a size and a pixel format, with a few optional talents.
 *
 * A panel over a bus (panel.h) is one; a window, a file or a test may be another. Coordinates are pixels, (0, 0) at the top
 * left of what the display shows, right and down. Functions return FC_OK or a negative number: an fc_error, or the
 * code of what is below (a bus), passed on unchanged.
 */
#ifndef FIXCAST_DISPLAY_H
#define FIXCAST_DISPLAY_H

#include <stddef.h>
#include <stdint.h>

#include "fixcast/bus.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How a display wants its pixels. FC_DISPLAY_RGB565 is what the renderer writes as FC_RGB565_BE; the others are made from
 * that by fc_display_convert. */
typedef enum fc_display_format {
  FC_DISPLAY_RGB565 = 0, /* two bytes, high byte first */
  FC_DISPLAY_RGB444 = 1, /* two pixels in three bytes: rrrrgggg bbbbrrrr ggggbbbb, the left one first */
  FC_DISPLAY_GREY4 = 2,  /* two pixels a byte, the left one in the high half */
  FC_DISPLAY_MONO8 = 3   /* eight pixels a byte, one below the other, the uppermost in bit 0: a row of bytes is a page of 8 rows */
} fc_display_format;

/* A rectangle of the display, in pixels from its top left corner. */
typedef struct fc_area {
  uint16_t x, y, width, height; /* pixels; width and height at least 1 */
} fc_area;

/* What a display can show and how it wants areas. */
typedef struct fc_display_capabilities {
  uint16_t width, height;                      /* pixels */
  uint8_t format;                              /* fc_display_format */
  uint8_t x_align, y_align;                    /* an area's x and width, y and height are multiples of these (1, 2, 4 or 8) */
  uint8_t asynchronous;                        /* 1: write_start returns before the pixels have left; 0: write is called in its place */
  uint8_t has_flush, has_backlight, has_vsync; /* 1: the operation does something; 0: it returns FC_ERR_UNSUPPORTED */
} fc_display_capabilities;

/* `pitch_bytes`: from one row of pixels to the next (FC_DISPLAY_MONO8: one page to the next); at least the bytes of a row of the area. */
typedef struct fc_display_ops {
  void (*capabilities)(void *context, fc_display_capabilities *to);
  int (*write)(void *context, const fc_area *area, const void *pixels, size_t pitch_bytes);
  int (*write_start)(void *context, const fc_area *area, const void *pixels, size_t pitch_bytes, fc_ready *ready,
                     void *ready_context); /* only called where the capabilities say asynchronous; may be NULL elsewhere */
  int (*wait)(void *context);              /* NULL: nothing is ever under way */
  int (*flush)(void *context);             /* NULL: not supported, as the next two */
  int (*backlight)(void *context, uint8_t level);
  int (*wait_vsync)(void *context);
} fc_display_ops;

/* A display: its functions and what they work on, both the caller's. */
typedef struct fc_display {
  const fc_display_ops *ops;
  void *context;
} fc_display;

/* What the display can show; `display` and `to` must not be NULL. */
void fc_display_capabilities_get(const fc_display *display, fc_display_capabilities *to);

/* Draws an area; returns when the pixels are the caller's again. Areas that follow one another downwards over the whole width are
 * cheapest: a panel then needs one window command a frame. Errors: FC_ERR_AREA for an area that is empty, off the display or not
 * aligned, or a pitch that is too small (nothing is sent then). */
int fc_display_write(const fc_display *display, const fc_area *area, const void *pixels, size_t pitch_bytes);

/* The same, but returns while the pixels are on their way: they must stay until `ready` (may be NULL) was called, perhaps from an interrupt,
 * or fc_display_wait returned. At most one is under way; a second waits for the first. On a display without the talent `ready` is called
 * before it returns. On an error returned by this function `ready` is not called. */
int fc_display_write_start(const fc_display *display, const fc_area *area, const void *pixels, size_t pitch_bytes,
                           fc_ready *ready, void *ready_context);

/* Until nothing is under way; the error of what was. */
int fc_display_wait(const fc_display *display);

/* What was written becomes visible (a window), the light's level 0..255, the start of a refresh: or FC_ERR_UNSUPPORTED. */
int fc_display_flush(const fc_display *display);
/* The backlight, 0 off to 255 full. FC_ERR_UNSUPPORTED without one. */
int fc_display_backlight(const fc_display *display, uint8_t level);
/* Returns when the panel is between two frames. FC_ERR_UNSUPPORTED without such a signal. */
int fc_display_wait_vsync(const fc_display *display);

/* Bytes of one row of `width` pixels in a format (FC_DISPLAY_MONO8: of one page of 8 rows), or 0 for an unknown format. */
size_t fc_display_row_bytes(uint8_t format, uint16_t width);

/*
 * Rows of FC_RGB565_BE pixels as the renderer left them, in a display's format. (x, y) is where on the display the first pixel is shown: ordered
 * dither depends on that and the pixel alone, so that strips of any height and areas of any place give the same bits.
 * FC_DISPLAY_MONO8: y must be a multiple of 8, unless rows is 1: a single row sets its own bit in each byte of `to` and leaves the other
 * bits alone, so that a page may be made row by row. `to` may be `from` where rows do not grow (all formats but that).
 * Errors: FC_ERR_FORMAT, FC_ERR_AREA.
 */
int fc_display_convert(uint8_t format, uint16_t x, uint16_t y, uint16_t width, uint16_t rows, const void *from,
                       size_t from_pitch_bytes, void *to, size_t to_pitch_bytes);

/*
 * Rows of FC_RGB888 pixels as FC_DISPLAY_RGB565, by the same dither of each channel, so that gradients show no bands where 31 levels are too
 * few. What fc_render_rows writes as FC_RGB565_BE is rounded instead, which costs a third less memory and no time. (x, y) is where on the display the
 * first pixel is shown. `to` may be `from`. Errors: FC_ERR_NULL; FC_ERR_AREA: nothing to convert, or a pitch below 3 or 2 bytes a pixel.
 */
int fc_display_dither565(uint16_t x, uint16_t y, uint16_t width, uint16_t rows, const void *from, size_t from_pitch_bytes, void *to,
                         size_t to_pitch_bytes);

#ifdef __cplusplus
}
#endif

#endif
