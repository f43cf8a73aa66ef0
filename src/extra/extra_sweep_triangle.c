/* A sphere over a time step against a triangle. */
#include <stddef.h>

#include "extra_near.h"
#include "extra_sweep.h"
#include "fixcast/volume_extra.h"
#include "view.h"
#include "volume.h"

typedef struct triangle_motion {
  int64_t from[3], to[3];           /* 30 bits */
  int64_t vertex[3][3], edge[3][3]; /* 46 bits, in ticks; 31 bits, in units */
  int64_t radius;                   /* in ticks */
} triangle_motion;

/* Segment and triangle are nearest where the path goes through the face, at an end of the path over the face, or at an edge. */
static bool triangle_by(const void *motion, uint32_t k) {
  triangle_motion m = *(const triangle_motion *)motion;
  int64_t a[3], b[3];
  uint8_t i;
  fc_at_tick(a, m.from, m.to, 0);
  fc_at_tick(b, m.from, m.to, k);
  if (fc_segment_pierces(a, b, m.vertex, m.edge) || fc_point_near_face(a, m.vertex, m.edge, m.radius) ||
      fc_point_near_face(b, m.vertex, m.edge, m.radius))
    return true;
  for (i = 0; i < 3; i++) {
    const int64_t *p = m.vertex[i], *q = m.vertex[(i + 1) % 3];
    if (fc_point_near_segment(p, a, b, m.radius) || fc_point_near_segment(a, p, q, m.radius) ||
        fc_point_near_segment(b, p, q, m.radius) || fc_segments_near_inside(a, b, p, q, m.radius))
      return true;
  }
  return false;
}

int fc_sweep_sphere_triangle(const fc_sphere *sphere, const fc_vec3 *to, const fc_vec3 triangle[3], uint32_t *t_q16) {
  triangle_motion motion;
  uint8_t i, j;
  int error = fc_volume_check_sphere(sphere);
  if (error == FC_OK) error = fc_volume_load(motion.to, to);
  if (error == FC_OK && triangle == NULL) error = FC_ERR_NULL;
  for (i = 0; i < 3 && error == FC_OK; i++) error = fc_volume_load(motion.vertex[i], triangle + i);
  if (error != FC_OK) return error;
  (void)fc_load(&sphere->center, motion.from);
  motion.radius = (int64_t)sphere->radius * FC_TICKS;
  for (i = 0; i < 3; i++)
    for (j = 0; j < 3; j++) motion.edge[i][j] = motion.vertex[(i + 1) % 3][j] - motion.vertex[i][j];
  for (i = 0; i < 3; i++)
    for (j = 0; j < 3; j++) motion.vertex[i][j] *= FC_TICKS;
  return fc_first_contact(triangle_by, &motion, t_q16);
}
