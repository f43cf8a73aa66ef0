/* Smooth shading by fast forms: a normal that is affine in the pixel, and one root for two lengths. */
#include "coat.h"

#include "facet.h"
#include "mesh.h"

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

/*
 * A triangle's normals at its vertices, and on which side of it they lie: 1 where `unit` points, -1, 0: not all on one side for certain, or
 * not of unit length (2^-1 .. 2^0.05), as rays will see. 2^-5 off the plane, so that weights below 0 by 2^-11 do no harm at its edges.
 */
static FC_COLD int8_t normals_set(const fc_scan *scan, const uint16_t vertex[3], const int32_t unit[3], int32_t n[3][3]) {
  int32_t u[3];
  uint8_t i, j;
  int8_t side = 0;
  for (j = 0; j < 3; j++) u[j] = fc_floor_shift32(unit[j], 16);
  for (i = 0; i < 3; i++) {
    uint32_t square;
    int32_t along;
    turned_normal(scan, vertex[i], n[i]);
    if ((fc_abs32(n[i][0]) | fc_abs32(n[i][1]) | fc_abs32(n[i][2])) >> 15 != 0) return 0;
    /* 15 bits each */
    square = (uint32_t)(n[i][0] * n[i][0]) + (uint32_t)(n[i][1] * n[i][1]) + (uint32_t)(n[i][2] * n[i][2]);
    if (square < UINT32_C(0x4000000) || square > UINT32_C(0x11000000)) return 0;
    along = n[i][0] * u[0] + n[i][1] * u[1] + n[i][2] * u[2]; /* |n| and |u| are at most 2^14.05: below 2^28.2, and partial sums below 2^31 */
    if (fc_abs32(along) >> 23 == 0 || (i > 0 && (along > 0) != (side > 0))) return 0;
    side = along > 0 ? 1 : -1;
  }
  return side;
}

/* A triangle of up to FC_SMALL pixels a side as the screen shows it. */
typedef struct screen_corners {
  int32_t x[3], y[3]; /* from the tile's first pixel, in 2^-16 pixels: below 2^22, within 1.2 */
  uint32_t near[3];   /* 1 / z times anything, 15 bits, within 2^-14 of the greatest */
  uint16_t vertex[3];
} screen_corners;

/* False when the triangle is larger, or not in front of the eye as a whole. */
static FC_COLD bool corners_set(const fc_scan *scan, screen_corners *c) {
  const fc_group *group = &scan->at->group;
  const fc_placed_mesh *mesh = group->memory;
  const uint8_t fraction = mesh->fraction, down = (uint8_t)(fraction - 16);
  fc_triangle copy;
  const fc_triangle *triangle = fc_triangle_at(&group->shapes, scan->index, &copy);
  uint32_t wide = 0;
  int32_t left, top;
  uint8_t exponent[3], i, high = 0;
  if (fraction < 20) return false; /* FC_CORNER_ERROR would tell */
  /* as fc_small_edges has them, with the half that makes floors nearest */
  left = (2 * (int32_t)scan->x + 1 - scan->frame->width) * (INT32_C(1) << (fraction - 1)) - (INT32_C(1) << (down - 1));
  top = (2 * (int32_t)scan->y + 1 - scan->frame->height) * (INT32_C(1) << (fraction - 1)) - (INT32_C(1) << (down - 1));
  for (i = 0; i < 3; i++) {
    const uint16_t vertex = triangle->vertex[i];
    const fc_placed_vertex *v = fc_mesh_vertices(mesh) + vertex;
    uint32_t mantissa;
    if (v->seen == 0) return false;
    c->vertex[i] = vertex;
    mantissa = fc_seen_mantissa(v->seen);
    exponent[i] = fc_seen_exponent(v->seen);
    c->x[i] = fc_floor_shift32(fc_mesh_screen(v->p[0], exponent[i] - mesh->shift, mantissa) - left, down);
    c->y[i] = fc_floor_shift32(fc_mesh_screen(-v->p[1], exponent[i] - mesh->shift, mantissa) - top, down);
    c->near[i] = mantissa >> 17;
    if (exponent[i] > high) high = exponent[i];
    wide |= fc_abs32(c->x[i]) | fc_abs32(c->y[i]);
  }
  for (i = 0; i < 3; i++) c->near[i] = high - exponent[i] > 14 ? 0 : c->near[i] >> (high - exponent[i]);
  return wide >> 22 == 0;
}

