/* What a board offers a display: GPIO chips and their lines, spidev devices, and who may open them. */
#ifndef FIXCAST_LINUX_PROBE_H
#define FIXCAST_LINUX_PROBE_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A device file. Texts are valid during the call only. */
typedef struct fc_linux_node {
  const char *path;
  const char *owner, *group; /* names, or numbers that have none */
  unsigned mode;             /* permission bits, such as 0660 */
  bool may_open;             /* by this process, to read and write */
} fc_linux_node;

typedef struct fc_linux_probe_calls {
  void (*spi)(void *context, const fc_linux_node *node);
  /* label is NULL and lines 0 where the chip could not be opened. */
  void (*chip)(void *context, const fc_linux_node *node, const char *label, unsigned lines);
  /* After its chip. name and consumer may be empty; used: somebody holds it. */
  void (*line)(void *context, unsigned offset, const char *name, const char *consumer, bool used, bool output);
} fc_linux_probe_calls;

/* Calls back for every spidev device, then for every chip, in the order of their numbers. Opens no spidev and requests no line. */
void fc_linux_probe(const fc_linux_probe_calls *calls, void *context);

/* The version of libgpiod that the program runs with, "1.6.3". */
const char *fc_linux_gpio_version(void);

#ifdef __cplusplus
}
#endif

#endif
