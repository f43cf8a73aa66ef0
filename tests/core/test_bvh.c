/* Hierarchies: what they promise about themselves, what is refused, and that no answer and no picture depends on one. */
#include <string.h>

#include "bvh.h"
#include "fixcast/fixcast.h"
#include "random.h"
#include "segment.h"
#include "space.h"
#include "unity.h"
#include "vectors.h"
#include "view.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  EACH = 40,
  SIZE = 12
};

static fc_sphere spheres[EACH];
static fc_plane planes[2];
static fc_vec3 vertices[EACH + 2];
static fc_triangle triangles[EACH];
static fc_light lights[2];
static fc_material materials[1];
static fc_shapes shapes[4];
static fc_scene scene, with; /* without and with */
static fc_bvh bvh;
static uint32_t memory[1400], again[1400];

/* ---- scenes ---- */

static int32_t within(int32_t low, int32_t high) { return random_within(low, high); }

static fc_vec3 any_point(int mode, fc_vec3 center, int32_t size) {
  fc_vec3 p = vec(center.x + within(-size, size), center.y + within(-size, size), center.z + within(-size, size));
  if (mode == 1) { /* on a coarse grid: borders coincide */
    int32_t step = size / 4 + 1;
    p = vec(center.x + within(-3, 3) * step, center.y + within(-3, 3) * step, center.z + within(-1, 1) * step);
  }
  if (mode == 2) p = center;     /* all the same */
  if (mode == 3) p.y = center.y; /* flat */
  return p;
}

/* Primitives of a size between 1 and 2^29 around a place anywhere. */
static void make_scene(int trial, fc_vec3 *center, int32_t *size) {
  int mode = trial % 5, i;
  uint8_t bits = (uint8_t)(1 + random_u64() % 28);
  uint16_t n;
  *size = (int32_t)(UINT32_C(1) << bits);
  *center = vec(random_any_size(28), random_any_size(28), random_any_size(28));
  if (trial % 7 == 0) *center = vec(0, 0, 0);
  n = (uint16_t)within(0, trial % 11 == 0 ? 3 : EACH);
  memset(&scene, 0, sizeof scene);
  memset(shapes, 0, sizeof shapes);
  memset(lights, 0, sizeof lights);
  for (i = 0; i < EACH; i++) {
    int32_t least = *size / 64 + 1;
    spheres[i].center = any_point(mode, *center, *size);
    spheres[i].radius = within(least, least * 8);
    if (mode == 1) spheres[i].radius = *size / 4 + 1;
    if (trial % 13 == 0) spheres[i].radius = FC_COORDINATE_MAX;
    spheres[i].material = 0;
    spheres[i].object = (uint16_t)i;
    triangles[i].vertex[0] = (uint16_t)i;
    triangles[i].vertex[1] = (uint16_t)(i + 1);
    triangles[i].vertex[2] = (uint16_t)(i + (trial % 3 == 0 ? 1 : 2)); /* some without area */
    triangles[i].material = 0;
    triangles[i].object = (uint16_t)i;
  }
  for (i = 0; i < EACH + 2; i++) {
    vertices[i] = any_point(mode, *center, *size);
    if (mode == 4 && i % 4 != 0) vertices[i] = vec(vertices[i - 1].x + *size / 16, vertices[i - 1].y, vertices[i - 1].z + 1);
  }
  for (i = 0; i < 2; i++) {
    planes[i].normal = vec(random_any_size(20), random_any_size(20), 1 + within(0, 1000));
    planes[i].d = random_any_size(29);
    lights[i].position = any_point(0, *center, *size);
    lights[i].exponent = (int8_t)(i == 0 ? 0 : within(0, 32));
    lights[i].intensity.r = lights[i].intensity.g = lights[i].intensity.b = 30000;
  }
  materials[0].diffuse.r = materials[0].diffuse.g = materials[0].diffuse.b = 30000;
  shapes[0].kind = &fc_kind_triangle;
  shapes[0].items = triangles;
  shapes[0].vertices = vertices;
  shapes[0].vertex_count = EACH + 2;
  shapes[0].count = (uint16_t)(n / 3);
  shapes[0].cull = trial % 4 == 1; /* not closed, but it is a sieve too */
  shapes[1].kind = &fc_kind_plane;
  shapes[1].items = planes;
  shapes[1].count = (uint16_t)(trial % 3);
  shapes[2].kind = &fc_kind_sphere;
  shapes[2].items = spheres;
  shapes[2].count = (uint16_t)(trial & 1 ? n : n / 2);
  shapes[3] = shapes[0];
  shapes[3].items = triangles + n / 3;
  shapes[3].count = (uint16_t)(n - n / 3);
  scene.shapes = shapes;
  scene.shape_count = 4;
  scene.materials = materials;
  scene.material_count = 1;
  scene.lights = lights;
  scene.light_count = (uint16_t)(1 + (trial >> 2 & 1));
}

