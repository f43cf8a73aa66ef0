/* Signs of polynomials at a ray's parameter: by value first, then by whole numbers. */
#include "root.h"

#include "bits.h"
#include "fixcast/config.h"

FC_COLD fc_num fc_root_value(const fc_root *root) {
  fc_num t, s;
  fc_num_set_abs(&t, &root->p);
  if (root->q != 0) {
    fc_num_set_abs(&s, &root->d);
    fc_num_root(&s);
    fc_num_plus(&t, &s);
    if (fc_i128_sign(root->p) == -root->q) {
      /* p and q sqrt(d) of opposite signs would cancel: t = c / (|p| + sqrt(d)) */
      s = t;
      fc_num_set_abs(&t, &root->c);
      fc_num_over(&t, &s);
      return t;
    }
  }
  fc_num_set_abs(&s, &root->m);
  fc_num_over(&t, &s);
  return t;
}

static FC_COLD fc_quick quick_abs(const fc_i128 *v) {
  fc_i128 a = fc_i128_abs(*v);
  return fc_quick_add(fc_quick_from(a.hi, 64), fc_quick_from(a.lo, 0));
}

FC_COLD fc_quick fc_root_quick(const fc_root *root) {
  /* as above; p, d, m and c within 2^-29, their root and the reciprocal within 2^-26 */
  fc_quick s = quick_abs(&root->p), over = quick_abs(&root->m), d = quick_abs(&root->d);
  int8_t sign = fc_i128_sign(root->p);
  if (d.m != 0) {
    s = fc_quick_add(s, fc_quick_mul(d, fc_quick_rsqrt(d)));
    if (sign != root->q && sign != 0) {
      over = s;
      s = quick_abs(&root->c);
    }
  }
  return fc_quick_mul(s, fc_quick_recip(over));
}

/* A value's magnitude, within 2^-30: four limbs have at least 49 bits. */
static FC_COLD fc_quick magnitude(const fc_wide *w, uint8_t i) {
  uint64_t m = 0;
  uint8_t end = w->start[i + 1], left = 4;
  while (left > 0 && end > w->start[i]) {
    end--;
    m |= (uint64_t)w->limb[end] << (16 * --left);
  }
  return fc_quick_from(m, (int16_t)(16 * (end - w->start[i] - left)));
}

/* The sign by value, 0 when that leaves it open. */
static FC_COLD int8_t quick_sign(const fc_wide *w, fc_quick t) {
  /* Positive and negative terms apart, each within 2^-22.8: a factor t within 2^-24, products and sums within 2^-30. */
  fc_quick sum[2] = {{0, 0}, {0, 0}}, power = fc_quick_from(1, 0);
  uint8_t i;
  for (i = (uint8_t)(w->count - 3); i < w->count; i++) {
    fc_quick *to = &sum[w->sign[i] < 0];
    if (w->sign[i] != 0) *to = fc_quick_add(*to, fc_quick_mul(power, magnitude(w, i)));
    power = fc_quick_mul(power, t);
  }
  for (i = 0; i < 2; i++) {
    fc_quick less = fc_quick_add(sum[1 - i], fc_quick_scale(sum[i], -20));
    if (fc_quick_less(less, sum[i])) return i == 0 ? 1 : -1;
  }
  return 0;
}

FC_COLD int8_t fc_root_sign(const fc_root *root, fc_quick t, fc_wide *w, fc_decision decision) {
  /* 0 gamma, 1 beta, 2 alpha, 3 p, 4 m, 5 d, 6 one; m^2 times the form is x + y q sqrt(d) with
   * x = alpha (p^2 + d) + beta m p + gamma m^2, y = 2 alpha p + beta m (m times that, and m > 0 is left out) */
  static const uint8_t expand[] FC_ROM = {FC_SUM(2, 0), FC_TIMES(3, 3), FC_TIMES(5, 6),                 /* 7: p^2 + d */
                                          FC_SUM(1, 0), FC_TIMES(3, 4),                                 /* 8: m p */
                                          FC_SUM(1, 0), FC_TIMES(4, 4),                                 /* 9: m^2 */
                                          FC_SUM(3, 0), FC_TIMES(2, 3), FC_TIMES(2, 3), FC_TIMES(1, 4), /* y */
                                          FC_SUM(3, 0), FC_TIMES(2, 7), FC_TIMES(1, 8), FC_TIMES(0, 9), /* x */
                                          0};
  /* 0 y, 1 x, 2 d: opposite signs, so x^2 - y^2 d decides */
  static const uint8_t squares[] FC_ROM = {FC_SUM(1, 0), FC_TIMES(0, 2), FC_SUM(1, 1), FC_TIMES(1, 1), FC_TIMES(3, 0), 0};
  int8_t x, y, sign = 0;
  if (t.m != 0) sign = quick_sign(w, t);
  (void)decision;
  FC_TALLY(decision, sign == 0);
  if (sign != 0) return sign;
  fc_wide_keep(w, 3);
  fc_wide_push(w, &root->p);
  fc_wide_push(w, &root->m);
  fc_wide_push(w, &root->d);
  fc_wide_push64(w, 1);
  fc_wide_run(w, expand);
  fc_wide_keep(w, 2);
  fc_wide_push(w, &root->d);
  x = w->sign[1];
  y = (int8_t)(w->sign[0] * root->q * w->sign[2]);
  if (x * y >= 0) return x != 0 ? x : y;
  fc_wide_run(w, squares);
  return (int8_t)(x * w->sign[4]);
}

