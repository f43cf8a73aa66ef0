/* Sums of products, schoolbook. */
#include "wide.h"

#include "bits.h"
#include "fixcast/config.h"

FC_COLD void fc_wide_start(fc_wide *w) { w->count = w->start[0] = 0; }

/* n limbs from where the list ends become its last value. */
static FC_COLD void append(fc_wide *w, uint8_t n, int8_t sign) {
  const uint16_t *limb = w->limb + w->start[w->count];
  while (n > 0 && limb[n - 1] == 0) n--;
  w->sign[w->count] = n > 0 ? sign : 0;
  n = (uint8_t)(n + w->start[w->count]);
  w->start[++w->count] = n;
}

/* Two's complement. */
static FC_COLD void negate(uint16_t *limb, uint8_t n) {
  uint32_t carry = 1;
  uint8_t i;
  for (i = 0; i < n; i++) {
    carry += (uint16_t)~limb[i];
    limb[i] = (uint16_t)carry;
    carry >>= 16;
  }
}

FC_COLD void fc_wide_push(fc_wide *w, const fc_i128 *v) {
  uint16_t *to = w->limb + w->start[w->count];
  uint64_t word = v->lo;
  uint8_t i;
  int8_t sign = 1;
  for (i = 0; i < 8; i++) {
    if (i == 4) word = v->hi;
    to[i] = (uint16_t)word;
    word >>= 16;
  }
  if (to[7] >> 15) {
    negate(to, 8);
    sign = -1;
  }
  append(w, 8, sign);
}

FC_COLD void fc_wide_push64(fc_wide *w, int64_t v) {
  fc_i128 wide = fc_i128_from(v);
  fc_wide_push(w, &wide);
}

FC_COLD void fc_wide_keep(fc_wide *w, uint8_t n) {
  uint8_t first = (uint8_t)(w->count - n), gap = w->start[first], i;
  for (i = gap; i < w->start[w->count]; i++) w->limb[i - gap] = w->limb[i];
  for (i = 0; i <= n; i++) {
    w->start[i] = (uint8_t)(w->start[first + i] - gap);
    if (i < n) w->sign[i] = w->sign[first + i];
  }
  w->count = n;
}

/* sum += a b, modulo 2^(16 n). */
static FC_COLD void add_product(uint16_t *sum, uint8_t n, const uint16_t *a, uint8_t a_count, const uint16_t *b,
                                uint8_t b_count) {
  for (; a_count > 0; a_count--, a++, sum++, n--) {
    uint32_t carry = 0, factor = *a;
    uint8_t j;
    for (j = 0; j < b_count; j++) {
      /* (2^16-1)^2 + 2 (2^16-1) = 2^32 - 1: fits */
      carry += factor * b[j] + sum[j];
      sum[j] = (uint16_t)carry;
      carry >>= 16;
    }
    for (; carry != 0 && j < n; j++) {
      carry += sum[j];
      sum[j] = (uint16_t)carry;
      carry >>= 16;
    }
  }
}

static uint8_t next_byte(const uint8_t **program) {
  uint8_t byte;
  FC_READ_ONE(&byte, *program);
  ++*program;
  return byte;
}

FC_COLD void fc_wide_run(fc_wide *w, const uint8_t *program) {
  uint8_t shape;
  while ((shape = next_byte(&program)) != 0) {
    /* `sum` is the value times `sign`, in two's complement of n limbs: one more than its longest product */
    uint16_t *sum = w->limb + w->start[w->count];
    uint8_t n = 0, terms = (uint8_t)((shape >> 4) + (shape & 15));
    int8_t sign = 1;
    for (; terms > 0; terms--) {
      uint8_t factors = next_byte(&program), i = factors >> 4, j = factors & 15;
      uint8_t i_count = (uint8_t)(w->start[i + 1] - w->start[i]), j_count = (uint8_t)(w->start[j + 1] - w->start[j]);
      int8_t term = (int8_t)(w->sign[i] * w->sign[j]);
      if (term == 0) continue;
      if (terms <= (shape & 15)) term = (int8_t)-term;
      for (; n <= i_count + j_count; n++) sum[n] = n > 0 && sum[n - 1] >> 15 ? UINT16_MAX : 0;
      if (term != sign) {
        negate(sum, n);
        sign = term;
      }
      add_product(sum, n, w->limb + w->start[i], i_count, w->limb + w->start[j], j_count);
    }
    if (n > 0 && sum[n - 1] >> 15) {
      negate(sum, n);
      sign = (int8_t)-sign;
    }
    append(w, n, sign);
  }
}
