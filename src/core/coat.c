/* Tiles of layered materials: the scan engine's light, then each layer's forms, run by run. */
#include "coat.h"

#include "mesh.h"
#include "pixel.h"

FC_COLD void fc_square_set(fc_square *s, const fc_sheaf *a, const fc_sheaf *b) {
  const uint64_t xx = fc_dot32(a->dx, b->dx), yy = fc_dot32(a->dy, b->dy);
  s->at = fc_dot32(a->at, b->at);
  s->dx = fc_dot32(a->at, b->dx) + fc_dot32(a->dx, b->at) + xx;
  s->dy = fc_dot32(a->at, b->dy) + fc_dot32(a->dy, b->at) + yy;
  s->dxx = 2 * xx;
  s->dyy = 2 * yy;
  s->dxy = fc_dot32(a->dx, b->dy) + fc_dot32(a->dy, b->dx);
}

/* round(v / 2^down) of a two's complement value: the low word of it. */
static uint32_t rounded(uint64_t v, uint8_t down) { return (uint32_t)((v + (UINT64_C(1) << (down - 1))) >> down); }

FC_HOT void fc_steps_start(const fc_square *s, uint16_t column, uint8_t down, fc_steps *steps) {
  uint64_t at = s->at, dx = s->dx;
  if (column != 0) {
    at += fc_times(dx + fc_times(s->dxx >> 1, (uint16_t)(column - 1u)), column); /* dxx is even */
    dx += fc_times(s->dxx, column);
  }
  steps->at = (uint32_t)(at >> down);
  steps->dx = rounded(dx, down);
  steps->dxx = rounded(s->dxx, down);
}

FC_COLD void fc_coat_directions(const fc_scan *scan, fc_sheaf *d) {
  int64_t at[3], step;
  uint8_t i;
  fc_scan_direction(scan, at, &step);
  for (i = 0; i < 3; i++) {
    d->at[i] = (int32_t)at[i];
    d->dx[i] = d->dy[i] = 0;
  }
  d->dx[0] = (int32_t)step;
  d->dy[1] = (int32_t)-step;
  d->error = 0;
}

FC_NOINLINE void fc_coat_put_levels(const fc_tint *tint, const uint32_t v[3], uint8_t *to) {
  uint8_t level[3], i;
  for (i = 0; i < 3; i++) {
    if (tint->transfer != NULL) {
      level[i] = fc_pixel_transfer(tint->transfer, v[i] >> 31 != 0 ? (uint32_t)INT32_MAX : v[i], 255, tint->most[i]);
    } else {
      /* 9 bits */
      const uint32_t whole = (v[i] >> FC_TINT_BITS) + (v[i] >> (FC_TINT_BITS - 1) & 1);
      level[i] = whole > tint->most[i] ? tint->most[i] : (uint8_t)whole;
    }
  }
  fc_pixel_put(tint->format, level, to);
}

FC_NOINLINE void fc_coat_put(const fc_tint *tint, const uint32_t slope[3], uint32_t cosine, uint32_t highlight, uint8_t *to) {
  uint8_t level[3], i;
  for (i = 0; i < 3; i++) {
    /* levels with FC_TINT_BITS of fraction: 32 bits and 31, the sum in 2^-8 of that */
    uint32_t v = ((tint->base[i] + tint->slope[i] * cosine) >> 8) + (slope[i] * highlight >> 8);
    if (tint->transfer != NULL) {
      level[i] = fc_pixel_transfer(tint->transfer, v >> 23 != 0 ? (uint32_t)INT32_MAX : v << 8, 255, tint->most[i]);
    } else {
      v >>= FC_TINT_BITS - 8;
      level[i] = v > tint->most[i] ? tint->most[i] : (uint8_t)v;
    }
  }
  fc_pixel_put(tint->format, level, to);
}

