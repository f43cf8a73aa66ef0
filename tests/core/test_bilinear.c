/* Bilinear images: the scan engine's runs of texels against rays, which find each pixel's coordinates by themselves, in all formats and sizes. */
#include <stdlib.h>
#include <string.h>

#include "fixcast/fixcast.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  SIZE = 72, /* RAM of the smallest chip that runs it: 64 KB */
  MOST = 32 * 32,
  COLOURS = 5
};

/* A floor seen with the head tilted, so that depth changes along rows; and a lamp. */
static const fc_plane floors[] FC_ROM = {{.normal = {0, 1, 0}, .object = 1}};
static const fc_shapes shapes[] FC_ROM = {FC_PLANES(floors)};
static const fc_camera camera FC_ROM = {.eye = FC_VEC3(1, 2, 3),
                                        .target = FC_VEC3(0, 0, -3),
                                        .up = FC_VEC3(1, 5, 0),
                                        .exponent = 0,
                                        .tan_half_fov_numerator = 1,
                                        .tan_half_fov_denominator = 2};
static const fc_light lamp FC_ROM = {.position = FC_VEC3(-3, 5, -1), .intensity = {28672, 24576, 20480}};

static uint8_t bytes[3 * MOST], colours[3 * COLOURS];
static uint16_t packed[MOST];

static int level_of(const uint8_t *pixel, int format, int channel) {
  const int word = pixel[0] << 8 | pixel[1];
  if (format == FC_RGB888) return pixel[channel];
  return channel == 0 ? word >> 11 : channel == 1 ? word >> 5 & 63
                                                  : word & 31;
}

/* Levels within one, and those that are off by it at most `permille` of all: a rounding here and there. */
static void compare(const fc_texture *texture, int format, int permille) {
  static uint8_t pixels[2][SIZE * SIZE * 3];
  static uint16_t depth[SIZE * SIZE];
  static int64_t memory[64];
  const int size = format == FC_RGB888 ? 3 : 2;
  const fc_layer layer = {&fc_layer_texture, texture};
  const fc_material material = {{FC_ONE_Q15, FC_ONE_Q15, FC_ONE_Q15}, 1, &layer};
  fc_options options;
  fc_scene scene;
  fc_frame frame;
  fc_target target;
  int i, channel, off = 0, engine;
  memset(&options, 0, sizeof options);
  memset(&scene, 0, sizeof scene);
  scene.shapes = shapes;
  scene.materials = &material;
  scene.lights = &lamp;
  scene.shape_count = scene.material_count = scene.light_count = 1;
  scene.ambient.r = scene.ambient.g = scene.ambient.b = FC_ONE_Q15 / 8;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, &options, SIZE, SIZE, memory, sizeof memory));
  memset(&target, 0, sizeof target);
  target.format = (uint8_t)format;
  target.pitch_bytes = (size_t)(SIZE * size);
  target.depth = depth;
  for (engine = 0; engine < 2; engine++) {
    target.pixels = pixels[engine];
    TEST_ASSERT_EQUAL_INT(FC_OK, engine == 0 ? fc_render_rows(&frame, 0, SIZE, &target) : fc_render_rows_by_rays(&frame, 0, SIZE, &target));
  }
  for (i = 0; i < SIZE * SIZE; i++)
    for (channel = 0; channel < 3; channel++) {
      const int difference = abs(level_of(pixels[0] + size * i, format, channel) - level_of(pixels[1] + size * i, format, channel));
      TEST_ASSERT_LESS_OR_EQUAL_INT(1, difference);
      off += difference;
    }
  TEST_ASSERT_LESS_OR_EQUAL_INT(permille * 3 * SIZE * SIZE / 1000, off);
}

/* An image of noise, full contrast: the worst that coordinates can meet. */
static void compare_sizes(const fc_texture_kind *kind, fc_texel_format format, const void *texels) {
  static const uint16_t sizes[][2] = {{32, 32}, {16, 8}, {24, 32}, {31, 17}, {1, 1}};
  fc_palette_image palette;
  fc_mapping mapping;
  fc_texture texture;
  size_t i;
  int clamp;
  memset(&palette, 0, sizeof palette);
  memset(&mapping, 0, sizeof mapping);
  mapping.kind = &fc_mapping_planar;
  mapping.u = (fc_vec3)FC_VEC3(2, 0, 0);
  mapping.v = (fc_vec3)FC_VEC3(0, 0, 2);
  mapping.repeat_u = mapping.repeat_v = 1;
  texture = (fc_texture){&mapping, kind, &palette, 0};
  palette.colours = colours;
  palette.colour_count = COLOURS;
  for (i = 0; i < sizeof sizes / sizeof *sizes; i++)
    for (clamp = 0; clamp < 2; clamp++) {
      palette.image = (fc_image){texels, sizes[i][0], sizes[i][1], (uint8_t)format, 1, (uint8_t)clamp};
      compare(&texture, FC_RGB565_BE, 30);
      compare(&texture, FC_RGB888, 60);
    }
}

static void test_three_bytes_a_texel(void) { compare_sizes(&fc_texture_image, FC_TEXEL_RGB888, bytes); }
static void test_grey(void) { compare_sizes(&fc_texture_image, FC_TEXEL_GREY8, bytes); }
static void test_two_bytes_a_texel(void) { compare_sizes(&fc_texture_image, FC_TEXEL_RGB565, packed); }

/* Stripes and areas of one colour, as well as noise. */
static void test_palette(void) {
  static uint8_t numbers[MOST];
  int i;
  for (i = 0; i < MOST; i++) numbers[i] = (uint8_t)(i % 32 < 12 ? 3 : i % 32 < 20 ? i / 32 % COLOURS
                                                                                  : bytes[i] % COLOURS);
  compare_sizes(&fc_texture_palette, FC_TEXEL_RGB888, numbers);
}

int main(void) {
  uint32_t random = 1;
  int i;
  for (i = 0; i < 3 * MOST; i++) {
    random = random * UINT32_C(1664525) + UINT32_C(1013904223);
    bytes[i] = (uint8_t)(random >> 24);
    packed[i % MOST] = (uint16_t)(random >> 16);
    colours[i % (3 * COLOURS)] = (uint8_t)(random >> 23);
  }
  UNITY_BEGIN();
  RUN_TEST(test_three_bytes_a_texel);
  RUN_TEST(test_grey);
  RUN_TEST(test_two_bytes_a_texel);
  RUN_TEST(test_palette);
  return UNITY_END();
}
