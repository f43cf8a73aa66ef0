/*
 * Unit tests in Unity's vocabulary, in one header that needs no printf and no operating system.
 *
 * The same test file runs on a host and bare-metal. The names, the argument order (expected, actual) and the
 * printed lines are those of ThrowTheSwitch's Unity, so the real one can take this header's place: put its src
 * directory first in the include path and link its unity.c (with UNITY_SUPPORT_64 on 32-bit chips).
 *
 *   #include "unity.h"
 *   void setUp(void) {}
 *   void tearDown(void) {}
 *   static void test_sum(void) { TEST_ASSERT_EQUAL_INT32(4, 2 + 2); }
 *   int main(void) {
 *     UNITY_BEGIN();
 *     RUN_TEST(test_sum);
 *     return UNITY_END();
 *   }
 *
 * One test program is one source file: the state is static. A failed assertion ends its test, from helper
 * functions too (longjmp). With UNITY_EXCLUDE_SETJMP_H it only returns from the function it stands in.
 *
 * Before including it, or in a unity_config.h read when UNITY_INCLUDE_CONFIG_H is defined:
 *   UNITY_OUTPUT_CHAR(c)    prints one character (default: putchar)
 *   UNITY_OUTPUT_FLUSH()    called at the end (default: nothing, or fflush with putchar)
 */
#ifndef FIXCAST_TEST_UNITY_H
#define FIXCAST_TEST_UNITY_H

#include <stddef.h>
#include <stdint.h>

#ifdef UNITY_INCLUDE_CONFIG_H
#include "unity_config.h"
#endif
#ifndef UNITY_EXCLUDE_SETJMP_H
#include <setjmp.h>
#endif
#ifndef UNITY_OUTPUT_CHAR
#include <stdio.h>
#define UNITY_OUTPUT_CHAR(c) ((void)putchar(c))
#define UNITY_OUTPUT_FLUSH() ((void)fflush(stdout))
#endif
#ifndef UNITY_OUTPUT_FLUSH
#define UNITY_OUTPUT_FLUSH() ((void)0)
#endif

/* Most of these functions are unused in any one test file. */
#if defined(__GNUC__)
#define UNITY_FN_ static __attribute__((unused))
#else
#define UNITY_FN_ static
#endif

/* Every test file defines these two; they run before and after each test. */
void setUp(void);
void tearDown(void);

typedef struct unity_state {
  const char *file;
  const char *test;
  unsigned line;
  unsigned tests, failures, ignored;
  unsigned char failed_now, ignored_now;
#ifndef UNITY_EXCLUDE_SETJMP_H
  jmp_buf abort_frame;
#endif
} unity_state;

static unity_state Unity;

#ifndef UNITY_EXCLUDE_SETJMP_H
#define TEST_PROTECT() (setjmp(Unity.abort_frame) == 0)
#define TEST_ABORT() longjmp(Unity.abort_frame, 1)
#else
#define TEST_PROTECT() 1
#define TEST_ABORT() return
#endif

/* ---- printing ---- */

UNITY_FN_ void unity_print(const char *text) {
  for (; *text != '\0'; text++) UNITY_OUTPUT_CHAR(*text);
}

UNITY_FN_ void unity_print_unsigned(uint64_t value) {
  char digits[20];
  int n = 0;
  do {
    digits[n++] = (char)('0' + (int)(value % 10u));
    value /= 10u;
  } while (value != 0);
  while (n > 0) UNITY_OUTPUT_CHAR(digits[--n]);
}

UNITY_FN_ void unity_print_signed(int64_t value) {
  uint64_t magnitude = (uint64_t)value;
  if (value < 0) {
    UNITY_OUTPUT_CHAR('-');
    magnitude = 0u - magnitude; /* defined for INT64_MIN too */
  }
  unity_print_unsigned(magnitude);
}

UNITY_FN_ void unity_print_hex(uint64_t value, int nibbles) {
  unity_print("0x");
  while (nibbles > 0) {
    nibbles--;
    UNITY_OUTPUT_CHAR("0123456789ABCDEF"[(value >> (4 * nibbles)) & 15u]);
  }
}

UNITY_FN_ void unity_print_where(unsigned line) {
  unity_print(Unity.file);
  UNITY_OUTPUT_CHAR(':');
  unity_print_unsigned(line);
  UNITY_OUTPUT_CHAR(':');
  unity_print(Unity.test);
  UNITY_OUTPUT_CHAR(':');
}

UNITY_FN_ void unity_fail_begin(unsigned line) {
  Unity.failed_now = 1;
  unity_print_where(line);
  unity_print("FAIL:");
}