FC_COLD bool fc_coat_weights_set(const fc_scan *scan, fc_coat_weights *weights) {
  int64_t d[3], step, at[3], dx[3], dy[3];
  fc_triangle copy;
  const fc_triangle *triangle = fc_triangle_at(&scan->at->group.shapes, scan->index, &copy);
  uint64_t most = 0;
  uint8_t i, j, bits, shift;
  fc_scan_direction(scan, d, &step);
  for (i = 0; i < 3; i++) {
    /* V_i+1 x V_i+2 has 63 bits, D 30, and W is below 2^61 in 2^32 of that */
    int64_t n[3], right, down;
    fc_cross(scan->form->u.triangle.vertex[i == 2 ? 0 : i + 1], scan->form->u.triangle.vertex[i == 0 ? 2 : i - 1], n);
    at[i] = 0;
    for (j = 0; j < 3; j++) at[i] += fc_smul64hi(n[j], (int32_t)d[j]);
    dx[i] = fc_smul64hi(n[0], (int32_t)step);
    dy[i] = fc_smul64hi(n[1], (int32_t)-step);
    right = dx[i] * (scan->columns - 1);
    down = dy[i] * (scan->rows - 1);
    most |= fc_abs64(at[i]) | fc_abs64(at[i] + right) | fc_abs64(at[i] + down) | fc_abs64(at[i] + right + down);
    weights->vertex[i] = triangle->vertex[i];
  }
  /* floors of 3, and 1 a step: 2^-17 of the greatest in 2^12 pixels and less */
  bits = fc_bits64(most);
  if (bits < 32) return false;
  shift = (uint8_t)(bits - 29);
  for (i = 0; i < 3; i++) {
    weights->at[i] = (int32_t)fc_floor_shift64(at[i], shift);
    weights->dx[i] = (int32_t)fc_floor_shift64(dx[i], shift);
    weights->dy[i] = (int32_t)fc_floor_shift64(dy[i], shift);
  }
  return true;
}

/* ---- layers ---- */

static bool layer_at(const fc_material *material, uint16_t i, fc_layer *layer, fc_coat_layer *coat) {
  fc_layer_kind kind;
  FC_READ_ONE(layer, material->layers + i);
  FC_READ_ONE(&kind, layer->kind);
  if (kind.coat == NULL) return false;
  FC_READ_ONE(coat, kind.coat);
  return true;
}

FC_COLD bool fc_coat_fits(const fc_scan *scan, const fc_material *material) {
  fc_material copy;
  uint16_t i;
  uint8_t roles = 0;
  FC_READ_ONE(&copy, material);
  for (i = 0; i < copy.layer_count; i++) {
    fc_layer layer;
    fc_coat_layer coat;
    if (!layer_at(&copy, i, &layer, &coat) || (roles & coat.role) != 0 || !coat.fits(scan, layer.data)) return false;
    roles |= coat.role;
  }
  /* what is added needs the flat normal's cosine and the tint */
  return (roles & (FC_COAT_ADDS | FC_COAT_MIRRORS)) == 0 || roles == FC_COAT_ADDS || roles == FC_COAT_MIRRORS;
}

enum {
  PLANAR_START,
  PLANAR_COSINES,
  PLANAR_RUN,
  SPHERE_START,
  SPHERE_RUN,
  SPHERE_SEEN
};

static FC_NOINLINE void apply(fc_coat *coat, uint8_t which) {
  uint8_t i;
  for (i = 0; i < coat->layers; i++) {
    const fc_coat_layer *of = &coat->layer[i];
    void (*act)(fc_coat *, const void *);
    switch (which) {
      case PLANAR_START: act = of->planar_start; break;
      case PLANAR_COSINES: act = of->planar_cosines; break;
      case PLANAR_RUN: act = of->planar_run; break;
      case SPHERE_START: act = of->sphere_start; break;
      case SPHERE_RUN: act = of->sphere_run; break;
      default: act = of->sphere_seen; break;
    }
    if (act != NULL) act(coat, coat->data[i]);
  }
}

/* Reads the layers once a tile. */
static FC_COLD void open_coat(fc_coat *coat, fc_scan *scan) {
  fc_material material;
  uint16_t i;
  coat->scan = scan;
  FC_READ_ONE(&material, scan->frame->scene.materials + scan->form->material);
  coat->layers = (uint8_t)material.layer_count;
  for (i = 0; i < material.layer_count; i++) {
    fc_layer layer;
    (void)layer_at(&material, i, &layer, &coat->layer[i]);
    coat->data[i] = layer.data;
  }
}

