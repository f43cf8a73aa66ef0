/* rotation.h against long double: sines, turns about axes and between directions, long products, matrices, points. */
#include <cmath>

#include "trials.h"

extern "C" {
#include "fixcast/rotation.h"
}

namespace {

using Real = long double;
const Real pi = acosl(-1.0L), ulp = ldexpl(1, -30);

struct Turn { /* a quaternion of reals */
  Real w, x, y, z;
};

Turn real(const fc_rotation &r) { return {r.w * ulp, r.x * ulp, r.y * ulp, r.z * ulp}; }
Real length(Turn q) { return sqrtl(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z); }
Turn operator*(Turn a, Turn b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}
Turn about(Vec axis, Real angle) {
  Real x = static_cast<Real>(axis.x), y = static_cast<Real>(axis.y), z = static_cast<Real>(axis.z);
  Real s = sinl(angle / 2) / sqrtl(x * x + y * y + z * z);
  return {cosl(angle / 2), x * s, y * s, z * s};
}

void close(const char *what, Turn got, Turn exact, Real bound) {
  Real worst = fmaxl(fmaxl(fabsl(got.w - exact.w), fabsl(got.x - exact.x)),
                     fmaxl(fabsl(got.y - exact.y), fabsl(got.z - exact.z)));
  if (!(worst <= bound))
    wrong("%s: a component is off by %.3Lf * 2^-30 (bound %.3Lf)", what, worst / ulp, bound / ulp);
}
void unit(const fc_rotation &r) {
  Real off = fabsl(length(real(r)) - 1);
  if (!(off <= 2 * ulp)) wrong("length is off by %.3Lf * 2^-30", off / ulp);
}

/* Rodrigues' formula for the unit quaternion of q. */
void matrix_of(Turn q, Real m[3][3]) {
  Real n = length(q);
  q = {q.w / n, q.x / n, q.y / n, q.z / n};
  const Real v[3] = {q.x, q.y, q.z};
  for (int j = 0; j < 3; j++) {
    Real e[3] = {0, 0, 0};
    e[j] = 1;
    /* p + 2 w v x p + 2 v x (v x p) */
    Real c[3] = {v[1] * e[2] - v[2] * e[1], v[2] * e[0] - v[0] * e[2], v[0] * e[1] - v[1] * e[0]};
    Real cc[3] = {v[1] * c[2] - v[2] * c[1], v[2] * c[0] - v[0] * c[2], v[0] * c[1] - v[1] * c[0]};
    for (int i = 0; i < 3; i++) m[i][j] = e[i] + 2 * q.w * c[i] + 2 * cc[i];
  }
}

Vec any_axis(Random &random) {
  for (;;) {
    Vec v = random.direction(30);
    if (fits(v)) return v;
  }
}

fc_rotation any_rotation(Random &random) {
  fc_rotation r;
  fc_vec3 axis = to_core(any_axis(random));
  if (fc_rotation_about(&r, &axis, static_cast<uint16_t>(random.next())) != FC_OK)
    wrong("fc_rotation_about refuses");
  return r;
}

void sine(uint32_t angle) {
  Real exact = sinl(2 * pi * angle / 4294967296.0L), off = fabsl(fc_sin_q30(angle) * ulp - exact);
  if (!(off <= ulp)) wrong("sin(%u / 2^32) is off by %.3Lf * 2^-30", angle, off / ulp);
  if (fc_sin_q30(0u - angle) != -fc_sin_q30(angle)) wrong("sin(-a) != -sin(a) at %u", angle);
  if (fc_sin_q30(0x80000000u - angle) != fc_sin_q30(angle)) wrong("sin(1/2 - a) != sin(a) at %u", angle);
  Real exact_cos = cosl(2 * pi * angle / 4294967296.0L);
  if (!(fabsl(fc_cos_q30(angle) * ulp - exact_cos) <= ulp)) wrong("cos(%u / 2^32)", angle);
}

void sines_of_all_16_bit_angles(Random &random) {
  uint32_t block = static_cast<uint32_t>(random.state) << 24; /* 256 blocks of 256 */
  for (uint32_t i = 0; i < 256; i++) sine(block | i << 16);
  for (int i = 0; i < 2000; i++) sine(block | static_cast<uint32_t>(random.next() & 0xffffff));
  for (uint32_t i = 0; i < 64; i++) /* around the entries of the table and the seams between them */
    for (uint32_t k = 0; k < 5; k++) sine((block << 2) + (i << 25) + k - 2);
}

void quarter_turns_are_exact(Random &) {
  if (fc_sin_q30(0) != 0 || fc_sin_q30(0x40000000u) != FC_ONE_Q30 || fc_sin_q30(0x80000000u) != 0 ||
      fc_sin_q30(0xc0000000u) != -FC_ONE_Q30)
    wrong("a sine of whole quarters");
  fc_rotation r;
  fc_matrix m;
  const fc_vec3 z = {0, 0, 7};
  if (fc_rotation_about(&r, &z, 0x4000) != FC_OK || fc_rotation_matrix(&m, &r) != FC_OK) wrong("refused");
  const int32_t quarter[3][3] = {{0, -FC_ONE_Q30, 0}, {FC_ONE_Q30, 0, 0}, {0, 0, FC_ONE_Q30}};
  for (int i = 0; i < 9; i++)
    if (std::abs(m.row[i / 3][i % 3] - quarter[i / 3][i % 3]) > 1)
      wrong("counter-clockwise quarter about z: entry %d", i);
}

void about_an_axis(Random &random) {
  Vec axis = any_axis(random);
  uint16_t angle =
      static_cast<uint16_t>(random.flip() ? random.next() : static_cast<uint64_t>(random.any_size(6)));
  fc_vec3 a = to_core(axis);
  fc_rotation r;
  int error = fc_rotation_about(&r, &a, angle);
  if (error != FC_OK) wrong("refused: %d", error);
  close("fc_rotation_about", real(r), about(axis, 2 * pi * angle / 65536), 2 * ulp);
  unit(r);
}

/* Takes a to b by the shortest way: exact integers say what |a||b| cos and the axis are. */
void between_directions(Random &random) {
  Vec a = any_axis(random), b = any_axis(random);
  switch (random.within(0, 5)) {
    case 3: { /* next to each other, or to opposite, as long vectors can be: Fibonacci's numbers, |a x b| = 1 */
      int64_t f[3] = {1, 1, 2}, n = random.within(0, 40), k = random.within(0, 2),
              side = random.flip() ? 1 : -1;
      for (; n > 0; n--) f[0] = f[1], f[1] = f[2], f[2] = f[0] + f[1];
      a = b = {0, 0, 0};
      a[static_cast<int>(k)] = f[0], a[static_cast<int>((k + 1) % 3)] = f[1];
      b[static_cast<int>(k)] = side * f[1], b[static_cast<int>((k + 1) % 3)] = side * f[2];
      break;
    }
    case 0: b = a + random.vec(2); break; /* next to it */
    case 1: b = random.vec(2) - a; break; /* next to its opposite */
    case 2: a = random.direction(8), b = a * random.within(1, 100000); break;
    default: break;
  }
  if (is_zero(b) || !fits(b) || !fits(a)) return;
  fc_vec3 from = to_core(a), to = to_core(b);
  fc_rotation r, back;
  if (fc_rotation_between(&r, &from, &to) != FC_OK || fc_rotation_between(&back, &to, &from) != FC_OK)
    wrong("refused");
  unit(r);
  __int128 cx = static_cast<__int128>(a.y) * b.z - static_cast<__int128>(a.z) * b.y,
           cy = static_cast<__int128>(a.z) * b.x - static_cast<__int128>(a.x) * b.z,
           cz = static_cast<__int128>(a.x) * b.y - static_cast<__int128>(a.y) * b.x,
           d = static_cast<__int128>(a.x) * b.x + static_cast<__int128>(a.y) * b.y +
               static_cast<__int128>(a.z) * b.z;
  if (cx == 0 && cy == 0 && cz == 0 && d < 0) { /* opposite: half a turn across */
    Real across =
        (r.x * static_cast<Real>(a.x) + r.y * static_cast<Real>(a.y) + r.z * static_cast<Real>(a.z)) /
        (FC_ONE_Q30 * sqrtl(static_cast<Real>(dot(a, a))));
    if (r.w != 0 || !(fabsl(across) <= 2 * ulp)) wrong("opposites: axis not across, w %d", r.w);
    return;
  }
  if (back.w != r.w || back.x != -r.x || back.y != -r.y || back.z != -r.z)
    wrong("the way back is not the inverse");
  /* the half angle from its tangent's double: atan2 is good where the cosine formula cancels */
  Real c[3] = {static_cast<Real>(cx), static_cast<Real>(cy), static_cast<Real>(cz)};
  Real size = hypotl(hypotl(c[0], c[1]), c[2]), half = atan2l(size, static_cast<Real>(d)) / 2, s = sinl(half);
  Turn exact = {cosl(half), 0, 0, 0};
  if (size > 0) exact = {exact.w, c[0] / size * s, c[1] / size * s, c[2] / size * s};
  close("fc_rotation_between", real(r), exact, ulp + ldexpl(1, -60));
}

/* 2000 products in a row: still of unit length, still a rotation matrix, the angle off by at most 2^-29 a product. */
void long_products_stay_rotations(Random &random) {
  fc_rotation r = FC_ROTATION_NONE;
  Turn exact = {1, 0, 0, 0};
  bool same = random.flip();
  fc_rotation step = any_rotation(random);
  for (int i = 1; i <= 2000; i++) {
    if (!same) step = any_rotation(random);
    if (random.flip()) {
      if (fc_rotation_compose(&r, &step, &r) != FC_OK) wrong("product %d refused", i);
      exact = real(step) * exact;
    } else {
      if (fc_rotation_compose(&r, &r, &step) != FC_OK) wrong("product %d refused", i);
      exact = exact * real(step);
    }
    Real n = length(exact);
    exact = {exact.w / n, exact.x / n, exact.y / n, exact.z / n};
    unit(r);
    /* half the separating angle */
    Turn got = real(r), error = got * Turn{exact.w, -exact.x, -exact.y, -exact.z};
    Real angle = 2 * atan2l(sqrtl(error.x * error.x + error.y * error.y + error.z * error.z), fabsl(error.w));
    if (!(angle <= i * 2 * ulp)) wrong("after %d products %.3Lf * 2^-30 radians off", i, angle / ulp);
  }
  fc_matrix m;
  if (fc_rotation_matrix(&m, &r) != FC_OK) wrong("matrix refused");
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      Real rows = -(i == j);
      for (int k = 0; k < 3; k++) rows += (m.row[i][k] * ulp) * (m.row[j][k] * ulp);
      if (!(fabsl(rows) <= 2 * ulp)) wrong("M M' - I, entry %d %d: %.3Lf * 2^-30", i, j, rows / ulp);
    }
}

