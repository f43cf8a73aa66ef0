/* See queue.h. */
#include "queue.h"

#include "fixcast/error.h"

static void begin(fc_queue *queue);

/* Perhaps in an interrupt. */
static void one_sent(void *context, int error) {
  fc_queue *queue = context;
  if (error < 0 && queue->error == FC_OK) queue->error = error;
  queue->sent = (uint8_t)(queue->sent + 1u);
  begin(queue);
}

/* Starts the next strip, or stops. */
static void begin(fc_queue *queue) {
  const uint8_t next = queue->sent % FC_QUEUE_STRIPS;
  int error;
  if (queue->sent == queue->added || queue->error != FC_OK) {
    queue->running = 0;
    return;
  }
  error = fc_display_write_start(queue->display, &queue->strip[next].area, queue->strip[next].pixels, queue->strip[next].pitch_bytes,
                                 one_sent, queue);
  if (error < 0) {
    queue->error = error;
    queue->running = 0;
  }
}

void fc_queue_start(fc_queue *queue, const fc_display *display) {
  const fc_queue start = {.display = display};
  *queue = start;
}

int fc_queue_wait(fc_queue *queue, uint8_t left) {
  while (queue->error == FC_OK && (uint8_t)(queue->added - queue->sent) > left) {
    const int error = fc_display_wait(queue->display);
    if (error < 0 && queue->error == FC_OK) queue->error = error;
  }
  return queue->error;
}

void fc_queue_add(fc_queue *queue, const fc_area *area, const void *pixels, size_t pitch_bytes) {
  const uint8_t last = queue->added % FC_QUEUE_STRIPS;
  queue->strip[last].area = *area;
  queue->strip[last].pixels = pixels;
  queue->strip[last].pitch_bytes = pitch_bytes;
  /* An interrupt from here on takes it, if one comes; one that came before has left `running` 0. */
  queue->added = (uint8_t)(queue->added + 1u);
  if (queue->running) return;
  queue->running = 1;
  begin(queue);
}
