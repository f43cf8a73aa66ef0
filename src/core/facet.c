/* Forms of a triangle: from its corners on the screen, or from exact cross products. */
#include "facet.h"

#include "num.h"
#include "view.h"

static uint32_t longest_side(const fc_tile *box) {
  int32_t columns = box->x1 - box->x0, rows = box->y1 - box->y0;
  return (uint32_t)(columns > rows ? columns : rows) + 2;
}

/* a frac / 2^point, floor: a below 2^29 in size, frac below 2^point, point at most 16. */
static int32_t part(int32_t a, uint32_t frac, uint8_t point) {
  /* the whole part times frac below 2^(29 + 1); the rest, 16 + 16 bits */
  uint32_t rest = (uint32_t)a & ((UINT32_C(1) << point) - 1);
  return fc_floor_shift32(a, point) * (int32_t)frac + (int32_t)((rest * frac) >> point);
}

bool fc_facet_edges(fc_facet *facet, const fc_frame *frame, const fc_corners *corners, const fc_tile *box,
                    const fc_tile *tile, int8_t hidden_side, bool *hidden) {
  uint32_t side = longest_side(box), margin;
  uint8_t fraction = corners->fraction, bits = (uint8_t)(32 - fc_clz32(side)), point, i, down;
  int64_t area, slack;
  int32_t x[3], y[3], half;
  *hidden = false;
  /* Differences below 2^31, products below 2^62. Each difference is off by 2 FC_CORNER_ERROR at most, and no longer than `side`. */
  area = fc_product(corners->x[1] - corners->x[0], corners->y[2] - corners->y[0]) -
         fc_product(corners->x[2] - corners->x[0], corners->y[1] - corners->y[0]);
  slack = ((int64_t)side * (8 * FC_CORNER_ERROR) << fraction) + 8 * FC_CORNER_ERROR * FC_CORNER_ERROR;
  if (area <= slack && area >= -slack) return false;
  /* y runs down: positive is the side on which normal . vertex < 0 */
  if (hidden_side != 0 && (area > 0) == (hidden_side < 0)) {
    *hidden = true;
    return true;
  }
  /* Edges in 2^-point pixels: a form is below 2 side^2 2^point <= 2^(2 bits + 1 + point) <= 2^29. */
  if (bits > 12) return false;
  point = bits <= 6 ? 16 : (uint8_t)(28 - 2 * bits);
  down = (uint8_t)(fraction - point);
  half = (INT32_C(1) << down) / 2;
  for (i = 0; i < 3; i++) {
    uint8_t j = area > 0 || i == 0 ? i : (uint8_t)(3 - i);
    /* to pixel coordinates: the centre of pixel 0 is (size - 1) / 2 to the left */
    x[i] = fc_floor_shift32(corners->x[j] + (frame->width - 1) * (INT32_C(1) << (fraction - 1)) + half, down);
    y[i] = fc_floor_shift32(corners->y[j] + (frame->height - 1) * (INT32_C(1) << (fraction - 1)) + half, down);
  }
  /* An edge form is cross(b - a, P - a); with a and b off by e = FC_CORNER_ERROR / 2^down + 1/2 < 11 / 2^down + 1/2 a coordinate, by
   * 2 e (|P - a|_1 + |P - b|_1) / 2 + 4 e^2 <= 4 e side + ...; and two floors. */
  margin = 4 * side + 4;
  margin = (margin >> 1) + ((margin * 11) >> down) + 4 + ((242u * 4) >> down);
  for (i = 0; i < 3; i++) {
    uint8_t j = i == 2 ? 0 : (uint8_t)(i + 1);
    int32_t dx = x[j] - x[i], dy = y[j] - y[i];
    const uint32_t low = (UINT32_C(1) << point) - 1;
    /* P = (x0, y0): dx (P.y - y) - dy (P.x - x), whole pixels and parts of one apart */
    int32_t up = (tile->y0 - fc_floor_shift32(y[i], point)) * dx - part(dx, (uint32_t)y[i] & low, point);
    int32_t across = (tile->x0 - fc_floor_shift32(x[i], point)) * dy - part(dy, (uint32_t)x[i] & low, point);
    facet->at[i] = up - across + (int32_t)margin;
    facet->dx[i] = -dy;
    facet->dy[i] = dx;
  }
  facet->certain = (int32_t)(2 * margin) + 1;
  return true;
}