static void build(void) {
  int error = 1;
  size_t bytes = fc_bvh_memory(&scene, &error);
  TEST_ASSERT_EQUAL_INT(FC_OK, error);
  TEST_ASSERT_TRUE(bytes <= sizeof memory);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_bvh_build(&bvh, &scene, memory, bytes));
  with = scene;
  with.bvh = &bvh;
}

#ifdef FIXCAST_BAREMETAL
enum {
  SCENES = 30,
  RAYS = 10,
  FRAMES = 20,
  DAMAGES = 200
};
#else
enum {
  SCENES = 1500,
  RAYS = 60,
  FRAMES = 1000,
  DAMAGES = 10000
};
#endif

/* ---- structure ---- */

static void test_built_ones_pass_the_check_and_are_the_same_again(void) {
  int trial;
  for (trial = 0; trial < SCENES; trial++) {
    fc_vec3 center;
    int32_t size;
    fc_bvh other;
    make_scene(trial, &center, &size);
    build();
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_scene_check(&with));
    TEST_ASSERT_EQUAL_UINT16(shapes[0].count + shapes[2].count + shapes[3].count, bvh.count);
    TEST_ASSERT_TRUE(fc_bvh_bytes(&bvh) <= fc_bvh_memory(&scene, NULL));
    memset(again, 0xa5, sizeof again);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_bvh_build(&other, &with, again, sizeof again));
    if (bvh.count > 0) TEST_ASSERT_EQUAL_MEMORY(memory, again, fc_bvh_bytes(&bvh));
  }
}

static void test_no_primitive_one_and_many_alike(void) {
  fc_vec3 center;
  int32_t size;
  fc_ray ray;
  fc_hit hit;
  make_scene(0, &center, &size);
  shapes[0].count = shapes[1].count = shapes[2].count = shapes[3].count = 0;
  TEST_ASSERT_EQUAL_UINT32(0, fc_bvh_memory(&scene, NULL));
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_bvh_build(&bvh, &scene, NULL, 0));
  with = scene;
  with.bvh = &bvh;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_scene_check(&with));
  memset(&ray, 0, sizeof ray);
  ray.origin = vec(0, 0, -100);
  ray.direction = vec(0, 0, 1);
  ray.t_max_q32 = UINT64_MAX;
  TEST_ASSERT_EQUAL_INT(0, fc_intersect(&with, &ray, &hit));
  shapes[2].count = 1;
  spheres[0].center = vec(0, 0, 0);
  spheres[0].radius = 1;
  build();
  TEST_ASSERT_EQUAL_UINT8(0, bvh.depth);
  TEST_ASSERT_EQUAL_INT(1, fc_intersect(&with, &ray, &hit));
  shapes[2].count = EACH;
  for (size = 1; size < EACH; size++) spheres[size] = spheres[0];
  build();
  TEST_ASSERT_EQUAL_INT(1, fc_intersect(&with, &ray, &hit));
  TEST_ASSERT_EQUAL_UINT16(0, hit.primitive); /* the lowest number, whatever the order */
}

static void test_bad_arguments_are_refused(void) {
  fc_vec3 center;
  int32_t size;
  int error = FC_OK;
  make_scene(1, &center, &size);
  shapes[2].count = EACH;
  TEST_ASSERT_EQUAL_UINT32(0, fc_bvh_memory(NULL, &error));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, error);
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_bvh_build(NULL, &scene, memory, sizeof memory));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_bvh_build(&bvh, NULL, memory, sizeof memory));
  TEST_ASSERT_EQUAL_INT(FC_ERR_MEMORY, fc_bvh_build(&bvh, &scene, NULL, sizeof memory));
  TEST_ASSERT_EQUAL_INT(FC_ERR_MEMORY, fc_bvh_build(&bvh, &scene, memory, fc_bvh_memory(&scene, NULL) - 1));
  spheres[3].radius = 0;
  TEST_ASSERT_EQUAL_INT(FC_ERR_RADIUS, fc_bvh_build(&bvh, &scene, memory, sizeof memory));
  spheres[3].radius = 1;
  build();
  bvh.kind = NULL;
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_scene_check(&with));
  build();
  bvh.order = NULL;
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_scene_check(&with));
  build();
  bvh.nodes = NULL;
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_scene_check(&with));
}

