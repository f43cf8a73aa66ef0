/*
 * The scan engine: strips drawn a primitive at a time, by spans and forward differences.
 *
 * Fast forms decide what they can prove; a pixel that they leave open goes to fc_scan_exact or fc_scan_blocked, which
 * ask the ray engine's predicates. So the picture is the ray engine's by construction, wherever a form's
 * error bound is right; tests hold the two equal.
 */
#ifndef FC_SCAN_H
#define FC_SCAN_H

#include <stdbool.h>
#include <stdint.h>

#include "kind.h"
#include "quick.h"
#include "space.h"
#include "view.h"

/* Words of a tile's mask. */
#define FC_SCAN_WORDS 64
/* How the frame is lit: not at all; by one light that the fast forms can serve; otherwise, by fc_shade, pixel by pixel. */
enum {
  FC_LIGHT_NONE,
  FC_LIGHT_ONE,
  FC_LIGHT_MANY
};

/* Most rows of a tile. */
#define FC_SCAN_ROWS 16

#define FC_TINT_BITS 23

/* What a surface looks like under the frame's only light: level = floor((base + slope c) / 2^FC_TINT_BITS), c the
 * cosine in Q16. */
typedef struct fc_tint {
  uint32_t base[3];            /* with the rounding half */
  uint32_t slope[3];           /* below 2^15 */
  uint8_t most[3];             /* the format's greatest levels */
  bool clamp;                  /* the sum may exceed them */
  uint8_t format;              /* fc_format */
  bool plain;                  /* FC_RGB565_BE, and no clamp */
  uint8_t unlit[4];            /* the pixel's bytes without the light */
  const fc_transfer *transfer; /* with one, the levels are those of 255, before rounding */
} fc_tint;

/* What exact answers are found in; one at a time. */
typedef struct fc_asked {
  fc_surface surface;
  fc_room room;
} fc_asked;

/* Words that a kind draws in, and those of an occluder's shadow among them (planar.h). */
#define FC_SCAN_WORK (sizeof(void *) > 4 ? 126 : 118)
#define FC_SHADOW_WORK 44

/* What draws a material's layers by fast forms (coat.h). */
typedef struct fc_coat_kind fc_coat_kind;

/* A primitive being drawn into a rectangle of the frame, of which the strip holds some rows. Where tiles lie depends on the
 * primitive alone, so that forms, which are rounded at a tile's origin, are the same for every strip height. */
struct fc_scan {
  const fc_frame *frame;
  const fc_target *target;
  const fc_cursor *at; /* the primitive's table */
  const fc_form *form;
  uint16_t primitive, index; /* its number, and its place in the table */
  uint16_t strip;            /* frame row of the target's row 0 */
  uint16_t x, y;             /* the tile's first pixel, in the frame */
  uint16_t columns;
  uint8_t rows, words;         /* words of mask a row */
  uint8_t first_row, last_row; /* those that the strip holds */
  uint8_t pixel_bytes;
  uint8_t light; /* FC_LIGHT_... */
  bool clip_far; /* the far limit may cut the primitive */
  bool clear;    /* nothing keeps the light from what of the table faces it */
  uint8_t skip;  /* rows of the frame with this parity are left out; FC_SKIP_NONE: none */
  fc_tint tint;
  fc_asked *asked;              /* below */
  const fc_coat_kind *coat;     /* NULL: the material is matte, or light is FC_LIGHT_MANY */
  uint32_t mask[FC_SCAN_WORDS]; /* bit i of word j of a row: pixel 32 j + i shows the primitive */
  /* What would crowd the stack, where calls are deepest: */
  fc_target drawn; /* a target in the order of bytes that inner loops know */
  fc_space space;
  fc_cursor cursor;
  fc_form item;
  fc_window box;
  fc_asked answer;
  int64_t work[FC_SCAN_WORK]; /* of the kind that draws: where its forms and rows of pixels lie */
};

#define FC_SKIP_NONE 2

/* Whether a row of the tile is left out. */
static inline bool fc_scan_skips(const fc_scan *scan, uint16_t row) { return ((scan->y + row) & 1) == scan->skip; }

/* Depth codes along a row: what changes only when near / z crosses a power of two. */
typedef struct fc_coder {
  uint32_t low;      /* codes of p in low .. 2 low - 1 ... */
  uint32_t half;     /* 2^(shift-1) */
  uint32_t low_bits; /* 2^shift - 1 */
  int32_t base;      /* ... are base + round(p / 2^shift) */
  uint8_t shift;
} fc_coder;

/* For values p with near / z = p / 2^(30 + drop). */
void fc_coder_start(fc_coder *coder, const fc_frame *frame, int16_t drop, uint32_t p);

/* Follows p into its octave. */
static inline void fc_coder_follow(fc_coder *coder, const fc_frame *frame, uint32_t p) {
  while (p < coder->low && coder->shift > 1) {
    coder->low >>= 1;
    coder->half >>= 1;
    coder->low_bits >>= 1;
    coder->shift--;
    coder->base -= INT32_C(1) << (16 - frame->depth_exponent_bits);
  }
  while (p >> 1 >= coder->low) {
    coder->low <<= 1;
    coder->half <<= 1;
    coder->low_bits = 2 * coder->low_bits + 1;
    coder->shift++;
    coder->base += INT32_C(1) << (16 - frame->depth_exponent_bits);
  }
}

/* p + half + error, of an octave, may round either way when its low bits are up to this. Below an octave codes are twice as
 * fine: p at its lower end may stand for them when the error exceeds half / 2, and all are open then. */
static inline uint32_t fc_coder_open(const fc_coder *coder, uint32_t error) {
  return 2 * error > coder->half ? coder->low_bits : 2 * error;
}