UNITY_FN_ void unity_fail_end(const char *message) {
  if (message != NULL) {
    UNITY_OUTPUT_CHAR(' ');
    unity_print(message);
  }
  UNITY_OUTPUT_CHAR('\n');
}

/* ---- assertions: each returns 1 when it holds, else prints why not and returns 0 ---- */

enum {
  UNITY_EQ,
  UNITY_NE,
  UNITY_GT,
  UNITY_LT,
  UNITY_GE,
  UNITY_LE
};
enum {
  UNITY_SIGNED = 0,
  UNITY_UNSIGNED = -1
}; /* styles; a positive style is hexadecimal digits */

UNITY_FN_ void unity_print_number(uint64_t bits, int style) {
  if (style > 0)
    unity_print_hex(bits, style);
  else if (style == UNITY_UNSIGNED)
    unity_print_unsigned(bits);
  else if (bits <= (uint64_t)INT64_MAX)
    unity_print_unsigned(bits);
  else
    unity_print_signed(-(int64_t)(~bits) - 1); /* two's complement, without a conversion out of range */
}

/* The signed order of two's complement is the unsigned one with the top bit turned over. */
UNITY_FN_ uint64_t unity_order(uint64_t bits, int style) {
  return style == UNITY_SIGNED ? bits ^ (UINT64_C(1) << 63) : bits;
}

UNITY_FN_ int unity_compare(uint64_t reference, uint64_t actual, int relation, int style, unsigned line,
                            const char *message) {
  static const char *const text[] = {"",
                                     " to be not equal to ",
                                     " to be greater than ",
                                     " to be less than ",
                                     " to be greater or equal to ",
                                     " to be less or equal to "};
  uint64_t r = unity_order(reference, style), a = unity_order(actual, style);
  int holds = relation == UNITY_EQ   ? a == r
              : relation == UNITY_NE ? a != r
              : relation == UNITY_GT ? a > r
              : relation == UNITY_LT ? a < r
              : relation == UNITY_GE ? a >= r
                                     : a <= r;
  if (holds) return 1;
  unity_fail_begin(line);
  unity_print(" Expected ");
  unity_print_number(relation == UNITY_EQ ? reference : actual, style);
  unity_print(relation == UNITY_EQ ? " Was " : text[relation]);
  unity_print_number(relation == UNITY_EQ ? actual : reference, style);
  unity_fail_end(message);
  return 0;
}

UNITY_FN_ int unity_within(uint64_t delta, uint64_t expected, uint64_t actual, int style, unsigned line,
                           const char *message) {
  uint64_t e = unity_order(expected, style), a = unity_order(actual, style);
  if ((a > e ? a - e : e - a) <= delta) return 1;
  unity_fail_begin(line);
  unity_print(" Values Not Within Delta ");
  unity_print_unsigned(delta);
  unity_print(" Expected ");
  unity_print_number(expected, style);
  unity_print(" Was ");
  unity_print_number(actual, style);
  unity_fail_end(message);
  return 0;
}

UNITY_FN_ int unity_condition(int holds, const char *what, unsigned line, const char *message) {
  if (holds) return 1;
  unity_fail_begin(line);
  unity_print(what);
  unity_fail_end(message);
  return 0;
}

UNITY_FN_ int unity_string(const char *expected, const char *actual, unsigned line, const char *message) {
  const char *e = expected, *a = actual;
  if (e != NULL && a != NULL) {
    while (*e == *a && *e != '\0') {
      e++;
      a++;
    }
    if (*e == *a) return 1;
  } else if (e == a) {
    return 1;
  }
  unity_fail_begin(line);
  unity_print(" Expected '");
  unity_print(expected != NULL ? expected : "NULL");
  unity_print("' Was '");
  unity_print(actual != NULL ? actual : "NULL");
  unity_print("'");
  unity_fail_end(message);
  return 0;
}

/* Element i of an array of 1, 2, 4 or 8 bytes an element, sign-extended when the style is signed. */
UNITY_FN_ uint64_t unity_element(const void *array, size_t i, size_t bytes, int style) {
  if (style == UNITY_SIGNED) {
    switch (bytes) {
      case 1: return (uint64_t)((const int8_t *)array)[i];
      case 2: return (uint64_t)((const int16_t *)array)[i];
      case 4: return (uint64_t)((const int32_t *)array)[i];
      default: return (uint64_t)((const int64_t *)array)[i];
    }
  }
  switch (bytes) {
    case 1: return ((const uint8_t *)array)[i];
    case 2: return ((const uint16_t *)array)[i];
    case 4: return ((const uint32_t *)array)[i];
    default: return ((const uint64_t *)array)[i];
  }
}

