/* The adaptive quincunx: a centre and four corners, halved where they differ. */
#include "bits.h"
#include "sample.h"
#include "shade.h"

/* A ray that is kept: radiance below 2^9 in Q22. */
typedef struct point {
  uint32_t radiance_q22[3];
  uint16_t object;
} point;

/* A square: its corners, the middles of its edges and its centre, row by row; those with a bit in `known` are traced. */
typedef struct square {
  point points[9];
  uint16_t known;
  uint8_t quarter; /* the one at hand; bit 0: the right, bit 1: the lower */
} square;

#define CENTRE 4

/* The ways across a square are all steps in a table of three by three. */
static uint8_t corner_of(uint8_t quarter) { return (uint8_t)((quarter & 1) * 2 + (quarter >> 1) * 6); }

/* Where corner `i` of a quarter lies in the square. */
static uint8_t in_square(uint8_t quarter, uint8_t i) {
  return (uint8_t)((quarter & 1) + (i & 1) + ((quarter >> 1) + (i >> 1)) * 3);
}

static FC_COLD void trace(const fc_sampler *sampler, const int32_t place_q16[2], point *p, fc_seen *seen) {
  uint8_t i;
  fc_sample_trace(sampler, place_q16, seen);
  for (i = 0; i < 3; i++) {
    uint64_t q22 = (seen->radiance_q39[i] + (1u << 16)) >> 17; /* at most 2^31 */
    p->radiance_q22[i] = (uint32_t)q22;
  }
  p->object = seen->object;
}

static FC_COLD bool alike(const fc_sampling *how, const point *a, const point *b) {
  const uint32_t white = UINT32_C(1) << 22;
  uint8_t i;
  if (a->object != b->object) return false;
  for (i = 0; i < 3; i++) {
    /* what is brighter than white looks the same */
    uint32_t u = a->radiance_q22[i] < white ? a->radiance_q22[i] : white;
    uint32_t v = b->radiance_q22[i] < white ? b->radiance_q22[i] : white;
    if ((u > v ? u - v : v - u) > (uint32_t)how->threshold_q15 << 7) return false;
  }
  return true;
}

/* sum += weight (a + b): weights of all pairs together 2^12 at most. */
static FC_COLD void add(uint64_t sum[3], const point *a, const point *b, uint8_t weight_bits) {
  uint8_t i;
  for (i = 0; i < 3; i++) sum[i] += ((uint64_t)a->radiance_q22[i] + b->radiance_q22[i]) << weight_bits;
}

/* Begins a square of which the corners are there: traces its centre. */
static FC_COLD void start(const fc_sampler *sampler, square *s, const int32_t place_q16[2], int32_t side, fc_seen *centre) {
  int32_t at[2];
  at[0] = place_q16[0] + side / 2;
  at[1] = place_q16[1] + side / 2;
  trace(sampler, at, &s->points[CENTRE], centre);
  s->known = 0x155; /* corners and centre */
  s->quarter = 0;
}

/* The pixel whose square stands on level 0, corners known, its upper left corner at `place`: its sum, 8 4^depth times Q22.
 * Returns how many rays that took. */