/*
 * N = sum of n_i e_i / z_i: e_i, the cross product of what leads from the pixel to the two other corners, is affine, and e_i / z_i is vertex
 * i's barycentric weight times anything. The e_i add up to the area (twice the triangle's), so N within it is at most the area times the
 * longest n_i / z_i. e_i is within 5.5 sides 2^-16 and a step within 2^-15 of the longest side, of which there are a side's pixels both ways:
 * with a height of at least a pixel and an eighth of the side N is off by 2^-10.5 of what the normals differ by, where the triangle is well
 * shaped by 2^-12. False when the triangle is not like that, or its normals do not lie to one side of it for certain.
 */
static FC_COLD bool set_small(fc_coat_smooth *smooth, const fc_scan *scan, const int32_t unit[3]) {
  screen_corners c;
  int32_t at[3], dx[3], dy[3], n[3][3], m[3][3], area = 0;
  uint32_t extent = 0;
  uint8_t i, j, shift, cut;
  int8_t side;
  bool turn;
  if (!corners_set(scan, &c)) return false;
  for (i = 0; i < 3; i++) {
    const uint8_t a = (uint8_t)(i == 2 ? 0 : i + 1), b = (uint8_t)(i == 0 ? 2 : i - 1);
    dx[i] = c.y[a] - c.y[b];
    dy[i] = c.x[b] - c.x[a];
    at[i] = fc_product16(c.x[a], c.y[b]) - fc_product16(c.x[b], c.y[a]); /* 22 and 22 bits, over 2^16 */
    extent |= fc_abs32(dx[i]) | fc_abs32(dy[i]);
    area += at[i];
  }
  turn = area < 0;
  if (turn) area = -area;
  /* a side below 32 pixels, so the area is below 2^27 and at least 2^16 */
  if (extent >> 21 != 0 || (uint32_t)area < extent || area >> 16 == 0 || 8 * (uint32_t)area < extent * (extent >> 16)) return false;
  side = normals_set(scan, c.vertex, unit, n);
  if (side == 0) return false;
  for (i = 0; i < 3; i++) {
    /* hardly longer than 1, so at most 2^14.05 */
    for (j = 0; j < 3; j++) m[i][j] = fc_floor_shift32(n[i][j] * (int32_t)c.near[i] + 0x4000, 15);
  }
  if (side > 0) turn = !turn; /* towards the eye: `unit` points away from it */
  /* 16 bits of area: N is below 2^30.05 within the triangle; without, it may wrap. 15 bits of the steps, whose sum is 0: below 2^30.1 */
  shift = (uint8_t)(16 - fc_clz32((uint32_t)area));
  cut = (uint8_t)(17 - fc_clz32(extent));
  for (j = 0; j < 3; j++) {
    const int32_t half = INT32_C(1) << (cut - 1);
    uint32_t sum = 0;
    int32_t right = 0, down = 0;
    for (i = 0; i < 3; i++) {
      sum += (uint32_t)fc_floor_shift32(at[i], shift) * (uint32_t)m[i][j];
      right += fc_floor_shift32(dx[i] + half, cut) * m[i][j];
      down += fc_floor_shift32(dy[i] + half, cut) * m[i][j];
    }
    if (shift >= cut) {
      right = fc_floor_shift32(right, (uint8_t)(shift - cut));
      down = fc_floor_shift32(down, (uint8_t)(shift - cut));
    } else { /* by 1: the area has as many bits as the extent at least */
      right = fc_to_i32((uint32_t)right << (cut - shift));
      down = fc_to_i32((uint32_t)down << (cut - shift));
    }
    smooth->at[j] = fc_to_i32(turn ? 0 - sum : sum);
    smooth->dx[j] = turn ? fc_to_i32(0 - (uint32_t)right) : right;
    smooth->dy[j] = turn ? fc_to_i32(0 - (uint32_t)down) : down;
  }
  return true;
}

