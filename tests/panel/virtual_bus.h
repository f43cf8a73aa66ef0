/*
 * fixcast's bus with a virtual panel at its end: synchronous, or asynchronous without threads; with faults on demand, and a filter for sabotage.
 *
 * An asynchronous transfer stays under way until the next bus call, or virtual_bus_run(), completes it; only then are its bytes read, and
 * compared with what they were when it was started.
 */
#ifndef FIXCAST_TEST_VIRTUAL_BUS_H
#define FIXCAST_TEST_VIRTUAL_BUS_H

#include "fixcast/bus.h"
#include "virtual_panel.h"

typedef enum virtual_fault {
  VIRTUAL_NO_FAULT = 0,
  VIRTUAL_FAIL,        /* the byte number fault_at is not sent, and its transfer fails with VIRTUAL_FAULT_CODE; so do later ones */
  VIRTUAL_READY_FAILS, /* a transfer that was started fails at that byte: data_start has returned FC_OK, `ready` and wait() tell */
  VIRTUAL_STUCK        /* a transfer that was started never ends: wait() gives up with FC_ERR_BUS */
} virtual_fault;
enum {
  VIRTUAL_FAULT_CODE = -4711 /* a port's own code */
};

typedef struct virtual_bus virtual_bus;
struct virtual_bus {
  fc_bus bus; /* give this to fc_panel_start */
  fc_bus_ops ops;
  virtual_panel *panel;
  /* faults */
  virtual_fault fault;
  uint64_t fault_at, bytes;         /* bytes sent so far */
  int configure_error, reset_error; /* returned by those, if not FC_OK */
  /* sabotage: may change a byte and its D/C, or have it left out (false); NULL: none */
  bool (*filter)(virtual_bus *bus, bool *data, uint8_t *byte);
  uint8_t last_command;   /* before the filter */
  uint64_t since_command; /* bytes since it */
  uint64_t filtered;      /* for the filter's own use */
  bool no_delays;         /* delays pass no time */
  /* the transfer under way */
  const uint8_t *under_way;
  uint8_t *as_started;
  size_t count, room;
  fc_ready *ready;
  void *ready_context;
  int transfer_error;
  /* what was asked */
  unsigned resets, readies, last_backlight;
};

/* Connects a bus to a panel. `asynchronous`: it has data_start and wait. The bus owns memory until virtual_bus_close. */
void virtual_bus_open(virtual_bus *bus, virtual_panel *panel, bool asynchronous);
void virtual_bus_close(virtual_bus *bus);
/* What is under way completes. */
void virtual_bus_run(virtual_bus *bus);

#endif