FC_COLD int8_t fc_root_compare_in(fc_wide *w, const fc_root *a, const fc_root *b) {
  /* b's own polynomial c - 2 p t + m t^2 at a's t, and half its derivative, which tells on which side of its apex a is:
   * 0 c, 1 p, 2 m, 3 one */
  static const uint8_t polynomial[] FC_ROM = {FC_SUM(1, 0), FC_TIMES(0, 3), FC_SUM(0, 2), FC_TIMES(1, 3), FC_TIMES(1, 3),
                                              FC_SUM(1, 0), FC_TIMES(2, 3), 0};
  static const uint8_t derivative[] FC_ROM = {FC_SUM(0, 1), FC_TIMES(1, 3), FC_SUM(1, 0), FC_TIMES(2, 3), FC_NOTHING, 0};
  const fc_quick t = fc_root_quick(a);
  int8_t sign = b->q;
  uint8_t i;
  for (i = 0; i < 2; i++) {
    int8_t s;
    fc_wide_start(w);
    fc_wide_push(w, &b->c);
    fc_wide_push(w, &b->p);
    fc_wide_push(w, &b->m);
    fc_wide_push64(w, 1);
    fc_wide_run(w, i == 0 ? derivative : polynomial);
    s = fc_root_sign(a, t, w, FC_DECIDE_NEARER);
    if (i != 0) return (int8_t)(sign * s);
    if (sign == 0 || s == -sign) return s;
  }
  return 0;
}

FC_COLD int8_t fc_root_compare(const fc_root *a, const fc_root *b) {
  fc_wide w;
  return fc_root_compare_in(&w, a, b);
}

FC_COLD int8_t fc_root_compare_q32(const fc_root *root, uint64_t t_q32) {
  /* 2^32 t - t_q32 */
  fc_i128 bound = fc_i128_from_u64(t_q32);
  fc_wide w;
  fc_wide_start(&w);
  fc_wide_push(&w, &bound);
  fc_wide_push64(&w, -(INT64_C(1) << 32));
  fc_wide_push64(&w, 0);
  return (int8_t)-fc_root_sign(root, fc_root_quick(root), &w, FC_DECIDE_FAR);
}

FC_COLD int8_t fc_root_compare_distance_in(fc_wide *w, const fc_root *root, int64_t length2, int32_t far, int16_t exponent) {
  /* 0 length2, 1 far, 2 2^max(exponent, 0), 3 2^max(-exponent, 0): all times the square of the last */
  static const uint8_t program[] FC_ROM = {FC_SUM(1, 0), FC_TIMES(1, 2), /* 4 */
                                           FC_SUM(1, 0), FC_TIMES(3, 3), /* 5 */
                                           FC_SUM(0, 1), FC_TIMES(4, 4), FC_NOTHING, FC_SUM(1, 0), FC_TIMES(0, 5), 0};
  uint8_t i;
  fc_wide_start(w);
  fc_wide_push64(w, length2);
  fc_wide_push64(w, far);
  for (i = 0; i < 2; i++) {
    /* up to 2^94 */
    fc_i128 one = {1, 0};
    one = fc_i128_shift_left(one, (uint8_t)(exponent > 0 ? exponent : 0));
    fc_wide_push(w, &one);
    exponent = (int16_t)-exponent;
  }
  fc_wide_run(w, program);
  return fc_root_sign(root, fc_root_quick(root), w, FC_DECIDE_FAR);
}

FC_COLD int8_t fc_root_compare_distance(const fc_root *root, int64_t length2, int32_t far, int16_t exponent) {
  fc_wide w;
  return fc_root_compare_distance_in(&w, root, length2, far, exponent);
}
