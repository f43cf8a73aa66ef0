/*
 * Profiles on every own scene, against the exact frame: fast shows the same primitives and depth and colours within 4/255;
 * half is the frame of its samples, doubled; fields are rows of the exact frame, and leave the others alone.
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
  MOST = 240 * 240,
  LEFT_ALONE = 0x5a,
  BESIDE = 7
};

typedef struct picture {
  uint8_t pixels[MOST * 3 + 240 * BESIDE];
  uint16_t depth[MOST], primitive[MOST];
  uint32_t lit[MOST];
} picture;

static int64_t memory[WORDS];
static picture exact, drawn, once;
static fc_frame frame;

#define X(name) \
  extern const fc_scene name; \
  extern const fc_camera name##_camera;
SCENES
#undef X

/* What fast forms leave to the ray engine: a triangle that reaches behind the eye, a sphere around it, a plane through it. */
static const fc_material odd_materials[] FC_ROM = {FC_MATTE(FC_RGB8(224, 64, 48)), FC_MATTE(FC_RGB8(48, 192, 80))};
static const fc_vec3 odd_vertices[] FC_ROM = {FC_VEC3(-3, -1, 2), FC_VEC3(4, -1, -9), FC_VEC3(-5, 2, -9)};
static const fc_triangle odd_triangles[] FC_ROM = {{{0, 1, 2}, 0, 1}};
static const fc_sphere odd_spheres[] FC_ROM = {{FC_VEC3(0, 0, 1), FC_Q16(20), 1, 2}};
static const fc_plane odd_planes[] FC_ROM = {{.normal = {0, 1, 0}, .material = 0, .object = 3}};
static const fc_light odd_lights[] FC_ROM = {{.position = FC_VEC3(-3, 5, -1), .intensity = FC_GREY(0.875)}};
static const fc_shapes odd_shapes[] FC_ROM = {FC_SPHERES(odd_spheres), FC_PLANES(odd_planes),
                                              FC_TRIANGLES(odd_vertices, odd_triangles)};
static const fc_scene odd FC_ROM = {.shapes = odd_shapes,
                                    .shape_count = FC_COUNT_OF(odd_shapes),
                                    .materials = odd_materials,
                                    .material_count = FC_COUNT_OF(odd_materials),
                                    .lights = odd_lights,
                                    .light_count = FC_COUNT_OF(odd_lights),
                                    .ambient = FC_GREY(0.125)};
static const fc_camera odd_camera FC_ROM = {.eye = FC_VEC3(0, 0, 1),
                                            .target = FC_VEC3(0, 0.25, 0),
                                            .up = {0, 1, 0},
                                            .tan_half_fov_numerator = 1,
                                            .tan_half_fov_denominator = 2};

static const struct {
  const char *name;
  const fc_scene *scene;
  const fc_camera *camera;
} scenes[] = {
#define X(name) {#name, &name, &name##_camera},
    SCENES
#undef X
    {"odd", &odd, &odd_camera},
};

static const uint16_t sizes[][2] = {{1, 1}, {2, 2}, {3, 5}, {17, 40}, {64, 33}, {127, 61}};

#define COUNT_OF(array) (sizeof(array) / sizeof(array)[0])

/* The strip from row y of a picture of this width. */
static fc_target target_of(picture *to, uint16_t width, uint16_t y, int format) {
  const size_t at = (size_t)y * width;
  fc_target t;
  t.pitch_bytes = width * (size_t)fc_format_bytes(format) + BESIDE;
  t.pixels = to->pixels + y * t.pitch_bytes;
  t.format = (uint8_t)format;
  t.depth = to->depth + at;
  t.primitive = to->primitive + at;
  t.lit = to->lit + at;
  return t;
}

static void set_up(size_t scene, uint16_t width, uint16_t height, uint8_t profile) {
  fc_options options;
  memset(&options, 0, sizeof options);
  options.profile = profile;
  /* clang-format off */
  TEST_ASSERT_EQUAL_INT_MESSAGE(FC_OK, fc_frame_setup(&frame, scenes[scene].scene, scenes[scene].camera, &options, width,
                                                      height, memory, sizeof memory), scenes[scene].name);
  /* clang-format on */
}

