/*
 * Proves that the assertions of unity.h can fail: each runs once with values that hold and once with values that
 * don't, its output captured. This program judges without unity.h's own machinery.
 */
static char captured[512];
static unsigned captured_length;
static void capture(int c) {
  if (captured_length + 1 < sizeof captured) captured[captured_length++] = (char)c;
  captured[captured_length] = '\0';
}
#ifdef UNITY_INCLUDE_CONFIG_H
#include "unity_config.h"
#define REPORT_CHAR(c) semihost_char(c)
#define REPORT_FLUSH() semihost_flush()
#undef UNITY_INCLUDE_CONFIG_H /* unity.h prints into `captured` */
#undef UNITY_OUTPUT_CHAR
#undef UNITY_OUTPUT_FLUSH
#else
#include <stdio.h>
#define REPORT_CHAR(c) ((void)putchar(c))
#define REPORT_FLUSH() ((void)fflush(stdout))
#endif
#define UNITY_OUTPUT_CHAR(c) capture(c)
#include "unity.h"

static int set_up_calls, tear_down_calls, after_failure;
void setUp(void) { set_up_calls++; }
void tearDown(void) { tear_down_calls++; }

static const int32_t small[3] = {1, -2, 3}, other[3] = {1, -2, 4};
static const uint8_t bytes_a[4] = {1, 2, 3, 0xff}, bytes_b[4] = {1, 2, 3, 0xfe};
static const int64_t wide_a[2] = {INT64_MIN, 5}, wide_b[2] = {INT64_MAX, 5};
static int object;

