/*
 * Virtual OLED controllers of Solomon Systech: SSD1351 (colour), SSD0323, SSD1327, SSD1322 (16 greys), SSD1306 (one bit), each with a glass.
 *
 * From the data sheets SSD1351 Rev 1.5, SSD0323 Rev 2.1, SSD1327 Rev 1.1, SSD1322 Rev 1.2, SSD1306 Rev 1.1: command tables, re-map commands, memory
 * maps, serial timing.
 * Memory is kept by row and segment: columns are re-mapped as they are written, rows as they are shown.
 */
#include "virtual_panel.h"

static void reset(virtual_panel *panel) {
  panel->on = false;
  panel->invert = panel->all_on = panel->all_off = false;
  panel->unlocked = false;
  panel->direction = panel->direction2 = 0;
  panel->addressing = 2; /* SSD1306: by page */
  panel->offset = panel->start_line = 0;
  panel->mux = 0xFF;
  panel->rows_reversed = panel->pump = false;
  panel->common_pins = 0x12;
  panel->window_full = true;
}

/* 15 and 75, 21 and 22. */
static void set_range(virtual_panel *panel, const uint8_t *parameters, unsigned size, const char *what,
                      uint16_t *first, uint16_t *last) {
  *first = parameters[0];
  *last = parameters[1];
  if (*first > *last || *last >= size) {
    virtual_complain(panel, "%s %u..%u: memory has 0..%u", what, *first, *last, size - 1);
    *first = 0, *last = 0;
  }
  virtual_window(panel);
}

static void switch_on(virtual_panel *panel) {
  if (panel->mux + 1 != panel->model->height) {
    virtual_complain(panel, "display on with a multiplex ratio of %u rows, the glass has %u", panel->mux + 1,
                     panel->model->height);
  }
  panel->on = true;
}

/* The row of memory that a common shows, of `commons`. */
static uint16_t row_of(const virtual_panel *panel, unsigned common, unsigned commons, bool reversed) {
  const unsigned line = reversed ? commons - 1 - common : common;
  return (uint16_t)((line + panel->offset + panel->start_line) % commons);
}

static uint32_t lit(const virtual_panel *panel, uint32_t colour) {
  if (panel->all_off) return 0;
  if (panel->all_on) return 0xFFFFFF;
  return panel->invert ? colour ^ 0xFFFFFF : colour;
}

static void store(virtual_panel *panel, unsigned row, unsigned segment, uint32_t colour) {
  const virtual_model *model = panel->model;
  if (segment < model->glass_x || segment >= (unsigned)model->glass_x + model->width) {
    virtual_complain(panel, "pixel of segment %u, where there is no glass", segment);
  }
  panel->memory[row * model->memory_width + segment] = colour;
  panel->pixels++;
}

/* The display modes of SSD1351, SSD1322: A4 all off, A5 all on, A6 normal, A7 inverse. */
static void set_mode(virtual_panel *panel, uint8_t command) {
  panel->all_off = command == 0xA4;
  panel->all_on = command == 0xA5;
  panel->invert = command == 0xA7;
}

/* ---- SSD1351 ---- */

static void reset_1351(virtual_panel *panel) {
  reset(panel);
  panel->direction = 0x40;
  panel->offset = 96;
}

static void execute_1351(virtual_panel *panel, uint8_t command, const uint8_t *parameters) {
  const bool locked = command == 0xA2 || command == 0xB1 || command == 0xB3 || command == 0xBB ||
                      command == 0xBE || command == 0xC1;
  if (locked && !panel->unlocked)
    virtual_complain(panel, "command %02X is locked: FD B1 comes first", command);
  switch (command) {
    case 0x15: set_range(panel, parameters, 128, "columns", &panel->x0, &panel->x1); break;
    case 0x75: set_range(panel, parameters, 128, "rows", &panel->y0, &panel->y1); break;
    case 0x5C:
      panel->windows++;
      virtual_window(panel);
      break;
    case 0xA0: panel->direction = parameters[0]; break;
    case 0xA1: panel->start_line = parameters[0]; break;
    case 0xA2: panel->offset = parameters[0]; break;
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7: set_mode(panel, command); break;
    case 0xAE: panel->on = false; break;
    case 0xAF: switch_on(panel); break;
    case 0xCA: panel->mux = parameters[0]; break;
    case 0xFD: panel->unlocked = parameters[0] == 0xB1 || (panel->unlocked && parameters[0] != 0xB0); break;
    default: break;
  }
}

