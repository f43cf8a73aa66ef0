/* Multiword integers: schoolbook, since they only run when a filter could not decide. */
#include "wide.h"

#include <string.h>

#include "bits.h"

static void trim(fc_wide *r) {
  while (r->count > 0 && r->limb[r->count - 1] == 0) r->count--;
  if (r->count == 0) r->sign = 0;
}

FC_COLD void fc_wide_from(fc_wide *r, fc_i128 v) {
  fc_i128 m = fc_i128_abs(v);
  r->sign = fc_i128_sign(v);
  r->count = 4;
  r->limb[0] = (uint32_t)m.lo;
  r->limb[1] = (uint32_t)(m.lo >> 32);
  r->limb[2] = (uint32_t)m.hi;
  r->limb[3] = (uint32_t)(m.hi >> 32);
  trim(r);
}

FC_COLD void fc_wide_from_i64(fc_wide *r, int64_t v) { fc_wide_from(r, fc_i128_from(v)); }

FC_COLD void fc_wide_neg(fc_wide *a) { a->sign = (int8_t)-a->sign; }

static int8_t compare_magnitude(const fc_wide *a, const fc_wide *b) {
  uint8_t i;
  if (a->count != b->count) return a->count < b->count ? -1 : 1;
  for (i = a->count; i-- > 0;)
    if (a->limb[i] != b->limb[i]) return a->limb[i] < b->limb[i] ? -1 : 1;
  return 0;
}

/* r = sign * (|a| + |b|), |a| at least as long as |b| */
static void add_magnitude(fc_wide *r, const fc_wide *a, const fc_wide *b, int8_t sign) {
  uint64_t carry = 0;
  uint8_t i, n = a->count, nb = b->count;
  for (i = 0; i < n; i++) {
    carry += a->limb[i];
    if (i < nb) carry += b->limb[i];
    r->limb[i] = (uint32_t)carry;
    carry >>= 32;
  }
  if (carry != 0) r->limb[n++] = (uint32_t)carry;
  r->count = n;
  r->sign = sign;
}

/* r = sign * (|a| - |b|), |a| > |b| */
static void sub_magnitude(fc_wide *r, const fc_wide *a, const fc_wide *b, int8_t sign) {
  uint32_t borrow = 0;
  uint8_t i, n = a->count, nb = b->count;
  for (i = 0; i < n; i++) {
    uint64_t take = (uint64_t)(i < nb ? b->limb[i] : 0) + borrow;
    uint32_t from = a->limb[i];
    r->limb[i] = (uint32_t)(from - take);
    borrow = from < take;
  }
  r->count = n;
  r->sign = sign;
  trim(r);
}

static void add_signed(fc_wide *r, const fc_wide *a, const fc_wide *b, int8_t b_sign) {
  int8_t order;
  if (b_sign == 0) {
    if (r != a) *r = *a;
    return;
  }
  if (a->sign == 0) {
    if (r != b) *r = *b;
    r->sign = b_sign;
    return;
  }
  if (a->sign == b_sign) {
    if (a->count >= b->count)
      add_magnitude(r, a, b, b_sign);
    else
      add_magnitude(r, b, a, b_sign);
    return;
  }
  order = compare_magnitude(a, b);
  if (order == 0) {
    r->sign = 0;
    r->count = 0;
  } else if (order > 0) {
    sub_magnitude(r, a, b, a->sign);
  } else {
    sub_magnitude(r, b, a, b_sign);
  }
}

FC_COLD void fc_wide_add(fc_wide *r, const fc_wide *a, const fc_wide *b) { add_signed(r, a, b, b->sign); }

FC_COLD void fc_wide_sub(fc_wide *r, const fc_wide *a, const fc_wide *b) { add_signed(r, a, b, (int8_t)-b->sign); }