/* CASE(name, an assertion that holds, one that fails, what its message must contain) */
#define CASES \
  CASE(assert_, TEST_ASSERT(2 > 1), TEST_ASSERT(1 > 2), "FALSE: 1 > 2") \
  CASE(true_, TEST_ASSERT_TRUE(2), TEST_ASSERT_TRUE(0), "Expected TRUE Was FALSE") \
  CASE(true_message, TEST_ASSERT_TRUE_MESSAGE(1, "m"), TEST_ASSERT_TRUE_MESSAGE(0, "why"), "FALSE why") \
  CASE(false_, TEST_ASSERT_FALSE(0), TEST_ASSERT_FALSE(4), "Expected FALSE Was TRUE") \
  CASE(false_message, TEST_ASSERT_FALSE_MESSAGE(0, "m"), TEST_ASSERT_FALSE_MESSAGE(1, "why"), "TRUE why") \
  CASE(message, TEST_ASSERT_MESSAGE(1, "m"), TEST_ASSERT_MESSAGE(0, "why"), "FALSE why") \
  CASE(unless, TEST_ASSERT_UNLESS(0), TEST_ASSERT_UNLESS(1), "Expected FALSE") \
  CASE(null_, TEST_ASSERT_NULL(NULL), TEST_ASSERT_NULL(&object), "Expected NULL") \
  CASE(not_null, TEST_ASSERT_NOT_NULL(&object), TEST_ASSERT_NOT_NULL(NULL), "Expected Non-NULL") \
  CASE(ptr, TEST_ASSERT_EQUAL_PTR(&object, &object), TEST_ASSERT_EQUAL_PTR(&object, small), "Expected 0x") \
  CASE(equal, TEST_ASSERT_EQUAL(1, 1), TEST_ASSERT_EQUAL(1, 2), "Expected 1 Was 2") \
  CASE(int_, TEST_ASSERT_EQUAL_INT(-7, -7), TEST_ASSERT_EQUAL_INT(-7, 7), "Expected -7 Was 7") \
  CASE(int_message, TEST_ASSERT_EQUAL_INT_MESSAGE(1, 1, "m"), TEST_ASSERT_EQUAL_INT_MESSAGE(1, 2, "why"), \
       "Expected 1 Was 2 why") \
  CASE(int8, TEST_ASSERT_EQUAL_INT8(-128, -128), TEST_ASSERT_EQUAL_INT8(-128, 127), "Expected -128 Was 127") \
  CASE(int16, TEST_ASSERT_EQUAL_INT16(-9, -9), TEST_ASSERT_EQUAL_INT16(-9, 9), "Expected -9 Was 9") \
  CASE(int32, TEST_ASSERT_EQUAL_INT32(INT32_MIN, INT32_MIN), TEST_ASSERT_EQUAL_INT32(INT32_MIN, INT32_MAX), \
       "Expected -2147483648 Was 2147483647") \
  CASE(int64, TEST_ASSERT_EQUAL_INT64(INT64_MIN, INT64_MIN), TEST_ASSERT_EQUAL_INT64(INT64_MIN, INT64_MAX), \
       "Expected -9223372036854775808 Was 9223372036854775807") \
  CASE(int64_high, TEST_ASSERT_EQUAL_INT64(1, 1), TEST_ASSERT_EQUAL_INT64(1, INT64_C(0x100000001)), \
       "Expected 1 Was 4294967297") \
  CASE(uint, TEST_ASSERT_EQUAL_UINT(4, 4), TEST_ASSERT_EQUAL_UINT(4, 5), "Expected 4 Was 5") \
  CASE(uint8, TEST_ASSERT_EQUAL_UINT8(255, 255), TEST_ASSERT_EQUAL_UINT8(255, 0), "Expected 255 Was 0") \
  CASE(uint16, TEST_ASSERT_EQUAL_UINT16(65535, 65535), TEST_ASSERT_EQUAL_UINT16(65535, 1), "Expected 65535") \
  CASE(uint32, TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, UINT32_MAX), TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, 0), \
       "Expected 4294967295 Was 0") \
  CASE(uint64, TEST_ASSERT_EQUAL_UINT64(UINT64_MAX, UINT64_MAX), TEST_ASSERT_EQUAL_UINT64(UINT64_MAX, 0), \
       "Expected 18446744073709551615 Was 0") \
  CASE(size, TEST_ASSERT_EQUAL_size_t(3, 3), TEST_ASSERT_EQUAL_size_t(3, 4), "Expected 3 Was 4") \
  CASE(hex8, TEST_ASSERT_EQUAL_HEX8(0xa5, 0xa5), TEST_ASSERT_EQUAL_HEX8(0xa5, 0x5a), \
       "Expected 0xA5 Was 0x5A") \
  CASE(hex16, TEST_ASSERT_EQUAL_HEX16(0xa5, 0xa5), TEST_ASSERT_EQUAL_HEX16(0xa5, 1), "0x00A5 Was 0x0001") \
  CASE(hex32, TEST_ASSERT_EQUAL_HEX32(0xdeadbeef, 0xdeadbeef), TEST_ASSERT_EQUAL_HEX32(0xdeadbeef, 1), \
       "Expected 0xDEADBEEF Was 0x00000001") \
  CASE(hex64, TEST_ASSERT_EQUAL_HEX64(1, 1), TEST_ASSERT_EQUAL_HEX64(1, UINT64_MAX), \
       "Was 0xFFFFFFFFFFFFFFFF") \
  CASE(not_equal, TEST_ASSERT_NOT_EQUAL(1, 2), TEST_ASSERT_NOT_EQUAL(2, 2), \
       "Expected 2 to be not equal to 2") \
  CASE(gt, TEST_ASSERT_GREATER_THAN(-1, 0), TEST_ASSERT_GREATER_THAN(0, 0), \
       "Expected 0 to be greater than 0") \
  CASE(gt_sign, TEST_ASSERT_GREATER_THAN_INT64(-1, 0), TEST_ASSERT_GREATER_THAN_INT64(0, -1), \
       "Expected -1 to") \
  CASE(gt_unsigned, TEST_ASSERT_GREATER_THAN_UINT64(1, UINT64_MAX), \
       TEST_ASSERT_GREATER_THAN_UINT64(UINT64_MAX, 1), "Expected 1 to be greater than 18446744073709551615") \
  CASE(lt, TEST_ASSERT_LESS_THAN(1, 0), TEST_ASSERT_LESS_THAN(0, 0), "Expected 0 to be less than 0") \
  CASE(lt32, TEST_ASSERT_LESS_THAN_INT32(0, -1), TEST_ASSERT_LESS_THAN_INT32(-1, 0), "to be less than -1") \
  CASE(ge, TEST_ASSERT_GREATER_OR_EQUAL(1, 1), TEST_ASSERT_GREATER_OR_EQUAL(1, 0), "greater or equal to 1") \
  CASE(le, TEST_ASSERT_LESS_OR_EQUAL(1, 1), TEST_ASSERT_LESS_OR_EQUAL(1, 2), "less or equal to 1") \
  CASE(within, TEST_ASSERT_INT32_WITHIN(2, 10, 8), TEST_ASSERT_INT32_WITHIN(2, 10, 7), \
       "Delta 2 Expected 10 Was 7") \
  CASE(within_above, TEST_ASSERT_INT32_WITHIN(2, 10, 12), TEST_ASSERT_INT32_WITHIN(2, 10, 13), "Was 13") \
  CASE(within_sign, TEST_ASSERT_INT64_WITHIN(2, -1, 1), TEST_ASSERT_INT64_WITHIN(1, -1, 1), \
       "Delta 1 Expected -1 Was 1") \
  CASE(within_ends, TEST_ASSERT_INT64_WITHIN(UINT64_MAX, INT64_MIN, INT64_MAX), \
       TEST_ASSERT_INT64_WITHIN(UINT64_MAX - 1, INT64_MIN, INT64_MAX), "Delta 18446744073709551614") \
  CASE(within_unsigned, TEST_ASSERT_UINT64_WITHIN(1, 0, 1), TEST_ASSERT_UINT64_WITHIN(1, 0, UINT64_MAX), \
       "Was 18446744073709551615") \
  CASE(within_message, TEST_ASSERT_INT32_WITHIN_MESSAGE(0, 1, 1, "m"), \
       TEST_ASSERT_INT32_WITHIN_MESSAGE(0, 1, 2, "why"), "Was 2 why") \
  CASE(string, TEST_ASSERT_EQUAL_STRING("abc", "abc"), TEST_ASSERT_EQUAL_STRING("abc", "abd"), \
       "Expected 'abc' Was 'abd'") \
  CASE(string_prefix, TEST_ASSERT_EQUAL_STRING("", ""), TEST_ASSERT_EQUAL_STRING("abc", "ab"), "Was 'ab'") \
  CASE(string_null, TEST_ASSERT_EQUAL_STRING(NULL, NULL), TEST_ASSERT_EQUAL_STRING("abc", NULL), \
       "Was 'NULL'") \
  CASE(memory, TEST_ASSERT_EQUAL_MEMORY(bytes_a, bytes_b, 3), TEST_ASSERT_EQUAL_MEMORY(bytes_a, bytes_b, 4), \
       "Element 3 Expected 0xFF Was 0xFE") \
  CASE(array_empty, TEST_ASSERT_EQUAL_UINT8_ARRAY(bytes_a, bytes_b, 1), \
       TEST_ASSERT_EQUAL_UINT8_ARRAY(bytes_a, bytes_b, 0), "Nothing") \
  CASE(array_null, TEST_ASSERT_EQUAL_UINT8_ARRAY(bytes_a, bytes_a, 4), \
       TEST_ASSERT_EQUAL_UINT8_ARRAY(bytes_a, NULL, 4), "NULL") \
  CASE(array8, TEST_ASSERT_EQUAL_INT8_ARRAY(bytes_a, bytes_b, 3), \
       TEST_ASSERT_EQUAL_INT8_ARRAY(bytes_a, bytes_b, 4), "Element 3 Expected -1 Was -2") \
  CASE(array32, TEST_ASSERT_EQUAL_INT32_ARRAY(small, other, 2), \
       TEST_ASSERT_EQUAL_INT32_ARRAY(small, other, 3), "Element 2 Expected 3 Was 4") \
  CASE(array64, TEST_ASSERT_EQUAL_INT64_ARRAY(wide_a, wide_a, 2), \
       TEST_ASSERT_EQUAL_INT64_ARRAY(wide_a, wide_b, 2), "Element 0 Expected -9223372036854775808") \
  CASE(array_hex, TEST_ASSERT_EQUAL_HEX32_ARRAY(small, small, 3), \
       TEST_ASSERT_EQUAL_HEX32_ARRAY(small, other, 3), "Element 2 Expected 0x00000003") \
  CASE(fail, TEST_ASSERT(1), TEST_FAIL(), "FAIL:") \
  CASE(fail_message, TEST_ASSERT(1), TEST_FAIL_MESSAGE("why"), "FAIL: why")

