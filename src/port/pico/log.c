#include "log.h"

#include "clocks.h"
#include "rp2040.h"

/* The divider in 1/64, rounded (4.2.7.1): clk_peri / (16 * baud). */
enum {
  DIVIDER_64 = (FCP_SYSTEM_HZ * 4 + FCP_LOG_BAUD / 2) / FCP_LOG_BAUD
};

void fcp_log_start(void) {
  fcp_reset_peripherals(RESETS_UART0);
  RP_REG(UART0_IBRD) = DIVIDER_64 / 64;
  RP_REG(UART0_FBRD) = DIVIDER_64 % 64;
  RP_REG(UART0_LCR_H) = UART_LCR_H_8BIT | UART_LCR_H_FEN; /* this write makes the dividers count */
  RP_REG(UART0_CR) = UART_CR_UARTEN | UART_CR_TXE | UART_CR_RXE;
}

void fcp_log_put(void *context, char character) {
  (void)context;
  while ((RP_REG(UART0_FR) & UART_FR_TXFF) != 0) continue;
  RP_REG(UART0_DR) = (uint8_t)character;
}

void fcp_log_wait(void) {
  while ((RP_REG(UART0_FR) & UART_FR_BUSY) != 0) continue;
}
