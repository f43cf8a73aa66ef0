/* Points on rays, rounded and exact, and the side of a plane they are on. */
#include "segment.h"

#include <stddef.h>

#include "bits.h"
#include "tally.h"

FC_COLD bool fc_point_at(fc_num t, const int64_t origin[3], const int64_t direction[3], int64_t point[3]) {
  /* |t direction| < 2^(t.e + 63 + 30): a value of up to 57 bits carries less than 2^-1 of relative error */
  uint8_t i, bits = fc_vector_bits(direction);
  bool valid = t.e + 63 + bits <= 56;
  if (!valid) t.e = 56 - 63 - bits;
  for (i = 0; i < 3; i++) {
    fc_num v = fc_num_mul(t, fc_num_from_u64(fc_abs64(direction[i]), 0));
    int64_t step = (int64_t)fc_num_round(v, 0);
    point[i] = origin[i] + (direction[i] < 0 ? -step : step);
  }
  return valid;
}

FC_COLD void fc_segment_prepare(fc_segment *segment) {
  uint8_t i, bits = fc_vector_bits(segment->light), point_bits = fc_vector_bits(segment->point);
  if (point_bits > bits) bits = point_bits;
  segment->unit = bits > 30 ? (uint8_t)(bits - 30) : 0;
  segment->length = 0;
  for (i = 0; i < 3; i++) {
    int64_t light = segment->light[i], low = segment->point[i] - segment->point_error,
            high = segment->point[i] + segment->point_error;
    segment->low[i] = light < low ? light : low;
    segment->high[i] = light > high ? light : high;
    segment->w[i] = fc_floor_shift64(segment->point[i] - light, segment->unit);
    segment->length += (int64_t)fc_abs64(segment->w[i]);
  }
}

FC_COLD void fc_exact_point_of(fc_exact_point *p, const fc_segment *segment) {
  uint8_t i;
  const fc_root *root = segment->root;
  if (root == NULL) {
    fc_wide_from_i64(&p->m, 1);
    fc_wide_from_i64(&p->d, 0);
  } else {
    fc_wide_from(&p->m, root->m);
    fc_wide_from(&p->d, root->d);
  }
  for (i = 0; i < 3; i++) {
    fc_wide w;
    if (root == NULL) {
      fc_wide_from_i64(&p->u[i], segment->point[i]);
      fc_wide_from_i64(&p->v[i], 0);
      continue;
    }
    fc_wide_from(&p->u[i], root->p);
    fc_wide_mul_i64(&p->u[i], &p->u[i], segment->direction[i]);
    fc_wide_mul_i64(&w, &p->m, segment->origin[i]);
    fc_wide_add(&p->u[i], &p->u[i], &w);
    fc_wide_from_i64(&p->v[i], segment->direction[i] * root->q);
  }
}

FC_COLD fc_i128 fc_norm1(const int64_t a[3]) {
  return fc_i128_add(fc_i128_from_u64(fc_abs64(a[0])),
                     fc_i128_add(fc_i128_from_u64(fc_abs64(a[1])), fc_i128_from_u64(fc_abs64(a[2]))));
}

FC_COLD int8_t fc_side_of_point(const fc_segment *segment, const int64_t n[3], fc_i128 k) {
  fc_exact_point p;
  fc_wide x, y, term;
  uint8_t i;
  if (segment->point_valid) {
    /* n 64 bits, point 61: 126 bits and the sum of three 127; off by less than |n|_1 * error */
    fc_i128 side = fc_i128_sub(k, fc_i128_dot(n, segment->point));
    bool certain = segment->point_error == 0 || fc_i128_compare(fc_i128_abs(side), fc_norm1(n)) > 0;
    FC_TALLY(FC_DECIDE_SIDE, !certain);
    if (certain) return fc_i128_sign(side);
  }
  fc_exact_point_of(&p, segment);
  fc_wide_from(&x, k);
  fc_wide_mul(&x, &x, &p.m);
  fc_wide_from_i64(&y, 0);
  for (i = 0; i < 3; i++) {
    fc_wide_mul_i64(&term, &p.u[i], n[i]);
    fc_wide_sub(&x, &x, &term);
    fc_wide_mul_i64(&term, &p.v[i], n[i]);
    fc_wide_sub(&y, &y, &term);
  }
  return fc_surd_sign(&x, &y, &p.d);
}

FC_COLD void fc_cross(const int64_t a[3], const int64_t b[3], int64_t r[3]) {
  r[0] = a[1] * b[2] - a[2] * b[1];
  r[1] = a[2] * b[0] - a[0] * b[2];
  r[2] = a[0] * b[1] - a[1] * b[0];
}

FC_COLD uint8_t fc_vector_bits(const int64_t a[3]) { return fc_bits64(fc_abs64(a[0]) | fc_abs64(a[1]) | fc_abs64(a[2])); }

FC_COLD void fc_step_off_plane(const int64_t n[3], fc_i128 k, bool behind, int64_t point[3]) {
  uint8_t axis = 0, i;
  int64_t step;
  for (i = 1; i < 3; i++)
    if (fc_abs64(n[i]) > fc_abs64(n[axis])) axis = i;
  step = (n[axis] < 0) != behind ? -1 : 1;
  /* |n . x - k| <= |n|_1 <= 3 |n|_max, so floor of the residual over |n|_max, plus 1, is at most 4 */
  for (i = 0; i < 4; i++) {
    int8_t side = fc_i128_sign(fc_i128_sub(fc_i128_dot(n, point), k));
    if (behind ? side < 0 : side > 0) break;
    point[axis] += step;
  }
}