/*
 * N = sum of n_i w_i, w_i the barycentric weights times anything: affine in the pixel, no division. In 29 bits where the weights are not below
 * 0, as within the triangle, of which pixels use the upper 13; without, it may wrap. False when that tells too little.
 */
static FC_COLD bool set_large(fc_coat_smooth *smooth, const fc_scan *scan, const int32_t unit[3]) {
  fc_coat_weights w;
  int32_t n[3][3];
  uint32_t at = 0, right = 0, down = 0, most;
  uint8_t i, j, shift;
  int8_t side;
  if (!fc_coat_weights_set(scan, &w)) return false;
  side = normals_set(scan, w.vertex, unit, n);
  if (side == 0) return false;
  for (i = 0; i < 3; i++) { /* two's complement: weights are below 2^29 at the tile's corners, sums of three below 2^31 there */
    at += (uint32_t)w.at[i];
    right += (uint32_t)w.dx[i] * (scan->columns - 1u);
    down += (uint32_t)w.dy[i] * (scan->rows - 1u);
  }
  most = fc_abs32(fc_to_i32(at)) | fc_abs32(fc_to_i32(at + right)) | fc_abs32(fc_to_i32(at + down)) | fc_abs32(fc_to_i32(at + right + down));
  /* N is at most the sum of the weights times 2^14.05 / 2^17: below 2^29.05 when that is 32 bits; of 24 and less too few are left */
  shift = fc_clz32(most | 1);
  if (shift > 8) return false;
  /* floors of three, and three a step, may reach a unit of what pixels use */
  if ((3 * ((uint32_t)scan->columns + scan->rows) + 3) << shift > UINT32_C(0x10000)) return false;
  for (j = 0; j < 3; j++) {
    uint32_t form[3] = {0, 0, 0};
    for (i = 0; i < 3; i++) {
      const uint32_t factor = (uint32_t)n[i][j] << 15;
      /* weights below 2^29, normals below 2^15, over 2^17 */
      form[0] += (uint32_t)fc_smulhi32(w.at[i], factor);
      form[1] += (uint32_t)fc_smulhi32(w.dx[i], factor);
      form[2] += (uint32_t)fc_smulhi32(w.dy[i], factor);
      if (n[i][j] < 0) { /* what is negative was taken modulo 2^32 */
        form[0] -= (uint32_t)w.at[i];
        form[1] -= (uint32_t)w.dx[i];
        form[2] -= (uint32_t)w.dy[i];
      }
    }
    for (i = 0; i < 3; i++) form[i] = (side > 0 ? 0 - form[i] : form[i]) << shift; /* towards the eye */
    smooth->at[j] = fc_to_i32(form[0]);
    smooth->dx[j] = fc_to_i32(form[1]);
    smooth->dy[j] = fc_to_i32(form[2]);
  }
  return true;
}

/* How the normals of a lit tile are to be had: FC_SMOOTH_... */
static FC_COLD void forms_set(fc_coat_smooth *smooth, const fc_scan *scan, const fc_planar *on) {
  smooth->how = FC_SMOOTH_NOT;
  if (fc_kind_of(scan->at)->weights == NULL || scan->at->group.shapes.normals == NULL) return;
  smooth->how = set_small(smooth, scan, on->unit) || set_large(smooth, scan, on->unit) ? FC_SMOOTH_FORMS : FC_SMOOTH_SLOW;
}

