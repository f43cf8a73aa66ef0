/* The ray engine over several kinds at once: planes, nearest across kinds, offsets, bad arguments. */
#include "fixcast/ray.h"

#include <string.h>

#include "fixcast/error.h"
#include "random.h"
#include "root.h"
#include "unity.h"
#include "vectors.h"

void setUp(void) {}
void tearDown(void) {}

static const fc_material materials[] = {FC_MATTE(FC_WHITE)};
static fc_sphere spheres[2];
static fc_plane planes[2];
static fc_vec3 vertices[3];
static const fc_triangle triangles[1] = {{{0, 1, 2}, 0, 5}};
static fc_shapes shapes[3];
static fc_scene scene;

static void add_table(const fc_kind *kind, const void *items, uint16_t count) {
  fc_shapes *s = &shapes[scene.shape_count++];
  s->kind = kind;
  s->items = items;
  s->count = count;
  s->vertices = vertices;
  s->vertex_count = 3;
}

static void clear(void) {
  memset(&scene, 0, sizeof scene);
  memset(spheres, 0, sizeof spheres);
  memset(planes, 0, sizeof planes);
  scene.shapes = shapes;
  scene.materials = materials;
  scene.material_count = 1;
}

static int shoot(fc_vec3 o, fc_vec3 d, fc_hit *hit) {
  fc_ray ray;
  ray.origin = o;
  ray.direction = d;
  ray.t_min_q32 = 0;
  ray.t_max_q32 = UINT64_MAX;
  return fc_intersect(&scene, &ray, hit);
}

/* Family 27. */
static void test_planes(void) {
  fc_hit hit;
  clear();
  planes[0].normal = vec(0, 1, 0);
  planes[0].d = -1000;
  planes[1].normal = vec(0, -5, 0);
  planes[1].d = 5005; /* y = 1001 */
  add_table(&fc_kind_plane, planes, 2);
  TEST_ASSERT_EQUAL_INT(1, shoot(vec(7, 0, 7), vec(1 << 20, 1, 0), &hit));
  TEST_ASSERT_EQUAL_UINT16(0, hit.primitive);
  TEST_ASSERT_EQUAL_INT32(1000, hit.position.y);
  TEST_ASSERT_EQUAL_INT32((1000 << 20) + 7, hit.position.x);
  TEST_ASSERT_EQUAL_INT32(-(1 << 30), hit.normal_q30.y);
  TEST_ASSERT_EQUAL_INT(1, shoot(vec(0, 2000, 0), vec(0, -1, 0), &hit));
  TEST_ASSERT_EQUAL_UINT16(1, hit.primitive);
  TEST_ASSERT_EQUAL_INT32(1 << 30, hit.normal_q30.y);
  TEST_ASSERT_EQUAL_INT(0, shoot(vec(0, 0, 0), vec(1, 0, 1), &hit)); /* parallel */
  TEST_ASSERT_EQUAL_INT(0, shoot(vec(0, 1002, 0), vec(1, 0, 1), &hit));
  planes[0].d = -FC_COORDINATE_MAX;
  planes[0].d_exponent = 2;
  TEST_ASSERT_EQUAL_INT(1, shoot(vec(0, 2000, 0), vec(-7, 1, 0), &hit)); /* t just below 2^32, beyond all coordinates */
  TEST_ASSERT_EQUAL_UINT64((((uint64_t)FC_COORDINATE_MAX << 2) - 2000) << 32, hit.t_q32);
  TEST_ASSERT_EQUAL_INT32(-FC_COORDINATE_MAX, hit.position.x);
  TEST_ASSERT_EQUAL_INT32(FC_COORDINATE_MAX, hit.position.y);
  TEST_ASSERT_EQUAL_INT32(0, hit.position.z);
  planes[0].d = -1000;
  planes[0].d_exponent = 0;
  TEST_ASSERT_EQUAL_INT(1, shoot(vec(0, 1000, 0), vec(0, 1, 0), &hit)); /* starts in the first */
  TEST_ASSERT_EQUAL_UINT16(1, hit.primitive);
}