/* v as mantissa (2^30 .. 2^31 in size, or 0) times 2^*exponent. */
static int32_t mantissa_of(int64_t v, int16_t *exponent) {
  uint64_t size = fc_abs64(v);
  uint8_t bits = fc_bits64(size);
  uint32_t m = bits > 31 ? (uint32_t)(size >> (bits - 31)) : (uint32_t)size << (31 - bits);
  *exponent = (int16_t)(bits - 31);
  if (size == 0) return 0;
  return v < 0 ? -(int32_t)m : (int32_t)m;
}

/* numerator / determinant 2^(fraction + 32); false when it is 2^62 or more. */
static bool slope(int64_t numerator, uint32_t reciprocal, int16_t exponent, uint64_t *to) {
  int16_t e;
  int32_t m = mantissa_of(numerator, &e);
  uint64_t product = fc_mul32(fc_abs32(m), reciprocal); /* 31 + 32 bits */
  e = (int16_t)(e + exponent);
  if (m == 0) {
    product = 0;
  } else if (e >= 0) {
    return false; /* at least 2^61 */
  } else {
    product = e > -64 ? product >> -e : 0;
    if (product >> 61) return false;
  }
  *to = m < 0 ? 0u - product : product;
  return true;
}

/* A 64-bit value times a small signed number; wraps. */
static uint64_t times(uint64_t v, int32_t n) { return v * (uint64_t)(int64_t)n; }

static uint32_t size_of(uint64_t v) { return (uint32_t)(fc_abs64(fc_to_i64(v)) >> 32); }

/* Whether a coordinate was cut before it was projected. */
static uint8_t coarse(const fc_corners *corners, const fc_placed_mesh *mesh) {
  uint8_t i;
  for (i = 0; i < 3; i++)
    if (corners->exponent[i] < mesh->shift) return 1;
  return 0;
}

/* 2^-27 of the size of p at the frame's centre, or more. */
static uint32_t at_centre(const fc_facet *facet, const fc_frame *frame, const fc_tile *tile) {
  /* high words are floors: off by a pixel's worth of 1 a step; 31 + 13 bits */
  int32_t columns = frame->width / 2 - tile->x0, rows = frame->height / 2 - tile->y0;
  int64_t p = (int64_t)(facet->p >> 32) + fc_product(fc_high_word(fc_to_i64(facet->px)), columns) +
              fc_product(fc_high_word(fc_to_i64(facet->py)), rows);
  /* and half a pixel from the middle of the middle one */
  uint64_t size = fc_abs64(p) + fc_abs32(columns) + fc_abs32(rows) + size_of(facet->px) + size_of(facet->py) + 2;
  return (uint32_t)(size >> 27) + 1;
}

