/*
 * The virtual panels notice what drivers get wrong: each line of the table below is one mistake, made in a panel's record or on its wires, and
 * the sentence that must come of it. Without the mistake the same panel shows its picture.
 */
#include <stdio.h>
#include <string.h>

#include "rig.h"
#include "unity.h"

static rig it;
static fc_panel broken;                     /* a copy of the record under test */
static uint8_t init[160], direction[2][16]; /* copies of its tables */

void setUp(void) {}
void tearDown(void) { rig_close(&it); }

/* ---- tables ---- */

static size_t entry_bytes(const uint8_t *entry) { return 2u + (entry[1] & 0x7Fu) + (entry[1] >> 7); }

static size_t table_bytes(const uint8_t *table) {
  size_t n = 0;
  while (table[n] != FC_PANEL_END) n += entry_bytes(table + n);
  return n + 1;
}

/* The entry of a command in `init`; the test is wrong if there is none. */
static uint8_t *entry_of(uint8_t command) {
  uint8_t *entry = init;
  while (*entry != command) {
    TEST_ASSERT_TRUE_MESSAGE(*entry != FC_PANEL_END, "the record has no such command");
    entry += entry_bytes(entry);
  }
  return entry;
}

static void cut(uint8_t *at, size_t count) {
  memmove(at, at + count, sizeof init - (size_t)(at + count - init));
}
static void drop(uint8_t command) { cut(entry_of(command), entry_bytes(entry_of(command))); }
static void set(uint8_t command, uint8_t value) { entry_of(command)[2] = value; }
static void no_delay(uint8_t command) {
  uint8_t *const entry = entry_of(command);
  const size_t n = entry_bytes(entry);
  entry[1] &= 0x7F;
  cut(entry + n - 1, 1);
}

/* ---- on the wires ---- */

static bool command_with_dc_high(virtual_bus *bus, bool *data, uint8_t *byte) {
  (void)bus;
  if (!*data && *byte == 0x2C) *data = true; /* D/C rises before the last bit of the command has left */
  return true;
}
static bool parameter_with_dc_low(virtual_bus *bus, bool *data, uint8_t *byte) {
  (void)byte;
  if (*data && bus->last_command == 0x2A && bus->since_command == 1) *data = false;
  return true;
}
static bool swapped_bytes(virtual_bus *bus, bool *data, uint8_t *byte) {
  static uint8_t held;
  if (!*data || bus->last_command != 0x2C) return true;
  if (bus->filtered++ % 2 == 0) {
    held = *byte;
    return false;
  }
  virtual_feed(bus->panel, true, *byte);
  *byte = held;
  return true;
}
static bool reversed_bits(virtual_bus *bus, bool *data, uint8_t *byte) {
  unsigned i, bits = 0;
  if (!*data || (bus->last_command != 0x2C && bus->last_command != 0x5C)) return true;
  for (i = 0; i < 8; i++) bits |= (unsigned)(*byte >> i & 1) << (7 - i);
  *byte = (uint8_t)bits;
  return true;
}
static bool lost_byte(virtual_bus *bus, bool *data, uint8_t *byte) {
  (void)byte;
  return !(*data && bus->since_command == 1000);
}
static bool two_lost_bytes(virtual_bus *bus, bool *data, uint8_t *byte) {
  (void)byte;
  return !(*data && (bus->since_command == 1001 || bus->since_command == 1002));
}
static bool doubled_byte(virtual_bus *bus, bool *data, uint8_t *byte) {
  if (*data && bus->since_command == 1000) virtual_feed(bus->panel, true, *byte);
  return true;
}
static bool one_wrong_bit(virtual_bus *bus, bool *data, uint8_t *byte) {
  if (*data && bus->since_command == 1000) *byte ^= 0x20;
  return true;
}
static bool no_rows(virtual_bus *bus, bool *data, uint8_t *byte) {
  (void)data, (void)byte;
  return bus->last_command != 0x2B && bus->last_command != 0x75;
}
static bool no_write_command(virtual_bus *bus, bool *data, uint8_t *byte) {
  (void)bus;
  return *data || (*byte != 0x2C && *byte != 0x5C);
}
static void filter_dc_early(void) { it.bus.filter = command_with_dc_high; }
static void filter_dc_late(void) { it.bus.filter = parameter_with_dc_low; }
static void filter_swapped(void) { it.bus.filter = swapped_bytes; }
static void filter_reversed(void) { it.bus.filter = reversed_bits; }
static void filter_lost(void) { it.bus.filter = lost_byte; }
static void filter_two_lost(void) { it.bus.filter = two_lost_bytes; }
static void filter_doubled(void) { it.bus.filter = doubled_byte; }
static void filter_wrong_bit(void) { it.bus.filter = one_wrong_bit; }
static void filter_no_rows(void) { it.bus.filter = no_rows; }
static void filter_no_write(void) { it.bus.filter = no_write_command; }
static void filter_no_delays(void) { it.bus.no_delays = true; }
static int ignored_configure(void *context, uint32_t hz, uint8_t spi_mode) {
  (void)context, (void)hz, (void)spi_mode;
  return FC_OK;
}
static void clock_never_set(void) { it.bus.ops.configure = ignored_configure; }