/* Sphere, plane and triangle touching at one point: the lowest number wins; one unit decides otherwise. */
static void test_nearest_across_kinds(void) {
  fc_hit hit;
  int32_t k;
  for (k = -1; k <= 1; k++) {
    clear();
    spheres[0].center = vec(0, 0, 2000 + k);
    spheres[0].radius = 1000;
    planes[0].normal = vec(0, 0, 77);
    planes[0].d = -77 * 1000;
    vertices[0] = vec(-10, -10, 1000);
    vertices[1] = vec(30, -10, 1000);
    vertices[2] = vec(-10, 30, 1000);
    add_table(&fc_kind_triangle, triangles, 1);
    add_table(&fc_kind_sphere, spheres, 1);
    add_table(&fc_kind_plane, planes, 1);
    TEST_ASSERT_EQUAL_INT(1, shoot(vec(0, 0, 0), vec(0, 0, 3), &hit));
    TEST_ASSERT_EQUAL_UINT16(k < 0 ? 1 : 0, hit.primitive);
    scene.shape_count = 0;
    add_table(&fc_kind_plane, planes, 1);
    add_table(&fc_kind_sphere, spheres, 1);
    TEST_ASSERT_EQUAL_INT(1, shoot(vec(0, 0, 0), vec(0, 0, 3), &hit));
    TEST_ASSERT_EQUAL_UINT16(k < 0 ? 1 : 0, hit.primitive);
  }
}

/* Two spheres whose near points on the ray differ by far less than any value holds: sqrt(d) against sqrt(d'). */
static void test_g2_nearest_of_two_irrational_roots(void) {
  fc_hit hit;
  int32_t i;
  for (i = 1; i < 200; i++) {
    int32_t r = (1 << 28) - 3 * i, x = (1 << 20) + i;
    clear();
    spheres[0].center = vec(x, 0, 1 << 29);
    spheres[1].center = vec(-x, 0, 1 << 29); /* mirrored: the same root exactly */
    spheres[0].radius = spheres[1].radius = r;
    add_table(&fc_kind_sphere, spheres, 2);
    TEST_ASSERT_EQUAL_INT(1, shoot(vec(0, 0, 0), vec(0, 0, 1 << 29), &hit));
    TEST_ASSERT_EQUAL_UINT16(0, hit.primitive);
    /* x^2 + 1 against x^2: the roots differ by about 2^-30 of a unit */
    spheres[1].center = vec(-x, 0, 1 << 29);
    spheres[0].center = vec(x, 1, 1 << 29);
    TEST_ASSERT_EQUAL_INT(1, shoot(vec(0, 0, 0), vec(0, 0, 1 << 29), &hit));
    TEST_ASSERT_EQUAL_UINT16(1, hit.primitive);
  }
}

/* After the residual step a point is strictly on the ray's side, at most sqrt(3) units up. */
static void test_residual_offset_leaves_the_surface(void) {
  int trial, hits = 0;
  for (trial = 0; trial < 2000; trial++) {
    fc_hit hit;
    fc_vec3 p, o = vec(random_any_size(26), random_any_size(26), random_any_size(26));
    int64_t x, y, z, c;
    clear();
    spheres[0].center = vec(random_any_size(26), random_any_size(26), random_any_size(26));
    spheres[0].radius = random_within(50, 1 << 26);
    add_table(&fc_kind_sphere, spheres, 1);
    if (shoot(o, vec((spheres[0].center.x - o.x) / 2 + 9, (spheres[0].center.y - o.y) / 2 + 5, (spheres[0].center.z - o.z) / 2 + 1),
              &hit) != 1)
      continue;
    hits++;
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_offset(&scene, &hit, FC_OFFSET_RESIDUAL, 0, &p));
    x = p.x - spheres[0].center.x;
    y = p.y - spheres[0].center.y;
    z = p.z - spheres[0].center.z;
    c = x * x + y * y + z * z - (int64_t)spheres[0].radius * spheres[0].radius;
    TEST_ASSERT_TRUE(hit.inside ? c < 0 : c > 0);
    TEST_ASSERT_TRUE((c < 0 ? -c : c) <= 4 * (int64_t)spheres[0].radius + 4); /* 2 r sqrt 3 + 3 */
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_offset(&scene, &hit, FC_OFFSET_EPSILON, 1000, &p));
    x = p.x - hit.position.x;
    y = p.y - hit.position.y;
    z = p.z - hit.position.z;
    TEST_ASSERT_INT64_WITHIN(4000, 1000000, x * x + y * y + z * z);
    TEST_ASSERT_TRUE(x * hit.normal_q30.x + y * hit.normal_q30.y + z * hit.normal_q30.z > 0);
  }
  TEST_ASSERT_GREATER_THAN_INT(1000, hits);
}

