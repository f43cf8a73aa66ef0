/*
 * Where a ray meets a surface: an exact ray parameter t = (p + q sqrt(d)) / m, and the signs of polynomials in t.
 *
 * Planes and triangles have q = 0; spheres have q = -1 (near) or +1 (far). Every kind of shape answers in this one form, and every
 * decision about the point is the sign of a form gamma + beta t + alpha t^2 in whole numbers, so no kind needs to know another.
 */
#ifndef FC_ROOT_H
#define FC_ROOT_H

#include <stdint.h>

#include "i128.h"
#include "num.h"
#include "quick.h"
#include "tally.h"
#include "wide.h"

typedef struct fc_root {
  fc_i128 p, m; /* m > 0 */
  fc_i128 d;    /* discriminant, 0 when q is 0 */
  fc_i128 c;    /* (p^2 - d) / m, exact; 0 when q is 0 */
  int8_t q;
} fc_root;

/* t > 0 as a value, relative error below 2^-58. */
fc_num fc_root_value(const fc_root *root);

/* The same, within 2^-24.5. */
fc_quick fc_root_quick(const fc_root *root);

/* The sign of gamma + beta t + alpha t^2, exact: the last three values of the list, which is used up. t: fc_root_quick, or 0 to
 * do without the filter. */
int8_t fc_root_sign(const fc_root *root, fc_quick t, fc_wide *w, fc_decision decision);

/* Sign of a - b, exact; worked out in *w. */
int8_t fc_root_compare_in(fc_wide *w, const fc_root *a, const fc_root *b);
int8_t fc_root_compare(const fc_root *a, const fc_root *b);

/* Sign of t - t_q32 / 2^32, exact. */
int8_t fc_root_compare_q32(const fc_root *root, uint64_t t_q32);

/* Sign of t^2 |direction|^2 - (far * 2^exponent)^2, exact: is the hit beyond a distance? length2 = |direction|^2. */
int8_t fc_root_compare_distance_in(fc_wide *w, const fc_root *root, int64_t length2, int32_t far, int16_t exponent);
int8_t fc_root_compare_distance(const fc_root *root, int64_t length2, int32_t far, int16_t exponent);

#endif