/* ---- damage ---- */

static void expect_refused(const char *what) { TEST_ASSERT_EQUAL_INT_MESSAGE(FC_ERR_BVH, fc_scene_check(&with), what); }

static void test_each_damage_is_refused(void) {
  fc_vec3 center;
  int32_t size;
  uint16_t *order;
  fc_bvh_node *nodes;
  make_scene(5, &center, &size); /* scattered, not flat */
  shapes[0].count = shapes[3].count = 0;
  shapes[2].count = EACH;
  build();
  nodes = (fc_bvh_node *)memory;
  order = (uint16_t *)(nodes + 2 * ((size_t)1 << bvh.depth) - 1);
  order[3] = order[9];
  expect_refused("twice");
  build();
  order[3] = 0xffff;
  expect_refused("no such primitive");
  build();
  order[3] = EACH + 2;
  expect_refused("just past the last");
  build();
  bvh.count--;
  expect_refused("one left out");
  build();
  bvh.count++;
  expect_refused("one too many");
  build();
  bvh.depth++;
  expect_refused("too deep");
  build();
  bvh.depth = 16;
  expect_refused("far too deep");
  build();
  bvh.depth = 255;
  expect_refused("depth");
  build();
  bvh.shift = 18;
  expect_refused("shift");
  build();
  bvh.origin.x++;
  expect_refused("moved");
  build();
  nodes[0].axis[1]++;
  expect_refused("root too high from below");
  build();
  nodes[0].axis[2] -= UINT32_C(1) << 16;
  expect_refused("root too low from above");
  build();
  nodes[(size_t)1 << bvh.depth].axis[0] += 1;
  expect_refused("leaf does not hold its primitives");
  build();
  nodes[1].axis[0] -= UINT32_C(1) << 16;
  expect_refused("node does not hold its children");
  build();
  shapes[1].count = shapes[1].count == 0 ? 1 : 0; /* numbers shift */
  expect_refused("made for another scene");
}

/* Rays, and what they say with and without. */
static void compare_rays(fc_vec3 center, int32_t size, int rays) {
  while (rays-- > 0) {
    fc_ray ray;
    fc_hit a, b;
    fc_vec3 to;
    int how = (int)(random_u64() % 8), hit;
    ray.t_min_q32 = random_u64() % 4 == 0 ? random_u64() >> (random_u64() % 40) : 0;
    ray.t_max_q32 = random_u64() % 4 == 0 ? random_u64() >> (random_u64() % 40) : UINT64_MAX;
    ray.origin = any_point(0, center, size * 2);
    to = any_point(0, center, size);
    if (how == 0) ray.origin = vec(random_any_size(30), random_any_size(30), random_any_size(30));
    if (how == 1 || how == 2) { /* in the plane of a box's side, often of several */
      ray.origin.x = spheres[0].center.x - (how == 1 ? spheres[0].radius : 0);
      if (ray.origin.x < -FC_COORDINATE_MAX) ray.origin.x = -FC_COORDINATE_MAX;
      to.x = ray.origin.x;
      if (how == 2) to.y = ray.origin.y = vertices[0].y;
    }
    if (how == 3) to = vertices[within(0, EACH)]; /* through corners */
    if (how == 4) {                               /* beside a sphere, within a unit */
      to = spheres[within(0, EACH - 1)].center;
      ray.origin = to;
      ray.origin.z = center.z - size;
      if (spheres[0].radius < FC_COORDINATE_MAX / 4) {
        to.x += spheres[0].radius + within(-1, 1);
        ray.origin.x = to.x;
      }
    }
    if (how == 5) ray.origin = spheres[0].center; /* from inside */
    ray.direction = vec((to.x - ray.origin.x) / 2, (to.y - ray.origin.y) / 2, (to.z - ray.origin.z) / 2);
    if (how == 6) ray.direction = vec(within(-1, 1), within(-1, 1), within(-1, 1));
    if ((ray.direction.x | ray.direction.y | ray.direction.z) == 0) ray.direction.y = 1;
    memset(&a, 0, sizeof a);
    memset(&b, 0, sizeof b);
    hit = fc_intersect(&scene, &ray, &a);
    TEST_ASSERT_EQUAL_INT(hit, fc_intersect(&with, &ray, &b));
    TEST_ASSERT_EQUAL_MEMORY(&a, &b, sizeof a);
    TEST_ASSERT_EQUAL_INT(fc_blocked(&scene, &ray.origin, &to), fc_blocked(&with, &ray.origin, &to));
  }
}