static void pixel_1351(virtual_panel *panel, uint8_t byte) {
  const unsigned colours = panel->direction >> 6;
  panel->part[panel->parts++] = byte;
  if (panel->parts < (colours == 0 ? 1 : colours == 1 ? 2
                                                      : 3)) return;
  panel->parts = 0;
  if (colours != 1) virtual_complain(panel, "re-map %02X: pixels are not of 16 bits", panel->direction);
  if (panel->direction & 0x01) virtual_complain(panel, "re-map %02X: addresses run down", panel->direction);
  if (!(panel->direction & 0x20))
    virtual_complain(panel, "re-map %02X: the glass's commons are split", panel->direction);
  if (!virtual_writable(panel)) return;
  {
    const unsigned pixel = (unsigned)panel->part[0] << 8 | panel->part[1];
    const unsigned first = pixel >> 11, middle = pixel >> 5 & 63, last = pixel & 31;
    const unsigned red = panel->direction & 0x04 ? first : last,
                   blue = panel->direction & 0x04 ? last : first;
    const unsigned segment = panel->direction & 0x02 ? 127u - panel->x : panel->x;
    store(panel, panel->y, segment,
          (red << 3 | red >> 2) << 16 | (middle << 2 | middle >> 4) << 8 | (blue << 3 | blue >> 2));
  }
  virtual_next(panel);
}

static uint32_t shown_1351(const virtual_panel *panel, uint16_t x, uint16_t y) {
  return lit(panel, panel->memory[row_of(panel, 127u - y, 128, (panel->direction & 0x10) != 0) * 128u + x]);
}

/* ---- SSD0323 ---- */

static void execute_0323(virtual_panel *panel, uint8_t command, const uint8_t *parameters) {
  switch (command) {
    case 0x15: set_range(panel, parameters, 64, "columns", &panel->x0, &panel->x1); break;
    case 0x75:
      panel->windows++;
      set_range(panel, parameters, 80, "rows", &panel->y0, &panel->y1);
      break;
    case 0xA0: panel->direction = parameters[0]; break;
    case 0xA1: panel->start_line = parameters[0]; break;
    case 0xA2: panel->offset = parameters[0]; break;
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7: /* normal, all on, all off, inverse */
      panel->all_on = command == 0xA5;
      panel->all_off = command == 0xA6;
      panel->invert = command == 0xA7;
      break;
    case 0xA8: panel->mux = parameters[0]; break;
    case 0xAE: panel->on = false; break;
    case 0xAF: switch_on(panel); break;
    default: break;
  }
}

static void pixel_0323(virtual_panel *panel, uint8_t byte) {
  const unsigned column = panel->direction & 0x01 ? 63u - panel->x : panel->x;
  const uint32_t high = (byte >> 4) * UINT32_C(0x111111), low = (byte & 15) * UINT32_C(0x111111);
  const bool swapped = (panel->direction & 0x02) != 0;
  if (panel->direction & 0x04) virtual_complain(panel, "re-map %02X: addresses run down", panel->direction);
  if (!(panel->direction & 0x40))
    virtual_complain(panel, "re-map %02X: the glass's commons are split", panel->direction);
  if (!virtual_writable(panel)) return;
  store(panel, panel->y, 2 * column, swapped ? high : low);
  store(panel, panel->y, 2 * column + 1, swapped ? low : high);
  virtual_next(panel);
}

