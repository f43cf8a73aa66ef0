/* Materials: what texels, mappings and transfer functions make of a wall that fills the picture, and bad ones refused. */
#include <string.h>

#include "fixcast/fixcast.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  SIZE = 8,
  TEXELS = 4
};

/* Seen by `camera`, the wall's corners are the picture's; u goes to the right and v down. */
static const fc_vec3 corners[] FC_ROM = {FC_VEC3(-2, 2, 0), FC_VEC3(2, 2, 0), FC_VEC3(2, -2, 0), FC_VEC3(-2, -2, 0)};
static const fc_triangle halves[] FC_ROM = {{.vertex = {0, 3, 1}, .object = 1}, {.vertex = {1, 3, 2}, .object = 1}};
static const fc_uv tile[] FC_ROM = {{0, 0}, {FC_Q16(1), 0}, {FC_Q16(1), FC_Q16(1)}, {0, FC_Q16(1)}};
static const fc_uv beyond[] FC_ROM = {{-FC_Q16(1), 0}, {FC_Q16(2), 0}, {FC_Q16(2), FC_Q16(1)}, {-FC_Q16(1), FC_Q16(1)}};
static const fc_camera camera FC_ROM = {
    .eye = FC_VEC3(0, 0, 4), .up = {0, 1, 0}, .tan_half_fov_numerator = 1, .tan_half_fov_denominator = 2};

static fc_image image;
static fc_mapping mapping;
static fc_texture texture;
static fc_layer layer;
static fc_material material;
static fc_shapes shapes;
static fc_scene scene;
static fc_options options;
static int64_t memory[64];
static uint8_t pixels[SIZE * SIZE * 3];
static uint16_t depth[SIZE * SIZE];

static void hang_up(const void *texels, fc_texel_format format) {
  memset(&image, 0, sizeof image);
  image.texels = texels;
  image.width = image.height = TEXELS;
  image.format = (uint8_t)format;
  memset(&mapping, 0, sizeof mapping);
  mapping.kind = &fc_mapping_vertices;
  mapping.repeat_u = mapping.repeat_v = 1;
  memset(&texture, 0, sizeof texture);
  texture.mapping = &mapping;
  texture.pattern = &fc_texture_image;
  texture.pattern_data = &image;
  layer.kind = &fc_layer_texture;
  layer.data = &texture;
  memset(&material, 0, sizeof material);
  material.layer_count = 1;
  material.layers = &layer;
  memset(&shapes, 0, sizeof shapes);
  shapes.kind = &fc_kind_triangle;
  shapes.items = halves;
  shapes.vertices = corners;
  shapes.count = 2;
  shapes.vertex_count = 4;
  shapes.uvs = tile;
  memset(&scene, 0, sizeof scene);
  scene.shapes = &shapes;
  scene.materials = &material;
  scene.shape_count = scene.material_count = 1;
  scene.ambient.r = scene.ambient.g = scene.ambient.b = FC_ONE_Q15;
  memset(&options, 0, sizeof options);
}

/* The picture by rays and by the scan engine, which must be the same here: nothing is lit, so nothing is approximate. */
static int draw(uint8_t format) {
  static uint8_t by_rays[sizeof pixels];
  fc_frame frame;
  fc_target target;
  int error = fc_frame_setup(&frame, &scene, &camera, &options, SIZE, SIZE, memory, sizeof memory);
  if (error != FC_OK) return error;
  memset(&target, 0, sizeof target);
  target.format = format;
  target.pitch_bytes = SIZE * (format == FC_RGB888 ? 3 : 2);
  target.depth = depth;
  target.pixels = by_rays;
  error = fc_render_rows_by_rays(&frame, 0, SIZE, &target);
  if (error != FC_OK) return error;
  target.pixels = pixels;
  error = fc_render_rows(&frame, 0, SIZE, &target);
  TEST_ASSERT_EQUAL_MEMORY(by_rays, pixels, SIZE * target.pitch_bytes);
  return error;
}

static const uint8_t *pixel(int x, int y) { return pixels + 3 * (y * SIZE + x); }