/* The same for planes and triangles, from both sides. */
static void test_residual_offset_leaves_flat_surfaces(void) {
  int trial, hits = 0;
  for (trial = 0; trial < 2000; trial++) {
    fc_hit hit;
    fc_vec3 p, d, o = vec(random_any_size(20), random_any_size(20), random_any_size(20));
    int64_t n[3], k, side_of_origin, side;
    int i;
    clear();
    if (trial & 1) {
      for (i = 0; i < 3; i++) vertices[i] = vec(random_any_size(20), random_any_size(20), random_any_size(20));
      add_table(&fc_kind_triangle, triangles, 1);
      d = vec((vertices[0].x + vertices[1].x + vertices[2].x) / 3 - o.x, (vertices[0].y + vertices[1].y + vertices[2].y) / 3 - o.y,
              (vertices[0].z + vertices[1].z + vertices[2].z) / 3 - o.z);
    } else {
      planes[0].normal = vec(random_any_size(20) | 1, random_any_size(20), random_any_size(20));
      planes[0].d = random_any_size(29);
      add_table(&fc_kind_plane, planes, 1);
      d = vec(random_any_size(20), random_any_size(20), random_any_size(20) | 1);
    }
    if ((d.x | d.y | d.z) == 0 || shoot(o, d, &hit) != 1) continue;
    if (hit.position.x > (1 << 28) || hit.position.x < -(1 << 28) || hit.position.y > (1 << 28) ||
        hit.position.y < -(1 << 28) || hit.position.z > (1 << 28) || hit.position.z < -(1 << 28))
      continue; /* clamped, perhaps */
    hits++;
    if (trial & 1) {
      int64_t ax = vertices[1].x - vertices[0].x, ay = vertices[1].y - vertices[0].y, az = vertices[1].z - vertices[0].z;
      int64_t bx = vertices[2].x - vertices[0].x, by = vertices[2].y - vertices[0].y, bz = vertices[2].z - vertices[0].z;
      n[0] = ay * bz - az * by;
      n[1] = az * bx - ax * bz;
      n[2] = ax * by - ay * bx;
      k = 0;
    } else {
      n[0] = planes[0].normal.x;
      n[1] = planes[0].normal.y;
      n[2] = planes[0].normal.z;
      k = -(int64_t)planes[0].d;
    }
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_offset(&scene, &hit, FC_OFFSET_RESIDUAL, 0, &p));
    if (trial & 1) { /* relative to a vertex: 22 bits times 43 */
      side_of_origin = n[0] / 4 * (o.x - vertices[0].x) + n[1] / 4 * (o.y - vertices[0].y) + n[2] / 4 * (o.z - vertices[0].z);
      if (side_of_origin < INT64_C(1) << 30 && side_of_origin > -(INT64_C(1) << 30)) continue; /* n / 4 is too coarse */
      side = n[0] * (p.x - vertices[0].x) + n[1] * (p.y - vertices[0].y) + n[2] * (p.z - vertices[0].z);
    } else {
      side_of_origin = n[0] * o.x + n[1] * o.y + n[2] * o.z - k;
      side = n[0] * p.x + n[1] * p.y + n[2] * p.z - k;
    }
    TEST_ASSERT_TRUE(side_of_origin > 0 ? side > 0 : side < 0);
  }
  TEST_ASSERT_GREATER_THAN_INT(800, hits);
}

