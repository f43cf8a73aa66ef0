/* How the port says that something failed. */
#include "failure.h"

#include <grp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

int fc_linux_fail(fc_linux_error *error, int number, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  (void)vsnprintf(error->text, sizeof error->text, format, arguments);
  va_end(arguments);
  error->code = FC_LINUX_ERROR(number);
  return error->code;
}

/* The file itself is read: getgrgid() of a statically linked program would want the shared C library. */
void fc_linux_group_name(unsigned long group, char *to, size_t size) {
  FILE *file = fopen("/etc/group", "re");
  const struct group *entry = NULL;
  if (file != NULL) {
    do entry = fgetgrent(file);
    while (entry != NULL && entry->gr_gid != group);
  }
  if (entry != NULL) (void)snprintf(to, size, "%s", entry->gr_name);
  else (void)snprintf(to, size, "%lu", group);
  if (file != NULL) (void)fclose(file);
}

void fc_linux_permission_advice(const char *path, char *to, size_t size) {
  struct stat status;
  char group[64];
  if (stat(path, &status) != 0 || status.st_gid == 0 || (status.st_mode & (S_IRGRP | S_IWGRP)) != (S_IRGRP | S_IWGRP)) {
    (void)snprintf(to, size, "only root may open it: run as root, or add a udev rule that gives it to a group of yours");
    return;
  }
  fc_linux_group_name(status.st_gid, group, sizeof group);
  (void)snprintf(to, size, "members of group '%s' may open it: 'sudo usermod -aG %s NAME', then log in again", group, group);
}
