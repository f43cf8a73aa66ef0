/* GPIO lines by API 2 of libgpiod (2.0 and later). */
#include "gpio.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>

static int failed(void) { return errno > 0 ? -errno : -EIO; }

const char *fc_gpio_library_version(void) { return gpiod_api_version(); }

int fc_gpio_chip_open(const char *path, fc_gpio_chip *chip) {
  struct gpiod_chip *handle = gpiod_chip_open(path);
  struct gpiod_chip_info *info;
  if (handle == NULL) return failed();
  info = gpiod_chip_get_info(handle);
  if (info == NULL) {
    const int error = failed();
    gpiod_chip_close(handle);
    return error;
  }
  chip->handle = handle;
  chip->lines = (unsigned)gpiod_chip_info_get_num_lines(info);
  (void)snprintf(chip->label, sizeof chip->label, "%s", gpiod_chip_info_get_label(info));
  gpiod_chip_info_free(info);
  return 0;
}

void fc_gpio_chip_close(fc_gpio_chip *chip) {
  if (chip->handle != NULL) gpiod_chip_close(chip->handle);
  chip->handle = NULL;
}

int fc_gpio_line_info_get(const fc_gpio_chip *chip, unsigned offset, fc_gpio_line_info *info) {
  struct gpiod_line_info *line = gpiod_chip_get_line_info(chip->handle, offset);
  const char *name, *consumer;
  if (line == NULL) return failed();
  name = gpiod_line_info_get_name(line);
  consumer = gpiod_line_info_get_consumer(line);
  (void)snprintf(info->name, sizeof info->name, "%s", name != NULL ? name : "");
  (void)snprintf(info->consumer, sizeof info->consumer, "%s", consumer != NULL ? consumer : "");
  info->used = gpiod_line_info_is_used(line);
  info->output = gpiod_line_info_get_direction(line) == GPIOD_LINE_DIRECTION_OUTPUT;
  gpiod_line_info_free(line);
  return 0;
}

/* A request of one line; NULL with errno set on an error. */
static struct gpiod_line_request *request(struct gpiod_chip *chip, unsigned offset, const char *consumer, fc_gpio_use use) {
  struct gpiod_line_settings *settings = gpiod_line_settings_new();
  struct gpiod_line_config *lines = gpiod_line_config_new();
  struct gpiod_request_config *how = gpiod_request_config_new();
  struct gpiod_line_request *made = NULL;
  int error = ENOMEM;
  if (settings != NULL && lines != NULL && how != NULL) {
    int refused;
    if (use == FC_GPIO_INPUT_PULL_UP) {
      refused = gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_INPUT);
      if (refused == 0) refused = gpiod_line_settings_set_bias(settings, GPIOD_LINE_BIAS_PULL_UP);
    } else {
      refused = gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT);
      if (refused == 0) {
        refused = gpiod_line_settings_set_output_value(
            settings, use == FC_GPIO_OUTPUT_HIGH ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE);
      }
    }
    gpiod_request_config_set_consumer(how, consumer);
    if (refused == 0) refused = gpiod_line_config_add_line_settings(lines, &offset, 1, settings);
    if (refused == 0) made = gpiod_chip_request_lines(chip, how, lines);
    error = errno;
  }
  if (how != NULL) gpiod_request_config_free(how);
  if (lines != NULL) gpiod_line_config_free(lines);
  if (settings != NULL) gpiod_line_settings_free(settings);
  errno = error;
  return made;
}

int fc_gpio_request(const char *path, unsigned offset, const char *consumer, fc_gpio_use use, fc_gpio_line *line) {
  struct gpiod_chip *chip = gpiod_chip_open(path);
  struct gpiod_line_request *made;
  int error;
  if (chip == NULL) return failed();
  made = request(chip, offset, consumer, use);
  error = made == NULL ? failed() : 0;
  gpiod_chip_close(chip); /* a request lives without it */
  if (error != 0) return error;
  line->owner = made;
  line->line = made;
  line->offset = offset;
  return 0;
}

void fc_gpio_release(fc_gpio_line *line) {
  if (line->owner != NULL) gpiod_line_request_release(line->owner);
  line->owner = NULL;
  line->line = NULL;
}

int fc_gpio_set(const fc_gpio_line *line, bool high) {
  const enum gpiod_line_value value = high ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
  return gpiod_line_request_set_value(line->line, line->offset, value) != 0 ? failed() : 0;
}

int fc_gpio_get(const fc_gpio_line *line) {
  const enum gpiod_line_value value = gpiod_line_request_get_value(line->line, line->offset);
  if (value == GPIOD_LINE_VALUE_ERROR) return failed();
  return value == GPIOD_LINE_VALUE_ACTIVE;
}
