/*
 * Stands in for main.c on the host, with -DDUMP: writes the frame to the file that the argument names, as
 * `fixcast compare --frame` reads it. A pixel is its object (16 bits) and light mask (32), both low byte first, then red,
 * green and blue.
 */
#include <stdio.h>

#include "renderer.h"

static uint8_t pixels[STRIP_ROWS * WIDTH * PIXEL_BYTES];
static uint16_t object[STRIP_ROWS * WIDTH];
static uint32_t lit[STRIP_ROWS * WIDTH];

void bench_put(const char *text) { (void)fputs(text, stderr); }

static int write_pixel(FILE *file, size_t i) {
  const uint8_t bytes[9] = {(uint8_t)object[i], (uint8_t)(object[i] >> 8), (uint8_t)lit[i],
                            (uint8_t)(lit[i] >> 8), (uint8_t)(lit[i] >> 16), (uint8_t)(lit[i] >> 24),
                            pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]};
  return fwrite(bytes, sizeof bytes, 1, file) != 1;
}

static int draw(FILE *file) {
  const strip to = {pixels, object, lit};
  uint16_t y, rows;
  size_t i;
  int failed = renderer_prepare() == 0 || renderer_setup() != 0;
  for (y = 0; !failed && y < HEIGHT; y = (uint16_t)(y + rows)) {
    rows = (uint16_t)(HEIGHT - y < STRIP_ROWS ? HEIGHT - y : STRIP_ROWS);
    failed = renderer_rows(y, rows, &to);
    for (i = 0; !failed && i < (size_t)rows * WIDTH; i++) failed = write_pixel(file, i);
  }
  return failed;
}

int main(int argc, char **argv) {
  FILE *file = argc == 2 ? fopen(argv[1], "wb") : NULL;
  int failed = file == NULL || draw(file) != 0;
  if (file != NULL && fclose(file) != 0) failed = 1;
  return failed;
}