UNITY_FN_ int unity_array(const void *expected, const void *actual, size_t count, size_t bytes, int style,
                          unsigned line, const char *message) {
  size_t i;
  if (count == 0) return unity_condition(0, " You Asked Me To Compare Nothing", line, message);
  if (expected == actual) return 1;
  if (expected == NULL || actual == NULL) return unity_condition(0, " Pointer Is NULL", line, message);
  for (i = 0; i < count; i++) {
    uint64_t e = unity_element(expected, i, bytes, style), a = unity_element(actual, i, bytes, style);
    if (e == a) continue;
    unity_fail_begin(line);
    unity_print(" Element ");
    unity_print_unsigned(i);
    unity_print(" Expected ");
    unity_print_number(e, style);
    unity_print(" Was ");
    unity_print_number(a, style);
    unity_fail_end(message);
    return 0;
  }
  return 1;
}

/* ---- running ---- */

UNITY_FN_ void unity_begin(const char *file) {
  Unity.file = file;
  Unity.test = "";
  Unity.tests = Unity.failures = Unity.ignored = 0;
}

UNITY_FN_ void unity_run(void (*test)(void), const char *name, unsigned line) {
  Unity.test = name;
  Unity.line = line;
  Unity.failed_now = Unity.ignored_now = 0;
  Unity.tests++;
  if (TEST_PROTECT()) {
    setUp();
    test();
  }
  if (TEST_PROTECT()) tearDown();
  if (Unity.failed_now) {
    Unity.failures++;
  } else if (Unity.ignored_now) {
    Unity.ignored++;
  } else {
    unity_print_where(Unity.line);
    unity_print("PASS\n");
  }
}

/* Failures, at most 255 so that it serves as an exit code; a program without tests has failed. */
UNITY_FN_ int unity_end(void) {
  unsigned bad = Unity.tests == 0 ? 1u : Unity.failures;
  unity_print("\n-----------------------\n");
  unity_print_unsigned(Unity.tests);
  unity_print(" Tests ");
  unity_print_unsigned(Unity.failures);
  unity_print(" Failures ");
  unity_print_unsigned(Unity.ignored);
  unity_print(bad != 0 ? " Ignored\nFAIL\n" : " Ignored\nOK\n");
  UNITY_OUTPUT_FLUSH();
  return bad > 255u ? 255 : (int)bad;
}

UNITY_FN_ void unity_ignore(unsigned line, const char *message) {
  Unity.ignored_now = 1;
  unity_print_where(line);
  unity_print("IGNORE");
  if (message != NULL) {
    unity_print(": ");
    unity_print(message);
  }
  UNITY_OUTPUT_CHAR('\n');
}

#define UNITY_BEGIN() unity_begin(__FILE__)
#define UNITY_END() unity_end()
#define RUN_TEST(test) unity_run((test), #test, __LINE__)

/* ---- the vocabulary ---- */

#define UNITY_REQUIRE_(holds) \
  do { \
    if (!(holds)) { \
      TEST_ABORT(); \
    } \
  } while (0)
#define UNITY_COND_(holds, what, message) \
  UNITY_REQUIRE_(unity_condition((holds), (what), __LINE__, (message)))
/* The cast through the assertion's own type cuts or extends both sides alike, as Unity does. */
#define UNITY_CMP_(type, style, relation, reference, actual, message) \
  UNITY_REQUIRE_(unity_compare((uint64_t)(type)(reference), (uint64_t)(type)(actual), (relation), (style), \
                               __LINE__, (message)))
#define UNITY_WITHIN_(type, style, delta, expected, actual, message) \
  UNITY_REQUIRE_(unity_within((uint64_t)(delta), (uint64_t)(type)(expected), (uint64_t)(type)(actual), \
                              (style), __LINE__, (message)))
#define UNITY_ARRAY_(style, bytes, expected, actual, count, message) \
  UNITY_REQUIRE_(unity_array((expected), (actual), (size_t)(count), (bytes), (style), __LINE__, (message)))

#define TEST_FAIL() UNITY_COND_(0, "", NULL)
#define TEST_FAIL_MESSAGE(message) UNITY_COND_(0, "", (message))
#define TEST_PASS() TEST_ABORT()
#define TEST_IGNORE_MESSAGE(message) \
  do { \
    unity_ignore(__LINE__, (message)); \
    TEST_ABORT(); \
  } while (0)
#define TEST_IGNORE() TEST_IGNORE_MESSAGE(NULL)
#define TEST_MESSAGE(message) \
  do { \
    unity_print_where(__LINE__); \
    unity_print("INFO: "); \
    unity_print(message); \
    UNITY_OUTPUT_CHAR('\n'); \
  } while (0)