/* The exact frame into `exact`. */
static void draw_exact(size_t scene, uint16_t width, uint16_t height, int format) {
  fc_target t = target_of(&exact, width, 0, format);
  set_up(scene, width, height, FC_PROFILE_EXACT);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows(&frame, 0, height, &t));
}

/* The frame that is set up in strips of some rows, the last ones first, into `drawn`. */
static void draw_profile(uint16_t width, uint16_t height, int format, uint8_t field, uint16_t rows) {
  uint16_t y = (uint16_t)((height - 1) / rows * rows);
  for (;; y = (uint16_t)(y - rows)) {
    fc_target t = target_of(&drawn, width, y, format);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_profile(&frame, field, y, (uint16_t)(height - y < rows ? height - y : rows), &t));
    if (y == 0) break;
  }
}

static void message(char text[160], size_t scene, uint16_t width, uint16_t height, int format, uint16_t rows) {
  snprintf(text, 160, "%s %ux%u, format %d, strips of %u", scenes[scene].name, width, height, format, rows);
}

/* A picture's row against another's row of the same width. */
static void same_row(const picture *a, uint16_t row_a, const picture *b, uint16_t row_b, uint16_t width, int format,
                     const char *what) {
  const size_t bytes = width * (size_t)fc_format_bytes(format), pitch = bytes + BESIDE;
  const size_t at = (size_t)row_a * width, other = (size_t)row_b * width;
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(a->pixels + row_a * pitch, b->pixels + row_b * pitch, bytes, what);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(a->depth + at, b->depth + other, width * sizeof a->depth[0], what);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(a->primitive + at, b->primitive + other, width * sizeof a->primitive[0], what);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(a->lit + at, b->lit + other, width * sizeof a->lit[0], what);
}

/* ---- fast ---- */

/* Channels and the greatest value of each. */
static void levels(const uint8_t *at, int format, int level[3], int most[3]) {
  unsigned packed = 0;
  if (format != FC_RGB888) packed = format == FC_RGB565_BE ? (unsigned)at[0] << 8 | at[1] : (unsigned)at[1] << 8 | at[0];
  level[0] = format == FC_RGB888 ? at[0] : (int)(packed >> 11);
  level[1] = format == FC_RGB888 ? at[1] : (int)(packed >> 5 & 63);
  level[2] = format == FC_RGB888 ? at[2] : (int)(packed & 31);
  most[0] = most[2] = format == FC_RGB888 ? 255 : 31;
  most[1] = format == FC_RGB888 ? 255 : 63;
}

/*
 * Primitives and depth equal those of the exact frame, which is FC_RGB888; so do colours but for 4/255, half a level of the
 * format and the exact frame's own 0.8 of a level, where lights are equal. Returns how many lights are not.
 */
static size_t compare_fast(size_t scene, uint16_t width, uint16_t height, int format) {
  const size_t bytes = (size_t)fc_format_bytes(format);
  size_t i, wrong = 0;
  char text[160];
  message(text, scene, width, height, format, height);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(exact.primitive, drawn.primitive, (size_t)width * height * 2, text);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(exact.depth, drawn.depth, (size_t)width * height * 2, text);
  for (i = 0; i < (size_t)width * height; i++) {
    const uint8_t *right = exact.pixels + i / width * (3u * width + BESIDE) + 3 * (i % width);
    int level[3], most[3], c;
    if (exact.lit[i] != drawn.lit[i]) {
      wrong++;
      continue;
    }
    levels(drawn.pixels + i / width * (width * bytes + BESIDE) + i % width * bytes, format, level, most);
    for (c = 0; c < 3; c++)
      TEST_ASSERT_INT_WITHIN_MESSAGE(48 * most[c] + 1275, 10 * most[c] * right[c], 2550 * level[c], text);
  }
  return wrong;
}