void inverse_restores_to_the_bit(Random &random) {
  fc_rotation r = any_rotation(random), back, both;
  if (fc_rotation_invert(&back, &r) != FC_OK || fc_rotation_compose(&both, &back, &r) != FC_OK)
    wrong("refused");
  if (both.w != FC_ONE_Q30 || both.x != 0 || both.y != 0 || both.z != 0)
    wrong("(%d, %d, %d, %d)", both.w, both.x, both.y, both.z);
}

/* Entries within 2^-30, rows and columns orthonormal within 2^-29, points within the stated bound. */
void matrices_and_points(Random &random) {
  fc_rotation r = any_rotation(random);
  for (int64_t i = random.within(0, 5); i > 0; i--) {
    fc_rotation more = any_rotation(random);
    if (fc_rotation_compose(&r, &more, &r) != FC_OK) wrong("refused");
  }
  fc_matrix m;
  Real exact[3][3];
  if (fc_rotation_matrix(&m, &r) != FC_OK) wrong("refused");
  matrix_of(real(r), exact);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      Real off = fabsl(m.row[i][j] * ulp - exact[i][j]), rows = -(i == j), columns = rows;
      if (!(off <= ulp)) wrong("entry %d %d is off by %.3Lf * 2^-30", i, j, off / ulp);
      for (int k = 0; k < 3; k++) {
        rows += (m.row[i][k] * ulp) * (m.row[j][k] * ulp);
        columns += (m.row[k][i] * ulp) * (m.row[k][j] * ulp);
      }
      if (!(fabsl(rows) <= 2 * ulp) || !(fabsl(columns) <= 2 * ulp))
        wrong("M M' - I, entry %d %d: %.3Lf * 2^-30", i, j, fmaxl(fabsl(rows), fabsl(columns)) / ulp);
    }
  int size = static_cast<int>(random.within(1, 30));
  fc_vec3 pivot = to_core(random.vec(size)), from[4], to[4];
  for (fc_vec3 &p : from) p = to_core(random.vec(size));
  int error = fc_rotate_points(to, from, 4, &m, &pivot);
  Real worst_reach = 0;
  for (int n = 0; n < 4; n++) {
    Vec d = from_core(from[n]) - from_core(pivot), p = from_core(pivot), got = from_core(to[n]);
    for (int i = 0; i < 3; i++) {
      Real at = static_cast<Real>(p[i]);
      for (int j = 0; j < 3; j++) at += exact[i][j] * static_cast<Real>(d[j]);
      Real sum = static_cast<Real>(std::llabs(d.x) + std::llabs(d.y) + std::llabs(d.z));
      worst_reach = fmaxl(worst_reach, fabsl(at) - sum * ulp);
      if (error == FC_OK && !(fabsl(static_cast<Real>(got[i]) - at) <= 0.5L + sum * ulp))
        wrong("point %d, axis %d: %lld instead of %.3Lf", n, i, static_cast<long long>(got[i]), at);
    }
  }
  if (error != FC_OK && (error != FC_ERR_COORDINATE || worst_reach < static_cast<Real>(coordinate_max) - 8))
    wrong("points in range refused: %d", error);
  if (error == FC_OK && worst_reach > static_cast<Real>(coordinate_max) + 1)
    wrong("points out of range accepted");
}

