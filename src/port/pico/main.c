/*
 * The demo on a Raspberry Pi Pico with an ST7789 on SPI0; the wiring is in pins.h.
 *
 * Options of the build (-D):
 *   PICO_ST7789_135      a glass of 135x240 instead of 240x240
 *   PICO_PIXEL_HZ=N      another clock for pixels, in Hz; the fastest that is not above N is taken
 *   PICO_HALF_TURN       the picture upside down
 *   PICO_TWO_CORES       core 1 draws half the rows of each strip
 */
#include "clocks.h"
#include "cores.h"
#include "firmware.h"
#include "log.h"
#include "pins.h"
#include "spi_bus.h"
#include "start.h"
#include "time.h"

#ifdef PICO_ST7789_135
enum {
  WIDTH = 135,
  STRIP_ROWS = 16,
  BUFFERS = 3
};
#define PANEL fc_panel_st7789_135
#else
enum {
  WIDTH = 240,
#ifdef PICO_TWO_CORES
  STRIP_ROWS = 6, /* core 1's stack and scratch have to fit 24 KB too */
#else
  STRIP_ROWS = 8,
#endif
  BUFFERS = 3
};
#define PANEL fc_panel_st7789_240
#endif

#ifndef PICO_PIXEL_HZ
#define PICO_PIXEL_HZ 0
#endif

enum {
  MEMORY_BYTES = FC_FIRMWARE_MEMORY(WIDTH, STRIP_ROWS) + (BUFFERS - 2) * FC_FIRMWARE_MEMORY_BUFFER(WIDTH, STRIP_ROWS)
};
static int64_t memory[(MEMORY_BYTES + 7) / 8];

static uint8_t buttons(void *context) {
  const unsigned held = fcp_buttons();
  (void)context;
  return (uint8_t)((held & 1 ? FC_BUTTON_PAUSE : 0) | (held & 2 ? FC_BUTTON_REVERSE : 0));
}

int main(void) {
  fc_firmware_board board = {.name = "pico",
                             .panel = &PANEL,
                             .options = {.pixel_hz = PICO_PIXEL_HZ},
                             .put = fcp_log_put,
                             .microseconds = fcp_microseconds,
                             .cycles = fcp_cycles,
                             .buttons = buttons,
                             .ram_bytes = fcp_ram_bytes,
                             .cpu_hz = FCP_SYSTEM_HZ,
                             .strip_rows = STRIP_ROWS,
                             .buffers = BUFFERS,
                             .alternate = 1,
                             .pattern_ms = 1000,
                             .memory = memory,
                             .memory_bytes = sizeof memory};
#ifdef PICO_HALF_TURN
  board.options.half_turn = 1;
#endif
  fcp_clocks_start();
  fcp_pins_start();
  fcp_log_start();
  fcp_cycles_start();
#ifdef PICO_TWO_CORES
  fcp_cores_start();
  board.render = fcp_cores_render;
#endif
  board.bus = fcp_spi_bus_start();
  return fc_firmware_run(&board);
}
