/* Vectors in a line, for tests. */
#ifndef TEST_VECTORS_H
#define TEST_VECTORS_H

#include "fixcast/vec3.h"

static inline fc_vec3 vec(int32_t x, int32_t y, int32_t z) {
  fc_vec3 v;
  v.x = x;
  v.y = y;
  v.z = z;
  return v;
}

#endif
