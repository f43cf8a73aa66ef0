/* A spidev device: mode and clock, and bytes in transfers as large as the kernel takes. */
#ifndef FIXCAST_LINUX_SPI_H
#define FIXCAST_LINUX_SPI_H

#include "linux_bus.h"

typedef struct fc_linux_spi {
  int file; /* -1: closed */
  char path[64];
  size_t chunk_bytes; /* largest transfer, by spidev's bufsiz */
  uint32_t clock_hz;  /* as read back; 0: not set yet */
  uint64_t sent_bytes, sending_ns;
} fc_linux_spi;

/* FC_OK or an error with *error filled, and nothing open. */
int fc_linux_spi_open(const char *path, fc_linux_spi *spi, fc_linux_error *error);
void fc_linux_spi_close(fc_linux_spi *spi);

/* FC_ERR_UNSUPPORTED for a mode that is not 0 or 3; otherwise as above. */
int fc_linux_spi_configure(fc_linux_spi *spi, uint32_t hz, uint8_t mode, fc_linux_error *error);

/* Returns when all bytes have left, or at the first error. */
int fc_linux_spi_send(fc_linux_spi *spi, const uint8_t *bytes, size_t count, fc_linux_error *error);

#endif
