/*
 * A triangle's shadow on a plane: forms that are affine in the pixel.
 *
 * With vertices A, B, C seen from the light, the line from it along W meets the triangle iff W.(A x B), W.(B x C) and W.(C x A) have
 * the sign of A.(B x C), or are 0. On a receiver n.p = k with the light at height h > 0 above it, W.n > 0 at every pixel. A
 * triangle wholly on the light's side is met before the receiver, one wholly on the other side after it; otherwise
 * a fourth form tells: the plane through the light and the line in which the two planes meet.
 */
#include "facet.h"
#include "planar.h"
#include "scan_kinds.h"
#include "triangle_shadow.h"

typedef struct shadow_form {
  int64_t at, dx, dy;
  int64_t error;
} shadow_form;

static uint8_t next(uint8_t i) { return i == 2 ? 0 : (uint8_t)(i + 1); }

static void cross(const int32_t a[3], const int32_t b[3], int64_t r[3]) {
  /* 31 + 31 bits, two products: below 2^63 */
  r[0] = fc_smul32(a[1], b[2]) - fc_smul32(a[2], b[1]);
  r[1] = fc_smul32(a[2], b[0]) - fc_smul32(a[0], b[2]);
  r[2] = fc_smul32(a[0], b[1]) - fc_smul32(a[1], b[0]);
}

/* floor(v / 2^s) within 2^30; s. */
static uint8_t shrink(const int64_t v[3], int32_t r[3]) {
  uint8_t bits = fc_vector_bits(v), s = bits > 30 ? (uint8_t)(bits - 30) : 0, i;
  for (i = 0; i < 3; i++) r[i] = (int32_t)fc_floor_shift64(v[i], s);
  return s;
}

/* 30 + 31 bits, three terms: below 2^63. */
static int64_t dot(const int32_t a[3], const int32_t b[3]) {
  return fc_smul32(a[0], b[0]) + fc_smul32(a[1], b[1]) + fc_smul32(a[2], b[2]);
}

static int64_t norm1(const int32_t a[3]) { return (int64_t)fc_abs32(a[0]) + fc_abs32(a[1]) + fc_abs32(a[2]); }

/* sign W.n for n off by less than `off` a component. */
static void set_form(const fc_sheaf *w, const int32_t n[3], int8_t sign, uint32_t off, shadow_form *form) {
  /* Components of W and n within 2^30: below 2^62. W is off by e: |n|_1 e; n by f: |W|_1 f; both: 3 e f. */
  form->at = dot(n, w->at);
  form->dx = dot(n, w->dx);
  form->dy = dot(n, w->dy);
  if (sign < 0) {
    form->at = -form->at;
    form->dx = -form->dx;
    form->dy = -form->dy;
  }
  form->error = (int64_t)fc_mul32((uint32_t)norm1(n), w->error);
  if (off != 0) form->error += (int64_t)fc_mul32((UINT32_C(3) << 30) + 3 * w->error, off);
}

/* floor(v / 2^s), s below 63, where it fits 32 bits. */
static int32_t cut_down(int64_t v, uint8_t s) {
  uint32_t high = (uint32_t)((uint64_t)v >> 32);
  if (s >= 32) return fc_floor_shift32(fc_to_i32(high), (uint8_t)(s - 32));
  return s == 0 ? fc_to_i32((uint32_t)v) : fc_to_i32(high << (32 - s) | (uint32_t)v >> s);
}

/* The form within 2^29 over the tile, moved up by its error there; false when it is below 0 everywhere. `certain` grows to the
 * bound from which it is above 0 for certain. */
static bool fit(const fc_scan *scan, const shadow_form *form, int32_t *at, int32_t *dx, int32_t *dy, int32_t *certain) {
  /* one column and row beyond, where steps end; each of the three below 2^27, their sum below 2^29 */
  uint8_t shift = fc_bits64(fc_abs64(form->at)), b = (uint8_t)(fc_bits64(fc_abs64(form->dx)) + fc_bits64(scan->columns));
  int32_t most, right, down;
  int64_t margin;
  if (b > shift) shift = b;
  b = (uint8_t)(fc_bits64(fc_abs64(form->dy)) + fc_bits64(scan->rows));
  if (b > shift) shift = b;
  shift = shift > 27 ? (uint8_t)(shift - 27) : 0;
  /* and a floor a step */
  margin = fc_floor_shift64(form->error, shift) + 3 + scan->columns + scan->rows;
  if (margin >= INT64_C(1) << 28) {
    /* it tells nothing */
    *at = *dx = *dy = 0;
    *certain = INT32_MAX;
    return true;
  }
  *at = cut_down(form->at, shift) + (int32_t)margin;
  *dx = cut_down(form->dx, shift);
  *dy = cut_down(form->dy, shift);
  right = *dx * (scan->columns - 1);
  down = *dy * (scan->rows - 1);
  most = *at + (right > 0 ? right : 0) + (down > 0 ? down : 0);
  if (most < 0) return false;
  if (2 * (int32_t)margin + 1 > *certain) *certain = 2 * (int32_t)margin + 1;
  return true;
}

