/*
 * The scan engine against the ray engine, its definition, on every own scene: the same primitives, lights and depth codes,
 * colours within one level, the same bits in any strips and in either byte order.
 *
 * SCENES lists the baked scenes as X(name) ...; compiled with the whole core.
 */
#include <stdio.h>
#include <string.h>

#include "fixcast/fixcast.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  WORDS = 20000,
  MOST = 240 * 240
};

typedef struct picture {
  uint8_t pixels[MOST * 3];
  uint16_t depth[MOST], primitive[MOST];
  uint32_t lit[MOST];
} picture;

static int64_t memory[WORDS];
static picture rays, scan, part;
static fc_frame frame;

#define X(name) \
  extern const fc_scene name; \
  extern const fc_camera name##_camera;
SCENES
#undef X

static const struct {
  const char *name;
  const fc_scene *scene;
  const fc_camera *camera;
} scenes[] = {
#define X(name) {#name, &name, &name##_camera},
    SCENES
#undef X
};

static fc_scratch scratch;

static fc_target target_of(picture *to, uint16_t y, int format, size_t gap) {
  const size_t at = (size_t)y * frame.width, bytes = (size_t)fc_format_bytes(format);
  fc_target t;
  t.pitch_bytes = frame.width * bytes + gap;
  t.pixels = to->pixels + y * t.pitch_bytes;
  t.format = (uint8_t)format;
  t.depth = to->depth + at;
  t.primitive = to->primitive + at;
  t.lit = to->lit + at;
  return t;
}

static void put_level(const uint8_t *at, int format, int level[3]) {
  unsigned packed;
  if (format == FC_RGB888) {
    level[0] = at[0];
    level[1] = at[1];
    level[2] = at[2];
    return;
  }
  packed = format == FC_RGB565_BE ? (unsigned)at[0] << 8 | at[1] : (unsigned)at[1] << 8 | at[0];
  level[0] = (int)(packed >> 11);
  level[1] = (int)(packed >> 5 & 63);
  level[2] = (int)(packed & 31);
}

/* scan against rays. */
static void compare(int format, const char *what) {
  const size_t bytes = (size_t)fc_format_bytes(format), pixels = (size_t)frame.width * frame.height;
  char text[160];
  size_t i;
  int c;
  for (i = 0; i < pixels; i++) {
    int expected[3], level[3];
    put_level(rays.pixels + i * bytes, format, expected);
    put_level(scan.pixels + i * bytes, format, level);
    snprintf(text, sizeof text, "%s, pixel (%u, %u)", what, (unsigned)(i % frame.width), (unsigned)(i / frame.width));
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(rays.primitive[i], scan.primitive[i], text);
    TEST_ASSERT_EQUAL_HEX16_MESSAGE(rays.depth[i], scan.depth[i], text);
    TEST_ASSERT_EQUAL_HEX32_MESSAGE(rays.lit[i], scan.lit[i], text);
    for (c = 0; c < 3; c++) TEST_ASSERT_INT_WITHIN_MESSAGE(1, expected[c], level[c], text);
  }
}

static void compare_orders(const char *what) {
  const size_t pixels = (size_t)frame.width * frame.height;
  fc_target t = target_of(&part, 0, FC_RGB565_LE, 0);
  size_t i;
  TEST_ASSERT_EQUAL_INT_MESSAGE(FC_OK, fc_render_rows(&frame, 0, frame.height, &t), what);
  for (i = 0; i < 2 * pixels; i++) TEST_ASSERT_EQUAL_HEX8_MESSAGE(scan.pixels[i ^ 1], part.pixels[i], what);
}

