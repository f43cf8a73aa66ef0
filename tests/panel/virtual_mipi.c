/*
 * Virtual controllers that speak MIPI's display command set: ST7789, ILI9341, ST7735, with the glass of the panels that are sold.
 *
 * From the data sheets ST7789V V1.3, ILI9341 V1.11, ST7735R V0.2: command lists; reset and sleep times (SWRESET, SLPOUT, SLPIN); MADCTL; COLMOD;
 * "Write data for 12/16/18-bit/pixel" of the 4-line serial interface.
 */
#include "virtual_panel.h"

enum {
  MY = 0x80,
  MX = 0x40,
  MV = 0x20,
  BGR = 0x08
};

static void reset(virtual_panel *panel) {
  panel->awake = false;
  panel->on = false;
  panel->invert = false;
  panel->direction = 0;
  panel->depth = 6; /* 18 bits */
  panel->x0 = 0, panel->y0 = 0;
  panel->x1 = (uint16_t)(panel->model->memory_width - 1);
  panel->y1 = (uint16_t)(panel->model->memory_height - 1);
  panel->window_full = true;
}

static void set_range(virtual_panel *panel, const uint8_t *parameters, uint16_t size, const char *what,
                      uint16_t *first, uint16_t *last) {
  *first = (uint16_t)(parameters[0] << 8 | parameters[1]);
  *last = (uint16_t)(parameters[2] << 8 | parameters[3]);
  if (*first > *last || *last >= size) {
    virtual_complain(panel, "%s %u..%u: memory has 0..%u", what, *first, *last, size - 1);
    *first = 0, *last = 0;
  }
}

static void set_depth(virtual_panel *panel, uint8_t colmod) {
  const uint8_t depth = colmod & 7;
  const bool known = depth == 5 || depth == 6 || (depth == 3 && panel->model->twelve_bits);
  if (!known) virtual_complain(panel, "COLMOD %02X is no format of this controller", colmod);
  panel->depth = known ? depth : 6;
}

static void execute(virtual_panel *panel, uint8_t command, const uint8_t *parameters) {
  switch (command) {
    case 0x01: /* SWRESET */
      reset(panel);
      panel->ready_at_us = panel->now_us + 5000;
      panel->wake_at_us = panel->now_us + 120000;
      break;
    case 0x10: /* SLPIN */
      if (panel->now_us < panel->settled_at_us)
        virtual_complain(panel, "sleep in less than 120 ms after sleep out");
      panel->awake = false;
      panel->ready_at_us = panel->now_us + panel->model->sleep_in_us;
      panel->wake_at_us = panel->now_us + 120000;
      break;
    case 0x11: /* SLPOUT */
      if (panel->now_us < panel->wake_at_us) {
        virtual_complain(panel, "sleep out %lu us too early: 120 ms after a reset or sleep in",
                         (unsigned long)(panel->wake_at_us - panel->now_us));
      }
      panel->awake = true;
      panel->ready_at_us = panel->now_us + 5000;
      panel->settled_at_us = panel->now_us + 120000;
      break;
    case 0x20: panel->invert = false; break;
    case 0x21: panel->invert = true; break;
    case 0x28: panel->on = false; break;
    case 0x29: /* DISPON */
      if (!panel->awake)
        virtual_complain(panel, "display on while asleep");
      else if (panel->now_us < panel->settled_at_us)
        virtual_complain(panel, "display on less than 120 ms after sleep out");
      panel->on = true;
      break;
    case 0x2A:
      set_range(panel, parameters, panel->model->memory_width, "columns", &panel->x0, &panel->x1);
      break;
    case 0x2B:
      set_range(panel, parameters, panel->model->memory_height, "rows", &panel->y0, &panel->y1);
      break;
    case 0x2C:
      panel->windows++;
      virtual_window(panel);
      break;
    case 0x36:
      panel->direction = parameters[0];
      if (parameters[0] & MV)
        virtual_complain(panel, "MADCTL %02X exchanges rows and columns: strips would be columns",
                         parameters[0]);
      break;
    case 0x3A: set_depth(panel, parameters[0]); break;
    default: break; /* voltages, gamma and the like */
  }
}

