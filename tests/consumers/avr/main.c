/* S1 on an ATmega, a row at a time; prints its golden line on UART 0. */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

#include "fixcast/fixcast.h"

enum {
  WIDTH = 32,
  HEIGHT = 24
};

extern const fc_scene s1;
extern const fc_camera s1_camera;

static void put(char character) {
  loop_until_bit_is_set(UCSR0A, UDRE0);
  UCSR0B = _BV(TXEN0);
  UDR0 = (uint8_t)character;
}

static void put_text(const char *text) {
  while (*text != '\0') put(*text++);
}

static uint32_t add_to_crc(uint32_t crc, const uint8_t *bytes, size_t count) {
  for (size_t i = 0; i < count; i++) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; bit++) crc = (crc >> 1) ^ ((crc & 1) != 0 ? UINT32_C(0xedb88320) : 0);
  }
  return crc;
}

int main(void) {
  static int64_t memory[20]; /* fc_frame_memory(&s1, NULL) says how many bytes */
  static uint8_t pixels[WIDTH * 2];
  static uint16_t depth[WIDTH];
  const fc_target row = {.pixels = pixels, .pitch_bytes = WIDTH * 2, .format = FC_RGB565_BE, .depth = depth};
  uint32_t crc = UINT32_C(0xffffffff);
  fc_frame frame;
  int error = fc_frame_setup(&frame, &s1, &s1_camera, NULL, WIDTH, HEIGHT, memory, sizeof memory);
  for (uint16_t y = 0; error == FC_OK && y < HEIGHT; y++) {
    error = fc_render_rows(&frame, y, 1, &row);
    crc = add_to_crc(crc, pixels, sizeof pixels);
  }
  if (error == FC_OK) {
    put_text("s1 32x24 0x");
    for (int8_t shift = 28; shift >= 0; shift -= 4) put("0123456789abcdef"[(~crc >> shift) & 15]);
  } else {
    put_text(fc_error_text(error));
  }
  put('\n');
  cli(); /* asleep without interrupts: the end, for an emulator too */
  for (;;) sleep_mode();
}
