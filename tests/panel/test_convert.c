/*
 * fc_display_convert against its description (src/panel/convert.c), redone here in another way: the matrix by Bayer's recursion, levels
 * by one exact 64-bit division.
 */
#include <string.h>

#include "fixcast/display.h"
#include "fixcast/error.h"
#include "unity.h"

enum {
  WIDTH = 24,
  ROWS = 16,
  BYTES = WIDTH * 2 * ROWS,
#ifdef FIXCAST_BAREMETAL
  STEP = 61 /* an emulated chip takes its time */
#else
  STEP = 7
#endif
};
static uint8_t from[BYTES], to[BYTES], expected[BYTES];

void setUp(void) {}
void tearDown(void) {}

/* M(2n) = 4 M(n) + (0 2 / 3 1), each quarter of the large matrix a copy of M(n). */
static uint32_t bayer(uint32_t size, uint32_t x, uint32_t y) {
  static const uint8_t quarter[2][2] = {{0, 2}, {3, 1}};
  if (size == 1) return 0;
  return 4 * bayer(size / 2, x % (size / 2), y % (size / 2)) + quarter[y / (size / 2)][x / (size / 2)];
}

/* floor(n v / m + (2 B + 1) / 128) = floor((128 n v + (2 B + 1) m) / (128 m)) */
static uint32_t level(uint32_t v, uint32_t m, uint32_t n, uint32_t x, uint32_t y) {
  const uint64_t b = bayer(8, x % 8, y % 8);
  return (uint32_t)((UINT64_C(128) * n * v + (2 * b + 1) * m) / (UINT64_C(128) * m));
}

static uint32_t pixel_at(const uint8_t *rows, size_t pitch, uint32_t i, uint32_t row) {
  return (uint32_t)rows[row * pitch + 2 * i] * 256 + rows[row * pitch + 2 * i + 1];
}
static uint32_t luma(uint32_t p) { return 41 * (p >> 11) + 39 * (p >> 5 & 63) + 16 * (p & 31); }

/* Rows of `width` pixels at (x, y), each bit of the result set on its own; MONO8 for whole pages. */
static void oracle(uint8_t format, uint32_t x, uint32_t y, uint32_t width, uint32_t rows,
                   const uint8_t *source, size_t source_pitch, uint8_t *target, size_t target_pitch) {
  uint32_t i, row, k;
  for (row = 0; row < rows; row++) {
    const size_t line = (format == FC_DISPLAY_MONO8 ? row / 8 : row) * target_pitch;
    for (k = 0;
         k < fc_display_row_bytes(format, (uint16_t)width) && (format != FC_DISPLAY_MONO8 || row % 8 == 0);
         k++)
      target[line + k] = 0;
    for (i = 0; i < width; i++) {
      const uint32_t p = pixel_at(source, source_pitch, i, row), at_x = x + i, at_y = y + row;
      const uint32_t colour[3] = {level(p >> 11, 31, 15, at_x, at_y), level(p >> 5 & 63, 63, 15, at_x, at_y),
                                  level(p & 31, 31, 15, at_x, at_y)};
      switch (format) {
        case FC_DISPLAY_RGB565:
          target[line + 2 * i] = (uint8_t)(p / 256);
          target[line + 2 * i + 1] = (uint8_t)p;
          break;
        case FC_DISPLAY_RGB444:
          for (k = 0; k < 3; k++)
            target[line + (3 * i + k) / 2] |= (uint8_t)(colour[k] << ((3 * i + k) % 2 ? 0 : 4));
          break;
        case FC_DISPLAY_GREY4:
          target[line + i / 2] |= (uint8_t)(level(luma(p), 4224, 15, at_x, at_y) << (i % 2 ? 0 : 4));
          break;
        default: target[line + i] |= (uint8_t)(level(luma(p), 4224, 1, at_x, at_y) << (row % 8)); break;
      }
    }
  }
}

static void fill(uint32_t seed) {
  size_t i;
  for (i = 0; i < sizeof from; i++) {
    seed = seed * UINT32_C(1664525) + UINT32_C(1013904223);
    from[i] = (uint8_t)(seed >> 24);
  }
}

static void assert_same(const char *what) {
  TEST_ASSERT_EQUAL_HEX8_ARRAY_MESSAGE(expected, to, sizeof to, what);
}

