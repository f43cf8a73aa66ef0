/* Spheres over a time step, against planes and each other. */
#include "extra_sweep.h"

#include <stddef.h>

#include "bits.h"
#include "extra_near.h"
#include "fixcast/volume_extra.h"
#include "i128.h"
#include "segment.h"
#include "view.h"
#include "volume.h"
#include "wide.h"

int fc_first_contact(fc_contact_by contact_by, const void *motion, uint32_t *t_q16) {
  uint32_t apart = 0, touching = FC_TICKS;
  if (!contact_by(motion, FC_TICKS)) return 0;
  if (t_q16 == NULL) return 1;
  *t_q16 = 0;
  if (contact_by(motion, 0)) return 1;
  while (touching - apart > 1) {
    const uint32_t middle = (apart + touching) / 2;
    if (contact_by(motion, middle))
      touching = middle;
    else
      apart = middle;
  }
  *t_q16 = touching;
  return 1;
}

void fc_at_tick(int64_t to[3], const int64_t a[3], const int64_t b[3], uint32_t k) {
  uint8_t i;
  for (i = 0; i < 3; i++) to[i] = a[i] * FC_TICKS + (b[i] - a[i]) * (int64_t)k;
}

/* ---- plane ---- */

typedef struct plane_motion {
  int64_t start, end; /* n . c + d: 63 bits */
  int64_t normal[3];
  int64_t radius;
} plane_motion;

static bool plane_by(const void *motion, uint32_t k) {
  static const uint8_t program[] FC_ROM = {FC_SUM(3, 0), FC_TIMES(2, 2), FC_TIMES(3, 3), FC_TIMES(4, 4), /* 5: n^2, 62 bits */
                                           FC_SUM(1, 0), FC_TIMES(1, 1),                                 /* 6: r^2, 92 bits */
                                           FC_SUM(1, 1), FC_TIMES(5, 6), FC_TIMES(0, 0), 0};
  const plane_motion *m = (const plane_motion *)motion;
  /* the distance at tick k, or at the start when it only grows: 63 + 16 bits */
  fc_i128 start = fc_i128_mul(m->start, FC_TICKS);
  fc_i128 now = fc_i128_add(fc_i128_mul(m->start, FC_TICKS - (int64_t)k), fc_i128_mul(m->end, (int64_t)k));
  fc_wide w;
  if (fc_i128_sign(start) * fc_i128_sign(now) < 0) return true; /* through it */
  if (fc_i128_compare(fc_i128_abs(start), fc_i128_abs(now)) < 0) now = start;
  fc_wide_start(&w);
  fc_wide_push(&w, &now);
  fc_wide_push64(&w, m->radius * FC_TICKS);
  fc_wide_push64(&w, m->normal[0]);
  fc_wide_push64(&w, m->normal[1]);
  fc_wide_push64(&w, m->normal[2]);
  fc_wide_run(&w, program);
  return w.sign[7] >= 0;
}

int fc_sweep_sphere_plane(const fc_sphere *sphere, const fc_vec3 *to, const fc_plane *plane, uint32_t *t_q16) {
  int64_t from[3], end[3];
  plane_motion motion;
  int error = fc_volume_check_sphere(sphere);
  if (error == FC_OK) error = fc_volume_load(end, to);
  if (error == FC_OK) error = fc_volume_check_plane(plane);
  if (error != FC_OK) return error;
  (void)fc_load(&sphere->center, from);
  (void)fc_load(&plane->normal, motion.normal);
  motion.start = fc_plane_value(plane, from);
  motion.end = fc_plane_value(plane, end);
  motion.radius = sphere->radius;
  return fc_first_contact(plane_by, &motion, t_q16);
}

/* ---- sphere ---- */

typedef struct sphere_motion {
  int64_t from[3], to[3]; /* of the one, seen from the other: 31 bits */
  int64_t reach;
} sphere_motion;

static bool sphere_by(const void *motion, uint32_t k) {
  static const int64_t origin[3] = {0, 0, 0};
  const sphere_motion *m = (const sphere_motion *)motion;
  int64_t a[3], b[3]; /* at most 2^31 2^16 */
  fc_at_tick(a, m->from, m->to, 0);
  fc_at_tick(b, m->from, m->to, k);
  return fc_point_near_segment(origin, a, b, m->reach * FC_TICKS);
}

int fc_sweep_sphere_sphere(const fc_sphere *a, const fc_vec3 *a_to, const fc_sphere *b, const fc_vec3 *b_to, uint32_t *t_q16) {
  int64_t p[3], q[3], r[3], s[3];
  sphere_motion motion;
  uint8_t i;
  int error = fc_volume_check_sphere(a);
  if (error == FC_OK) error = fc_volume_check_sphere(b);
  if (error == FC_OK) error = fc_volume_load(r, a_to);
  if (error == FC_OK) error = fc_volume_load(s, b_to);
  if (error != FC_OK) return error;
  (void)fc_load(&a->center, p);
  (void)fc_load(&b->center, q);
  for (i = 0; i < 3; i++) {
    motion.from[i] = p[i] - q[i];
    motion.to[i] = r[i] - s[i];
  }
  motion.reach = (int64_t)a->radius + b->radius;
  return fc_first_contact(sphere_by, &motion, t_q16);
}
