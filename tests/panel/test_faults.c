/* A bus that fails: at every byte of a start and a frame, in every way. Its error comes out unchanged, nothing hangs, and the panel starts again. */
#include <string.h>

#include "rig.h"
#include "unity.h"

static rig it;
static fc_panel small; /* a copy of a record with few rows, so that every byte can be tried */

void setUp(void) {}
void tearDown(void) { rig_close(&it); }

static void open_small(const fc_panel *panel, bool asynchronous, uint16_t height) {
  small = *panel;
  small.height = height;
  rig_open(&it, &small, asynchronous, false, false);
}

static void assert_picture(void) {
  const char *verdict = rig_verdict(&it);
  if (verdict != NULL) TEST_FAIL_MESSAGE(verdict);
}

/* Nothing is left of what went wrong but what is in the controller. */
static void end_of_faults(void) {
  it.bus.fault = VIRTUAL_NO_FAULT;
  virtual_finish(it.panel);
  it.panel->errors = 0;
}

/* Starts and draws a frame with a fault at byte n; returns whether the fault was met. */
static bool try_fault(const fc_panel *panel, virtual_fault fault, uint64_t n, uint64_t start_bytes) {
  const int code = fault == VIRTUAL_STUCK ? FC_ERR_BUS : VIRTUAL_FAULT_CODE;
  int error;
  bool met;
  open_small(panel, fault != VIRTUAL_FAIL || n % 2 == 1, 8);
  it.bus.fault = fault;
  it.bus.fault_at = n;
  error = rig_start(&it);
  if (error != FC_OK) {
    TEST_ASSERT_EQUAL_INT(code, error);
    TEST_ASSERT_TRUE_MESSAGE(fault == VIRTUAL_FAIL && n <= start_bytes, "the start sends everything itself");
    TEST_ASSERT_NULL_MESSAGE(it.display.ops, "no display after a failed start");
    met = true;
  } else {
    rig_noise(&it, 9);
    error = rig_draw(&it, 4);
    met = error != FC_OK;
    if (met) TEST_ASSERT_EQUAL_INT(code, error);
    if (met && panel->window == FC_WINDOW_MIPI) { /* goes on without a start: the window is opened anew */
      end_of_faults();
      TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 4));
      assert_picture();
    }
  }
  end_of_faults();
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
  rig_noise(&it, 10);
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 4));
  assert_picture();
  rig_close(&it);
  return met;
}

static void every_byte(virtual_fault fault, const fc_panel *panel) {
  uint64_t start_bytes, all_bytes, n;
  open_small(panel, false, 8);
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
  start_bytes = it.bus.bytes;
  rig_noise(&it, 9);
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 4));
  all_bytes = it.bus.bytes;
  TEST_ASSERT_TRUE(start_bytes > 5 && all_bytes > start_bytes + 200);
  rig_close(&it);
  for (n = 0; n < all_bytes; n++)
    TEST_ASSERT_TRUE_MESSAGE(try_fault(panel, fault, n, start_bytes), "the fault was not told");
  TEST_ASSERT_FALSE_MESSAGE(
      try_fault(panel, fault == VIRTUAL_STUCK ? VIRTUAL_NO_FAULT : fault, all_bytes + 1, start_bytes),
      "a fault after the end");
}

static void test_a_transfer_that_fails_at_any_byte(void) {
  every_byte(VIRTUAL_FAIL, &fc_panel_st7789_135);
  every_byte(VIRTUAL_FAIL, &fc_panel_ssd1351);
}
static void oled_fails_at_any_byte(const fc_panel *panel) {
  uint64_t n;
  /* Glass and multiplex ratio belong together: these stay whole. */
  for (n = 0;; n++) {
    int error;
    rig_open(&it, panel, n % 2 == 1, false, false);
    it.bus.fault = VIRTUAL_FAIL;
    it.bus.fault_at = n;
    error = rig_start(&it);
    rig_noise(&it, 9);
    if (error == FC_OK) error = rig_draw(&it, 16);
    if (error == FC_OK) {
      rig_close(&it);
      break;
    }
    TEST_ASSERT_EQUAL_INT(VIRTUAL_FAULT_CODE, error);
    end_of_faults();
    TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
    rig_noise(&it, 10);
    TEST_ASSERT_EQUAL_INT(FC_OK, rig_draw(&it, 16));
    assert_picture();
    rig_close(&it);
  }
  TEST_ASSERT_TRUE(n > 1000);
}
static void test_a_transfer_that_fails_at_any_byte_of_an_oled(void) {
  oled_fails_at_any_byte(&fc_panel_ssd1306);
  oled_fails_at_any_byte(&fc_panel_ssd0323);
}
static void test_ready_with_an_error_at_any_byte(void) {
  every_byte(VIRTUAL_READY_FAILS, &fc_panel_st7789_135);
}
static void test_a_transfer_that_never_ends(void) {
  TEST_ASSERT_TRUE(try_fault(&fc_panel_st7789_135, VIRTUAL_STUCK, 0, 0));
  TEST_ASSERT_TRUE(try_fault(&fc_panel_ssd1351, VIRTUAL_STUCK, 0, 0));
}