bool fc_facet_depth(fc_facet *facet, const fc_frame *frame, const fc_placed_mesh *mesh, const fc_corners *corners,
                    const fc_tile *box, const fc_tile *tile) {
  uint8_t i, fraction = corners->fraction, most = 0;
  uint32_t p[3], reciprocal, steep, across;
  int32_t x1 = corners->x[1] - corners->x[0], x2 = corners->x[2] - corners->x[0];
  int32_t y1 = corners->y[1] - corners->y[0], y2 = corners->y[2] - corners->y[0], p1, p2, off_x, off_y;
  int64_t determinant = fc_product(x1, y2) - fc_product(x2, y1);
  int32_t m;
  uint8_t cut;
  int16_t exponent;
  uint64_t at;
  for (i = 0; i < 3; i++) {
    uint8_t e = corners->exponent[i];
    if (e > most) most = e;
  }
  /* 1 / determinant = reciprocal 2^(-63 - exponent) */
  m = mantissa_of(determinant, &exponent);
  reciprocal = fc_recip_q63(fc_abs32(m) << 1);
  exponent = (int16_t)(-exponent + 1 - 63 + fraction + 32);
  for (cut = 0;; cut = (uint8_t)(cut + 4)) {
    for (i = 0; i < 3; i++) {
      /* below 2^31; short by less than 2 */
      p[i] = corners->near[i] >> (1 + most - corners->exponent[i]);
      p[i] >>= cut;
    }
    facet->drop = (int16_t)(mesh->depth_down + mesh->focal_down - most - 32 - cut);
    p1 = (int32_t)p[1] - (int32_t)p[0];
    p2 = (int32_t)p[2] - (int32_t)p[0];
    if (m < 0) {
      p1 = -p1;
      p2 = -p2;
    }
    /* Through the three corners: 31 + 31 bits, two products. Flat triangles seen from afar are steep: four bits less then. */
    if (slope(fc_product(p1, y2) - fc_product(p2, y1), reciprocal, exponent, &facet->px) &&
        slope(fc_product(p2, x1) - fc_product(p1, x2), reciprocal, exponent, &facet->py))
      break;
    if (cut == 8) return false;
  }
  /* from the first corner to the tile's first pixel, in units of 2^-fraction */
  off_x = (2 * tile->x0 + 1 - frame->width) * (INT32_C(1) << (fraction - 1)) - corners->x[0];
  off_y = (2 * tile->y0 + 1 - frame->height) * (INT32_C(1) << (fraction - 1)) - corners->y[0];
  at = (uint64_t)p[0] << 32;
  at += times(facet->px, fc_floor_shift32(off_x, fraction)) + times(facet->py, fc_floor_shift32(off_y, fraction));
  {
    uint32_t low = (UINT32_C(1) << fraction) - 1;
    at += (uint64_t)(fc_smul64hi(fc_to_i64(facet->px), (int32_t)(((uint32_t)off_x & low) << (30 - fraction))) * 4);
    at += (uint64_t)(fc_smul64hi(fc_to_i64(facet->py), (int32_t)(((uint32_t)off_y & low) << (30 - fraction))) * 4);
  }
  /* corners are floors: on average half a unit too far left and up */
  at -= (uint64_t)fc_floor_shift64(fc_to_i64(facet->px + facet->py), (uint8_t)(fraction + 1));
  facet->p = at;
  /*
   * The form passes through the rounded corners; where it is off by at most e at the true ones, it is so at every point
   * between them. Corner values are short by 2; corners are off by 1/2 unit, 3/2 where x and y were cut; what the three
   * coordinates have in common (2^-27) moves the form by that part of its value at the frame's centre. Slopes have a relative
   * error of 2^-28, over the box; and a step along a row is rounded, for up to 32 columns.
   */
  steep = size_of(facet->px) + size_of(facet->py) + 2; /* a pixel */
  if (steep >> 30) return false;
  across = (uint32_t)(tile->x1 - tile->x0) + 1;
  facet->error = 2 + 1 + 1 + (steep >> (fraction + 1 - 2 * coarse(corners, mesh))) + at_centre(facet, frame, tile) +
                 (uint32_t)(fc_mul32(steep, longest_side(box)) >> 27) + (across < 32 ? across : 32) / 2 + 3;
  facet->least = p[0] < p[1] ? p[0] : p[1];
  if (p[2] < facet->least) facet->least = p[2];
  facet->least = facet->least > facet->error ? facet->least - facet->error : 0;
  return true;
}

/* |v| as mantissa (2^31 .. 2^32-1, cut) times 2^*exponent; v != 0. */
static uint32_t normal_of(uint64_t v, int16_t *exponent) {
  uint32_t high = (uint32_t)(v >> 32), low = (uint32_t)v;
  uint8_t zeros;
  if (high == 0) {
    zeros = fc_clz32(low);
    *exponent = (int16_t)-zeros;
    return low << zeros;
  }
  zeros = fc_clz32(high);
  *exponent = (int16_t)(32 - zeros);
  return zeros == 0 ? high : high << zeros | low >> (32 - zeros);
}

/* v reciprocal / 2^(32 + down), within 5/8: in eighths, two floors of less than 1 each, and rounded; false when it may be 2^28 or more. */
static inline bool short_slope(int64_t v, uint32_t reciprocal, uint8_t down, uint32_t *to) {
  const int64_t cut = fc_floor_shift64(v, (uint8_t)(down - 3));
  const int32_t n = fc_to_i32((uint32_t)(uint64_t)cut);
  *to = (uint32_t)fc_floor_shift32(fc_floor_shift32(fc_smulhi32(n, reciprocal), 2) + 1, 1);
  return n == cut;
}

