/*
 * Renders one baked scene strip by strip, as a chip with little RAM does, and prints a line of crc.txt:
 * scene, size, CRC of the RGB565 big-endian frame. The same file runs on the host and on emulated chips.
 *
 * -DSCENE=s1 -DWIDTH=128 -DHEIGHT=128; for very small chips also -DSTRIP_ROWS=1 -DMEMORY_BYTES=2048
 */
#include "fixcast/fixcast.h"

#ifdef FIXCAST_BAREMETAL
#include "semihost.h"
#define PUT(c) semihost_char(c)
#else
#include <stdio.h>
#define PUT(c) ((void)putchar(c))
#endif

#define PASTE2(a, b) a##b
#define PASTE(a, b) PASTE2(a, b)
#define TEXT2(a) #a
#define TEXT(a) TEXT2(a)
#define CAMERA PASTE(SCENE, _camera)

extern const fc_scene SCENE;
extern const fc_camera CAMERA;

#ifndef STRIP_ROWS
#define STRIP_ROWS 8
#endif
#ifndef MEMORY_BYTES
#define MEMORY_BYTES 24576
#endif

static int64_t memory[MEMORY_BYTES / 8];
static uint8_t pixels[STRIP_ROWS * WIDTH * 2];
static uint16_t depth[STRIP_ROWS * WIDTH], primitive[STRIP_ROWS * WIDTH];

static void put(const char *text) {
  for (; *text != '\0'; text++) PUT(*text);
}

static void put_hex(uint32_t value) {
  int i;
  for (i = 28; i >= 0; i -= 4) PUT("0123456789abcdef"[(value >> i) & 15]);
}

/* zlib's CRC-32, bit by bit. */
static uint32_t crc32(uint32_t crc, const uint8_t *bytes, size_t count) {
  crc = ~crc;
  while (count-- > 0) {
    int bit;
    crc ^= *bytes++;
    for (bit = 0; bit < 8; bit++) crc = (crc >> 1) ^ ((crc & 1) != 0 ? UINT32_C(0xedb88320) : 0);
  }
  return ~crc;
}

static int failed(int error) {
  put("error: ");
  put(fc_error_text(error));
  put("\n");
  return 1;
}

int main(void) {
  fc_frame frame;
  fc_target target = {0};
  uint32_t crc = 0;
  uint16_t y, rows;
  int error = fc_frame_setup(&frame, &SCENE, &CAMERA, NULL, WIDTH, HEIGHT, memory, sizeof memory);
  if (error < 0) return failed(error);
  target.pixels = pixels;
  target.pitch_bytes = WIDTH * 2;
  target.format = FC_RGB565_BE;
  target.depth = depth;
  target.primitive = primitive;
  for (y = 0; y < HEIGHT; y = (uint16_t)(y + rows)) {
    rows = (uint16_t)(HEIGHT - y < STRIP_ROWS ? HEIGHT - y : STRIP_ROWS);
    error = fc_render_rows(&frame, y, rows, &target);
    if (error < 0) return failed(error);
    crc = crc32(crc, pixels, (size_t)rows * WIDTH * 2);
  }
  put(TEXT(SCENE) " " TEXT(WIDTH) "x" TEXT(HEIGHT) " 0x");
  put_hex(crc);
  put("\n");
  return 0;
}