/* Sides of the receiver on which the vertices are: bit 0, some on the light's; bit 1, some on the other. */
static uint8_t sides_of(const fc_planar *receiver, const fc_form *form) {
  uint8_t i, sides = 0;
  for (i = 0; i < 3; i++) {
    const int64_t *v = form->u.triangle.vertex[i];
    int8_t side = fc_planar_side(receiver, v);
    if (side > 0) sides |= 1;
    if (side < 0) sides |= 2;
  }
  return sides;
}

FC_COLD void fc_shadow_darken(fc_scan *scan, uint16_t row, int32_t first, int32_t last) {
  int32_t word;
  for (word = first / 32; word <= last / 32; word++) {
    uint32_t bits = scan->mask[row * scan->words + word];
    if (word == first / 32) bits &= UINT32_MAX << (first % 32);
    if (word == last / 32) bits &= UINT32_MAX >> (31 - last % 32);
    if (bits != 0) fc_planar_darken(scan, row, (uint16_t)(32 * word), bits);
  }
}

static FC_COLD void ask(fc_scan *scan, uint16_t row, int32_t column, const fc_kind *kind, const fc_form *form) {
  uint32_t bit = UINT32_C(1) << (column % 32);
  if ((scan->mask[row * scan->words + column / 32] & bit) && fc_scan_blocked(scan, row, (uint16_t)column, kind, form))
    fc_planar_darken(scan, row, (uint16_t)column, bit);
}

static void cast(fc_scan *scan, const fc_facet *facet, const int32_t more[3], uint8_t count, const fc_kind *kind,
                 const fc_form *form) {
  /* the fourth form: at, dx, dy */
  int32_t at[4], dx[4], dy[4], top = scan->first_row, bottom = scan->last_row, row;
  uint8_t i;
  for (i = 0; i < count; i++) {
    at[i] = i < 3 ? facet->at[i] : more[0];
    dx[i] = i < 3 ? facet->dx[i] : more[1];
    dy[i] = i < 3 ? facet->dy[i] : more[2];
    /* rows whose greatest value is above 0 */
    fc_facet_cut(at[i] + (dx[i] > 0 ? dx[i] * (scan->columns - 1) : 0), dy[i], 0, scan->rows, &top, &bottom);
  }
  for (i = 0; i < count; i++) at[i] += dy[i] * top;
  for (row = top; row <= bottom; row++) {
    int32_t first = 0, last = scan->columns - 1, inner_first, inner_last;
    uint32_t any = 0;
    for (i = 0; i < scan->words; i++) any |= scan->mask[row * scan->words + i];
    if (any != 0) {
      for (i = 0; i < count; i++) fc_facet_cut(at[i], dx[i], 0, scan->columns, &first, &last);
      if (first <= last) {
        inner_first = first;
        inner_last = last;
        for (i = 0; i < count; i++) fc_facet_cut(at[i], dx[i], facet->certain, scan->columns, &inner_first, &inner_last);
        if (inner_first > inner_last) inner_first = last + 1;
        for (; first <= last && first < inner_first; first++) ask(scan, (uint16_t)row, first, kind, form);
        if (first <= last) {
          for (; last > inner_last; last--) ask(scan, (uint16_t)row, last, kind, form);
          fc_shadow_darken(scan, (uint16_t)row, first, last);
        }
      }
    }
    for (i = 0; i < count; i++) at[i] += dy[i];
  }
}

/*
 * The fourth form: W.M > 0 with M = h s n' - |v| n, n' the triangle's normal, v = n'.A, s its sign, h the light's height: where
 * the line meets the triangle's plane before the receiver. False when it cannot be told.
 */
