/* The Bayer matrix of 8x8. */
#include "bayer.h"

#include "fixcast/config.h"

/* clang-format off */

static const uint8_t bayer[8][8] FC_ROM = {{0, 32, 8, 40, 2, 34, 10, 42},  {48, 16, 56, 24, 50, 18, 58, 26},
                                           {12, 44, 4, 36, 14, 46, 6, 38}, {60, 28, 52, 20, 62, 30, 54, 22},
                                           {3, 35, 11, 43, 1, 33, 9, 41},  {51, 19, 59, 27, 49, 17, 57, 25},
                                           {15, 47, 7, 39, 13, 45, 5, 37}, {63, 31, 55, 23, 61, 29, 53, 21}};
/* clang-format on */

void fc_bayer_row(uint8_t b[8], uint16_t x, uint16_t y) {
  uint8_t row[8], i;
  FC_READ(row, bayer[y & 7u], sizeof row);
  for (i = 0; i < 8; i++) b[i] = row[(x + i) & 7u];
}
