/* Triangles by the scan engine against the ray engine: the same primitives, lights and depth codes at every pixel. */
#include <stdbool.h>
#include <string.h>

#include "fixcast/fixcast.h"
#include "random.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  WIDTH = 37,
  HEIGHT = 29,
  PIXELS = WIDTH * HEIGHT,
  VERTICES = 16,
  TRIANGLES = 14
};

static fc_vec3 vertices[VERTICES];
/* Emulated chips take a part of the scenes: every kind of them, as the host has gone through all. */
#ifdef FIXCAST_BAREMETAL
enum {
  PART = 6
};
#else
enum {
  PART = 1
};
#endif

static fc_triangle triangles[TRIANGLES];
static fc_plane ground;
static fc_light lamp;
static fc_material materials[3] = {FC_MATTE(FC_RGB8(200, 100, 50)), FC_MATTE(FC_RGB8(20, 220, 90)), FC_MATTE(FC_RGB8(90, 90, 250))};
static fc_shapes shapes[2];
static fc_scene scene;
static fc_camera camera;
static fc_frame frame;
static int64_t memory[256];
static uint8_t pixels[2][PIXELS * 3];
static uint16_t depth[2][PIXELS], primitive[2][PIXELS];
static uint32_t lit[2][PIXELS];

static fc_vec3 at(int32_t x, int32_t y, int32_t z) {
  fc_vec3 v;
  v.x = x;
  v.y = y;
  v.z = z;
  return v;
}

/* A level camera at the origin: pixel (x, y) is seen along (2x + 1 - WIDTH, HEIGHT - 2y - 1, -HEIGHT). */
static void reset(void) {
  memset(&scene, 0, sizeof scene);
  memset(&camera, 0, sizeof camera);
  memset(&lamp, 0, sizeof lamp);
  camera.target = at(0, 0, -1);
  camera.up = at(0, 1, 0);
  camera.tan_half_fov_numerator = camera.tan_half_fov_denominator = 1;
  scene.materials = materials;
  scene.material_count = FC_COUNT_OF(materials);
  scene.ambient.r = scene.ambient.g = scene.ambient.b = FC_ONE_Q15;
  scene.shapes = shapes;
  scene.shape_count = 1;
  shapes[0] = (fc_shapes)FC_TRIANGLES(vertices, triangles);
}

static void add_lamp(void) {
  scene.ambient.r = scene.ambient.g = scene.ambient.b = FC_ONE_Q15 / 4;
  lamp.intensity.r = lamp.intensity.g = lamp.intensity.b = FC_ONE_Q15 / 2;
  scene.lights = &lamp;
  scene.light_count = 1;
}

static void draw(int which, uint16_t strip) {
  uint16_t y;
  for (y = 0; y < HEIGHT; y = (uint16_t)(y + strip)) {
    uint16_t rows = (uint16_t)(HEIGHT - y < strip ? HEIGHT - y : strip);
    size_t first = (size_t)y * WIDTH;
    fc_target target;
    memset(&target, 0, sizeof target);
    target.pixels = pixels[which] + 3 * first;
    target.pitch_bytes = WIDTH * 3;
    target.format = FC_RGB888;
    target.depth = depth[which] + first;
    target.primitive = primitive[which] + first;
    target.lit = lit[which] + first;
    TEST_ASSERT_EQUAL_INT(FC_OK, which == 0 ? fc_render_rows(&frame, y, rows, &target)
                                            : fc_render_rows_by_rays(&frame, y, rows, &target));
  }
}

