/* One test that passes and one that fails: the way from an assertion to the exit code is tested with it. */
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

static void test_holds(void) { TEST_ASSERT_EQUAL_INT32(1, 1); }

static void test_fails(void) { TEST_ASSERT_EQUAL_INT32(1, 2); }

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_holds);
  RUN_TEST(test_fails);
  return UNITY_END();
}
