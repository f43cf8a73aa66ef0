#include "serial.h"

#include "clock.h"
#include "lm3s6965.h"

enum {
  BAUD = 115200,
  PIN_RECEIVE = 1 << 0, /* port A */
  PIN_TRANSMIT = 1 << 1
};

void serial_start(void) {
  const uint32_t divider_64ths = (CPU_HZ * 4u + BAUD / 2u) / BAUD; /* of clock / (16 baud) [13.3.2] */
  SYSCTL_RCGC1 |= RCGC1_UART0;
  SYSCTL_RCGC2 |= RCGC2_GPIOA;
  (void)SYSCTL_RCGC2; /* a module may be used three cycles after its clock came on */
  GPIO_AFSEL(GPIO_A) |= PIN_RECEIVE | PIN_TRANSMIT;
  GPIO_DEN(GPIO_A) |= PIN_RECEIVE | PIN_TRANSMIT;
  UART0_CTL = 0;
  UART0_IBRD = divider_64ths / 64u;
  UART0_FBRD = divider_64ths % 64u;
  UART0_LCRH = LCRH_WLEN_8 | LCRH_FEN;
  UART0_CTL = UART_CTL_UARTEN | UART_CTL_TXE;
}

void serial_put(void *context, char c) {
  (void)context;
  while ((UART0_FR & FR_TXFF) != 0) {
  }
  UART0_DR = (uint8_t)c;
}