/* The code of p (followed), or -1 when an error of `error` leaves it open. Values of 1 and more saturate. */
static inline int32_t fc_coder_code(const fc_coder *coder, uint32_t p, uint32_t error) {
  /* p + half, cut by the shift; within 2 error of a multiple of 2^shift, so it may be either */
  uint32_t up = p + coder->half + error;
  int32_t code = coder->base + (int32_t)(up >> coder->shift);
  if ((up & (coder->low_bits)) <= fc_coder_open(coder, error) || code <= 1) return -1;
  return code > UINT16_MAX ? UINT16_MAX : code;
}

/* The tile's depth at a column of a row. */
static inline uint16_t *fc_scan_depth(const fc_scan *scan, uint16_t row, uint16_t column) {
  return scan->target->depth + (size_t)(scan->y - scan->strip + row) * scan->frame->width + scan->x + column;
}

static inline uint8_t *fc_scan_pixel(const fc_scan *scan, uint16_t row, uint16_t column) {
  return (uint8_t *)scan->target->pixels + (size_t)(scan->y - scan->strip + row) * scan->target->pitch_bytes +
         (size_t)(scan->x + column) * scan->pixel_bytes;
}

/* Sets light and tint for scan->form's material. */
void fc_scan_tint(fc_scan *scan);

/* The tint's slope of a reflectance under the frame's only light; 2^15 and more: too bright for the fast forms. */
uint32_t fc_scan_slope(const fc_scan *scan, uint16_t reflectance, uint8_t channel);

/* Decides a pixel by the ray engine: true when the primitive is what it shows so far; its depth is then written. */
bool fc_scan_exact(const fc_scan *scan, uint16_t row, uint16_t column);

/* Whether the sign of a shadow's form is good enough within its error bound too. */
static inline bool fc_scan_guesses(const fc_scan *scan) { return scan->frame->options.profile == FC_PROFILE_FAST; }

/* far_shift of a frame whose far limit only the ray engine can tell. */
#define FC_FAR_EXACT 255

/* The checks that both engines' strips begin with: bytes of a pixel, or an error. */
int fc_render_check(const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target);

/* A strip's parts, after the checks: background everywhere; the rows that aren't of parity `skip`; the other byte order of
 * FC_RGB565_LE, for which the first two write FC_RGB565_BE. */
void fc_strip_clear(const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target);
void fc_strip_draw(fc_scan *scan, const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target, uint8_t skip);
void fc_strip_finish(const fc_frame *frame, uint16_t rows, const fc_target *target);

/* Depth tests of a row between two columns (inclusive), near / z affine: value / 2^(62 - gain) at `first`, off by at
 * most error / 2^(30 - gain); pixels with a value below 0 are missed, the others hit for certain. Sets the row's mask. The coder was
 * started for drop -gain; rows follow each other in it. */
void fc_scan_affine(fc_scan *scan, uint16_t row, uint16_t first, uint16_t last, int64_t value, int64_t step,
                    uint8_t gain, uint32_t error, fc_coder *coder);

/* Whether one occluder keeps the light from the primitive there, by the ray engine. */
bool fc_scan_blocked(const fc_scan *scan, uint16_t row, uint16_t column, const fc_kind *kind, const fc_form *occluder);

/* Every pixel of the tile by the ray engine: what a kind falls back to where its fast forms do not hold. */
void fc_scan_slowly(fc_scan *scan);

/* -1, 0, 1: near / z = p / 2^30, off by at most error / 2^30, lies beyond the far limit, too close to tell, within. */
int8_t fc_scan_far(const fc_scan *scan, uint16_t row, uint16_t column, uint32_t p, uint32_t error);

/* Colours a pixel in any format. */
void fc_tint_put_any(const fc_tint *tint, uint32_t cosine, uint8_t *to);

static inline uint32_t fc_tint_level(const fc_tint *tint, uint8_t channel, uint32_t cosine) {
  return (tint->base[channel] + tint->slope[channel] * cosine) >> FC_TINT_BITS;
}

/* Colours a pixel that the light reaches, from the cosine in Q16. */
static inline void fc_tint_put(const fc_tint *tint, uint32_t cosine, uint8_t *to) {
  if (tint->plain) {
    uint32_t packed = fc_tint_level(tint, 0, cosine) << 6;
    packed = (packed | fc_tint_level(tint, 1, cosine)) << 5;
    packed |= fc_tint_level(tint, 2, cosine);
    to[0] = (uint8_t)(packed >> 8);
    to[1] = (uint8_t)packed;
  } else {
    fc_tint_put_any(tint, cosine, to);
  }
}

/* Notes for the target that the light reaches the pixels of a row in `bits`. */
void fc_scan_lit(const fc_scan *scan, uint16_t row, uint16_t column, uint32_t bits);

/* Colours as unlit. */
void fc_scan_unlit(const fc_scan *scan, uint16_t row, uint16_t column, uint32_t bits);

/* Shades pixels by the ray engine. */
void fc_scan_shade_slowly(const fc_scan *scan, uint16_t row, uint16_t column, uint32_t bits);

/* Writes what else the target wants of visible pixels, and shades them where no fast form may; false when it has. */
bool fc_scan_wants_light(const fc_scan *scan, uint16_t row, uint16_t column, uint32_t bits);

/* The direction of a tile's first pixel; one column adds *step to x, one row takes it from y. */
static inline void fc_scan_direction(const fc_scan *scan, int64_t at[3], int64_t *step) {
  fc_view_direction(scan->frame, scan->x, scan->y, at);
  *step = INT64_C(2) << scan->frame->view.pixel_shift;
}

#endif
