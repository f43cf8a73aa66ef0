/* Spheres through the public ray engine: tangency, origins inside and on the surface, extreme sizes. */
#include <string.h>

#include "fixcast/fixcast.h"
#include "random.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

static const fc_material materials[] = {FC_MATTE(FC_WHITE)};
static fc_sphere sphere;
static fc_shapes shapes;
static fc_scene scene;

static void use_sphere(int32_t x, int32_t y, int32_t z, int32_t radius) {
  memset(&scene, 0, sizeof scene);
  memset(&sphere, 0, sizeof sphere);
  sphere.center.x = x;
  sphere.center.y = y;
  sphere.center.z = z;
  sphere.radius = radius;
  sphere.object = 1;
  shapes.kind = &fc_kind_sphere;
  shapes.items = &sphere;
  shapes.count = 1;
  scene.shapes = &shapes;
  scene.shape_count = 1;
  scene.materials = materials;
  scene.material_count = 1;
}

static int shoot(const int32_t o[3], const int32_t d[3], fc_hit *hit) {
  fc_ray ray;
  ray.origin.x = o[0];
  ray.origin.y = o[1];
  ray.origin.z = o[2];
  ray.direction.x = d[0];
  ray.direction.y = d[1];
  ray.direction.z = d[2];
  ray.t_min_q32 = 0;
  ray.t_max_q32 = UINT64_MAX;
  return fc_intersect(&scene, &ray, hit);
}

/* Three orthogonal integer vectors of length |q|^2 (Euler-Rodrigues). */
static int32_t quaternion_frame(int32_t row[3][3]) {
  int32_t a = random_within(-9, 9), b = random_within(-9, 9), c = random_within(-9, 9), d = random_within(-9, 9);
  if (a == 0 && b == 0 && c == 0 && d == 0) a = 1;
  row[0][0] = a * a + b * b - c * c - d * d;
  row[0][1] = 2 * (b * c - a * d);
  row[0][2] = 2 * (b * d + a * c);
  row[1][0] = 2 * (b * c + a * d);
  row[1][1] = a * a - b * b + c * c - d * d;
  row[1][2] = 2 * (c * d - a * b);
  row[2][0] = 2 * (b * d - a * c);
  row[2][1] = 2 * (c * d + a * b);
  row[2][2] = a * a - b * b - c * c + d * d;
  return a * a + b * b + c * c + d * d;
}

/* Families 19 and 20: discriminant exactly 0 is a hit; one unit of radius decides either way. */
static void test_g2_tangent_is_hit_and_one_unit_less_is_not(void) {
  int trial;
  for (trial = 0; trial < 2000; trial++) {
    int32_t f[3][3], n = quaternion_frame(f), k = random_within(1, 20000), s = random_within(1, 20000), o[3], i;
    int32_t c[3];
    fc_hit hit;
    for (i = 0; i < 3; i++) {
      o[i] = random_any_size(24);
      c[i] = o[i] + k * f[0][i] + s * f[1][i]; /* k along the ray, s n beside it */
    }
    use_sphere(c[0], c[1], c[2], s * n);
    TEST_ASSERT_EQUAL_INT(1, shoot(o, f[0], &hit));
    TEST_ASSERT_EQUAL_UINT64((uint64_t)k << 32, hit.t_q32);
    use_sphere(c[0], c[1], c[2], s * n + 1);
    TEST_ASSERT_EQUAL_INT(1, shoot(o, f[0], &hit));
    if (s * n > 1) {
      use_sphere(c[0], c[1], c[2], s * n - 1);
      TEST_ASSERT_EQUAL_INT(0, shoot(o, f[0], &hit));
    }
  }
}

/* Families 23 to 25. */
static void test_origin_on_inside_and_past(void) {
  static const int32_t on[3] = {0, 0, 0}, centre[3] = {0, 0, 10}, beyond[3] = {0, 0, 21}, inward[3] = {0, 0, 5},
                       outward[3] = {0, 0, -5}, sideways[3] = {5, 0, 0};
  fc_hit hit;
  use_sphere(0, 0, 10, 10);
  TEST_ASSERT_EQUAL_INT(0, shoot(on, outward, &hit));
  TEST_ASSERT_EQUAL_INT(0, shoot(on, sideways, &hit));
  TEST_ASSERT_EQUAL_INT(1, shoot(on, inward, &hit));
  TEST_ASSERT_EQUAL_UINT64(UINT64_C(4) << 32, hit.t_q32); /* 2b/a = 2 * 50 / 25 */
  TEST_ASSERT_TRUE(hit.inside);                           /* the far side, seen through the sphere */
  TEST_ASSERT_EQUAL_INT32(-(1 << 30), hit.normal_q30.z);
  TEST_ASSERT_EQUAL_INT(1, shoot(centre, sideways, &hit));
  TEST_ASSERT_EQUAL_UINT64(UINT64_C(2) << 32, hit.t_q32);
  TEST_ASSERT_TRUE(hit.inside);
  TEST_ASSERT_EQUAL_INT32(-(1 << 30), hit.normal_q30.x);
  TEST_ASSERT_EQUAL_INT(0, shoot(beyond, inward, &hit));
  TEST_ASSERT_EQUAL_INT(1, shoot(beyond, outward, &hit));
  TEST_ASSERT_FALSE(hit.inside);
  TEST_ASSERT_EQUAL_INT32(1 << 30, hit.normal_q30.z);
  TEST_ASSERT_EQUAL_INT32(20, hit.position.z);
}

