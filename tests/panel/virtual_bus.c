/* A bus with a virtual panel at its end. */
#include "virtual_bus.h"

#include <stdlib.h>
#include <string.h>

#include "fixcast/error.h"

static bool failing(const virtual_bus *bus, virtual_fault fault) {
  return bus->fault == fault && bus->bytes >= bus->fault_at;
}

/* Bytes to the panel until they are all sent, or `fault` strikes. */
static int send(virtual_bus *bus, bool data, const uint8_t *bytes, size_t count, virtual_fault fault) {
  size_t i;
  for (i = 0; i < count; i++) {
    bool level = data;
    uint8_t byte = bytes[i];
    if (failing(bus, fault)) return VIRTUAL_FAULT_CODE;
    bus->bytes++;
    if (!data)
      bus->last_command = byte, bus->since_command = 0;
    else
      bus->since_command++;
    if (bus->filter == NULL || bus->filter(bus, &level, &byte)) virtual_feed(bus->panel, level, byte);
  }
  return failing(bus, fault) ? VIRTUAL_FAULT_CODE
                             : FC_OK; /* a fault after the last byte is one of this transfer too */
}

static void complete(virtual_bus *bus, int error) {
  fc_ready *const ready = bus->ready;
  bus->transfer_error = error;
  bus->under_way = NULL;
  bus->readies++;
  if (ready != NULL) ready(bus->ready_context, error);
}

void virtual_bus_run(virtual_bus *bus) {
  if (bus->under_way == NULL || bus->fault == VIRTUAL_STUCK) return;
  if (memcmp(bus->under_way, bus->as_started, bus->count) != 0)
    virtual_complain(bus->panel, "the pixels were changed while they were under way");
  complete(bus, send(bus, true, bus->under_way, bus->count, VIRTUAL_READY_FAILS));
}

static int bus_wait(void *context) {
  virtual_bus *bus = context;
  const unsigned before = bus->readies;
  virtual_bus_run(bus);
  if (bus->under_way != NULL && bus->readies == before) complete(bus, FC_ERR_BUS); /* stuck: the port gives up */
  /* as some ports do, until the next start: callers must not ask twice */
  return bus->transfer_error;
}

static int transfer(virtual_bus *bus, bool data, const uint8_t *bytes, size_t count) {
  virtual_bus_run(bus);
  if (bus->under_way != NULL) return bus_wait(bus);
  if (count == 0 || bytes == NULL) virtual_complain(bus->panel, "the bus was asked to send nothing");
  return send(bus, data, bytes, count, VIRTUAL_FAIL);
}

static int bus_command(void *context, const uint8_t *bytes, size_t count) {
  return transfer(context, false, bytes, count);
}
static int bus_data(void *context, const uint8_t *bytes, size_t count) {
  return transfer(context, true, bytes, count);
}

static int bus_data_start(void *context, const uint8_t *bytes, size_t count, fc_ready *ready,
                          void *ready_context) {
  virtual_bus *bus = context;
  virtual_bus_run(bus);
  if (bus->under_way != NULL) return bus_wait(bus);
  if (failing(bus, VIRTUAL_FAIL) || (bus->fault == VIRTUAL_FAIL && bus->bytes + count > bus->fault_at)) {
    return send(bus, true, bytes, count, VIRTUAL_FAIL);
  }
  if (count > bus->room) {
    free(bus->as_started);
    bus->as_started = malloc(count);
    bus->room = count;
    if (bus->as_started == NULL) abort();
  }
  memcpy(bus->as_started, bytes, count);
  bus->under_way = bytes;
  bus->count = count;
  bus->ready = ready;
  bus->ready_context = ready_context;
  bus->transfer_error = FC_OK;
  return FC_OK;
}

static int bus_configure(void *context, uint32_t hz, uint8_t spi_mode) {
  virtual_bus *bus = context;
  if (bus->under_way != NULL) virtual_complain(bus->panel, "the clock is changed while bytes are under way");
  if (bus->configure_error == FC_OK) virtual_clock(bus->panel, hz, spi_mode);
  return bus->configure_error;
}

static uint32_t bus_clock_hz(void *context) { return ((virtual_bus *)context)->panel->hz; }

static int bus_reset(void *context, bool active) {
  virtual_bus *bus = context;
  if (bus->reset_error != FC_OK) return bus->reset_error;
  if (active) bus->resets++;
  virtual_reset(bus->panel, active);
  return FC_OK;
}

static void bus_delay_us(void *context, uint32_t us) {
  virtual_bus *bus = context;
  if (!bus->no_delays) virtual_time(bus->panel, us);
}

static int bus_backlight(void *context, uint8_t level) {
  ((virtual_bus *)context)->last_backlight = level;
  return FC_OK;
}

void virtual_bus_open(virtual_bus *bus, virtual_panel *panel, bool asynchronous) {
  memset(bus, 0, sizeof *bus);
  bus->panel = panel;
  bus->ops.configure = bus_configure;
  bus->ops.clock_hz = bus_clock_hz;
  bus->ops.command = bus_command;
  bus->ops.data = bus_data;
  bus->ops.data_start = asynchronous ? bus_data_start : NULL;
  bus->ops.wait = asynchronous ? bus_wait : NULL;
  bus->ops.reset = bus_reset;
  bus->ops.delay_us = bus_delay_us;
  bus->ops.backlight = bus_backlight;
  bus->bus.ops = &bus->ops;
  bus->bus.context = bus;
  bus->last_backlight = 256;
}

void virtual_bus_close(virtual_bus *bus) {
  free(bus->as_started);
  bus->as_started = NULL;
}
