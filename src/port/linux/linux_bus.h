/*
 * A bus (fixcast/bus.h) over Linux' spidev and GPIO character devices: what any board with SPI pins and a kernel offers.
 *
 * Transfers of data_start run on a second thread, so that a strip is sent while the next is rendered. The chip select belongs to the
 * kernel's SPI driver and is never requested here. Lines are given by the name that the board gives them ("GPIO25") or as
 * CHIPLABEL:OFFSET ("pinctrl-bcm2835:25"), never by the number of a chip, which differs from kernel to kernel.
 *
 * Functions return FC_OK or, when the system refused, FC_LINUX_ERROR(errno), which is below every fc_error; the sentence that says which call,
 * which device and what to do is in an fc_linux_error.
 */
#ifndef FIXCAST_LINUX_BUS_H
#define FIXCAST_LINUX_BUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fixcast/bus.h"

#ifdef __cplusplus
extern "C" {
#endif

/* errno is 0 where no call failed but what was asked for does not exist. */
#define FC_LINUX_ERROR(number) (-1000 - (number))

typedef struct fc_linux_error {
  int code;       /* FC_OK, or FC_LINUX_ERROR() of the errno of the call that failed */
  char text[640]; /* one sentence: what, where, what to do; no line break, no full stop */
} fc_linux_error;

/* Device and line names; they are not kept. */
typedef struct fc_linux_wiring {
  const char *spi;       /* "/dev/spidev0.0" */
  const char *dc;        /* data (high) / command (low) */
  const char *reset;     /* active low; NULL: not wired */
  const char *backlight; /* high is on; NULL: not wired */
} fc_linux_wiring;

typedef struct fc_linux_bus fc_linux_bus;

/*
 * Opens the device and requests the lines as outputs: command, reset not active, light off. NULL on an error, with *error filled and nothing
 * left open. A bus must be closed by fc_linux_bus_close(). Signals that are blocked by the caller stay blocked on the second thread:
 * block those that you handle.
 */
fc_linux_bus *fc_linux_bus_open(const fc_linux_wiring *wiring, fc_linux_error *error);

/* Waits for a transfer that is under way, releases the lines and closes the device. NULL is allowed. */
void fc_linux_bus_close(fc_linux_bus *bus);

/* The interface for panels. `bus` stays the owner and must live as long as it is used. */
fc_bus fc_linux_bus_ops(fc_linux_bus *bus);

/* What the last operation that failed has said; code is FC_OK when none has. Valid until the next call with this bus. */
const fc_linux_error *fc_linux_bus_error(const fc_linux_bus *bus);

typedef struct fc_linux_bus_figures {
  uint32_t clock_hz;   /* as the kernel gives it back; 0 before configure() */
  size_t chunk_bytes;  /* largest transfer, by spidev's parameter bufsiz */
  uint64_t sent_bytes; /* since the bus was opened */
  uint64_t sending_ns; /* time spent in transfers */
} fc_linux_bus_figures;

/* Only while nothing is under way. */
fc_linux_bus_figures fc_linux_bus_figures_get(const fc_linux_bus *bus);

/* A line that is read: a button to ground, with the board's pull-up where it has one. */
typedef struct fc_linux_input fc_linux_input;

/* NULL on an error, with *error filled. */
fc_linux_input *fc_linux_input_open(const char *name, fc_linux_error *error);
void fc_linux_input_close(fc_linux_input *input);

/* 1: high, 0: low, or an error with *error filled. */
int fc_linux_input_read(fc_linux_input *input, fc_linux_error *error);

#ifdef __cplusplus
}
#endif

#endif
