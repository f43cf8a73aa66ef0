/* Convex meshes that shadow by their outlines: what the ray engine says of each face, pixel by pixel, and the same as without. */
#include <stdbool.h>
#include <string.h>

#include "fixcast/fixcast.h"
#include "mesh.h"
#include "random.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  WIDTH = 40,
  HEIGHT = 32,
  PIXELS = WIDTH * HEIGHT,
  RING = 11,
  VERTICES = RING + 2,
  FACES = 2 * RING,
  MESHES = 2
};

/* Emulated chips take a part of the scenes: every kind of them, as the host has gone through all. */
#ifdef FIXCAST_BAREMETAL
enum {
  PART = 8
};
#else
enum {
  PART = 1
};
#endif

static fc_vec3 vertices[MESHES][VERTICES], floor_corners[3];
static fc_triangle faces[MESHES][FACES], floor_face[1];
static fc_plane ground;
static fc_light lamp;
static fc_material materials[3] = {FC_MATTE(FC_RGB8(200, 100, 50)), FC_MATTE(FC_RGB8(20, 220, 90)), FC_MATTE(FC_RGB8(90, 90, 250))};
static fc_shapes shapes[MESHES + 1];
static fc_scene scene;
static fc_camera camera;
static fc_frame frame;
static int64_t memory[512];
static uint8_t pixels[PIXELS * 3];
static uint16_t depth[PIXELS], primitive[3][PIXELS];
static uint32_t lit[3][PIXELS];

static fc_vec3 at(int32_t x, int32_t y, int32_t z) {
  fc_vec3 v;
  v.x = x;
  v.y = y;
  v.z = z;
  return v;
}

/* cos and sin of 2 pi k / 11, times 1000. */
/* clang-format off */
static const int16_t ring[RING][2] = {{1000, 0},    {841, 541},  {415, 910},   {-142, 990},  {-655, 756}, {-959, 282},
                                      {-959, -282}, {-655, -756}, {-142, -990}, {415, -910}, {841, -541}};
/* clang-format on */

/* Two pyramids on a ring, through a linear map of whole numbers; counter-clockwise seen from outside. False when the map turns space
 * inside out, or nearly flat. */
static bool make_mesh(int which, fc_vec3 center, const int32_t map[3][3]) {
  fc_vec3 *v = vertices[which];
  int i;
  int64_t turn = (int64_t)map[0][0] * ((int64_t)map[1][1] * map[2][2] - (int64_t)map[1][2] * map[2][1]) -
                 (int64_t)map[0][1] * ((int64_t)map[1][0] * map[2][2] - (int64_t)map[1][2] * map[2][0]) +
                 (int64_t)map[0][2] * ((int64_t)map[1][0] * map[2][1] - (int64_t)map[1][1] * map[2][0]);
  for (i = 0; i < VERTICES; i++) {
    int32_t p[3] = {0, 0, 0};
    if (i < RING) {
      p[0] = ring[i][0];
      p[1] = ring[i][1];
    } else {
      p[2] = i == RING ? 1000 : -1000;
    }
    v[i] = at(center.x + (map[0][0] * p[0] + map[0][1] * p[1] + map[0][2] * p[2]) / 1000,
              center.y + (map[1][0] * p[0] + map[1][1] * p[1] + map[1][2] * p[2]) / 1000,
              center.z + (map[2][0] * p[0] + map[2][1] * p[1] + map[2][2] * p[2]) / 1000);
  }
  for (i = 0; i < FACES; i++) {
    int a = i % RING, b = (i + 1) % RING;
    faces[which][i].vertex[0] = (uint16_t)(i < RING ? a : b);
    faces[which][i].vertex[1] = (uint16_t)(i < RING ? b : a);
    faces[which][i].vertex[2] = (uint16_t)(i < RING ? RING : RING + 1);
    faces[which][i].material = (uint16_t)(i % 3);
    faces[which][i].object = (uint16_t)(which + 1);
  }
  return turn > INT64_C(1000) * 1000 * 1000;
}

