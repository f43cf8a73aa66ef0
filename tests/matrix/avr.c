/* Text and an exit code out of an emulated AVR: semihost.h on UART 0, whose lines simavr prints. */
#include "semihost.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

void semihost_char(int c) {
  while ((UCSR0A & _BV(UDRE0)) == 0) {
  }
  UCSR0B = _BV(TXEN0);
  UDR0 = (uint8_t)c;
}

void semihost_flush(void) {}

/* simavr ends when the chip sleeps with interrupts off; it has no exit code to give. */
void semihost_exit(int code) {
  const char *text = code == 0 ? "" : "failed\n";
  for (; *text != '\0'; text++) semihost_char(*text);
  cli();
  for (;;) sleep_mode();
}

/* Where avr-libc goes after main. */
void exit(int code) {
  semihost_exit(code);
  for (;;) {
  }
}
