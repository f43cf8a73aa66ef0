/* The interpreter of panel records: what a record says is sent over a bus, and a display sink made of it. */
#include "fixcast/panel.h"

#include <stdbool.h>

#include "fixcast/error.h"

enum {
  CHUNK = 16,           /* bytes of a command table that are copied to RAM at a time */
  DELAY_UNIT_US = 5000, /* of FC_PANEL_DELAY */
  PAGE_ROWS = 8         /* rows of a page of FC_DISPLAY_MONO8 */
};

/* ---- commands ---- */

/* Replays a table of panel.h's form, which is in constant memory. */
static int replay(const fc_bus *bus, const uint8_t *table, bool data_as_commands) {
  for (;;) {
    uint8_t head[2], bytes[CHUNK], left;
    int error;
    FC_READ(head, table, 1);
    if (head[0] == FC_PANEL_END) return FC_OK;
    FC_READ(head, table, 2);
    table += 2;
    error = bus->ops->command(bus->context, head, 1);
    left = (uint8_t)(head[1] & ~FC_PANEL_DELAY);
    while (error == FC_OK && left != 0) {
      const uint8_t count = left < CHUNK ? left : CHUNK;
      FC_READ(bytes, table, count);
      error = (data_as_commands ? bus->ops->command : bus->ops->data)(bus->context, bytes, count);
      table += count;
      left = (uint8_t)(left - count);
    }
    if (error != FC_OK) return error;
    if ((head[1] & FC_PANEL_DELAY) != 0) {
      FC_READ(bytes, table, 1);
      table++;
      bus->ops->delay_us(bus->context, (uint32_t)bytes[0] * DELAY_UNIT_US);
    }
  }
}

/* A command with the ends of a range, as bytes or, high byte first, as words. */
static int send_range(const fc_bus *bus, uint8_t command, uint16_t first, uint16_t last, bool words) {
  uint8_t data[4], count = 0;
  const int error = bus->ops->command(bus->context, &command, 1);
  if (error != FC_OK) return error;
  if (words) data[count++] = (uint8_t)(first >> 8);
  data[count++] = (uint8_t)first;
  if (words) data[count++] = (uint8_t)(last >> 8);
  data[count++] = (uint8_t)last;
  return bus->ops->data(bus->context, data, count);
}

/* Columns, rows, and the command after which pixels come. */
static int send_ranges(const fc_bus *bus, const uint8_t commands[3], uint16_t x0, uint16_t x1, uint16_t y0,
                       uint16_t y1, bool words) {
  int error = send_range(bus, commands[0], x0, x1, words);
  if (error == FC_OK) error = send_range(bus, commands[1], y0, y1, words);
  return error != FC_OK ? error : bus->ops->command(bus->context, &commands[2], 1);
}

/* Where pixels go: columns x0..x1 and rows y0..y1 of the controller's memory, the ends included. */
static int send_window(const fc_bus *bus, uint8_t style, uint16_t x0, uint16_t x1, uint16_t y0, uint16_t y1) {
  uint8_t bytes[6];
  switch (style) {
    case FC_WINDOW_MIPI:
      bytes[0] = 0x2A, bytes[1] = 0x2B, bytes[2] = 0x2C;
      return send_ranges(bus, bytes, x0, x1, y0, y1, true);
    case FC_WINDOW_SSD1322:
      x0 /= 4, x1 /= 4;
      /* fall through */
    case FC_WINDOW_SSD1351:
      bytes[0] = 0x15, bytes[1] = 0x75, bytes[2] = 0x5C;
      return send_ranges(bus, bytes, x0, x1, y0, y1, false);
    case FC_WINDOW_SSD0323:
      bytes[0] = 0x15, bytes[3] = 0x75;
      x0 /= 2, x1 /= 2;
      break;
    case FC_WINDOW_SSD1306:
      bytes[0] = 0x21, bytes[3] = 0x22;
      y0 /= PAGE_ROWS, y1 /= PAGE_ROWS;
      break;
    default: return FC_ERR_UNSUPPORTED;
  }
  bytes[1] = (uint8_t)x0, bytes[2] = (uint8_t)x1;
  bytes[4] = (uint8_t)y0, bytes[5] = (uint8_t)y1;
  return bus->ops->command(bus->context, bytes, sizeof bytes);
}

