/* A sphere's tile while it is drawn, as far as those need it who colour its pixels. */
#ifndef FC_BALL_H
#define FC_BALL_H

#include "quick.h"
#include "scan.h"
#include "scan_kinds.h"

/*
 * Lambert's law from one scalar (lectures: n.l; the point is t D, the normal (P - C) / r). With the light at distance l of
 * the center, s = (P - C).(L - C) / (r l) and h = r / l, the cosine at P is
 *   (s - h) / sqrt(1 + h^2 - 2 s h),
 * lit iff s > h; and s + s0 = (D.(L - C)) t / (r l) with s0 = C.(L - C) / (r l).
 */
typedef struct fc_ball_light {
  int32_t at, dx, dy;      /* D.(L - C) near / (F r l) at the tile's first pixel and its steps, times a power of two */
  int16_t shift;           /* s + s0 = that * 2^31 / m / 2^(16 + shift) / 2^24, m the first 16 bits of p; less p's octave */
  int32_t away, h, sum;    /* Q24; away = s0 + h, sum = 1 + h^2 */
  int32_t margin;          /* Q24: bound on the error of s from 16 bits of p */
  int32_t fine_margin;     /* ... and refined */
  uint8_t octave, octaves; /* p of fewer bits, or octaves or more above them, is left to the ray engine */
  fc_quick depth;          /* near 2^(30 + drop) / F: over p it is t */
  uint32_t curve[3];       /* cosine / (s - h) = curve[0] + x (curve[1] + x curve[2]), Q16, x = s - h; curve[0] 0: see fc_ball_cosine */
  uint8_t occluders;       /* MANY: more than the list holds; UNSOUGHT */
  uint8_t unit;            /* a short vector's unit is 2^this: what lies between light and ball has 15 bits */
  struct {
    uint16_t primitive;
    int16_t radius;  /* of a sphere, short; 0: ask the form */
    uint32_t square; /* of its center */
    union {
      int16_t center[3];       /* of a sphere with a short radius: from the light */
      fc_placed_window window; /* of others: pixels in which it may matter */
    } at;
  } occluder[8];
} fc_ball_light;

/* s - h in Q24 of a pixel with this p, refined (fine_margin); along: the form at the pixel; octave: p is in 2^octave .. */
int32_t fc_ball_refined(const fc_ball_light *light, int32_t along, uint32_t p, uint8_t octave);

/* The cosine in Q16 from s - h = e > 0. */
uint32_t fc_ball_cosine(const fc_ball_light *light, uint32_t e);

/* Who colours the lit pixels of a sphere once more. */
typedef struct fc_ball_coat fc_ball_coat;
struct fc_ball_coat {
  /* Before a tile's first run: near / z = p / 2^(30 + drop), off by at most `error`. */
  void (*start)(fc_ball_coat *coat, const fc_ball_light *light, const fc_placed_sphere *placed, int16_t drop, uint32_t error);
  /* Pixels of a row that are lit, and have been coloured: p and s - h of each; b: p less its root at `column`, and b's step. */
  void (*run)(fc_ball_coat *coat, uint16_t row, uint16_t column, uint32_t bits, const uint32_t *p, const uint32_t *e, uint32_t b,
              uint32_t b_step);
  /* All pixels of a row's run that show the sphere, after those that are lit. */
  void (*seen)(fc_ball_coat *coat, uint16_t row, uint16_t column, uint32_t bits, const uint32_t *p);
};

/* Draws a tile of a sphere in front of the eye; coat may be NULL. */
void fc_ball_draw(fc_scan *scan, const fc_placed_sphere *placed, fc_ball_coat *coat);

#endif
