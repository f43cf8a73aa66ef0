/*
 * What reads a mesh's vertices in world coordinates, written once for every width of a vertex.
 *
 * Included by each kind of triangles, which says how it reads a vertex: so no kind asks at run time how wide a vertex is.
 */
#ifndef FC_MESH_WORLD_H
#define FC_MESH_WORLD_H

#include <stdbool.h>
#include <stdint.h>

#include "bits.h"
#include "fixcast/error.h"
#include "kind.h"
#include "mesh.h"
#include "scan_kinds.h"
#include "transform.h"
#include "view.h"

/* What kinds of triangles share (kind.h). */
void fc_triangle_prepare(const fc_form *form, const int64_t origin[3], fc_prepared *prepared);
uint8_t fc_triangle_test(const fc_prepared *prepared, const int64_t direction[3], fc_root *root);
bool fc_triangle_blocked(const fc_form *form, fc_segment *segment);
bool fc_triangle_facing(const fc_form *form, fc_segment *segment);
void fc_triangle_normal(const fc_form *form, const int64_t point[3], int64_t n[3]);
int8_t fc_triangle_side(const fc_form *form, const int64_t point[3]);
void fc_triangle_weights(const fc_prepared *prepared, const int64_t direction[3], uint32_t weight_q30[3]);
void fc_triangle_depth_range(const fc_frame *frame, const fc_group *group, uint64_t *near, uint64_t *far);
void fc_triangle_bounds(const fc_form *form, int64_t low[3], int64_t high[3]);

/* Strips are drawn whole: no window, no draw, and no hides; casts and settles one by one. */
#define FC_KIND_OF_TRIANGLES(check, extent, place, fetch) \
  { \
    check, fc_mesh_memory, extent, place, fetch, fc_triangle_prepare, fc_triangle_test, fc_triangle_blocked, \
        fc_triangle_facing, fc_triangle_normal, fc_triangle_side, fc_triangle_weights, fc_triangle_depth_range, \
        fc_triangle_project, NULL, NULL, fc_triangle_shadow, fc_triangle_between, NULL, fc_triangle_strip, \
        fc_triangle_bounds, fc_triangle_casts, NULL, NULL \
  }

/* The reader: the includer defines it. */
static inline void fc_read_world(const fc_shapes *shapes, uint16_t index, fc_vec3 *v);

static int check(const fc_scene *scene, const fc_shapes *shapes) {
  uint16_t i;
  if (shapes->vertices == NULL && shapes->vertex_count > 0) return FC_ERR_NULL;
  for (i = 0; i < shapes->vertex_count; i++) {
    fc_vec3 v;
    fc_read_world(shapes, i, &v);
    if (fc_abs32(v.x) > (uint32_t)FC_COORDINATE_MAX || fc_abs32(v.y) > (uint32_t)FC_COORDINATE_MAX ||
        fc_abs32(v.z) > (uint32_t)FC_COORDINATE_MAX)
      return FC_ERR_COORDINATE;
  }
  for (i = 0; i < shapes->count; i++) {
    fc_triangle t;
    fc_read_triangle(shapes, i, &t);
    if (t.vertex[0] >= shapes->vertex_count || t.vertex[1] >= shapes->vertex_count ||
        t.vertex[2] >= shapes->vertex_count || t.material >= scene->material_count)
      return FC_ERR_INDEX;
  }
  return FC_OK;
}

/* The eye in whole units of 2^r world coordinates, floor; r is the least, returned, with which it has the range of a coordinate. */
static FC_COLD uint8_t whole_eye(const fc_view *view, int32_t eye[3]) {
  uint8_t i, down = 0;
  for (i = 0; i < 3; i++)
    while (fc_abs64(fc_floor_shift64(view->eye[i], (uint8_t)(view->fine + down))) > (uint64_t)FC_COORDINATE_MAX) down++; /* 2^61 at most */
  for (i = 0; i < 3; i++) eye[i] = (int32_t)fc_floor_shift64(view->eye[i], (uint8_t)(view->fine + down));
  return down;
}

/* Offsets from the eye in units of 2^(down + shift) world coordinates: a, below 2^14, stands for more than a - 1 and less than a + 1, as both
 * ends are rounded down; so three squares are off by less than 6 a + 3, the slack. */
typedef struct fc_eye_squares {
  int32_t eye[3]; /* 2^down */
  uint8_t down, shift;
  uint32_t slack;
} fc_eye_squares;