#define TEST_ASSERT_MESSAGE(condition, message) \
  UNITY_COND_(!!(condition), " Expression Evaluated To FALSE", (message))
#define TEST_ASSERT(condition) UNITY_COND_(!!(condition), " Expression Evaluated To FALSE: " #condition, NULL)
#define TEST_ASSERT_TRUE_MESSAGE(condition, message) \
  UNITY_COND_(!!(condition), " Expected TRUE Was FALSE", (message))
#define TEST_ASSERT_TRUE(condition) UNITY_COND_(!!(condition), " Expected TRUE Was FALSE: " #condition, NULL)
#define TEST_ASSERT_UNLESS_MESSAGE(condition, message) TEST_ASSERT_FALSE_MESSAGE(condition, message)
#define TEST_ASSERT_UNLESS(condition) TEST_ASSERT_FALSE(condition)
#define TEST_ASSERT_FALSE_MESSAGE(condition, message) \
  UNITY_COND_(!(condition), " Expected FALSE Was TRUE", (message))
#define TEST_ASSERT_FALSE(condition) UNITY_COND_(!(condition), " Expected FALSE Was TRUE: " #condition, NULL)
#define TEST_ASSERT_NULL_MESSAGE(pointer, message) UNITY_COND_((pointer) == NULL, " Expected NULL", (message))
#define TEST_ASSERT_NULL(pointer) TEST_ASSERT_NULL_MESSAGE(pointer, NULL)
#define TEST_ASSERT_NOT_NULL_MESSAGE(pointer, message) \
  UNITY_COND_((pointer) != NULL, " Expected Non-NULL", (message))
#define TEST_ASSERT_NOT_NULL(pointer) TEST_ASSERT_NOT_NULL_MESSAGE(pointer, NULL)
#define TEST_ASSERT_EQUAL_PTR_MESSAGE(expected, actual, message) \
  UNITY_CMP_(uintptr_t, (int)(2 * sizeof(void *)), UNITY_EQ, (expected), (actual), message)
#define TEST_ASSERT_EQUAL_PTR(expected, actual) TEST_ASSERT_EQUAL_PTR_MESSAGE(expected, actual, NULL)

#define TEST_ASSERT_EQUAL_STRING_MESSAGE(expected, actual, message) \
  UNITY_REQUIRE_(unity_string((expected), (actual), __LINE__, (message)))
#define TEST_ASSERT_EQUAL_STRING(expected, actual) TEST_ASSERT_EQUAL_STRING_MESSAGE(expected, actual, NULL)
#define TEST_ASSERT_EQUAL_MEMORY_MESSAGE(expected, actual, bytes, message) \
  UNITY_ARRAY_(2, 1, expected, actual, bytes, message)
#define TEST_ASSERT_EQUAL_MEMORY(expected, actual, bytes) \
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(expected, actual, bytes, NULL)

/* Numbers: for each type, equal, within delta, the four orders, and arrays. */

/* INT */
#define TEST_ASSERT_EQUAL_INT_MESSAGE(expected, actual, message) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_INT(expected, actual) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_GREATER_THAN_INT_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_GT, threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN_INT(threshold, actual) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_GT, threshold, actual, NULL)
#define TEST_ASSERT_LESS_THAN_INT_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_LT, threshold, actual, message)
#define TEST_ASSERT_LESS_THAN_INT(threshold, actual) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_LT, threshold, actual, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_GE, threshold, actual, message)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT(threshold, actual) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_GE, threshold, actual, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_INT_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_LE, threshold, actual, message)
#define TEST_ASSERT_LESS_OR_EQUAL_INT(threshold, actual) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_LE, threshold, actual, NULL)
#define TEST_ASSERT_NOT_EQUAL_INT_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_NE, threshold, actual, message)
#define TEST_ASSERT_NOT_EQUAL_INT(threshold, actual) \
  UNITY_CMP_(int, UNITY_SIGNED, UNITY_NE, threshold, actual, NULL)
#define TEST_ASSERT_INT_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(int, UNITY_SIGNED, delta, expected, actual, message)
#define TEST_ASSERT_INT_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(int, UNITY_SIGNED, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_INT_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(UNITY_SIGNED, sizeof(int), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_INT_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(UNITY_SIGNED, sizeof(int), expected, actual, count, NULL)