#define SWAP(a, b) \
  do { \
    int32_t t = a; \
    a = b; \
    b = t; \
  } while (0)

uint8_t fc_small_edges(fc_small_facet *facet, const fc_frame *frame, int8_t hidden_side) {
  const fc_corners *corners = facet->corners;
  const fc_tile *tile = facet->tile;
  const uint8_t fraction = corners->fraction, down = (uint8_t)(fraction - 16);
  const uint32_t close = (11u >> down) + 2;
  const int32_t half = INT32_C(1) << (down - 1);
  const int32_t left = (2 * tile->x0 + 1 - frame->width) * (INT32_C(1) << (fraction - 1)) - half;
  const int32_t top = (2 * tile->y0 + 1 - frame->height) * (INT32_C(1) << (fraction - 1)) - half;
  int32_t x0, x1, x2, y0, y1, y2, area;
  y0 = fc_floor_shift32(corners->y[0] - top, down);
  y1 = fc_floor_shift32(corners->y[1] - top, down);
  y2 = fc_floor_shift32(corners->y[2] - top, down);
  /* Rows whose centre is too near a corner's height to tell on which side it is: 11 / 2^down + 1/2. */
  if ((((uint32_t)y0 + close) & 0xffffu) <= 2 * close || (((uint32_t)y1 + close) & 0xffffu) <= 2 * close ||
      (((uint32_t)y2 + close) & 0xffffu) <= 2 * close)
    return FC_FACET_UNCLEAR;
  x0 = fc_floor_shift32(corners->x[0] - left, down);
  x1 = fc_floor_shift32(corners->x[1] - left, down);
  x2 = fc_floor_shift32(corners->x[2] - left, down);
  facet->side = longest_side(facet->box);
  {
    /* as in fc_facet_edges */
    uint32_t margin = 4 * facet->side + 4;
    facet->margin = (int32_t)((margin >> 1) + ((margin * 11) >> down) + 4 + ((242u * 4) >> down));
  }
  /* Differences below 2^22, products below 2^27. Each difference is off by 2 e and no longer than `side`, e as in fc_facet_edges:
   * 8 e side + 8 e^2, and two floors, are less than two margins. */
  area = fc_product16(x1 - x0, y2 - y0) - fc_product16(x2 - x0, y1 - y0);
  if (area <= 2 * facet->margin && area >= -2 * facet->margin) return FC_FACET_UNCLEAR;
  if (hidden_side != 0 && (area > 0) == (hidden_side < 0)) return FC_FACET_HIDDEN;
  /* from top to bottom; clockwise then (as y runs down): the middle corner is on the right */
  facet->left = area < 0;
  if (y0 > y1) {
    SWAP(x0, x1);
    SWAP(y0, y1);
    facet->left = !facet->left;
  }
  if (y1 > y2) {
    SWAP(x1, x2);
    SWAP(y1, y2);
    facet->left = !facet->left;
    if (y0 > y1) {
      SWAP(x0, x1);
      SWAP(y0, y1);
      facet->left = !facet->left;
    }
  }
  facet->x[0] = x0;
  facet->x[1] = x1;
  facet->x[2] = x2;
  facet->y[0] = y0;
  facet->y[1] = y1;
  facet->y[2] = y2;
  return FC_FACET_SEEN;
}

/* g off / 2^fraction, floors; off below 2^6 pixels. */
static uint32_t moved(uint32_t g, int32_t off, uint8_t fraction) {
  return g * (uint32_t)fc_floor_shift32(off, fraction) + (uint32_t)fc_smulhi32(fc_to_i32(g), (uint32_t)off << (32 - fraction));
}

