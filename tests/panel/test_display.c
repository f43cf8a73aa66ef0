/* The front door of a display sink: what it refuses, what it makes up for, what it passes on. */
#include <string.h>

#include "fixcast/display.h"
#include "fixcast/error.h"
#include "unity.h"

/* A sink of 40x16 that notes what reaches it. */
static fc_display_capabilities can;
static unsigned writes, starts, waits;
static fc_area last;
static const void *last_pixels;
static size_t last_pitch;
static int answer;

static void sink_capabilities(void *context, fc_display_capabilities *to) {
  (void)context;
  *to = can;
}
static int sink_write(void *context, const fc_area *area, const void *pixels, size_t pitch_bytes) {
  (void)context;
  writes++;
  last = *area;
  last_pixels = pixels;
  last_pitch = pitch_bytes;
  return answer;
}
static int sink_write_start(void *context, const fc_area *area, const void *pixels, size_t pitch_bytes,
                            fc_ready *ready, void *ready_context) {
  (void)context, (void)area, (void)pixels, (void)pitch_bytes, (void)ready, (void)ready_context;
  starts++;
  return answer;
}
static int sink_wait(void *context) {
  (void)context;
  waits++;
  return answer;
}
static int sink_level(void *context, uint8_t level) {
  (void)context;
  return -100 - level;
}

static const fc_display_ops plain_ops = {.capabilities = sink_capabilities, .write = sink_write};
static const fc_display_ops rich_ops = {.capabilities = sink_capabilities,
                                        .write = sink_write,
                                        .write_start = sink_write_start,
                                        .wait = sink_wait,
                                        .flush = sink_wait,
                                        .backlight = sink_level,
                                        .wait_vsync = sink_wait};
static const fc_display plain = {&plain_ops, NULL}, rich = {&rich_ops, NULL};
static const uint8_t pixels[40 * 2 * 16];

void setUp(void) {
  const fc_display_capabilities all = {
      .width = 40, .height = 16, .format = FC_DISPLAY_RGB565, .asynchronous = 1, .x_align = 1, .y_align = 1};
  can = all;
  writes = starts = waits = 0;
  answer = FC_OK;
}
void tearDown(void) {}

static int write_area(uint16_t x, uint16_t y, uint16_t width, uint16_t height, size_t pitch) {
  const fc_area area = {x, y, width, height};
  const int error = fc_display_write(&plain, &area, pixels, pitch);
  /* write_start refuses the same. */
  TEST_ASSERT_EQUAL_INT(error, fc_display_write_start(&rich, &area, pixels, pitch, NULL, NULL));
  TEST_ASSERT_EQUAL_UINT(error == FC_OK ? 1 : 0, starts);
  TEST_ASSERT_EQUAL_UINT(error == FC_OK ? 1 : 0, writes);
  starts = writes = 0;
  return error;
}

static void test_areas_off_the_display_are_refused(void) {
  TEST_ASSERT_EQUAL_INT(FC_OK, write_area(0, 0, 40, 16, 80));
  TEST_ASSERT_EQUAL_INT(FC_OK, write_area(39, 15, 1, 1, 2));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(0, 0, 41, 16, 82));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(0, 0, 40, 17, 80));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(1, 0, 40, 16, 80));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(0, 1, 40, 16, 80));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(40, 0, 1, 1, 2));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(0, 16, 1, 1, 2));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(65535, 0, 2, 1, 4)); /* 65535 + 2 is 1 in 16 bits */
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(0, 65535, 1, 2, 2));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(39, 0, 65535, 1, 131070));
}
static void test_empty_areas_are_refused(void) {
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(0, 0, 0, 1, 80));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(0, 0, 1, 0, 80));
}
static void test_areas_that_are_not_aligned_are_refused(void) {
  can.x_align = 4;
  can.y_align = 8;
  TEST_ASSERT_EQUAL_INT(FC_OK, write_area(4, 8, 8, 8, 16));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(2, 8, 8, 8, 16));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(4, 4, 8, 8, 16));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(4, 8, 6, 8, 16));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(4, 8, 8, 4, 16));
}
static void test_a_pitch_below_a_row_is_refused(void) {
  static const struct {
    uint8_t format;
    size_t row; /* of 20 pixels */
  } cases[] = {
      {FC_DISPLAY_RGB565, 40}, {FC_DISPLAY_RGB444, 30}, {FC_DISPLAY_GREY4, 10}, {FC_DISPLAY_MONO8, 20}};
  size_t i;
  for (i = 0; i < sizeof cases / sizeof *cases; i++) {
    can.format = cases[i].format;
    TEST_ASSERT_EQUAL_size_t(cases[i].row, fc_display_row_bytes(cases[i].format, 20));
    TEST_ASSERT_EQUAL_INT(FC_OK, write_area(0, 0, 20, 8, cases[i].row));
    TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, write_area(0, 0, 20, 8, cases[i].row - 1));
  }
}
static void test_bytes_of_odd_rows_are_rounded_up(void) {
  TEST_ASSERT_EQUAL_size_t(5, fc_display_row_bytes(FC_DISPLAY_RGB444, 3));
  TEST_ASSERT_EQUAL_size_t(2, fc_display_row_bytes(FC_DISPLAY_RGB444, 1));
  TEST_ASSERT_EQUAL_size_t(2, fc_display_row_bytes(FC_DISPLAY_GREY4, 3));
  TEST_ASSERT_EQUAL_size_t(3, fc_display_row_bytes(FC_DISPLAY_MONO8, 3));
  TEST_ASSERT_EQUAL_size_t(0, fc_display_row_bytes(4, 3));
}
static void test_null_is_refused(void) {
  const fc_area area = {0, 0, 1, 1};
  const fc_display none = {NULL, NULL};
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_write(NULL, &area, pixels, 2));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_write(&none, &area, pixels, 2));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_write(&plain, NULL, pixels, 2));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_write(&plain, &area, NULL, 2));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_write_start(&none, &area, pixels, 2, NULL, NULL));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_wait(NULL));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_flush(&none));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_backlight(&none, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_wait_vsync(NULL));
}
static void test_what_is_accepted_arrives_as_it_was(void) {
  const fc_area area = {3, 5, 7, 2};
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_write(&plain, &area, pixels + 9, 33));
  TEST_ASSERT_EQUAL_INT(0, memcmp(&last, &area, sizeof area));
  TEST_ASSERT_EQUAL_PTR(pixels + 9, last_pixels);
  TEST_ASSERT_EQUAL_size_t(33, last_pitch);
}

