/*
 * The few things that the port needs of libgpiod, the same over both of its APIs: gpio_v1.c is written against 1.6, gpio_v2.c
 * against 2.x, and the build takes the one whose header is installed.
 *
 * Functions that can fail return 0 or more, or a negative errno.
 */
#ifndef FIXCAST_LINUX_GPIO_H
#define FIXCAST_LINUX_GPIO_H

#include <stdbool.h>

enum {
  FC_GPIO_TEXT = 64 /* bytes of a name with its end; the kernel's are at most 32 */
};

typedef struct fc_gpio_chip {
  void *handle;
  unsigned lines;
  char label[FC_GPIO_TEXT];
} fc_gpio_chip;

typedef struct fc_gpio_line_info {
  char name[FC_GPIO_TEXT];     /* empty where the board has given none */
  char consumer[FC_GPIO_TEXT]; /* who holds it; empty when it is free or the kernel does not tell */
  bool used, output;
} fc_gpio_line_info;

typedef enum fc_gpio_use {
  FC_GPIO_OUTPUT_LOW,
  FC_GPIO_OUTPUT_HIGH,
  FC_GPIO_INPUT_PULL_UP /* where the chip has pull-ups */
} fc_gpio_use;

/* A line that was requested; the fields are gpio_v1.c's or gpio_v2.c's. All zero: none. */
typedef struct fc_gpio_line {
  void *owner, *line;
  unsigned offset;
} fc_gpio_line;

/* "1.6.3" */
const char *fc_gpio_library_version(void);

/* `path`: the chip's device file. */
int fc_gpio_chip_open(const char *path, fc_gpio_chip *chip);
void fc_gpio_chip_close(fc_gpio_chip *chip);
int fc_gpio_line_info_get(const fc_gpio_chip *chip, unsigned offset, fc_gpio_line_info *info);

/* Takes a line for this program, which the kernel shows as `consumer`; no chip need be open. */
int fc_gpio_request(const char *path, unsigned offset, const char *consumer, fc_gpio_use use, fc_gpio_line *line);
/* Gives it back; a line that is none is allowed. */
void fc_gpio_release(fc_gpio_line *line);
int fc_gpio_set(const fc_gpio_line *line, bool high);
int fc_gpio_get(const fc_gpio_line *line);

#endif