static void test_fast_keeps_primitives_and_colours(void) {
  size_t i, j, wrong = 0, pixels = 0;
  int format;
  for (i = 0; i < COUNT_OF(scenes); i++)
    for (j = 0; j < COUNT_OF(sizes); j++)
      for (format = FC_RGB888; format <= FC_RGB565_LE; format++) {
        draw_exact(i, sizes[j][0], sizes[j][1], FC_RGB888);
        set_up(i, sizes[j][0], sizes[j][1], FC_PROFILE_FAST);
        draw_profile(sizes[j][0], sizes[j][1], format, 0, sizes[j][1]);
        wrong += compare_fast(i, sizes[j][0], sizes[j][1], format);
        pixels += (size_t)sizes[j][0] * sizes[j][1];
      }
  TEST_ASSERT_TRUE(wrong * 2000 <= pixels); /* what it states: below 0.05 % */
}

static void test_fast_at_full_size(void) {
  size_t i;
  for (i = 0; i < COUNT_OF(scenes); i++) {
    draw_exact(i, 240, 240, FC_RGB888);
    set_up(i, 240, 240, FC_PROFILE_FAST);
    draw_profile(240, 240, FC_RGB565_BE, 0, 240);
    TEST_ASSERT_TRUE(compare_fast(i, 240, 240, FC_RGB565_BE) < 240 * 240 / 2000);
  }
}

static void test_fast_draws_the_same_in_any_strips(void) {
  size_t i;
  for (i = 0; i < COUNT_OF(scenes); i++) {
    uint16_t y;
    fc_target t = target_of(&once, 65, 0, FC_RGB565_BE);
    set_up(i, 65, 49, FC_PROFILE_FAST);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_profile(&frame, 9, 0, 49, &t)); /* the field is not looked at */
    draw_profile(65, 49, FC_RGB565_BE, 0, 7);
    for (y = 0; y < 49; y++) same_row(&once, y, &drawn, y, 65, FC_RGB565_BE, scenes[i].name);
  }
}

/* ---- half ---- */

/* `once` holds the samples: each must show in its block. */
static void compare_half(uint16_t width, uint16_t height, int format, const char *what) {
  const size_t bytes = (size_t)fc_format_bytes(format), samples = (size_t)(width + 1) / 2;
  const size_t pitch = width * bytes + BESIDE, sample_pitch = samples * bytes + BESIDE;
  uint16_t x, y;
  for (y = 0; y < height; y++)
    for (x = 0; x < width; x++) {
      const size_t i = (size_t)y * width + x, s = (size_t)(y / 2) * samples + x / 2;
      TEST_ASSERT_EQUAL_MEMORY_MESSAGE(once.pixels + y / 2 * sample_pitch + x / 2 * bytes, drawn.pixels + y * pitch + x * bytes,
                                       bytes, what);
      TEST_ASSERT_EQUAL_HEX16_MESSAGE(once.depth[s], drawn.depth[i], what);
      TEST_ASSERT_EQUAL_HEX16_MESSAGE(once.primitive[s], drawn.primitive[i], what);
      TEST_ASSERT_EQUAL_HEX32_MESSAGE(once.lit[s], drawn.lit[i], what);
    }
}

static void test_half_is_its_samples_doubled(void) {
  static const uint16_t strips[] = {1, 2, 3, 7, 16, 240};
  size_t i, j, k;
  int format;
  for (i = 0; i < COUNT_OF(scenes); i++)
    for (j = 0; j < COUNT_OF(sizes); j++)
      for (format = FC_RGB888; format <= FC_RGB565_LE; format++) {
        const uint16_t width = sizes[j][0], height = sizes[j][1], samples = (uint16_t)((width + 1) / 2);
        fc_target t = target_of(&once, samples, 0, format);
        set_up(i, width, height, FC_PROFILE_HALF);
        TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows(&frame, 0, (uint16_t)((height + 1) / 2), &t));
        for (k = 0; k < COUNT_OF(strips); k++) {
          char text[160];
          message(text, i, width, height, format, strips[k]);
          memset(&drawn, LEFT_ALONE, sizeof drawn);
          draw_profile(width, height, format, 0, strips[k]);
          compare_half(width, height, format, text);
        }
      }
}