static unsigned calls;
static int told;
static void ready(void *context, int error) {
  ++*(unsigned *)context;
  told = error;
}
static void test_without_write_start_ready_is_called_before_it_returns(void) {
  const fc_area area = {0, 0, 4, 4};
  calls = 0;
  told = 1;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_write_start(&plain, &area, pixels, 8, ready, &calls));
  TEST_ASSERT_EQUAL_UINT(1, writes);
  TEST_ASSERT_EQUAL_UINT(1, calls);
  TEST_ASSERT_EQUAL_INT(FC_OK, told);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_write_start(&plain, &area, pixels, 8, NULL, NULL));
  answer = -55;
  TEST_ASSERT_EQUAL_INT(-55, fc_display_write_start(&plain, &area, pixels, 8, ready, &calls));
  TEST_ASSERT_EQUAL_UINT_MESSAGE(1, calls, "an error is returned, not told to ready");
}
static void test_a_display_that_is_not_asynchronous_now_gets_write(void) {
  const fc_area area = {0, 0, 4, 4};
  calls = 0;
  can.asynchronous = 0;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_write_start(&rich, &area, pixels, 8, ready, &calls));
  TEST_ASSERT_EQUAL_UINT(0, starts);
  TEST_ASSERT_EQUAL_UINT(1, writes);
  TEST_ASSERT_EQUAL_UINT(1, calls);
}
static void test_talents_that_are_missing_say_so(void) {
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_wait(&plain));
  TEST_ASSERT_EQUAL_INT(FC_ERR_UNSUPPORTED, fc_display_flush(&plain));
  TEST_ASSERT_EQUAL_INT(FC_ERR_UNSUPPORTED, fc_display_backlight(&plain, 3));
  TEST_ASSERT_EQUAL_INT(FC_ERR_UNSUPPORTED, fc_display_wait_vsync(&plain));
}
static void test_codes_of_the_sink_come_out_unchanged(void) {
  const fc_area area = {0, 0, 4, 4};
  answer = -4711;
  TEST_ASSERT_EQUAL_INT(-4711, fc_display_write(&rich, &area, pixels, 8));
  TEST_ASSERT_EQUAL_INT(-4711, fc_display_write_start(&rich, &area, pixels, 8, NULL, NULL));
  TEST_ASSERT_EQUAL_INT(-4711, fc_display_wait(&rich));
  TEST_ASSERT_EQUAL_INT(-4711, fc_display_flush(&rich));
  TEST_ASSERT_EQUAL_INT(-4711, fc_display_wait_vsync(&rich));
  TEST_ASSERT_EQUAL_INT(-107, fc_display_backlight(&rich, 7));
  TEST_ASSERT_EQUAL_UINT(3, waits);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_areas_off_the_display_are_refused);
  RUN_TEST(test_empty_areas_are_refused);
  RUN_TEST(test_areas_that_are_not_aligned_are_refused);
  RUN_TEST(test_a_pitch_below_a_row_is_refused);
  RUN_TEST(test_bytes_of_odd_rows_are_rounded_up);
  RUN_TEST(test_null_is_refused);
  RUN_TEST(test_what_is_accepted_arrives_as_it_was);
  RUN_TEST(test_without_write_start_ready_is_called_before_it_returns);
  RUN_TEST(test_a_display_that_is_not_asynchronous_now_gets_write);
  RUN_TEST(test_talents_that_are_missing_say_so);
  RUN_TEST(test_codes_of_the_sink_come_out_unchanged);
  return UNITY_END();
}
