/* Frames and strips: the same bits whatever the strips, nothing written outside, every bad argument refused. */
#include <string.h>

#include "random.h"
#include "../../host_sim/scenes/s1.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  WIDTH = 48,
  HEIGHT = 36,
  PIXELS = WIDTH * HEIGHT
};

static int64_t memory[64];
static fc_frame frame;
static uint8_t pixels[PIXELS * 3 + 64];
static uint16_t depth[PIXELS], primitive[PIXELS];
static uint32_t lit[PIXELS];

static uint32_t fnv(uint32_t hash, const void *data, size_t bytes) {
  const uint8_t *p = data;
  while (bytes-- > 0) hash = (hash ^ *p++) * UINT32_C(16777619);
  return hash;
}

static void set_up(const fc_scene *scene, uint16_t width, uint16_t height) {
  TEST_ASSERT_EQUAL_INT(FC_OK,
                        fc_frame_setup(&frame, scene, &s1_camera, NULL, width, height, memory, sizeof memory));
}

static fc_target target_of(int format) {
  fc_target t;
  t.pixels = pixels;
  t.pitch_bytes = (size_t)WIDTH * (size_t)fc_format_bytes(format);
  t.format = (uint8_t)format;
  t.depth = depth;
  t.primitive = primitive;
  t.lit = NULL;
  return t;
}

/* A hash over the frame, rendered in strips of `rows`. */
static uint32_t render(int format, uint16_t rows) {
  fc_target target = target_of(format);
  uint32_t hash = UINT32_C(2166136261);
  uint16_t y;
  for (y = 0; y < HEIGHT; y = (uint16_t)(y + rows)) {
    uint16_t n = (uint16_t)(HEIGHT - y < rows ? HEIGHT - y : rows);
    if (fc_render_rows(&frame, y, n, &target) != FC_OK) return 0;
    hash = fnv(hash, pixels, (size_t)n * target.pitch_bytes);
  }
  return hash;
}

static void test_g3_strip_height_changes_nothing(void) {
  uint32_t whole;
  set_up(&s1, WIDTH, HEIGHT);
  whole = render(FC_RGB888, HEIGHT);
  TEST_ASSERT_NOT_EQUAL_UINT32(0, whole);
  TEST_ASSERT_EQUAL_HEX32(whole, render(FC_RGB888, 1));
  TEST_ASSERT_EQUAL_HEX32(whole, render(FC_RGB888, 7));
  TEST_ASSERT_EQUAL_HEX32(whole, render(FC_RGB888, 16));
}

static void test_formats_agree(void) {
  static uint8_t rgb[PIXELS * 3];
  fc_target t;
  int i;
  set_up(&s1, WIDTH, HEIGHT);
  t = target_of(FC_RGB888);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows_by_rays(&frame, 0, HEIGHT, &t));
  memcpy(rgb, pixels, sizeof rgb);
  t = target_of(FC_RGB565_BE);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows_by_rays(&frame, 0, HEIGHT, &t));
  for (i = 0; i < PIXELS; i++) {
    unsigned v = (unsigned)pixels[2 * i] << 8 | pixels[2 * i + 1];
    /* both nearest to one value: |255 r5 - 31 r8| <= 255 / 2 + 31 / 2, and 63 / 2 */
    TEST_ASSERT_INT_WITHIN(143, 31 * (int)rgb[3 * i], 255 * (int)(v >> 11));
    TEST_ASSERT_INT_WITHIN(159, 63 * (int)rgb[3 * i + 1], 255 * (int)(v >> 5 & 63));
    TEST_ASSERT_INT_WITHIN(143, 31 * (int)rgb[3 * i + 2], 255 * (int)(v & 31));
  }
  memcpy(rgb, pixels, PIXELS * 2);
  t = target_of(FC_RGB565_LE);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows_by_rays(&frame, 0, HEIGHT, &t));
  for (i = 0; i < PIXELS * 2; i++) TEST_ASSERT_EQUAL_HEX8(rgb[i ^ 1], pixels[i]);
}