/* ---- in the record ---- */

static void x_offset(void) { broken.turn[0].x_offset++, broken.turn[1].x_offset++; }
static void x_offset_down(void) { broken.turn[0].x_offset--, broken.turn[1].x_offset--; }
static void y_offset(void) { broken.turn[0].y_offset++, broken.turn[1].y_offset++; }
static void offsets_of_the_other_way_up(void) {
  broken.turn[1].x_offset = broken.turn[0].x_offset;
  broken.turn[1].y_offset = broken.turn[0].y_offset;
}
static void direction_of_the_other_way_up(void) { broken.turn[1].direction = broken.turn[0].direction; }
static void no_sleep_out(void) { drop(0x11); }
static void no_delay_after_reset(void) { no_delay(0x01); }
static void no_delay_after_sleep_out(void) { no_delay(0x11); }
static void short_delay_after_sleep_out(void) { entry_of(0x11)[2] = 23; }
static void no_display_on(void) { drop(0x29); }
static void no_display_on_oled(void) { drop(0xAF); }
static void no_format(void) { drop(0x3A); }
static void format_of_12_bits(void) { set(0x3A, 0x53); }
static void unknown_format(void) { set(0x3A, 0x57); }
static void no_inversion(void) { drop(0x21); }
static void inversion_on(void) { *entry_of(0x20) = 0x21; }
static void colours_swapped(void) { direction[0][2] ^= 0x08; }
static void rows_and_columns_exchanged(void) { direction[0][2] ^= 0x20; }
static void spi_mode_1(void) { broken.spi_mode = 1; }
static void spi_mode_2(void) { broken.spi_mode = 2; }
static void pixels_too_fast(void) { broken.pixel_hz = broken.pixel_hz * 5 / 4; }
static void init_too_fast(void) { broken.init_hz = 12000000; }
static void reset_too_short(void) { broken.reset_low_us = 2; }
static void reset_wait_missing(void) { broken.reset_wait_us = 1; }
static void parameter_missing(void) {
  entry_of(0x3A)[1]--;
  cut(entry_of(0x3A) + 2, 1);
}
static void parameter_too_many(void) { entry_of(0x13)[0] = 0x3A, entry_of(0x3A)[0] = 0x13; }
static void unknown_command(void) { *entry_of(0x13) = 0x14; }
static void too_wide(void) { broken.width = 242; }
static void too_narrow(void) { broken.width--; }
static void data_as_data(void) { broken.data_as_commands = 0; }
static void data_as_commands(void) { broken.data_as_commands = 1; }
static void window_of_an_oled(void) { broken.window = FC_WINDOW_SSD1351; }
static void window_of_a_tft(void) { broken.window = FC_WINDOW_MIPI; }
static void window_in_single_columns(void) { broken.window = FC_WINDOW_SSD1351; }
static void nibbles_swapped(void) { direction[0][2] ^= 0x02; }
static void nibbles_swapped_1322(void) { direction[0][2] ^= 0x04; }
static void addresses_run_down(void) { direction[0][2] ^= 0x04; }
static void commons_not_split(void) { direction[0][2] ^= 0x40; }
static void rows_reversed(void) { direction[0][2] ^= 0x10; }
static void columns_reversed(void) { direction[0][2] ^= 0x02; }
static void colours_swapped_1351(void) { direction[0][2] ^= 0x04; }
static void offset_missing_0323(void) { direction[0][5] = 0; }
static void offset_missing_1351(void) { drop(0xA2); }
static void locked(void) { init[5] = 0x12; } /* FD B1, the second entry */
static void columns_reversed_1327(void) { direction[0][2] ^= 0x01; }
static void offset_1327(void) { set(0xA2, 32); }
static void no_regulator(void) { drop(0xAB); }
static void locked_1327(void) { set(0xFD, 0x16); }
static void single_commons(void) { direction[0][3] = 0x01; }
static void multiplex_missing(void) { drop(0xA8); }
static void inverse(void) { *entry_of(0xA6) = 0xA7; }
static void all_off(void) { *entry_of(0xA4) = 0xA6; }
static void page_addressing(void) { set(0x20, 2); }
static void no_charge_pump(void) { drop(0x8D); }
static void common_pins(void) { set(0xDA, 0x02); }
static void segments_reversed_1306(void) { direction[0][0] ^= 0x01; }
static void rows_reversed_1306(void) { direction[0][2] ^= 0x08; }
static void start_line(void) { *entry_of(0x40) = 0x41; }