static FC_COLD bool set_passed(const fc_planar *receiver, const int32_t a[3][3], int8_t sign, shadow_form *form) {
  int32_t ab[3], ac[3], across[3], m[3];
  int64_t wide[3], volume, height;
  uint64_t h, v, off, blur_h, blur_v;
  uint8_t i, bits, shift;
  for (i = 0; i < 3; i++) {
    ab[i] = a[1][i] - a[0][i]; /* 31 bits: vertices within 2^30 */
    ac[i] = a[2][i] - a[0][i];
  }
  cross(ab, ac, wide);
  (void)shrink(wide, across);
  volume = dot(across, a[0]);
  height = receiver->height;
  if (height <= 0 || fc_sign64(volume) != sign) return false;
  /* both within 30 bits, by the same shift; off by the receiver's slack and |A|_1, and by the cut */
  bits = fc_bits64((uint64_t)height | fc_abs64(volume));
  shift = bits > 30 ? (uint8_t)(bits - 30) : 0;
  h = (uint64_t)height >> shift;
  v = fc_abs64(volume) >> shift;
  blur_h = ((uint64_t)receiver->slack >> shift) + 2;
  blur_v = ((uint64_t)norm1(a[0]) >> shift) + 2;
  for (i = 0; i < 3; i++) wide[i] = sign * fc_smul32((int32_t)h, across[i]) - fc_smul32((int32_t)v, (int32_t)receiver->normal[i]);
  bits = fc_vector_bits(wide);
  shift = shrink(wide, m);
  /* 30-bit factors, each normal short by less than 1 */
  off = ((blur_h + blur_v + 2) << 30 >> shift) + 2;
  if (off >> 24) return false;
  set_form(&receiver->w, m, 1, (uint32_t)off, form);
  return true;
}

/* Edges seen from the light over the tile, in 16 bits: N.W / 4 at three corners of it. */
typedef struct edge_glance {
  int32_t at, right, down;
} edge_glance;

/*
 * Whether a triangle seen from the light is clear of the tile's four directions, in 16 bits: on the outer side of one edge (sign
 * known), or on different sides of two. Where it is not, `edges` are what was found.
 */
static bool misses(const fc_planar *receiver, const int32_t a[3][3], int8_t sign, edge_glance edges[3]) {
  const int32_t error = FC_GLANCE_ERROR;
  uint32_t all = 0;
  uint8_t i, j, shift;
  bool outside = false, inside = false;
  for (i = 0; i < 3; i++)
    for (j = 0; j < 3; j++) all |= fc_abs32(a[i][j]);
  shift = fc_glance_shift(all);
  for (i = 0; i < 3; i++) {
    int32_t n[3], value[4], low = INT32_MAX, high = INT32_MIN;
    if (!fc_glance_edge(a[i], a[next(i)], shift, n)) { /* no edge, which tells nothing */
      edges[i].at = edges[i].right = edges[i].down = 0;
      continue;
    }
    for (j = 0; j < 4; j++) {
      const int16_t *w = receiver->corner[j];
      value[j] = n[0] * w[0] + n[1] * w[1] + n[2] * w[2];
      if (value[j] < low) low = value[j];
      if (value[j] > high) high = value[j];
    }
    if (high < -error) outside = true;
    if (low > error) inside = true;
    if (sign < 0 ? inside : sign > 0 ? outside
                                     : inside && outside) return true;
    edges[i].at = fc_floor_shift32(value[0], 2);
    edges[i].right = fc_floor_shift32(value[1], 2) - edges[i].at; /* below 2^30 */
    edges[i].down = fc_floor_shift32(value[2], 2) - edges[i].at;
  }
  return false;
}

/* Whether the mask has a pixel of a row between two columns. */
static bool shows(const fc_scan *scan, int32_t row, int32_t first, int32_t last) {
  const uint32_t *mask = scan->mask + row * scan->words;
  int32_t word;
  for (word = first / 32; word <= last / 32; word++) {
    uint32_t bits = mask[word];
    if (word == first / 32) bits &= UINT32_MAX << (first % 32);
    if (word == last / 32) bits &= UINT32_MAX >> (31 - last % 32);
    if (bits != 0) return true;
  }
  return false;
}

/*
 * Whether some masked pixel may lie inside the edges at a glance. What N is off tells as at the corners, what W is off up to
 * three times as much between them, for 1 - x - y, x and y are within 1: 147515 + 3 * 73728 < 4 * 92200. Steps are
 * off by less than 3 each.
 */
static bool touches(const fc_scan *scan, const fc_planar *receiver, const edge_glance edges[3], int8_t sign) {
  const uint16_t columns = (uint16_t)(receiver->right - receiver->left + 1), rows = (uint16_t)(receiver->bottom - receiver->top + 1);
  const int32_t margin = 92200 + 6 + 3 * (columns + rows);
  int32_t at[3], dx[3], dy[3], row = 0, bottom = rows - 1;
  uint8_t i;
  for (i = 0; i < 3; i++) {
    int32_t right = sign < 0 ? -edges[i].right : edges[i].right, down = sign < 0 ? -edges[i].down : edges[i].down;
    at[i] = (sign < 0 ? -edges[i].at : edges[i].at) + margin;
    dx[i] = fc_smulhi32(right, receiver->per_column);
    dy[i] = fc_smulhi32(down, receiver->per_row);
    fc_facet_cut(at[i] + (right > 0 ? right : 0), dy[i], 0, rows, &row, &bottom);
    if (row > bottom) return false;
  }
  for (i = 0; i < 3; i++) at[i] += dy[i] * row;
  for (; row <= bottom; row++) {
    int32_t first = 0, last = columns - 1;
    for (i = 0; i < 3 && first <= last; i++) fc_facet_cut(at[i], dx[i], 0, columns, &first, &last);
    if (first <= last && shows(scan, row + receiver->top, first + receiver->left, last + receiver->left)) return true;
    for (i = 0; i < 3; i++) at[i] += dy[i];
  }
  return false;
}