/* INT8 */
#define TEST_ASSERT_EQUAL_INT8_MESSAGE(expected, actual, message) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_INT8(expected, actual) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_GREATER_THAN_INT8_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_GT, threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN_INT8(threshold, actual) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_GT, threshold, actual, NULL)
#define TEST_ASSERT_LESS_THAN_INT8_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_LT, threshold, actual, message)
#define TEST_ASSERT_LESS_THAN_INT8(threshold, actual) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_LT, threshold, actual, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT8_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_GE, threshold, actual, message)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT8(threshold, actual) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_GE, threshold, actual, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_INT8_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_LE, threshold, actual, message)
#define TEST_ASSERT_LESS_OR_EQUAL_INT8(threshold, actual) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_LE, threshold, actual, NULL)
#define TEST_ASSERT_NOT_EQUAL_INT8_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_NE, threshold, actual, message)
#define TEST_ASSERT_NOT_EQUAL_INT8(threshold, actual) \
  UNITY_CMP_(int8_t, UNITY_SIGNED, UNITY_NE, threshold, actual, NULL)
#define TEST_ASSERT_INT8_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(int8_t, UNITY_SIGNED, delta, expected, actual, message)
#define TEST_ASSERT_INT8_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(int8_t, UNITY_SIGNED, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_INT8_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(UNITY_SIGNED, sizeof(int8_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_INT8_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(UNITY_SIGNED, sizeof(int8_t), expected, actual, count, NULL)

/* INT16 */
#define TEST_ASSERT_EQUAL_INT16_MESSAGE(expected, actual, message) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_INT16(expected, actual) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_GREATER_THAN_INT16_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_GT, threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN_INT16(threshold, actual) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_GT, threshold, actual, NULL)
#define TEST_ASSERT_LESS_THAN_INT16_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_LT, threshold, actual, message)
#define TEST_ASSERT_LESS_THAN_INT16(threshold, actual) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_LT, threshold, actual, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT16_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_GE, threshold, actual, message)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT16(threshold, actual) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_GE, threshold, actual, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_INT16_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_LE, threshold, actual, message)
#define TEST_ASSERT_LESS_OR_EQUAL_INT16(threshold, actual) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_LE, threshold, actual, NULL)
#define TEST_ASSERT_NOT_EQUAL_INT16_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_NE, threshold, actual, message)
#define TEST_ASSERT_NOT_EQUAL_INT16(threshold, actual) \
  UNITY_CMP_(int16_t, UNITY_SIGNED, UNITY_NE, threshold, actual, NULL)
#define TEST_ASSERT_INT16_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(int16_t, UNITY_SIGNED, delta, expected, actual, message)
#define TEST_ASSERT_INT16_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(int16_t, UNITY_SIGNED, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_INT16_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(UNITY_SIGNED, sizeof(int16_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_INT16_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(UNITY_SIGNED, sizeof(int16_t), expected, actual, count, NULL)

/* INT32 */
#define TEST_ASSERT_EQUAL_INT32_MESSAGE(expected, actual, message) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_INT32(expected, actual) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_GREATER_THAN_INT32_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_GT, threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN_INT32(threshold, actual) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_GT, threshold, actual, NULL)
#define TEST_ASSERT_LESS_THAN_INT32_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_LT, threshold, actual, message)
#define TEST_ASSERT_LESS_THAN_INT32(threshold, actual) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_LT, threshold, actual, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT32_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_GE, threshold, actual, message)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT32(threshold, actual) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_GE, threshold, actual, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_INT32_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_LE, threshold, actual, message)
#define TEST_ASSERT_LESS_OR_EQUAL_INT32(threshold, actual) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_LE, threshold, actual, NULL)
#define TEST_ASSERT_NOT_EQUAL_INT32_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_NE, threshold, actual, message)
#define TEST_ASSERT_NOT_EQUAL_INT32(threshold, actual) \
  UNITY_CMP_(int32_t, UNITY_SIGNED, UNITY_NE, threshold, actual, NULL)
#define TEST_ASSERT_INT32_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(int32_t, UNITY_SIGNED, delta, expected, actual, message)
#define TEST_ASSERT_INT32_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(int32_t, UNITY_SIGNED, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_INT32_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(UNITY_SIGNED, sizeof(int32_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_INT32_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(UNITY_SIGNED, sizeof(int32_t), expected, actual, count, NULL)