static int64_t dot(const int64_t a[3], const int64_t b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const int64_t a[3], const int64_t b[3], int64_t r[3]) {
  r[0] = a[1] * b[2] - a[2] * b[1];
  r[1] = a[2] * b[0] - a[0] * b[2];
  r[2] = a[0] * b[1] - a[1] * b[0];
}

static void between(const fc_vec3 *a, const fc_vec3 *b, int64_t r[3]) {
  r[0] = (int64_t)b->x - a->x;
  r[1] = (int64_t)b->y - a->y;
  r[2] = (int64_t)b->z - a->z;
}

static int64_t size(int64_t v) { return v < 0 ? -v : v; }

/* Whether the mesh has a margin of 1: edges of up to 2^14, normals 2^29, |n| from below by its longest axis. */
static bool has_margin(int which) {
  int f, i, j;
  for (f = 0; f < FACES; f++) {
    const fc_triangle *t = &faces[which][f];
    const fc_vec3 *a = &vertices[which][t->vertex[0]];
    int64_t ab[3], ac[3], n[3], length = 0, longest = 1;
    between(a, &vertices[which][t->vertex[1]], ab);
    between(a, &vertices[which][t->vertex[2]], ac);
    cross(ab, ac, n);
    for (j = 0; j < 3; j++) {
      if (size(n[j]) > length) length = size(n[j]);
      longest += size(ab[j]) + size(ac[j]);
    }
    if (length < 16 * longest) return false;
    for (i = 0; i < VERTICES; i++) {
      int64_t av[3], part[3], weights[2];
      if (i == t->vertex[0] || i == t->vertex[1] || i == t->vertex[2]) continue;
      between(a, &vertices[which][i], av);
      cross(av, ac, part);
      weights[0] = dot(part, n) / length; /* beta |n|, or more */
      cross(ab, av, part);
      weights[1] = dot(part, n) / length;
      /* distance -n.av / |n| against 1 + the sum, all times |n|, and |n| is below 2 `length` */
      if (-dot(n, av) < 2 * (4 * length + 2 * size(weights[0]) + 2 * size(weights[1]) + 4)) return false;
    }
  }
  return true;
}

static bool any_mesh(int which, fc_vec3 center) {
  int32_t map[3][3];
  int i, j;
  for (i = 0; i < 3; i++)
    for (j = 0; j < 3; j++) map[i][j] = random_within(-3000, 3000);
  return make_mesh(which, center, (const int32_t(*)[3])map) && has_margin(which);
}

static void reset(void) {
  memset(&scene, 0, sizeof scene);
  memset(&camera, 0, sizeof camera);
  memset(&lamp, 0, sizeof lamp);
  camera.target = at(0, 0, -1);
  camera.up = at(0, 1, 0);
  camera.tan_half_fov_numerator = camera.tan_half_fov_denominator = 1;
  scene.materials = materials;
  scene.material_count = FC_COUNT_OF(materials);
  scene.ambient.r = scene.ambient.g = scene.ambient.b = FC_ONE_Q15 / 4;
  lamp.intensity.r = lamp.intensity.g = lamp.intensity.b = FC_ONE_Q15 / 2;
  scene.lights = &lamp;
  scene.light_count = 1;
  scene.shapes = shapes;
}

static void add_mesh(int which) {
  shapes[scene.shape_count++] = (fc_shapes)FC_TRIANGLES_CONVEX(vertices[which], NULL, NULL, faces[which], 0);
}

static void add_floor(int32_t y, bool triangle) {
  if (triangle) {
    floor_corners[0] = at(-60000, y, 30000);
    floor_corners[1] = at(60000, y, 30000);
    floor_corners[2] = at(0, y, -90000);
    floor_face[0].vertex[0] = 0;
    floor_face[0].vertex[1] = 1;
    floor_face[0].vertex[2] = 2;
    floor_face[0].material = 1;
    floor_face[0].object = 99;
    shapes[scene.shape_count++] = (fc_shapes)FC_TRIANGLES(floor_corners, floor_face);
  } else {
    ground.normal = at(0, 1, 0);
    ground.d = -y;
    ground.material = 1;
    ground.object = 99;
    memset(&shapes[scene.shape_count], 0, sizeof shapes[0]);
    shapes[scene.shape_count].kind = &fc_kind_plane;
    shapes[scene.shape_count].items = &ground;
    shapes[scene.shape_count++].count = 1;
  }
}