/* The scan engine against its definition; tests/engines does so for every scene. */
static void test_g2_engines_agree(void) {
  static uint8_t rgb[PIXELS * 3];
  static uint16_t depth_by_rays[PIXELS], primitive_by_rays[PIXELS];
  static uint32_t lit_by_rays[PIXELS];
  fc_target t = target_of(FC_RGB888);
  int i;
  set_up(&s1, WIDTH, HEIGHT);
  t.lit = lit;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows_by_rays(&frame, 0, HEIGHT, &t));
  memcpy(rgb, pixels, sizeof rgb);
  memcpy(depth_by_rays, depth, sizeof depth);
  memcpy(primitive_by_rays, primitive, sizeof primitive);
  memcpy(lit_by_rays, lit, sizeof lit);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows(&frame, 0, HEIGHT, &t));
  TEST_ASSERT_EQUAL_MEMORY(depth_by_rays, depth, sizeof depth);
  TEST_ASSERT_EQUAL_MEMORY(primitive_by_rays, primitive, sizeof primitive);
  TEST_ASSERT_EQUAL_MEMORY(lit_by_rays, lit, sizeof lit);
  for (i = 0; i < PIXELS * 3; i++) TEST_ASSERT_INT_WITHIN(1, rgb[i], pixels[i]);
}

static void test_g7_nothing_is_written_outside(void) {
  fc_target t = target_of(FC_RGB888);
  size_t i;
  set_up(&s1, WIDTH, HEIGHT);
  memset(pixels, 0xa5, sizeof pixels);
  memset(depth, 0xa5, sizeof depth);
  memset(lit, 0xa5, sizeof lit);
  t.pitch_bytes = WIDTH * 3 + 5;
  t.lit = lit;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows(&frame, 20, 3, &t));
  for (i = 0; i < sizeof pixels; i++)
    if (i >= 3 * t.pitch_bytes || i % t.pitch_bytes >= WIDTH * 3) TEST_ASSERT_EQUAL_HEX8(0xa5, pixels[i]);
  for (i = 3 * WIDTH; i < PIXELS; i++) {
    TEST_ASSERT_EQUAL_HEX16(0xa5a5, depth[i]);
    TEST_ASSERT_EQUAL_HEX32(UINT32_C(0xa5a5a5a5), lit[i]);
  }
}

/* A pixel and a pick are one thing. */
static void test_pick_agrees_with_the_picture(void) {
  fc_target t = target_of(FC_RGB888);
  uint16_t x, y;
  int surfaces = 0;
  set_up(&s1, WIDTH, HEIGHT);
  t.lit = lit;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows(&frame, 0, HEIGHT, &t));
  for (y = 0; y < HEIGHT; y = (uint16_t)(y + 3)) {
    for (x = 0; x < WIDTH; x++) {
      fc_hit hit;
      uint32_t mask;
      size_t at = (size_t)y * WIDTH + x;
      int found = fc_pick(&frame, x, y, &hit, &mask);
      TEST_ASSERT_EQUAL_INT(primitive[at] != 0xffff, found);
      TEST_ASSERT_EQUAL_INT(depth[at] != 0, found);
      if (!found) continue;
      surfaces++;
      TEST_ASSERT_EQUAL_UINT16(primitive[at], hit.primitive);
      TEST_ASSERT_EQUAL_UINT16(fc_object(&frame, primitive[at]), hit.object);
      TEST_ASSERT_EQUAL_UINT32(lit[at], mask);
      if (hit.object == 4) TEST_ASSERT_INT32_WITHIN(2, 0, hit.position.y); /* on the floor y = 0 */
      if (hit.object == 4) TEST_ASSERT_EQUAL_INT32(1 << 30, hit.normal_q30.y);
    }
  }
  TEST_ASSERT_GREATER_THAN_INT(100, surfaces);
}

/* A far plane, an eye on the finest exponent and one on the coarsest: positions are right or clamped, never wrapped. */
static void test_pick_of_far_points_is_clamped(void) {
  static const fc_plane far_plane[] = {{{0, 0, 1}, 1 << 29, 8, 0, 1}};
  static const fc_shapes tables[] = {FC_PLANES(far_plane)};
  static const int8_t exponents[] = {-31, -16, 0};
  fc_scene scene = s1;
  unsigned i;
  scene.shapes = tables;
  scene.shape_count = 1;
  scene.far_limit = 0;
  for (i = 0; i < sizeof exponents; i++) {
    fc_camera camera = s1_camera;
    fc_hit hit;
    camera.eye.x = camera.eye.y = camera.eye.z = 0;
    camera.target.x = 1 << 29;
    camera.target.y = 0;
    camera.target.z = -1024;
    camera.exponent = exponents[i];
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, NULL, 8, 8, memory, sizeof memory));
    TEST_ASSERT_EQUAL_INT(1, fc_pick(&frame, 0, 0, &hit, NULL));
    TEST_ASSERT_EQUAL_INT32(FC_COORDINATE_MAX, hit.position.x);
    TEST_ASSERT_EQUAL_INT32(FC_COORDINATE_MAX, hit.position.y);
    TEST_ASSERT_EQUAL_INT32(-FC_COORDINATE_MAX, hit.position.z);
  }
}