/* Without numbers and masks pixels take another way, to the same two bytes. */
static void check_plain(void) {
  static uint8_t plain[2 * PIXELS];
  static uint16_t plain_depth[PIXELS];
  fc_target target;
  int i;
  memset(&target, 0, sizeof target);
  target.pixels = plain;
  target.pitch_bytes = WIDTH * 2;
  target.format = FC_RGB565_BE;
  target.depth = plain_depth;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows(&frame, 0, HEIGHT, &target));
  target.pixels = pixels[1];
  target.depth = depth[1];
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows_by_rays(&frame, 0, HEIGHT, &target));
  for (i = 0; i < PIXELS; i++) {
    int off = ((plain[2 * i] << 8) | plain[2 * i + 1]) - ((pixels[1][2 * i] << 8) | pixels[1][2 * i + 1]);
    TEST_ASSERT_EQUAL_UINT16(depth[1][i], plain_depth[i]);
    if (scene.light_count == 0) TEST_ASSERT_EQUAL_INT(0, off);
  }
}

/* `colours`: within a level, too; not with a light so close to a surface that the picture cannot tell where it is. */
static void check(bool colours) {
  int i;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, NULL, WIDTH, HEIGHT, memory, sizeof memory));
  draw(0, (uint16_t)random_within(1, HEIGHT));
  draw(1, HEIGHT);
  for (i = 0; i < PIXELS; i++) {
    int j;
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(primitive[1][i], primitive[0][i], "primitive");
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(depth[1][i], depth[0][i], "depth");
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(lit[1][i], lit[0][i], "lit");
    if (colours)
      for (j = 0; j < 3; j++) TEST_ASSERT_INT_WITHIN(1, pixels[1][3 * i + j], pixels[0][3 * i + j]);
  }
  check_plain();
}

static void any_triangles(void) {
  int i, j;
  for (i = 0; i < TRIANGLES; i++) {
    for (j = 0; j < 3; j++) triangles[i].vertex[j] = (uint16_t)random_within(0, VERTICES - 1);
    triangles[i].material = (uint16_t)random_within(0, 2);
    triangles[i].object = (uint16_t)(i + 1);
  }
}

/* A vertex that is seen exactly at a pixel's centre, or at a corner between pixels. */
static fc_vec3 on_centre(int32_t most) {
  int32_t k = random_within(1, most), x = random_within(-WIDTH - 9, WIDTH + 9), y = random_within(-HEIGHT - 9, HEIGHT + 9);
  return at(x * k, y * k, -HEIGHT * k);
}

static void lamp_anywhere(int32_t most) {
  add_lamp();
  lamp.position = at(random_within(-most, most), random_within(-most, most), random_within(-most, most));
}

static void test_g1_edges_through_pixel_centres(void) {
  int trial, i;
  for (trial = 0; trial < 150 / PART; trial++) {
    reset();
    for (i = 0; i < VERTICES; i++) vertices[i] = on_centre(trial % 3 == 0 ? 1 : 40);
    any_triangles();
    shapes[0].cull = trial % 4 == 0;
    if (trial % 2 != 0) lamp_anywhere(2000);
    check(scene.light_count == 0);
  }
}

static void test_any_size_anywhere(void) {
  int trial, i;
  for (trial = 0; trial < 250 / PART; trial++) {
    reset();
    for (i = 0; i < VERTICES; i++)
      vertices[i] = at(random_any_size(29), random_any_size(29), random_any_size(29));
    any_triangles();
    shapes[0].cull = trial % 5 == 0;
    if (trial % 2 != 0) lamp_anywhere(INT32_C(1) << random_within(4, 29));
    check(scene.light_count == 0);
  }
}

/* Small ones in front of the eye: many a pixel. */
static void test_small_and_thin(void) {
  int trial, i;
  for (trial = 0; trial < 150 / PART; trial++) {
    int32_t size = INT32_C(1) << random_within(16, 22), depth_range = INT32_C(1) << random_within(4, 24);
    reset();
    for (i = 0; i < VERTICES; i++) {
      int32_t z = (INT32_C(1) << 24) + random_within(0, depth_range);
      vertices[i] = at(random_within(-size, size), random_within(-size, size) / (trial % 3 == 0 ? 64 : 1), -z);
    }
    any_triangles();
    if (trial % 2 != 0) lamp_anywhere(INT32_C(1) << 25);
    if (trial % 7 == 0) {
      scene.far_limit = (INT32_C(1) << 24) + depth_range / 2;
    }
    check(true);
  }
}