static void draw(int which, uint16_t strip) {
  uint16_t y;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, NULL, WIDTH, HEIGHT, memory, sizeof memory));
  for (y = 0; y < HEIGHT; y = (uint16_t)(y + strip)) {
    uint16_t rows = (uint16_t)(HEIGHT - y < strip ? HEIGHT - y : strip);
    size_t first = (size_t)y * WIDTH;
    fc_target target;
    memset(&target, 0, sizeof target);
    target.pixels = pixels + 3 * first;
    target.pitch_bytes = WIDTH * 3;
    target.format = FC_RGB888;
    target.depth = depth + first;
    target.primitive = primitive[which] + first;
    target.lit = lit[which] + first;
    TEST_ASSERT_EQUAL_INT(FC_OK, which == 1 ? fc_render_rows_by_rays(&frame, y, rows, &target)
                                            : fc_render_rows(&frame, y, rows, &target));
  }
}

/* How many of the convex meshes that a scene begins with have an outline: none of their faces casts alone. */
static int outlines(void) {
  const unsigned char *place = frame.memory;
  int i, j, count = 0;
  for (i = 0; i < scene.shape_count && shapes[i].kind == &fc_kind_convex; i++) {
    const uint8_t *casts = fc_mesh_casts((const fc_placed_mesh *)(const void *)place, &shapes[i]);
    bool any = false;
    for (j = 0; j < shapes[i].count; j++) any = any || (casts[j / 8] >> (j % 8) & 1);
    count += !any;
    place += fc_kind_convex.memory(&shapes[i]);
  }
  return count;
}

static uint32_t dark; /* pixels in shadow so far */

/* The scan engine with outlines, the ray engine, and the scan engine without. Returns how many outlines there were. */
static int check(void) {
  int i, count;
  draw(0, (uint16_t)random_within(1, HEIGHT));
  count = outlines();
  draw(1, HEIGHT);
  for (i = 0; i < scene.shape_count; i++)
    if (shapes[i].kind == &fc_kind_convex) {
      shapes[i].kind = &fc_kind_triangle;
      shapes[i].cull = 1;
    }
  draw(2, 16);
  for (i = 0; i < PIXELS; i++) {
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(primitive[1][i], primitive[0][i], "primitive");
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(lit[1][i], lit[0][i], "lit");
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(primitive[2][i], primitive[0][i], "primitive without an outline");
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(lit[2][i], lit[0][i], "lit without an outline");
    dark += primitive[0][i] != UINT16_MAX && lit[0][i] == 0;
  }
  return count;
}

static int32_t lowest(int which) {
  int32_t y = INT32_MAX;
  int i;
  for (i = 0; i < VERTICES; i++)
    if (vertices[which][i].y < y) y = vertices[which][i].y;
  return y;
}

