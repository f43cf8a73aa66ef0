/* The device files of a kind, in the order of their numbers. */
#ifndef FIXCAST_LINUX_DEVICES_H
#define FIXCAST_LINUX_DEVICES_H

#include <stdbool.h>

/* False ends the walk. `path` is valid during the call only. */
typedef bool fc_linux_each_device(void *context, const char *path);

/* /dev/PREFIX followed by a digit. Returns how many there are. */
unsigned fc_linux_devices(const char *prefix, fc_linux_each_device *each, void *context);

#endif