/* All 65536 pixels at places of the matrix. */
static void test_each_pixel_at_each_place_is_as_described(void) {
  uint32_t p, place, x, y;
  uint8_t format;
  for (format = FC_DISPLAY_RGB565; format <= FC_DISPLAY_MONO8; format++) {
    for (p = 0; p < 65536; p++) {
      for (place = p % STEP; place < 64; place += STEP) { /* of every pixel some, of every value all */
        uint8_t one[2], got[2] = {0, 0}, want[2] = {0, 0};
        one[0] = (uint8_t)(p >> 8), one[1] = (uint8_t)p;
        x = place % 8;
        y = format == FC_DISPLAY_MONO8
                ? 0
                : place / 8; /* one bit: the others stay, which another test looks at */
        if (fc_display_convert(format, (uint16_t)x, (uint16_t)y, 1, 1, one, 2, got, 2) != FC_OK)
          TEST_FAIL_MESSAGE("refused");
        oracle(format, x, y, 1, 1, one, 2, want, 2);
        if (memcmp(got, want, 2) != 0) {
          TEST_ASSERT_EQUAL_HEX8_ARRAY_MESSAGE(want, got, 2, "one pixel");
          return;
        }
      }
    }
  }
}

static void test_rows_anywhere_are_as_described(void) {
  static const uint16_t widths[] = {1, 2, 3, 7, 8, 23, 24}, xs[] = {0, 1, 5, 100}, ys[] = {0, 8, 16, 248};
  size_t w, x, y;
  uint8_t format;
  for (format = FC_DISPLAY_RGB565; format <= FC_DISPLAY_MONO8; format++) {
    for (w = 0; w < sizeof widths / sizeof *widths; w++) {
      for (x = 0; x < sizeof xs / sizeof *xs; x++) {
        for (y = 0; y < sizeof ys / sizeof *ys; y++) {
          const uint16_t rows = (uint16_t)(1 + (w * 5 + x * 3 + y) % ROWS),
                         top = (uint16_t)(ys[y] + (format == FC_DISPLAY_MONO8 ? 0 : x));
          if (format == FC_DISPLAY_MONO8 && rows == 1) continue;
          fill((uint32_t)(w * 100 + x * 10 + y));
          memset(to, 0xA5, sizeof to); /* what is not written stays */
          memset(expected, 0xA5, sizeof expected);
          TEST_ASSERT_EQUAL_INT(
              FC_OK, fc_display_convert(format, xs[x], top, widths[w], rows, from, WIDTH * 2, to, WIDTH * 2));
          oracle(format, xs[x], top, widths[w], rows, from, WIDTH * 2, expected, WIDTH * 2);
          assert_same("rows");
        }
      }
    }
  }
}

/* Strips of any height give what the whole gives. */
static void test_rows_one_by_one_are_the_whole(void) {
  uint8_t format;
  uint16_t row;
  for (format = FC_DISPLAY_RGB565; format <= FC_DISPLAY_MONO8; format++) {
    const size_t pitch = fc_display_row_bytes(format, WIDTH);
    const unsigned rows_a_step = format == FC_DISPLAY_MONO8 ? 8 : 1;
    fill(format);
    memset(to, 0x5A, sizeof to);
    memset(expected, 0x5A, sizeof expected);
    TEST_ASSERT_EQUAL_INT(FC_OK,
                          fc_display_convert(format, 3, 8, WIDTH, ROWS, from, WIDTH * 2, expected, pitch));
    for (row = 0; row < ROWS; row++) {
      TEST_ASSERT_EQUAL_INT(
          FC_OK, fc_display_convert(format, 3, (uint16_t)(8 + row), WIDTH, 1, from + row * WIDTH * 2,
                                    WIDTH * 2, to + row / rows_a_step * pitch, pitch));
    }
    assert_same("row by row");
  }
}

static void test_a_single_row_of_one_bit_leaves_the_other_bits_alone(void) {
  uint16_t i;
  for (i = 0; i < 8; i++) {
    memset(from, i & 1 ? 0xFF : 0, WIDTH * 2);
    memset(to, 0x33, WIDTH);
    TEST_ASSERT_EQUAL_INT(FC_OK,
                          fc_display_convert(FC_DISPLAY_MONO8, 0, i, WIDTH, 1, from, WIDTH * 2, to, WIDTH));
    TEST_ASSERT_EQUAL_HEX8(i & 1 ? 0x33 | 1 << i : 0x33 & ~(1 << i), to[5]);
  }
}