/* Two of them over, on and in a floor that is a plane or a triangle, lit from anywhere, from inside too. */
static void test_shadows_are_those_of_faces(void) {
  int trial, used = 0, trials = 0;
  dark = 0;
  for (trial = 0; trial < 240 / PART; trial++) {
    reset();
    if (!any_mesh(0, at(random_within(-4000, 4000), random_within(-2000, 2000), -14000)) ||
        !any_mesh(1, at(random_within(-8000, 8000), random_within(-3000, 6000), random_within(-26000, -13000))))
      continue;
    trials++;
    add_mesh(0);
    add_mesh(1);
    if (trial % 5 != 0) add_floor(lowest(0) - (trial % 5 == 1 ? 0 : trial % 5 == 2 ? 800
                                                                : trial % 5 == 3   ? -300
                                                                                   : 2),
                                  trial % 2 == 0);
    lamp.position = trial % 11 == 0 ? at(vertices[0][0].x / 2 + vertices[0][5].x / 2, vertices[0][0].y / 2 + vertices[0][5].y / 2,
                                         vertices[0][0].z / 2 + vertices[0][5].z / 2)
                                    : at(random_within(-20000, 20000), random_within(-2000, 30000), random_within(-30000, 5000));
    if (trial % 3 == 0) {
      camera.eye = at(random_within(-2000, 2000), random_within(0, 5000), random_within(0, 3000));
      camera.target = at(random_within(-2000, 2000), random_within(-3000, 3000), -14000);
      camera.up = at(random_within(-300, 300), 1000, random_within(-300, 300));
    }
    used += check() == 2;
  }
  TEST_ASSERT_GREATER_THAN_INT(24 / PART, trials);
  TEST_ASSERT_GREATER_THAN_INT(trials / 2, used);
  TEST_ASSERT_GREATER_THAN_UINT32(PART == 1 ? 3000 : 40, dark); /* few trials may happen to see few shadows */
}

/* The point at which a mesh stands on a floor is lit: nothing lies between. All around it is in the mesh's shadow. */
static void test_a_foot_is_not_in_its_own_shadow(void) {
  static const int32_t map[3][3] = {{3000, 0, 0}, {0, 0, 2000}, {0, -3000, 0}};
  int trial, seen = 0;
  for (trial = 0; trial < 40 / PART + 2; trial++) {
    int32_t k = random_within(200, 320), x = 2 * random_within(-12, 12) + 1, y = -2 * random_within(1, 5) - 1;
    int column = (x + WIDTH - 1) / 2, row = (HEIGHT - 1 - y) / 2;
    reset();
    add_floor(y * k, trial % 2 == 0);
    TEST_ASSERT_TRUE(make_mesh(0, at(x * k, y * k + 2000, -HEIGHT * k), map));
    TEST_ASSERT_TRUE(has_margin(0));
    add_mesh(0);
    lamp.position = at(x * k + random_within(-200, 200), y * k + 9000, -HEIGHT * k + random_within(-200, 200));
    (void)check();
    seen += primitive[0][row * WIDTH + column] == 0 && lit[0][row * WIDTH + column] == 1 &&
            lit[0][row * WIDTH + column + 1] == 0 && lit[0][row * WIDTH + column - 1] == 0;
  }
  TEST_ASSERT_GREATER_THAN_INT(0, seen);
}

/* A mesh that stands on an edge. */
static void test_an_edge_is_not_in_its_own_shadow(void) {
  static const int32_t map[3][3] = {{0, 3000, 0}, {3000, 0, 0}, {0, 0, -2000}};
  int trial, seen = 0;
  for (trial = 0; trial < 40 / PART + 2; trial++) {
    int32_t k = random_within(120, 320), x = 2 * random_within(-12, 12) + 1, y = -2 * random_within(1, 5) - 1;
    int column = (x + WIDTH - 1) / 2, row = (HEIGHT - 1 - y) / 2;
    reset();
    add_floor(y * k, trial % 2 == 0);
    TEST_ASSERT_TRUE(make_mesh(0, at(x * k, y * k + 959 * 3, -HEIGHT * k), map));
    TEST_ASSERT_TRUE(has_margin(0));
    TEST_ASSERT_EQUAL_INT(y * k, lowest(0));
    add_mesh(0);
    lamp.position = at(x * k + random_within(-200, 200), y * k + 9000, -HEIGHT * k + random_within(-200, 200));
    (void)check();
    seen += primitive[0][row * WIDTH + column] == 0 && lit[0][row * WIDTH + column] == 1 && lit[0][(row - 1) * WIDTH + column] == 0;
  }
  TEST_ASSERT_GREATER_THAN_INT(0, seen);
}

static void scale(fc_vec3 *v) {
  v->x *= INT32_C(1) << 13;
  v->y *= INT32_C(1) << 13;
  v->z *= INT32_C(1) << 13;
}

