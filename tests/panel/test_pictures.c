/* What is written to each panel is what its glass shows, bit for bit: strips of all heights, both ways up, synchronous or not. */
#include <stdio.h>
#include <string.h>

#include "rig.h"
#include "unity.h"

static rig it;

void setUp(void) {}
void tearDown(void) { rig_close(&it); }

/* Calls `test` for each panel, way up, kind of bus, and number of bits. */
static void for_each(void (*test)(void)) {
  const fc_panel *const *record;
  unsigned variant;
  for (record = fc_panels; *record != NULL; record++) {
    for (variant = 0; variant < 8; variant++) {
      const bool asynchronous = variant & 1, half_turn = variant & 2, twelve_bit = variant & 4;
      if (twelve_bit && (*record)->format12 == NULL) continue;
      rig_open(&it, *record, asynchronous, half_turn, twelve_bit);
      TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
      test();
      rig_close(&it);
    }
  }
}

static void assert_picture(void) {
  const char *verdict = rig_verdict(&it);
  if (verdict != NULL) TEST_FAIL_MESSAGE(verdict);
}

static void sixty_frames(void) {
  const uint32_t frames = it.options.half_turn || it.options.twelve_bit ? 6 : 60;
  uint32_t frame;
  for (frame = 0; frame < frames; frame++) {
    const unsigned long windows = it.panel->windows;
    rig_noise(&it, frame);
    TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 16));
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(1, it.panel->windows - windows, "window commands a frame");
    if (frame % 29 == 1 || frame == frames - 1) assert_picture();
  }
}
static void test_sixty_frames_in_strips_of_16_rows_with_one_window_command_each(void) {
  for_each(sixty_frames);
}

static void strip_heights(void) {
  const uint16_t heights[] = {1, 7, 8, 24, it.can.height};
  uint32_t i;
  for (i = 0; i < FC_COUNT_OF(heights); i++) {
    const unsigned long windows = it.panel->windows, pixels = it.panel->pixels;
    if (heights[i] % it.can.y_align != 0) continue;
    rig_noise(&it, 100 + i);
    TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, heights[i]));
    assert_picture();
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(1, it.panel->windows - windows, "window commands a frame");
    TEST_ASSERT_EQUAL_UINT32_MESSAGE((uint32_t)it.can.width * it.can.height, it.panel->pixels - pixels,
                                     "pixels a frame");
  }
}
static void test_strips_of_any_height_give_the_same_picture(void) { for_each(strip_heights); }

/* The last strip of one frame must not leak into the next when the buffer is used again too early. */
static void early_reuse(void) {
  static uint8_t buffer[RIG_BYTES_MAX];
  const fc_area area = {0, 0, it.can.width, 16};
  const size_t pitch = fc_display_row_bytes(it.can.format, it.can.width);
  if (!it.can.asynchronous) return;
  memset(buffer, 1, sizeof buffer);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_write_start(&it.display, &area, buffer, pitch, NULL, NULL));
  buffer[3] = 2;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_wait(&it.display));
  TEST_ASSERT_EQUAL_UINT32(1, it.panel->errors);
  TEST_ASSERT_NOT_NULL(strstr(it.panel->error, "changed while they were under way"));
}
static void test_the_rig_notices_a_buffer_that_is_changed_while_it_is_under_way(void) {
  for_each(early_reuse);
}

/* Areas anywhere, out of buffers with gaps between the rows, in between strips of the whole width. */
static void areas(void) {
  static uint8_t buffer[RIG_BYTES_MAX];
  const uint16_t step_x = it.can.x_align, step_y = it.can.y_align,
                 rows_a_byte = it.can.format == FC_DISPLAY_MONO8 ? 8 : 1;
  const size_t row = fc_display_row_bytes(it.can.format, it.can.width);
  uint32_t state = 5, i;
  rig_noise(&it, 1);
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 8));
  for (i = 0; i < 60; i++) {
    uint16_t random[4], k;
    size_t pitch, at, step;
    fc_area area;
    for (k = 0; k < 4; k++) {
      state = state * UINT32_C(1664525) + UINT32_C(1013904223);
      random[k] = (uint16_t)(state >> 16);
    }
    area.x = (uint16_t)(random[0] % (it.can.width / step_x) * step_x);
    area.y = (uint16_t)(random[1] % (it.can.height / step_y) * step_y);
    area.width = (uint16_t)((1 + random[2] % ((it.can.width - area.x) / step_x)) * step_x);
    area.height = (uint16_t)((1 + random[3] % ((it.can.height - area.y) / step_y)) * step_y);
    if (i % 4 == 0) area.x = 0, area.width = it.can.width;
    pitch = fc_display_row_bytes(it.can.format, area.width) + (i % 3) * 5;
    for (at = 0; at < pitch * area.height / rows_a_byte; at++) {
      state = state * UINT32_C(1664525) + UINT32_C(1013904223);
      buffer[at] = (uint8_t)(state >> 24);
    }
    /* The same into the picture, by whole bytes: x_align sees to that. */
    step = fc_display_row_bytes(it.can.format, area.x);
    for (k = 0; k < area.height / rows_a_byte; k++) {
      memcpy(it.picture + row * (size_t)(area.y / rows_a_byte + k) + step, buffer + pitch * k,
             fc_display_row_bytes(it.can.format, area.width));
    }
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_write_start(&it.display, &area, buffer, pitch, NULL, NULL));
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_wait(&it.display));
  }
  assert_picture();
}
static void test_areas_anywhere_from_buffers_with_gaps(void) { for_each(areas); }

