/*
 * The demo on TI's LM3S6965 evaluation board (first revision, with the Osram OLED of 128x64 and an SSD0323; later ones have another display).
 *
 * Wiring, all on the board (EVB user's manual, schematics):
 *   OLED clock   PA2 SSI0Clk     OLED power   PC6, high: 15 V on
 *   OLED CS      PA3 SSI0Fss     OLED reset   the board's reset
 *   OLED data    PA5 SSI0Tx      SD card CS   PD0, kept high: on the same SSI
 *   OLED D/C     PC7, low: command
 *   serial       PA0, PA1 UART 0, 115200 baud, by USB
 *   buttons, low when held: up PE0 faster, down PE1 slower, left PE2 reverse, right PE3 pattern, select PF1 pause
 */
#include "buttons.h"
#include "clock.h"
#include "firmware.h"
#include "serial.h"
#include "ssi.h"
#include "start.h"

enum {
  WIDTH = 128,
  STRIP_ROWS = 16
};

static int64_t memory[(FC_FIRMWARE_MEMORY_GREY4(WIDTH, STRIP_ROWS) + 7) / 8];

int main(void) {
  const fc_firmware_board board = {.name = "lm3s6965evb",
                                   .panel = &fc_panel_ssd0323,
                                   .bus = ssi_bus,
                                   .put = serial_put,
                                   .microseconds = clock_microseconds,
                                   .cycles = clock_cycles,
                                   .buttons = buttons_read,
                                   .ram_bytes = start_ram_bytes,
                                   .cpu_hz = CPU_HZ,
                                   .strip_rows = STRIP_ROWS,
                                   .pattern_ms = 1000,
                                   .memory = memory,
                                   .memory_bytes = sizeof memory};
  clock_start();
  serial_start();
  buttons_start();
  ssi_start();
  return fc_firmware_run(&board);
}