/* The middle of a block is the centre of a pixel in a frame of half the size. */
static void test_half_of_an_even_size_is_the_smaller_frame(void) {
  size_t i;
  uint16_t y;
  for (i = 0; i < COUNT_OF(scenes); i++) {
    fc_target t = target_of(&once, 60, 0, FC_RGB565_BE);
    draw_exact(i, 60, 44, FC_RGB565_BE);
    set_up(i, 120, 88, FC_PROFILE_HALF);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows(&frame, 0, 44, &t));
    if (scenes[i].camera->fov_rule == FC_FOV_CENTRES) continue; /* spans S - 1 pixels: another angle for the smaller frame */
    for (y = 0; y < 44; y++)
      TEST_ASSERT_EQUAL_MEMORY_MESSAGE(exact.primitive + 60 * y, once.primitive + 60 * y, 120, scenes[i].name);
  }
}

/* Of an odd size it is the block's first pixel, which is the frame's too. */
static void test_half_of_an_odd_size_shows_pixels_of_the_frame(void) {
  size_t i;
  uint16_t x, y;
  for (i = 0; i < COUNT_OF(scenes); i++) {
    fc_target t = target_of(&once, 32, 0, FC_RGB888);
    draw_exact(i, 63, 47, FC_RGB888);
    set_up(i, 63, 47, FC_PROFILE_HALF);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows(&frame, 0, 24, &t));
    for (y = 0; y < 24; y++)
      for (x = 0; x < 32; x++) {
        TEST_ASSERT_EQUAL_HEX16_MESSAGE(exact.primitive[2 * y * 63 + 2 * x], once.primitive[y * 32 + x], scenes[i].name);
        TEST_ASSERT_EQUAL_HEX16_MESSAGE(exact.depth[2 * y * 63 + 2 * x], once.depth[y * 32 + x], scenes[i].name);
        TEST_ASSERT_EQUAL_HEX32_MESSAGE(exact.lit[2 * y * 63 + 2 * x], once.lit[y * 32 + x], scenes[i].name);
      }
  }
}

/* ---- interlaced ---- */

static void test_fields_are_rows_of_the_exact_frame(void) {
  static const uint16_t strips[] = {1, 7, 16, 240};
  size_t i, j, k;
  int format;
  uint8_t field;
  memset(&once, LEFT_ALONE, sizeof once);
  for (i = 0; i < COUNT_OF(scenes); i++)
    for (j = 0; j < COUNT_OF(sizes); j++)
      for (format = FC_RGB888; format <= FC_RGB565_LE; format++) {
        const uint16_t width = sizes[j][0], height = sizes[j][1];
        draw_exact(i, width, height, format);
        set_up(i, width, height, FC_PROFILE_INTERLACED);
        for (k = 0; k < COUNT_OF(strips); k++) {
          char text[160];
          uint16_t y;
          message(text, i, width, height, format, strips[k]);
          memset(&drawn, LEFT_ALONE, sizeof drawn);
          for (field = 0; field < 2; field++) {
            draw_profile(width, height, format, field, strips[k]);
            for (y = 0; y < height; y++)
              same_row(y % 2 <= field ? &exact : &once, y, &drawn, y, width, format, text);
          }
        }
      }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_fast_keeps_primitives_and_colours);
  RUN_TEST(test_fast_at_full_size);
  RUN_TEST(test_fast_draws_the_same_in_any_strips);
  RUN_TEST(test_half_is_its_samples_doubled);
  RUN_TEST(test_half_of_an_even_size_is_the_smaller_frame);
  RUN_TEST(test_half_of_an_odd_size_shows_pixels_of_the_frame);
  RUN_TEST(test_fields_are_rows_of_the_exact_frame);
  return UNITY_END();
}
