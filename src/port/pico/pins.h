/*
 * What is wired to which pin of the Pico.
 *
 *   GPIO  pin of the board  signal       to
 *      0        1           UART0 TX     log, 115200 baud 8N1 (GPIO 1, pin 2, is RX and not used)
 *     14       19           button 1     other end to GND; pulled up, so 0 is pressed
 *     15       20           button 2     likewise
 *     16       21           D/C          display: DC, RS or A0
 *     17       22           CS           display: CS
 *     18       24           SPI0 SCK     display: SCL, SCK or CLK
 *     19       25           SPI0 TX      display: SDA, MOSI or DIN
 *     20       26           RST          display: RES or RST
 *     21       27           backlight    display: BLK, BL or LED, by its own transistor; 1 is on
 *      -       36           3V3          display: VCC
 *      -       38           GND          display: GND
 *
 * D/C, CS, RST and the backlight are plain outputs. At 62.5 MHz keep the wires to the display below 10 cm.
 */
#ifndef FIXCAST_PORT_PICO_PINS_H
#define FIXCAST_PORT_PICO_PINS_H

#include <stdbool.h>
#include <stdint.h>

enum {
  FCP_PIN_LOG = 0,
  FCP_PIN_BUTTON_1 = 14,
  FCP_PIN_BUTTON_2 = 15,
  FCP_PIN_DC = 16,
  FCP_PIN_CS = 17,
  FCP_PIN_SCK = 18,
  FCP_PIN_MOSI = 19,
  FCP_PIN_RESET = 20,
  FCP_PIN_BACKLIGHT = 21
};

/* Sets up all of the above: CS and RST high, the backlight off. */
void fcp_pins_start(void);

void fcp_pin_set(unsigned pin, bool high);

/* Bit 0: button 1 is pressed, bit 1: button 2. As they are now: bouncing is the caller's. */
unsigned fcp_buttons(void);

#endif