FC_COLD void fc_wide_mul(fc_wide *r, const fc_wide *a, const fc_wide *b) {
  fc_wide p;
  uint8_t i, j;
  p.sign = (int8_t)(a->sign * b->sign);
  p.count = 0;
  if (p.sign != 0) {
    p.count = (uint8_t)(a->count + b->count);
    memset(p.limb, 0, (size_t)p.count * sizeof p.limb[0]);
    for (i = 0; i < a->count; i++) {
      uint64_t carry = 0;
      for (j = 0; j < b->count; j++) {
        /* (2^32-1)^2 + 2 (2^32-1) = 2^64 - 1: fits */
        carry += (uint64_t)a->limb[i] * b->limb[j] + p.limb[i + j];
        p.limb[i + j] = (uint32_t)carry;
        carry >>= 32;
      }
      p.limb[i + b->count] = (uint32_t)carry;
    }
    trim(&p);
  }
  *r = p;
}

FC_COLD void fc_wide_mul_i64(fc_wide *r, const fc_wide *a, int64_t b) {
  fc_wide w;
  fc_wide_from_i64(&w, b);
  fc_wide_mul(r, a, &w);
}

FC_COLD void fc_wide_shift_left(fc_wide *r, const fc_wide *a, uint16_t s) {
  uint8_t words = (uint8_t)(s / 32), rest = (uint8_t)(s % 32), i;
  fc_wide p;
  if (a->sign == 0) {
    if (r != a) *r = *a;
    return;
  }
  memset(p.limb, 0, sizeof p.limb);
  p.sign = a->sign;
  p.count = (uint8_t)(a->count + words);
  for (i = 0; i < a->count; i++) {
    uint64_t v = (uint64_t)a->limb[i] << rest;
    p.limb[i + words] |= (uint32_t)v;
    if (v >> 32) {
      p.limb[i + words + 1] = (uint32_t)(v >> 32);
      if (i + 1 == a->count) p.count++;
    }
  }
  *r = p;
}

FC_COLD void fc_wide_dot(fc_wide *r, const fc_wide a[3], const fc_wide b[3]) {
  fc_wide sum, term;
  fc_wide_mul(&sum, &a[0], &b[0]);
  fc_wide_mul(&term, &a[1], &b[1]);
  fc_wide_add(&sum, &sum, &term);
  fc_wide_mul(&term, &a[2], &b[2]);
  fc_wide_add(r, &sum, &term);
}

FC_COLD int8_t fc_surd_sign(const fc_wide *x, const fc_wide *y, const fc_wide *d) {
  fc_wide xx, yy;
  int8_t ys = d->sign == 0 ? 0 : y->sign;
  if (ys == 0 || x->sign == ys) return x->sign == 0 ? ys : x->sign;
  if (x->sign == 0) return ys;
  /* opposite signs: the larger square wins */
  fc_wide_mul(&xx, x, x);
  fc_wide_mul(&yy, y, y);
  fc_wide_mul(&yy, &yy, d);
  switch (compare_magnitude(&xx, &yy)) {
    case 0: return 0;
    case 1: return x->sign;
    default: return ys;
  }
}

FC_COLD int8_t fc_surd_sign2(const fc_wide *x, const fc_wide *y, const fc_wide *d, const fc_wide *z, const fc_wide *e) {
  fc_wide a, b;
  int8_t first = fc_surd_sign(x, y, d);
  int8_t second = e->sign == 0 ? 0 : z->sign;
  if (second == 0 || first == second) return first == 0 ? second : first;
  if (first == 0) return second;
  /* opposite signs: (x + y sqrt d)^2 - z^2 e = (x^2 + y^2 d - z^2 e) + 2 x y sqrt d decides */
  fc_wide_mul(&a, x, x);
  fc_wide_mul(&b, y, y);
  fc_wide_mul(&b, &b, d);
  fc_wide_add(&a, &a, &b);
  fc_wide_mul(&b, z, z);
  fc_wide_mul(&b, &b, e);
  fc_wide_sub(&a, &a, &b);
  fc_wide_mul(&b, x, y);
  fc_wide_add(&b, &b, &b);
  return (int8_t)(first * fc_surd_sign(&a, &b, d));
}
