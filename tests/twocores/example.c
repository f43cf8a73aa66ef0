/*
 * S1 as an RP2040 draws it with both cores: core 1 takes the odd strips, each core owns one buffer, and DMA sends one while the
 * other is drawn. Threads stand in for the cores and for DMA here; prints S1's golden line. The part between the marks is README's.
 */
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "s1.h"

static void bus_wait_free(unsigned core);
static void bus_send(unsigned strip, unsigned core, const void *bytes, size_t count);

/* README: begin */
#include "fixcast/fixcast.h"

enum {
  WIDTH = 128,
  HEIGHT = 128,
  ROWS = 16
};

/* Core 0 runs this with 0, core 1 with 1. The frame was set up before and is only read. */
int draw_strips(const fc_frame *frame, unsigned core) {
  static uint16_t pixels[2][WIDTH * ROWS], depth[2][WIDTH * ROWS]; /* a buffer a core: 16 KB in all */
  const fc_target strip = {
      .pixels = pixels[core], .pitch_bytes = WIDTH * 2, .format = FC_RGB565_BE, .depth = depth[core]};
  for (unsigned i = core; i < HEIGHT / ROWS; i += 2) {
    int error;
    bus_wait_free(core); /* until DMA has read this core's last strip */
    error = fc_render_rows(frame, (uint16_t)(i * ROWS), ROWS, &strip);
    if (error != FC_OK) return error;
    bus_send(i, core, pixels[core], sizeof pixels[core]); /* waits for strip i - 1, starts DMA, returns */
  }
  return FC_OK;
}
/* README: end */

/* ---- what the chip has: two cores and DMA to the display. multicore_launch_core1, a DMA channel and its interrupt there. ---- */

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static struct {
  unsigned next;     /* strip that goes out next */
  bool busy[2];      /* a core's buffer waits for DMA, or is being read */
  unsigned core;     /* whose */
  const void *bytes; /* NULL: nothing to send */
  size_t count;
} bus;
static uint8_t screen[WIDTH * HEIGHT * 2];

static void bus_wait_free(unsigned core) {
  pthread_mutex_lock(&lock);
  while (bus.busy[core]) pthread_cond_wait(&changed, &lock);
  pthread_mutex_unlock(&lock);
}

static void bus_send(unsigned strip, unsigned core, const void *bytes, size_t count) {
  pthread_mutex_lock(&lock);
  while (bus.next != strip || bus.bytes != NULL) pthread_cond_wait(&changed, &lock);
  bus.busy[core] = true;
  bus.core = core;
  bus.bytes = bytes;
  bus.count = count;
  pthread_cond_broadcast(&changed);
  pthread_mutex_unlock(&lock);
}

static void *dma(void *unused) {
  size_t sent = 0;
  (void)unused;
  while (sent < sizeof screen) {
    pthread_mutex_lock(&lock);
    while (bus.bytes == NULL) pthread_cond_wait(&changed, &lock);
    pthread_mutex_unlock(&lock);
    memcpy(screen + sent, bus.bytes, bus.count);
    pthread_mutex_lock(&lock);
    sent += bus.count;
    bus.bytes = NULL;
    bus.busy[bus.core] = false;
    bus.next++;
    pthread_cond_broadcast(&changed);
    pthread_mutex_unlock(&lock);
  }
  return NULL;
}

static void *core1(void *frame) {
  int error = draw_strips(frame, 1);
  if (error != FC_OK) printf("core 1: %s\n", fc_error_text(error));
  return NULL;
}

static unsigned long crc_of(const uint8_t *bytes, size_t count) {
  unsigned long crc = 0xffffffff;
  size_t i;
  for (i = 0; i < count; i++) {
    int bit;
    crc ^= bytes[i];
    for (bit = 0; bit < 8; bit++) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320 : 0);
  }
  return crc ^ 0xffffffff;
}

int main(void) {
  static int64_t memory[20];
  static fc_frame frame;
  pthread_t threads[2];
  int error = fc_frame_setup(&frame, &s1, &s1_camera, NULL, WIDTH, HEIGHT, memory, sizeof memory);
  if (error != FC_OK) {
    printf("%s\n", fc_error_text(error));
    return 1;
  }
  if (pthread_create(&threads[0], NULL, dma, NULL) != 0 || pthread_create(&threads[1], NULL, core1, &frame) != 0) return 1;
  error = draw_strips(&frame, 0);
  pthread_join(threads[0], NULL);
  pthread_join(threads[1], NULL);
  printf("s1 128x128 0x%08lx\n", crc_of(screen, sizeof screen));
  return error != FC_OK;
}
