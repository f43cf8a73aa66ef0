/* What gpio_v1.c calls of libgpiod 1.6, over the fake kernel. */
#include <errno.h>
#include <gpiod.h>
#include <stdlib.h>

#include "fake_kernel.h"

struct gpiod_line {
  struct gpiod_chip *chip;
  unsigned offset;
  bool requested;
};
struct gpiod_chip {
  fake_chip *of;
  struct gpiod_line lines[FAKE_LINES];
};

static fake_line *line_of(struct gpiod_line *line) { return &line->chip->of->lines[line->offset]; }

const char *gpiod_version_string(void) { return "1.6.fake"; }

struct gpiod_chip *gpiod_chip_open(const char *path) {
  fake_chip *of = fake_chip_at(path);
  struct gpiod_chip *chip;
  if (of == NULL || fake_fails()) return NULL;
  chip = calloc(1, sizeof *chip);
  chip->of = of;
  kernel.handles++;
  return chip;
}

void gpiod_chip_close(struct gpiod_chip *chip) {
  for (unsigned i = 0; i < chip->of->count; i++)
    if (chip->lines[i].requested) fake_release(&chip->of->lines[i]);
  free(chip);
  kernel.handles--;
}

const char *gpiod_chip_label(struct gpiod_chip *chip) { return chip->of->label; }

unsigned int gpiod_chip_num_lines(struct gpiod_chip *chip) { return chip->of->count; }

struct gpiod_line *gpiod_chip_get_line(struct gpiod_chip *chip, unsigned int offset) {
  if (offset >= chip->of->count) errno = EINVAL;
  if (offset >= chip->of->count || fake_fails()) return NULL;
  chip->lines[offset].chip = chip;
  chip->lines[offset].offset = offset;
  return &chip->lines[offset];
}

const char *gpiod_line_name(struct gpiod_line *line) { return line_of(line)->name; }

const char *gpiod_line_consumer(struct gpiod_line *line) { return line_of(line)->consumer; }

bool gpiod_line_is_used(struct gpiod_line *line) { return line_of(line)->consumer != NULL; }

int gpiod_line_direction(struct gpiod_line *line) {
  return line_of(line)->output ? GPIOD_LINE_DIRECTION_OUTPUT : GPIOD_LINE_DIRECTION_INPUT;
}

static int request(struct gpiod_line *line, const char *consumer, bool output, bool high, bool pull_up) {
  if (fake_fails() || !fake_take(line->chip->of, line->offset, consumer, output, high, pull_up)) return -1;
  line->requested = true;
  return 0;
}

int gpiod_line_request_output(struct gpiod_line *line, const char *consumer, int value) { return request(line, consumer, true, value != 0, false); }

int gpiod_line_request_input_flags(struct gpiod_line *line, const char *consumer, int flags) {
  return request(line, consumer, false, false, flags == GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP);
}

int gpiod_line_set_value(struct gpiod_line *line, int value) { return !fake_fails() && fake_drive(line_of(line), value != 0) ? 0 : -1; }

int gpiod_line_get_value(struct gpiod_line *line) { return fake_fails() ? -1 : fake_level(line_of(line)); }