/* The flat surface's cosines of a run. */
static FC_HOT void flat_cosines(fc_steps q, int32_t g, int32_t dg, uint8_t count, uint32_t *cosine) {
  do {
    *cosine++ = fc_cosine_of(q.at, g);
    fc_steps_next(&q);
    g += dg;
  } while (--count != 0);
}

/* The same by chords of 2^s pixels: within 2^-8 (fc_chord_of). They must not cross the horizon, where cosines are cut to 0. */
static FC_HOT void flat_chords(fc_steps q, int32_t g, int32_t dg, uint8_t count, uint8_t s, uint32_t *cosine) {
  const uint32_t bend = (q.dxx << (2 * s - 1)) - (q.dxx << (s - 1)); /* n dx + n (n - 1) / 2 dxx */
  uint32_t end = fc_cosine_of(q.at, g);
  while (count != 0) {
    uint32_t at = end << 12, step; /* 17 + 12 bits */
    uint8_t n = (uint8_t)(1 << s);
    if (g <= -dg * (INT32_C(1) << s)) {
      flat_cosines(q, g, dg, count, cosine);
      return;
    }
    q.at += (q.dx << s) + bend;
    q.dx += q.dxx << s;
    g += dg * (INT32_C(1) << s);
    end = fc_cosine_of(q.at, g);
    step = (uint32_t)fc_floor_shift32(fc_to_i32((end << 12) - at), s);
    if (n > count) n = count;
    count = (uint8_t)(count - n);
    do {
      *cosine++ = at >> 12;
      at += step;
    } while (--n != 0);
  }
}

static FC_NOINLINE void find_cosines(fc_coat *coat) {
  fc_coat_run *run = &coat->run;
  fc_steps q;
  fc_cosine_row row;
  int32_t g, dg = coat->cosine->dx;
  uint8_t chord;
  fc_steps_start(run->square, run->column, 30, &q);
  row.q = q.at;
  row.dq = q.dx;
  row.ddq = q.dxx;
  /* off by 265 after 32 pixels: 2^-13 of 2^22 and more, half of which the cosine is off by */
  if (fc_cosine_least(&row, run->count) < UINT32_C(1) << 22) {
    run->slow = run->lit;
    return;
  }
  g = coat->cosine->at + run->column * dg + run->row * coat->cosine->dy;
  chord = coat->textured && coat->scan->tint.plain ? fc_chord_of(fc_cosine_least(&row, (uint8_t)(run->count + 14)), row.ddq) : 0;
  if (chord != 0)
    flat_chords(q, g, dg, run->count, chord, run->cosine);
  else
    flat_cosines(q, g, dg, run->count, run->cosine);
}

/* Colours a run by its cosines. */
static FC_HOT void put_pixels(const fc_tint *tint, const uint32_t *cosine, uint32_t bits, uint8_t *to, uint8_t pixel_bytes) {
  for (; bits != 0; bits >>= 1, cosine++, to += pixel_bytes)
    if (bits & 1) fc_tint_put(tint, *cosine, to);
}

/* A run of a tile, and what the light reaches of it. */
static FC_NOINLINE void colour_run(fc_coat *coat, uint16_t row, uint16_t column, uint32_t bits, uint32_t lit) {
  const fc_scan *scan = coat->scan;
  fc_coat_run *run = &coat->run;
  uint8_t i;
  for (; !(bits & 1); bits >>= 1, lit >>= 1) column++;
  run->row = row;
  run->column = column;
  run->bits = bits;
  run->lit = lit;
  run->count = (uint8_t)(32 - fc_clz32(bits));
  run->slow = 0;
  if (coat->cosines && lit != 0) {
    if (coat->smooth.how != FC_SMOOTH_NOT)
      apply(coat, PLANAR_COSINES);
    else
      find_cosines(coat);
  }
  if (coat->cosines && lit != bits)
    for (i = 0; i < run->count; i++)
      if (!(lit >> i & 1)) run->cosine[i] = 0;
  apply(coat, PLANAR_RUN);
  if (!coat->cosines) return;
  if (lit != 0) fc_scan_lit(scan, row, column, lit & ~run->slow);
  if (!coat->textured) put_pixels(&scan->tint, run->cosine, bits & ~run->slow, fc_scan_pixel(scan, row, column), scan->pixel_bytes);
  if ((run->slow & bits) != 0) fc_scan_shade_slowly(scan, row, column, run->slow & bits);
}