/* INT64 */
#define TEST_ASSERT_EQUAL_INT64_MESSAGE(expected, actual, message) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_INT64(expected, actual) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_GREATER_THAN_INT64_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_GT, threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN_INT64(threshold, actual) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_GT, threshold, actual, NULL)
#define TEST_ASSERT_LESS_THAN_INT64_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_LT, threshold, actual, message)
#define TEST_ASSERT_LESS_THAN_INT64(threshold, actual) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_LT, threshold, actual, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT64_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_GE, threshold, actual, message)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT64(threshold, actual) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_GE, threshold, actual, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_INT64_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_LE, threshold, actual, message)
#define TEST_ASSERT_LESS_OR_EQUAL_INT64(threshold, actual) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_LE, threshold, actual, NULL)
#define TEST_ASSERT_NOT_EQUAL_INT64_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_NE, threshold, actual, message)
#define TEST_ASSERT_NOT_EQUAL_INT64(threshold, actual) \
  UNITY_CMP_(int64_t, UNITY_SIGNED, UNITY_NE, threshold, actual, NULL)
#define TEST_ASSERT_INT64_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(int64_t, UNITY_SIGNED, delta, expected, actual, message)
#define TEST_ASSERT_INT64_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(int64_t, UNITY_SIGNED, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_INT64_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(UNITY_SIGNED, sizeof(int64_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_INT64_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(UNITY_SIGNED, sizeof(int64_t), expected, actual, count, NULL)

/* UINT */
#define TEST_ASSERT_EQUAL_UINT_MESSAGE(expected, actual, message) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_UINT(expected, actual) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_GREATER_THAN_UINT_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_GT, threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN_UINT(threshold, actual) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_GT, threshold, actual, NULL)
#define TEST_ASSERT_LESS_THAN_UINT_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_LT, threshold, actual, message)
#define TEST_ASSERT_LESS_THAN_UINT(threshold, actual) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_LT, threshold, actual, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_GE, threshold, actual, message)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT(threshold, actual) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_GE, threshold, actual, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_LE, threshold, actual, message)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT(threshold, actual) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_LE, threshold, actual, NULL)
#define TEST_ASSERT_NOT_EQUAL_UINT_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_NE, threshold, actual, message)
#define TEST_ASSERT_NOT_EQUAL_UINT(threshold, actual) \
  UNITY_CMP_(unsigned, UNITY_UNSIGNED, UNITY_NE, threshold, actual, NULL)
#define TEST_ASSERT_UINT_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(unsigned, UNITY_UNSIGNED, delta, expected, actual, message)
#define TEST_ASSERT_UINT_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(unsigned, UNITY_UNSIGNED, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_UINT_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(unsigned), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_UINT_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(unsigned), expected, actual, count, NULL)

/* UINT8 */
#define TEST_ASSERT_EQUAL_UINT8_MESSAGE(expected, actual, message) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_UINT8(expected, actual) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_GREATER_THAN_UINT8_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_GT, threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN_UINT8(threshold, actual) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_GT, threshold, actual, NULL)
#define TEST_ASSERT_LESS_THAN_UINT8_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_LT, threshold, actual, message)
#define TEST_ASSERT_LESS_THAN_UINT8(threshold, actual) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_LT, threshold, actual, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT8_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_GE, threshold, actual, message)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT8(threshold, actual) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_GE, threshold, actual, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT8_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_LE, threshold, actual, message)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT8(threshold, actual) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_LE, threshold, actual, NULL)
#define TEST_ASSERT_NOT_EQUAL_UINT8_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_NE, threshold, actual, message)
#define TEST_ASSERT_NOT_EQUAL_UINT8(threshold, actual) \
  UNITY_CMP_(uint8_t, UNITY_UNSIGNED, UNITY_NE, threshold, actual, NULL)
#define TEST_ASSERT_UINT8_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(uint8_t, UNITY_UNSIGNED, delta, expected, actual, message)
#define TEST_ASSERT_UINT8_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(uint8_t, UNITY_UNSIGNED, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_UINT8_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(uint8_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_UINT8_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(uint8_t), expected, actual, count, NULL)

/* UINT16 */
#define TEST_ASSERT_EQUAL_UINT16_MESSAGE(expected, actual, message) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_UINT16(expected, actual) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_GREATER_THAN_UINT16_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_GT, threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN_UINT16(threshold, actual) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_GT, threshold, actual, NULL)
#define TEST_ASSERT_LESS_THAN_UINT16_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_LT, threshold, actual, message)
#define TEST_ASSERT_LESS_THAN_UINT16(threshold, actual) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_LT, threshold, actual, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT16_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_GE, threshold, actual, message)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT16(threshold, actual) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_GE, threshold, actual, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT16_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_LE, threshold, actual, message)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT16(threshold, actual) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_LE, threshold, actual, NULL)
#define TEST_ASSERT_NOT_EQUAL_UINT16_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_NE, threshold, actual, message)
#define TEST_ASSERT_NOT_EQUAL_UINT16(threshold, actual) \
  UNITY_CMP_(uint16_t, UNITY_UNSIGNED, UNITY_NE, threshold, actual, NULL)