static void put(virtual_panel *panel, uint8_t red, uint8_t green, uint8_t blue) {
  const virtual_model *model = panel->model;
  if (!panel->awake)
    virtual_complain(panel, "pixels while asleep");
  else if (panel->now_us < panel->settled_at_us)
    virtual_complain(panel, "pixels less than 120 ms after sleep out");
  if (!virtual_writable(panel)) return;
  {
    const uint16_t column = (uint16_t)(panel->direction & MX ? model->memory_width - 1 - panel->x : panel->x);
    const uint16_t row = (uint16_t)(panel->direction & MY ? model->memory_height - 1 - panel->y : panel->y);
    const int x = (model->mirror_x ? model->memory_width - 1 - column : column) - model->glass_x;
    const int y = (model->mirror_y ? model->memory_height - 1 - row : row) - model->glass_y;
    const bool swapped = ((panel->direction & BGR) != 0) != model->bgr;
    if (x < 0 || x >= model->width || y < 0 || y >= model->height) {
      virtual_complain(panel, "pixel at memory column %u, row %u, where there is no glass", column, row);
    }
    panel->memory[(uint32_t)row * model->memory_width + column] =
        (uint32_t)(swapped ? blue : red) << 16 | (uint32_t)green << 8 | (swapped ? red : blue);
    panel->pixels++;
  }
  virtual_next(panel);
}

static uint8_t from5(unsigned v) { return (uint8_t)(v << 3 | v >> 2); }
static uint8_t from6(unsigned v) { return (uint8_t)(v << 2 | v >> 4); }

static void pixel_byte(virtual_panel *panel, uint8_t byte) {
  uint8_t *p = panel->part;
  p[panel->parts++] = byte;
  if (panel->depth == 5 && panel->parts == 2) {
    const unsigned pixel = (unsigned)p[0] << 8 | p[1];
    panel->parts = 0;
    put(panel, from5(pixel >> 11), from6(pixel >> 5 & 63), from5(pixel & 31));
  } else if (panel->depth == 3 && panel->parts == 3) {
    const uint8_t second[3] = {(uint8_t)((p[1] & 15) * 17), (uint8_t)((p[2] >> 4) * 17),
                               (uint8_t)((p[2] & 15) * 17)};
    panel->parts = 0;
    put(panel, (uint8_t)((p[0] >> 4) * 17), (uint8_t)((p[0] & 15) * 17), (uint8_t)((p[1] >> 4) * 17));
    put(panel, second[0], second[1], second[2]);
  } else if (panel->depth == 6 && panel->parts == 3) {
    panel->parts = 0;
    put(panel, from6(p[0] >> 2), from6(p[1] >> 2), from6(p[2] >> 2));
  }
}

static uint32_t shown(const virtual_panel *panel, uint16_t x, uint16_t y) {
  const virtual_model *model = panel->model;
  const uint16_t column =
      (uint16_t)(model->mirror_x ? model->memory_width - 1 - x - model->glass_x : x + model->glass_x);
  const uint16_t row =
      (uint16_t)(model->mirror_y ? model->memory_height - 1 - y - model->glass_y : y + model->glass_y);
  const uint32_t colour = panel->memory[(uint32_t)row * model->memory_width + column];
  if (!panel->awake) return 0;
  return panel->invert != model->inverted ? colour ^ 0xFFFFFF : colour;
}

static const virtual_family mipi = {.parameters_as_commands = false,
                                    .pixels_without_command = false,
                                    .reset = reset,
                                    .execute = execute,
                                    .pixel_byte = pixel_byte,
                                    .shown = shown};