#define CASE(name, holding, failing, text) \
  static void holds_##name(void) { holding; } \
  static void fails_##name(void) { \
    failing; \
    after_failure++; \
  }
CASES
#undef CASE

static void ignored(void) { TEST_IGNORE_MESSAGE("later"); }

#ifndef UNITY_EXCLUDE_SETJMP_H
static int helper(int x) {
  TEST_ASSERT_EQUAL_INT(1, x);
  return x;
}
static void fails_in_helper(void) {
  (void)helper(2);
  after_failure++;
}
#endif

/* ---- judging ---- */

static int checks, wrong;

static int contains(const char *text, const char *part) {
  for (; *text != '\0'; text++) {
    int i = 0;
    while (part[i] != '\0' && part[i] == text[i]) i++;
    if (part[i] == '\0') return 1;
  }
  return 0;
}

static void report(const char *text) {
  for (; *text != '\0'; text++) REPORT_CHAR(*text);
}

static void judge(int right, const char *name, const char *what) {
  checks++;
  if (right) return;
  wrong++;
  report("WRONG: ");
  report(name);
  report(": ");
  report(what);
  report("; output: ");
  report(captured);
  report("\n");
}

static void run(void (*test)(void), const char *name) {
  captured_length = 0;
  captured[0] = '\0';
  unity_run(test, name, 1);
}