static void test_texels_stand_where_they_are_stored(void) {
  static uint8_t rgb888[TEXELS * TEXELS][3], grey[TEXELS * TEXELS];
  static uint16_t rgb565[TEXELS * TEXELS];
  int format, i, x, y;
  for (i = 0; i < TEXELS * TEXELS; i++) {
    grey[i] = (uint8_t)(17 * i);
    rgb888[i][0] = (uint8_t)(255 - 3 * i);
    rgb888[i][1] = (uint8_t)(5 * i);
    rgb888[i][2] = grey[i];
    rgb565[i] = (uint16_t)(i << 11 | 4 * i << 5 | (31 - i));
  }
  for (format = FC_TEXEL_RGB888; format <= FC_TEXEL_GREY8; format++) {
    hang_up(format == FC_TEXEL_RGB888 ? (const void *)rgb888 : format == FC_TEXEL_RGB565 ? (const void *)rgb565
                                                                                         : grey,
            (fc_texel_format)format);
    TEST_ASSERT_EQUAL_INT(FC_OK, draw(FC_RGB888));
    for (y = 0; y < SIZE; y++)
      for (x = 0; x < SIZE; x++) {
        uint8_t right[3];
        i = y / 2 * TEXELS + x / 2;
        if (format == FC_TEXEL_RGB888) {
          memcpy(right, rgb888[i], 3);
        } else if (format == FC_TEXEL_RGB565) {
          right[0] = (uint8_t)((i * 510 + 31) / 62); /* of 31 levels, rounded to nearest */
          right[1] = (uint8_t)((4 * i * 510 + 63) / 126);
          right[2] = (uint8_t)(((31 - i) * 510 + 31) / 62);
        } else {
          right[0] = right[1] = right[2] = grey[i];
        }
        TEST_ASSERT_EQUAL_MEMORY(right, pixel(x, y), 3);
      }
  }
}

/* Three tiles side by side: the image three times, or its border's texels to both sides. */
static void test_tiles_repeat_or_the_border_goes_on(void) {
  static const uint8_t grey[TEXELS * TEXELS] = {10, 20, 30, 40, 10, 20, 30, 40, 10, 20, 30, 40, 10, 20, 30, 40};
  int x;
  for (image.clamp = 0; image.clamp < 2; image.clamp++) {
    const uint8_t clamp = image.clamp;
    hang_up(grey, FC_TEXEL_GREY8);
    image.clamp = clamp;
    shapes.uvs = beyond;
    TEST_ASSERT_EQUAL_INT(FC_OK, draw(FC_RGB888));
    for (x = 0; x < SIZE; x++) {
      /* u of the pixel's middle, in sixteenths of a tile: -1 + 3 (2 x + 1) / 16 */
      const int u = -16 + 3 * (2 * x + 1), texel = clamp ? (u < 0 ? 0 : u >= 16 ? 3
                                                                                : u / 4)
                                                         : (u + 16) % 16 / 4;
      TEST_ASSERT_EQUAL_INT(grey[texel], pixel(x, 5)[0]);
    }
  }
}

/* Between the middles of texels a bilinear image is a straight line; pixels lie a quarter of a texel beside the middles. */
static void test_between_texels(void) {
  static const uint8_t ramp[TEXELS * TEXELS] = {0, 40, 80, 120, 0, 40, 80, 120, 0, 40, 80, 120, 0, 40, 80, 120};
  int x;
  hang_up(ramp, FC_TEXEL_GREY8);
  image.bilinear = image.clamp = 1;
  TEST_ASSERT_EQUAL_INT(FC_OK, draw(FC_RGB888));
  for (x = 1; x < SIZE - 1; x++) TEST_ASSERT_INT_WITHIN(1, 20 * x - 10, pixel(x, 3)[0]);
  TEST_ASSERT_EQUAL_INT(0, pixel(0, 3)[0]);
  TEST_ASSERT_EQUAL_INT(120, pixel(SIZE - 1, 3)[0]);
}

