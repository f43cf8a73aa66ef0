/*
 * Where a ray meets a surface: an exact ray parameter t = (p + q sqrt(d)) / m, and how two of them compare.
 *
 * Planes and triangles have q = 0; spheres have q = -1 (near) or +1 (far). Every kind of shape answers in this
 * one form, so no kind needs to know another.
 */
#ifndef FC_ROOT_H
#define FC_ROOT_H

#include <stdint.h>

#include "i128.h"
#include "num.h"
#include "wide.h"

typedef struct fc_root {
  fc_i128 p, m; /* m > 0 */
  fc_i128 d;    /* discriminant, 0 when q is 0 */
  fc_i128 c;    /* |p^2 - d| / m, exact: the other factor, for roots that would cancel */
  int8_t q;
} fc_root;

/* t > 0 as a value, relative error below 2^-58. */
fc_num fc_root_value(const fc_root *root);

/* Sign of a - b, exact. */
int8_t fc_root_compare(const fc_root *a, const fc_root *b);

/* Sign of t - t_q32 / 2^32, exact. */
int8_t fc_root_compare_q32(const fc_root *root, uint64_t t_q32);

/* Sign of t^2 |direction|^2 - (far * 2^exponent)^2, exact: is the hit beyond a distance? length2 = |direction|^2. */
int8_t fc_root_compare_distance(const fc_root *root, int64_t length2, int32_t far, int16_t exponent);

/* Sign of a - b * t for a, b >= 0, exact. */
int8_t fc_root_compare_ratio(const fc_root *root, const fc_wide *a, const fc_wide *b);

/* The order of two values with relative errors below 2^-57 each; 0: too close to tell. */
int8_t fc_num_order(fc_num a, fc_num b);

#endif
