/* Points on rays, rounded and exact, and the side of a plane they are on. */
#include "segment.h"

#include <stddef.h>

#include "bits.h"
#include "tally.h"

FC_COLD uint32_t fc_point_near(fc_quick t, const int64_t origin[3], const int64_t direction[3], int64_t point[3]) {
  /* |t direction| < 2^reach; a product is within 2^-24 of itself, and cut */
  int16_t reach = (int16_t)(t.e + 32 + fc_vector_bits(direction));
  uint8_t i;
  if (reach > 54) t.e = (int16_t)(t.e + 54 - reach);
  for (i = 0; i < 3; i++) {
    int64_t step = (int64_t)fc_quick_to_u64(fc_quick_mul(t, fc_quick_from(fc_abs64(direction[i]), 0)));
    point[i] = origin[i] + (direction[i] < 0 ? -step : step);
  }
  if (reach > 53) return UINT32_MAX;
  return reach < 24 ? 2 : (UINT32_C(1) << (reach - 24)) + 2;
}

FC_COLD bool fc_point_at(fc_num t, const int64_t origin[3], const int64_t direction[3], int64_t point[3]) {
  /* |t direction| < 2^(t.e + 63 + 30): a value of up to 57 bits carries less than 2^-1 of relative error */
  uint8_t i, bits = fc_vector_bits(direction);
  bool valid = t.e + 63 + bits <= 56;
  if (!valid) t.e = 56 - 63 - bits;
  for (i = 0; i < 3; i++) {
    fc_num v = t;
    int64_t step;
    fc_num_times_u64(&v, fc_abs64(direction[i]));
    step = (int64_t)fc_num_rounded(&v, 0);
    point[i] = origin[i] + (direction[i] < 0 ? -step : step);
  }
  return valid;
}

const int64_t fc_eye[3] = {0, 0, 0};

/* What an exact point is a root of: t = 1. */
static const fc_root one = {{1, 0}, {1, 0}, {0, 0}, {0, 0}, 0};

FC_COLD void fc_segment_from(fc_segment *segment, const fc_root *root, const int64_t direction[3], const int64_t light[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) segment->light[i] = light[i];
  segment->root = root;
  segment->direction = direction;
  segment->outside = true;
  segment->t = fc_root_quick(root);
  segment->point_error = fc_point_near(segment->t, fc_eye, direction, segment->point);
  if (segment->point_error == UINT32_MAX) segment->t.m = 0;
}

FC_COLD void fc_segment_prepare(fc_segment *segment) {
  segment->t.m = 0;
  segment->t.e = 0;
  if (segment->point_error != UINT32_MAX) segment->t = fc_root_quick(segment->root != NULL ? segment->root : &one);
}

FC_COLD bool fc_segment_apart(const fc_segment *segment, const int64_t low[3], const int64_t high[3]) {
  uint8_t i;
  if (segment->point_error == UINT32_MAX) return false;
  for (i = 0; i < 3; i++) {
    int64_t light = segment->light[i], point = segment->point[i];
    if (light < low[i] && point + segment->point_error < low[i]) return true;
    if (light > high[i] && point - segment->point_error > high[i]) return true;
  }
  return false;
}

FC_COLD const int64_t *fc_segment_direction(const fc_segment *segment) {
  return segment->root != NULL ? segment->direction : segment->point;
}

FC_COLD int8_t fc_segment_sign(fc_segment *segment, fc_decision decision) {
  return fc_root_sign(segment->root != NULL ? segment->root : &one, segment->t, &segment->wide, decision);
}

FC_COLD int8_t fc_side_of_point(fc_segment *segment, const int64_t n[3], fc_i128 k) {
  /* n 64 bits, direction 61: below 2^127 */
  fc_i128 along = fc_i128_dot(n, fc_segment_direction(segment));
  fc_wide *w = &segment->wide;
  fc_wide_start(w);
  fc_wide_push(w, &k);
  fc_wide_push(w, &along);
  w->sign[1] = (int8_t)-w->sign[1];
  fc_wide_push64(w, 0);
  return fc_segment_sign(segment, FC_DECIDE_SIDE);
}

FC_COLD int64_t fc_small_norm1(const int64_t a[3]) {
  return (int64_t)(fc_abs64(a[0]) + fc_abs64(a[1]) + fc_abs64(a[2]));
}

FC_COLD int64_t fc_dot(const int64_t a[3], const int64_t b[3]) {
  return fc_to_i64((uint64_t)a[0] * (uint64_t)b[0] + (uint64_t)a[1] * (uint64_t)b[1] + (uint64_t)a[2] * (uint64_t)b[2]);
}

FC_COLD void fc_cross(const int64_t a[3], const int64_t b[3], int64_t r[3]) {
  r[0] = a[1] * b[2] - a[2] * b[1];
  r[1] = a[2] * b[0] - a[0] * b[2];
  r[2] = a[0] * b[1] - a[1] * b[0];
}

FC_COLD uint8_t fc_vector_bits(const int64_t a[3]) { return fc_bits64(fc_abs64(a[0]) | fc_abs64(a[1]) | fc_abs64(a[2])); }

FC_COLD uint8_t fc_shrink(const int64_t v[3], int64_t r[3]) {
  uint8_t bits = fc_vector_bits(v), shift = bits > 30 ? (uint8_t)(bits - 30) : 0, i;
  for (i = 0; i < 3; i++) r[i] = fc_floor_shift64(v[i], shift);
  return shift;
}
