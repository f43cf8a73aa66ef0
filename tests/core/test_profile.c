/* Profiles: bad arguments are refused, nothing is written outside, picks name pixels of the whole frame. */
#include <string.h>

#include "../../host_sim/scenes/s1.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  WIDTH = 23,
  HEIGHT = 17,
  PIXELS = WIDTH * HEIGHT,
  GUARD = 0xc3
};

static int64_t memory[64];
static fc_frame frame;
static uint8_t pixels[PIXELS * 2 + 8];
static uint16_t depth[PIXELS + 4], primitive[PIXELS + 4];

static int set_up(uint8_t profile) {
  fc_options options;
  memset(&options, 0, sizeof options);
  options.profile = profile;
  return fc_frame_setup(&frame, &s1, &s1_camera, &options, WIDTH, HEIGHT, memory, sizeof memory);
}

static fc_target target(void) {
  fc_target t;
  t.pixels = pixels;
  t.pitch_bytes = 2 * WIDTH;
  t.format = FC_RGB565_BE;
  t.depth = depth;
  t.primitive = primitive;
  t.lit = NULL;
  return t;
}

static void test_g6_bad_arguments_are_refused(void) {
  uint8_t profile;
  fc_target t = target();
  TEST_ASSERT_EQUAL_INT(FC_ERR_PROFILE, set_up(FC_PROFILE_INTERLACED + 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_PROFILE, set_up(255));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_render_profile(NULL, 0, 0, 1, &t));
  for (profile = FC_PROFILE_EXACT; profile <= FC_PROFILE_INTERLACED; profile++) {
    t = target();
    TEST_ASSERT_EQUAL_INT(FC_OK, set_up(profile));
    TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_render_profile(&frame, 0, 0, 1, NULL));
    TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_render_profile(&frame, 0, 0, 0, &t));
    TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_render_profile(&frame, 0, 0, HEIGHT + 1, &t));
    TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_render_profile(&frame, 0, HEIGHT, 1, &t));
    TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_render_profile(&frame, 0, 1, UINT16_MAX, &t));
    t.pitch_bytes--;
    TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_render_profile(&frame, 0, 0, 1, &t));
    t = target();
    t.format = 9;
    TEST_ASSERT_EQUAL_INT(FC_ERR_FORMAT, fc_render_profile(&frame, 0, 0, 1, &t));
    t = target();
    t.depth = NULL;
    TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_render_profile(&frame, 0, 0, 1, &t));
  }
  t = target();
  TEST_ASSERT_EQUAL_INT(FC_ERR_PROFILE, fc_render_profile(&frame, 2, 0, 1, &t));
}

static void test_g7_nothing_is_written_outside(void) {
  uint8_t profile, field;
  size_t i;
  for (profile = FC_PROFILE_EXACT; profile <= FC_PROFILE_INTERLACED; profile++) {
    TEST_ASSERT_EQUAL_INT(FC_OK, set_up(profile));
    for (field = 0; field < 2; field++) {
      fc_target t = target();
      memset(pixels, GUARD, sizeof pixels);
      memset(depth, GUARD, sizeof depth);
      memset(primitive, GUARD, sizeof primitive);
      TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_profile(&frame, field, 0, HEIGHT, &t));
      for (i = PIXELS * 2; i < sizeof pixels; i++) TEST_ASSERT_EQUAL_HEX8(GUARD, pixels[i]);
      for (i = PIXELS; i < PIXELS + 4; i++) {
        TEST_ASSERT_EQUAL_HEX16(0xc3c3, depth[i]);
        TEST_ASSERT_EQUAL_HEX16(0xc3c3, primitive[i]);
      }
    }
  }
}

static void test_picks_name_pixels_of_the_whole_frame(void) {
  uint8_t profile;
  uint16_t x, y;
  for (profile = FC_PROFILE_EXACT; profile <= FC_PROFILE_INTERLACED; profile++) {
    fc_target t = target();
    fc_hit hit;
    TEST_ASSERT_EQUAL_INT(FC_OK, set_up(profile));
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_profile(&frame, 0, 0, HEIGHT, &t));
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_profile(&frame, 1, 0, HEIGHT, &t));
    TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_pick(&frame, WIDTH, 0, &hit, NULL));
    TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_pick(&frame, 0, HEIGHT, &hit, NULL));
    for (y = 0; y < HEIGHT; y += 4)
      for (x = y % 3; x < WIDTH; x += 3) {
        int found = fc_pick(&frame, x, y, &hit, NULL);
        TEST_ASSERT_EQUAL_HEX16(found == 1 ? hit.primitive : 0xffff, primitive[y * WIDTH + x]);
      }
    TEST_ASSERT_TRUE(fc_pick(&frame, WIDTH - 1, HEIGHT - 1, &hit, NULL) >= 0);
  }
}

/* Rows that start at multiples of four bytes are widened two pixels at a time; others byte by byte: the same picture. */
static void test_half_resolution_on_any_alignment(void) {
  enum {
    EVEN = WIDTH - 1
  };
  static uint32_t words[EVEN * HEIGHT / 2 + HEIGHT];
  fc_options options;
  fc_target t = target();
  uint16_t y;
  memset(&options, 0, sizeof options);
  options.profile = FC_PROFILE_HALF;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &s1, &s1_camera, &options, EVEN, HEIGHT, memory, sizeof memory));
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_profile(&frame, 0, 0, HEIGHT, &t)); /* 46 bytes a row */
  t.pixels = words;
  t.pitch_bytes = 2 * EVEN + 4;
  memset(words, GUARD, sizeof words);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_profile(&frame, 0, 0, HEIGHT, &t));
  for (y = 0; y < HEIGHT; y++) {
    TEST_ASSERT_EQUAL_MEMORY(pixels + y * 2 * WIDTH, (uint8_t *)words + y * t.pitch_bytes, 2 * EVEN);
    if (y + 1 < HEIGHT) TEST_ASSERT_EQUAL_HEX32(UINT32_C(0xc3c3c3c3), words[((y + 1u) * t.pitch_bytes) / 4 - 1]);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g6_bad_arguments_are_refused);
  RUN_TEST(test_g7_nothing_is_written_outside);
  RUN_TEST(test_picks_name_pixels_of_the_whole_frame);
  RUN_TEST(test_half_resolution_on_any_alignment);
  return UNITY_END();
}