void bad_arguments_are_refused(Random &) {
  const fc_vec3 zero = {0, 0, 0}, x = {1, 0, 0}, far = {INT32_C(0x40000001), 0, 0}, low = {INT32_MIN, 0, 0};
  fc_rotation r = {1, 2, 3, 4};
  const fc_rotation none = FC_ROTATION_NONE, shorter = {FC_ONE_Q30 - 16, 0, 0, 0},
                    wild = {INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN};
  fc_matrix m = {};
  fc_vec3 p[2] = {{1, 2, 3}, {FC_COORDINATE_MAX, FC_COORDINATE_MAX, 0}}, q[2] = {{9, 9, 9}, {9, 9, 9}};
  if (fc_rotation_about(nullptr, &x, 0) != FC_ERR_NULL || fc_rotation_about(&r, nullptr, 0) != FC_ERR_NULL ||
      fc_rotation_about(&r, &zero, 0) != FC_ERR_DIRECTION ||
      fc_rotation_about(&r, &far, 0) != FC_ERR_COORDINATE ||
      fc_rotation_about(&r, &low, 0) != FC_ERR_COORDINATE ||
      fc_rotation_between(&r, &x, &zero) != FC_ERR_DIRECTION ||
      fc_rotation_between(&r, &far, &x) != FC_ERR_COORDINATE ||
      fc_rotation_compose(&r, &wild, &none) != FC_ERR_ROTATION ||
      fc_rotation_compose(&r, &none, &shorter) != FC_ERR_ROTATION ||
      fc_rotation_invert(&r, &wild) != FC_ERR_ROTATION ||
      fc_rotation_matrix(&m, &shorter) != FC_ERR_ROTATION || r.w != 1 || r.x != 2 || r.y != 3 || r.z != 4 ||
      m.row[0][0] != 0)
    wrong("a bad argument was taken, or something was written");
  fc_rotation eighth;
  const fc_vec3 z = {0, 0, 1};
  if (fc_rotation_about(&eighth, &z, 0x2000) != FC_OK || fc_rotation_matrix(&m, &eighth) != FC_OK)
    wrong("refused");
  if (fc_rotate_points(q, p, 2, &m, nullptr) != FC_ERR_COORDINATE || q[0].x != 9)
    wrong("a point left the range, or was written");
  if (fc_rotate_points(q, &low, 1, &m, nullptr) != FC_ERR_COORDINATE) wrong("a point out of range");
  m.row[2][1] = INT32_MIN;
  if (fc_rotate_points(q, p, 1, &m, nullptr) != FC_ERR_ROTATION) wrong("a matrix beyond 1");
}

} // namespace

int main(int argc, char **argv) {
  return run_trials(argc, argv,
                    {{"bad_arguments_are_refused", 1, bad_arguments_are_refused},
                     {"sines_of_all_16_bit_angles", 256, sines_of_all_16_bit_angles},
                     {"quarter_turns_are_exact", 1, quarter_turns_are_exact},
                     {"about_an_axis", 100000, about_an_axis},
                     {"between_directions", 100000, between_directions},
                     {"long_products_stay_rotations", 60, long_products_stay_rotations},
                     {"inverse_restores_to_the_bit", 100000, inverse_restores_to_the_bit},
                     {"matrices_and_points", 100000, matrices_and_points}});
}
