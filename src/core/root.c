/* Exact comparison of ray parameters: values first, surds when the values are too close. */
#include "root.h"

#include "bits.h"
#include "tally.h"

FC_COLD fc_num fc_root_value(const fc_root *root) {
  fc_num p = fc_num_from_abs(root->p), m = fc_num_from_abs(root->m), s;
  if (root->q == 0) return fc_num_div(p, m);
  s = fc_num_add(p, fc_num_sqrt(fc_num_from_abs(root->d)));
  /* p and q sqrt(d) of one sign add up; of opposite signs they would cancel, and t = c / (|p| + sqrt(d)) */
  if (fc_i128_sign(root->p) == root->q || fc_i128_sign(root->p) == 0) return fc_num_div(s, m);
  return fc_num_div(fc_num_from_abs(root->c), s);
}

FC_COLD int8_t fc_num_order(fc_num a, fc_num b) {
  int8_t order = fc_num_compare(a, b);
  fc_num big = order > 0 ? a : b, small = order > 0 ? b : a;
  if (order == 0) return 0;
  return fc_num_compare(fc_num_sub(big, small), fc_num_scale(big, -56)) > 0 ? order : 0;
}

FC_COLD int8_t fc_root_compare(const fc_root *a, const fc_root *b) {
  fc_wide x, y, pa, pb, ma, mb, da, db;
  int8_t order = fc_num_order(fc_root_value(a), fc_root_value(b));
  FC_TALLY(FC_DECIDE_NEARER, order == 0);
  if (order != 0) return order;
  /* (pa mb - pb ma) + qa mb sqrt(da) - qb ma sqrt(db) */
  fc_wide_from(&pa, a->p);
  fc_wide_from(&pb, b->p);
  fc_wide_from(&ma, a->m);
  fc_wide_from(&mb, b->m);
  fc_wide_from(&da, a->d);
  fc_wide_from(&db, b->d);
  fc_wide_mul(&x, &pa, &mb);
  fc_wide_mul(&y, &pb, &ma);
  fc_wide_sub(&x, &x, &y);
  fc_wide_mul_i64(&mb, &mb, a->q);
  fc_wide_mul_i64(&ma, &ma, -b->q);
  return fc_surd_sign2(&x, &mb, &da, &ma, &db);
}

FC_COLD int8_t fc_root_compare_ratio(const fc_root *root, const fc_wide *a, const fc_wide *b) {
  /* a m - b p - b q sqrt(d) */
  fc_wide x, y, d;
  fc_wide_from(&x, root->m);
  fc_wide_mul(&x, &x, a);
  fc_wide_from(&y, root->p);
  fc_wide_mul(&y, &y, b);
  fc_wide_sub(&x, &x, &y);
  fc_wide_mul_i64(&y, b, -root->q);
  fc_wide_from(&d, root->d);
  return fc_surd_sign(&x, &y, &d);
}

FC_COLD int8_t fc_root_compare_q32(const fc_root *root, uint64_t t_q32) {
  fc_wide a, b;
  int8_t order = fc_num_order(fc_root_value(root), fc_num_from_u64(t_q32, -32));
  FC_TALLY(FC_DECIDE_FAR, order == 0);
  if (order != 0) return order;
  fc_wide_from(&a, fc_i128_from_u64(t_q32));
  fc_wide_from_i64(&b, INT64_C(1) << 32);
  return (int8_t)-fc_root_compare_ratio(root, &a, &b);
}

FC_COLD int8_t fc_root_compare_distance(const fc_root *root, int64_t length2, int32_t far, int16_t exponent) {
  fc_wide x, y, z, d;
  fc_num t = fc_root_value(root), limit = fc_num_from_u64((uint64_t)far, exponent);
  int8_t order = fc_num_order(fc_num_mul(fc_num_mul(t, t), fc_num_from_u64((uint64_t)length2, 0)),
                              fc_num_mul(limit, limit));
  FC_TALLY(FC_DECIDE_FAR, order == 0);
  if (order != 0) return order;
  /* (p + q sqrt d)^2 length2 - far^2 m^2, times 2^(-2 exponent) when the exponent is negative:
   * the constant part is (p^2 + q^2 d) length2 - far^2 m^2, the part with sqrt(d) is 2 p q length2 */
  fc_wide_from(&d, root->d);
  fc_wide_from(&y, root->p);
  fc_wide_mul(&x, &y, &y);
  if (root->q != 0) fc_wide_add(&x, &x, &d);
  fc_wide_mul_i64(&x, &x, length2);
  fc_wide_mul_i64(&y, &y, 2 * root->q);
  fc_wide_mul_i64(&y, &y, length2);
  fc_wide_from(&z, root->m);
  fc_wide_mul(&z, &z, &z);
  fc_wide_mul_i64(&z, &z, (int64_t)far * far);
  if (exponent >= 0) {
    fc_wide_shift_left(&z, &z, (uint16_t)(2 * exponent));
  } else {
    fc_wide_shift_left(&x, &x, (uint16_t)(-2 * exponent));
    fc_wide_shift_left(&y, &y, (uint16_t)(-2 * exponent));
  }
  fc_wide_sub(&x, &x, &z);
  return fc_surd_sign(&x, &y, &d);
}