/* ---- the sink ---- */

static uint8_t format_of(const fc_panel_state *state, const fc_panel *panel) {
  return state->options.twelve_bit ? (uint8_t)FC_DISPLAY_RGB444 : panel->format;
}

static void panel_capabilities(void *context, fc_display_capabilities *to) {
  const fc_panel_state *state = context;
  const fc_bus_ops *ops = state->bus.ops;
  fc_panel panel;
  FC_READ(&panel, state->panel, sizeof panel);
  to->width = panel.width;
  to->height = panel.height;
  to->format = format_of(state, &panel);
  to->x_align = 1;
  to->y_align = 1;
  if (to->format == FC_DISPLAY_RGB444 || to->format == FC_DISPLAY_GREY4)
    to->x_align = 2; /* whole bytes a row */
  if (panel.window == FC_WINDOW_SSD1322) to->x_align = 4;
  if (to->format == FC_DISPLAY_MONO8) to->y_align = PAGE_ROWS;
  to->asynchronous = ops->data_start != NULL;
  to->has_flush = 0;
  to->has_backlight = ops->backlight != NULL;
  to->has_vsync = ops->wait_vsync != NULL;
}

static int panel_wait(void *context) {
  fc_panel_state *state = context;
  int error;
  if (!state->busy) return FC_OK;
  state->busy = 0; /* an error is told once */
  error = state->bus.ops->wait(state->bus.context);
  if (error != FC_OK)
    state->next_y = UINT16_MAX; /* who knows where the controller is: open the window anew */
  return error;
}

/* An area's pixels. All but the last row of bytes are sent at once, and that too unless `start` says that it may go on afterwards. */
static int send_pixels(fc_panel_state *state, const uint8_t *pixels, size_t pitch_bytes, size_t row_bytes,
                       uint16_t rows, bool start, fc_ready *ready, void *ready_context) {
  const fc_bus *bus = &state->bus;
  int error;
  if (pitch_bytes == row_bytes) { /* no gaps: one transfer */
    row_bytes *= rows;
    rows = 1;
  }
  for (; rows > 1; rows--) {
    error = bus->ops->data(bus->context, pixels, row_bytes);
    if (error != FC_OK) return error;
    pixels += pitch_bytes;
  }
  if (!start) return bus->ops->data(bus->context, pixels, row_bytes);
  error = bus->ops->data_start(bus->context, pixels, row_bytes, ready, ready_context);
  if (error == FC_OK) state->busy = 1;
  return error;
}

/*
 * Areas over the whole width that follow one another downwards share a window that reaches to the bottom: a controller goes on
 * where the last byte left it, even when the chip select was inactive meanwhile (ST7789V data sheet 8.6 "Data transfer pause"; the others alike).
 */
static int write_area(fc_panel_state *state, const fc_area *area, const void *pixels, size_t pitch_bytes,
                      bool start, fc_ready *ready, void *ready_context) {
  fc_panel panel;
  uint8_t format;
  uint16_t rows;
  bool whole_width;
  int error = panel_wait(state);
  if (error != FC_OK) return error;
  FC_READ(&panel, state->panel, sizeof panel);
  format = format_of(state, &panel);
  whole_width = area->width == panel.width;
  if (!whole_width || area->y != state->next_y) { /* which is never 0: each frame opens one */
    const fc_panel_turn *turn = &panel.turn[state->options.half_turn];
    const uint16_t x0 = (uint16_t)(turn->x_offset + area->x), x1 = (uint16_t)(x0 + area->width - 1u);
    const uint16_t y0 = (uint16_t)(turn->y_offset + area->y);
    const uint16_t y1 = (uint16_t)(whole_width ? turn->y_offset + panel.height - 1u : y0 + area->height - 1u);
    error = send_window(&state->bus, panel.window, x0, x1, y0, y1);
  }
  state->next_y = UINT16_MAX; /* until all has gone well */
  if (error != FC_OK) return error;
  rows = format == FC_DISPLAY_MONO8 ? (uint16_t)(area->height / PAGE_ROWS) : area->height;
  error = send_pixels(state, pixels, pitch_bytes, fc_display_row_bytes(format, area->width), rows, start,
                      ready, ready_context);
  if (error == FC_OK && whole_width) state->next_y = (uint16_t)(area->y + area->height);
  return error;
}

