/*
 * A kernel for the Linux port's tests: spidev, GPIO chips and the calls that the port makes, with a virtual panel on the wires and faults on demand.
 *
 * The linker puts fake_kernel.c in place of the C library's calls (--wrap), and fake_gpiod_v1.c or _v2.c in place of libgpiod. It counts what is
 * open, so that nothing stays so.
 */
#ifndef FIXCAST_TEST_FAKE_KERNEL_H
#define FIXCAST_TEST_FAKE_KERNEL_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../panel/virtual_panel.h"

enum {
  FAKE_LINES = 8,
  FAKE_CHIPS = 2
};

typedef struct fake_line {
  const char *name;     /* NULL: it has none */
  const char *consumer; /* NULL: free */
  bool output, high, pull_up;
  unsigned requests; /* so far */
} fake_line;

typedef struct fake_chip {
  const char *path, *label;
  unsigned count;
  fake_line lines[FAKE_LINES];
  int open_error; /* errno of opening it; 0: it opens */
} fake_chip;

typedef struct fake_kernel {
  fake_chip chips[FAKE_CHIPS];
  unsigned chip_count;
  fake_line *dc, *reset; /* the panel's wires */
  /* spidev */
  bool spidev;        /* there is /dev/spidev0.0 */
  int spidev_error;   /* errno of opening it */
  const char *bufsiz; /* what the parameter's file says; NULL: no such file */
  size_t limit;       /* more bytes a message are refused with EMSGSIZE */
  size_t most;        /* a message sends no more than this and returns how many; 0: all */
  int message_error;  /* errno of the message number message_at, from 1, and of all later ones; 0: none fails */
  unsigned message_at;
  bool gated;                /* a message waits for fake_gate, but ends with EIO after ten seconds */
  bool slow;                 /* a message takes a millisecond before its bytes leave */
  uint32_t mode, hz, hz_max; /* registers; hz_max: above it the clock is refused with EINVAL */
  int line_error;            /* errno of setting or reading a line; 0: it works */
  int thread_error;          /* of starting a thread */
  /* the call number fail_at, from 1, of all that can fail, fails with EIO */
  unsigned calls, fail_at;
  /* counts */
  unsigned messages;
  size_t largest_message;
  int files, handles; /* open now: files; chips and requests of libgpiod */
  virtual_panel panel;
} fake_kernel;

extern fake_kernel kernel;
extern pthread_mutex_t fake_gate;

/* A board as it should be: named lines on the first chip, none on the second; no panel model. */
void fake_board(void);

/* For the fake libgpiod: whether this call is to fail; sets errno. */
bool fake_fails(void);
fake_chip *fake_chip_at(const char *path); /* NULL with errno set */
/* Takes a line: false with errno set when it is held. */
bool fake_take(fake_chip *chip, unsigned offset, const char *consumer, bool output, bool high, bool pull_up);
void fake_release(fake_line *line);
bool fake_drive(fake_line *line, bool high); /* false with errno set */
int fake_level(const fake_line *line);       /* -1 with errno set */

#endif