FC_COLD void fc_coat_planar(fc_scan *scan, const int64_t normal[3], fc_i128 k, const int64_t *hull, uint8_t corners) {
  const fc_planar *on;
  const fc_cosine *g;
  fc_square square;
  fc_coat coat;
  uint32_t cosine[32], seen[FC_SCAN_WORDS], any = 0;
  uint16_t row, i;
  uint8_t word, reached;
  for (i = 0; i < scan->rows * scan->words; i++) {
    seen[i] = scan->mask[i];
    any |= seen[i];
  }
  if (any == 0) return; /* nothing would be set */
  reached = fc_planar_reach(scan, normal, k, hull, corners, &on, &g);
  if (reached == FC_PLANAR_SLOW) return;
  open_coat(&coat, scan);
  coat.planar = on;
  coat.cosine = g;
  coat.lit = reached == FC_PLANAR_LIT;
  coat.run.square = &square;
  coat.run.cosine = cosine;
  coat.cosines = coat.textured = false;
  coat.smooth.how = FC_SMOOTH_NOT;
  apply(&coat, PLANAR_START);
  if (!coat.lit && !coat.textured) return;
  if (coat.lit && coat.smooth.how == FC_SMOOTH_NOT) fc_square_set(&square, &on->w, &on->w);
  if (!coat.cosines) fc_planar_colour(scan, on, g);
  for (row = 0; row <= scan->last_row; row++) {
    for (word = 0; row >= scan->first_row && word < scan->words; word++) {
      const uint32_t lit = coat.lit ? scan->mask[row * scan->words + word] : 0;
      const uint32_t bits = coat.textured ? seen[row * scan->words + word] : lit;
      if (bits != 0) colour_run(&coat, row, (uint16_t)(32 * word), bits, lit);
    }
    if (coat.lit && coat.smooth.how == FC_SMOOTH_NOT) fc_square_next_row(&square);
  }
}

/* A sphere's coat, as fc_ball_draw wants it. */
typedef struct ball_coat {
  fc_ball_coat calls; /* first */
  fc_coat coat;
} ball_coat;

static FC_COLD void ball_start(fc_ball_coat *of, const fc_ball_light *light, const fc_placed_sphere *placed, int16_t drop, uint32_t error) {
  fc_coat *coat = &((ball_coat *)of)->coat;
  coat->light = light;
  coat->placed = placed;
  coat->drop = drop;
  coat->error = error;
  apply(coat, SPHERE_START);
}

static FC_COLD void ball_run(fc_ball_coat *of, uint16_t row, uint16_t column, uint32_t bits, const uint32_t *p, const uint32_t *e, uint32_t b,
                             uint32_t b_step) {
  fc_coat *coat = &((ball_coat *)of)->coat;
  coat->run.row = row;
  coat->run.column = column;
  coat->run.bits = bits;
  coat->run.p = p;
  coat->run.e = e;
  coat->run.b = b;
  coat->run.b_step = b_step;
  apply(coat, SPHERE_RUN);
}

static FC_COLD void ball_seen(fc_ball_coat *of, uint16_t row, uint16_t column, uint32_t bits, const uint32_t *p) {
  fc_coat *coat = &((ball_coat *)of)->coat;
  coat->run.row = row;
  coat->run.column = column;
  coat->run.bits = bits;
  coat->run.p = p;
  apply(coat, SPHERE_SEEN);
}

FC_COLD void fc_coat_sphere(fc_scan *scan, const fc_placed_sphere *placed) {
  ball_coat of;
  of.calls.start = ball_start;
  of.calls.run = ball_run;
  of.calls.seen = ball_seen;
  open_coat(&of.coat, scan);
  fc_ball_draw(scan, placed, &of.calls);
}

const fc_coat_kind fc_coat_layers FC_ROM = {fc_coat_fits, fc_coat_planar, fc_coat_sphere};
