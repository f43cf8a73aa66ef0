/* What gpio_v2.c calls of libgpiod 2, over the fake kernel. */
#include <errno.h>
#include <gpiod.h>
#include <stdlib.h>

#include "fake_kernel.h"

struct gpiod_chip {
  fake_chip *of;
};
struct gpiod_chip_info {
  fake_chip *of;
};
struct gpiod_line_info {
  fake_line of;
};
struct gpiod_line_settings {
  bool output, high, pull_up;
};
struct gpiod_line_config {
  unsigned offset;
  struct gpiod_line_settings settings;
};
struct gpiod_request_config {
  const char *consumer;
};
struct gpiod_line_request {
  fake_line *of;
  unsigned offset;
};

/* Each object is counted: none may be left. */
static void *make(size_t size) {
  if (fake_fails()) return NULL;
  kernel.handles++;
  return calloc(1, size);
}

static void end(void *object) {
  free(object);
  kernel.handles--;
}

const char *gpiod_api_version(void) { return "2.fake"; }

struct gpiod_chip *gpiod_chip_open(const char *path) {
  fake_chip *of = fake_chip_at(path);
  struct gpiod_chip *chip = of != NULL ? make(sizeof *chip) : NULL;
  if (chip != NULL) chip->of = of;
  return chip;
}

void gpiod_chip_close(struct gpiod_chip *chip) { end(chip); }

struct gpiod_chip_info *gpiod_chip_get_info(struct gpiod_chip *chip) {
  struct gpiod_chip_info *info = make(sizeof *info);
  if (info != NULL) info->of = chip->of;
  return info;
}

void gpiod_chip_info_free(struct gpiod_chip_info *info) { end(info); }

const char *gpiod_chip_info_get_label(struct gpiod_chip_info *info) { return info->of->label; }

size_t gpiod_chip_info_get_num_lines(struct gpiod_chip_info *info) { return info->of->count; }

struct gpiod_line_info *gpiod_chip_get_line_info(struct gpiod_chip *chip, unsigned int offset) {
  struct gpiod_line_info *info;
  errno = EINVAL;
  info = offset < chip->of->count ? make(sizeof *info) : NULL;
  if (info != NULL) info->of = chip->of->lines[offset];
  return info;
}

void gpiod_line_info_free(struct gpiod_line_info *info) { end(info); }

const char *gpiod_line_info_get_name(struct gpiod_line_info *info) { return info->of.name; }

const char *gpiod_line_info_get_consumer(struct gpiod_line_info *info) { return info->of.consumer; }

bool gpiod_line_info_is_used(struct gpiod_line_info *info) { return info->of.consumer != NULL; }

enum gpiod_line_direction gpiod_line_info_get_direction(struct gpiod_line_info *info) {
  return info->of.output ? GPIOD_LINE_DIRECTION_OUTPUT : GPIOD_LINE_DIRECTION_INPUT;
}

struct gpiod_line_settings *gpiod_line_settings_new(void) {
  return make(sizeof(struct gpiod_line_settings));
}

void gpiod_line_settings_free(struct gpiod_line_settings *settings) { end(settings); }

int gpiod_line_settings_set_direction(struct gpiod_line_settings *settings, enum gpiod_line_direction direction) {
  settings->output = direction == GPIOD_LINE_DIRECTION_OUTPUT;
  return fake_fails() ? -1 : 0;
}

int gpiod_line_settings_set_bias(struct gpiod_line_settings *settings, enum gpiod_line_bias bias) {
  settings->pull_up = bias == GPIOD_LINE_BIAS_PULL_UP;
  return fake_fails() ? -1 : 0;
}

int gpiod_line_settings_set_output_value(struct gpiod_line_settings *settings, enum gpiod_line_value value) {
  settings->high = value == GPIOD_LINE_VALUE_ACTIVE;
  return fake_fails() ? -1 : 0;
}

struct gpiod_line_config *gpiod_line_config_new(void) {
  return make(sizeof(struct gpiod_line_config));
}

void gpiod_line_config_free(struct gpiod_line_config *config) { end(config); }

int gpiod_line_config_add_line_settings(struct gpiod_line_config *config, const unsigned int *offsets, size_t count,
                                        struct gpiod_line_settings *settings) {
  if (fake_fails() || count != 1) return -1;
  config->offset = offsets[0];
  config->settings = *settings;
  return 0;
}

struct gpiod_request_config *gpiod_request_config_new(void) {
  return make(sizeof(struct gpiod_request_config));
}

void gpiod_request_config_free(struct gpiod_request_config *config) { end(config); }

void gpiod_request_config_set_consumer(struct gpiod_request_config *config, const char *consumer) { config->consumer = consumer; }

struct gpiod_line_request *gpiod_chip_request_lines(struct gpiod_chip *chip, struct gpiod_request_config *how, struct gpiod_line_config *lines) {
  struct gpiod_line_request *request;
  const struct gpiod_line_settings *settings = &lines->settings;
  if (lines->offset >= chip->of->count) {
    errno = EINVAL;
    return NULL;
  }
  request = make(sizeof *request);
  if (request == NULL) return NULL;
  if (!fake_take(chip->of, lines->offset, how->consumer, settings->output, settings->high, settings->pull_up)) {
    const int number = errno;
    end(request);
    errno = number;
    return NULL;
  }
  request->of = &chip->of->lines[lines->offset];
  request->offset = lines->offset;
  return request;
}

void gpiod_line_request_release(struct gpiod_line_request *request) {
  fake_release(request->of);
  end(request);
}

int gpiod_line_request_set_value(struct gpiod_line_request *request, unsigned int offset, enum gpiod_line_value value) {
  errno = EINVAL;
  return offset == request->offset && !fake_fails() && fake_drive(request->of, value == GPIOD_LINE_VALUE_ACTIVE) ? 0 : -1;
}

enum gpiod_line_value gpiod_line_request_get_value(struct gpiod_line_request *request, unsigned int offset) {
  int level;
  errno = EINVAL;
  if (offset != request->offset || fake_fails()) return GPIOD_LINE_VALUE_ERROR;
  level = fake_level(request->of);
  return level < 0 ? GPIOD_LINE_VALUE_ERROR : level ? GPIOD_LINE_VALUE_ACTIVE
                                                    : GPIOD_LINE_VALUE_INACTIVE;
}