static FC_COLD uint16_t pixel(const fc_sampler *sampler, square *levels, const int32_t place_q16[2], uint64_t sum[3], fc_seen *centre) {
  const uint8_t depth = sampler->how.depth;
  int32_t at[2], side = FC_PLACE_ONE;
  uint16_t rays = 1;
  uint8_t level = 0, i;
  fc_seen seen;
  start(sampler, levels, place_q16, side, centre);
  sum[0] = sum[1] = sum[2] = 0;
  at[0] = place_q16[0];
  at[1] = place_q16[1];
  for (;;) {
    /* `at` and `side` are those of the square at this level */
    square *s = levels + level, *to = s + 1;
    uint8_t q = s->quarter;
    const point *corner = &s->points[corner_of(q)];
    if (q == 4) {
      if (level == 0) return rays;
      /* back to the square that this one is a quarter of */
      q = levels[--level].quarter++;
      at[0] -= (q & 1) * side;
      at[1] -= (q >> 1) * side;
      side *= 2;
      continue;
    }
    if (level == depth || alike(&sampler->how, corner, &s->points[CENTRE])) {
      add(sum, corner, &s->points[CENTRE], (uint8_t)(2 * (depth - level)));
      s->quarter++;
      continue;
    }
    side /= 2;
    for (i = 0; i < 4; i++) {
      const uint8_t j = in_square(q, i);
      if ((s->known >> j & 1) == 0) {
        int32_t middle[2];
        middle[0] = at[0] + j % 3 * side;
        middle[1] = at[1] + j / 3 * side;
        trace(sampler, middle, &s->points[j], &seen);
        s->known = (uint16_t)(s->known | 1u << j);
        rays++;
      }
      to->points[corner_of(i)] = s->points[j];
    }
    at[0] += (q & 1) * side;
    at[1] += (q >> 1) * side;
    start(sampler, to, at, side, &seen);
    rays++;
    level++;
  }
}

static FC_COLD bool check(const fc_sampling *how) {
  return how->depth <= FC_QUINCUNX_DEPTH_MAX && how->filter == FC_FILTER_BOX && how->threshold_q15 <= FC_ONE_Q15;
}

static FC_COLD size_t scratch_bytes(const fc_sampling *how, uint16_t width) {
  return ((size_t)how->depth + 1) * sizeof(square) + ((size_t)width + 1) * sizeof(point);
}

static FC_COLD void strip(const fc_sampler *sampler, void *scratch) {
  const uint16_t width = sampler->frame.width, height = sampler->frame.height;
  const uint8_t up = (uint8_t)(14 - 2 * sampler->how.depth); /* from 8 4^depth times Q22, below 2^46, to Q39 */
  square *levels = scratch;
  point *corners = (point *)(levels + sampler->how.depth + 1); /* those above the row, and below where the row is done */
  fc_seen seen;
  int32_t at[2];
  uint16_t x, row;
  at[1] = (int32_t)sampler->y * FC_PLACE_ONE;
  for (x = 0; x <= width; x++) {
    at[0] = x * FC_PLACE_ONE;
    trace(sampler, at, &corners[x], &seen);
  }
  for (row = 0; row < sampler->rows; row++) {
    const int32_t upper = (int32_t)(sampler->y + row) * FC_PLACE_ONE, lower = upper + FC_PLACE_ONE;
    point above = corners[0]; /* the pixel's upper left corner */
    at[0] = 0;
    at[1] = lower;
    trace(sampler, at, &corners[0], &seen);
    for (x = 0; x < width; x++) {
      uint64_t sum[3];
      uint16_t rays;
      uint8_t i;
      levels[0].points[0] = above;
      levels[0].points[2] = corners[x + 1];
      levels[0].points[6] = corners[x];
      above = corners[x + 1];
      at[0] = (x + INT32_C(1)) * FC_PLACE_ONE;
      at[1] = lower;
      trace(sampler, at, &corners[x + 1], &seen);
      levels[0].points[8] = corners[x + 1];
      at[0] = x * FC_PLACE_ONE;
      at[1] = upper;
      rays = (uint16_t)(pixel(sampler, levels, at, sum, &seen) + 1);
      /* corners of the frame's last edges belong to nobody else */
      if (x + 1 == width) rays++;
      if (sampler->y + row + 1 == height) rays = (uint16_t)(rays + (x + 1 == width ? 2 : 1));
      for (i = 0; i < 3; i++) sum[i] <<= up;
      fc_sample_put(sampler, x, row, sum, rays, &seen);
    }
  }
}

const fc_pattern fc_pattern_quincunx FC_ROM = {check, scratch_bytes, strip};
