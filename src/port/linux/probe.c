/* What a board offers a display. */
#include <pwd.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "devices.h"
#include "failure.h"
#include "gpio.h"
#include "linux_probe.h"

enum {
  NAME_TEXT = 64
};

typedef struct walk {
  const fc_linux_probe_calls *calls;
  void *context;
} walk;

/* As failure.c does for groups, and for the same reason. */
static void user_name(unsigned long user, char *to, size_t size) {
  FILE *file = fopen("/etc/passwd", "re");
  const struct passwd *entry = NULL;
  if (file != NULL) {
    do entry = fgetpwent(file);
    while (entry != NULL && entry->pw_uid != user);
  }
  if (entry != NULL) (void)snprintf(to, size, "%s", entry->pw_name);
  else (void)snprintf(to, size, "%lu", user);
  if (file != NULL) (void)fclose(file);
}

/* Fills *node, names into the two buffers; false when the file has gone. */
static bool look_at(const char *path, fc_linux_node *node, char *owner, char *group) {
  struct stat status;
  if (stat(path, &status) != 0) return false;
  user_name(status.st_uid, owner, NAME_TEXT);
  fc_linux_group_name(status.st_gid, group, NAME_TEXT);
  node->path = path;
  node->owner = owner;
  node->group = group;
  node->mode = status.st_mode & 07777u;
  node->may_open = access(path, R_OK | W_OK) == 0;
  return true;
}

static bool probe_spi(void *context, const char *path) {
  const walk *w = context;
  char owner[NAME_TEXT], group[NAME_TEXT];
  fc_linux_node node;
  if (look_at(path, &node, owner, group)) w->calls->spi(w->context, &node);
  return true;
}

static bool probe_chip(void *context, const char *path) {
  const walk *w = context;
  char owner[NAME_TEXT], group[NAME_TEXT];
  fc_linux_node node;
  fc_gpio_chip chip;
  unsigned offset;
  if (!look_at(path, &node, owner, group)) return true;
  if (fc_gpio_chip_open(path, &chip) != 0) {
    w->calls->chip(w->context, &node, NULL, 0);
    return true;
  }
  w->calls->chip(w->context, &node, chip.label, chip.lines);
  for (offset = 0; offset < chip.lines; offset++) {
    fc_gpio_line_info info;
    if (fc_gpio_line_info_get(&chip, offset, &info) == 0) {
      w->calls->line(w->context, offset, info.name, info.consumer, info.used, info.output);
    }
  }
  fc_gpio_chip_close(&chip);
  return true;
}

void fc_linux_probe(const fc_linux_probe_calls *calls, void *context) {
  walk w;
  w.calls = calls;
  w.context = context;
  (void)fc_linux_devices("spidev", probe_spi, &w);
  (void)fc_linux_devices("gpiochip", probe_chip, &w);
}

const char *fc_linux_gpio_version(void) { return fc_gpio_library_version(); }