static void expect_pass(void (*test)(void), const char *name) {
  unsigned failures = Unity.failures;
  run(test, name);
  judge(Unity.failures == failures, name, "failed although it holds");
  judge(contains(captured, ":PASS\n"), name, "printed no PASS");
}

static void expect_failure(void (*test)(void), const char *name, const char *text) {
  unsigned failures = Unity.failures;
  after_failure = 0;
  run(test, name);
  judge(Unity.failures == failures + 1, name, "did not fail");
  judge(contains(captured, ":FAIL:") && contains(captured, text), name, "did not say why");
  judge(!contains(captured, "PASS"), name, "printed PASS");
  judge(after_failure == 0, name, "did not end its test");
}

int main(void) {
  int i;
  UNITY_BEGIN();
  judge(unity_end() == 1, "empty", "a program without tests must fail");

  UNITY_BEGIN();
#define CASE(name, holding, failing, text) \
  expect_pass(holds_##name, #name); \
  expect_failure(fails_##name, #name, text);
  CASES
#undef CASE
#ifndef UNITY_EXCLUDE_SETJMP_H
  expect_failure(fails_in_helper, "helper", "Expected 1 Was 2");
#endif
  run(ignored, "ignored");
  judge(Unity.ignored == 1 && contains(captured, "IGNORE: later"), "ignored", "not counted");
  judge(set_up_calls == (int)Unity.tests && tear_down_calls == set_up_calls, "setUp", "not around each test");

  captured_length = 0;
  i = unity_end();
  judge(i == (int)Unity.failures && contains(captured, "\nFAIL\n"), "end", "did not report the failures");
  for (i = 0; i < 300; i++) run(fails_fail, "many");
  judge(unity_end() == 255, "end", "more than 255 failures must not wrap around to an exit code of 0");

  UNITY_BEGIN();
  run(holds_fail, "good");
  captured_length = 0;
  judge(unity_end() == 0 && contains(captured, "1 Tests 0 Failures 0 Ignored\nOK\n"), "end", "no OK");

  report(wrong == 0 ? "unity.h: every assertion passes and fails as it should\n" : "unity.h: FAIL\n");
  REPORT_FLUSH();
  return wrong != 0 || checks < 100;
}
