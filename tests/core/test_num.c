/* Values with a 63-bit mantissa: relative errors at their stated bound, square roots to the last bit. */
#include "num.h"

#include "bits.h"
#include "random.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

static fc_num random_num(void) { return fc_num_from_u64(random_u64() | 1, (int32_t)(random_u64() % 200) - 100); }

/* |a - b| <= b * ulps * 2^-63, for values with the same exponent or neighbours */
static void assert_close(fc_num a, fc_num b, uint64_t ulps) {
  fc_num difference = fc_num_compare(a, b) > 0 ? fc_num_sub(a, b) : fc_num_sub(b, a);
  TEST_ASSERT_TRUE(fc_num_compare(difference, fc_num_mul(b, fc_num_from_u64(ulps, -63))) <= 0);
}

static void test_g11_sqrt64_is_the_floor(void) {
  uint32_t i;
  static const uint64_t edges[] = {0, 1, 2, 3, 4, UINT64_MAX, UINT64_MAX - 1, UINT64_C(0xfffffffe00000001),
                                   UINT64_C(0xfffffffe00000000), UINT64_C(1) << 62, (UINT64_C(1) << 62) - 1};
  for (i = 0; i < 65536; i++) TEST_ASSERT_EQUAL_UINT32(i, fc_sqrt64((uint64_t)i * i));
  for (i = 1; i < 65536; i++) TEST_ASSERT_EQUAL_UINT32(i - 1, fc_sqrt64((uint64_t)i * i - 1));
  for (i = 0; i < 4000 + sizeof edges / sizeof edges[0]; i++) {
    uint64_t v = i < 4000 ? random_u64() >> (random_u64() % 64) : edges[i - 4000];
    uint64_t r = fc_sqrt64(v);
    TEST_ASSERT_TRUE(r * r <= v);
    TEST_ASSERT_TRUE(r == UINT32_MAX || (r + 1) * (r + 1) > v);
  }
}

static void test_g11_inverse_operations_return(void) {
  int i;
  for (i = 0; i < 2000; i++) {
    fc_num a = random_num(), b = random_num();
    assert_close(fc_num_mul(fc_num_div(a, b), b), a, 8);
    assert_close(fc_num_div(fc_num_mul(a, b), b), a, 8);
    assert_close(fc_num_sqrt(fc_num_mul(a, a)), a, 6);
    if (fc_num_compare(a, b) > 0) assert_close(fc_num_add(fc_num_sub(a, b), b), a, 8);
  }
}

static void test_exact_cases_are_exact(void) {
  uint32_t i;
  for (i = 1; i < 3000; i++) {
    fc_num n = fc_num_from_u64(i, 0), square = fc_num_from_u64((uint64_t)i * i, 0);
    TEST_ASSERT_EQUAL_INT8(0, fc_num_compare(fc_num_sqrt(square), n));
    TEST_ASSERT_EQUAL_INT8(0, fc_num_compare(fc_num_div(square, n), n));
    TEST_ASSERT_EQUAL_INT8(0, fc_num_compare(fc_num_mul(n, n), square));
    TEST_ASSERT_EQUAL_UINT64(i, fc_num_round(n, 0));
    TEST_ASSERT_EQUAL_UINT64((i + 1) / 2, fc_num_round(n, -1));
  }
}

static void test_rounding_at_the_ends(void) {
  fc_num zero = {0, 0};
  TEST_ASSERT_EQUAL_UINT64(0, fc_num_round(zero, 10));
  TEST_ASSERT_EQUAL_UINT64(UINT64_MAX, fc_num_round(fc_num_from_u64(1, 0), 64));
  TEST_ASSERT_EQUAL_UINT64(UINT64_C(1) << 63, fc_num_round(fc_num_from_u64(1, 0), 63));
  TEST_ASSERT_EQUAL_UINT64(UINT64_C(1) << 62, fc_num_round(fc_num_from_u64(1, 0), 62));
  TEST_ASSERT_EQUAL_UINT64(1, fc_num_round(fc_num_from_u64(1, 0), -1));
  TEST_ASSERT_EQUAL_UINT64(0, fc_num_round(fc_num_from_u64(1, 0), -2));
  TEST_ASSERT_EQUAL_UINT64(0, fc_num_round(fc_num_from_u64(1, 0), -200));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g11_sqrt64_is_the_floor);
  RUN_TEST(test_g11_inverse_operations_return);
  RUN_TEST(test_exact_cases_are_exact);
  RUN_TEST(test_rounding_at_the_ends);
  return UNITY_END();
}
