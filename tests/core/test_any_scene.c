/* Scenes of any bits: refused with an error, or rendered without overflow (seen by UBSan) and the same twice. */
#include <string.h>

#include "fixcast/fixcast.h"
#include "random.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  SIZE = 6,
  EACH = 3
};

static fc_sphere spheres[EACH];
static fc_plane planes[EACH];
static fc_vec3 vertices[EACH + 1];
static fc_triangle triangles[EACH];
static fc_light lights[EACH];
static fc_material materials[2];
static fc_shapes shapes[3];
static fc_scene scene;
static fc_camera camera;
static int64_t memory[64];
static uint8_t pixels[2][SIZE * SIZE * 3];
static uint16_t depth[SIZE * SIZE], primitive[SIZE * SIZE];

/* Mostly in range, of any size, with the limits themselves often; `wild` lets any 32 bits through. */
static int32_t any_value(int wild) {
  if (wild && random_u64() % 64 == 0) return random_u64() & 1 ? INT32_MIN : (int32_t)(uint32_t)(random_u64() & 0x7fffffff);
  switch (random_u64() % 10) {
    case 0: return 0;
    case 1: return FC_COORDINATE_MAX;
    case 2: return -FC_COORDINATE_MAX;
    case 3: return random_within(-3, 3);
    default: return random_any_size(29);
  }
}

static fc_vec3 any_vec(int wild) {
  fc_vec3 v;
  v.x = any_value(wild);
  v.y = any_value(wild);
  v.z = any_value(wild);
  return v;
}

static int8_t any_exponent(int wild, int low, int high) {
  if (random_u64() & 1) return 0;
  return wild && random_u64() % 32 == 0 ? (int8_t)random_within(-128, 127) : (int8_t)random_within(low, high);
}

static uint16_t any_index(int wild, uint16_t count) { return (uint16_t)(random_u64() % (count + (wild && random_u64() % 16 == 0 ? 1u : 0u))); }

static fc_rgb any_rgb(void) {
  fc_rgb c;
  c.r = (uint16_t)random_u64();
  c.g = (uint16_t)random_u64();
  c.b = (uint16_t)random_u64();
  return c;
}

static void make_scene(int wild) {
  int i;
  for (i = 0; i < EACH; i++) {
    spheres[i].center = any_vec(wild);
    spheres[i].radius = any_value(wild);
    if (spheres[i].radius < 1 && spheres[i].radius > INT32_MIN && (!wild || random_u64() % 16 != 0))
      spheres[i].radius = 1 - spheres[i].radius;
    spheres[i].material = any_index(wild, 2);
    planes[i].normal = any_vec(wild);
    if ((!wild || random_u64() % 16 != 0) && planes[i].normal.x == 0) planes[i].normal.x = 1;
    planes[i].d = any_value(wild);
    planes[i].d_exponent = any_exponent(wild, 0, 32);
    planes[i].material = any_index(wild, 2);
    vertices[i] = any_vec(wild);
    triangles[i].vertex[0] = any_index(wild, EACH + 1);
    triangles[i].vertex[1] = any_index(wild, EACH + 1);
    triangles[i].vertex[2] = any_index(wild, EACH + 1);
    triangles[i].material = any_index(wild, 2);
    lights[i].position = any_vec(wild);
    lights[i].exponent = any_exponent(wild, -31, 32);
    lights[i].intensity = any_rgb();
    lights[i].intensity_exponent = any_exponent(wild, -40, 40);
    lights[i].inverse_square = (uint8_t)(random_u64() & 1);
  }
  vertices[EACH] = any_vec(wild);
  materials[0].diffuse = any_rgb();
  materials[1].diffuse = any_rgb();
  memset(&scene, 0, sizeof scene);
  memset(shapes, 0, sizeof shapes);
  shapes[0].kind = &fc_kind_sphere;
  shapes[0].items = spheres;
  shapes[1].kind = &fc_kind_plane;
  shapes[1].items = planes;
  shapes[2].kind = &fc_kind_triangle;
  shapes[2].items = triangles;
  shapes[2].vertices = vertices;
  shapes[2].vertex_count = EACH + 1;
  for (i = 0; i < 3; i++) shapes[i].count = (uint16_t)(random_u64() % (EACH + 1));
  scene.shapes = shapes;
  scene.shape_count = 3;
  scene.materials = materials;
  scene.material_count = 2;
  scene.lights = lights;
  scene.light_count = (uint16_t)(random_u64() % (EACH + 1));
  scene.exponent = any_exponent(wild, -60, 60);
  scene.far_exponent = any_exponent(wild, -31, 32);
  scene.far_limit = random_u64() & 1 ? 0 : any_value(wild);
  if (!wild && scene.far_limit < 0) scene.far_limit = -scene.far_limit;
  scene.ambient = any_rgb();
  scene.background = any_rgb();
  camera.eye = any_vec(wild);
  camera.target = any_vec(wild);
  camera.up = any_vec(wild);
  camera.exponent = any_exponent(wild, -31, 31);
  camera.fov_rule = (uint8_t)(random_u64() % (wild && random_u64() % 16 == 0 ? 3 : 2));
  camera.tan_half_fov_numerator = wild ? (uint32_t)random_u64() >> random_u64() % 32 : (uint32_t)random_within(1, 9);
  camera.tan_half_fov_denominator = wild ? (uint32_t)random_u64() >> random_u64() % 32 : (uint32_t)random_within(1, 9);
}

static int render(uint8_t *to, uint8_t rule, uint16_t rows) {
  fc_frame frame;
  fc_options options;
  fc_target target;
  uint16_t y;
  int error;
  memset(&options, 0, sizeof options);
  options.offset_rule = rule;
  options.epsilon = 1000;
  error = fc_frame_setup(&frame, &scene, &camera, &options, SIZE, SIZE, memory, sizeof memory);
  if (error != FC_OK) return error;
  target.pitch_bytes = SIZE * 3;
  target.format = FC_RGB888;
  target.depth = depth;
  target.primitive = primitive;
  target.lit = NULL;
  for (y = 0; y < SIZE; y = (uint16_t)(y + rows)) {
    target.pixels = to + y * SIZE * 3;
    error = fc_render_rows(&frame, y, rows, &target);
    if (error != FC_OK) return error;
  }
  return FC_OK;
}

static void run(int wild, int trials, int least) {
  int trial, rendered = 0;
  for (trial = 0; trial < trials; trial++) {
    uint8_t rule = (uint8_t)(trial % 4);
    int result;
    make_scene(wild);
    result = render(pixels[0], rule, SIZE);
    TEST_ASSERT_TRUE(result == FC_OK || result < 0);
    if (result != FC_OK) continue;
    rendered++;
    TEST_ASSERT_EQUAL_INT(FC_OK, render(pixels[1], rule, 1));
    TEST_ASSERT_EQUAL_MEMORY(pixels[0], pixels[1], sizeof pixels[0]);
  }
  TEST_ASSERT_GREATER_THAN_INT(least, rendered);
}

#ifdef FIXCAST_BAREMETAL
enum {
  TRIALS = 60
}; /* emulated */
#else
enum {
  TRIALS = 6000
};
#endif

static void test_g12_scenes_of_any_bits(void) { run(1, TRIALS, TRIALS / 20); }

static void test_g12_scenes_within_range(void) { run(0, TRIALS, TRIALS / 3); }

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g12_scenes_of_any_bits);
  RUN_TEST(test_g12_scenes_within_range);
  return UNITY_END();
}
