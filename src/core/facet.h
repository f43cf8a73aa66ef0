/*
 * A triangle over a rectangle of pixels, as affine forms of the column and the row: three edges and near / z.
 *
 * Edge forms are 32-bit integers. A pixel's centre is outside for certain where one of them is below 0, inside for certain where
 * all of them are at least `certain`; in between the ray engine is asked. near / z = p / 2^(62 + drop), off by at
 * most error / 2^(30 + drop) at the pixels inside.
 */
#ifndef FC_FACET_H
#define FC_FACET_H

#include "mesh.h"

typedef struct fc_facet {
  int32_t at[3], dx[3], dy[3]; /* at the rectangle's first pixel; to the next column; to the next row */
  int32_t certain;
  uint64_t p, px, py;    /* two's complement */
  uint32_t error, least; /* p / 2^32 is nowhere inside less than `least` */
  int16_t drop;
} fc_facet;

/* Corners on the screen: 2^fraction units a pixel from the frame's centre, x to the right, y downwards. Each is within
 * FC_CORNER_ERROR units of the true place. near: the mantissa of `seen` times the mesh's depth / 2^32, 0 when not seen; and its exponent. */
typedef struct fc_corners {
  int32_t x[3], y[3];
  uint32_t near[3];
  uint8_t exponent[3];
  uint8_t fraction;
} fc_corners;

/* 2 from rounding, and 2^30 times the relative error 2^-27 that x, y and near / z have in common. */
#define FC_CORNER_ERROR 10

/* A rectangle of pixels, x1 and y1 included. */
typedef struct fc_tile {
  int32_t x0, x1, y0, y1;
} fc_tile;

/* Edge forms over `tile`, which lies within `box`, the pixels around the corners. False when the corners tell too little; *hidden
 * when they say that the triangle faces the way that is not drawn (`hidden` as in fc_form). */
bool fc_facet_edges(fc_facet *facet, const fc_frame *frame, const fc_corners *corners, const fc_tile *box,
                    const fc_tile *tile, int8_t hidden_side, bool *hidden);

/* near / z over the tile; false when it is too steep. */
bool fc_facet_depth(fc_facet *facet, const fc_frame *frame, const fc_placed_mesh *mesh, const fc_corners *corners,
                    const fc_tile *box, const fc_tile *tile);

/* Both from the prepared form: no vertex need be in front of the eye. False when the triangle is seen edge-on. */
bool fc_facet_exact(fc_facet *facet, const fc_frame *frame, const fc_prepared *prepared, const fc_tile *tile);

/* The same for a triangle within FC_SMALL pixels a side, in 32 bits, and for the whole of it: most have few pixels. */
#define FC_SMALL 32

typedef struct fc_small_facet {
  const fc_corners *corners;
  const fc_tile *box, *tile;
  int32_t x[3], y[3]; /* corners from top to bottom, from the tile's first pixel, in 2^-16 pixels, below 2^22 */
  uint32_t side;      /* the longer side of its box, and 2 pixels */
  int32_t margin;     /* an edge form of corners a, b is off by less than this: (P - a) x (b - a), in pixels by 2^-16 pixels */
  bool left;          /* the middle corner is on the left of the other two */
  uint32_t p, px, py; /* near / z = p / 2^(30 + drop), p between least and most inside */
  uint32_t error, least, most;
  int16_t drop;
} fc_small_facet;

/* What the corners tell: too little, or not in 32 bits; that the triangle's hidden side is seen; the forms. */
enum {
  FC_FACET_UNCLEAR,
  FC_FACET_HIDDEN,
  FC_FACET_SEEN
};

/* floor(a b / 2^16): a, b below 2^22 in size. */
static inline int32_t fc_product16(int32_t a, int32_t b) {
#ifdef FC_SHORT_MULTIPLIER
  uint32_t a0 = (uint32_t)a & 0xffffu, b0 = (uint32_t)b & 0xffffu;
  return fc_floor_shift32(a, 16) * b + (int32_t)a0 * fc_floor_shift32(b, 16) + (int32_t)((a0 * b0) >> 16);
#else
  return (int32_t)fc_floor_shift64((int64_t)a * b, 16);
#endif
}

/* Edges, from corners, box and tile. */
uint8_t fc_small_edges(fc_small_facet *facet, const fc_frame *frame, int8_t hidden_side);

/* near / z, after the edges; false when it is too steep. */
bool fc_small_depth(fc_small_facet *facet, const fc_frame *frame, const fc_placed_mesh *mesh);

/* Cuts *first .. *last to the columns below `columns` where a form at + dx column is at least `bound`, by bisection. */
void fc_facet_cut(int32_t at, int32_t dx, int32_t bound, uint16_t columns, int32_t *first, int32_t *last);

#endif