/* Multiplying the world by a power of two is a change of exponents. */
static void test_g4_world_scale_changes_no_bit(void) {
  fc_scene scaled = s1;
  uint32_t one;
  int8_t e;
  set_up(&s1, WIDTH, HEIGHT);
  one = render(FC_RGB565_BE, HEIGHT);
  for (e = -6; e <= 6; e = (int8_t)(e + 3)) {
    scaled.exponent = e;
    set_up(&scaled, WIDTH, HEIGHT);
    TEST_ASSERT_EQUAL_HEX32(one, render(FC_RGB565_BE, HEIGHT));
  }
}

/* Depth codes follow z, and decode to it within half a step. */
static void test_depth_codes(void) {
  uint32_t code;
  uint8_t bits;
  for (bits = 2; bits <= 4; bits++) {
    fc_options options;
    fc_hit hit;
    uint16_t y;
    int exponent, last_exponent = 100;
    uint32_t last = UINT32_MAX;
    memset(&options, 0, sizeof options);
    options.depth_exponent_bits = bits;
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &s1, &s1_camera, &options, WIDTH, HEIGHT, memory, sizeof memory));
    for (code = 1; code <= 0xffff; code++) {
      uint32_t z = fc_depth_z(&frame, (uint16_t)code, &exponent);
      TEST_ASSERT_TRUE(z >= UINT32_C(0x80000000));
      TEST_ASSERT_TRUE(exponent < last_exponent || (exponent == last_exponent && z < last));
      last = z;
      last_exponent = exponent;
    }
    render(FC_RGB888, HEIGHT);
    for (y = HEIGHT / 2 + 4; y < HEIGHT; y++) {
      uint64_t z, off;
      uint16_t c = depth[(size_t)y * WIDTH];
      TEST_ASSERT_EQUAL_INT(1, fc_pick(&frame, 0, y, &hit, NULL));
      z = fc_depth_z(&frame, c, &exponent);
      TEST_ASSERT_TRUE(exponent < 0);
      /* both in Q32 */
      z = exponent > -32 ? z << (32 + exponent) : z >> (-32 - exponent);
      off = z > hit.t_q32 ? z - hit.t_q32 : hit.t_q32 - z;
      TEST_ASSERT_TRUE(off <= (z >> (17 - bits)) + (z >> 28));
    }
  }
}

/* Family 35: coincident primitives show the lowest number, in frames and picks. */
static void test_coincident_primitives_lowest_number(void) {
  static const fc_sphere twins[] = {{FC_VEC3(0, 1.5, -6), FC_Q16(1), 0, 1}, {FC_VEC3(0, 1.5, -6), FC_Q16(1), 1, 2}};
  static const fc_shapes tables[] = {FC_SPHERES(twins)};
  fc_scene scene = s1;
  fc_hit hit;
  int i, shown = 0;
  scene.shapes = tables;
  scene.shape_count = 1;
  set_up(&scene, WIDTH, HEIGHT);
  render(FC_RGB888, HEIGHT);
  for (i = 0; i < PIXELS; i++) {
    shown += primitive[i] == 0;
    TEST_ASSERT_TRUE(primitive[i] != 1);
  }
  TEST_ASSERT_GREATER_THAN_INT(50, shown);
  TEST_ASSERT_EQUAL_INT(1, fc_pick(&frame, WIDTH / 2, HEIGHT / 2, &hit, NULL));
  TEST_ASSERT_EQUAL_UINT16(1, hit.object);
}

