/* Two-word integers. */
#include "i128.h"

#include "bits.h"
#include "random.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

static void assert_i128(int64_t hi, uint64_t lo, fc_i128 v) {
  TEST_ASSERT_EQUAL_HEX64((uint64_t)hi, v.hi);
  TEST_ASSERT_EQUAL_HEX64(lo, v.lo);
}

static void test_products_of_extremes(void) {
  assert_i128((int64_t)(UINT64_MAX - 1), 1, fc_i128_mul_u64(UINT64_MAX, UINT64_MAX));
  assert_i128(INT64_C(0x4000000000000000), 0, fc_i128_mul(INT64_MIN, INT64_MIN));
  assert_i128(-INT64_C(0x4000000000000000), UINT64_C(0x8000000000000000), fc_i128_mul(INT64_MIN, INT64_MAX));
  assert_i128(-1, UINT64_MAX, fc_i128_mul(1, -1));
  assert_i128(0, 0, fc_i128_mul(0, INT64_MIN));
}

static void test_small_products_equal_64_bit_ones(void) {
  int i;
  for (i = 0; i < 2000; i++) {
    int32_t a = (int32_t)(uint32_t)(random_u64() >> 33) - (1 << 30), b = random_any_size(30);
    fc_i128 p = fc_i128_mul(a, b);
    TEST_ASSERT_EQUAL_INT64((int64_t)a * b, fc_i128_to_i64(p));
    TEST_ASSERT_EQUAL_INT8(fc_sign64((int64_t)a * b), fc_i128_sign(p));
  }
}

/* (a + b)(a - b) == a a - b b, and scale agrees with repeated shifts */
static void test_ring_identities(void) {
  int i;
  for (i = 0; i < 2000; i++) {
    int64_t a = (int64_t)(random_u64() >> 3), b = (int64_t)(random_u64() >> 3);
    fc_i128 left = fc_i128_mul(a + b, a - b), right = fc_i128_sub(fc_i128_mul(a, a), fc_i128_mul(b, b));
    TEST_ASSERT_EQUAL_INT8(0, fc_i128_compare(left, right));
    left = fc_i128_scale(fc_i128_mul(a, b >> 10), -1000);
    right = fc_i128_mul(a, (b >> 10) * -1000);
    TEST_ASSERT_EQUAL_INT8(0, fc_i128_compare(left, right));
  }
}

static void test_shifts_round_halves_up(void) {
  static const int64_t cases[][3] = {{5, 1, 3}, {-5, 1, -2}, {-6, 2, -1}, {-7, 2, -2}, {6, 2, 2}, {-1, 1, 0}, {1, 0, 1}};
  unsigned i;
  for (i = 0; i < sizeof cases / sizeof cases[0]; i++)
    TEST_ASSERT_EQUAL_INT64(
        cases[i][2], fc_i128_to_i64(fc_i128_round_shift(fc_i128_from(cases[i][0]), (uint8_t)cases[i][1])));
  for (i = 0; i < 127; i++) {
    fc_i128 one = fc_i128_shift_left(fc_i128_from(1), (uint8_t)i);
    TEST_ASSERT_EQUAL_UINT8(i + 1, fc_i128_bits(i == 126 ? fc_i128_neg(one) : one));
    if (i < 126) {
      TEST_ASSERT_EQUAL_INT64(1, fc_i128_to_i64(fc_i128_round_shift(one, (uint8_t)i)));
      TEST_ASSERT_EQUAL_INT64(-1, fc_i128_to_i64(fc_i128_round_shift(fc_i128_neg(one), (uint8_t)i)));
    }
  }
}

static void test_floor_shift_of_negatives(void) {
  TEST_ASSERT_EQUAL_INT64(-1, fc_floor_shift64(-1, 63));
  TEST_ASSERT_EQUAL_INT64(-1, fc_floor_shift64(INT64_MIN, 63));
  TEST_ASSERT_EQUAL_INT64(INT64_MIN / 2, fc_floor_shift64(INT64_MIN, 1));
  TEST_ASSERT_EQUAL_INT64(-2, fc_floor_shift64(-3, 1));
  TEST_ASSERT_EQUAL_INT64(1, fc_floor_shift64(3, 1));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_products_of_extremes);
  RUN_TEST(test_small_products_equal_64_bit_ones);
  RUN_TEST(test_ring_identities);
  RUN_TEST(test_shifts_round_halves_up);
  RUN_TEST(test_floor_shift_of_negatives);
  return UNITY_END();
}