static inline void eye_offset(const fc_eye_squares *s, const fc_vec3 *v, uint32_t offset[3]) {
  offset[0] = fc_abs32(fc_floor_shift32(v->x, s->down) - s->eye[0]) >> s->shift; /* 30 bits less 30 */
  offset[1] = fc_abs32(fc_floor_shift32(v->y, s->down) - s->eye[1]) >> s->shift;
  offset[2] = fc_abs32(fc_floor_shift32(v->z, s->down) - s->eye[2]) >> s->shift;
}

/* Where a power of two lies too near: by exact distances. */
static FC_COLD fc_num exact_extent(const fc_view *view, const fc_shapes *shapes) {
  fc_num most = {0, 0};
  uint16_t i;
  for (i = 0; i < shapes->vertex_count; i++) {
    fc_vec3 v;
    int64_t offset[3];
    fc_num distance;
    fc_read_world(shapes, i, &v);
    fc_view_offset(view, &v, offset);
    distance = fc_length(offset);
    if (fc_num_compare(distance, most) > 0) most = distance;
  }
  return most;
}

static fc_num extent(const fc_view *view, const fc_shapes *shapes) {
  fc_eye_squares found;
  uint32_t all = 0, most = 0;
  uint16_t i;
  uint8_t bits, pass;
  found.down = whole_eye(view, found.eye);
  found.shift = 0;
  found.slack = 0;
  for (pass = 0; pass < 2; pass++) {
    const fc_eye_squares s = found; /* one that no pointer leads to may stay in registers */
    for (i = 0; i < shapes->vertex_count; i++) {
      fc_vec3 v;
      uint32_t a[3], square;
      fc_read_world(shapes, i, &v);
      eye_offset(&s, &v, a);
      if (pass == 0) {
        all |= a[0] | a[1] | a[2];
        continue;
      }
      square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; /* below 3 2^28 */
      if (square > most) most = square;
    }
    bits = (uint8_t)(32 - (all == 0 ? 32 : fc_clz32(all)));
    found.slack = (UINT32_C(6) << (bits < 14 ? bits : 14)) + 3;
    found.shift = bits > 14 ? (uint8_t)(bits - 14) : 0;
  }
  if (most > found.slack) {
    const uint32_t low = most - found.slack, high = most + found.slack;
    const uint8_t n = (uint8_t)((31 - fc_clz32(low)) / 2); /* 4^n <= low, n at most 14 */
    if ((high + (high >> 20) + 1) >> (2 * n + 2) == 0)     /* below 2^(n + 1) (1 - 2^-21) */
      return fc_num_from_u64(3, n - 1 + found.shift + found.down + view->fine);
  }
  return exact_extent(view, shapes);
}

static void place(const fc_view *view, const fc_shapes *shapes, void *to) {
  fc_placed_vertex *placed = (fc_placed_vertex *)(void *)((fc_placed_mesh *)to + 1);
  fc_transform found;
  const bool quick = fc_transform_find(view, &found);
  const fc_transform t = found; /* one that no pointer leads to may stay in registers */
  uint16_t i;
  uint8_t j;
  for (i = 0; i < shapes->vertex_count; i++) {
    fc_vec3 v;
    fc_read_world(shapes, i, &v);
    placed[i].seen = 0;
    if (quick) {
      fc_transform_point(view, &t, &v, placed[i].p);
    } else {
      int64_t p[3];
      (void)fc_view_point(view, &v, 0, p); /* within range: the grid was chosen for it */
      for (j = 0; j < 3; j++) placed[i].p[j] = (int32_t)p[j];
    }
  }
}

static inline void fetch(const fc_group *group, uint16_t index, fc_form *form) {
  fc_triangle t;
  uint8_t i;
  fc_read_triangle(&group->shapes, index, &t);
  form->material = t.material;
  form->object = t.object;
  /* the camera's axes are left-handed: there, outward normals turn inwards */
  form->u.triangle.hidden = !group->shapes.cull ? 0 : group->memory != NULL ? -1
                                                                            : 1;
  for (i = 0; i < 3; i++) {
    int64_t *to = form->u.triangle.vertex[i];
    if (group->memory != NULL) {
      const fc_placed_vertex *v = fc_mesh_vertices(group->memory) + t.vertex[i];
      to[0] = v->p[0];
      to[1] = v->p[1];
      to[2] = v->p[2];
    } else {
      fc_vec3 v;
      fc_read_world(&group->shapes, t.vertex[i], &v);
      to[0] = v.x;
      to[1] = v.y;
      to[2] = v.z;
    }
  }
}

#endif
