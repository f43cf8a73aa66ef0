/* The log: characters out of UART0. */
#ifndef FIXCAST_PORT_PICO_LOG_H
#define FIXCAST_PORT_PICO_LOG_H

enum {
  FCP_LOG_BAUD = 115200
};

/* After fcp_clocks_start() and fcp_pins_start(). */
void fcp_log_start(void);

/* Waits for room in the FIFO of 32 characters: 87 us a character when that is full. `context` is not used, here and in time.h
 * and start.h: these are functions of fc_firmware_board. */
void fcp_log_put(void *context, char character);

/* Until the last stop bit has left. */
void fcp_log_wait(void);

#endif
