/*
 * fc_display_dither565 against its description (src/panel/bayer.h), redone here in another way: the matrix by interleaving the bits of the place, levels
 * by one exact 64-bit division.
 */
#include <string.h>

#include "fixcast/display.h"
#include "fixcast/error.h"
#include "unity.h"

enum {
  WIDTH = 19,
  ROWS = 21
};
static uint8_t from[WIDTH * 3 * ROWS], to[WIDTH * 3 * ROWS], whole[WIDTH * 2 * ROWS];

void setUp(void) {}
void tearDown(void) {}

/* M(2n) = 4 M(n) + (0 2 / 3 1): the lowest bits of column and row weigh most; (0 2 / 3 1) is 2 (x xor y) + y. */
static uint32_t bayer(uint32_t x, uint32_t y) {
  uint32_t value = 0, bit;
  for (bit = 0; bit < 3; bit++) value = 4 * value + 2 * ((x ^ y) >> bit & 1) + (y >> bit & 1);
  return value;
}

/* floor(n v / 255 + (2 B + 1) / 128) */
static uint32_t level(uint32_t v, uint32_t n, uint32_t x, uint32_t y) {
  return (uint32_t)((UINT64_C(128) * n * v + (2 * bayer(x, y) + 1) * UINT64_C(255)) / (UINT64_C(128) * 255));
}

static uint32_t dithered(const uint8_t rgb[3], uint32_t x, uint32_t y) {
  uint8_t got[2] = {0, 0};
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_dither565((uint16_t)x, (uint16_t)y, 1, 1, rgb, 3, got, 2));
  return got[0] * UINT32_C(256) + got[1];
}

/* Each value of each channel at each place; other channels hold other values, so that none leaks into another. */
static void test_each_value_at_each_place_is_as_described(void) {
  uint32_t v, place;
  for (v = 0; v < 256; v++) {
    const uint8_t rgb[3] = {(uint8_t)v, (uint8_t)(v * 3 + 7), (uint8_t)(255 - v)};
    for (place = 0; place < 64; place++) {
      const uint32_t x = place % 8, y = place / 8;
      const uint32_t expected = level(rgb[0], 31, x, y) << 11 | level(rgb[1], 63, x, y) << 5 | level(rgb[2], 31, x, y);
      const uint32_t got = dithered(rgb, x + 8 * (v % 5), y + 8 * (v % 3));
      if (got != expected) { /* asked here: 16384 times is much on an emulated chip */
        TEST_ASSERT_EQUAL_HEX32(expected, got);
        return;
      }
    }
  }
}

/* The mean of 64 pixels is within 1/128 of a level of what one exact display would show; black and white are themselves. */
static void test_the_mean_is_kept_and_black_and_white_are_pure(void) {
  uint32_t v, place;
  for (v = 0; v < 256; v++) {
    const uint8_t rgb[3] = {(uint8_t)v, (uint8_t)v, (uint8_t)v};
    uint32_t sum = 0, sum_green = 0;
    for (place = 0; place < 64; place++) {
      const uint32_t pixel = dithered(rgb, place % 8, place / 8);
      sum += pixel >> 11;
      sum_green += pixel >> 5 & 63;
    }
    /* |sum / 64 - n v / 255| <= 1 / 128, times 128 * 255 */
    TEST_ASSERT_UINT32_WITHIN(255, 128 * 31 * v, sum * 2 * 255);
    TEST_ASSERT_UINT32_WITHIN(255, 128 * 63 * v, sum_green * 2 * 255);
    if (v == 0) TEST_ASSERT_EQUAL_UINT32(0, sum + sum_green);
    if (v == 255) TEST_ASSERT_EQUAL_UINT32(64 * 31 + 64 * 63, sum + sum_green);
  }
}

static void fill(void) {
  uint32_t seed = 5;
  size_t i;
  for (i = 0; i < sizeof from; i++) {
    seed = seed * UINT32_C(1664525) + UINT32_C(1013904223);
    from[i] = (uint8_t)(seed >> 24);
  }
}

/* Nothing but a pixel's own place and value counts: strips, columns, and in place, give what the whole gives. */
static void test_any_cut_of_a_picture_gives_the_same_pixels(void) {
  uint16_t rows, x, y;
  fill();
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_dither565(5, 3, WIDTH, ROWS, from, WIDTH * 3, whole, WIDTH * 2));
  for (rows = 1; rows <= ROWS; rows++) {
    memset(to, 0xA5, sizeof to);
    for (y = 0; y < ROWS; y = (uint16_t)(y + rows))
      TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_dither565(5, (uint16_t)(3 + y), WIDTH, ROWS - y < rows ? (uint16_t)(ROWS - y) : rows,
                                                        from + y * WIDTH * 3, WIDTH * 3, to + y * WIDTH * 2, WIDTH * 2));
    TEST_ASSERT_EQUAL_INT(0, memcmp(whole, to, sizeof whole));
    TEST_ASSERT_EQUAL_HEX8(0xA5, to[sizeof whole]); /* nothing behind it */
  }
  for (x = 0; x < WIDTH; x++)
    TEST_ASSERT_EQUAL_INT(FC_OK,
                          fc_display_dither565((uint16_t)(5 + x), 3, 1, ROWS, from + 3 * x, WIDTH * 3, to + 2 * x, WIDTH * 2));
  TEST_ASSERT_EQUAL_INT(0, memcmp(whole, to, sizeof whole));
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_dither565(5, 3, WIDTH, ROWS, from, WIDTH * 3, from, WIDTH * 2));
  TEST_ASSERT_EQUAL_INT(0, memcmp(whole, from, sizeof whole));
}

static void test_what_is_refused(void) {
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_dither565(0, 0, 2, 1, NULL, 6, to, 4));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_dither565(0, 0, 2, 1, from, 6, NULL, 4));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, fc_display_dither565(0, 0, 0, 1, from, 6, to, 4));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, fc_display_dither565(0, 0, 2, 0, from, 6, to, 4));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, fc_display_dither565(0, 0, 2, 1, from, 5, to, 4));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, fc_display_dither565(0, 0, 2, 1, from, 6, to, 3));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_what_is_refused);
  RUN_TEST(test_each_value_at_each_place_is_as_described);
  RUN_TEST(test_the_mean_is_kept_and_black_and_white_are_pure);
  RUN_TEST(test_any_cut_of_a_picture_gives_the_same_pixels);
  return UNITY_END();
}