bool fc_small_depth(fc_small_facet *facet, const fc_frame *frame, const fc_placed_mesh *mesh) {
  const fc_corners *corners = facet->corners;
  const fc_tile *tile = facet->tile;
  const uint8_t fraction = corners->fraction;
  const int32_t x1 = corners->x[1] - corners->x[0], x2 = corners->x[2] - corners->x[0];
  const int32_t y1 = corners->y[1] - corners->y[0], y2 = corners->y[2] - corners->y[0];
  int64_t area = fc_product(x1, y2) - fc_product(x2, y1);
  const int32_t left = (2 * tile->x0 + 1 - frame->width) * (INT32_C(1) << (fraction - 1));
  const int32_t top = (2 * tile->y0 + 1 - frame->height) * (INT32_C(1) << (fraction - 1));
  int32_t p1, p2;
  uint32_t p0, steep, reciprocal, low, high;
  uint8_t down, most = corners->exponent[0];
  int16_t exponent;
  if (corners->exponent[1] > most) most = corners->exponent[1];
  if (corners->exponent[2] > most) most = corners->exponent[2];
  p0 = corners->near[0] >> (1 + most - corners->exponent[0]);
  p1 = (int32_t)(corners->near[1] >> (1 + most - corners->exponent[1]));
  p2 = (int32_t)(corners->near[2] >> (1 + most - corners->exponent[2]));
  low = high = p0;
  if ((uint32_t)p1 < low) low = (uint32_t)p1;
  if ((uint32_t)p1 > high) high = (uint32_t)p1;
  if ((uint32_t)p2 < low) low = (uint32_t)p2;
  if ((uint32_t)p2 > high) high = (uint32_t)p2;
  facet->drop = (int16_t)(mesh->depth_down + mesh->focal_down - most - 32);
  p1 -= (int32_t)p0; /* all below 2^31 */
  p2 -= (int32_t)p0;
  if (area < 0) {
    p1 = -p1;
    p2 = -p2;
  }
  /* 1 / |area| = reciprocal 2^(-63 - exponent); the area is not 0, as the edges have told */
  reciprocal = fc_recip_q63(normal_of(fc_abs64(area), &exponent));
  /* Twice a margin is 4 side + 12 or more; corners rounded to 2^-16 pixels make less than 4 side + 6 of it. So |area| is at least
   * 6 2^(2 fraction - 16), more than 2^(fraction + 3) as fraction is above 16, and below 2^(2 fraction + 12): 3 .. 40. */
  down = (uint8_t)(exponent + 31 - fraction);
  if (!short_slope(fc_product(p1, y2) - fc_product(p2, y1), reciprocal, down, &facet->px) ||
      !short_slope(fc_product(p2, x1) - fc_product(p1, x2), reciprocal, down, &facet->py))
    return false;
  facet->p = p0 + moved(facet->px, left - corners->x[0], fraction) + moved(facet->py, top - corners->y[0], fraction);
  /* as in fc_facet_depth; slopes are within 5/8, over `side` columns and rows; at the frame's centre, within half
   * its size and 32 pixels each way, at most p + steep * reach */
  steep = fc_abs32(fc_to_i32(facet->px)) + fc_abs32(fc_to_i32(facet->py)) + 2;
  low -= 2 < low ? 2 : low;
  facet->error = 2 + 16 + 1 + (steep >> (fraction - 1)) + facet->side + facet->side / 4 + 5 +
                 /* 14 + 13 bits; 2^-27 steep times the way */
                 ((((steep >> 16) + 1) * (facet->side + 65 + (uint32_t)(frame->width + frame->height) / 2)) >> 11) + 1;
  facet->least = low > facet->error ? low - facet->error : 0;
  facet->most = high + facet->error + 2;
  return true;
}

/* v 2^(62 - bits). */
static fc_i128 to_bits(fc_i128 v, uint8_t bits) {
  return bits < 62 ? fc_i128_shift_left(v, (uint8_t)(62 - bits)) : fc_i128_floor_shift(v, (uint8_t)(bits - 62));
}

