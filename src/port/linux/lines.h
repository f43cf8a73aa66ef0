/* GPIO lines as people name them: found on whichever chip has them, requested, and the sentences when that fails. */
#ifndef FIXCAST_LINUX_LINES_H
#define FIXCAST_LINUX_LINES_H

#include "gpio.h"
#include "linux_bus.h"

/* A line and what it is called in messages. All zero: none. */
typedef struct fc_linux_line {
  fc_gpio_line gpio;
  char name[2 * FC_GPIO_TEXT];
} fc_linux_line;

/* `name`: a line's name, or CHIPLABEL:OFFSET. `purpose` says in messages what the line is for ("D/C"). FC_OK or an error with *error filled. */
int fc_linux_line_open(const char *name, const char *purpose, fc_gpio_use use, fc_linux_line *line, fc_linux_error *error);
void fc_linux_line_close(fc_linux_line *line);
int fc_linux_line_set(const fc_linux_line *line, bool high, fc_linux_error *error);
/* 0, 1, or an error. */
int fc_linux_line_get(const fc_linux_line *line, fc_linux_error *error);

#endif
