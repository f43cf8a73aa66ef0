/* Depth codes, exhaustively: rounding exact at every boundary, monotone, worst relative error 2^-15, 2^-14, 2^-13. */
#include "depth.h"

#include <string.h>

#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

#ifdef FIXCAST_BAREMETAL
enum {
  STEP = 509
}; /* emulated: a sample, ends included below */
#else
enum {
  STEP = 1
};
#endif

static const uint32_t nears[] = {1, 3, UINT32_C(65537), UINT32_C(0x3fffffff), UINT32_C(0xfffffffb)};

static void use(fc_frame *frame, uint8_t bits, uint32_t near) {
  memset(frame, 0, sizeof *frame);
  frame->depth_exponent_bits = bits;
  frame->depth_near = near;
  frame->view.focal = 268435399; /* prime */
}

/* The code of z = near / v for v = (b / 2^s) * (m / p): root t = p / m with z = t F. */
static uint16_t code_of(const fc_frame *frame, uint32_t b, uint8_t s, int64_t more) {
  fc_root root;
  memset(&root, 0, sizeof root);
  /* near 2^(s+20) / (b F 2^20), and `more` units of 2^-20 farther: 32 + 32 + 20 bits over 18 + 28 + 20 */
  root.p = fc_i128_shift_left(fc_i128_from_u64(frame->depth_near), (uint8_t)(s + 20));
  root.p = fc_i128_add(root.p, fc_i128_from(more));
  root.m = fc_i128_shift_left(fc_i128_from((int64_t)b * frame->view.focal), 20);
  return fc_depth_code(frame, &root);
}

/* Between code and code + 1: the middle rounds up (nearer), the least bit farther away rounds down. */
static void test_g8_rounding_is_exact_at_every_boundary(void) {
  uint8_t bits;
  for (bits = 2; bits <= 4; bits++) {
    uint8_t m_bits = (uint8_t)(16 - bits), octaves = (uint8_t)(1 << bits);
    uint32_t code;
    fc_frame frame;
    use(&frame, bits, nears[bits]);
    for (code = 1; code < 0xffff; code += code + STEP < 0xffff ? STEP : 1) {
      uint32_t mantissa = (code & ((UINT32_C(1) << m_bits) - 1)) + (UINT32_C(1) << m_bits);
      uint8_t s = (uint8_t)(octaves - (code >> m_bits) + m_bits);
      TEST_ASSERT_EQUAL_UINT16(code, code_of(&frame, mantissa, s, 0));
      TEST_ASSERT_EQUAL_UINT16(code + 1, code_of(&frame, 2 * mantissa + 1, (uint8_t)(s + 1), 0));
      TEST_ASSERT_EQUAL_UINT16(code, code_of(&frame, 2 * mantissa + 1, (uint8_t)(s + 1), 1));
    }
  }
}

/* Out of range both ways. */
static void test_saturation(void) {
  uint8_t bits, i;
  for (bits = 2; bits <= 4; bits++) {
    for (i = 0; i < sizeof nears / sizeof nears[0]; i++) {
      fc_frame frame;
      use(&frame, bits, nears[i]);
      TEST_ASSERT_EQUAL_HEX16(0xffff, code_of(&frame, 1, 0, 0));
      TEST_ASSERT_EQUAL_HEX16(0xffff, code_of(&frame, 1000, 0, 0));
      TEST_ASSERT_EQUAL_HEX16(1, code_of(&frame, 1, (uint8_t)(1 << bits), 0));
      TEST_ASSERT_EQUAL_HEX16(1, code_of(&frame, 1, 40, 0));
    }
  }
}

/* Neighbouring codes' depths, as mantissa and exponent, are at most two worst errors apart: 2^(1-15), ... */
static void test_g8_decoded_steps_are_within_the_bound(void) {
  uint8_t bits;
  for (bits = 2; bits <= 4; bits++) {
    fc_frame frame;
    uint32_t code, worst_q40 = 0;
    int last_exponent = 0;
    uint64_t last = 0;
    use(&frame, bits, nears[3]);
    for (code = 1; code <= 0xffff; code++) {
      int exponent;
      uint64_t z = fc_depth_z(&frame, (uint16_t)code, &exponent);
      if (code > 1) {
        uint64_t before = last_exponent > exponent ? last << (last_exponent - exponent) : last;
        TEST_ASSERT_TRUE(last_exponent >= exponent && before > z);
        /* half the step over the farther depth, Q40 */
        if ((uint32_t)(((before - z) << 28) / (before >> 11)) > worst_q40)
          worst_q40 = (uint32_t)(((before - z) << 28) / (before >> 11));
      }
      last = z;
      last_exponent = exponent;
    }
    TEST_ASSERT_UINT32_WITHIN((UINT32_C(1) << (40 - 17 + bits)) / 50, UINT32_C(1) << (40 - 17 + bits), worst_q40);
  }
}

static void test_format_follows_the_depth_range(void) {
  fc_frame frame;
  use(&frame, 0, 0);
  fc_depth_choose(&frame, 100, 1500);
  TEST_ASSERT_EQUAL_UINT8(2, frame.depth_exponent_bits);
  frame.options.depth_exponent_bits = 0;
  fc_depth_choose(&frame, 100, 25000);
  TEST_ASSERT_EQUAL_UINT8(3, frame.depth_exponent_bits);
  fc_depth_choose(&frame, 100, 26000);
  TEST_ASSERT_EQUAL_UINT8(4, frame.depth_exponent_bits);
  fc_depth_choose(&frame, 0, UINT64_MAX);
  TEST_ASSERT_EQUAL_UINT8(4, frame.depth_exponent_bits);
  TEST_ASSERT_GREATER_THAN_UINT32(0, frame.depth_near);
  /* the greatest codes stay free: nothing in range rounds up to 1 */
  fc_depth_choose(&frame, UINT64_MAX, UINT64_MAX);
  TEST_ASSERT_EQUAL_UINT32(UINT32_MAX - (UINT32_MAX >> 16) * 23 - 22, frame.depth_near);
  fc_depth_choose(&frame, 100000, 100000);
  TEST_ASSERT_EQUAL_UINT32(100000 - 35, frame.depth_near);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g8_rounding_is_exact_at_every_boundary);
  RUN_TEST(test_saturation);
  RUN_TEST(test_g8_decoded_steps_are_within_the_bound);
  RUN_TEST(test_format_follows_the_depth_range);
  return UNITY_END();
}
