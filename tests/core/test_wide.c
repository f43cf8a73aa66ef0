/* Multiword integers and the signs of surds. */
#include "wide.h"

#include "random.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

static fc_wide wide(int64_t v) {
  fc_wide w;
  fc_wide_from_i64(&w, v);
  return w;
}

/* up to 4 * 63 bits */
static fc_wide random_wide(void) {
  fc_wide w = wide((int64_t)random_u64());
  unsigned i, n = (unsigned)(random_u64() % 4);
  for (i = 0; i < n; i++) fc_wide_mul_i64(&w, &w, (int64_t)random_u64());
  return w;
}

static int8_t sign_of_difference(const fc_wide *a, const fc_wide *b) {
  fc_wide d;
  fc_wide_sub(&d, a, b);
  return d.sign;
}

static void test_ring_identities(void) {
  int i;
  for (i = 0; i < 500; i++) {
    fc_wide a = random_wide(), b = random_wide(), sum, difference, left, right, bb;
    fc_wide_add(&sum, &a, &b);
    fc_wide_sub(&difference, &a, &b);
    fc_wide_mul(&left, &sum, &difference);
    fc_wide_mul(&right, &a, &a);
    fc_wide_mul(&bb, &b, &b);
    fc_wide_sub(&right, &right, &bb);
    TEST_ASSERT_EQUAL_INT8(0, sign_of_difference(&left, &right));
    fc_wide_add(&sum, &difference, &b); /* aliasing and cancellation */
    TEST_ASSERT_EQUAL_INT8(0, sign_of_difference(&sum, &a));
    fc_wide_sub(&a, &a, &a);
    TEST_ASSERT_EQUAL_INT8(0, a.sign);
    TEST_ASSERT_EQUAL_UINT8(0, a.count);
  }
}

static void test_shift_is_multiplication(void) {
  uint16_t s;
  for (s = 0; s < 200; s++) {
    fc_wide a = random_wide(), b = a, shifted;
    uint16_t i;
    for (i = 0; i < s; i++) fc_wide_add(&b, &b, &b);
    fc_wide_shift_left(&shifted, &a, s);
    TEST_ASSERT_EQUAL_INT8(0, sign_of_difference(&shifted, &b));
    TEST_ASSERT_EQUAL_UINT8(b.count, shifted.count);
  }
}

/* With d a square the sign is an integer's. */
static void test_surd_sign_with_square_radicands(void) {
  int i;
  for (i = 0; i < 2000; i++) {
    int32_t x = random_any_size(20), y = random_any_size(10), s = random_within(0, 1000), z = random_any_size(10);
    int32_t q = random_within(0, 1000), v = x + y * s, v2 = v + z * q;
    fc_wide wx = wide(x), wy = wide(y), d = wide((int64_t)s * s), wz = wide(z), e = wide((int64_t)q * q);
    TEST_ASSERT_EQUAL_INT8((v > 0) - (v < 0), fc_surd_sign(&wx, &wy, &d));
    TEST_ASSERT_EQUAL_INT8((v2 > 0) - (v2 < 0), fc_surd_sign2(&wx, &wy, &d, &wz, &e));
  }
}

/* Pell: p/q approximates sqrt 2 with p^2 - 2 q^2 = -1, 1, -1, ...: the hardest cases there are, to 300 bits. */
static void test_surd_sign_at_best_approximations(void) {
  fc_wide p = wide(1), q = wide(1), two = wide(2), three = wide(3), zero = wide(0);
  int8_t expected = -1;
  int n;
  for (n = 0; n < 230; n++) {
    fc_wide minus_q = q, next_p, twice;
    fc_wide_neg(&minus_q);
    TEST_ASSERT_EQUAL_INT8(expected, fc_surd_sign(&p, &minus_q, &two));
    fc_wide_neg(&p);
    TEST_ASSERT_EQUAL_INT8(-expected, fc_surd_sign(&p, &q, &two));
    TEST_ASSERT_EQUAL_INT8(-expected, fc_surd_sign2(&p, &zero, &three, &q, &two));
    TEST_ASSERT_EQUAL_INT8(-expected, fc_surd_sign2(&p, &q, &two, &zero, &three));
    fc_wide_neg(&p);
    /* p' = p + 2q, q' = p + q */
    fc_wide_add(&twice, &q, &q);
    fc_wide_add(&next_p, &p, &twice);
    fc_wide_add(&q, &p, &q);
    p = next_p;
    expected = (int8_t)-expected;
  }
}

/* sqrt(k^2 d) - k sqrt(d) is 0, and one unit more or less is not. */
static void test_two_roots_that_cancel(void) {
  int32_t k;
  for (k = 1; k < 300; k++) {
    fc_wide x = wide(0), y = wide(-k), d = wide(7), z = wide(1), e = wide((int64_t)7 * k * k), e_more, e_less;
    e_more = wide((int64_t)7 * k * k + 1);
    e_less = wide((int64_t)7 * k * k - 1);
    TEST_ASSERT_EQUAL_INT8(0, fc_surd_sign2(&x, &y, &d, &z, &e));
    TEST_ASSERT_EQUAL_INT8(1, fc_surd_sign2(&x, &y, &d, &z, &e_more));
    TEST_ASSERT_EQUAL_INT8(-1, fc_surd_sign2(&x, &y, &d, &z, &e_less));
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_ring_identities);
  RUN_TEST(test_shift_is_multiplication);
  RUN_TEST(test_surd_sign_with_square_radicands);
  RUN_TEST(test_surd_sign_at_best_approximations);
  RUN_TEST(test_two_roots_that_cancel);
  return UNITY_END();
}