typedef struct sabotage {
  const char *what;
  const fc_panel *panel;
  void (*make)(void);
  bool half_turn;
  const char *sentence; /* part of the verdict */
} sabotage;

static const sabotage table[] = {
    {"D/C rises before a command's last bit", &fc_panel_st7789_240, filter_dc_early, false,
     "data byte 2C after command 2B"},
    {"D/C is late for the first parameter", &fc_panel_st7789_240, filter_dc_late, false,
     "command 2A got 0 parameters, it takes 4"},
    {"low byte of pixels first", &fc_panel_st7789_240, filter_swapped, false, "the glass shows"},
    {"lowest bit first", &fc_panel_ili9341, filter_reversed, false, "the glass shows"},
    {"a byte is lost", &fc_panel_ili9341, filter_lost, false, "1 odd byte after pixel"},
    {"two bytes are lost", &fc_panel_ili9341, filter_two_lost, false, "the glass shows"},
    {"a byte comes twice", &fc_panel_st7735_128, filter_doubled, false, "1 odd byte after pixel"},
    {"a byte comes twice on an OLED", &fc_panel_ssd0323, filter_doubled, false, "past the end of the window"},
    {"one bit is wrong", &fc_panel_ssd1322, filter_wrong_bit, false, "the glass shows"},
    {"one bit is wrong in a picture of one bit", &fc_panel_ssd1306, filter_wrong_bit, false,
     "the glass shows"},
    {"the rows of the window are not set", &fc_panel_st7789_135, filter_no_rows, false,
     "where there is no glass"},
    {"the rows of the window are not set", &fc_panel_ssd1351, filter_no_rows, false,
     "past the end of the window"},
    {"no memory write command", &fc_panel_st7789_240, filter_no_write, false,
     "after command 2B, which takes 4"},
    {"no memory write command", &fc_panel_ssd1322, filter_no_write, false, "after command 75, which takes 2"},
    {"delays take no time", &fc_panel_st7789_240, filter_no_delays, false, "reset was held for 0 us"},
    {"no time after a software reset", &fc_panel_st7789_240, no_delay_after_reset, false,
     "too early after a reset"},
    {"the clock is never set", &fc_panel_st7789_240, clock_never_set, false,
     "before the clock was configured"},
    {"columns off by one to the right", &fc_panel_st7789_135, x_offset, false, "where there is no glass"},
    {"columns off by one to the left", &fc_panel_st7789_135, x_offset_down, false, "where there is no glass"},
    {"columns off by one, turned", &fc_panel_st7789_135, x_offset, true, "where there is no glass"},
    {"rows off by one", &fc_panel_st7789_240, y_offset, false, "where there is no glass"},
    {"rows off by one where memory ends", &fc_panel_ili9341, y_offset, false,
     "rows 1..320: memory has 0..319"},
    {"rows off by one on an OLED with rows to spare", &fc_panel_ssd0323, y_offset, false, "the glass shows"},
    {"offsets of the other way up", &fc_panel_st7789_240, offsets_of_the_other_way_up, true,
     "where there is no glass"},
    {"offsets of the other way up, off by one", &fc_panel_st7789_135, offsets_of_the_other_way_up, true,
     "where there is no glass"},
    {"direction of the other way up", &fc_panel_st7789_240, direction_of_the_other_way_up, true,
     "where there is no glass"},
    {"direction of the other way up", &fc_panel_ssd0323, direction_of_the_other_way_up, true,
     "the glass shows"},
    {"direction of the other way up", &fc_panel_ssd1306, direction_of_the_other_way_up, true,
     "the glass shows"},
    {"no sleep out", &fc_panel_st7789_240, no_sleep_out, false, "display on while asleep"},
    {"no delay after sleep out", &fc_panel_st7789_240, no_delay_after_sleep_out, false, "5000 us too early"},
    {"sleep out 5 ms short", &fc_panel_ili9341, short_delay_after_sleep_out, false,
     "display on less than 120 ms after sleep out"},
    {"no display on", &fc_panel_st7789_320, no_display_on, false, "before the display is on"},
    {"no display on", &fc_panel_ssd1322, no_display_on_oled, false, "the glass shows 000000"},
    {"no pixel format", &fc_panel_st7789_240, no_format, false, "the glass shows"},
    {"pixel format of 12 bits", &fc_panel_st7789_240, format_of_12_bits, false, "past the end of the window"},
    {"unknown pixel format", &fc_panel_ili9341, unknown_format, false, "COLMOD 57 is no format"},
    {"no inversion on IPS glass", &fc_panel_st7789_240, no_inversion, false, "the glass shows"},
    {"inversion on other glass", &fc_panel_st7735_128, inversion_on, false, "the glass shows"},
    {"red and blue swapped", &fc_panel_st7789_240, colours_swapped, false, "the glass shows"},
    {"red and blue swapped", &fc_panel_ili9341, colours_swapped, false, "the glass shows"},
    {"red and blue swapped", &fc_panel_ssd1351, colours_swapped_1351, false, "the glass shows"},
    {"rows and columns exchanged", &fc_panel_st7789_240, rows_and_columns_exchanged, false,
     "exchanges rows and columns"},
    {"SPI mode 1", &fc_panel_ssd1306, spi_mode_1, false, "in SPI mode 1"},
    {"SPI mode 2", &fc_panel_st7789_240, spi_mode_2, false, "in SPI mode 2"},
    {"pixels too fast", &fc_panel_st7789_240, pixels_too_fast, false, "the data sheet allows 62500000"},
    {"pixels too fast", &fc_panel_ssd1351, pixels_too_fast, false, "the data sheet allows 4545454"},
    {"initialised too fast", &fc_panel_st7789_240, init_too_fast, false, "initialise at 10 MHz at most"},
    {"reset too short", &fc_panel_st7789_240, reset_too_short, false, "reset was held for 2 us"},
    {"no time after reset", &fc_panel_ili9341, reset_wait_missing, false, "4999 us too early after a reset"},
    {"a parameter is missing", &fc_panel_st7789_240, parameter_missing, false,
     "command 3A got 0 parameters, it takes 1"},
    {"a parameter too many", &fc_panel_st7789_240, parameter_too_many, false,
     "after command 13, which takes 0"},
    {"unknown command", &fc_panel_st7789_240, unknown_command, false, "unknown command 14"},
    {"wider than memory", &fc_panel_st7789_240, too_wide, false, "columns 0..241: memory has 0..239"},
    {"narrower than the glass", &fc_panel_st7789_320, too_narrow, true, "the glass shows"},
    {"data with D/C high", &fc_panel_ssd0323, data_as_data, false, "still waits for 1 parameters"},
    {"data with D/C low", &fc_panel_ssd1351, data_as_commands, false,
     "command FD got 0 parameters, it takes 1"},
    {"window commands of an OLED", &fc_panel_st7789_240, window_of_an_oled, false, "unknown command 15"},
    {"window commands of a TFT", &fc_panel_ssd1351, window_of_a_tft, false, "unknown command 2A"},
    {"columns of one pixel", &fc_panel_ssd1322, window_in_single_columns, false, "memory has 0..119"},
    {"halves of bytes swapped", &fc_panel_ssd0323, nibbles_swapped, false, "the glass shows"},
    {"pixels of a column reversed", &fc_panel_ssd1322, nibbles_swapped_1322, false, "the glass shows"},
    {"addresses run down", &fc_panel_ssd0323, addresses_run_down, false, "addresses run down"},
    {"commons not split", &fc_panel_ssd0323, commons_not_split, false, "commons are split"},
    {"rows reversed", &fc_panel_ssd1351, rows_reversed, false, "the glass shows"},
    {"columns reversed", &fc_panel_ssd1351, columns_reversed, false, "the glass shows"},
    {"rows reversed", &fc_panel_ssd1322, rows_reversed, false, "the glass shows"},
    {"columns reversed", &fc_panel_ssd1322, columns_reversed, false, "the glass shows"},
    {"display offset missing", &fc_panel_ssd0323, offset_missing_0323, false, "the glass shows"},
    {"display offset as after reset", &fc_panel_ssd1351, offset_missing_1351, false, "the glass shows"},
    {"commands are locked", &fc_panel_ssd1351, locked, false, "is locked: FD B1 comes first"},
    {"single commons", &fc_panel_ssd1322, single_commons, false, "two commons at a time"},
    {"columns of the other 1.9 inch glass", &fc_panel_st7789_170, x_offset_down, false,
     "where there is no glass"},
    {"columns reversed", &fc_panel_ssd1327, columns_reversed_1327, false, "the glass shows"},
    {"halves of bytes swapped", &fc_panel_ssd1327, nibbles_swapped, false, "the glass shows"},
    {"addresses run down", &fc_panel_ssd1327, addresses_run_down, false, "addresses run down"},
    {"rows reversed", &fc_panel_ssd1327, rows_reversed, false, "the glass shows"},
    {"commons not split", &fc_panel_ssd1327, commons_not_split, false, "commons are split"},
    {"display offset of another glass", &fc_panel_ssd1327, offset_1327, false, "the glass shows"},
    {"no multiplex ratio", &fc_panel_ssd1327, multiplex_missing, false,
     "multiplex ratio of 256 rows, the glass has 128"},
    {"no regulator", &fc_panel_ssd1327, no_regulator, false, "without the internal VDD regulator"},
    {"locked", &fc_panel_ssd1327, locked_1327, false, "nothing would be taken after it"},
    {"no multiplex ratio", &fc_panel_ssd0323, multiplex_missing, false,
     "multiplex ratio of 256 rows, the glass has 64"},
    {"inverse", &fc_panel_ssd1306, inverse, false, "the glass shows"},
    {"all off", &fc_panel_ssd0323, all_off, false, "the glass shows 000000"},
    {"page addressing", &fc_panel_ssd1306, page_addressing, false, "addressing mode 2"},
    {"no charge pump", &fc_panel_ssd1306, no_charge_pump, false, "without the charge pump"},
    {"common pins of other glass", &fc_panel_ssd1306, common_pins, false, "common pins 02"},
    {"segments reversed", &fc_panel_ssd1306, segments_reversed_1306, false, "the glass shows"},
    {"commons reversed", &fc_panel_ssd1306, rows_reversed_1306, false, "the glass shows"},
    {"start line off by one", &fc_panel_ssd1306, start_line, false, "the glass shows"},
};

