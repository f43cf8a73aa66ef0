/* A kernel for the Linux port's tests. */
#include "fake_kernel.h"

#include <dirent.h>
#include <errno.h>
#include <linux/spi/spidev.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <time.h>

enum {
  SPIDEV_FILE = 4711
};

static const char spidev_path[] = "/dev/spidev0.0";

fake_kernel kernel;
pthread_mutex_t fake_gate = PTHREAD_MUTEX_INITIALIZER;

void fake_board(void) {
  static const char *const names[FAKE_LINES] = {"SPI_SCLK", "SPI_MOSI", "SPI_CE0", "GPIO5", "GPIO25", "GPIO27", "GPIO18", "GPIO4"};
  memset(&kernel, 0, sizeof kernel);
  kernel.chip_count = 2;
  kernel.chips[0].path = "/dev/gpiochip0";
  kernel.chips[0].label = "soc-gpio";
  kernel.chips[0].count = FAKE_LINES;
  for (int i = 0; i < FAKE_LINES; i++) kernel.chips[0].lines[i].name = names[i];
  kernel.chips[0].lines[2].consumer = "spi0 CS0";
  kernel.chips[1].path = "/dev/gpiochip1";
  kernel.chips[1].label = "expander";
  kernel.chips[1].count = 4;
  kernel.dc = &kernel.chips[0].lines[4];
  kernel.reset = &kernel.chips[0].lines[5];
  kernel.spidev = true;
  kernel.bufsiz = "4096\n";
  kernel.limit = 4096;
  kernel.mode = SPI_CS_HIGH; /* as a device tree may say */
  kernel.hz_max = 125000000;
}

bool fake_fails(void) {
  if (++kernel.calls != kernel.fail_at) return false;
  errno = EIO;
  return true;
}

/* ---- lines ---- */

fake_chip *fake_chip_at(const char *path) {
  for (unsigned i = 0; i < kernel.chip_count; i++) {
    if (strcmp(path, kernel.chips[i].path) != 0) continue;
    errno = kernel.chips[i].open_error;
    return errno != 0 ? NULL : &kernel.chips[i];
  }
  errno = ENOENT;
  return NULL;
}

bool fake_take(fake_chip *chip, unsigned offset, const char *consumer, bool output, bool high, bool pull_up) {
  fake_line *line = &chip->lines[offset];
  if (line->consumer != NULL) {
    errno = EBUSY;
    return false;
  }
  line->consumer = consumer;
  line->requests++;
  line->output = output;
  line->pull_up = pull_up;
  if (output) line->high = high;
  return true;
}

void fake_release(fake_line *line) { line->consumer = NULL; }

bool fake_drive(fake_line *line, bool high) {
  errno = kernel.line_error;
  if (errno != 0) return false;
  line->high = high;
  if (line == kernel.reset && kernel.panel.model != NULL) virtual_reset(&kernel.panel, !high);
  return true;
}

int fake_level(const fake_line *line) {
  errno = kernel.line_error;
  return errno != 0 ? -1 : line->high;
}

/* ---- calls of the C library ---- */

int __real_ioctl(int file, unsigned long request, ...);
FILE *__real_fopen(const char *path, const char *how);
int __real_stat(const char *path, struct stat *status);
int __real_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *), void *argument);

int __wrap_open(const char *path, int flags, ...) {
  (void)flags;
  if (fake_fails()) return -1;
  errno = strcmp(path, spidev_path) != 0 || !kernel.spidev ? ENOENT : kernel.spidev_error;
  if (errno != 0) return -1;
  kernel.files++;
  return SPIDEV_FILE;
}

int __wrap_close(int file) {
  if (file == SPIDEV_FILE) kernel.files--;
  return 0;
}

