/* The queue of strips against a display whose transfers end when the test, or a wait, says so. */
#include "queue.h"

#include <string.h>

#include "fixcast/error.h"
#include "unity.h"

enum {
  STARTS = 64
};

static struct {
  const void *started[STARTS];
  unsigned count, waits;
  fc_ready *ready; /* of what is under way, or NULL */
  void *context;
  unsigned fail_at;   /* number of the start that fails, from 1; 0: none */
  unsigned end_early; /* from this start on, each ends before it returns */
} fake;

static fc_queue queue;
static const uint8_t pixels[STARTS];

static void end_transfer(int error) {
  fc_ready *ready = fake.ready;
  TEST_ASSERT_NOT_NULL_MESSAGE(ready, "nothing is under way");
  fake.ready = NULL;
  ready(fake.context, error);
}

static int fake_start(void *context, const fc_area *area, const void *from, size_t pitch, fc_ready *ready, void *ready_context) {
  (void)context;
  TEST_ASSERT_NULL_MESSAGE(fake.ready, "a transfer is started while another is under way");
  TEST_ASSERT_EQUAL_UINT16((const uint8_t *)from - pixels, area->y);
  TEST_ASSERT_EQUAL_UINT(2 * area->y + 8, pitch);
  fake.started[fake.count++] = from;
  if (fake.count == fake.fail_at) return FC_ERR_BUS;
  fake.ready = ready;
  fake.context = ready_context;
  if (fake.end_early != 0 && fake.count >= fake.end_early) end_transfer(FC_OK);
  return FC_OK;
}

static int fake_wait(void *context) {
  (void)context;
  fake.waits++;
  if (fake.ready != NULL) end_transfer(FC_OK);
  return FC_OK;
}

static void fake_capabilities(void *context, fc_display_capabilities *to) {
  (void)context;
  to->width = 4;
  to->height = STARTS;
  to->format = FC_DISPLAY_RGB565;
  to->x_align = to->y_align = 1;
  to->asynchronous = 1;
}

static const fc_display_ops ops = {.capabilities = fake_capabilities, .write_start = fake_start, .wait = fake_wait};
static const fc_display display = {&ops, NULL};

void setUp(void) {
  memset(&fake, 0, sizeof fake);
  fc_queue_start(&queue, &display);
}

void tearDown(void) {}

static void add(uint16_t number) {
  const fc_area area = {0, number, 4, 1};
  fc_queue_add(&queue, &area, pixels + number, 2u * number + 8u);
}

static void expect_started(unsigned count) {
  unsigned i;
  TEST_ASSERT_EQUAL_UINT(count, fake.count);
  for (i = 0; i < count; i++) TEST_ASSERT_EQUAL_PTR(pixels + i, fake.started[i]);
}

static void test_first_strip_starts_at_once_and_others_when_one_has_left(void) {
  add(0);
  expect_started(1);
  add(1);
  add(2);
  expect_started(1);
  end_transfer(FC_OK);
  expect_started(2);
  end_transfer(FC_OK);
  expect_started(3);
  end_transfer(FC_OK);
  expect_started(3);
}

static void test_queue_that_ran_dry_starts_again(void) {
  add(0);
  end_transfer(FC_OK);
  add(1);
  expect_started(2);
  TEST_ASSERT_NOT_NULL(fake.ready);
}

static void test_wait_returns_as_soon_as_few_enough_are_left(void) {
  add(0);
  add(1);
  add(2);
  add(3);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_queue_wait(&queue, 3));
  TEST_ASSERT_EQUAL_UINT(1, fake.waits);
  expect_started(2);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_queue_wait(&queue, 3));
  TEST_ASSERT_EQUAL_UINT(1, fake.waits);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_queue_wait(&queue, 0));
  TEST_ASSERT_EQUAL_UINT(4, fake.waits);
  expect_started(4);
}

static void test_hundreds_of_strips_go_out_once_each_in_order(void) {
  uint16_t i, round;
  for (round = 0; round < 20; round++) {
    fake.count = 0;
    for (i = 0; i < 30; i++) {
      add(i);
      if ((i + round) % 3 == 0 && fake.ready != NULL) end_transfer(FC_OK);
      TEST_ASSERT_EQUAL_INT(FC_OK, fc_queue_wait(&queue, (uint8_t)(round % FC_QUEUE_STRIPS)));
    }
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_queue_wait(&queue, 0));
    expect_started(30);
  }
}

static void test_transfers_that_end_before_start_returns_are_counted(void) {
  uint16_t i;
  fake.end_early = 1;
  for (i = 0; i < 10; i++) add(i);
  expect_started(10);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_queue_wait(&queue, 0));
  TEST_ASSERT_EQUAL_UINT(0, fake.waits);
}

static void test_error_of_a_transfer_is_told_and_nothing_follows(void) {
  add(0);
  add(1);
  end_transfer(-77);
  TEST_ASSERT_EQUAL_INT(-77, fc_queue_wait(&queue, 3));
  TEST_ASSERT_EQUAL_INT(-77, fc_queue_wait(&queue, 0));
  add(2);
  expect_started(1);
}

static void test_error_of_a_start_is_told_and_nothing_follows(void) {
  fake.fail_at = 2;
  add(0);
  add(1);
  end_transfer(FC_OK);
  TEST_ASSERT_EQUAL_INT(FC_ERR_BUS, fc_queue_wait(&queue, 0));
  add(2);
  expect_started(2);
}

static void test_after_an_error_it_can_be_started_anew(void) {
  add(0);
  end_transfer(-77);
  fc_queue_start(&queue, &display);
  fake.count = 0;
  add(0);
  expect_started(1);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_queue_wait(&queue, 0));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_first_strip_starts_at_once_and_others_when_one_has_left);
  RUN_TEST(test_queue_that_ran_dry_starts_again);
  RUN_TEST(test_wait_returns_as_soon_as_few_enough_are_left);
  RUN_TEST(test_hundreds_of_strips_go_out_once_each_in_order);
  RUN_TEST(test_transfers_that_end_before_start_returns_are_counted);
  RUN_TEST(test_error_of_a_transfer_is_told_and_nothing_follows);
  RUN_TEST(test_error_of_a_start_is_told_and_nothing_follows);
  RUN_TEST(test_after_an_error_it_can_be_started_anew);
  return UNITY_END();
}
