/* The adaptive quincunx: a centre and four corners, halved where they differ. */
#include "bits.h"
#include "sample.h"
#include "shade.h"

/* A ray that is kept: radiance below 2^9 in Q22. */
typedef struct point {
  uint32_t radiance_q22[3];
  uint16_t object;
  uint16_t known; /* 0: not traced yet */
} point;

/* The pixel at hand. Corners of squares of all sizes, and the centres of all but the smallest, are points of a grid of 2^depth steps a
 * side, so that what squares share is there for all of them. */
typedef struct pixel {
  const fc_sampler *sampler;
  point *grid;      /* (steps + 1)^2, row by row */
  int32_t place[2]; /* its upper left corner */
  uint16_t steps, rays;
} pixel;

static FC_COLD void trace(const fc_sampler *sampler, const int32_t place_q16[2], point *p, fc_seen *seen) {
  uint8_t i;
  fc_sample_trace(sampler, place_q16, seen);
  for (i = 0; i < 3; i++) {
    uint64_t q22 = (seen->radiance_q39[i] + (UINT32_C(1) << 16)) >> 17; /* at most 2^31 */
    p->radiance_q22[i] = (uint32_t)q22;
  }
  p->object = seen->object;
  p->known = 1;
}

/* A quarter of a smaller square is a fourth of the pixel less at each level: as much more may be lost there. */
static FC_COLD bool alike(const fc_sampling *how, uint8_t level, const point *a, const point *b) {
  const uint32_t white = UINT32_C(1) << 22;
  uint8_t i;
  if (a->object != b->object) return false;
  for (i = 0; i < 3; i++) {
    /* what is brighter than white looks the same */
    uint32_t u = a->radiance_q22[i] < white ? a->radiance_q22[i] : white;
    uint32_t v = b->radiance_q22[i] < white ? b->radiance_q22[i] : white;
    if ((u > v ? u - v : v - u) > (uint64_t)how->threshold_q15 << (7 + 2 * level)) return false;
  }
  return true;
}

/* sum += weight (a + b): weights of all pairs together are 2^12 at most. */
static FC_COLD void add(uint64_t sum[3], const point *a, const point *b, uint8_t weight_bits) {
  uint8_t i;
  for (i = 0; i < 3; i++) sum[i] += ((uint64_t)a->radiance_q22[i] + b->radiance_q22[i]) << weight_bits;
}

/* Traces a point that is (x, y) / 2 steps from the pixel's corner. */
static FC_COLD void trace_at(pixel *p, uint16_t x, uint16_t y, point *to, fc_seen *seen) {
  int32_t at[2];
  at[0] = p->place[0] + x * (FC_PLACE_HALF / p->steps);
  at[1] = p->place[1] + y * (FC_PLACE_HALF / p->steps);
  trace(p->sampler, at, to, seen);
  p->rays++;
}

/* The point of the grid at (x, y), traced when it has not been yet. */
static FC_COLD const point *at_grid(pixel *p, uint16_t x, uint16_t y) {
  point *to = p->grid + (size_t)y * (p->steps + 1u) + x;
  if (to->known == 0) {
    fc_seen seen;
    trace_at(p, (uint16_t)(2 * x), (uint16_t)(2 * y), to, &seen);
  }
  return to;
}

/* The pixel's sum, 8 4^depth times Q22: squares one in another, without recursion. */
static FC_COLD void sum_squares(pixel *p, uint64_t sum[3], fc_seen *centre) {
  const uint8_t depth = p->sampler->how.depth;
  uint8_t quarter[FC_QUINCUNX_DEPTH_MAX + 1]; /* of the square of each level: the one at hand; bit 0: the right, bit 1: the lower */
  uint16_t x = 0, y = 0, side = p->steps;     /* of the square at this level, in steps */
  uint8_t level = 0, q;
  point smallest; /* the centre of a square of a step, which is none of the grid */
  fc_seen seen;
  sum[0] = sum[1] = sum[2] = 0;
  quarter[0] = 0;
  trace_at(p, side, side, depth == 0 ? &smallest : p->grid + (size_t)(side / 2u) * (side + 2u), centre);
  for (;;) {
    const point *corner, *middle;
    q = quarter[level];
    if (q == 4) {
      if (level == 0) return;
      q = quarter[--level]++;
      x = (uint16_t)(x - (q & 1) * side);
      y = (uint16_t)(y - (q >> 1) * side);
      side = (uint16_t)(side * 2);
      continue;
    }
    corner = at_grid(p, (uint16_t)(x + (q & 1) * side), (uint16_t)(y + (q >> 1) * side));
    middle = level == depth ? &smallest : at_grid(p, (uint16_t)(x + side / 2), (uint16_t)(y + side / 2));
    if (level == depth || alike(&p->sampler->how, level, corner, middle)) {
      add(sum, corner, middle, (uint8_t)(2 * (depth - level)));
      quarter[level]++;
      continue;
    }
    side = (uint16_t)(side / 2);
    x = (uint16_t)(x + (q & 1) * side);
    y = (uint16_t)(y + (q >> 1) * side);
    quarter[++level] = 0;
    if (level == depth) trace_at(p, (uint16_t)(2 * x + 1), (uint16_t)(2 * y + 1), &smallest, &seen);
  }
}

