/* Strips that wait to be sent: the next one is started, from the interrupt, when one has left. */
#ifndef FIXCAST_FIRMWARE_QUEUE_H
#define FIXCAST_FIRMWARE_QUEUE_H

#include "fixcast/display.h"

enum {
  FC_QUEUE_STRIPS = 4
};

/*
 * Filled by fc_queue_start(); fields are private. One thread adds strips; `ready` of the display's transfers runs in an interrupt of that thread's
 * processor, or in fc_display_wait(), and starts the next transfer. fc_display_wait() has to return when one transfer has ended, also
 * when `ready` has started another.
 */
typedef struct fc_queue {
  const fc_display *display;
  struct {
    fc_area area;
    const void *pixels;
    size_t pitch_bytes;
  } strip[FC_QUEUE_STRIPS];
  volatile uint8_t added, sent; /* counted modulo 256; the strip number n is at n % FC_QUEUE_STRIPS */
  volatile uint8_t running;
  volatile int error; /* the first one: nothing is sent after it */
} fc_queue;

void fc_queue_start(fc_queue *queue, const fc_display *display);

/* Waits until at most `left` strips are not yet sent, 0 .. FC_QUEUE_STRIPS. The error of any strip, told until fc_queue_start(). */
int fc_queue_wait(fc_queue *queue, uint8_t left);

/* Adds a strip, whose pixels must stay until it is sent; at most FC_QUEUE_STRIPS may be unsent (fc_queue_wait). */
void fc_queue_add(fc_queue *queue, const fc_area *area, const void *pixels, size_t pitch_bytes);

#endif
