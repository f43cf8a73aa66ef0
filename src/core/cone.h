/*
 * A sphere seen along directions that are affine in the pixel: one quadratic form, differenced exactly.
 *
 * Seen from a point at C from its centre, the line along W meets a sphere iff
 *   f(W) = (C.W)^2 - (|C|^2 - r^2) W.W >= 0   (lecture: discriminant of the ray's quadratic equation).
 * Along a row f is a second-order form in the column, so two additions a pixel follow it.
 */
#ifndef FC_CONE_H
#define FC_CONE_H

#include <stdint.h>

#include "bits.h"

/* Directions W(column, row) = at + column dx + row dy; every component within 2^30 in the whole tile. */
typedef struct fc_sheaf {
  int32_t at[3], dx[3], dy[3];
  uint32_t error; /* each component is within this of the direction it stands for (times a positive number) */
} fc_sheaf;

typedef struct fc_cone {
  int64_t f, dx, dxx;   /* of the current row: value and first difference at its first column; second difference */
  int64_t dy, dyy, dxy; /* to the next row */
  int64_t error;        /* f is within this of f(W) 2^(scale - 64) */
  int8_t scale;         /* even, -2 .. 62 */
} fc_cone;

/* center: from the point the directions start at, components below 2^31, each within center_error (0 or 1). Tiles of up to
 * 2^12 columns and rows. */
void fc_cone_setup(fc_cone *cone, const int64_t center[3], int64_t radius, uint8_t center_error, const fc_sheaf *sheaf,
                   uint16_t columns, uint16_t rows);

static inline void fc_cone_next_row(fc_cone *cone) {
  /* sums wrap on the way, the forms themselves fit */
  cone->f = fc_to_i64((uint64_t)cone->f + (uint64_t)cone->dy);
  cone->dy = fc_to_i64((uint64_t)cone->dy + (uint64_t)cone->dyy);
  cone->dx = fc_to_i64((uint64_t)cone->dx + (uint64_t)cone->dxy);
}

#endif
