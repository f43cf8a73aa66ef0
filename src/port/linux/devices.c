/* The device files of a kind. */
#include "devices.h"

#include <ctype.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

unsigned fc_linux_devices(const char *prefix, fc_linux_each_device *each, void *context) {
  struct dirent **entries = NULL;
  const int count = scandir("/dev", &entries, NULL, versionsort);
  const size_t length = strlen(prefix);
  unsigned found = 0;
  bool going = true;
  int i;
  for (i = 0; i < count; i++) {
    const char *name = entries[i]->d_name;
    if (strncmp(name, prefix, length) == 0 && isdigit((unsigned char)name[length])) {
      char path[sizeof "/dev/" + sizeof entries[i]->d_name];
      (void)snprintf(path, sizeof path, "/dev/%s", name);
      found++;
      if (going) going = each(context, path);
    }
    free(entries[i]);
  }
  free(entries);
  return found;
}