/* Strips of some rows, the last ones first, against the whole; the target may want less. */
static void compare_strips(int format, uint16_t rows, const char *what, int only_pixels) {
  const size_t bytes = (size_t)fc_format_bytes(format), pixels = (size_t)frame.width * frame.height;
  uint16_t y = (uint16_t)((frame.height - 1) / rows * rows);
  memset(&part, 0x5a, sizeof part);
  for (;; y = (uint16_t)(y - rows)) {
    fc_target t = target_of(&part, y, format, 0);
    if (only_pixels) {
      t.primitive = NULL;
      t.lit = NULL;
    }
    /* every other strip in the caller's memory, whatever it holds */
    if (y / rows % 2 == 0) {
      memset(&scratch, y / rows % 4 == 0 ? 0xff : 0, sizeof scratch);
      TEST_ASSERT_EQUAL_INT_MESSAGE(
          FC_OK, fc_render_rows_in(&scratch, &frame, y, (uint16_t)(frame.height - y < rows ? frame.height - y : rows), &t), what);
    } else {
      TEST_ASSERT_EQUAL_INT_MESSAGE(
          FC_OK, fc_render_rows(&frame, y, (uint16_t)(frame.height - y < rows ? frame.height - y : rows), &t), what);
    }
    if (y == 0) break;
  }
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(scan.pixels, part.pixels, pixels * bytes, what);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(scan.depth, part.depth, pixels * sizeof part.depth[0], what);
  if (only_pixels) return;
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(scan.primitive, part.primitive, pixels * sizeof part.primitive[0], what);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(scan.lit, part.lit, pixels * sizeof part.lit[0], what);
}

static void run(size_t scene, uint16_t width, uint16_t height, uint8_t rule, uint8_t depth_bits) {
  static const uint16_t strips[] = {1, 7, 16};
  char what[128];
  fc_options options;
  size_t i;
  int format;
  memset(&options, 0, sizeof options);
  options.offset_rule = rule;
  options.depth_exponent_bits = depth_bits;
  options.epsilon = 64;
  snprintf(what, sizeof what, "%s %ux%u, offset rule %u, depth bits %u", scenes[scene].name, width, height, rule, depth_bits);
  /* clang-format off */
  TEST_ASSERT_EQUAL_INT_MESSAGE(FC_OK, fc_frame_setup(&frame, scenes[scene].scene, scenes[scene].camera, &options, width,
                                                      height, memory, sizeof memory), what);
  /* clang-format on */
  for (format = FC_RGB888; format <= FC_RGB565_LE; format++) {
    fc_target t = target_of(&rays, 0, format, 0);
    TEST_ASSERT_EQUAL_INT_MESSAGE(FC_OK, fc_render_rows_by_rays(&frame, 0, height, &t), what);
    t = target_of(&scan, 0, format, 0);
    TEST_ASSERT_EQUAL_INT_MESSAGE(FC_OK, fc_render_rows(&frame, 0, height, &t), what);
    compare(format, what);
    for (i = 0; i < sizeof strips / sizeof strips[0]; i++) compare_strips(format, strips[i], what, i == 1);
    if (format == FC_RGB565_BE) compare_orders(what);
  }
}

static size_t scene_named(const char *name) {
  size_t i;
  for (i = 0; i < sizeof scenes / sizeof scenes[0]; i++)
    if (strcmp(scenes[i].name, name) == 0) return i;
  TEST_FAIL_MESSAGE(name);
  return 0;
}

static void test_g2_engines_agree_in_any_size(void) {
  static const uint16_t sizes[][2] = {{1, 1}, {3, 5}, {17, 40}, {65, 33}, {127, 61}};
  size_t i, j;
  for (i = 0; i < sizeof scenes / sizeof scenes[0]; i++)
    for (j = 0; j < sizeof sizes / sizeof sizes[0]; j++) run(i, sizes[j][0], sizes[j][1], FC_OFFSET_EXACT, 0);
}

static void test_g2_engines_agree_at_full_size(void) {
  static const char *const names[] = {"s1", "s1r"};
  size_t i;
  for (i = 0; i < sizeof names / sizeof names[0]; i++) run(scene_named(names[i]), 240, 240, FC_OFFSET_EXACT, 0);
}

static void test_g2_engines_agree_with_every_option(void) {
  size_t i;
  uint8_t rule, bits;
  for (i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
    for (rule = FC_OFFSET_RESIDUAL; rule <= FC_OFFSET_NONE; rule++) run(i, 29, 23, rule, 0);
    for (bits = 2; bits <= 4; bits++) run(i, 40, 31, FC_OFFSET_EXACT, bits);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g2_engines_agree_in_any_size);
  RUN_TEST(test_g2_engines_agree_at_full_size);
  RUN_TEST(test_g2_engines_agree_with_every_option);
  return UNITY_END();
}