/* SSD1327: the same memory with 128 rows; the glass begins at the last segment and common. */
static void execute_1327(virtual_panel *panel, uint8_t command, const uint8_t *parameters) {
  switch (command) {
    case 0x15: set_range(panel, parameters, 64, "columns", &panel->x0, &panel->x1); break;
    case 0x75:
      panel->windows++;
      set_range(panel, parameters, 128, "rows", &panel->y0, &panel->y1);
      break;
    case 0xAB: panel->pump = (parameters[0] & 1) != 0; break;
    case 0xAF:
      if (!panel->pump) virtual_complain(panel, "display on without the internal VDD regulator");
      switch_on(panel);
      break;
    case 0xFD:
      if (parameters[0] != 0x12)
        virtual_complain(panel, "command lock %02X: nothing would be taken after it", parameters[0]);
      break;
    default: execute_0323(panel, command, parameters); break;
  }
}

static uint32_t shown_1327(const virtual_panel *panel, uint16_t x, uint16_t y) {
  return lit(panel,
             panel->memory[row_of(panel, 127u - y, 128, (panel->direction & 0x10) != 0) * 128u + 127u - x]);
}

static uint32_t shown_0323(const virtual_panel *panel, uint16_t x, uint16_t y) {
  const unsigned common = 75u - y; /* the glass is on commons 12 to 75 */
  return lit(panel, panel->memory[row_of(panel, common, 80, (panel->direction & 0x10) != 0) * 128u + x]);
}

/* ---- SSD1322 ---- */

static void execute_1322(virtual_panel *panel, uint8_t command, const uint8_t *parameters) {
  switch (command) {
    case 0x15: set_range(panel, parameters, 120, "columns", &panel->x0, &panel->x1); break;
    case 0x75: set_range(panel, parameters, 128, "rows", &panel->y0, &panel->y1); break;
    case 0x5C:
      panel->windows++;
      virtual_window(panel);
      break;
    case 0xA0: panel->direction = parameters[0], panel->direction2 = parameters[1]; break;
    case 0xA1: panel->start_line = parameters[0]; break;
    case 0xA2: panel->offset = parameters[0]; break;
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7: set_mode(panel, command); break;
    case 0xAE: panel->on = false; break;
    case 0xAF: switch_on(panel); break;
    case 0xCA: panel->mux = parameters[0]; break;
    default: break;
  }
}

/* A column is four pixels, two bytes. */
static void pixel_1322(virtual_panel *panel, uint8_t byte) {
  unsigned i;
  panel->part[panel->parts++] = byte;
  if (panel->parts < 2) return;
  panel->parts = 0;
  if (panel->direction & 0x01) virtual_complain(panel, "re-map %02X: addresses run down", panel->direction);
  if (panel->direction & 0x20 || panel->direction2 != 0x11) {
    virtual_complain(panel, "re-map %02X %02X: the glass is driven by two commons at a time",
                     panel->direction, panel->direction2);
  }
  if (!virtual_writable(panel)) return;
  for (i = 0; i < 4; i++) {
    const unsigned nibble = panel->direction & 0x04 ? i : 3 - i, segment = 4u * panel->x + i;
    const unsigned grey = nibble & 1 ? panel->part[nibble / 2] & 15u : panel->part[nibble / 2] >> 4;
    store(panel, panel->y, panel->direction & 0x02 ? 479 - segment : segment, grey * UINT32_C(0x111111));
  }
  virtual_next(panel);
}

static uint32_t shown_1322(const virtual_panel *panel, uint16_t x, uint16_t y) {
  const unsigned line = panel->direction & 0x10 ? y : 63u - y; /* two commons each, the upper end on top */
  const unsigned row = (line + panel->offset + panel->start_line) % 128;
  return lit(panel, panel->memory[row * 480u + 112u + x]);
}

/* ---- SSD1306 ---- */

