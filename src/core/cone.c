/* Coefficients of a cone's quadratic form. */
#include "cone.h"

#include "quick.h"

/* f = W' M W with M = C C' - (|C|^2 - r^2) I: on the diagonal r^2 less the squares of the other two. */
static FC_COLD void matrix(const int64_t c[3], int64_t r, int64_t m[3][3]) {
  /* 31-bit factors: squares below 2^62, sums of two below 2^63 */
  int64_t square[3], rr = fc_smul32((int32_t)r, (int32_t)r);
  uint8_t i;
  for (i = 0; i < 3; i++) square[i] = fc_smul32((int32_t)c[i], (int32_t)c[i]);
  for (i = 0; i < 3; i++) {
    uint8_t j = (uint8_t)(i == 2 ? 0 : i + 1), k = (uint8_t)(i == 0 ? 2 : i - 1);
    m[i][i] = rr - (square[j] + square[k]);
    m[i][j] = m[j][i] = fc_smul32((int32_t)c[i], (int32_t)c[j]);
  }
}

/* M W / 2^32: entries below 2^62, W within 2^30: each term below 2^60, the sum below 2^62; floors: up to 3 short. */
static FC_COLD void apply(const int64_t m[3][3], const int32_t w[3], int64_t u[3]) {
  uint8_t i, j;
  for (i = 0; i < 3; i++) {
    u[i] = 0;
    for (j = 0; j < 3; j++)
      if (w[j] != 0) u[i] += fc_smul64hi(m[i][j], w[j]); /* primary rays move along one axis */
  }
}

/* W.U / 2^32: terms below 2^60. */
static FC_COLD int64_t dot(const int32_t w[3], const int64_t u[3]) {
  int64_t sum = 0;
  uint8_t i;
  for (i = 0; i < 3; i++)
    if (w[i] != 0) sum += fc_smul64hi(u[i], w[i]);
  return sum;
}

FC_COLD void fc_cone_setup(fc_cone *cone, const int64_t center[3], int64_t radius, uint8_t center_error, const fc_sheaf *sheaf,
                           uint16_t columns, uint16_t rows) {
  int64_t m[3][3], u[3], ux[3], uy[3], xx, yy, steps = (int64_t)columns + rows + 1;
  uint64_t largest = 0, center_reach = 0;
  uint8_t i, j, s;
  matrix(center, radius, m);
  for (i = 0; i < 3; i++) {
    for (j = i; j < 3; j++) largest |= fc_abs64(m[i][j]);
    center_reach += fc_abs64(center[i]);
  }
  if (largest >> 62) {
    /* only with lights: a quarter of it */
    for (i = 0; i < 3; i++)
      for (j = 0; j < 3; j++) m[i][j] = fc_floor_shift64(m[i][j], 2);
    s = 0;
    cone->scale = -2;
  } else {
    s = largest == 0 ? 0 : (uint8_t)((fc_clz64(largest) - 2) & ~1);
    for (i = 0; i < 3; i++)
      for (j = 0; j < 3; j++) m[i][j] = fc_to_i64((uint64_t)m[i][j] << s);
    cone->scale = (int8_t)s;
  }
  apply((const int64_t(*)[3])m, sheaf->at, u);
  apply((const int64_t(*)[3])m, sheaf->dx, ux);
  apply((const int64_t(*)[3])m, sheaf->dy, uy);
  xx = dot(sheaf->dx, ux);
  yy = dot(sheaf->dy, uy);
  cone->f = dot(sheaf->at, u);
  cone->dx = 2 * dot(sheaf->dx, u) + xx;
  cone->dxx = 2 * xx;
  cone->dy = 2 * dot(sheaf->dy, u) + yy;
  cone->dyy = 2 * yy;
  cone->dxy = 2 * dot(sheaf->dx, uy);
  /* A coefficient is short by at most 2 (3 + 3 3 / 4) + that of xx, below 20; i columns and j rows add up i^2 / 2 + j^2 / 2
   * + i j + i + j + 1 of them at most. An error e of W: 2 |M W|_1 e + |M| e^2, below 2 * 3 * 2^62 e / 2^32 and small.
   * An error of C: an entry is off by 4 |C|_1 + 8, times |W|_1^2 / 2^64 < 1. */
  cone->error = 20 * steps * steps + 8;
  if (sheaf->error != 0) cone->error += (int64_t)(sheaf->error + 1) << 33;
  if (center_error != 0) cone->error += (int64_t)((center_reach + 8) << (s + 2));
}
