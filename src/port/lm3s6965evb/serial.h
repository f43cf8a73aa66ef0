/* Text on UART 0 (the board's USB serial port): 115200 baud, 8 bits, no parity, 1 stop bit. */
#ifndef FIXCAST_LM3S6965_SERIAL_H
#define FIXCAST_LM3S6965_SERIAL_H

/* After clock_start(). */
void serial_start(void);

/* Waits while the FIFO of 16 is full. */
void serial_put(void *context, char c);

#endif
