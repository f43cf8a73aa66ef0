/*
 * Planar receivers under a point light, as affine forms of the pixel (pinhole: the eye is the origin).
 *
 * For a plane n.p = k, k > 0, and a light L: where the ray along D meets it, P = k D / (n.D), and
 *   W = k D - (n.D) L = (n.D) (P - L)
 * is affine in the pixel. So the line from the light through P is known without a division, and the
 * cosine at P is (k - n.L) (n.D) / (|n| |W|).
 */
#ifndef FC_PLANAR_H
#define FC_PLANAR_H

#include <stdint.h>

#include "cone.h"
#include "i128.h"
#include "scan.h"

/* The plane through the light and two corners of a tile, to which W's two other corners lie on one side. */
typedef struct fc_planar_edge {
  int16_t normal[3];      /* 15 bits */
  int8_t side;            /* of the other corners: 1, -1; 0: not for certain, and the rest is not set */
  uint16_t error;         /* of an axis of the normal: below 2^10 */
  uint32_t sum, greatest; /* of the normal's axes */
} fc_planar_edge;

struct fc_planar {
  int64_t normal[3]; /* towards the far side, seen from the eye; below 2^30 */
  int32_t unit[3];   /* the same, Q30, within 2^-25 */
  int64_t k;         /* > 0, below 2^62 */
  int64_t height;    /* k - n.L: > 0 when the light is on the eye's side */
  int64_t slack;     /* k - n.p is within this of what the exact normal says, in units of its cut; 0: the normal is exact */
  int64_t exact[3];  /* before the cut: below 2^63 */
  fc_i128 exact_k;
  fc_sheaf w;                        /* from the light to the points of the tile */
  uint16_t left, right, top, bottom; /* the rectangle that the tile's mask shows */
  /* what glances at an occluder need, found when the first does */
  int16_t corner[4][3];         /* round(W / 2^16) at its corners */
  fc_planar_edge edge[2];       /* upper and lower (scan_sphere.c) */
  uint32_t per_column, per_row; /* 2^32 / steps between corners, below by less than 2 */
  bool corners_known, edges_known, steps_known;
  int64_t work[FC_SHADOW_WORK]; /* of the occluder at hand */
};

/* Find `corner`; `per_column` and `per_row`. */
void fc_planar_find_corners(fc_planar *planar);
void fc_planar_find_steps(fc_planar *planar);

/* The cosine's numerator (k - n.L) (n.D) / |n| in the unit of W: affine too. */
typedef struct fc_cosine {
  int32_t at, dx, dy;
} fc_cosine;

/* What cosines need of a row: W.W / 2^30 and its differences, and the numerator. */
typedef struct fc_cosine_row {
  uint32_t q, dq, ddq;
  int32_t g;
} fc_cosine_row;

/* A quadratic form of the pixel and its differences at the first column of a row, exact; what wraps is not looked at in the tile. */
typedef struct fc_square {
  uint64_t at, dx, dxx; /* value, difference to the next column, its difference */
  uint64_t dy, dyy, dxy;
} fc_square;

static inline void fc_square_next_row(fc_square *s) {
  s->at += s->dy;
  s->dy += s->dyy;
  s->dx += s->dxy;
}

/* a.b modulo 2^64. */
uint64_t fc_dot32(const int32_t a[3], const int32_t b[3]);

/* The least q of the columns from where the forms stand to n on. */
uint32_t fc_cosine_least(const fc_cosine_row *r, uint8_t n);

/* Sets the forms of a row at a column. */
void fc_cosine_start(const fc_square *s, const fc_cosine *g, uint16_t row, uint16_t column, fc_cosine_row *r);

/* The cosine in Q16 where W.W / 2^30 is q and the numerator is g. */
FC_INLINE uint32_t fc_cosine_of(uint32_t q, int32_t g) {
  uint32_t down = 14;
  uint32_t c;
  if (g <= 0 || q < 16) return 0;
  while (q < UINT32_C(1) << 30) {
    q <<= 2;
    down--;
  }
  /* g below 2^(down + 17) sqrt(q / 2^32) and little more, as |W.n| <= |W|: the product is about 2^31 at most */
  c = (((uint32_t)g >> (down + 1)) * fc_rsqrt_q15(q)) >> 15;
  return c > 65536 ? 65536 : c;
}