FC_NOINLINE bool fc_shadow_is_clear(const fc_scan *scan, fc_planar *receiver, const int32_t a[3][3], int8_t hidden) {
  edge_glance edges[3];
  if (!receiver->corners_known) fc_planar_find_corners(receiver);
  if (misses(receiver, a, hidden, edges)) return true;
  if (hidden == 0) return false;
  if (!receiver->steps_known) fc_planar_find_steps(receiver);
  return !touches(scan, receiver, edges, hidden);
}

FC_NOINLINE bool fc_shadow_edge_find(const fc_scan *scan, const fc_planar *receiver, const int32_t a[3], const int32_t b[3], int8_t sign,
                                     fc_shadow_edge *edge) {
  int64_t wide[3];
  int32_t n[3];
  shadow_form form;
  bool cut;
  cross(a, b, wide);
  cut = shrink(wide, n) > 0; /* short by less than 1 a component */
  set_form(&receiver->w, n, sign, cut, &form);
  edge->certain = 0;
  return fit(scan, &form, &edge->at, &edge->dx, &edge->dy, &edge->certain);
}

int8_t fc_triangle_turn(const int32_t a[3], const int32_t b[3], const int32_t c[3], const int64_t light[3]) {
  int32_t v[3][3], n[3];
  int64_t wide[3], volume, doubt;
  uint8_t j;
  for (j = 0; j < 3; j++) { /* 30 bits each */
    v[0][j] = (int32_t)(a[j] - light[j]);
    v[1][j] = (int32_t)(b[j] - light[j]);
    v[2][j] = (int32_t)(c[j] - light[j]);
  }
  cross(v[0], v[1], wide);
  doubt = shrink(wide, n) > 0 ? norm1(v[2]) : 0;
  volume = dot(n, v[2]);
  return (int8_t)((volume > doubt) - (volume < -doubt));
}

void fc_triangle_shadow(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_form *form) {
  int32_t a[3][3], n[3][3], more[3] = {0, 0, 0};
  int64_t volume;
  fc_facet facet;
  shadow_form f;
  uint8_t i, j, sides, cut[3];
  int8_t sign = 0;
  facet.certain = 0;
  for (j = 0; j < 3; j++) { /* 30 bits each */
    int32_t light = (int32_t)scan->frame->lights[j];
    a[0][j] = (int32_t)form->u.triangle.vertex[0][j] - light;
    a[1][j] = (int32_t)form->u.triangle.vertex[1][j] - light;
    a[2][j] = (int32_t)form->u.triangle.vertex[2][j] - light;
  }
  sides = sides_of(receiver, form); /* a plane cut into triangles is no shadow on itself */
  if (!(sides & 1)) return;
  if (receiver->w.error >> 14 == 0 && fc_shadow_is_clear(scan, receiver, (const int32_t(*)[3])a, form->u.triangle.hidden)) return;
  for (i = 0; i < 3; i++) {
    int64_t wide[3];
    cross(a[i], a[next(i)], wide);
    cut[i] = shrink(wide, n[i]) > 0;
    if (i == 0) {
      /* A x B is short by less than 1 a component */
      volume = dot(n[0], a[2]);
      if (fc_abs64(volume) <= (cut[0] ? (uint64_t)norm1(a[2]) : 0)) {
        if (volume != 0 || cut[0]) fc_planar_ask(scan, kind, form);
        return;
      }
      sign = fc_sign64(volume);
      if (form->u.triangle.hidden != 0 && sign != form->u.triangle.hidden) return;
    }
    set_form(&receiver->w, n[i], sign, cut[i], &f);
    if (!fit(scan, &f, &facet.at[i], &facet.dx[i], &facet.dy[i], &facet.certain)) return;
  }
  if (sides & 2) {
    if (!set_passed(receiver, (const int32_t(*)[3])a, sign, &f))
      facet.certain = INT32_MAX;
    else if (!fit(scan, &f, &more[0], &more[1], &more[2], &facet.certain))
      return;
  }
  cast(scan, &facet, more, sides & 2 ? 4 : 3, kind, form);
}
