/* White box: what the scan engine's short answers on spheres say about points, against long doubles. */
#include <math.h>

#include "../../src/core/scan_sphere.c"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

static uint64_t state = 20260704;

static uint32_t random_u32(void) {
  state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return (uint32_t)(state >> 32);
}

static int64_t within(int64_t low, int64_t high) {
  return low + (int64_t)(((uint64_t)random_u32() << 31 ^ random_u32()) % (uint64_t)(high - low + 1));
}

/* A frame and a light at random; a point of the picture, near or far, and the way to it from the light: within the bound. */
static void test_short_way_is_within_its_bound(void) {
  int trial, used = 0, tight = 0;
  for (trial = 0; trial < 200000; trial++) {
    fc_frame frame;
    fc_scan scan;
    fc_ball_light light;
    int64_t lights[3];
    int16_t way[3];
    uint32_t error = 0, p;
    const int16_t drop = (int16_t)within(-2, 12);
    long double z;
    int i;
    frame.width = (uint16_t)within(1, 512);
    frame.height = (uint16_t)within(1, 512);
    /* the larger of the sides and F has 29 bits */
    frame.view.pixel_shift = (uint8_t)within(15, 19);
    frame.view.focal = (int32_t)within(INT64_C(1) << (trial % 3 == 0 ? 22 : 28), INT64_C(1) << 29);
    frame.depth_near = (uint32_t)within(1 << 10, 1 << 28);
    for (i = 0; i < 3; i++) lights[i] = within(-(INT64_C(1) << 29), INT64_C(1) << 29);
    frame.lights = lights;
    scan.frame = &frame;
    scan.x = (uint16_t)within(0, frame.width - 1);
    scan.y = (uint16_t)within(0, frame.height - 1);
    p = (uint32_t)within(INT64_C(1) << 20, INT64_C(1) << 31);
    light.unit = (uint8_t)within(0, 18);
    light.depth = fc_quick_mul(fc_quick_from(frame.depth_near, (int16_t)(30 + drop)), fc_quick_recip(fc_quick_from((uint64_t)frame.view.focal, 0)));
    if (!short_way(&scan, &light, 0, 0, p, way, &error)) continue;
    used++;
    tight += error < 64;
    z = ldexpl(frame.depth_near, 30 + drop) / p; /* near / z = p / 2^(30 + drop) */
    for (i = 0; i < 3; i++) {
      const long double d = i == 0   ? ldexpl(2 * scan.x + 1 - frame.width, frame.view.pixel_shift)
                            : i == 1 ? ldexpl(frame.height - 2 * scan.y - 1, frame.view.pixel_shift)
                                     : frame.view.focal;
      const long double exact = ldexpl(d * z / frame.view.focal - lights[i], -light.unit);
      TEST_ASSERT_TRUE(fabsl(exact - way[i]) <= error + 1); /* and the floor that callers count with */
    }
  }
  TEST_ASSERT_GREATER_THAN_INT(10000, used);
  TEST_ASSERT_GREATER_THAN_INT(5000, tight);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_short_way_is_within_its_bound);
  return UNITY_END();
}
