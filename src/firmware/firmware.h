/*
 * The demo that every board shows: scene S1 (host_sim/scenes/s1.h) seen by a camera that goes round it, drawn in strips that are sent while
 * the next is drawn, with figures of its speed as lines of text. A board fills in one struct and calls fc_firmware_run().
 *
 * Text (each line ends with a newline):
 *   fixcast on BOARD, N Hz
 *   panel NAME WxH FORMAT, spi requested N Hz, actual N Hz        (0: not known)
 *   wire limit F fps, B bytes a frame
 *   pattern shown [crc XXXXXXXX]
 *   frame N crc XXXXXXXX                                          (each frame, built with FC_FIRMWARE_CRC)
 *   N frames: F fps, render R us, C cycles a pixel, wire W us a frame: render binds|wire binds[, ram N bytes]
 *   done | error: SENTENCE (CODE)
 * A CRC is zlib's CRC-32 of the frame's bytes as the panel gets them, from the top row to the bottom.
 */
#ifndef FIXCAST_FIRMWARE_H
#define FIXCAST_FIRMWARE_H

#include <stddef.h>
#include <stdint.h>

#include "fixcast/bus.h"
#include "fixcast/panel.h"
#include "fixcast/render.h"

/* Bits of fc_firmware_board.buttons, 1 while held. A button counts from the first time it is seen released. */
enum {
  FC_BUTTON_PAUSE = 1,  /* stops the camera, or lets it go on */
  FC_BUTTON_FASTER = 2, /* 1, 2, 4, 8 steps a frame */
  FC_BUTTON_SLOWER = 4,
  FC_BUTTON_REVERSE = 8, /* the other way round */
  FC_BUTTON_PATTERN = 16 /* the bring-up pattern as long as it is held */
};

/* Owned by the board; it and all it points to must live as long as fc_firmware_run() runs. `context` is handed to the functions. */
typedef struct fc_firmware_board {
  const char *name; /* read through FC_READ, as the panel is */
  const fc_panel *panel;
  fc_panel_options options; /* pixel_hz: the requested clock, 0: the panel's fastest */
  fc_bus bus;
  void *context;
  void (*put)(void *context, char c);      /* a character of the text. Required */
  uint32_t (*microseconds)(void *context); /* a clock that goes round after 2^32 us. Required */
  uint32_t (*cycles)(void *context);       /* processor cycles, likewise; NULL: reckoned from microseconds and cpu_hz */
  uint8_t (*buttons)(void *context);       /* FC_BUTTON_ bits; NULL: none */
  uint32_t (*ram_bytes)(void *context);    /* static data and the deepest stack so far; NULL: not known */
  /* In place of fc_render_rows_in (a second core), whose scratch is for the core that calls; NULL: that. */
  int (*render)(void *context, fc_scratch *scratch, const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target);
  uint32_t cpu_hz;        /* at least 1 MHz */
  uint16_t width, height; /* of the picture, which is centred; 0: the panel's */
  uint16_t strip_rows;    /* rows drawn at a time, at least 1; FC_DISPLAY_MONO8: 1, 2, 4 or a multiple of 8 */
  /* Strips of pixels: 0 or 2; 3 or 4 where the bus is as queue.h says: then the next strip follows from the interrupt, and what is drawn
   * slowly is made up for by what was drawn fast. */
  uint8_t buffers;
  /* 1: strips of the upper and of the lower half in turn, so that slow ones (ground) and fast ones (sky) are neighbours; a window command a
   * strip. 0: from the top to the bottom. */
  uint8_t alternate;
  uint16_t frames;     /* how many to show, then return; 0: no end */
  uint16_t pattern_ms; /* how long the bring-up pattern is shown first, at most 60000 */
  void *memory;        /* aligned for int64_t */
  size_t memory_bytes; /* FC_FIRMWARE_MEMORY() */
} fc_firmware_board;

/* Enough bytes of memory: the frame's own, what strips are drawn in, two strips to send, one of depth codes and, where a strip to send is
 * smaller than what is drawn, one of that. The second is for panels of FC_DISPLAY_GREY4. */
#define FC_FIRMWARE_MEMORY(width, strip_rows) (256u + sizeof(fc_scratch) + 6u * (size_t)(width) * (strip_rows))
/* What each further strip of pixels adds to that. */
#define FC_FIRMWARE_MEMORY_BUFFER(width, strip_rows) (8u + 2u * (size_t)(width) * (strip_rows))
#define FC_FIRMWARE_MEMORY_GREY4(width, strip_rows) (256u + sizeof(fc_scratch) + 5u * (size_t)(width) * (strip_rows))

/* Starts the panel and shows frames. FC_OK after the last one, or the error that it has also printed: any of fc_error or the bus's own. */
int fc_firmware_run(const fc_firmware_board *board);

/* Called when all of a frame was sent and its line was printed; does nothing. A debugger or an emulator stops here to look at the panel. */
void fc_firmware_frame_shown(void);

#endif
