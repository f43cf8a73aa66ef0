/*
 * Whole numbers of any length for exact decisions: a list of values, made by programs of a byte a product.
 *
 * Sign and magnitude, 16-bit limbs, least significant first: a product of two limbs and two sums fit 32 bits. The values lie one
 * after the other in the list's own memory; docs/SPEC.md bounds how much the decisions need.
 */
#ifndef FC_WIDE_H
#define FC_WIDE_H

#include <stdint.h>

#include "i128.h"

enum {
  FC_WIDE_LIMBS = 128,
  FC_WIDE_VALUES = 18
};

typedef struct fc_wide {
  uint8_t count;
  uint8_t start[FC_WIDE_VALUES + 1]; /* first limb of each value, and of what comes next; the highest limb is not 0 */
  int8_t sign[FC_WIDE_VALUES];       /* -1, 0, 1 */
  uint16_t limb[FC_WIDE_LIMBS];
} fc_wide;

void fc_wide_start(fc_wide *w);
void fc_wide_push(fc_wide *w, const fc_i128 *v);
void fc_wide_push64(fc_wide *w, int64_t v);

/* All but the last n values go. */
void fc_wide_keep(fc_wide *w, uint8_t n);

/*
 * Appends sums of products. A value is a byte with the numbers of terms to add and to subtract, FC_SUM(a, s), and a byte for each,
 * FC_TIMES(i, j): the product of the values i and j. A 0 ends the program.
 */
#define FC_SUM(plus, minus) ((plus) << 4 | (minus))
#define FC_TIMES(i, j) ((i) << 4 | (j))
#define FC_NOTHING FC_SUM(1, 1), FC_TIMES(0, 0), FC_TIMES(0, 0) /* the value 0 */
void fc_wide_run(fc_wide *w, const uint8_t *program);

#endif