/* The shadow of a corner falls on the middle of a pixel. */
static void test_corners_that_shadow_a_pixels_centre(void) {
  const int32_t height = 6930; /* 2 * 5 * 7 * 9 * 11: middles of those rows are whole points of the floor */
  int trial, trials = 0;
  for (trial = 0; trial < 200 / PART; trial++) {
    const int32_t y = 2 * random_within(1, 5) + 1, k = height / y, x = 2 * random_within(-15, 15) + 1;
    const fc_vec3 *v = &vertices[0][random_within(0, VERTICES - 1)];
    reset();
    if (!any_mesh(0, at(random_within(-4000, 4000), random_within(-3000, 1000), -14000))) continue;
    if (lowest(0) < -height || v->y < -height / 2 + 100) continue;
    trials++;
    add_mesh(0);
    add_floor(-height, trial % 2 == 0);
    lamp.position = at(2 * v->x - x * k, 2 * v->y + height, 2 * v->z + HEIGHT * k);
    if (trial % 4 > 1) { /* or misses it by next to nothing */
      int i;
      for (i = 0; i < VERTICES; i++) scale(&vertices[0][i]);
      for (i = 0; i < 3 && trial % 2 == 0; i++) scale(&floor_corners[i]);
      scale(&lamp.position);
      if (trial % 2 != 0) ground.d *= INT32_C(1) << 13;
      lamp.position.x += random_within(-2, 2);
      lamp.position.y += random_within(-2, 2);
      lamp.position.z += random_within(-2, 2);
    }
    (void)check();
  }
  TEST_ASSERT_GREATER_THAN_INT(30 / PART, trials);
}

/* A grid too coarse for the margin, no margin at all, and what is not convex but says so, which may look wrong but does no harm. */
static void test_meshes_that_may_not_be_convex_cast_by_faces(void) {
  const int32_t far = INT32_C(3) << 28;
  int trial, i;
  for (trial = 0; trial < 30 / PART; trial++) {
    reset();
    if (!any_mesh(0, at(0, 0, -14000))) continue;
    add_mesh(0);
    add_floor(lowest(0) - 500, true);
    lamp.position = at(3000, 12000, -9000);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, NULL, WIDTH, HEIGHT, memory, sizeof memory));
    TEST_ASSERT_EQUAL_INT(1, outlines());
    shapes[0].cull = 1;
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, NULL, WIDTH, HEIGHT, memory, sizeof memory));
    TEST_ASSERT_EQUAL_INT(0, outlines());
    /* the eye and the floor's end three halves of 2^30 apart: a unit of the camera's grid is two of the world's */
    for (i = 0; i < VERTICES; i++) vertices[0][i].x -= far;
    lamp.position.x -= far;
    camera.eye.x -= far;
    camera.target.x -= far;
    floor_corners[1].x += far;
    shapes[0].cull = 3;
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, NULL, WIDTH, HEIGHT, memory, sizeof memory));
    TEST_ASSERT_EQUAL_INT(1, outlines());
    shapes[0].cull = 2;
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, NULL, WIDTH, HEIGHT, memory, sizeof memory));
    TEST_ASSERT_EQUAL_INT(0, outlines());
    camera.eye.x += far;
    camera.target.x += far;
    for (i = 0; i < VERTICES; i++) vertices[0][i] = at(random_within(-4000, 4000), random_within(-4000, 4000), random_within(-14000, -9000));
    lamp.position = at(random_within(-9000, 9000), 12000, random_within(-14000, 9000));
    draw(0, 16);
    for (i = 0; i < FACES * 3; i++) faces[0][i / 3].vertex[i % 3] = (uint16_t)random_within(0, VERTICES - 1);
    draw(0, 16);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_shadows_are_those_of_faces);
  RUN_TEST(test_a_foot_is_not_in_its_own_shadow);
  RUN_TEST(test_an_edge_is_not_in_its_own_shadow);
  RUN_TEST(test_corners_that_shadow_a_pixels_centre);
  RUN_TEST(test_meshes_that_may_not_be_convex_cast_by_faces);
  return UNITY_END();
}