static void test_in_place_is_the_same(void) {
  uint8_t format;
  for (format = FC_DISPLAY_RGB565; format <= FC_DISPLAY_GREY4; format++) {
    const size_t pitch = fc_display_row_bytes(format, WIDTH);
    fill(77u + format);
    memcpy(to, from, sizeof to);
    memcpy(expected, from, sizeof expected);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_convert(format, 0, 0, WIDTH, ROWS, to, WIDTH * 2, to, pitch));
    oracle(format, 0, 0, WIDTH, ROWS, from, WIDTH * 2, expected, pitch);
    assert_same("in place");
  }
}

/* Black is black, white is white, and a grey of 64 pixels keeps its mean within 1/128 of a level. */
static void test_dither_keeps_black_white_and_the_mean(void) {
  uint32_t grey, x, y;
  for (grey = 0; grey < 32; grey++) {
    const uint32_t p = grey << 11 | (grey * 63 / 31) << 5 | grey;
    uint32_t sum = 0, white = 0;
    for (y = 0; y < 8; y++) {
      for (x = 0; x < 8; x++) {
        const uint8_t one[2] = {(uint8_t)(p >> 8), (uint8_t)p};
        uint8_t four = 0, bit = 0;
        TEST_ASSERT_EQUAL_INT(
            FC_OK, fc_display_convert(FC_DISPLAY_GREY4, (uint16_t)x, (uint16_t)y, 1, 1, one, 2, &four, 1));
        TEST_ASSERT_EQUAL_INT(
            FC_OK, fc_display_convert(FC_DISPLAY_MONO8, (uint16_t)x, (uint16_t)y, 1, 1, one, 2, &bit, 1));
        sum += four >> 4;
        white += bit >> y;
      }
    }
    /* |sum / 64 - 15 v / m| <= 1 / 128, times 128 m */
    TEST_ASSERT_TRUE((sum * 2 + 1) * 4224 >= 128 * 15 * luma(p) &&
                     sum * 2 * 4224 <= 128 * 15 * luma(p) + 4224);
    TEST_ASSERT_TRUE((white * 2 + 1) * 4224 >= 128 * luma(p) && white * 2 * 4224 <= 128 * luma(p) + 4224);
    if (grey == 0) TEST_ASSERT_EQUAL_UINT32(0, sum + white);
    if (grey == 31) TEST_ASSERT_EQUAL_UINT32(64 * 16, sum + white);
  }
}

static void test_the_weights_are_those_of_bt_601_within_6_per_mille(void) {
  const int32_t red = 41 * 31, green = 39 * 63, blue = 16 * 31;
  TEST_ASSERT_EQUAL_INT32(4224, red + green + blue);
  TEST_ASSERT_INT32_WITHIN(6 * 4224, 299 * 4224, 1000 * red);
  TEST_ASSERT_INT32_WITHIN(6 * 4224, 587 * 4224, 1000 * green);
  TEST_ASSERT_INT32_WITHIN(6 * 4224, 114 * 4224, 1000 * blue);
}

static void test_what_is_refused(void) {
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_convert(FC_DISPLAY_GREY4, 0, 0, 2, 1, NULL, 4, to, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_display_convert(FC_DISPLAY_GREY4, 0, 0, 2, 1, from, 4, NULL, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_FORMAT, fc_display_convert(4, 0, 0, 2, 1, from, 4, to, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, fc_display_convert(FC_DISPLAY_GREY4, 0, 0, 0, 1, from, 4, to, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, fc_display_convert(FC_DISPLAY_GREY4, 0, 0, 2, 0, from, 4, to, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, fc_display_convert(FC_DISPLAY_GREY4, 0, 0, 2, 1, from, 3, to, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, fc_display_convert(FC_DISPLAY_GREY4, 0, 0, 3, 1, from, 6, to, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_AREA, fc_display_convert(FC_DISPLAY_MONO8, 0, 4, 2, 2, from, 4, to, 2));
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_display_convert(FC_DISPLAY_MONO8, 0, 4, 2, 1, from, 4, to, 2));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_what_is_refused);
  RUN_TEST(test_each_pixel_at_each_place_is_as_described);
  RUN_TEST(test_rows_anywhere_are_as_described);
  RUN_TEST(test_rows_one_by_one_are_the_whole);
  RUN_TEST(test_a_single_row_of_one_bit_leaves_the_other_bits_alone);
  RUN_TEST(test_in_place_is_the_same);
  RUN_TEST(test_dither_keeps_black_white_and_the_mean);
  RUN_TEST(test_the_weights_are_those_of_bt_601_within_6_per_mille);
  return UNITY_END();
}
