/* CRC-32 against its definition, a bit at a time, and CRCs that are joined against those of the whole. */
#include "crc32.h"

#include "unity.h"

enum {
  BYTES = 3000
};

static uint8_t bytes[BYTES];

void setUp(void) {
  uint32_t state = 1;
  size_t i;
  for (i = 0; i < BYTES; i++) {
    state = state * 1664525u + 1013904223u;
    bytes[i] = (uint8_t)(state >> 24);
  }
}

void tearDown(void) {}

static uint32_t by_definition(const uint8_t *from, size_t count) {
  uint32_t crc = 0xffffffffu;
  size_t i;
  int bit;
  for (i = 0; i < count; i++)
    for (bit = 0; bit < 8; bit++) {
      const uint32_t low = (crc ^ ((uint32_t)from[i] >> bit)) & 1u;
      crc = (crc >> 1) ^ (low != 0 ? 0xedb88320u : 0u);
    }
  return ~crc;
}

static void test_crc_of_the_nine_digits_is_the_published_check_value(void) {
  TEST_ASSERT_EQUAL_HEX32(0xcbf43926u, fc_crc32(0, (const uint8_t *)"123456789", 9));
}

static void test_crc_in_pieces_is_that_of_the_whole(void) {
  size_t cut;
  for (cut = 0; cut <= BYTES; cut += 97)
    TEST_ASSERT_EQUAL_HEX32(by_definition(bytes, BYTES), fc_crc32(fc_crc32(0, bytes, cut), bytes + cut, BYTES - cut));
}

static void test_joined_crcs_are_that_of_the_whole_for_any_cut(void) {
  size_t cut;
  for (cut = 0; cut <= BYTES; cut++) {
    const uint32_t before = by_definition(bytes, cut), after = by_definition(bytes + cut, BYTES - cut);
    TEST_ASSERT_EQUAL_HEX32(by_definition(bytes, BYTES), fc_crc32_join(before, after, (uint32_t)(BYTES - cut)));
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_crc_of_the_nine_digits_is_the_published_check_value);
  RUN_TEST(test_crc_in_pieces_is_that_of_the_whole);
  RUN_TEST(test_joined_crcs_are_that_of_the_whole_for_any_cut);
  return UNITY_END();
}
