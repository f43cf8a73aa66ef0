/* S1 as firmware would draw it, strip by strip; prints its golden line. The part between the marks is README's. */
#include <stdio.h>

#include "s1.h"

/* README: begin */
#include "fixcast/fixcast.h"

enum {
  WIDTH = 128,
  HEIGHT = 128,
  ROWS = 8
};

int draw(void (*send)(const uint8_t *bytes, size_t count)) {
  static int64_t memory[20]; /* fc_frame_memory(&s1, NULL) says how many bytes */
  static uint16_t pixels[WIDTH * ROWS], depth[WIDTH * ROWS], primitive[WIDTH * ROWS];
  fc_frame frame;
  fc_target strip = {.pixels = pixels,
                     .pitch_bytes = WIDTH * 2,
                     .format = FC_RGB565_BE,
                     .depth = depth,
                     .primitive = primitive};
  int error = fc_frame_setup(&frame, &s1, &s1_camera, NULL, WIDTH, HEIGHT, memory, sizeof memory);
  for (uint16_t y = 0; error == FC_OK && y < HEIGHT; y += ROWS) {
    error = fc_render_rows(&frame, y, ROWS, &strip);
    if (error == FC_OK) send((const uint8_t *)pixels, sizeof pixels);
  }
  return error;
}
/* README: end */

static unsigned long crc = 0xffffffff;

static void add_to_crc(const uint8_t *bytes, size_t count) {
  for (size_t i = 0; i < count; i++) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; bit++) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320 : 0);
  }
}

int main(void) {
  int error = draw(add_to_crc);
  if (error != FC_OK) {
    printf("%s\n", fc_error_text(error));
    return 1;
  }
  printf("s1 128x128 0x%08lx\n", crc ^ 0xffffffff);
  return 0;
}