static int message(const struct spi_ioc_transfer *transfer) {
  const uint8_t *bytes = (const uint8_t *)(uintptr_t)transfer->tx_buf;
  size_t count = transfer->len;
  kernel.messages++;
  if (count > kernel.largest_message) kernel.largest_message = count;
  errno = count > kernel.limit ? EMSGSIZE : kernel.message_error != 0 && kernel.messages >= kernel.message_at ? kernel.message_error
                                                                                                              : 0;
  if (errno != 0) return -1;
  if (kernel.gated) {
    struct timespec end;
    (void)clock_gettime(CLOCK_REALTIME, &end);
    end.tv_sec += 10;
    errno = pthread_mutex_timedlock(&fake_gate, &end) != 0 ? EIO : 0;
    if (errno != 0) return -1;
    (void)pthread_mutex_unlock(&fake_gate);
  }
  if (kernel.slow) {
    const struct timespec millisecond = {0, 1000000};
    (void)nanosleep(&millisecond, NULL);
  }
  if (kernel.most != 0 && count > kernel.most) count = kernel.most;
  if (kernel.panel.model != NULL) {
    virtual_clock(&kernel.panel, transfer->speed_hz, kernel.mode & 3);
    for (size_t i = 0; i < count; i++) virtual_feed(&kernel.panel, kernel.dc->high, bytes[i]);
  }
  return (int)count;
}

int __wrap_ioctl(int file, unsigned long request, ...) {
  va_list arguments;
  void *argument;
  va_start(arguments, request);
  argument = va_arg(arguments, void *);
  va_end(arguments);
  if (file != SPIDEV_FILE) return __real_ioctl(file, request, argument);
  if (fake_fails()) return -1;
  switch (request) {
    case SPI_IOC_RD_MODE32: memcpy(argument, &kernel.mode, sizeof kernel.mode); return 0;
    case SPI_IOC_WR_MODE32: memcpy(&kernel.mode, argument, sizeof kernel.mode); return 0;
    case SPI_IOC_WR_BITS_PER_WORD: return 0;
    case SPI_IOC_WR_MAX_SPEED_HZ: {
      uint32_t hz;
      memcpy(&hz, argument, sizeof hz);
      errno = hz > kernel.hz_max ? EINVAL : 0;
      kernel.hz = hz;
      return errno != 0 ? -1 : 0;
    }
    case SPI_IOC_RD_MAX_SPEED_HZ: memcpy(argument, &kernel.hz, sizeof kernel.hz); return 0;
    case SPI_IOC_MESSAGE(1): return message(argument);
    default: errno = ENOTTY; return -1;
  }
}

int __wrap_scandir(const char *directory, struct dirent ***entries, int (*filter)(const struct dirent *),
                   int (*compare)(const struct dirent **, const struct dirent **)) {
  const char *names[FAKE_CHIPS + 3];
  int count = 0;
  (void)directory;
  (void)filter;
  (void)compare;
  names[count++] = "console";
  for (unsigned i = 0; i < kernel.chip_count; i++) names[count++] = kernel.chips[i].path + strlen("/dev/");
  if (kernel.spidev) names[count++] = spidev_path + strlen("/dev/");
  names[count++] = "spidev-notes"; /* no device */
  *entries = malloc((size_t)count * sizeof **entries);
  for (int i = 0; i < count; i++) {
    (*entries)[i] = calloc(1, sizeof ***entries);
    strcpy((*entries)[i]->d_name, names[i]);
  }
  return count;
}

FILE *__wrap_fopen(const char *path, const char *how) {
  if (strcmp(path, "/sys/module/spidev/parameters/bufsiz") == 0) {
    errno = ENOENT;
    return kernel.bufsiz != NULL ? fmemopen((char *)(uintptr_t)kernel.bufsiz, strlen(kernel.bufsiz), "r") : NULL;
  }
  if (strcmp(path, "/etc/group") == 0) {
    static char groups[] = "root:x:0:\nspi:x:999:\ngpio:x:998:pi\n";
    return fmemopen(groups, strlen(groups), "r");
  }
  return __real_fopen(path, how);
}

int __wrap_stat(const char *path, struct stat *status) {
  if (strncmp(path, "/dev/", 5) != 0) return __real_stat(path, status);
  memset(status, 0, sizeof *status);
  status->st_mode = S_IFCHR | 0660;
  status->st_gid = strcmp(path, spidev_path) == 0 ? 999 : strcmp(path, "/dev/gpiochip0") == 0 ? 998
                                                                                              : 997;
  return 0;
}

int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *), void *argument) {
  if (kernel.thread_error != 0) return kernel.thread_error;
  return __real_pthread_create(thread, attributes, run, argument);
}

int __wrap_clock_nanosleep(clockid_t clock, int flags, const struct timespec *time, struct timespec *left) {
  (void)clock;
  (void)flags;
  (void)left;
  if (kernel.panel.model != NULL) virtual_time(&kernel.panel, (uint32_t)(time->tv_sec * 1000000 + (time->tv_nsec + 999) / 1000));
  return 0;
}
