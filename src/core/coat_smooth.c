/* Smooth shading by fast forms: a normal that is affine in the pixel, and one root for two lengths. */
#include "coat.h"

static FC_COLD bool fits(const fc_scan *scan, const void *data) {
  (void)scan;
  (void)data;
  return true; /* shapes without vertices keep their normals */
}

/* A vertex's normal in camera axes: Q14 within 2^-12. */
static FC_COLD void turned_normal(const fc_scan *scan, uint16_t vertex, int32_t n[3]) {
  const fc_view *view = &scan->frame->view;
  fc_normal normal;
  uint8_t i;
  FC_READ_ONE(&normal, scan->at->group.shapes.normals + vertex);
  for (i = 0; i < 3; i++) {
    /* unit rows in Q14 and 16 bits: sums below sqrt(3) 2^29 */
    const int32_t sum = fc_floor_shift32(view->row[i][0], 16) * normal.x + fc_floor_shift32(view->row[i][1], 16) * normal.y +
                        fc_floor_shift32(view->row[i][2], 16) * normal.z;
    n[i] = fc_floor_shift32(sum + 0x2000, 14);
  }
}

/* The sign of N.n in the whole tile, n the flat normal: 0 when it is not the same. */
static FC_COLD int8_t side_of(const fc_coat *coat) {
  const fc_coat_smooth *smooth = &coat->smooth;
  /* 30 bits and 30 bits, and as much a step at most: sums of three below 2^62 */
  const int64_t at = fc_to_i64(fc_dot32(smooth->at, coat->planar->unit));
  const int64_t right = fc_to_i64(fc_dot32(smooth->dx, coat->planar->unit)) * (coat->scan->columns - 1);
  const int64_t down = fc_to_i64(fc_dot32(smooth->dy, coat->planar->unit)) * (coat->scan->rows - 1);
  const int64_t low = at + (right < 0 ? right : 0) + (down < 0 ? down : 0), high = at + (right > 0 ? right : 0) + (down > 0 ? down : 0);
  const int64_t margin = INT64_C(1) << 48; /* N within 2^16, as its cuts are */
  return (int8_t)((low > margin) - (high < -margin));
}

/*
 * N = sum of n_i w_i, w_i the barycentric weights times anything: affine in the pixel, no division. In 30 bits over the tile, of which pixels use
 * the upper 14.
 */
static FC_COLD void planar_start(fc_coat *coat, const void *data) {
  const fc_scan *scan = coat->scan;
  fc_coat_smooth *smooth = &coat->smooth;
  fc_coat_weights w;
  int32_t n[3][3];
  uint32_t most = 0;
  uint8_t i, j, shift;
  int8_t side;
  (void)data;
  if (!coat->lit || fc_kind_of(scan->at)->weights == NULL || scan->at->group.shapes.normals == NULL) return;
  smooth->how = FC_SMOOTH_SLOW;
  coat->cosines = true;
  if (!fc_coat_weights_set(scan, &w)) return;
  for (i = 0; i < 3; i++) turned_normal(scan, w.vertex[i], n[i]);
  for (j = 0; j < 3; j++) {
    int32_t right, down;
    smooth->at[j] = smooth->dx[j] = smooth->dy[j] = 0;
    for (i = 0; i < 3; i++) {
      /* weights below 2^29, normals below 2^16, over 2^17: sums of three below 2^29.6 */
      smooth->at[j] += fc_smulhi32(w.at[i], (uint32_t)n[i][j] << 15);
      smooth->dx[j] += fc_smulhi32(w.dx[i], (uint32_t)n[i][j] << 15);
      smooth->dy[j] += fc_smulhi32(w.dy[i], (uint32_t)n[i][j] << 15);
      if (n[i][j] < 0) { /* what is negative was taken modulo 2^32 */
        smooth->at[j] -= w.at[i];
        smooth->dx[j] -= w.dx[i];
        smooth->dy[j] -= w.dy[i];
      }
    }
    right = smooth->dx[j] * (scan->columns - 1);
    down = smooth->dy[j] * (scan->rows - 1);
    most |= fc_abs32(smooth->at[j]) | fc_abs32(smooth->at[j] + right) | fc_abs32(smooth->at[j] + down) |
            fc_abs32(smooth->at[j] + right + down);
  }
  /* floors of three, and three a step: below 2^12 in all where steps are few; 2^16 after the shift */
  shift = fc_clz32(most | 1);
  if (shift < 2 || shift > 8 || scan->columns > 1024) return;
  shift = (uint8_t)(shift - 2);
  for (j = 0; j < 3; j++) {
    smooth->at[j] *= INT32_C(1) << shift;
    smooth->dx[j] *= INT32_C(1) << shift;
    smooth->dy[j] *= INT32_C(1) << shift;
  }
  side = side_of(coat);
  if (side == 0) return;
  for (j = 0; side > 0 && j < 3; j++) { /* towards the eye */
    smooth->at[j] = -smooth->at[j];
    smooth->dx[j] = -smooth->dx[j];
    smooth->dy[j] = -smooth->dy[j];
  }
  smooth->how = FC_SMOOTH_FORMS;
}

