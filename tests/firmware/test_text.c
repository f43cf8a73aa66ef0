/* Printed numbers, against the C library's. */
#include "text.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "unity.h"

static char got[64];
static size_t used;

static void put(void *context, char c) {
  TEST_ASSERT_TRUE(context == got);
  if (used < sizeof got - 1) got[used++] = c;
  got[used] = '\0';
}

static const fc_text out = {put, got};

void setUp(void) {
  used = 0;
  got[0] = '\0';
}
void tearDown(void) {}

static const uint32_t values[] = {0, 1, 9, 10, 99, 100, 12345, 65535, 65536,
                                  999999999, 1000000000, 2147483647, 2147483648, 4294967295, 4000000000, 3000000001, 0xdeadbeef, 0x0a0b0c0d};
enum {
  COUNT = sizeof values / sizeof values[0]
};

static void test_unsigned_numbers_of_all_lengths(void) {
  char expected[64];
  size_t i;
  for (i = 0; i < COUNT; i++) {
    setUp();
    fc_text_unsigned(&out, values[i]);
    snprintf(expected, sizeof expected, "%" PRIu32, values[i]);
    TEST_ASSERT_EQUAL_STRING(expected, got);
  }
}

static void test_signed_numbers_to_both_ends(void) {
  const int32_t numbers[] = {0, 1, -1, 42, -20, INT32_MAX, -INT32_MAX, INT32_MIN};
  char expected[64];
  size_t i;
  for (i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
    setUp();
    fc_text_signed(&out, numbers[i]);
    snprintf(expected, sizeof expected, "%" PRId32, numbers[i]);
    TEST_ASSERT_EQUAL_STRING(expected, got);
  }
}

static void test_tenths_have_one_digit_behind_the_point(void) {
  char expected[64];
  size_t i;
  for (i = 0; i < COUNT; i++) {
    setUp();
    fc_text_tenths(&out, values[i]);
    snprintf(expected, sizeof expected, "%" PRIu32 ".%" PRIu32, values[i] / 10, values[i] % 10);
    TEST_ASSERT_EQUAL_STRING(expected, got);
  }
}

static void test_hexadecimal_numbers_have_eight_digits(void) {
  char expected[64];
  size_t i;
  for (i = 0; i < COUNT; i++) {
    setUp();
    fc_text_hex(&out, values[i]);
    snprintf(expected, sizeof expected, "%08" PRIx32, values[i]);
    TEST_ASSERT_EQUAL_STRING(expected, got);
  }
}

static void test_strings_one_after_the_other(void) {
  fc_text_rom(&out, FC_TEXT("frame "));
  fc_text_ram(&out, "seven");
  fc_text_rom(&out, FC_TEXT(""));
  TEST_ASSERT_EQUAL_STRING("frame seven", got);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_unsigned_numbers_of_all_lengths);
  RUN_TEST(test_signed_numbers_to_both_ends);
  RUN_TEST(test_tenths_have_one_digit_behind_the_point);
  RUN_TEST(test_hexadecimal_numbers_have_eight_digits);
  RUN_TEST(test_strings_one_after_the_other);
  return UNITY_END();
}
