/* GPIO lines by API 1 of libgpiod (1.5 and 1.6). */
#include "gpio.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>

static int failed(void) { return errno > 0 ? -errno : -EIO; }

const char *fc_gpio_library_version(void) { return gpiod_version_string(); }

int fc_gpio_chip_open(const char *path, fc_gpio_chip *chip) {
  struct gpiod_chip *handle = gpiod_chip_open(path);
  if (handle == NULL) return failed();
  chip->handle = handle;
  chip->lines = gpiod_chip_num_lines(handle);
  (void)snprintf(chip->label, sizeof chip->label, "%s", gpiod_chip_label(handle));
  return 0;
}

void fc_gpio_chip_close(fc_gpio_chip *chip) {
  if (chip->handle != NULL) gpiod_chip_close(chip->handle);
  chip->handle = NULL;
}

int fc_gpio_line_info_get(const fc_gpio_chip *chip, unsigned offset, fc_gpio_line_info *info) {
  struct gpiod_line *line = gpiod_chip_get_line(chip->handle, offset);
  const char *name, *consumer;
  if (line == NULL) return failed();
  name = gpiod_line_name(line);
  consumer = gpiod_line_consumer(line);
  (void)snprintf(info->name, sizeof info->name, "%s", name != NULL ? name : "");
  (void)snprintf(info->consumer, sizeof info->consumer, "%s", consumer != NULL ? consumer : "");
  info->used = gpiod_line_is_used(line);
  info->output = gpiod_line_direction(line) == GPIOD_LINE_DIRECTION_OUTPUT;
  return 0;
}

int fc_gpio_request(const char *path, unsigned offset, const char *consumer, fc_gpio_use use, fc_gpio_line *line) {
  struct gpiod_chip *chip = gpiod_chip_open(path);
  struct gpiod_line *requested;
  int error;
  if (chip == NULL) return failed();
  requested = gpiod_chip_get_line(chip, offset);
  if (requested == NULL) {
    error = failed();
  } else if (use == FC_GPIO_INPUT_PULL_UP) {
    error = gpiod_line_request_input_flags(requested, consumer, GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP) != 0 ? failed() : 0;
  } else {
    error = gpiod_line_request_output(requested, consumer, use == FC_GPIO_OUTPUT_HIGH) != 0 ? failed() : 0;
  }
  if (error != 0) {
    gpiod_chip_close(chip);
    return error;
  }
  line->owner = chip;
  line->line = requested;
  line->offset = offset;
  return 0;
}

void fc_gpio_release(fc_gpio_line *line) {
  if (line->owner != NULL) gpiod_chip_close(line->owner); /* releases its lines too */
  line->owner = NULL;
  line->line = NULL;
}

int fc_gpio_set(const fc_gpio_line *line, bool high) { return gpiod_line_set_value(line->line, high) != 0 ? failed() : 0; }

int fc_gpio_get(const fc_gpio_line *line) {
  const int value = gpiod_line_get_value(line->line);
  return value < 0 ? failed() : value;
}
