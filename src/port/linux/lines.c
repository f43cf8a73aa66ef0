/* GPIO lines as people name them. */
#include "lines.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "devices.h"
#include "failure.h"
#include "fixcast/error.h"

enum {
  PATH_TEXT = 64,
  KNOWN_TEXT = 240 /* bytes of names that exist, for a message */
};

static const char consumer[] = "fixcast";

/* ---- a line by its name ---- */

typedef struct search {
  const char *name;
  const char *offset_text; /* what follows the last colon of the name, or NULL */
  size_t label_length;
  unsigned long offset;
  unsigned by_name, by_label;  /* how often found */
  unsigned label_lines;        /* of the chip with that label */
  char path[PATH_TEXT];        /* the first found */
  char chips[2][FC_GPIO_TEXT]; /* labels, to tell a name that is not unique */
  unsigned found_offset;
  char known[KNOWN_TEXT]; /* names that exist, or chips where lines have none */
  char denied[PATH_TEXT]; /* a chip that may not be opened */
} search;

static void search_start(search *s, const char *name) {
  const char *colon = strrchr(name, ':');
  memset(s, 0, sizeof *s);
  s->name = name;
  if (colon != NULL && colon != name && isdigit((unsigned char)colon[1])) {
    char *end;
    errno = 0;
    s->offset = strtoul(colon + 1, &end, 10);
    if (*end == '\0' && errno == 0 && s->offset < UINT_MAX) {
      s->offset_text = colon + 1;
      s->label_length = (size_t)(colon - name);
    }
  }
}

/* Appends ", text", or nothing when there is no room for it. */
static void mention(char *to, size_t size, const char *text) {
  const size_t used = strlen(to), more = strlen(text) + (used != 0 ? 2 : 0);
  if (used + more >= size) return;
  (void)snprintf(to + used, size - used, "%s%s", used != 0 ? ", " : "", text);
}

static void found(search *s, const char *path, unsigned offset) {
  (void)snprintf(s->path, sizeof s->path, "%s", path);
  s->found_offset = offset;
}

static void search_lines(search *s, const char *path, const fc_gpio_chip *chip) {
  unsigned offset, named = 0;
  for (offset = 0; offset < chip->lines; offset++) {
    fc_gpio_line_info info;
    if (fc_gpio_line_info_get(chip, offset, &info) != 0 || info.name[0] == '\0') continue;
    named++;
    if (!info.used) mention(s->known, sizeof s->known, info.name);
    if (strcmp(info.name, s->name) != 0) continue;
    if (s->by_name < 2) (void)snprintf(s->chips[s->by_name], sizeof s->chips[0], "%s", chip->label);
    if (s->by_name++ == 0) found(s, path, offset);
  }
  if (named == 0 && chip->lines != 0) {
    char range[3 * FC_GPIO_TEXT];
    (void)snprintf(range, sizeof range, "%s:0 to %s:%u", chip->label, chip->label, chip->lines - 1);
    mention(s->known, sizeof s->known, range);
  }
  if (s->offset_text != NULL && strlen(chip->label) == s->label_length && strncmp(chip->label, s->name, s->label_length) == 0) {
    s->label_lines = chip->lines;
    if (s->offset < chip->lines && s->by_label++ == 0 && s->by_name == 0) found(s, path, (unsigned)s->offset);
  }
}

static bool search_chip(void *context, const char *path) {
  search *s = context;
  fc_gpio_chip chip;
  const int error = fc_gpio_chip_open(path, &chip);
  if (error == -EACCES || error == -EPERM) (void)snprintf(s->denied, sizeof s->denied, "%s", path);
  if (error != 0) return true; /* of others: gone since, or no chip at all */
  search_lines(s, path, &chip);
  fc_gpio_chip_close(&chip);
  return true;
}