static void ready_called(void *context, int error) {
  TEST_ASSERT_EQUAL_INT(FC_OK, error);
  ++*(unsigned *)context;
}
static void ready(void) {
  static uint8_t buffer[RIG_BYTES_MAX];
  unsigned calls = 0;
  const fc_area area = {0, 0, it.can.width, 8};
  const size_t pitch = fc_display_row_bytes(it.can.format, it.can.width);
  TEST_ASSERT_EQUAL_INT(FC_OK,
                        fc_display_write_start(&it.display, &area, buffer, pitch, ready_called, &calls));
  TEST_ASSERT_EQUAL_UINT(it.can.asynchronous ? 0 : 1, calls);
  virtual_bus_run(&it.bus);
  TEST_ASSERT_EQUAL_UINT(1, calls);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_wait(&it.display));
  TEST_ASSERT_EQUAL_UINT(1, calls);
}
static void test_ready_is_called_once_when_the_pixels_have_left(void) { for_each(ready); }

static void stop_and_start(void) {
  rig_noise(&it, 3);
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 16));
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_backlight(&it.display, 200));
  TEST_ASSERT_EQUAL_UINT(200, it.bus.last_backlight);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_panel_stop(&it.state));
  TEST_ASSERT_EQUAL_UINT(0, it.bus.last_backlight);
  TEST_ASSERT_FALSE_MESSAGE(it.panel->on, "the panel is off");
  TEST_ASSERT_EQUAL_UINT32(0, virtual_shown(it.panel, 1, 1));
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
  rig_noise(&it, 4);
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 8));
  assert_picture();
}
static void test_a_stopped_panel_is_dark_and_starts_again(void) { for_each(stop_and_start); }

static int vsync(void *context) {
  (void)context;
  return -33;
}
/* What the bus has wired, the display can; what it has not, it says. */
static void talents(void) {
  TEST_ASSERT_EQUAL_UINT(it.options.twelve_bit ? FC_DISPLAY_RGB444 : it.record->format, it.can.format);
  TEST_ASSERT_EQUAL_UINT(it.bus.ops.data_start != NULL, it.can.asynchronous);
  TEST_ASSERT_EQUAL_UINT(0, it.can.has_flush);
  TEST_ASSERT_EQUAL_UINT(1, it.can.has_backlight);
  TEST_ASSERT_EQUAL_UINT(0, it.can.has_vsync);
  TEST_ASSERT_EQUAL_INT(FC_ERR_UNSUPPORTED, fc_display_flush(&it.display));
  TEST_ASSERT_EQUAL_INT(FC_ERR_UNSUPPORTED, fc_display_wait_vsync(&it.display));
  it.bus.ops.backlight = NULL;
  it.bus.ops.wait_vsync = vsync;
  fc_display_capabilities_get(&it.display, &it.can);
  TEST_ASSERT_EQUAL_UINT(0, it.can.has_backlight);
  TEST_ASSERT_EQUAL_UINT(1, it.can.has_vsync);
  TEST_ASSERT_EQUAL_INT(FC_ERR_UNSUPPORTED, fc_display_backlight(&it.display, 9));
  TEST_ASSERT_EQUAL_INT(-33, fc_display_wait_vsync(&it.display));
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_panel_stop(&it.state));
}
static void test_talents_are_those_of_the_bus(void) { for_each(talents); }

/* Boards that do not wire the reset line. */
static void no_reset_line(void) {
  it.bus.ops.reset = NULL;
  virtual_open(it.panel, it.panel->model);
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
  rig_noise(&it, 5);
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 8));
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 16));
  assert_picture();
}
static void test_panels_start_and_restart_without_a_reset_line(void) { for_each(no_reset_line); }

static void test_every_panel_has_a_virtual_one_of_the_same_size(void) {
  const fc_panel *const *record;
  for (record = fc_panels; *record != NULL; record++) {
    const virtual_model *model = virtual_model_named((*record)->name);
    TEST_ASSERT_NOT_NULL_MESSAGE(model, (*record)->name);
    TEST_ASSERT_EQUAL_UINT16(model->width, (*record)->width);
    TEST_ASSERT_EQUAL_UINT16(model->height, (*record)->height);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_panel_has_a_virtual_one_of_the_same_size);
  RUN_TEST(test_sixty_frames_in_strips_of_16_rows_with_one_window_command_each);
  RUN_TEST(test_strips_of_any_height_give_the_same_picture);
  RUN_TEST(test_the_rig_notices_a_buffer_that_is_changed_while_it_is_under_way);
  RUN_TEST(test_areas_anywhere_from_buffers_with_gaps);
  RUN_TEST(test_ready_is_called_once_when_the_pixels_have_left);
  RUN_TEST(test_a_stopped_panel_is_dark_and_starts_again);
  RUN_TEST(test_talents_are_those_of_the_bus);
  RUN_TEST(test_panels_start_and_restart_without_a_reset_line);
  return UNITY_END();
}