/* From a pixel to its right neighbour, or (`first`) to the first of a row: what is known is the edge between them. */
static FC_COLD void move_on(pixel *p, bool first) {
  const uint16_t points = (uint16_t)(p->steps + 1);
  uint16_t x, y;
  for (y = 0; y < points; y++) {
    point *row = p->grid + (size_t)y * points;
    if (!first) row[0] = row[p->steps];
    for (x = first ? 0 : 1; x < points; x++) row[x].known = 0;
  }
}

static FC_COLD bool check(const fc_sampling *how) {
  return how->depth <= FC_QUINCUNX_DEPTH_MAX && how->filter == FC_FILTER_BOX && how->threshold_q15 <= FC_ONE_Q15;
}

static FC_COLD size_t scratch_bytes(const fc_sampling *how, uint16_t width) {
  const uint32_t side = (UINT32_C(1) << how->depth) + 1, bytes = (side * side + width + 1) * (uint32_t)sizeof(point);
  return (size_t)bytes == bytes ? (size_t)bytes : SIZE_MAX; /* more than nobody has */
}

static FC_COLD void strip(const fc_sampler *sampler, void *scratch) {
  const uint16_t width = sampler->frame.width, last_row = (uint16_t)(sampler->frame.height - 1);
  const uint8_t up = (uint8_t)(14 - 2 * sampler->how.depth); /* from 8 4^depth times Q22, below 2^44, to Q39 */
  pixel p;
  point *corners, *far_corner; /* those above the row; where the row is done, those below */
  fc_seen seen;
  uint16_t x, row;
  p.sampler = sampler;
  p.grid = scratch;
  p.steps = (uint16_t)(1u << sampler->how.depth);
  far_corner = p.grid + (size_t)p.steps * (p.steps + 2u);
  corners = far_corner + 1;
  p.place[1] = (int32_t)sampler->y * FC_PLACE_ONE;
  for (x = 0; x <= width; x++) {
    p.place[0] = x * FC_PLACE_ONE;
    trace(sampler, p.place, &corners[x], &seen);
  }
  for (row = 0; row < sampler->rows; row++) {
    const uint16_t y = (uint16_t)(sampler->y + row);
    point below; /* the corner between this pixel and the next, of the lower edge */
    int32_t at[2];
    at[0] = 0;
    at[1] = (y + INT32_C(1)) * FC_PLACE_ONE;
    trace(sampler, at, &below, &seen);
    p.place[1] = (int32_t)y * FC_PLACE_ONE;
    for (x = 0; x < width; x++) {
      uint64_t sum[3];
      uint8_t i;
      move_on(&p, x == 0);
      p.grid[0] = corners[x];
      p.grid[p.steps] = corners[x + 1];
      far_corner[-(int32_t)p.steps] = below;
      corners[x] = below;
      at[0] = (x + INT32_C(1)) * FC_PLACE_ONE;
      trace(sampler, at, &below, &seen);
      *far_corner = below;
      p.place[0] = x * FC_PLACE_ONE;
      /* its upper left corner; those of the frame's last edges belong to nobody else */
      p.rays = (uint16_t)(1 + (x + 1 == width) + (y == last_row) + (x + 1 == width && y == last_row));
      sum_squares(&p, sum, &seen);
      for (i = 0; i < 3; i++) sum[i] <<= up;
      fc_sample_put(sampler, x, row, sum, p.rays, &seen);
    }
    corners[width] = below;
  }
}

const fc_pattern fc_pattern_quincunx FC_ROM = {check, scratch_bytes, strip};