#define TEST_ASSERT_UINT16_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(uint16_t, UNITY_UNSIGNED, delta, expected, actual, message)
#define TEST_ASSERT_UINT16_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(uint16_t, UNITY_UNSIGNED, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_UINT16_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(uint16_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_UINT16_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(uint16_t), expected, actual, count, NULL)

/* UINT32 */
#define TEST_ASSERT_EQUAL_UINT32_MESSAGE(expected, actual, message) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_UINT32(expected, actual) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_GREATER_THAN_UINT32_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_GT, threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN_UINT32(threshold, actual) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_GT, threshold, actual, NULL)
#define TEST_ASSERT_LESS_THAN_UINT32_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_LT, threshold, actual, message)
#define TEST_ASSERT_LESS_THAN_UINT32(threshold, actual) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_LT, threshold, actual, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT32_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_GE, threshold, actual, message)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT32(threshold, actual) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_GE, threshold, actual, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT32_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_LE, threshold, actual, message)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT32(threshold, actual) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_LE, threshold, actual, NULL)
#define TEST_ASSERT_NOT_EQUAL_UINT32_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_NE, threshold, actual, message)
#define TEST_ASSERT_NOT_EQUAL_UINT32(threshold, actual) \
  UNITY_CMP_(uint32_t, UNITY_UNSIGNED, UNITY_NE, threshold, actual, NULL)
#define TEST_ASSERT_UINT32_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(uint32_t, UNITY_UNSIGNED, delta, expected, actual, message)
#define TEST_ASSERT_UINT32_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(uint32_t, UNITY_UNSIGNED, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_UINT32_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(uint32_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_UINT32_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(uint32_t), expected, actual, count, NULL)

/* UINT64 */
#define TEST_ASSERT_EQUAL_UINT64_MESSAGE(expected, actual, message) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_UINT64(expected, actual) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_GREATER_THAN_UINT64_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_GT, threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN_UINT64(threshold, actual) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_GT, threshold, actual, NULL)
#define TEST_ASSERT_LESS_THAN_UINT64_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_LT, threshold, actual, message)
#define TEST_ASSERT_LESS_THAN_UINT64(threshold, actual) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_LT, threshold, actual, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT64_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_GE, threshold, actual, message)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT64(threshold, actual) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_GE, threshold, actual, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT64_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_LE, threshold, actual, message)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT64(threshold, actual) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_LE, threshold, actual, NULL)
#define TEST_ASSERT_NOT_EQUAL_UINT64_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_NE, threshold, actual, message)
#define TEST_ASSERT_NOT_EQUAL_UINT64(threshold, actual) \
  UNITY_CMP_(uint64_t, UNITY_UNSIGNED, UNITY_NE, threshold, actual, NULL)
#define TEST_ASSERT_UINT64_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(uint64_t, UNITY_UNSIGNED, delta, expected, actual, message)
#define TEST_ASSERT_UINT64_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(uint64_t, UNITY_UNSIGNED, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_UINT64_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(uint64_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_UINT64_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(uint64_t), expected, actual, count, NULL)

/* size_t */
#define TEST_ASSERT_EQUAL_size_t_MESSAGE(expected, actual, message) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_size_t(expected, actual) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_GREATER_THAN_size_t_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_GT, threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN_size_t(threshold, actual) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_GT, threshold, actual, NULL)
#define TEST_ASSERT_LESS_THAN_size_t_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_LT, threshold, actual, message)
#define TEST_ASSERT_LESS_THAN_size_t(threshold, actual) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_LT, threshold, actual, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_size_t_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_GE, threshold, actual, message)
#define TEST_ASSERT_GREATER_OR_EQUAL_size_t(threshold, actual) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_GE, threshold, actual, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_size_t_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_LE, threshold, actual, message)
#define TEST_ASSERT_LESS_OR_EQUAL_size_t(threshold, actual) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_LE, threshold, actual, NULL)
#define TEST_ASSERT_NOT_EQUAL_size_t_MESSAGE(threshold, actual, message) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_NE, threshold, actual, message)
#define TEST_ASSERT_NOT_EQUAL_size_t(threshold, actual) \
  UNITY_CMP_(size_t, UNITY_UNSIGNED, UNITY_NE, threshold, actual, NULL)
#define TEST_ASSERT_size_t_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(size_t, UNITY_UNSIGNED, delta, expected, actual, message)
#define TEST_ASSERT_size_t_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(size_t, UNITY_UNSIGNED, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_size_t_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(size_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_size_t_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(UNITY_UNSIGNED, sizeof(size_t), expected, actual, count, NULL)