/* Opens the rig with copies of the record and its tables. */
static void open_copy(const fc_panel *panel, bool half_turn) {
  unsigned i;
  broken = *panel;
  memset(init, 0, sizeof init);
  memcpy(init, panel->init, table_bytes(panel->init));
  broken.init = init;
  for (i = 0; i < 2; i++) {
    memset(direction[i], 0, sizeof direction[i]);
    memcpy(direction[i], panel->turn[i].direction, table_bytes(panel->turn[i].direction));
    broken.turn[i].direction = direction[i];
  }
  rig_open(&it, &broken, false, half_turn, false);
}

static const char *draw(void) {
  const int error = rig_start(&it);
  if (error == FC_OK) {
    rig_noise(&it, 77);
    TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 16));
    TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 16));
  }
  return rig_verdict(&it);
}

static void test_each_mistake_is_noticed(void) {
  size_t i;
  for (i = 0; i < sizeof table / sizeof *table; i++) {
    const sabotage *mistake = &table[i];
    const char *verdict;
    open_copy(mistake->panel, mistake->half_turn);
    mistake->make();
    verdict = draw();
    printf("  %s: %s\n", mistake->what, verdict != NULL ? verdict : "as it should be");
    TEST_ASSERT_TRUE_MESSAGE(verdict != NULL, mistake->what);
    TEST_ASSERT_TRUE_MESSAGE(strstr(verdict, mistake->sentence) != NULL, mistake->sentence);
    rig_close(&it);
  }
}

