/* The bus: a spidev device, a D/C line and perhaps a reset and a backlight line, with transfers on a second thread. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "failure.h"
#include "fixcast/error.h"
#include "lines.h"
#include "linux_bus.h"
#include "sender.h"
#include "spi.h"

struct fc_linux_bus {
  fc_bus_ops ops;
  fc_linux_spi spi;
  fc_linux_line dc, reset, backlight;
  bool dc_high;
  fc_linux_sender sender;
  const uint8_t *bytes; /* of the transfer under way */
  size_t count;
  fc_linux_error error;
};

struct fc_linux_input {
  fc_linux_line line;
};

/* ---- fc_bus_ops ---- */

static int op_wait(void *context) {
  fc_linux_bus *bus = context;
  return fc_linux_sender_wait(&bus->sender);
}

static int op_configure(void *context, uint32_t hz, uint8_t spi_mode) {
  fc_linux_bus *bus = context;
  const int error = op_wait(bus);
  return error != FC_OK ? error : fc_linux_spi_configure(&bus->spi, hz, spi_mode, &bus->error);
}

static uint32_t op_clock_hz(void *context) { return ((fc_linux_bus *)context)->spi.clock_hz; }

/* D/C as it has to be for what comes; what came before has left. */
static int select_dc(fc_linux_bus *bus, bool high) {
  int error = op_wait(bus);
  if (error != FC_OK || bus->dc_high == high) return error;
  error = fc_linux_line_set(&bus->dc, high, &bus->error);
  if (error == FC_OK) bus->dc_high = high;
  return error;
}

static int op_command(void *context, const uint8_t *bytes, size_t count) {
  fc_linux_bus *bus = context;
  const int error = select_dc(bus, false);
  return error != FC_OK ? error : fc_linux_spi_send(&bus->spi, bytes, count, &bus->error);
}

static int op_data(void *context, const uint8_t *bytes, size_t count) {
  fc_linux_bus *bus = context;
  const int error = select_dc(bus, true);
  return error != FC_OK ? error : fc_linux_spi_send(&bus->spi, bytes, count, &bus->error);
}

/* On the sender's thread; until it is done nothing else touches the device or the error. */
static int send_job(void *context) {
  fc_linux_bus *bus = context;
  return fc_linux_spi_send(&bus->spi, bus->bytes, bus->count, &bus->error);
}

static int op_data_start(void *context, const uint8_t *bytes, size_t count, fc_ready *ready, void *ready_context) {
  fc_linux_bus *bus = context;
  const int error = select_dc(bus, true);
  if (error != FC_OK) return error;
  bus->bytes = bytes;
  bus->count = count;
  fc_linux_sender_start(&bus->sender, send_job, bus, ready, ready_context);
  return FC_OK;
}

static int op_reset(void *context, bool active) {
  fc_linux_bus *bus = context;
  const int error = op_wait(bus);
  return error != FC_OK ? error : fc_linux_line_set(&bus->reset, !active, &bus->error);
}

static int op_backlight(void *context, uint8_t level) {
  fc_linux_bus *bus = context;
  const int error = op_wait(bus);
  return error != FC_OK ? error : fc_linux_line_set(&bus->backlight, level != 0, &bus->error);
}

static void op_delay_us(void *context, uint32_t us) {
  struct timespec left;
  (void)context;
  left.tv_sec = (time_t)(us / 1000000u);
  left.tv_nsec = (long)(us % 1000000u) * 1000;
  while (clock_nanosleep(CLOCK_MONOTONIC, 0, &left, &left) == EINTR) {
  }
}

/* ---- the bus ---- */

static int open_lines(fc_linux_bus *bus, const fc_linux_wiring *wiring) {
  int error = fc_linux_line_open(wiring->dc, "D/C", FC_GPIO_OUTPUT_LOW, &bus->dc, &bus->error);
  if (error == FC_OK && wiring->reset != NULL) {
    error = fc_linux_line_open(wiring->reset, "reset", FC_GPIO_OUTPUT_HIGH, &bus->reset, &bus->error);
  }
  if (error == FC_OK && wiring->backlight != NULL) {
    error = fc_linux_line_open(wiring->backlight, "backlight", FC_GPIO_OUTPUT_LOW, &bus->backlight, &bus->error);
  }
  return error;
}