/* HEX8 */
#define TEST_ASSERT_EQUAL_HEX8_MESSAGE(expected, actual, message) \
  UNITY_CMP_(uint8_t, 2, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_HEX8(expected, actual) UNITY_CMP_(uint8_t, 2, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_HEX8_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(uint8_t, 2, delta, expected, actual, message)
#define TEST_ASSERT_HEX8_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(uint8_t, 2, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_HEX8_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(2, sizeof(uint8_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_HEX8_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(2, sizeof(uint8_t), expected, actual, count, NULL)

/* HEX16 */
#define TEST_ASSERT_EQUAL_HEX16_MESSAGE(expected, actual, message) \
  UNITY_CMP_(uint16_t, 4, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_HEX16(expected, actual) UNITY_CMP_(uint16_t, 4, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_HEX16_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(uint16_t, 4, delta, expected, actual, message)
#define TEST_ASSERT_HEX16_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(uint16_t, 4, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_HEX16_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(4, sizeof(uint16_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_HEX16_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(4, sizeof(uint16_t), expected, actual, count, NULL)

/* HEX32 */
#define TEST_ASSERT_EQUAL_HEX32_MESSAGE(expected, actual, message) \
  UNITY_CMP_(uint32_t, 8, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_HEX32(expected, actual) UNITY_CMP_(uint32_t, 8, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_HEX32_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(uint32_t, 8, delta, expected, actual, message)
#define TEST_ASSERT_HEX32_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(uint32_t, 8, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_HEX32_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(8, sizeof(uint32_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_HEX32_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(8, sizeof(uint32_t), expected, actual, count, NULL)

/* HEX64 */
#define TEST_ASSERT_EQUAL_HEX64_MESSAGE(expected, actual, message) \
  UNITY_CMP_(uint64_t, 16, UNITY_EQ, expected, actual, message)
#define TEST_ASSERT_EQUAL_HEX64(expected, actual) UNITY_CMP_(uint64_t, 16, UNITY_EQ, expected, actual, NULL)
#define TEST_ASSERT_HEX64_WITHIN_MESSAGE(delta, expected, actual, message) \
  UNITY_WITHIN_(uint64_t, 16, delta, expected, actual, message)
#define TEST_ASSERT_HEX64_WITHIN(delta, expected, actual) \
  UNITY_WITHIN_(uint64_t, 16, delta, expected, actual, NULL)
#define TEST_ASSERT_EQUAL_HEX64_ARRAY_MESSAGE(expected, actual, count, message) \
  UNITY_ARRAY_(16, sizeof(uint64_t), expected, actual, count, message)
#define TEST_ASSERT_EQUAL_HEX64_ARRAY(expected, actual, count) \
  UNITY_ARRAY_(16, sizeof(uint64_t), expected, actual, count, NULL)

/* Unity's short names mean int. */
#define TEST_ASSERT_EQUAL_MESSAGE(expected, actual, message) \
  TEST_ASSERT_EQUAL_INT_MESSAGE(expected, actual, message)
#define TEST_ASSERT_EQUAL(expected, actual) TEST_ASSERT_EQUAL_INT(expected, actual)
#define TEST_ASSERT_NOT_EQUAL_MESSAGE(expected, actual, message) \
  TEST_ASSERT_NOT_EQUAL_INT_MESSAGE(expected, actual, message)
#define TEST_ASSERT_NOT_EQUAL(expected, actual) TEST_ASSERT_NOT_EQUAL_INT(expected, actual)
#define TEST_ASSERT_GREATER_THAN_MESSAGE(threshold, actual, message) \
  TEST_ASSERT_GREATER_THAN_INT_MESSAGE(threshold, actual, message)
#define TEST_ASSERT_GREATER_THAN(threshold, actual) TEST_ASSERT_GREATER_THAN_INT(threshold, actual)
#define TEST_ASSERT_LESS_THAN_MESSAGE(threshold, actual, message) \
  TEST_ASSERT_LESS_THAN_INT_MESSAGE(threshold, actual, message)
#define TEST_ASSERT_LESS_THAN(threshold, actual) TEST_ASSERT_LESS_THAN_INT(threshold, actual)
#define TEST_ASSERT_GREATER_OR_EQUAL(threshold, actual) TEST_ASSERT_GREATER_OR_EQUAL_INT(threshold, actual)
#define TEST_ASSERT_LESS_OR_EQUAL(threshold, actual) TEST_ASSERT_LESS_OR_EQUAL_INT(threshold, actual)
#define TEST_ASSERT_EQUAL_HEX(expected, actual) TEST_ASSERT_EQUAL_HEX32(expected, actual)

#endif