static void execute_1306(virtual_panel *panel, uint8_t command, const uint8_t *parameters) {
  if (command >= 0x40 && command <= 0x7F) panel->start_line = command & 63;
  switch (command) {
    case 0x20: panel->addressing = parameters[0]; break;
    case 0x21: set_range(panel, parameters, 128, "columns", &panel->x0, &panel->x1); break;
    case 0x22:
      panel->windows++;
      set_range(panel, parameters, 8, "pages", &panel->y0, &panel->y1);
      break;
    case 0x8D: panel->pump = (parameters[0] & 4) != 0; break;
    case 0xA0:
    case 0xA1: panel->direction = command & 1; break;
    case 0xA4:
    case 0xA5: panel->all_on = command == 0xA5; break;
    case 0xA6:
    case 0xA7: panel->invert = command == 0xA7; break;
    case 0xA8: panel->mux = parameters[0]; break;
    case 0xAE: panel->on = false; break;
    case 0xAF:
      if (!panel->pump)
        virtual_complain(panel, "display on without the charge pump: the glass has no voltage");
      if (panel->common_pins != 0x12) {
        virtual_complain(panel, "display on with common pins %02X: the glass is wired for 12",
                         panel->common_pins);
      }
      switch_on(panel);
      break;
    case 0xC0:
    case 0xC8: panel->rows_reversed = command == 0xC8; break;
    case 0xD3: panel->offset = parameters[0]; break;
    case 0xDA: panel->common_pins = parameters[0]; break;
    default: break;
  }
}

static void pixel_1306(virtual_panel *panel, uint8_t byte) {
  unsigned i;
  if (panel->addressing != 0)
    virtual_complain(panel, "addressing mode %u: pixels do not go on in the next page", panel->addressing);
  if (!virtual_writable(panel)) return;
  for (i = 0; i < 8; i++) {
    store(panel, 8u * panel->y + i, panel->direction ? 127u - panel->x : panel->x,
          byte >> i & 1 ? 0xFFFFFF : 0);
  }
  virtual_next(panel);
}

static uint32_t shown_1306(const virtual_panel *panel, uint16_t x, uint16_t y) {
  return lit(panel, panel->memory[row_of(panel, 63u - y, 64, panel->rows_reversed) * 128u + 127u - x]);
}

/* clang-format off */
static const virtual_command commands_1351[] = {
  {0x15, 0x15, 2}, {0x5C, 0x5C, VIRTUAL_PIXELS}, {0x75, 0x75, 2}, {0x96, 0x96, 5}, {0x9E, 0x9F, 0}, {0xA0, 0xA2, 1}, {0xA4, 0xA7, 0},
  {0xAB, 0xAB, 1}, {0xAE, 0xAF, 0}, {0xB1, 0xB1, 1}, {0xB2, 0xB2, 3}, {0xB3, 0xB3, 1}, {0xB4, 0xB4, 3}, {0xB5, 0xB6, 1}, {0xB8, 0xB8, 63},
  {0xB9, 0xB9, 0}, {0xBB, 0xBB, 1}, {0xBE, 0xBE, 1}, {0xC1, 0xC1, 3}, {0xC7, 0xC7, 1}, {0xCA, 0xCA, 1}, {0xE3, 0xE3, 0}, {0xFD, 0xFD, 1},
  {1, 0, 0}};
static const virtual_command commands_0323[] = {
  {0x15, 0x15, 2}, {0x75, 0x75, 2}, {0x81, 0x81, 1}, {0x84, 0x86, 0}, {0xA0, 0xA2, 1}, {0xA4, 0xA7, 0}, {0xA8, 0xA8, 1}, {0xAD, 0xAD, 1},
  {0xAE, 0xAF, 0}, {0xB1, 0xB3, 1}, {0xB8, 0xB8, 8}, {0xBC, 0xBC, 1}, {0xBE, 0xBF, 1}, {0xE3, 0xE3, 0}, {1, 0, 0}};
static const virtual_command commands_1327[] = {
  {0x15, 0x15, 2}, {0x75, 0x75, 2}, {0x81, 0x81, 1}, {0xA0, 0xA2, 1}, {0xA4, 0xA7, 0}, {0xA8, 0xA8, 1}, {0xAB, 0xAB, 1}, {0xAE, 0xAF, 0},
  {0xB1, 0xB1, 1}, {0xB3, 0xB3, 1}, {0xB5, 0xB6, 1}, {0xB8, 0xB8, 15}, {0xB9, 0xB9, 0}, {0xBC, 0xBC, 1}, {0xBE, 0xBE, 1}, {0xD5, 0xD5, 1},
  {0xFD, 0xFD, 1}, {1, 0, 0}};
