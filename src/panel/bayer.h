/*
 * The matrix of ordered dither, the one home of what a value becomes where a display has fewer levels.
 *
 * B(x, y) is the Bayer matrix of 8x8 with the values 0..63, M(8) of
 *   M(2n) = 4 M(n) + (0 2 / 3 1) spread over the quarters, M(1) = (0), (B. E. Bayer, An optimum method for two-level rendition of continuous-tone
 *   pictures, ICC 1973), at column x mod 8 and row y mod 8. A value v of 0..m becomes the level, of 0..n,
 *   floor(n v / m + (2 B + 1) / 128).
 * 0 always becomes 0, m always n, and over 64 pixels of one v the mean level is within 1/128 of n v / m.
 */
#ifndef FC_BAYER_H
#define FC_BAYER_H

#include <stdint.h>

/* A row of the matrix, turned so that b[i & 7] belongs to the pixel at (x + i, y). */
void fc_bayer_row(uint8_t b[8], uint16_t x, uint16_t y);

/* What is still missing to the next level, in 128ths, 1..127: the level is raised when the remainder of n v / m, times 128 / m, is at least this. */
static inline uint8_t fc_bayer_missing(uint8_t b) { return (uint8_t)(127 - 2 * b); }

#endif