/* FC_OK with s->path and s->found_offset, or an error. */
static int find(search *s, const char *purpose, fc_linux_error *error) {
  const unsigned chips = fc_linux_devices("gpiochip", search_chip, s);
  if (s->by_name > 1) {
    return fc_linux_fail(error, 0, "%s line '%s': more than one line has this name, on chip '%s' and on '%s'; name it as CHIPLABEL:OFFSET", purpose,
                         s->name, s->chips[0], s->chips[1]);
  }
  if (s->by_name == 1 || s->by_label == 1) return FC_OK;
  if (s->by_label > 1) {
    return fc_linux_fail(error, 0, "%s line '%s': %u chips have this label; use a line's name, 'fixcast probe' lists them", purpose, s->name,
                         s->by_label);
  }
  if (s->denied[0] != '\0') {
    char advice[192];
    fc_linux_permission_advice(s->denied, advice, sizeof advice);
    return fc_linux_fail(error, EACCES, "%s line '%s': %s: open: %s; %s", purpose, s->name, s->denied, strerror(EACCES), advice);
  }
  if (chips == 0) {
    return fc_linux_fail(error, ENOENT, "%s line '%s': there is no /dev/gpiochip*; this kernel has no GPIO driver for the board", purpose, s->name);
  }
  if (s->label_lines != 0) {
    return fc_linux_fail(error, 0, "%s line '%s': chip '%.*s' has offsets 0 to %u only", purpose, s->name, (int)s->label_length, s->name,
                         s->label_lines - 1);
  }
  return fc_linux_fail(error, 0, "%s line '%s': no line has this name; free are %s%s", purpose, s->name,
                       s->known[0] != '\0' ? s->known : "none", "; 'fixcast probe' lists all");
}

/* Who holds a line, into `to`. */
static void holder(const char *path, unsigned offset, char *to, size_t size) {
  fc_gpio_chip chip;
  fc_gpio_line_info info;
  to[0] = '\0';
  if (fc_gpio_chip_open(path, &chip) != 0) return;
  if (fc_gpio_line_info_get(&chip, offset, &info) == 0) (void)snprintf(to, size, "%s", info.consumer);
  fc_gpio_chip_close(&chip);
}

int fc_linux_line_open(const char *name, const char *purpose, fc_gpio_use use, fc_linux_line *line, fc_linux_error *error) {
  search s;
  int result;
  search_start(&s, name);
  result = find(&s, purpose, error);
  if (result != FC_OK) return result;
  result = fc_gpio_request(s.path, s.found_offset, consumer, use, &line->gpio);
  if (result == 0) {
    (void)snprintf(line->name, sizeof line->name, "%s line '%s'", purpose, name);
    return FC_OK;
  }
  if (result == -EBUSY) {
    char who[FC_GPIO_TEXT];
    holder(s.path, s.found_offset, who, sizeof who);
    return fc_linux_fail(error, EBUSY, "%s line '%s' (%s, offset %u): request: %s; it is held by '%s': end that, or wire another line", purpose, name,
                         s.path, s.found_offset, strerror(EBUSY), who[0] != '\0' ? who : "unknown");
  }
  return fc_linux_fail(error, -result, "%s line '%s' (%s, offset %u): request: %s; wire another line, 'fixcast probe' lists them", purpose, name,
                       s.path, s.found_offset, strerror(-result));
}

void fc_linux_line_close(fc_linux_line *line) { fc_gpio_release(&line->gpio); }

static int lost(const fc_linux_line *line, const char *call, int number, fc_linux_error *error) {
  return fc_linux_fail(error, number, "%s: %s: %s; is the GPIO chip still there? 'fixcast probe' lists them", line->name, call, strerror(number));
}

int fc_linux_line_set(const fc_linux_line *line, bool high, fc_linux_error *error) {
  const int result = fc_gpio_set(&line->gpio, high);
  return result < 0 ? lost(line, "set value", -result, error) : FC_OK;
}

int fc_linux_line_get(const fc_linux_line *line, fc_linux_error *error) {
  const int result = fc_gpio_get(&line->gpio);
  return result < 0 ? lost(line, "get value", -result, error) : result;
}