/* A rational root in disguise, (10 - sqrt 16) / 2 = 3, times a direction of length 2, against a far limit of 6. */
static void test_g2_far_limit_is_exact_for_spheres(void) {
  fc_root root;
  memset(&root, 0, sizeof root);
  root.p = fc_i128_from(10);
  root.q = -1;
  root.d = fc_i128_from(16);
  root.m = fc_i128_from(2);
  root.c = fc_i128_from(42); /* (100 - 16) / 2 */
  TEST_ASSERT_EQUAL_INT8(0, fc_root_compare_distance(&root, 4, 6, 0));
  TEST_ASSERT_EQUAL_INT8(0, fc_root_compare_distance(&root, 4, 3, 1));
  TEST_ASSERT_EQUAL_INT8(0, fc_root_compare_distance(&root, 4, 12, -1));
  TEST_ASSERT_EQUAL_INT8(1, fc_root_compare_distance(&root, 4, 5, 0));
  TEST_ASSERT_EQUAL_INT8(-1, fc_root_compare_distance(&root, 4, 7, 0));
  TEST_ASSERT_EQUAL_INT8(0, fc_root_compare_q32(&root, UINT64_C(3) << 32));
  TEST_ASSERT_EQUAL_INT8(-1, fc_root_compare_q32(&root, (UINT64_C(3) << 32) + 1));
  root.q = 1; /* 7 */
  TEST_ASSERT_EQUAL_INT8(0, fc_root_compare_distance(&root, 4, 14, 0));
  TEST_ASSERT_EQUAL_INT8(0, fc_root_compare_q32(&root, UINT64_C(7) << 32));
}

static void test_g6_bad_rays_are_refused(void) {
  fc_hit hit;
  fc_vec3 far_off = vec(INT32_MIN, 0, 0), origin = vec(0, 0, 0);
  clear();
  TEST_ASSERT_EQUAL_INT(0, shoot(origin, vec(0, 0, 1), &hit)); /* an empty scene */
  TEST_ASSERT_EQUAL_INT(FC_ERR_DIRECTION, shoot(origin, origin, &hit));
  TEST_ASSERT_EQUAL_INT(FC_ERR_COORDINATE, shoot(far_off, vec(0, 0, 1), &hit));
  TEST_ASSERT_EQUAL_INT(FC_ERR_COORDINATE, shoot(origin, vec(0, FC_COORDINATE_MAX + 1, 1), &hit));
  TEST_ASSERT_EQUAL_INT(FC_ERR_COORDINATE, fc_blocked(&scene, &origin, &far_off));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_blocked(&scene, &origin, NULL));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_scene_check(NULL));
  add_table(&fc_kind_plane, planes, 1);
  TEST_ASSERT_EQUAL_INT(FC_ERR_NORMAL, fc_scene_check(&scene));
  planes[0].normal.x = 1;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_scene_check(&scene));
  planes[0].d_exponent = 33;
  TEST_ASSERT_EQUAL_INT(FC_ERR_EXPONENT, fc_scene_check(&scene));
  shapes[0].count = 0xffff;
  shapes[1] = shapes[0];
  scene.shape_count = 1;
  memset(&hit, 0, sizeof hit);
  hit.primitive = 0xffff;
  TEST_ASSERT_EQUAL_INT(FC_ERR_INDEX, fc_offset(&scene, &hit, FC_OFFSET_RESIDUAL, 0, &origin));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_planes);
  RUN_TEST(test_nearest_across_kinds);
  RUN_TEST(test_g2_nearest_of_two_irrational_roots);
  RUN_TEST(test_residual_offset_leaves_the_surface);
  RUN_TEST(test_residual_offset_leaves_flat_surfaces);
  RUN_TEST(test_g2_far_limit_is_exact_for_spheres);
  RUN_TEST(test_g6_bad_rays_are_refused);
  return UNITY_END();
}
