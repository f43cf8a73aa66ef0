/* Tiles of layered materials: the scan engine's light, then each layer's forms, run by run. */
#include "coat.h"

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

/* ---- layers ---- */

static bool layer_at(const fc_material *material, uint16_t i, fc_layer *layer, fc_coat_layer *coat) {
  fc_layer_kind kind;
  FC_READ_ONE(layer, material->layers + i);
  FC_READ_ONE(&kind, layer->kind);
  if (kind.coat == NULL) return false;
  FC_READ_ONE(coat, kind.coat);
  return true;
}

static FC_COLD bool fits(const fc_scan *scan, const fc_material *material) {
  uint16_t i, layers;
  FC_READ_ONE(&layers, &material->layer_count);
  for (i = 0; i < layers; i++) {
    fc_layer layer;
    fc_coat_layer coat;
    fc_material copy;
    FC_READ_ONE(&copy, material);
    if (!layer_at(&copy, i, &layer, &coat) || !coat.fits(scan, layer.data)) return false;
  }
  return layers == 1; /* their sums would have to be kept */
}

enum { PLANAR_START, PLANAR_RUN, SPHERE_START, SPHERE_RUN };

static FC_NOINLINE void apply(fc_coat *coat, uint8_t which) {
  uint16_t i;
  for (i = 0; i < coat->material.layer_count; i++) {
    fc_layer layer;
    fc_coat_layer of;
    void (*act)(fc_coat *, const void *);
    if (!layer_at(&coat->material, i, &layer, &of)) continue;
    act = which == PLANAR_START ? of.planar_start : which == PLANAR_RUN ? of.planar_run : which == SPHERE_START ? of.sphere_start : of.sphere_run;
    if (act != NULL) act(coat, layer.data);
  }
}

static FC_COLD void open_coat(fc_coat *coat, fc_scan *scan) {
  coat->scan = scan;
  FC_READ_ONE(&coat->material, scan->frame->scene.materials + scan->form->material);
}

static FC_COLD void planar(fc_scan *scan, const int64_t normal[3], fc_i128 k, const int64_t *hull, uint8_t corners) {
  fc_planar on;
  fc_cosine g;
  fc_square square;
  fc_coat coat;
  uint16_t row;
  uint8_t word;
  if (fc_planar_reach(scan, normal, k, hull, corners, &on, &g) != FC_PLANAR_LIT) return;
  fc_planar_colour(scan, &on, &g);
  open_coat(&coat, scan);
  coat.planar = &on;
  coat.cosine = &g;
  coat.run.square = &square;
  fc_square_set(&square, &on.w, &on.w);
  apply(&coat, PLANAR_START);
  for (row = 0; row <= scan->last_row; row++, fc_square_next_row(&square)) {
    if (row < scan->first_row) continue;
    for (word = 0; word < scan->words; word++) {
      coat.run.row = row;
      coat.run.column = (uint16_t)(32 * word);
      coat.run.bits = scan->mask[row * scan->words + word];
      if (coat.run.bits != 0) apply(&coat, PLANAR_RUN);
    }
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

static FC_COLD void sphere(fc_scan *scan, const fc_placed_sphere *placed) {
  ball_coat of;
  of.calls.start = ball_start;
  of.calls.run = ball_run;
  open_coat(&of.coat, scan);
  fc_ball_draw(scan, placed, &of.calls);
}

const fc_coat_kind fc_coat_layers FC_ROM = {fits, planar, sphere};