static const virtual_command commands_1322[] = {
  {0x00, 0x00, 0}, {0x15, 0x15, 2}, {0x5C, 0x5C, VIRTUAL_PIXELS}, {0x75, 0x75, 2}, {0xA0, 0xA0, 2}, {0xA1, 0xA2, 1}, {0xA4, 0xA7, 0},
  {0xA8, 0xA8, 2}, {0xA9, 0xA9, 0}, {0xAB, 0xAB, 1}, {0xAE, 0xAF, 0}, {0xB1, 0xB1, 1}, {0xB3, 0xB3, 1}, {0xB4, 0xB4, 2}, {0xB5, 0xB6, 1},
  {0xB8, 0xB8, 15}, {0xB9, 0xB9, 0}, {0xBB, 0xBB, 1}, {0xBE, 0xBE, 1}, {0xC1, 0xC1, 1}, {0xC7, 0xC7, 1}, {0xCA, 0xCA, 1}, {0xD1, 0xD1, 2},
  {0xFD, 0xFD, 1}, {1, 0, 0}};
static const virtual_command commands_1306[] = {
  {0x00, 0x1F, 0}, {0x20, 0x20, 1}, {0x21, 0x22, 2}, {0x26, 0x27, 6}, {0x29, 0x2A, 5}, {0x2E, 0x2F, 0}, {0x40, 0x7F, 0}, {0x81, 0x81, 1},
  {0x8D, 0x8D, 1}, {0xA0, 0xA1, 0}, {0xA3, 0xA3, 2}, {0xA4, 0xA7, 0}, {0xA8, 0xA8, 1}, {0xAE, 0xB7, 0}, {0xC0, 0xC0, 0}, {0xC8, 0xC8, 0},
  {0xD3, 0xD3, 1}, {0xD5, 0xD5, 1}, {0xD9, 0xDB, 1}, {0xE3, 0xE3, 0}, {1, 0, 0}};
/* clang-format on */

static const virtual_family family_1351 = {false, false, reset_1351, execute_1351, pixel_1351, shown_1351};
static const virtual_family family_0323 = {true, true, reset, execute_0323, pixel_0323, shown_0323};
static const virtual_family family_1327 = {true, true, reset, execute_1327, pixel_0323, shown_1327};
static const virtual_family family_1322 = {false, false, reset, execute_1322, pixel_1322, shown_1322};
static const virtual_family family_1306 = {true, true, reset, execute_1306, pixel_1306, shown_1306};

#define RESET .reset_low_us = 3, .reset_wait_us = 3
const virtual_model virtual_ssd1351 = {RESET,
                                       .name = "ssd1351",
                                       .family = &family_1351,
                                       .commands = commands_1351,
                                       .memory_width = 128,
                                       .memory_height = 128,
                                       .width = 128,
                                       .height = 128,
                                       .hz_max = 4545454};
const virtual_model virtual_ssd0323 = {RESET,
                                       .name = "ssd0323",
                                       .family = &family_0323,
                                       .commands = commands_0323,
                                       .memory_width = 128,
                                       .memory_height = 80,
                                       .width = 128,
                                       .height = 64,
                                       .hz_max = 4000000};
const virtual_model virtual_ssd1327 = {RESET,
                                       .name = "ssd1327",
                                       .family = &family_1327,
                                       .commands = commands_1327,
                                       .memory_width = 128,
                                       .memory_height = 128,
                                       .width = 128,
                                       .height = 128,
                                       .hz_max = 10000000};
const virtual_model virtual_ssd1322 = {RESET,
                                       .name = "ssd1322",
                                       .family = &family_1322,
                                       .commands = commands_1322,
                                       .memory_width = 480,
                                       .memory_height = 128,
                                       .width = 256,
                                       .height = 64,
                                       .glass_x = 112,
                                       .hz_max = 10000000};
const virtual_model virtual_ssd1306 = {RESET,
                                       .name = "ssd1306",
                                       .family = &family_1306,
                                       .commands = commands_1306,
                                       .memory_width = 128,
                                       .memory_height = 64,
                                       .width = 128,
                                       .height = 64,
                                       .hz_max = 10000000};