/* Levels of half the light by IEC 61966-2-1 and by the power 1 / 2.2: 187.5 and 186.1 of 255, 22.8 and 22.6 of 31, 46.3 and 46.0 of 63. */
static void test_transfer_functions(void) {
  static const uint8_t white[TEXELS * TEXELS] = {255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255};
  const fc_transfer *const transfers[] = {&fc_transfer_srgb, &fc_transfer_gamma22};
  static const uint8_t level255[] = {188, 186};
  int i, textured;
  for (textured = 0; textured < 2; textured++)
    for (i = 0; i < 2; i++) {
      hang_up(white, FC_TEXEL_GREY8);
      if (!textured) material.layer_count = 0;
      material.diffuse.r = material.diffuse.g = material.diffuse.b = FC_ONE_Q15;
      scene.ambient.r = scene.ambient.g = scene.ambient.b = FC_ONE_Q15 / 2;
      options.transfer = transfers[i];
      TEST_ASSERT_EQUAL_INT(FC_OK, draw(FC_RGB888));
      TEST_ASSERT_EQUAL_INT(level255[i], pixel(3, 3)[1]);
      TEST_ASSERT_EQUAL_INT(FC_OK, draw(FC_RGB565_BE));
      TEST_ASSERT_EQUAL_HEX8(23 << 3 | 46 >> 3, pixels[0]);
      TEST_ASSERT_EQUAL_HEX8((46 & 7) << 5 | 23, pixels[1]);
      TEST_ASSERT_EQUAL_INT(FC_OK, draw(FC_RGB565_LE));
      TEST_ASSERT_EQUAL_HEX8(23 << 3 | 46 >> 3, pixels[1]);
      TEST_ASSERT_EQUAL_HEX8((46 & 7) << 5 | 23, pixels[0]);
    }
}

/* A lit wall, ambient light a quarter: the scan engine's cosine is approximate, so its levels are within one of the ray engine's. */
static void test_transfer_of_lit_surfaces(void) {
  static const uint8_t white[TEXELS * TEXELS];
  static const fc_light light FC_ROM = {.position = FC_VEC3(1, 1, 3), .intensity = FC_GREY(0.5)};
  static uint8_t by_rays[sizeof pixels];
  fc_frame frame;
  fc_target target;
  unsigned i;
  hang_up(white, FC_TEXEL_GREY8);
  material.layer_count = 0;
  material.diffuse.r = FC_ONE_Q15;
  material.diffuse.g = FC_ONE_Q15 / 2;
  scene.ambient.r = scene.ambient.g = scene.ambient.b = FC_ONE_Q15 / 4;
  scene.lights = &light;
  scene.light_count = 1;
  options.transfer = &fc_transfer_srgb;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, &options, SIZE, SIZE, memory, sizeof memory));
  memset(&target, 0, sizeof target);
  target.format = FC_RGB888;
  target.pitch_bytes = SIZE * 3;
  target.depth = depth;
  target.pixels = by_rays;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows_by_rays(&frame, 0, SIZE, &target));
  target.pixels = pixels;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows(&frame, 0, SIZE, &target));
  for (i = 0; i < sizeof pixels; i++) TEST_ASSERT_INT_WITHIN(1, by_rays[i], pixels[i]);
  /* at the foot of the light the cosine is nearly 1: 0.75 as IEC 61966-2-1 has it is 224.6 of 255, 0.375 is 164.9 */
  TEST_ASSERT_INT_WITHIN(2, 224, pixel(5, 2)[0]);
  TEST_ASSERT_INT_WITHIN(2, 164, pixel(5, 2)[1]);
  TEST_ASSERT_EQUAL_INT(0, pixel(5, 2)[2]);
}

static int refused(void) { return draw(FC_RGB888); }

