/* A spidev device (kernel documentation, "SPI userspace API"). */
#include "spi.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/spi/spidev.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include "devices.h"
#include "failure.h"
#include "fixcast/error.h"

enum {
  BUFSIZ_DEFAULT = 4096, /* of the spidev driver, where it does not tell */
  ALIGNMENT = 128,       /* the driver counts a transfer as so much longer that it ends on a boundary for DMA, 128 bytes on arm64 */
  BITS = 8
};

static const char bufsiz_path[] = "/sys/module/spidev/parameters/bufsiz";

/* The most bytes of one transfer; more is refused with EMSGSIZE. */
static size_t read_chunk_bytes(void) {
  FILE *file = fopen(bufsiz_path, "re");
  unsigned long bytes = 0;
  if (file != NULL) {
    if (fscanf(file, "%10lu", &bytes) != 1) bytes = 0;
    (void)fclose(file);
  }
  if (bytes == 0) bytes = BUFSIZ_DEFAULT;
  return bytes < ALIGNMENT ? bytes : bytes / ALIGNMENT * ALIGNMENT;
}

typedef struct name_list {
  char *to;
  size_t size, used;
} name_list;

static bool list_name(void *context, const char *path) {
  name_list *list = context;
  if (list->used + strlen(path) + sizeof ", " < list->size) {
    list->used += (size_t)snprintf(list->to + list->used, list->size - list->used, "%s%s", list->used != 0 ? ", " : "", path);
  }
  return true;
}

/* The spidev devices that exist, ", " between them, into `to`; empty when there are none. */
static void list_names(char *to, size_t size) {
  name_list list;
  list.to = to;
  list.size = size;
  list.used = 0;
  to[0] = '\0';
  (void)fc_linux_devices("spidev", list_name, &list);
}

static int open_failed(const char *path, int number, fc_linux_error *error) {
  char names[160], advice[192];
  switch (number) {
    case EACCES:
    case EPERM:
      fc_linux_permission_advice(path, advice, sizeof advice);
      return fc_linux_fail(error, number, "%s: open: %s; %s", path, strerror(number), advice);
    case ENOENT:
      list_names(names, sizeof names);
      if (names[0] != '\0') return fc_linux_fail(error, number, "%s: open: %s; there are %s", path, strerror(number), names);
      return fc_linux_fail(error, number, "%s: open: %s; there is no /dev/spidev* at all: switch SPI on (Raspberry Pi: dtparam=spi=on in config.txt)",
                           path, strerror(number));
    default:
      return fc_linux_fail(error, number, "%s: open: %s; is it a spidev device, its driver bound and no other program using it?", path,
                           strerror(number));
  }
}

int fc_linux_spi_open(const char *path, fc_linux_spi *spi, fc_linux_error *error) {
  uint32_t mode;
  memset(spi, 0, sizeof *spi);
  (void)snprintf(spi->path, sizeof spi->path, "%s", path);
  spi->file = open(path, O_RDWR | O_CLOEXEC);
  if (spi->file < 0) return open_failed(path, errno, error);
  if (ioctl(spi->file, SPI_IOC_RD_MODE32, &mode) != 0) {
    const int number = errno;
    fc_linux_spi_close(spi);
    return fc_linux_fail(error, number, "%s: SPI_IOC_RD_MODE32: %s; this is no spidev device: 'fixcast probe' lists them", path, strerror(number));
  }
  spi->chunk_bytes = read_chunk_bytes();
  return FC_OK;
}

void fc_linux_spi_close(fc_linux_spi *spi) {
  if (spi->file >= 0) (void)close(spi->file);
  spi->file = -1;
}

static int set_failed(const fc_linux_spi *spi, const char *call, unsigned long value, fc_linux_error *error) {
  const int number = errno;
  return fc_linux_fail(error, number, "%s: %s %lu: %s; the controller cannot do this: try another --hz or another device", spi->path, call, value,
                       strerror(number));
}

