/* error.h: every code has a text of its own. */
#include "fixcast/error.h"

#include <limits.h>

#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  FIRST = FC_OK,
  LAST = FC_ERR_LENS
};

static int same(const char *a, const char *b) {
  while (*a == *b && *a != '\0') {
    a++;
    b++;
  }
  return *a == *b;
}

static void test_unknown_codes_have_a_text(void) {
  static const int unknown[] = {LAST - 1, -1000, -INT_MAX, INT_MIN};
  unsigned i;
  for (i = 0; i < sizeof unknown / sizeof unknown[0]; i++) {
    TEST_ASSERT_NOT_NULL(fc_error_text(unknown[i]));
    TEST_ASSERT_EQUAL_STRING(fc_error_text(unknown[0]), fc_error_text(unknown[i]));
    TEST_ASSERT_TRUE(fc_error_text(unknown[i])[0] != '\0');
  }
}

/* Functions that count return more than 0 on success. */
static void test_positive_results_are_no_error(void) {
  TEST_ASSERT_EQUAL_STRING(fc_error_text(FC_OK), fc_error_text(1));
  TEST_ASSERT_EQUAL_STRING(fc_error_text(FC_OK), fc_error_text(INT_MAX));
}

static void test_every_code_has_its_own_text(void) {
  int a, b;
  for (a = FIRST; a >= LAST; a--) {
    TEST_ASSERT_NOT_NULL(fc_error_text(a));
    TEST_ASSERT_TRUE(fc_error_text(a)[0] != '\0');
    for (b = LAST - 1; b < a; b++) /* LAST - 1: the text of unknown codes */
      TEST_ASSERT_FALSE_MESSAGE(same(fc_error_text(a), fc_error_text(b)), fc_error_text(a));
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_unknown_codes_have_a_text);
  RUN_TEST(test_positive_results_are_no_error);
  RUN_TEST(test_every_code_has_its_own_text);
  return UNITY_END();
}
