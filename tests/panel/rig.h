/*
 * A panel record, the bus and the virtual panel it drives, and pictures to draw: what the tests of panels share.
 *
 * Pictures are noise in the display's own format, so that no two neighbours are alike and nothing is symmetric; what the eye should see of one is
 * computed here from the format's description in display.h, not by the panel's code.
 */
#ifndef FIXCAST_TEST_RIG_H
#define FIXCAST_TEST_RIG_H

#include "fixcast/fixcast.h"
#include "fixcast/panel.h"
#include "virtual_bus.h"

enum {
  RIG_BYTES_MAX = 256 * 320 * 2
};

typedef struct rig {
  const fc_panel *record;
  virtual_panel *panel;
  virtual_bus bus;
  fc_panel_options options;
  fc_panel_state state;
  fc_display display;
  fc_display_capabilities can;
  uint8_t *picture; /* what was drawn: the whole display, without gaps */
} rig;

/* A rig of a panel, not started. One at a time. `rig_start` starts the panel; on success the capabilities are known. */
void rig_open(rig *it, const fc_panel *record, bool asynchronous, bool half_turn, bool twelve_bit);
int rig_start(rig *it);
void rig_close(rig *it);

/* Noise number `seed` into the picture. */
void rig_noise(rig *it, uint32_t seed);
/* Draws rows of the picture in strips; stops at an error and returns it. Asynchronous displays: with write_start from two buffers in turn. */
int rig_draw(rig *it, uint16_t strip_rows);
/* NULL when the glass shows the picture and nothing was complained of, else a sentence. */
const char *rig_verdict(rig *it);
/* What the eye should see of the picture at (x, y): 0xRRGGBB. */
uint32_t rig_colour(const rig *it, uint16_t x, uint16_t y);

#endif
