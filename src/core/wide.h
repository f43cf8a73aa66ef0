/*
 * Multiword integers for the exact fallbacks, and the signs of expressions with square roots.
 *
 * Sign and magnitude, 32-bit limbs, least significant first. The widest value of any fallback is bounded in
 * docs/SPEC.md; results never exceed FC_WIDE_LIMBS. Results may be the same object as an argument.
 */
#ifndef FC_WIDE_H
#define FC_WIDE_H

#include <stdint.h>

#include "i128.h"

#define FC_WIDE_LIMBS 26

typedef struct fc_wide {
  int8_t sign;   /* -1, 0, 1 */
  uint8_t count; /* limbs in use; the highest is not 0 */
  uint32_t limb[FC_WIDE_LIMBS];
} fc_wide;

void fc_wide_from(fc_wide *r, fc_i128 v);
void fc_wide_from_i64(fc_wide *r, int64_t v);
void fc_wide_add(fc_wide *r, const fc_wide *a, const fc_wide *b);
void fc_wide_sub(fc_wide *r, const fc_wide *a, const fc_wide *b);
void fc_wide_mul(fc_wide *r, const fc_wide *a, const fc_wide *b);
void fc_wide_mul_i64(fc_wide *r, const fc_wide *a, int64_t b);
void fc_wide_shift_left(fc_wide *r, const fc_wide *a, uint16_t s);
void fc_wide_neg(fc_wide *a);

/* a . b over three components. */
void fc_wide_dot(fc_wide *r, const fc_wide a[3], const fc_wide b[3]);

/* The sign of x + y sqrt(d), d >= 0: exact, by comparing squares. */
int8_t fc_surd_sign(const fc_wide *x, const fc_wide *y, const fc_wide *d);

/* The sign of x + y sqrt(d) + z sqrt(e), d, e >= 0. */
int8_t fc_surd_sign2(const fc_wide *x, const fc_wide *y, const fc_wide *d, const fc_wide *z, const fc_wide *e);

#endif