static void close_devices(fc_linux_bus *bus) {
  fc_linux_line_close(&bus->backlight);
  fc_linux_line_close(&bus->reset);
  fc_linux_line_close(&bus->dc);
  fc_linux_spi_close(&bus->spi);
}

static int open_bus(fc_linux_bus *bus, const fc_linux_wiring *wiring) {
  int error = fc_linux_spi_open(wiring->spi, &bus->spi, &bus->error);
  if (error == FC_OK) error = open_lines(bus, wiring);
  if (error == FC_OK) {
    const int number = fc_linux_sender_begin(&bus->sender);
    if (number != 0) {
      error = fc_linux_fail(&bus->error, number, "cannot start a thread for transfers: %s; end other programs or raise 'ulimit -u'",
                            strerror(number));
    }
  }
  if (error != FC_OK) close_devices(bus);
  return error;
}

fc_linux_bus *fc_linux_bus_open(const fc_linux_wiring *wiring, fc_linux_error *error) {
  fc_linux_bus *bus;
  if (wiring->spi == NULL || wiring->dc == NULL) {
    (void)fc_linux_fail(error, EINVAL, "a display needs an SPI device and a D/C line");
    return NULL;
  }
  bus = calloc(1, sizeof *bus);
  if (bus == NULL) {
    (void)fc_linux_fail(error, ENOMEM, "no memory for the bus; end other programs");
    return NULL;
  }
  if (open_bus(bus, wiring) != FC_OK) {
    *error = bus->error;
    free(bus);
    return NULL;
  }
  bus->ops.configure = op_configure;
  bus->ops.clock_hz = op_clock_hz;
  bus->ops.command = op_command;
  bus->ops.data = op_data;
  bus->ops.data_start = op_data_start;
  bus->ops.wait = op_wait;
  bus->ops.reset = wiring->reset != NULL ? op_reset : NULL;
  bus->ops.delay_us = op_delay_us;
  bus->ops.backlight = wiring->backlight != NULL ? op_backlight : NULL;
  return bus;
}

void fc_linux_bus_close(fc_linux_bus *bus) {
  if (bus == NULL) return;
  fc_linux_sender_end(&bus->sender);
  close_devices(bus);
  free(bus);
}

fc_bus fc_linux_bus_ops(fc_linux_bus *bus) {
  fc_bus interface;
  interface.ops = &bus->ops;
  interface.context = bus;
  return interface;
}

const fc_linux_error *fc_linux_bus_error(const fc_linux_bus *bus) { return &bus->error; }

fc_linux_bus_figures fc_linux_bus_figures_get(const fc_linux_bus *bus) {
  fc_linux_bus_figures figures;
  figures.clock_hz = bus->spi.clock_hz;
  figures.chunk_bytes = bus->spi.chunk_bytes;
  figures.sent_bytes = bus->spi.sent_bytes;
  figures.sending_ns = bus->spi.sending_ns;
  return figures;
}

/* ---- inputs ---- */

fc_linux_input *fc_linux_input_open(const char *name, fc_linux_error *error) {
  fc_linux_input *input = calloc(1, sizeof *input);
  if (input == NULL) {
    (void)fc_linux_fail(error, ENOMEM, "no memory for an input line; end other programs");
    return NULL;
  }
  if (fc_linux_line_open(name, "button", FC_GPIO_INPUT_PULL_UP, &input->line, error) != FC_OK) {
    free(input);
    return NULL;
  }
  return input;
}

void fc_linux_input_close(fc_linux_input *input) {
  if (input == NULL) return;
  fc_linux_line_close(&input->line);
  free(input);
}

int fc_linux_input_read(fc_linux_input *input, fc_linux_error *error) { return fc_linux_line_get(&input->line, error); }
