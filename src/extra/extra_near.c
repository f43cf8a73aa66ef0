/* Distances of points, segments and triangles against a radius. */
#include "extra_near.h"

#include "bits.h"
#include "fixcast/config.h"
#include "i128.h"
#include "segment.h"
#include "wide.h"

/* Products of vectors that stand in a list from i and from j on. */
#define DOT(i, j) FC_SUM(3, 0), FC_TIMES(i, j), FC_TIMES(i + 1, j + 1), FC_TIMES(i + 2, j + 2)

static void difference(int64_t to[3], const int64_t a[3], const int64_t b[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) to[i] = a[i] - b[i];
}

/* a x b for components whose products are below 2^126. */
static void cross(fc_i128 to[3], const int64_t a[3], const int64_t b[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    const uint8_t j = (uint8_t)((i + 1) % 3), k = (uint8_t)((i + 2) % 3);
    to[i] = fc_i128_sub(fc_i128_mul(a[j], b[k]), fc_i128_mul(a[k], b[j]));
  }
}

static void push(fc_wide *w, const fc_i128 v[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) fc_wide_push(w, v + i);
}

static void push64(fc_wide *w, const int64_t v[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) fc_wide_push64(w, v[i]);
}

/* The sign of m . v: 97 + 48 bits. */
static int8_t sign_of_dot(const fc_i128 m[3], const int64_t v[3]) {
  static const uint8_t program[] FC_ROM = {DOT(0, 3), 0};
  fc_wide w;
  fc_wide_start(&w);
  push(&w, m);
  push64(&w, v);
  fc_wide_run(&w, program);
  return w.sign[6];
}

/* |v . n| <= r |n|: (2 + 97 + 48) bits twice, 2 * 47 and 2 + 2 * 97. 21 + 12 + 3 + 10 + 13 + 6 + 20 limbs of 16 bits. */
static bool near_along(const fc_i128 n[3], const int64_t v[3], int64_t r) {
  static const uint8_t program[] FC_ROM = {DOT(0, 3),                    /* 7: v . n */
                                           DOT(0, 0),                    /* 8: n^2 */
                                           FC_SUM(1, 0), FC_TIMES(6, 6), /* 9: r^2 */
                                           FC_SUM(1, 1), FC_TIMES(8, 9), FC_TIMES(7, 7), 0};
  fc_wide w;
  fc_wide_start(&w);
  push(&w, n);
  push64(&w, v);
  fc_wide_push64(&w, r);
  fc_wide_run(&w, program);
  return w.sign[10] >= 0;
}

/* 0 <= m . n <= n^2: 2 + 98 + 97 bits. */
static bool part_of(const fc_i128 m[3], const fc_i128 n[3]) {
  static const uint8_t program[] FC_ROM = {DOT(0, 3), FC_SUM(3, 3), FC_TIMES(3, 3), FC_TIMES(4, 4), FC_TIMES(5, 5),
                                           FC_TIMES(0, 3), FC_TIMES(1, 4), FC_TIMES(2, 5), 0};
  fc_wide w;
  fc_wide_start(&w);
  push(&w, m);
  push(&w, n);
  fc_wide_run(&w, program);
  return w.sign[6] >= 0 && w.sign[7] >= 0;
}

/* |v| <= r: 2 + 96 bits */
static bool short_as(const int64_t v[3], int64_t r) { return fc_i128_compare(fc_i128_dot(v, v), fc_i128_mul(r, r)) <= 0; }

bool fc_point_near_segment(const int64_t p[3], const int64_t a[3], const int64_t b[3], int64_t r) {
  static const uint8_t program[] FC_ROM = {DOT(3, 3),                    /* 7: |b - a|^2, 2 + 96 bits */
                                           FC_SUM(1, 0), FC_TIMES(6, 6), /* 8: r^2 */
                                           FC_SUM(1, 3), FC_TIMES(7, 8), FC_TIMES(0, 0), FC_TIMES(1, 1), FC_TIMES(2, 2), 0};
  int64_t from_a[3], from_b[3], along[3]; /* 48 bits */
  fc_i128 m[3];
  fc_wide w;
  difference(from_a, p, a);
  difference(from_b, p, b);
  difference(along, b, a);
  if (fc_i128_sign(fc_i128_dot(from_a, along)) <= 0) return short_as(from_a, r);
  if (fc_i128_sign(fc_i128_dot(from_b, along)) >= 0) return short_as(from_b, r);
  cross(m, from_a, along); /* |m| = |along| times the distance of the line: 1 + 96 bits, r^2 |along|^2 has 94 + 98 */
  fc_wide_start(&w);
  push(&w, m);
  push64(&w, along);
  fc_wide_push64(&w, r);
  fc_wide_run(&w, program);
  return w.sign[9] >= 0;
}

/* a + s (b - a) and c + t (d - c) are nearest for s n^2 = (w x v) . n, t n^2 = (w x u) . n, n = u x v, w = c - a. */
bool fc_segments_near_inside(const int64_t a[3], const int64_t b[3], const int64_t c[3], const int64_t d[3], int64_t r) {
  int64_t u[3], v[3], between[3];
  fc_i128 n[3], m[3];
  difference(u, b, a);
  difference(v, d, c);
  difference(between, c, a);
  cross(n, u, v);
  if (fc_i128_sign(n[0]) == 0 && fc_i128_sign(n[1]) == 0 && fc_i128_sign(n[2]) == 0) return false; /* parallel: an end is nearest too */
  cross(m, between, v);
  if (!part_of(m, n)) return false;
  cross(m, between, u);
  return part_of(m, n) && near_along(n, between, r);
}

/* 31 + 31 bits: below 2^63; false when it is 0 */
static bool normal_of(int64_t n[3], int64_t edge[3][3]) {
  fc_cross(edge[0], edge[1], n);
  return fc_vector_bits(n) != 0;
}

bool fc_point_near_face(const int64_t p[3], int64_t vertex[3][3], int64_t edge[3][3], int64_t r) {
  int64_t n[3], from[3];
  fc_i128 m[3];
  uint8_t i;
  if (!normal_of(n, edge)) return false;
  for (i = 0; i < 3; i++) {
    difference(from, p, vertex[i]);
    cross(m, n, edge[i]); /* into the triangle: 63 + 31 bits */
    if (sign_of_dot(m, from) < 0) return false;
  }
  for (i = 0; i < 3; i++) m[i] = fc_i128_from(n[i]);
  return near_along(m, from, r);
}

bool fc_segment_pierces(const int64_t a[3], const int64_t b[3], int64_t vertex[3][3], int64_t edge[3][3]) {
  int64_t n[3], along[3], from[3][3];
  int8_t side, front = 0, back = 0;
  fc_i128 m[3];
  uint8_t i;
  if (!normal_of(n, edge)) return false;
  difference(from[0], a, vertex[0]);
  difference(from[1], b, vertex[0]);
  side = fc_i128_sign(fc_i128_dot(n, from[0])); /* 63 + 48 + 2 bits */
  if (side == 0 || fc_i128_sign(fc_i128_dot(n, from[1])) != -side) return false;
  difference(along, b, a);
  for (i = 0; i < 3; i++) difference(from[i], vertex[i], a);
  for (i = 0; i < 3; i++) { /* on which side of each edge the line goes by */
    cross(m, from[i], from[(i + 1) % 3]);
    side = sign_of_dot(m, along);
    front = (int8_t)(front | (side > 0));
    back = (int8_t)(back | (side < 0));
  }
  return !(front && back);
}