/* N and W = (n.D)(P - L) along a row. */
typedef struct smooth_row {
  int32_t n[3], w[3];
} smooth_row;

/*
 * Cosines of up to 32 pixels, Q16: -N.W / (|N| |W|), N turned against W's n. Components have 14 bits, so |N|^2 and |W|^2 are below 2^30. Returns those
 * that are too short: from 2^22 on cuts cost the cosine less than sqrt(3) 2^-11 / sqrt(3) = 2^-11 each, at N's and W's usual lengths 2^-13.
 */
static FC_HOT uint32_t cosines(const fc_coat_smooth *smooth, const fc_sheaf *sheaf, smooth_row at, uint8_t count, uint32_t *cosine) {
  const int32_t ax = smooth->dx[0], ay = smooth->dx[1], az = smooth->dx[2], bx = sheaf->dx[0], by = sheaf->dx[1], bz = sheaf->dx[2];
  const uint32_t *end = cosine + count;
  uint32_t faint = 0, bit = 1;
  do {
    const int32_t nx = fc_floor_shift32(at.n[0], 16), ny = fc_floor_shift32(at.n[1], 16), nz = fc_floor_shift32(at.n[2], 16);
    const int32_t wx = fc_floor_shift32(at.w[0], 16), wy = fc_floor_shift32(at.w[1], 16), wz = fc_floor_shift32(at.w[2], 16);
    uint32_t nn = (uint32_t)(nx * nx + ny * ny + nz * nz), ww = (uint32_t)(wx * wx + wy * wy + wz * wz), product, c = 0;
    int32_t dot = nx * wx + ny * wy + nz * wz;
    if (dot < 0 && ((nn | 1) >> 22 == 0 || ww >> 22 == 0)) faint |= bit;
    if (dot < 0 && nn >= 64 && ww >= 64) {
      uint32_t along = (uint32_t)-dot, down = 14;
      while (nn < UINT32_C(1) << 28) {
        nn <<= 2;
        along <<= 1;
      }
      while (ww < UINT32_C(1) << 28) {
        ww <<= 2;
        along <<= 1;
      }
      product = (nn >> 14) * (ww >> 14); /* 2^28 .. 2^32 - 1 */
      if (product < UINT32_C(1) << 30) {
        product <<= 2;
        down--;
      }
      c = (along >> 15) * fc_rsqrt_q15(product) >> down; /* 15 + 17 bits: the cosine is at most 1 and little more */
      if (c > 65536) c = 65536;
    }
    *cosine = c;
    bit <<= 1;
    at.n[0] += ax;
    at.n[1] += ay;
    at.n[2] += az;
    at.w[0] += bx;
    at.w[1] += by;
    at.w[2] += bz;
  } while (++cosine != end);
  return faint;
}

static FC_NOINLINE void planar_cosines(fc_coat *coat, const void *data) {
  const fc_coat_smooth *smooth = &coat->smooth;
  const fc_sheaf *w = &coat->planar->w;
  fc_coat_run *run = &coat->run;
  smooth_row at;
  uint8_t i;
  (void)data;
  if (smooth->how == FC_SMOOTH_NOT) return;
  if (smooth->how == FC_SMOOTH_SLOW) {
    run->slow = run->bits;
    return;
  }
  for (i = 0; i < 3; i++) {
    at.n[i] = smooth->at[i] + smooth->dx[i] * run->column + smooth->dy[i] * run->row;
    at.w[i] = w->at[i] + w->dx[i] * run->column + w->dy[i] * run->row;
  }
  run->slow |= cosines(smooth, w, at, run->count, run->cosine);
}

const fc_coat_layer fc_coat_layer_smooth FC_ROM = {&fc_coat_layers, FC_COAT_TURNS, fits, planar_start, planar_cosines, NULL, NULL, NULL, NULL};
