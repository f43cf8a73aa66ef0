/* Scene S1, drawn in strips of 8 rows that DMA sends while the next one is drawn. */
#include <stdio.h>

#include "fixcast/fixcast.h"
#include "fixcast/panel.h"
#include "pico/stdlib.h"
#include "s1.h"
#include "sdk_bus.h"

enum {
  WIDTH = 240,
  HEIGHT = 240,
  ROWS = 8
};

static int draw(const fc_display *display) {
  static int64_t memory[20]; /* fc_frame_memory(&s1, NULL) says how many bytes */
  static uint16_t pixels[2][WIDTH * ROWS], depth[WIDTH * ROWS];
  fc_frame frame;
  unsigned turn = 0;
  int error = fc_frame_setup(&frame, &s1, &s1_camera, NULL, WIDTH, HEIGHT, memory, sizeof memory);
  for (uint16_t y = 0; error == FC_OK && y < HEIGHT; y += ROWS, turn ^= 1) {
    const fc_area area = {.x = 0, .y = y, .width = WIDTH, .height = ROWS};
    const fc_target strip = {.pixels = pixels[turn], .pitch_bytes = WIDTH * 2, .format = FC_RGB565_BE, .depth = depth};
    error = fc_render_rows(&frame, y, ROWS, &strip);
    /* Waits for the strip before, whose buffer is the next one's. */
    if (error == FC_OK) error = fc_display_write_start(display, &area, pixels[turn], WIDTH * 2, NULL, NULL);
  }
  return error == FC_OK ? fc_display_wait(display) : error;
}

/* A function of its own, so that a debugger or an emulator can stop here to look at the panel. */
void __noinline frame_shown(unsigned number, uint32_t us) { printf("frame %u: %lu us\n", number, (unsigned long)us); }

int main(void) {
  fc_panel_state state;
  fc_display display;
  stdio_init_all();
  const fc_bus bus = sdk_bus_start();
  int error = fc_panel_start(&state, &fc_panel_st7789_240, &bus, NULL, &display);
  for (unsigned number = 0; error == FC_OK; number++) {
    const uint32_t began = time_us_32();
    error = draw(&display);
    if (error == FC_OK && number == 0) error = fc_display_backlight(&display, 255);
    if (error == FC_OK) frame_shown(number, time_us_32() - began);
  }
  printf("error %d: %s\n", error, fc_error_text(error));
  return 1;
}