static void test_g6_bad_arguments_are_refused(void) {
  static fc_scratch scratch;
  fc_target t = target_of(FC_RGB888);
  fc_camera camera = s1_camera;
  fc_hit hit;
  fc_options options;
  size_t bytes = fc_frame_memory(&s1, NULL);
  TEST_ASSERT_EQUAL_UINT(3 * 32 + 40 + 24, bytes);
  TEST_ASSERT_EQUAL_INT(FC_ERR_MEMORY, fc_frame_setup(&frame, &s1, &s1_camera, NULL, 8, 8, memory, bytes - 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_MEMORY, fc_frame_setup(&frame, &s1, &s1_camera, NULL, 8, 8, NULL, bytes));
  TEST_ASSERT_EQUAL_INT(FC_ERR_MEMORY,
                        fc_frame_setup(&frame, &s1, &s1_camera, NULL, 8, 8, (uint8_t *)memory + 1, bytes));
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_frame_setup(&frame, &s1, &s1_camera, NULL, 0, 8, memory, bytes));
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_frame_setup(&frame, &s1, &s1_camera, NULL, 8, 4097, memory, bytes));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_frame_setup(&frame, NULL, &s1_camera, NULL, 8, 8, memory, bytes));
  memset(&options, 0, sizeof options);
  options.offset_rule = 4;
  TEST_ASSERT_EQUAL_INT(FC_ERR_FORMAT, fc_frame_setup(&frame, &s1, &s1_camera, &options, 8, 8, memory, bytes));
  options.offset_rule = 0;
  options.depth_exponent_bits = 5;
  TEST_ASSERT_EQUAL_INT(FC_ERR_FORMAT, fc_frame_setup(&frame, &s1, &s1_camera, &options, 8, 8, memory, bytes));
  camera.target = camera.eye;
  TEST_ASSERT_EQUAL_INT(FC_ERR_CAMERA_TARGET, fc_frame_setup(&frame, &s1, &camera, NULL, 8, 8, memory, bytes));
  camera = s1_camera;
  camera.up.y = 0;
  camera.up.z = -77;
  TEST_ASSERT_EQUAL_INT(FC_ERR_CAMERA_UP, fc_frame_setup(&frame, &s1, &camera, NULL, 8, 8, memory, bytes));
  camera = s1_camera;
  camera.tan_half_fov_denominator = 0;
  TEST_ASSERT_EQUAL_INT(FC_ERR_FIELD_OF_VIEW, fc_frame_setup(&frame, &s1, &camera, NULL, 8, 8, memory, bytes));
  set_up(&s1, WIDTH, HEIGHT);
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_render_rows(&frame, 0, 0, &t));
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_render_rows(&frame, HEIGHT, 1, &t));
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_render_rows(&frame, HEIGHT - 1, 2, &t));
  t.format = 3;
  TEST_ASSERT_EQUAL_INT(FC_ERR_FORMAT, fc_render_rows(&frame, 0, 1, &t));
  TEST_ASSERT_EQUAL_INT(FC_ERR_FORMAT, fc_render_rows_in(&scratch, &frame, 0, 1, &t));
  t = target_of(FC_RGB888);
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_render_rows_in(NULL, &frame, 0, 1, &t));
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows_in(&scratch, &frame, 0, 1, &t));
  t.pitch_bytes--;
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_render_rows(&frame, 0, 1, &t));
  t.depth = NULL;
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_render_rows(&frame, 0, 1, &t));
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_pick(&frame, WIDTH, 0, &hit, NULL));
}

/* The lectures' rules are there to show their faults: without an offset the floor and spheres shadow themselves, with a
 * large epsilon contact shadows leak, and the residual rule shows none of either here. */
static void test_offset_rules(void) {
  static const uint8_t rules[] = {FC_OFFSET_EXACT, FC_OFFSET_RESIDUAL, FC_OFFSET_EPSILON, FC_OFFSET_NONE};
  int32_t unlit[4], i;
  for (i = 0; i < 4; i++) {
    fc_options options;
    fc_target t = target_of(FC_RGB888);
    int p;
    memset(&options, 0, sizeof options);
    options.offset_rule = rules[i];
    options.epsilon = FC_Q16(0.25);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &s1, &s1_camera, &options, WIDTH, HEIGHT, memory, sizeof memory));
    t.lit = lit;
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows(&frame, 0, HEIGHT, &t));
    unlit[i] = 0;
    for (p = 0; p < PIXELS; p++) unlit[i] += primitive[p] != 0xffff && lit[p] == 0;
  }
  TEST_ASSERT_EQUAL_INT32(unlit[0], unlit[1]);
  TEST_ASSERT_GREATER_THAN_INT(unlit[0] + 20, unlit[3]); /* acne */
  TEST_ASSERT_NOT_EQUAL_INT(unlit[0], unlit[2]);         /* peter-panning */
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g3_strip_height_changes_nothing);
  RUN_TEST(test_formats_agree);
  RUN_TEST(test_g2_engines_agree);
  RUN_TEST(test_g7_nothing_is_written_outside);
  RUN_TEST(test_pick_agrees_with_the_picture);
  RUN_TEST(test_pick_of_far_points_is_clamped);
  RUN_TEST(test_g4_world_scale_changes_no_bit);
  RUN_TEST(test_depth_codes);
  RUN_TEST(test_coincident_primitives_lowest_number);
  RUN_TEST(test_g6_bad_arguments_are_refused);
  RUN_TEST(test_offset_rules);
  return UNITY_END();
}