/* A ground that passes under the eye, and walls that stand in it. */
static void test_planes_that_pass_the_eye(void) {
  int trial, i;
  for (trial = 0; trial < 120 / PART; trial++) {
    reset();
    for (i = 0; i < VERTICES; i++) {
      int32_t reach = INT32_C(1) << random_within(8, 28);
      vertices[i] = at(random_within(-reach, reach), i < 8 ? -(INT32_C(1) << random_within(2, 20)) : random_within(-reach, reach),
                       random_within(-reach, reach));
    }
    any_triangles();
    if (trial % 2 != 0) lamp_anywhere(INT32_C(1) << random_within(10, 29));
    if (trial % 3 == 0) {
      ground.normal = at(random_within(-3, 3), 40, random_within(-3, 3));
      ground.d = random_within(1, 1 << 25);
      ground.material = 1;
      ground.object = 99;
      shapes[1].kind = &fc_kind_plane;
      shapes[1].items = &ground;
      shapes[1].count = 1;
      scene.shape_count = 2;
    }
    check(scene.light_count == 0);
  }
}

/* A box, closed: with its back faces left out it looks the same, light and shadows too. */
static void test_closed_meshes_look_the_same(void) {
  /* clang-format off */
  static const uint16_t faces[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                        {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  /* clang-format on */
  int trial, i, j;
  for (trial = 0; trial < 40 / PART; trial++) {
    int32_t skew = random_within(-9000, 9000);
    reset();
    memset(triangles, 0, sizeof triangles);
    for (i = 0; i < 8; i++)
      vertices[i] = at((i & 1 ? 30000 : -30000) + (i & 2 ? skew : 0), (i & 2 ? 25000 : -25000) + (i & 4 ? skew / 2 : 0),
                       -120000 + (i & 4 ? 28000 : -28000) + random_within(-200, 200));
    for (i = 0; i < 12; i++) {
      for (j = 0; j < 3; j++) triangles[i].vertex[j] = faces[i][j];
      triangles[i].material = (uint16_t)(i % 3);
      triangles[i].object = 1;
    }
    /* and a floor in a table of its own */
    vertices[8] = at(-400000, -60000, -400000);
    vertices[9] = at(400000, -60000, -400000);
    vertices[10] = at(0, -60000, 100000);
    triangles[12].vertex[0] = 8;
    triangles[12].vertex[1] = 9;
    triangles[12].vertex[2] = 10;
    triangles[13] = triangles[12];
    shapes[0].count = 12;
    shapes[1] = shapes[0];
    shapes[1].items = triangles + 12;
    shapes[1].count = 1;
    scene.shape_count = 2;
    add_lamp();
    lamp.position = at(random_within(-200000, 200000), random_within(30000, 300000), random_within(-200000, 100000));
    check(true);
    memcpy(primitive[1], primitive[0], sizeof primitive[0]);
    memcpy(lit[1], lit[0], sizeof lit[0]);
    shapes[0].cull = 1;
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, NULL, WIDTH, HEIGHT, memory, sizeof memory));
    draw(0, 8);
    TEST_ASSERT_EQUAL_MEMORY(primitive[1], primitive[0], sizeof primitive[0]);
    TEST_ASSERT_EQUAL_MEMORY(lit[1], lit[0], sizeof lit[0]);
    check(true);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g1_edges_through_pixel_centres);
  RUN_TEST(test_any_size_anywhere);
  RUN_TEST(test_small_and_thin);
  RUN_TEST(test_planes_that_pass_the_eye);
  RUN_TEST(test_closed_meshes_look_the_same);
  return UNITY_END();
}
