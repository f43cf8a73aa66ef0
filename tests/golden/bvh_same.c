/* The hierarchy that a chip builds of a baked scene is, byte for byte, the one that was baked with it. -DSCENE=flake */
#include <string.h>

#include "fixcast/fixcast.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

extern const fc_scene SCENE;

static uint32_t memory[4096];

static void test_built_is_baked(void) {
  fc_scene scene;
  fc_bvh baked, built;
  FC_READ(&scene, &SCENE, sizeof scene);
  TEST_ASSERT_NOT_NULL(scene.bvh);
  FC_READ(&baked, scene.bvh, sizeof baked);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_bvh_build(&built, &SCENE, memory, sizeof memory));
  TEST_ASSERT_EQUAL_UINT16(baked.count, built.count);
  TEST_ASSERT_EQUAL_UINT8(baked.depth, built.depth);
  TEST_ASSERT_EQUAL_UINT8(baked.shift, built.shift);
  TEST_ASSERT_EQUAL_MEMORY(&baked.origin, &built.origin, sizeof baked.origin);
  TEST_ASSERT_EQUAL_MEMORY(baked.order, built.order, baked.count * sizeof *baked.order);
  TEST_ASSERT_EQUAL_MEMORY(baked.nodes, built.nodes, fc_bvh_bytes(&baked) - baked.count * sizeof *baked.order);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_built_is_baked);
  return UNITY_END();
}