static void test_copies_without_a_mistake_show_the_picture(void) {
  size_t i;
  for (i = 0; i < sizeof table / sizeof *table; i++) {
    const char *verdict;
    open_copy(table[i].panel, table[i].half_turn);
    verdict = draw();
    TEST_ASSERT_TRUE_MESSAGE(verdict == NULL, verdict != NULL ? verdict : "");
    rig_close(&it);
  }
}

/* A grey table of 63 bytes, which is more than the interpreter copies at a time: all arrive, and what follows is understood. */
static uint8_t heard[80];
static unsigned heard_count;
static bool hear(virtual_bus *bus, bool *data, uint8_t *byte) {
  if (*data && bus->last_command == 0xB8 && heard_count < sizeof heard) heard[heard_count++] = *byte;
  return true;
}
static void test_a_command_with_63_bytes_of_data(void) {
  uint8_t *entry;
  unsigned i;
  const char *verdict;
  open_copy(&fc_panel_ssd1351, false);
  entry = entry_of(0xB9);
  memmove(entry + 2 + 63, entry + 2, table_bytes(init) - (size_t)(entry + 2 - init));
  entry[0] = 0xB8;
  entry[1] = 63;
  for (i = 0; i < 63; i++) entry[2 + i] = (uint8_t)(3 * i + 1);
  heard_count = 0;
  it.bus.filter = hear;
  verdict = draw();
  TEST_ASSERT_TRUE_MESSAGE(verdict == NULL, verdict != NULL ? verdict : "");
  TEST_ASSERT_EQUAL_UINT(63, heard_count);
  TEST_ASSERT_EQUAL_HEX8_ARRAY(entry + 2, heard, 63);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_command_with_63_bytes_of_data);
  RUN_TEST(test_copies_without_a_mistake_show_the_picture);
  RUN_TEST(test_each_mistake_is_noticed);
  return UNITY_END();
}