/* "If the near root is below t_min take the far one." */
static void test_t_min_selects_the_far_root(void) {
  fc_ray ray = {{0, 0, -20}, {0, 0, 1}, 0, UINT64_MAX};
  fc_hit hit;
  use_sphere(0, 0, 0, 10);
  TEST_ASSERT_EQUAL_INT(1, fc_intersect(&scene, &ray, &hit));
  TEST_ASSERT_EQUAL_UINT64(UINT64_C(10) << 32, hit.t_q32);
  ray.t_min_q32 = UINT64_C(10) << 32;
  TEST_ASSERT_EQUAL_INT(1, fc_intersect(&scene, &ray, &hit));
  TEST_ASSERT_EQUAL_UINT64(UINT64_C(30) << 32, hit.t_q32);
  TEST_ASSERT_TRUE(hit.inside);
  ray.t_max_q32 = UINT64_C(30) << 32;
  TEST_ASSERT_EQUAL_INT(0, fc_intersect(&scene, &ray, &hit));
}

/* The rounded point: off by at most one unit an axis along the ray, whatever the sizes. The residual |P-C|^2 - r^2
 * of a point off by (e) is within 2 |e| r + |e|^2. */
static void test_g10_position_is_within_a_unit(void) {
  int trial, hits = 0;
  for (trial = 0; trial < 2000; trial++) {
    int32_t o[3], d[3], r = random_within(1, 1 << (4 + trial % 25)), i;
    fc_hit hit;
    int64_t dx, dy, dz;
    uint64_t bound;
    use_sphere(random_any_size(28), random_any_size(28), random_any_size(28), r);
    for (i = 0; i < 3; i++) o[i] = random_any_size(28);
    d[0] = (sphere.center.x - o[0]) / 2 + random_within(-r / 4, r / 4);
    d[1] = (sphere.center.y - o[1]) / 2 + random_within(-r / 4, r / 4);
    d[2] = (sphere.center.z - o[2]) / 2 + random_within(-r / 4, r / 4);
    if ((d[0] | d[1] | d[2]) == 0 || shoot(o, d, &hit) == 0) continue;
    hits++;
    dx = hit.position.x - sphere.center.x;
    dy = hit.position.y - sphere.center.y;
    dz = hit.position.z - sphere.center.z;
    bound = 2 * 2 * (uint64_t)r + 4;
    TEST_ASSERT_TRUE((uint64_t)(dx * dx + dy * dy + dz * dz) <= (uint64_t)r * (uint64_t)r + bound);
    TEST_ASSERT_TRUE((uint64_t)(dx * dx + dy * dy + dz * dz) + bound >= (uint64_t)r * (uint64_t)r);
  }
  TEST_ASSERT_GREATER_THAN_INT(1000, hits);
}

/* Family 40. */
static void test_extreme_magnitudes(void) {
  const int32_t m = FC_COORDINATE_MAX, o[3] = {-m, -m, -m}, d[3] = {m, m, m}, away[3] = {-m, m, m};
  fc_hit hit;
  use_sphere(m, m, m, m);
  TEST_ASSERT_EQUAL_INT(1, shoot(o, d, &hit));
  TEST_ASSERT_FALSE(hit.inside);
  TEST_ASSERT_EQUAL_INT(0, shoot(o, away, &hit));
  use_sphere(0, 0, 0, m);
  TEST_ASSERT_EQUAL_INT(1, shoot(o, d, &hit));
  TEST_ASSERT_EQUAL_INT32(hit.position.x, hit.position.z);
}

/* Family 26. */
static void test_g6_bad_radius_is_refused(void) {
  use_sphere(0, 0, 0, 0);
  TEST_ASSERT_EQUAL_INT(FC_ERR_RADIUS, fc_scene_check(&scene));
  use_sphere(0, 0, 0, -1);
  TEST_ASSERT_EQUAL_INT(FC_ERR_RADIUS, fc_scene_check(&scene));
  use_sphere(0, 0, 0, INT32_MIN);
  TEST_ASSERT_EQUAL_INT(FC_ERR_RADIUS, fc_scene_check(&scene));
  use_sphere(INT32_MIN, 0, 0, 1);
  TEST_ASSERT_EQUAL_INT(FC_ERR_COORDINATE, fc_scene_check(&scene));
  use_sphere(0, 0, 0, 1);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_scene_check(&scene));
  sphere.material = 1;
  TEST_ASSERT_EQUAL_INT(FC_ERR_INDEX, fc_scene_check(&scene));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g2_tangent_is_hit_and_one_unit_less_is_not);
  RUN_TEST(test_origin_on_inside_and_past);
  RUN_TEST(test_t_min_selects_the_far_root);
  RUN_TEST(test_g10_position_is_within_a_unit);
  RUN_TEST(test_extreme_magnitudes);
  RUN_TEST(test_g6_bad_radius_is_refused);
  return UNITY_END();
}
