/* What buttons do to the animation. */
#include "controls.h"

#include "firmware.h"
#include "orbit.h"
#include "unity.h"

static fc_controls controls;

void setUp(void) { fc_controls_start(&controls); }
void tearDown(void) {}

/* A press, and the release before it that makes a button count. */
static void press(uint8_t button) {
  fc_controls_buttons(&controls, 0);
  fc_controls_buttons(&controls, button);
}

static uint8_t next(void) {
  fc_controls_advance(&controls);
  return controls.step;
}

static void test_without_buttons_steps_follow_one_another_round_and_round(void) {
  unsigned i;
  for (i = 1; i <= 2 * FC_ORBIT_STEPS; i++) TEST_ASSERT_EQUAL_INT((int)(i % FC_ORBIT_STEPS), next());
}

static void test_pause_holds_the_step_until_it_is_pressed_again(void) {
  (void)next();
  press(FC_BUTTON_PAUSE);
  TEST_ASSERT_EQUAL_INT(1, next());
  TEST_ASSERT_EQUAL_INT(1, next());
  press(FC_BUTTON_PAUSE);
  TEST_ASSERT_EQUAL_INT(2, next());
}

static void test_a_button_that_is_held_is_one_press(void) {
  unsigned i;
  press(FC_BUTTON_PAUSE);
  for (i = 0; i < 9; i++) fc_controls_buttons(&controls, FC_BUTTON_PAUSE);
  TEST_ASSERT_TRUE(controls.paused);
}

static void test_reverse_goes_the_other_way_across_step_0(void) {
  (void)next();
  press(FC_BUTTON_REVERSE);
  TEST_ASSERT_EQUAL_INT(0, next());
  TEST_ASSERT_EQUAL_INT(59, next());
  press(FC_BUTTON_REVERSE);
  TEST_ASSERT_EQUAL_INT(0, next());
}

static void test_faster_doubles_the_stride_up_to_eight(void) {
  const int steps[] = {2, 6, 14, 22};
  unsigned i;
  for (i = 0; i < 4; i++) {
    press(FC_BUTTON_FASTER);
    TEST_ASSERT_EQUAL_INT(steps[i], next());
  }
}

static void test_slower_halves_it_down_to_one(void) {
  press(FC_BUTTON_FASTER);
  press(FC_BUTTON_FASTER);
  press(FC_BUTTON_SLOWER);
  TEST_ASSERT_EQUAL_INT(2, next());
  press(FC_BUTTON_SLOWER);
  press(FC_BUTTON_SLOWER);
  TEST_ASSERT_EQUAL_INT(3, next());
}

static void test_the_pattern_shows_while_its_button_is_held(void) {
  press(FC_BUTTON_PATTERN);
  TEST_ASSERT_TRUE(controls.pattern);
  fc_controls_buttons(&controls, FC_BUTTON_PATTERN);
  TEST_ASSERT_TRUE(controls.pattern);
  fc_controls_buttons(&controls, 0);
  TEST_ASSERT_FALSE(controls.pattern);
}

/* Inputs of a board without buttons, or in an emulator, may read as held for ever. */
static void test_a_button_counts_only_once_it_was_seen_released(void) {
  fc_controls_buttons(&controls, 0xff);
  fc_controls_buttons(&controls, 0xff);
  TEST_ASSERT_FALSE(controls.paused);
  TEST_ASSERT_FALSE(controls.pattern);
  fc_controls_buttons(&controls, 0xff ^ FC_BUTTON_PAUSE);
  fc_controls_buttons(&controls, 0xff);
  TEST_ASSERT_TRUE(controls.paused);
  TEST_ASSERT_FALSE(controls.pattern);
  TEST_ASSERT_FALSE(controls.reverse);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_without_buttons_steps_follow_one_another_round_and_round);
  RUN_TEST(test_pause_holds_the_step_until_it_is_pressed_again);
  RUN_TEST(test_a_button_that_is_held_is_one_press);
  RUN_TEST(test_reverse_goes_the_other_way_across_step_0);
  RUN_TEST(test_faster_doubles_the_stride_up_to_eight);
  RUN_TEST(test_slower_halves_it_down_to_one);
  RUN_TEST(test_the_pattern_shows_while_its_button_is_held);
  RUN_TEST(test_a_button_counts_only_once_it_was_seen_released);
  return UNITY_END();
}