FC_COLD bool fc_facet_exact(fc_facet *facet, const fc_frame *frame, const fc_prepared *prepared, const fc_tile *tile) {
  int64_t d[3], step = INT64_C(2) << frame->view.pixel_shift, e[3], ex[3], ey[3];
  uint32_t columns = (uint32_t)(tile->x1 - tile->x0) + 1, rows = (uint32_t)(tile->y1 - tile->y0) + 1;
  uint64_t most = 0, reach;
  int8_t side = fc_i128_sign(prepared->u.triangle.side);
  uint8_t i, shift;
  bool cut = false;
  if (side == 0) return false;
  fc_view_direction(frame, (uint16_t)tile->x0, (uint16_t)tile->y0, d);
  for (i = 0; i < 3; i++) {
    /* 30 + 30 bits, three terms, at every pixel of the frame: below 2^62, and so are the sums over the tile */
    const int32_t *f = prepared->u.triangle.filter[i];
    uint64_t sum;
    e[i] = side * (f[0] * d[0] + f[1] * d[1] + f[2] * d[2]);
    ex[i] = side * (f[0] * step);
    ey[i] = -side * (f[1] * step);
    sum = fc_abs64(e[i]) + fc_abs64(ex[i]) * columns + fc_abs64(ey[i]) * rows;
    if (sum > most) most = sum;
    if (fc_vector_bits(prepared->u.triangle.edge[i]) > 30) cut = true;
  }
  shift = fc_bits64(most);
  shift = shift > 29 ? (uint8_t)(shift - 29) : 0;
  /* the filter's floor: |D|_1, components below 2^30; then ours */
  reach = cut ? (UINT64_C(3) << 30 >> shift) + 1 : 0;
  reach += 2 + columns + rows;
  if (reach >> 28) return false;
  for (i = 0; i < 3; i++) {
    facet->at[i] = (int32_t)fc_floor_shift64(e[i], shift) + (int32_t)reach;
    facet->dx[i] = (int32_t)fc_floor_shift64(ex[i], shift);
    facet->dy[i] = (int32_t)fc_floor_shift64(ey[i], shift);
  }
  facet->certain = (int32_t)(2 * reach) + 1;
  {
    /* near / z = (n.D) near / (side F): n.D as 62 bits, the factor as 31 */
    const int64_t *n = prepared->u.triangle.normal;
    fc_i128 nd = fc_i128_dot(n, d), ndx = fc_i128_mul(n[0], step), ndy = fc_i128_mul(n[1], -step), sum;
    fc_num factor = fc_num_mul(fc_num_from_abs(prepared->u.triangle.side), fc_num_from_u64((uint64_t)frame->view.focal, 0));
    int32_t times_factor;
    uint8_t bits;
    factor = fc_num_div(fc_num_from_u64(frame->depth_near, 0), factor);
    if (side < 0) {
      nd = fc_i128_neg(nd);
      ndx = fc_i128_neg(ndx);
      ndy = fc_i128_neg(ndy);
    }
    /* 95 bits and 93 + 13: below 2^108 */
    sum = fc_i128_add(fc_i128_abs(nd), fc_i128_add(fc_i128_scale(fc_i128_abs(ndx), columns), fc_i128_scale(fc_i128_abs(ndy), rows)));
    bits = fc_i128_bits(sum);
    nd = to_bits(nd, bits);
    ndx = to_bits(ndx, bits);
    ndy = to_bits(ndy, bits);
    times_factor = (int32_t)(factor.m >> 32);
    /* 62 + 31 - 32 bits, doubled: 62 */
    facet->p = 2 * (uint64_t)fc_smul64hi(fc_i128_to_i64(nd), times_factor);
    facet->px = 2 * (uint64_t)fc_smul64hi(fc_i128_to_i64(ndx), times_factor);
    facet->py = 2 * (uint64_t)fc_smul64hi(fc_i128_to_i64(ndy), times_factor);
    /* 2^62 / 2^32: the factor's cut and the floors of up to 2^13 steps take less than 2 of it, a row's rounded step 16 */
    {
      int32_t drop = -((int32_t)bits - 62 + 95 + factor.e) - 30;
      if (drop > 1000 || drop < -1000) return false;
      facet->drop = (int16_t)drop;
    }
    facet->error = 20;
    facet->least = 0;
  }
  return true;
}

void fc_facet_cut(int32_t at, int32_t dx, int32_t bound, uint16_t columns, int32_t *first, int32_t *last) {
  int32_t bit, top = 1, x = -1;
  if (dx == 0) {
    if (at < bound) *first = columns;
    return;
  }
  while (top <= columns / 2) top *= 2;
  if (dx > 0) {
    /* x: the last column below the bound */
    for (bit = top; bit > 0; bit >>= 1)
      if (x + bit < columns && at + dx * (x + bit) < bound) x += bit;
    if (x + 1 > *first) *first = x + 1;
  } else {
    /* x: the last column not below it */
    for (bit = top; bit > 0; bit >>= 1)
      if (x + bit < columns && at + dx * (x + bit) >= bound) x += bit;
    if (x < *last) *last = x;
  }
}