static FC_COLD void planar_start(fc_coat *coat, const void *data) {
  (void)data;
  if (!coat->lit) return;
  forms_set(&coat->smooth, coat->scan, coat->planar);
  if (coat->smooth.how != FC_SMOOTH_NOT) coat->cosines = true;
}

FC_INLINE int32_t upper(uint32_t v) { return fc_floor_shift32(fc_to_i32(v), 16); }

/* N and W = (n.D)(P - L) along a row, and their steps. */
typedef struct smooth_row {
  uint32_t n[3], w[3], dn[3], dw[3]; /* two's complement: a step past the row wraps */
} smooth_row;

/* At a column of a row. */
FC_INLINE void row_start(smooth_row *row, const fc_coat_smooth *smooth, const fc_sheaf *w, uint16_t y, uint16_t column) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    row->dn[i] = (uint32_t)smooth->dx[i];
    row->dw[i] = (uint32_t)w->dx[i];
    /* rounded once they are cut */
    row->n[i] = (uint32_t)smooth->at[i] + 0x8000u + row->dn[i] * column + (uint32_t)smooth->dy[i] * y;
    row->w[i] = (uint32_t)w->at[i] + 0x8000u + row->dw[i] * column + (uint32_t)w->dy[i] * y;
  }
}

/* One column on. */
FC_INLINE void row_next(smooth_row *row) {
  row->n[0] += row->dn[0];
  row->n[1] += row->dn[1];
  row->n[2] += row->dn[2];
  row->w[0] += row->dw[0];
  row->w[1] += row->dw[1];
  row->w[2] += row->dw[2];
}

#define FAINT UINT32_MAX

/*
 * The cosine in Q16: -N.W / (|N| |W|), N turned against W's n. |N|^2 is below 3 2^26, or 2^28.2 of small triangles, |W|^2 below 3 2^26 and
 * little more. FAINT where they are too short: from 2^22 on rounding costs the cosine less than sqrt(3) / 2 2^-11 = 2^-11.2 each, at N's and
 * W's usual lengths 2^-13, and rounded squares 2^-12 each, 2^-15 at usual lengths.
 */
FC_INLINE uint32_t cosine_of(uint32_t n0, uint32_t n1, uint32_t n2, uint32_t w0, uint32_t w1, uint32_t w2) {
  const int32_t nx = upper(n0), ny = upper(n1), nz = upper(n2), wx = upper(w0), wy = upper(w1), wz = upper(w2);
  const int32_t along = -(nx * wx + ny * wy + nz * wz);
  uint32_t nn, ww, product, down = 13, c;
  if (along <= 0) return 0;
  nn = (uint32_t)(nx * nx + ny * ny + nz * nz);
  ww = (uint32_t)(wx * wx + wy * wy + wz * wz);
  if (nn >> 22 == 0 || ww >> 22 == 0) return FAINT;
  product = ((nn + 0x800) >> 12) * ((ww + 0x800) >> 12); /* 2^16.2 and 2^15.6 at most, 2^10 at least */
#ifdef FC_SHORT_MULTIPLIER
  while (product < UINT32_C(1) << 30) {
    product <<= 2;
    down--;
  }
#else
  {
    const uint8_t up = fc_clz32(product) & 30;
    product <<= up;
    down -= up >> 1;
  }
#endif
  c = ((uint32_t)along >> down) * fc_rsqrt_q15(product) >> 14; /* 15 + 16 bits: the cosine is at most 1 and little more */
  return c > 65536 ? 65536 : c;
}

