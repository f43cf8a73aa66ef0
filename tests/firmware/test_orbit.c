/* The camera's way round, against sines and cosines of the C library. */
#include "orbit.h"

#include <math.h>
#include <string.h>

#include "fixcast/config.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

static const double turn = 6.283185307179586476925;

static const fc_camera start FC_ROM = {.eye = {70000, 98304, 65536},
                                       .target = {-1000, 98304, 0},
                                       .up = {0, 1, 0},
                                       .fov_rule = FC_FOV_CENTRES,
                                       .exponent = 3,
                                       .tan_half_fov_numerator = 3,
                                       .tan_half_fov_denominator = 7};
enum {
  AXIS_X = 1234,
  AXIS_Z = -393216
};

static void assert_turned(const fc_vec3 *from, uint16_t step, const fc_vec3 *point) {
  const double angle = turn * step / FC_ORBIT_STEPS, x = (double)from->x - AXIS_X, z = (double)from->z - AXIS_Z;
  /* A sine is off by 2^-16 at most, the result by half a unit for rounding. */
  const double bound = (fabs(x) + fabs(z)) / 65536 + 0.5;
  TEST_ASSERT_TRUE(fabs(point->x - (AXIS_X + x * cos(angle) + z * sin(angle))) <= bound);
  TEST_ASSERT_TRUE(fabs(point->z - (AXIS_Z + z * cos(angle) - x * sin(angle))) <= bound);
  TEST_ASSERT_EQUAL_INT32(from->y, point->y);
}

static void test_each_step_turns_eye_and_target_by_six_degrees_about_the_axis(void) {
  uint16_t step;
  for (step = 0; step < FC_ORBIT_STEPS; step++) {
    fc_camera camera;
    fc_orbit(&start, AXIS_X, AXIS_Z, step, &camera);
    assert_turned(&start.eye, step, &camera.eye);
    assert_turned(&start.target, step, &camera.target);
  }
}

/* As orbit.h has it; these products are exact in double precision. */
static void test_coordinates_are_rounded_to_the_nearest(void) {
  uint16_t step;
  for (step = 0; step < FC_ORBIT_STEPS; step++) {
    const double angle = turn * step / FC_ORBIT_STEPS, s = round(32768 * sin(angle)), c = round(32768 * cos(angle));
    const double x = (double)start.eye.x - AXIS_X, z = (double)start.eye.z - AXIS_Z;
    fc_camera camera;
    fc_orbit(&start, AXIS_X, AXIS_Z, step, &camera);
    TEST_ASSERT_EQUAL_INT32(AXIS_X + (int32_t)round((x * c + z * s) / 32768), camera.eye.x);
    TEST_ASSERT_EQUAL_INT32(AXIS_Z + (int32_t)round((z * c - x * s) / 32768), camera.eye.z);
  }
}

static void test_step_0_is_the_camera_itself(void) {
  fc_camera camera;
  fc_orbit(&start, AXIS_X, AXIS_Z, 0, &camera);
  TEST_ASSERT_TRUE(memcmp(&start.eye, &camera.eye, sizeof start.eye) == 0);
  TEST_ASSERT_TRUE(memcmp(&start.target, &camera.target, sizeof start.target) == 0);
}

static void test_a_quarter_turn_is_exact(void) {
  fc_camera camera;
  fc_orbit(&start, AXIS_X, AXIS_Z, 15, &camera);
  TEST_ASSERT_EQUAL_INT32(AXIS_X + (65536 - AXIS_Z), camera.eye.x);
  TEST_ASSERT_EQUAL_INT32(AXIS_Z - (70000 - AXIS_X), camera.eye.z);
}

static void test_sixty_steps_are_a_turn(void) {
  uint16_t step;
  for (step = 0; step < FC_ORBIT_STEPS; step++) {
    fc_camera once, again;
    fc_orbit(&start, AXIS_X, AXIS_Z, step, &once);
    fc_orbit(&start, AXIS_X, AXIS_Z, (uint16_t)(step + 60u * 1000u), &again);
    TEST_ASSERT_TRUE(memcmp(&once.eye, &again.eye, sizeof once.eye) == 0);
  }
}

static void test_the_rest_of_the_camera_stays(void) {
  fc_camera camera;
  fc_orbit(&start, AXIS_X, AXIS_Z, 7, &camera);
  TEST_ASSERT_EQUAL_INT32(1, camera.up.y);
  TEST_ASSERT_EQUAL_INT(FC_FOV_CENTRES, camera.fov_rule);
  TEST_ASSERT_EQUAL_INT(3, camera.exponent);
  TEST_ASSERT_EQUAL_UINT32(3, camera.tan_half_fov_numerator);
  TEST_ASSERT_EQUAL_UINT32(7, camera.tan_half_fov_denominator);
}

/* The far end of the range: products of 2^30 by 2^15. */
static void test_the_largest_distances_do_not_overflow(void) {
  const fc_camera far = {.eye = {(INT32_C(1) << 30) - 1, 0, 0}, .target = {0, 0, 1 - (INT32_C(1) << 30)}, .up = {0, 1, 0}};
  fc_camera camera;
  fc_orbit(&far, 0, 0, 15, &camera);
  TEST_ASSERT_EQUAL_INT32(0, camera.eye.x);
  TEST_ASSERT_EQUAL_INT32(1 - (INT32_C(1) << 30), camera.eye.z);
  TEST_ASSERT_EQUAL_INT32(1 - (INT32_C(1) << 30), camera.target.x);
  fc_orbit(&far, 0, 0, 45, &camera);
  TEST_ASSERT_EQUAL_INT32((INT32_C(1) << 30) - 1, camera.eye.z);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_each_step_turns_eye_and_target_by_six_degrees_about_the_axis);
  RUN_TEST(test_coordinates_are_rounded_to_the_nearest);
  RUN_TEST(test_step_0_is_the_camera_itself);
  RUN_TEST(test_a_quarter_turn_is_exact);
  RUN_TEST(test_sixty_steps_are_a_turn);
  RUN_TEST(test_the_rest_of_the_camera_stays);
  RUN_TEST(test_the_largest_distances_do_not_overflow);
  return UNITY_END();
}
