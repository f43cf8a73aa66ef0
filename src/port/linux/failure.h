/* How the port says that something failed: an error code and one sentence. */
#ifndef FIXCAST_LINUX_FAILURE_H
#define FIXCAST_LINUX_FAILURE_H

#include "linux_bus.h"

#if defined(__GNUC__)
#define FC_PRINTF_LIKE __attribute__((format(printf, 3, 4)))
#else
#define FC_PRINTF_LIKE
#endif

/* Fills *error and returns its code. The sentence is what `format` makes of the rest. */
int fc_linux_fail(fc_linux_error *error, int number, const char *format, ...) FC_PRINTF_LIKE;

/* What to do about a device file that may not be opened: a phrase that names the group that may, into `to`. */
void fc_linux_permission_advice(const char *path, char *to, size_t size);

/* The name of a group id into `to`, or its number where the group file does not know it. */
void fc_linux_group_name(unsigned long group, char *to, size_t size);

#endif