/* Cosines of up to 32 pixels; the bits of those that are too short. */
static FC_HOT uint32_t cosines(smooth_row at, uint32_t bits, uint32_t *cosine) {
  uint32_t faint = 0, bit = 1;
  for (; bits != 0; bits >>= 1, bit <<= 1, cosine++) {
    if (bits & 1) {
      const uint32_t c = cosine_of(at.n[0], at.n[1], at.n[2], at.w[0], at.w[1], at.w[2]);
      *cosine = c == FAINT ? 0 : c;
      if (c == FAINT) faint |= bit;
    } else {
      *cosine = 0; /* what lies between is read, and not shown */
    }
    row_next(&at);
  }
  return faint;
}

static FC_NOINLINE void planar_cosines(fc_coat *coat, const void *data) {
  const fc_coat_smooth *smooth = &coat->smooth;
  fc_coat_run *run = &coat->run;
  smooth_row at;
  (void)data;
  if (smooth->how == FC_SMOOTH_NOT) return;
  if (smooth->how == FC_SMOOTH_SLOW) {
    run->slow = run->bits;
    return;
  }
  row_start(&at, smooth, &coat->planar->w, run->row, run->column);
  run->slow |= cosines(at, run->lit, run->cosine);
}

/* ---- a material that is smooth and nothing else: no cosines are kept ---- */

/* Colours up to 32 pixels from a column of a row on; the bits of those that are left to rays. */
static FC_HOT uint32_t colour_run(const fc_scan *scan, const fc_coat_smooth *smooth, const fc_sheaf *w, uint16_t row, uint16_t column,
                                  uint32_t bits) {
  const uint32_t all = bits;
  const uint8_t pixel_bytes = scan->pixel_bytes;
  uint8_t *to = fc_scan_pixel(scan, row, column);
  uint32_t faint = 0;
  smooth_row at;
  row_start(&at, smooth, w, row, column);
  do {
    if (bits & 1) {
      const uint32_t c = cosine_of(at.n[0], at.n[1], at.n[2], at.w[0], at.w[1], at.w[2]);
      if (c == FAINT)
        faint |= UINT32_C(1) << (fc_clz32(bits) - fc_clz32(all)); /* the last bit stays the last */
      else
        fc_tint_put(&scan->tint, c, to);
    }
    row_next(&at);
    to += pixel_bytes;
    bits >>= 1;
  } while (bits != 0);
  return faint;
}

static FC_COLD void planar(fc_scan *scan, const int64_t normal[3], fc_i128 k, const int64_t *hull, uint8_t corners) {
  const fc_planar *on;
  const fc_cosine *g;
  fc_coat_smooth smooth;
  uint16_t row, column, layers;
  uint8_t word;
  FC_READ_ONE(&layers, &scan->frame->scene.materials[scan->form->material].layer_count);
  if (layers != 1) {
    fc_coat_planar(scan, normal, k, hull, corners);
    return;
  }
  if (fc_planar_reach(scan, normal, k, hull, corners, &on, &g) != FC_PLANAR_LIT) return;
  forms_set(&smooth, scan, on);
  if (smooth.how == FC_SMOOTH_NOT) {
    fc_planar_colour(scan, on, g);
    return;
  }
  for (row = scan->first_row; row <= scan->last_row; row++) {
    for (word = 0; word < scan->words; word++) {
      uint32_t bits = scan->mask[row * scan->words + word], faint;
      if (bits == 0) continue;
      for (column = (uint16_t)(32 * word); !(bits & 1); bits >>= 1) column++;
      if (smooth.how == FC_SMOOTH_FORMS) {
        faint = colour_run(scan, &smooth, &on->w, row, column, bits);
        if (bits != faint) fc_scan_lit(scan, row, column, bits & ~faint);
      } else {
        faint = bits;
      }
      if (faint != 0) fc_scan_shade_slowly(scan, row, column, faint);
    }
  }
}

static const fc_coat_kind alone FC_ROM = {fc_coat_fits, planar, fc_coat_sphere};

const fc_coat_layer fc_coat_layer_smooth FC_ROM = {&alone, FC_COAT_TURNS, fits, planar_start, planar_cosines, NULL, NULL, NULL, NULL};