typedef struct told {
  unsigned calls;
  int error;
} told;
static void tell(void *context, int error) {
  told *it_was = context;
  it_was->calls++;
  it_was->error = error;
}

/* An error is told to `ready`, and by the next call, once; then the panel is usable. */
static void test_an_error_of_a_started_transfer_is_told_by_the_next_call_once(void) {
  static uint8_t pixels[135 * 2 * 8];
  const fc_area area = {0, 0, 135, 8};
  told was = {0, FC_OK};
  open_small(&fc_panel_st7789_135, true, 16);
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
  it.bus.fault = VIRTUAL_READY_FAILS;
  it.bus.fault_at = it.bus.bytes + 500;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_write_start(&it.display, &area, pixels, 270, tell, &was));
  virtual_bus_run(&it.bus);
  TEST_ASSERT_EQUAL_UINT(1, was.calls);
  TEST_ASSERT_EQUAL_INT(VIRTUAL_FAULT_CODE, was.error);
  end_of_faults();
  TEST_ASSERT_EQUAL_INT(VIRTUAL_FAULT_CODE, fc_display_write(&it.display, &area, pixels, 270));
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_wait(&it.display));
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_write(&it.display, &area, pixels, 270));
  TEST_ASSERT_EQUAL_UINT(1, was.calls);
}

/* Rows that would have gone on in the window of a failed transfer get one of their own: nobody knows where the controller is. */
static void test_after_a_failed_transfer_the_window_is_opened_anew(void) {
  static uint8_t pixels[135 * 2 * 8];
  const fc_area first = {0, 0, 135, 8}, second = {0, 8, 135, 8};
  unsigned asynchronous;
  for (asynchronous = 0; asynchronous < 2; asynchronous++) {
    unsigned long windows;
    int error;
    open_small(&fc_panel_st7789_135, asynchronous != 0, 16);
    TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
    it.bus.fault = asynchronous ? VIRTUAL_READY_FAILS : VIRTUAL_FAIL;
    it.bus.fault_at = it.bus.bytes + 500;
    error = fc_display_write_start(&it.display, &first, pixels, 270, NULL, NULL);
    if (error == FC_OK) error = fc_display_wait(&it.display);
    TEST_ASSERT_EQUAL_INT(VIRTUAL_FAULT_CODE, error);
    end_of_faults();
    windows = it.panel->windows;
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_write(&it.display, &second, pixels, 270));
    TEST_ASSERT_EQUAL_UINT32(1, it.panel->windows - windows);
    rig_close(&it);
  }
}

/* `ready` is not called when write_start itself has returned the error. */
static void test_ready_is_not_called_for_an_error_that_was_returned(void) {
  static uint8_t pixels[135 * 2 * 8];
  const fc_area area = {0, 0, 135, 8};
  unsigned asynchronous;
  for (asynchronous = 0; asynchronous < 2; asynchronous++) {
    told was = {0, FC_OK};
    open_small(&fc_panel_st7789_135, asynchronous != 0, 16);
    TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
    it.bus.fault = VIRTUAL_FAIL;
    it.bus.fault_at = it.bus.bytes + 500;
    TEST_ASSERT_EQUAL_INT(VIRTUAL_FAULT_CODE,
                          fc_display_write_start(&it.display, &area, pixels, 270, tell, &was));
    TEST_ASSERT_EQUAL_UINT(0, was.calls);
    rig_close(&it);
  }
}

static void test_a_clock_or_reset_that_fails(void) {
  open_small(&fc_panel_st7789_135, false, 16);
  it.bus.configure_error = FC_ERR_UNSUPPORTED;
  TEST_ASSERT_EQUAL_INT(FC_ERR_UNSUPPORTED, rig_start(&it));
  TEST_ASSERT_EQUAL_UINT(0, it.bus.bytes);
  it.bus.configure_error = FC_OK;
  it.bus.reset_error = -99;
  TEST_ASSERT_EQUAL_INT(-99, rig_start(&it));
  TEST_ASSERT_EQUAL_UINT(0, it.bus.bytes);
  it.bus.reset_error = FC_OK;
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
}