static void test_g13_rays_and_segments_are_answered_alike(void) {
  int trial;
  for (trial = 0; trial < SCENES; trial++) {
    fc_vec3 center;
    int32_t size;
    make_scene(trial, &center, &size);
    build();
    compare_rays(center, size, RAYS);
  }
}

/* One bit wrong anywhere: refused, or harmless. */
static void test_g13_damaged_ones_are_refused_or_harmless(void) {
  int trial, refused = 0;
  fc_vec3 center = vec(0, 0, 0);
  int32_t size = 1;
  for (trial = 0; trial < DAMAGES; trial++) {
    size_t bytes;
    int error;
    if (trial % 50 == 0) make_scene(trial / 50 * 3 + 1, &center, &size);
    build();
    if (bvh.count == 0) continue;
    bytes = fc_bvh_bytes(&bvh);
    ((unsigned char *)memory)[random_u64() % bytes] ^= (unsigned char)(1u << random_u64() % 8);
    error = fc_scene_check(&with);
    if (error != FC_OK) {
      TEST_ASSERT_EQUAL_INT(FC_ERR_BVH, error);
      refused++;
      continue;
    }
    compare_rays(center, size, 2);
  }
  TEST_ASSERT_GREATER_THAN_INT(DAMAGES / 4, refused);
}

/* ---- frames ---- */

static int64_t frame_memory[4096];

typedef struct picture {
  uint8_t pixels[SIZE * SIZE * 3];
  uint16_t depth[SIZE * SIZE], primitive[SIZE * SIZE];
  uint32_t lit[SIZE * SIZE];
} picture;

static picture pictures[4];

static int draw(const fc_scene *of, const fc_camera *camera, uint8_t rule, int by_rays, picture *p) {
  fc_frame frame;
  fc_options options;
  fc_target target;
  int error;
  memset(&options, 0, sizeof options);
  options.offset_rule = rule;
  options.epsilon = 10;
  memset(p, 0, sizeof *p);
  error = fc_frame_setup(&frame, of, camera, &options, SIZE, SIZE, frame_memory, sizeof frame_memory);
  if (error != FC_OK) return error;
  target.pixels = p->pixels;
  target.pitch_bytes = SIZE * 3;
  target.format = FC_RGB888;
  target.depth = p->depth;
  target.primitive = p->primitive;
  target.lit = p->lit;
  return by_rays ? fc_render_rows_by_rays(&frame, 0, SIZE, &target) : fc_render_rows(&frame, 0, SIZE, &target);
}

static void test_g13_pictures_are_the_same(void) {
  int trial, shown = 0;
  for (trial = 0; trial < FRAMES; trial++) {
    fc_vec3 center;
    fc_camera camera;
    int32_t size, away;
    int error, i;
    uint8_t rule = (uint8_t)(trial % 16 == 0 ? trial / 16 % 4 : 0);
    make_scene(trial, &center, &size);
    build();
    memset(&camera, 0, sizeof camera);
    /* at the scene's edge, or so far away that its cells are finer than the camera's grid */
    away = trial & 1 ? (int32_t)(UINT32_C(1) << 28) : 2 * size;
    if (away < size) away = size;
    camera.target = center;
    camera.eye = any_point(0, center, size);
    if (trial & 2)
      camera.eye.x += camera.eye.x > 0 ? -away : away;
    else
      camera.eye.z += camera.eye.z > 0 ? -away : away;
    if (trial % 32 == 5) {
      camera.exponent = (int8_t)within(-20, 12);
      camera.target = vec(0, 0, 0);
    }
    camera.up = vec(within(-9, 9), 10, within(-9, 9));
    camera.tan_half_fov_numerator = (uint32_t)size;
    camera.tan_half_fov_denominator = (uint32_t)away;
    while (camera.tan_half_fov_denominator >> 15 > camera.tan_half_fov_numerator) camera.tan_half_fov_denominator >>= 1;
    error = draw(&scene, &camera, rule, 1, &pictures[0]);
    TEST_ASSERT_EQUAL_INT(error, draw(&with, &camera, rule, 1, &pictures[1]));
    if (error != FC_OK) continue;
    TEST_ASSERT_EQUAL_MEMORY(&pictures[0], &pictures[1], sizeof pictures[0]);
    TEST_ASSERT_EQUAL_INT(FC_OK, draw(&scene, &camera, rule, 0, &pictures[2]));
    TEST_ASSERT_EQUAL_INT(FC_OK, draw(&with, &camera, rule, 0, &pictures[3]));
    TEST_ASSERT_EQUAL_MEMORY(&pictures[2], &pictures[3], sizeof pictures[2]);
    for (i = 0; i < SIZE * SIZE; i++) shown += pictures[0].depth[i] != 0;
  }
  TEST_ASSERT_GREATER_THAN_INT(FRAMES * 10, shown);
}

