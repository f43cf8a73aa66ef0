/* Narrow tables say the same as wide ones, or are refused: vertices of 16 bits, images with a palette. */
#include <string.h>

#include "fixcast/fixcast.h"
#include "random.h"
#include "unity.h"

enum {
  TRIANGLES = 12,
  SIDE = 16
};

static fc_short_vec3 narrow[3 * TRIANGLES];
static fc_vec3 wide[3 * TRIANGLES];
static fc_triangle triangles[TRIANGLES];
static const fc_material materials[1] = {FC_MATTE(FC_RGB8(200, 150, 100))};
static const fc_light lights[1] = {{{FC_COORDINATE_MAX, FC_COORDINATE_MAX, -FC_COORDINATE_MAX}, FC_GREY(1), 0, 0, 0, 0}};
static fc_shapes shapes[1];
static fc_scene scene;
static int64_t memory[512];

void setUp(void) {
  memset(&scene, 0, sizeof scene);
  scene.shapes = shapes;
  scene.shape_count = 1;
  scene.materials = materials;
  scene.material_count = 1;
  scene.lights = lights;
  scene.light_count = 1;
  scene.background = materials[0].diffuse;
}
void tearDown(void) {}

static void make_mesh(uint8_t shift) {
  int i;
  for (i = 0; i < 3 * TRIANGLES; i++) {
    narrow[i].x = (int16_t)random_within(-32767, 32767);
    narrow[i].y = (int16_t)random_within(-32767, 32767);
    narrow[i].z = (int16_t)random_within(-32767, 32767);
    wide[i].x = narrow[i].x * (INT32_C(1) << shift);
    wide[i].y = narrow[i].y * (INT32_C(1) << shift);
    wide[i].z = narrow[i].z * (INT32_C(1) << shift);
    triangles[i / 3].vertex[i % 3] = (uint16_t)i;
    triangles[i / 3].object = 1;
  }
}

/* Pixels of the scene from beside the mesh, and the depth that set-up found nearest. */
static uint64_t draw(uint8_t shift, uint8_t pixels[3 * SIDE * SIDE]) {
  static uint16_t depth[SIDE * SIDE], primitive[SIDE * SIDE];
  fc_camera camera = {{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 1, FC_FOV_EDGES, 1, 1};
  fc_frame frame;
  fc_target target;
  memset(&target, 0, sizeof target);
  target.pixels = pixels;
  target.pitch_bytes = 3 * SIDE;
  target.format = FC_RGB888;
  target.depth = depth;
  target.primitive = primitive;
  camera.eye.z = 32767 * (INT32_C(1) << shift);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, NULL, SIDE, SIDE, memory, sizeof memory));
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows(&frame, 0, SIDE, &target));
  return frame.depth_near;
}

static void test_short_vertices_draw_what_wide_ones_draw(void) {
  static uint8_t from_wide[3 * SIDE * SIDE], from_narrow[3 * SIDE * SIDE];
  uint8_t shift;
  for (shift = 0; shift <= 15; shift++) {
    const fc_shapes as_wide = FC_TRIANGLES(wide, triangles), as_narrow = FC_TRIANGLES_SHORT(narrow, 15, NULL, NULL, triangles, 0);
    uint64_t near_wide;
    size_t i, seen = 0;
    make_mesh(shift);
    shapes[0] = as_wide;
    near_wide = draw(shift, from_wide);
    shapes[0] = as_narrow;
    shapes[0].vertex_shift = shift;
    TEST_ASSERT_TRUE(near_wide == draw(shift, from_narrow));
    TEST_ASSERT_EQUAL_MEMORY(from_wide, from_narrow, sizeof from_wide);
    for (i = 3; i < sizeof from_wide; i++) seen += from_wide[i] != from_wide[i - 3];
    TEST_ASSERT_TRUE(seen > 30); /* there is something to compare */
  }
}

static void test_short_vertices_beyond_the_range_are_refused(void) {
  const fc_shapes as_narrow = FC_TRIANGLES_SHORT(narrow, 15, NULL, NULL, triangles, 0);
  make_mesh(15);
  shapes[0] = as_narrow;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_scene_check(&scene));
  narrow[5].y = INT16_MIN; /* 2^30 */
  TEST_ASSERT_EQUAL_INT(FC_ERR_COORDINATE, fc_scene_check(&scene));
  shapes[0].vertex_shift = 14;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_scene_check(&scene));
  shapes[0].vertex_shift = 16;
  TEST_ASSERT_EQUAL_INT(FC_ERR_EXPONENT, fc_scene_check(&scene));
}

static void test_palettes_are_checked(void) {
  static const uint8_t colours[6] = {1, 2, 3, 4, 5, 6};
  static const fc_mapping mapping = {&fc_mapping_spherical, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 1, 1};
  uint8_t texels[6] = {0, 1, 1, 0, 1, 0};
  fc_palette_image image = {{NULL, 3, 2, FC_TEXEL_RGB888, 1, 0}, colours, 2};
  fc_texture texture = {&mapping, &fc_texture_palette, NULL, 0};
  fc_layer layer = {&fc_layer_texture, NULL};
  fc_material material = {{0, 0, 0}, 1, NULL};
  scene.shape_count = 0;
  scene.materials = &material;
  material.layers = &layer;
  layer.data = &texture;
  texture.pattern_data = &image;
  TEST_ASSERT_EQUAL_INT(FC_ERR_MATERIAL, fc_scene_check(&scene));
  image.image.texels = texels;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_scene_check(&scene));
  texels[5] = 2;
  TEST_ASSERT_EQUAL_INT(FC_ERR_INDEX, fc_scene_check(&scene));
  image.colour_count = 3; /* not read: the check believes it */
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_scene_check(&scene));
  image.image.format = FC_TEXEL_GREY8;
  TEST_ASSERT_EQUAL_INT(FC_ERR_MATERIAL, fc_scene_check(&scene));
  image.image.format = FC_TEXEL_RGB888;
  image.colours = NULL;
  TEST_ASSERT_EQUAL_INT(FC_ERR_MATERIAL, fc_scene_check(&scene));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_short_vertices_draw_what_wide_ones_draw);
  RUN_TEST(test_short_vertices_beyond_the_range_are_refused);
  RUN_TEST(test_palettes_are_checked);
  return UNITY_END();
}