static void test_stop_tries_everything_and_tells_the_first_error(void) {
  open_small(&fc_panel_st7789_135, false, 16);
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
  it.bus.fault = VIRTUAL_FAIL;
  it.bus.fault_at = it.bus.bytes;
  TEST_ASSERT_EQUAL_INT(VIRTUAL_FAULT_CODE, fc_panel_stop(&it.state));
  TEST_ASSERT_EQUAL_UINT_MESSAGE(0, it.bus.last_backlight, "the light is off all the same");
}

/* Neither starting nor stopping disturbs pixels that are under way: they wait. */
static void test_start_and_stop_wait_for_what_is_under_way(void) {
  static uint8_t pixels[135 * 2 * 8];
  const fc_area area = {0, 0, 135, 8};
  unsigned stop;
  for (stop = 0; stop < 2; stop++) {
    told was = {0, FC_OK};
    unsigned long drawn;
    open_small(&fc_panel_st7789_135, true, 16);
    TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
    drawn = it.panel->pixels;
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_write_start(&it.display, &area, pixels, 270, tell, &was));
    TEST_ASSERT_EQUAL_INT(FC_OK, stop ? fc_panel_stop(&it.state) : rig_start(&it));
    TEST_ASSERT_EQUAL_UINT(1, was.calls);
    TEST_ASSERT_EQUAL_INT(FC_OK, was.error);
    TEST_ASSERT_EQUAL_UINT32(135 * 8, it.panel->pixels - drawn);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(0, it.panel->errors, it.panel->error);
    rig_close(&it);
  }
}

static void test_stop_tells_the_error_of_what_was_under_way(void) {
  static uint8_t pixels[135 * 2 * 8];
  const fc_area area = {0, 0, 135, 8};
  open_small(&fc_panel_st7789_135, true, 16);
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
  it.bus.fault = VIRTUAL_READY_FAILS;
  it.bus.fault_at = it.bus.bytes + 500;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_write_start(&it.display, &area, pixels, 270, NULL, NULL));
  virtual_bus_run(&it.bus);
  end_of_faults();
  TEST_ASSERT_EQUAL_INT(VIRTUAL_FAULT_CODE, fc_panel_stop(&it.state));
  TEST_ASSERT_FALSE_MESSAGE(it.panel->on, "the panel is off all the same");
}

static void test_what_start_refuses_it_refuses_before_a_byte_is_sent(void) {
  fc_bus no_ops = {NULL, NULL};
  open_small(&fc_panel_st7789_135, false, 16);
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_panel_start(NULL, it.record, &it.bus.bus, NULL, &it.display));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_panel_start(&it.state, NULL, &it.bus.bus, NULL, &it.display));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_panel_start(&it.state, it.record, NULL, NULL, &it.display));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_panel_start(&it.state, it.record, &no_ops, NULL, &it.display));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_panel_start(&it.state, it.record, &it.bus.bus, NULL, NULL));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_panel_stop(NULL));
  it.options.twelve_bit = 1; /* 135 columns have no whole bytes in 12 bits */
  TEST_ASSERT_EQUAL_INT(FC_ERR_UNSUPPORTED, rig_start(&it));
  TEST_ASSERT_EQUAL_UINT(0, it.bus.bytes);
  TEST_ASSERT_EQUAL_UINT(0, it.bus.resets);
}

static void test_pixel_clock_of_the_options(void) {
  open_small(&fc_panel_st7789_135, false, 16);
  it.options.pixel_hz = 24000000;
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
  TEST_ASSERT_EQUAL_UINT32(24000000, it.panel->hz);
  it.options.pixel_hz = 0;
  TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
  TEST_ASSERT_EQUAL_UINT32(62500000, it.panel->hz);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_what_start_refuses_it_refuses_before_a_byte_is_sent);
  RUN_TEST(test_a_clock_or_reset_that_fails);
  RUN_TEST(test_pixel_clock_of_the_options);
  RUN_TEST(test_a_transfer_that_fails_at_any_byte);
  RUN_TEST(test_a_transfer_that_fails_at_any_byte_of_an_oled);
  RUN_TEST(test_ready_with_an_error_at_any_byte);
  RUN_TEST(test_a_transfer_that_never_ends);
  RUN_TEST(test_an_error_of_a_started_transfer_is_told_by_the_next_call_once);
  RUN_TEST(test_after_a_failed_transfer_the_window_is_opened_anew);
  RUN_TEST(test_ready_is_not_called_for_an_error_that_was_returned);
  RUN_TEST(test_start_and_stop_wait_for_what_is_under_way);
  RUN_TEST(test_stop_tells_the_error_of_what_was_under_way);
  RUN_TEST(test_stop_tries_everything_and_tells_the_first_error);
  return UNITY_END();
}
