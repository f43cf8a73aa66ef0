/* When a motion first touches: bisection of an exact decision. */
#ifndef FC_EXTRA_SWEEP_H
#define FC_EXTRA_SWEEP_H

#include <stdbool.h>
#include <stdint.h>

#define FC_TICKS INT32_C(65536)

/* Whether there was contact at or before tick k of FC_TICKS; once true it stays so for greater k. */
typedef bool (*fc_contact_by)(const void *motion, uint32_t k);

/* 1 with the first such tick, or 0. */
int fc_first_contact(fc_contact_by contact_by, const void *motion, uint32_t *t_q16);

/* a + (b - a) k / FC_TICKS in units of 1 / FC_TICKS: 30 + 16 bits. */
void fc_at_tick(int64_t to[3], const int64_t a[3], const int64_t b[3], uint32_t k);

#endif