/* The longest chords that are good enough for q from `least` on: 2^s pixels; 0: none. 6.1^2 m^2 / 2 = 4764, 1191, 298, 75. */
static inline uint8_t fc_chord_of(uint32_t least, uint32_t ddq) {
  /* 4096, 1024, 256 and 64 times 5 / 4 */
  const uint32_t bend = ddq + (ddq >> 2);
  return least >> 12 >= bend ? 4 : least >> 10 >= bend ? 3
                               : least >> 8 >= bend    ? 2
                               : least >> 6 >= bend    ? 1
                                                       : 0;
}

/* What fc_planar_reach left to do. */
enum {
  FC_PLANAR_DARK,
  FC_PLANAR_SLOW,
  FC_PLANAR_LIT
};

/* The light's part of fc_planar_light up to colours: FC_PLANAR_LIT: the mask holds what it reaches, and *planar and *g, in scan->work, are
 * set; all else is coloured. DARK: nothing is lit, SLOW: the ray engine has coloured everything. */
uint8_t fc_planar_reach(fc_scan *scan, const int64_t normal[3], fc_i128 k, const int64_t *hull, uint8_t corners, const fc_planar **planar,
                        const fc_cosine **g);

/* Colours what the mask holds by the tint. */
void fc_planar_colour(fc_scan *scan, const fc_planar *planar, const fc_cosine *g);

/* Shades the masked pixels of a tile on the plane n.p = k: facing, shadows, cosines. |n| below 2^63. They lie within the hull
 * of `corners` points of the plane, three coordinates each; 0: anywhere, for |n| below 2^30 only. */
void fc_planar_light(fc_scan *scan, const int64_t normal[3], fc_i128 k, const int64_t *hull, uint8_t corners);

/* The sign of k - n.p, exact: 1 on the eye's side. */
int8_t fc_planar_side(const fc_planar *planar, const int64_t p[3]);

/* How far a ball may reach beyond a plane n . p = k from the side of its center (above = k - n . C), and the foot of the
 * center on the plane: both too much by up to twice fc_ball_margin, an axis. Not positive: clear of it. unit = n / |n|, Q30
 * within 2^-25; |n| below 2^30, the radius too. */
int64_t fc_ball_foot(const int64_t n[3], const int32_t unit[3], int64_t above, const int64_t center[3], int64_t radius,
                     int64_t foot[3]);

static inline int64_t fc_ball_margin(int64_t radius) { return (radius >> 24) + 2; }

/* Takes pixels of a mask word out of the light. */
static inline void fc_planar_darken(fc_scan *scan, uint16_t row, uint16_t column, uint32_t bits) {
  uint16_t word = (uint16_t)(column / 32);
  scan->mask[row * scan->words + word] &= ~bits;
  fc_scan_unlit(scan, row, (uint16_t)(32 * word), bits);
}

/*
 * Whether a ball reaches the light's side of the receiver at all; false: it shadows nothing there.
 *
 * A line from the light that meets the ball is blocked at P if it meets it before P, and it does when the ball lies
 * wholly on the light's side. If the ball dips below the plane by e, a line may pass P first and meet what is below
 * afterwards; then P is within 2 sqrt(2 r e) + 2 e |L - T| / h of T, the ball's deepest point lifted to the plane, h
 * the light's height. *doubt is a window around those points, empty when the ball does not dip.
 */
bool fc_planar_faces_ball(const fc_scan *scan, const fc_planar *receiver, const int64_t center[3], int64_t radius,
                          fc_window *doubt);

/* Whether an occluder keeps the light from what the pixel shows of the receiver: by the point to the unit where that tells, else by
 * the ray engine. */
bool fc_planar_blocked(const fc_scan *scan, const fc_planar *receiver, uint16_t row, uint16_t column, const fc_kind *kind,
                       const fc_form *occluder);

/* Every masked pixel by the ray engine: for occluders without a fast form. */
void fc_planar_ask(fc_scan *scan, const fc_kind *kind, const fc_form *occluder);

#endif
