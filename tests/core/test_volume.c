/* volume.h and reflect.h on every machine: known answers at the touch, and the same bits from random ones. What is right, volume_basic
 * asks exact fractions and torture (families 33, 34) GMP. */
#include "fixcast/volume.h"

#include "fixcast/reflect.h"
#include "random.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  MOST = FC_COORDINATE_MAX
};

static void test_g16_touching_counts_as_meeting(void) {
  const fc_vec3 origin = {-5, 1, 0}, along = {3, 0, 0}, corner[3] = {{1, 1, 3}, {3, 1, 1}, {3, 3, 3}};
  const fc_aabb unit = {{0, 0, 0}, {1, 1, 1}}, next = {{1, 0, 0}, {2, 1, 1}}, after = {{2, 0, 0}, {2, 1, 1}};
  const fc_sphere a = {{0, 0, 0}, 3, 0, 0}, b = {{2, 3, 6}, 4, 0, 0}, c = {{2, 3, 6}, 3, 0, 0};
  const fc_plane tangent = {{2, 3, 6}, -21, 0, 0, 0}, clear = {{2, 3, 6}, -22, 0, 0, 0};
  fc_span span;
  TEST_ASSERT_EQUAL_INT(1, fc_ray_aabb(&origin, &along, &unit, &span)); /* along an edge */
  TEST_ASSERT_EQUAL_INT64(5, span.enter);
  TEST_ASSERT_EQUAL_INT64(3, span.enter_of);
  TEST_ASSERT_EQUAL_INT64(6, span.leave);
  TEST_ASSERT_EQUAL_INT64(3, span.leave_of);
  TEST_ASSERT_EQUAL_INT(1, fc_aabb_aabb(&unit, &next));
  TEST_ASSERT_EQUAL_INT(0, fc_aabb_aabb(&unit, &after));
  TEST_ASSERT_EQUAL_INT(1, fc_sphere_sphere(&a, &b)); /* 7 apart */
  TEST_ASSERT_EQUAL_INT(0, fc_sphere_sphere(&a, &c));
  TEST_ASSERT_EQUAL_INT(FC_SIDE_ON, fc_sphere_plane(&a, &tangent));
  TEST_ASSERT_EQUAL_INT(FC_SIDE_BACK, fc_sphere_plane(&a, &clear));
  TEST_ASSERT_EQUAL_INT(FC_SIDE_ON, fc_aabb_plane(&unit, &(fc_plane){{1, 1, 1}, -3, 0, 0, 0}));
  TEST_ASSERT_EQUAL_INT(FC_SIDE_BACK, fc_aabb_plane(&unit, &(fc_plane){{1, 1, 1}, -4, 0, 0, 0}));
  TEST_ASSERT_EQUAL_INT(0, fc_triangle_aabb(corner, &unit));
  TEST_ASSERT_EQUAL_INT(1, fc_triangle_aabb(corner, &(fc_aabb){{0, 0, 0}, {2, 2, 2}}));
}

static uint32_t hash;

static void add(int64_t v) {
  uint8_t i;
  for (i = 0; i < 64; i = (uint8_t)(i + 8)) hash = (hash ^ (uint32_t)(((uint64_t)v >> i) & 255u)) * UINT32_C(16777619);
}

static fc_vec3 any(void) {
  fc_vec3 v;
  v.x = random_any_size(30);
  v.y = random_any_size(30);
  v.z = random_any_size(30) | 1;
  return v;
}

static void sort(int32_t *low, int32_t *high) {
  if (*low > *high) {
    const int32_t kept = *low;
    *low = *high;
    *high = kept;
  }
}

static void test_g16_the_same_answers_everywhere(void) {
  uint16_t i;
  hash = UINT32_C(2166136261);
  for (i = 0; i < 300; i++) {
    fc_vec3 o = any(), d = any(), t[3];
    fc_aabb box, other;
    fc_sphere ball, second;
    fc_plane plane;
    fc_span span = {0, 0, 0, 0};
    int result;
    t[0] = o;
    t[1] = d;
    t[2] = any();
    box.low = any();
    box.high = any();
    sort(&box.low.x, &box.high.x);
    sort(&box.low.y, &box.high.y);
    sort(&box.low.z, &box.high.z);
    other.low = box.low;
    other.high = box.low;
    ball.center = t[2];
    ball.radius = random_within(1, MOST);
    second.center = o;
    second.radius = random_within(1, MOST);
    plane.normal = d;
    plane.d = random_any_size(30);
    plane.d_exponent = (int8_t)(i % 33);
    add(fc_ray_aabb(&o, &d, &box, &span));
    add(span.enter);
    add(span.leave);
    add(span.leave_of);
    add(fc_point_plane(&o, &plane));
    add(fc_sphere_plane(&ball, &plane));
    add(fc_aabb_plane(&box, &plane));
    add(fc_sphere_sphere(&ball, &second));
    add(fc_aabb_aabb(&box, &other));
    add(fc_triangle_aabb(t, &box));
    result = fc_reflect(&o, &d, &t[2]);
    TEST_ASSERT_EQUAL_INT(FC_OK, result);
    add(o.x);
    add(o.y);
    add(o.z);
  }
  TEST_ASSERT_EQUAL_HEX32(UINT32_C(0xD5BB9D11), hash);
}

static void test_g6_mirrors_refuse_bad_arguments(void) {
  const fc_vec3 zero = {0, 0, 0}, x = {1, 0, 0}, far = {0, INT32_MIN, 0};
  fc_vec3 r = {7, 7, 7};
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_reflect(NULL, &x, &x));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_reflect(&r, NULL, &x));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_reflect(&r, &x, NULL));
  TEST_ASSERT_EQUAL_INT(FC_ERR_DIRECTION, fc_reflect(&r, &zero, &x));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NORMAL, fc_reflect(&r, &x, &zero));
  TEST_ASSERT_EQUAL_INT(FC_ERR_COORDINATE, fc_reflect(&r, &far, &x));
  TEST_ASSERT_EQUAL_INT(FC_ERR_COORDINATE, fc_reflect(&r, &x, &far));
  TEST_ASSERT_EQUAL_INT32(7, r.x);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g16_touching_counts_as_meeting);
  RUN_TEST(test_g16_the_same_answers_everywhere);
  RUN_TEST(test_g6_mirrors_refuse_bad_arguments);
  return UNITY_END();
}