static void test_g6_bad_materials_are_refused(void) {
  static const uint8_t grey[TEXELS * TEXELS];
#define BAD(change) \
  do { \
    hang_up(grey, FC_TEXEL_GREY8); \
    TEST_ASSERT_EQUAL_INT(FC_OK, refused()); \
    change; \
    TEST_ASSERT_EQUAL_INT(FC_ERR_MATERIAL, refused()); \
  } while (0)
  BAD(image.texels = NULL);
  BAD(image.width = 0);
  BAD(image.height = 0);
  BAD(image.width = 4097);
  BAD(image.height = 4097);
  BAD(image.format = FC_TEXEL_GREY8 + 1);
  BAD(image.bilinear = 2);
  BAD(image.clamp = 2);
  BAD(mapping.kind = NULL);
  BAD(mapping.repeat_u = 0);
  BAD(mapping.repeat_v = 0);
  BAD(mapping.kind = &fc_mapping_planar); /* its u and v are 0 */
  BAD(texture.mapping = NULL);
  BAD(texture.pattern = NULL);
  BAD(texture.pattern_data = NULL);
  BAD(texture.modulate = 2);
  BAD(layer.kind = NULL);
  BAD(layer.data = NULL);
  BAD(layer.kind = &fc_layer_smooth); /* takes no data */
  BAD((layer.kind = &fc_layer_phong, layer.data = NULL));
  BAD((layer.kind = &fc_layer_mirror, layer.data = NULL));
  BAD((layer.kind = &fc_layer_emission, layer.data = NULL));
  BAD(material.layers = NULL);
  BAD(material.layer_count = FC_LAYERS_MAX + 1);
#undef BAD
}

static void test_g6_bad_lights_and_skies_are_refused(void) {
  static const uint8_t grey[TEXELS * TEXELS];
  static fc_light light;
  static fc_sky sky;
#define BAD(error, change) \
  do { \
    hang_up(grey, FC_TEXEL_GREY8); \
    memset(&light, 0, sizeof light); \
    memset(&sky, 0, sizeof sky); \
    light.position.y = 1; \
    light.directional = 1; \
    sky.kind = &fc_sky_gradient; \
    sky.up.y = 1; \
    scene.lights = &light; \
    scene.light_count = 1; \
    scene.sky = &sky; \
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_scene_check(&scene)); \
    change; \
    TEST_ASSERT_EQUAL_INT(error, fc_scene_check(&scene)); \
  } while (0)
  BAD(FC_ERR_COORDINATE, light.position.x = FC_COORDINATE_MAX + 1);
  BAD(FC_ERR_COORDINATE, light.position.z = -FC_COORDINATE_MAX - 1);
  BAD(FC_ERR_DIRECTION, light.position.y = 0);
  BAD(FC_ERR_DIRECTION, light.exponent = 1);
  BAD(FC_ERR_DIRECTION, light.inverse_square = 1);
  BAD(FC_ERR_DIRECTION, light.directional = 2);
  BAD(FC_ERR_EXPONENT, light.intensity_exponent = 41);
  BAD(FC_ERR_EXPONENT, light.intensity_exponent = -41);
  BAD(FC_ERR_EXPONENT, (light.directional = 0, light.exponent = 33));
  BAD(FC_ERR_EXPONENT, (light.directional = 0, light.exponent = -32));
  BAD(FC_ERR_NULL, scene.lights = NULL);
  BAD(FC_ERR_NULL, scene.materials = NULL);
  BAD(FC_ERR_NULL, scene.shapes = NULL);
  BAD(FC_ERR_NULL, shapes.kind = NULL);
  BAD(FC_ERR_NULL, shapes.items = NULL);
  BAD(FC_ERR_NULL, sky.kind = NULL);
  BAD(FC_ERR_DIRECTION, sky.up.y = 0);
#undef BAD
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_texels_stand_where_they_are_stored);
  RUN_TEST(test_tiles_repeat_or_the_border_goes_on);
  RUN_TEST(test_between_texels);
  RUN_TEST(test_transfer_functions);
  RUN_TEST(test_transfer_of_lit_surfaces);
  RUN_TEST(test_g6_bad_materials_are_refused);
  RUN_TEST(test_g6_bad_lights_and_skies_are_refused);
  return UNITY_END();
}