static int panel_write(void *context, const fc_area *area, const void *pixels, size_t pitch_bytes) {
  return write_area(context, area, pixels, pitch_bytes, false, NULL, NULL);
}

/* Only called on a bus that has data_start: capabilities say so. */
static int panel_write_start(void *context, const fc_area *area, const void *pixels, size_t pitch_bytes,
                             fc_ready *ready, void *ready_context) {
  return write_area(context, area, pixels, pitch_bytes, true, ready, ready_context);
}

static int panel_backlight(void *context, uint8_t level) {
  const fc_bus *bus = &((fc_panel_state *)context)->bus;
  return bus->ops->backlight != NULL ? bus->ops->backlight(bus->context, level) : FC_ERR_UNSUPPORTED;
}

static int panel_wait_vsync(void *context) {
  const fc_bus *bus = &((fc_panel_state *)context)->bus;
  return bus->ops->wait_vsync != NULL ? bus->ops->wait_vsync(bus->context) : FC_ERR_UNSUPPORTED;
}

static const fc_display_ops panel_ops = {.capabilities = panel_capabilities,
                                         .write = panel_write,
                                         .write_start = panel_write_start,
                                         .wait = panel_wait,
                                         .flush = NULL,
                                         .backlight = panel_backlight,
                                         .wait_vsync = panel_wait_vsync};

/* ---- start and stop ---- */

static int reset(const fc_bus *bus, const fc_panel *panel) {
  int error;
  if (bus->ops->reset == NULL) return FC_OK;
  error = bus->ops->reset(bus->context, true);
  if (error != FC_OK) return error;
  bus->ops->delay_us(bus->context, panel->reset_low_us);
  error = bus->ops->reset(bus->context, false);
  bus->ops->delay_us(bus->context, panel->reset_wait_us);
  return error;
}

int fc_panel_start(fc_panel_state *state, const fc_panel *panel, const fc_bus *bus,
                   const fc_panel_options *options, fc_display *display) {
  fc_panel record;
  int error;
  if (state == NULL || panel == NULL || bus == NULL || bus->ops == NULL || display == NULL)
    return FC_ERR_NULL;
  FC_READ(&record, panel, sizeof record);
  state->panel = panel;
  state->bus = *bus;
  state->options.pixel_hz = options != NULL && options->pixel_hz != 0 ? options->pixel_hz : record.pixel_hz;
  state->options.half_turn = options != NULL && options->half_turn;
  state->options.twelve_bit = options != NULL && options->twelve_bit;
  state->next_y = UINT16_MAX;
  state->busy = 0;
  if (state->options.twelve_bit && record.format12 == NULL) return FC_ERR_UNSUPPORTED;
  if (bus->ops->wait != NULL)
    (void)bus->ops->wait(bus->context); /* what an earlier life left under way; its error is not ours */
  error = bus->ops->configure(bus->context, record.init_hz, record.spi_mode);
  if (error == FC_OK) error = reset(bus, &record);
  if (error == FC_OK) error = replay(bus, record.init, record.data_as_commands);
  if (error == FC_OK)
    error = replay(bus, record.turn[state->options.half_turn].direction, record.data_as_commands);
  if (error == FC_OK && state->options.twelve_bit)
    error = replay(bus, record.format12, record.data_as_commands);
  if (error == FC_OK) error = bus->ops->configure(bus->context, state->options.pixel_hz, record.spi_mode);
  if (error != FC_OK) return error;
  display->ops = &panel_ops;
  display->context = state;
  return FC_OK;
}

int fc_panel_stop(fc_panel_state *state) {
  fc_panel record;
  const fc_bus *bus;
  int first, error;
  if (state == NULL || state->bus.ops == NULL) return FC_ERR_NULL;
  FC_READ(&record, state->panel, sizeof record);
  bus = &state->bus;
  first = panel_wait(state);
  if (bus->ops->backlight != NULL) {
    error = bus->ops->backlight(bus->context, 0);
    if (first == FC_OK) first = error;
  }
  error = bus->ops->configure(bus->context, record.init_hz, record.spi_mode);
  if (error == FC_OK) error = replay(bus, record.off, record.data_as_commands);
  return first != FC_OK ? first : error;
}
