/* The grid that a mesh asks for is the one that its exact distances ask for, from near and from far, at every power of two. */
#include "fixcast/fixcast.h"
#include "random.h"
#include "triangle.c"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

/* frame.c's rule: the bits of a power of two, and whether there is no room above. */
static int32_t grid_of(fc_num most) { return most.e + (most.m > (UINT64_C(1) << 63) - (UINT64_C(1) << 38)); }

enum {
  TRIALS = 20000
};

static void test_quick_and_exact_choose_the_same_grid(void) {
  int exact_ones = 0, i, k;
  for (i = 0; i < TRIALS; i++) {
    const uint8_t bits = (uint8_t)random_within(1, 30), far = (uint8_t)random_within(1, 30);
    fc_vec3 vertices[4];
    fc_shapes shapes = {&fc_kind_triangle, NULL, vertices, 0, 4, NULL, NULL, 0, 0};
    fc_camera camera = {{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 0, FC_FOV_EDGES, 1, 1};
    fc_view view;
    fc_num quick, exact;
    for (k = 0; k < 4; k++) {
      vertices[k].x = random_any_size(bits);
      vertices[k].y = random_any_size(bits);
      vertices[k].z = random_any_size(bits);
    }
    camera.exponent = (int8_t)(i % 2 == 0 ? 0 : random_within(-31, 31));
    camera.eye.x = random_any_size(far);
    camera.eye.y = random_any_size(far);
    camera.eye.z = random_any_size(far);
    camera.target = camera.eye;
    camera.target.z += camera.eye.z > 0 ? -1 : 1;
    camera.target.x += camera.eye.x > 0 ? -1 : 1;
    if (i % 4 == 0) { /* a distance at a power of two, or one beside it */
      camera.exponent = 0;
      camera.eye.x = camera.eye.y = 0;
      vertices[0].x = vertices[0].y = vertices[0].z = 0;
      for (k = 0; k < 4; k++) vertices[k] = vertices[0];
      vertices[3].z = (INT32_C(1) << (bits - 1)) + random_within(-1, 1);
      camera.eye.z = 0;
      camera.target.x = 0;
      camera.target.y = 1;
      camera.target.z = 0;
      camera.up.x = 1;
      camera.up.y = 0;
    }
    if (fc_view_from_camera(&view, &camera, 64, 48) != FC_OK) continue;
    quick = extent(&view, &shapes);
    exact = exact_extent(&view, &shapes);
    TEST_ASSERT_EQUAL_INT32(grid_of(exact), grid_of(quick));
    exact_ones += quick.m == exact.m && quick.e == exact.e;
  }
  /* the quick way is taken, and is not the only one */
  TEST_ASSERT_TRUE(exact_ones > TRIALS / 20 && exact_ones < TRIALS * 3 / 4);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_quick_and_exact_choose_the_same_grid);
  return UNITY_END();
}
