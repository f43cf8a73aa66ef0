/* rotation.h: the same bits on every machine. What they should be, volume_rotation and volume_trackball ask long double. */
#include "fixcast/error.h"
#include "fixcast/rotation.h"

#include "random.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

static uint32_t hash;

/* FNV-1a of a word, least significant byte first */
static void add(int32_t v) {
  uint8_t i;
  for (i = 0; i < 32; i = (uint8_t)(i + 8)) hash = (hash ^ (((uint32_t)v >> i) & 255u)) * UINT32_C(16777619);
}

static void add_rotation(const fc_rotation *r) {
  add(r->w);
  add(r->x);
  add(r->y);
  add(r->z);
}

static fc_vec3 random_direction(void) {
  fc_vec3 v;
  v.x = random_any_size(28);
  v.y = random_any_size(28);
  v.z = random_any_size(28) | 1;
  return v;
}

static void test_g15_rotations_have_the_same_bits_everywhere(void) {
  fc_rotation all = FC_ROTATION_NONE, r;
  fc_matrix m;
  fc_vec3 axis, to, p;
  int32_t mouse[5];
  uint16_t i;
  uint8_t j;
  hash = UINT32_C(2166136261);
  for (i = 0; i < 200; i++) {
    add(fc_sin_q30((uint32_t)random_u64()));
    axis = random_direction();
    to = random_direction();
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotation_about(&r, &axis, (uint16_t)random_u64()));
    add_rotation(&r);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotation_compose(&all, &r, &all));
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotation_between(&r, &axis, &to));
    add_rotation(&r);
    for (j = 0; j < 5; j++) mouse[j] = j == 4 ? random_within(1, 500) : random_within(j == 1 ? -65535 : -300, 300);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_trackball_drag(&r, mouse[0], mouse[1], mouse[2], mouse[3], mouse[4]));
    add_rotation(&r);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotation_compose(&all, &all, &r));
    add_rotation(&all);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotation_matrix(&m, &all));
    for (j = 0; j < 9; j++) add(m.row[j / 3][j % 3]);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotate_points(&p, &axis, 1, &m, &to));
    add(p.x);
    add(p.y);
    add(p.z);
  }
  TEST_ASSERT_EQUAL_HEX32(UINT32_C(0x61C4C1C8), hash);
}

/* Opposite directions: half a turn, which takes the one to the other; the way back, after the way there, is none. */
static void test_g15_half_turns_and_ways_back(void) {
  static const fc_vec3 ways[] = {{0, 0, 5}, {0, 0, -7}, {3, 0, 0}, {0, -2, 0}, {1, 2, 3}};
  static const fc_vec3 nowhere = {0, 0, 0};
  fc_rotation turn, back, both, stretched = FC_ROTATION_NONE;
  fc_vec3 p;
  fc_matrix m;
  unsigned i;
  for (i = 0; i < sizeof ways / sizeof ways[0]; i++) {
    fc_vec3 v = ways[i], to;
    to.x = -v.x;
    to.y = -v.y;
    to.z = -v.z;
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotation_between(&turn, &v, &to));
    TEST_ASSERT_INT_WITHIN(1, 0, turn.w);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotation_matrix(&m, &turn));
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotate_points(&v, &v, 1, &m, NULL));
    TEST_ASSERT_EQUAL_INT(to.x, v.x);
    TEST_ASSERT_EQUAL_INT(to.y, v.y);
    TEST_ASSERT_EQUAL_INT(to.z, v.z);
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotation_about(&turn, &ways[i], (uint16_t)(1000 * i + 7)));
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotation_invert(&back, &turn));
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_rotation_compose(&both, &back, &turn));
    TEST_ASSERT_INT_WITHIN(4, FC_ONE_Q30, both.w);
    TEST_ASSERT_INT_WITHIN(4, 0, both.x);
    TEST_ASSERT_INT_WITHIN(4, 0, both.y);
    TEST_ASSERT_INT_WITHIN(4, 0, both.z);
  }
  stretched.x = FC_ONE_Q30 / 2;
  TEST_ASSERT_EQUAL_INT(FC_ERR_ROTATION, fc_rotation_invert(&back, &stretched));
  TEST_ASSERT_EQUAL_INT(FC_ERR_ROTATION, fc_rotation_matrix(&m, &stretched));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_rotation_invert(&back, NULL));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_trackball_point(NULL, 0, 0, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_trackball_point(&p, FC_TRACKBALL_MAX + 1, 0, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_trackball_point(&p, 0, -FC_TRACKBALL_MAX - 1, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_trackball_point(&p, 0, 0, 0));
  TEST_ASSERT_EQUAL_INT(FC_ERR_DIRECTION, fc_rotation_about(&turn, &nowhere, 1));
  TEST_ASSERT_EQUAL_INT(FC_ERR_DIRECTION, fc_rotation_between(&turn, &ways[0], &nowhere));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g15_rotations_have_the_same_bits_everywhere);
  RUN_TEST(test_g15_half_turns_and_ways_back);
  return UNITY_END();
}