/* clang-format off */
#define COMMON \
  {0x00, 0x01, 0}, {0x10, 0x13, 0}, {0x20, 0x21, 0}, {0x26, 0x26, 1}, {0x28, 0x29, 0}, {0x2A, 0x2B, 4}, {0x2C, 0x2C, VIRTUAL_PIXELS}, \
  {0x30, 0x30, 4}, {0x33, 0x33, 6}, {0x34, 0x34, 0}, {0x35, 0x36, 1}, {0x37, 0x37, 2}, {0x38, 0x39, 0}, {0x3A, 0x3A, 1}
static const virtual_command st7789_commands[] = {
  COMMON, {0x44, 0x44, 2}, {0x51, 0x51, 1}, {0x53, 0x53, 1}, {0x55, 0x55, 1}, {0x5E, 0x5E, 1}, {0xB0, 0xB0, 2}, {0xB1, 0xB1, 3},
  {0xB2, 0xB2, 5}, {0xB3, 0xB3, 3}, {0xB7, 0xB7, 1}, {0xBB, 0xBB, 1}, {0xC0, 0xC0, 1}, {0xC2, 0xC2, 2}, {0xC3, 0xC6, 1}, {0xD0, 0xD0, 2},
  {0xE0, 0xE1, 14}, {1, 0, 0}};
static const virtual_command ili9341_commands[] = {
  COMMON, {0x44, 0x44, 2}, {0x51, 0x51, 1}, {0x53, 0x53, 1}, {0x55, 0x55, 1}, {0x5E, 0x5E, 1}, {0xB0, 0xB0, 1}, {0xB1, 0xB3, 2},
  {0xB4, 0xB4, 1}, {0xB5, 0xB5, 4}, {0xB6, 0xB6, 4}, {0xB7, 0xB7, 1}, {0xC0, 0xC1, 1}, {0xC5, 0xC5, 2}, {0xC7, 0xC7, 1},
  {0xE0, 0xE1, 15}, {0xF6, 0xF6, 3}, {1, 0, 0}};
static const virtual_command st7735_commands[] = {
  COMMON, {0xB1, 0xB2, 3}, {0xB3, 0xB3, 6}, {0xB4, 0xB4, 1}, {0xB6, 0xB6, 2}, {0xC0, 0xC0, 3}, {0xC1, 0xC1, 1}, {0xC2, 0xC4, 2},
  {0xC5, 0xC5, 1}, {0xE0, 0xE1, 16}, {0xFC, 0xFC, 1}, {1, 0, 0}};
/* clang-format on */

#define MODEL .family = &mipi, .reset_low_us = 10, .reset_wait_us = 5000
#define ST7789 \
  MODEL, .commands = st7789_commands, .memory_width = 240, .memory_height = 320, .inverted = true, \
         .twelve_bits = true, .hz_max = 62500000, .sleep_in_us = 5000

const virtual_model virtual_st7789_240 = {ST7789, .name = "st7789-240", .width = 240, .height = 240};
const virtual_model virtual_st7789_135 = {ST7789, .name = "st7789-135", .width = 135,
                                          .height = 240, .glass_x = 52, .glass_y = 40};
const virtual_model virtual_st7789_320 = {ST7789, .name = "st7789-320", .width = 240, .height = 320};
const virtual_model virtual_st7789_170 = {ST7789, .name = "st7789-170", .width = 170, .height = 320,
                                          .glass_x = 35};
const virtual_model virtual_ili9341 = {MODEL,
                                       .name = "ili9341",
                                       .commands = ili9341_commands,
                                       .memory_width = 240,
                                       .memory_height = 320,
                                       .width = 240,
                                       .height = 320,
                                       .mirror_x = true,
                                       .bgr = true,
                                       .hz_max = 10000000,
                                       .sleep_in_us = 5000};
const virtual_model virtual_st7735_128 = {MODEL,
                                          .name = "st7735-128",
                                          .commands = st7735_commands,
                                          .memory_width = 128,
                                          .memory_height = 160,
                                          .width = 128,
                                          .height = 160,
                                          .mirror_x = true,
                                          .mirror_y = true,
                                          .twelve_bits = true,
                                          .hz_max = 15151515,
                                          .sleep_in_us = 120000};
