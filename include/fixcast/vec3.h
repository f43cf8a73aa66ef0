/* Integer vectors and the Q16.16 literals that scenes are written in. */
#ifndef FIXCAST_VEC3_H
#define FIXCAST_VEC3_H

#include <stdint.h>

/* A point or direction of the world: coordinates times 2^exponent of what holds it, Q16.16 where that is 0. */
typedef struct fc_vec3 {
  int32_t x, y, z;
} fc_vec3;

/* Largest magnitude of any coordinate, radius or ray direction: the bit budgets of docs/SPEC.md rest on it. */
#define FC_COORDINATE_MAX INT32_C(0x3fffffff)

/* A constant in Q16.16, rounded to nearest: FC_Q16(1.75). For initialisers; folded by the compiler, so no
 * floating point reaches the target. Range +-16383. */
#define FC_Q16(v) ((int32_t)((v)*65536.0 + ((v) < 0 ? -0.5 : 0.5)))
/* For initialisers: a fc_vec3 of three real constants, in Q16.16. */
#define FC_VEC3(x, y, z) \
  { FC_Q16(x), FC_Q16(y), FC_Q16(z) }

#endif