int fc_linux_spi_configure(fc_linux_spi *spi, uint32_t hz, uint8_t spi_mode, fc_linux_error *error) {
  uint32_t mode, read_back = 0;
  uint8_t bits = BITS;
  if (spi_mode != SPI_MODE_0 && spi_mode != SPI_MODE_3) {
    (void)fc_linux_fail(error, 0, "%s: SPI mode %d is none of 0 and 3", spi->path, spi_mode);
    return error->code = FC_ERR_UNSUPPORTED;
  }
  /* Mode 0 for either: both have data ready as the clock rises. For mode 3 the kernel's bit-banged bus raises the clock after it has selected the
   * chip, which takes that for the first bit. */
  /* What the device tree says of the wires (an inverted chip select, say) stays. */
  if (ioctl(spi->file, SPI_IOC_RD_MODE32, &mode) != 0) return set_failed(spi, "SPI_IOC_RD_MODE32", 0, error);
  mode &= ~(uint32_t)(SPI_CPHA | SPI_CPOL | SPI_LSB_FIRST);
  if (ioctl(spi->file, SPI_IOC_WR_MODE32, &mode) != 0) return set_failed(spi, "SPI_IOC_WR_MODE32", mode, error);
  if (ioctl(spi->file, SPI_IOC_WR_BITS_PER_WORD, &bits) != 0) return set_failed(spi, "SPI_IOC_WR_BITS_PER_WORD", bits, error);
  if (ioctl(spi->file, SPI_IOC_WR_MAX_SPEED_HZ, &hz) != 0) return set_failed(spi, "SPI_IOC_WR_MAX_SPEED_HZ", hz, error);
  if (ioctl(spi->file, SPI_IOC_RD_MAX_SPEED_HZ, &read_back) != 0) return set_failed(spi, "SPI_IOC_RD_MAX_SPEED_HZ", hz, error);
  spi->clock_hz = read_back;
  return FC_OK;
}

static uint64_t now_ns(void) {
  struct timespec now;
  (void)clock_gettime(CLOCK_MONOTONIC, &now);
  return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

static int send_failed(const fc_linux_spi *spi, int number, size_t sent, size_t count, size_t chunk, fc_linux_error *error) {
  const char *advice = "try a slower clock (--hz) and look at the kernel's log (dmesg)";
  if (number == EMSGSIZE) advice = "spidev takes less at a time than its parameter bufsiz says: start again, or boot with spidev.bufsiz=65536";
  if (number == ESHUTDOWN || number == ENODEV || number == ENXIO)
    advice = "the device has gone: is its driver still bound, the overlay still loaded?";
  return fc_linux_fail(error, number, "%s: SPI_IOC_MESSAGE of %lu bytes, after %lu of %lu: %s; %s", spi->path, (unsigned long)chunk,
                       (unsigned long)sent, (unsigned long)count, strerror(number), advice);
}

/* One message of one transfer an ioctl: below the 511 transfers that its size field can tell. */
int fc_linux_spi_send(fc_linux_spi *spi, const uint8_t *bytes, size_t count, fc_linux_error *error) {
  size_t sent = 0;
  int result = FC_OK;
  const uint64_t start = now_ns();
  while (sent < count && result == FC_OK) {
    const size_t left = count - sent, chunk = left < spi->chunk_bytes ? left : spi->chunk_bytes;
    struct spi_ioc_transfer transfer;
    int done;
    memset(&transfer, 0, sizeof transfer);
    transfer.tx_buf = (uintptr_t)(bytes + sent);
    transfer.len = (uint32_t)chunk;
    transfer.speed_hz = spi->clock_hz;
    transfer.bits_per_word = BITS;
    done = ioctl(spi->file, SPI_IOC_MESSAGE(1), &transfer);
    if (done > 0 && (size_t)done <= chunk) sent += (size_t)done; /* a short one is gone on from */
    else result = send_failed(spi, done < 0 ? errno : EIO, sent, count, chunk, error);
  }
  spi->sent_bytes += sent;
  spi->sending_ns += now_ns() - start;
  return result;
}