/* Seen from so far away that a unit of the camera's grid is many cells, each rounding of a placed vertex or radius takes it
 * out of its box: only the margin of the search still finds it. */
static void test_g13_placed_primitives_are_found_outside_their_boxes(void) {
  int trial, blocked = 0, hits = 0;
  for (trial = 0; trial < SCENES; trial++) {
    fc_vec3 center;
    fc_camera camera;
    fc_frame frame;
    fc_space all, sieved;
    int32_t size;
    int i, j, units = within(1, 12), exponent = within(4, 14);
    make_scene(trial, &center, &size);
    memset(&camera, 0, sizeof camera);
    camera.exponent = (int8_t)exponent;
    camera.eye = vec(within(-FC_COORDINATE_MAX, FC_COORDINATE_MAX), within(-FC_COORDINATE_MAX, FC_COORDINATE_MAX), FC_COORDINATE_MAX);
    camera.up = vec(within(-9, 9), 10, within(-9, 9));
    camera.tan_half_fov_numerator = camera.tan_half_fov_denominator = 1;
    shapes[1].count = 0;
    size = (int32_t)((UINT32_C(1) << exponent) * (uint32_t)units);
    for (i = 0; i < EACH + 2; i++) vertices[i] = any_point(0, vec(0, 0, 0), size);
    for (i = 0; i < EACH; i++) {
      spheres[i].center = any_point(0, vec(0, 0, 0), size);
      spheres[i].radius = within(1, size);
    }
    build();
    if (fc_frame_setup(&frame, &with, &camera, NULL, SIZE, SIZE, frame_memory, sizeof frame_memory) != FC_OK) continue;
    sieved = all = fc_space_of_frame(&frame);
    all.scene = &scene;
    for (i = 0; i < RAYS; i++) {
      int64_t from[3], to[3], middle[3];
      fc_segment segment;
      bool expected;
      uint16_t nearest;
      fc_vec3 around = vec(0, 0, 0);
      (void)fc_view_point(&frame.view, &around, 0, middle);
      memset(&segment, 0, sizeof segment);
      for (j = 0; j < 3; j++) {
        int64_t off = within(-2 * units - 3, 2 * units + 3), along = i % 4 == j ? within(20, 2000) : (int64_t)(random_u64() % 2);
        from[j] = middle[j] + off - along;
        to[j] = middle[j] + off + along;
        segment.light[j] = from[j];
        segment.point[j] = to[j];
        to[j] -= from[j];
      }
      fc_segment_prepare(&segment);
      expected = fc_space_blocked(&all, &segment, 0xffff);
      blocked += expected;
      TEST_ASSERT_EQUAL_INT(expected, fc_space_blocked(&sieved, &segment, 0xffff));
      if ((to[0] | to[1] | to[2]) == 0) continue;
      nearest = fc_space_nearest(&all, from, to, 0, UINT64_MAX, NULL);
      hits += nearest != 0xffff;
      TEST_ASSERT_EQUAL_UINT16(nearest, fc_space_nearest(&sieved, from, to, 0, UINT64_MAX, NULL));
    }
  }
  TEST_ASSERT_GREATER_THAN_INT(SCENES * RAYS / 40, blocked);
  TEST_ASSERT_GREATER_THAN_INT(SCENES * RAYS / 40, hits);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_built_ones_pass_the_check_and_are_the_same_again);
  RUN_TEST(test_no_primitive_one_and_many_alike);
  RUN_TEST(test_bad_arguments_are_refused);
  RUN_TEST(test_each_damage_is_refused);
  RUN_TEST(test_g13_rays_and_segments_are_answered_alike);
  RUN_TEST(test_g13_damaged_ones_are_refused_or_harmless);
  RUN_TEST(test_g13_pictures_are_the_same);
  RUN_TEST(test_g13_placed_primitives_are_found_outside_their_boxes);
  return UNITY_END();
}
