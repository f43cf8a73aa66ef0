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
bool fc_triangle_blocked(const fc_form *form, const fc_segment *segment);
bool fc_triangle_facing(const fc_form *form, const fc_segment *segment);
void fc_triangle_normal(const fc_form *form, const int64_t point[3], int64_t n[3]);
int8_t fc_triangle_side(const fc_form *form, const int64_t point[3]);
void fc_triangle_weights(const fc_prepared *prepared, const int64_t direction[3], uint32_t weight_q30[3]);
void fc_triangle_depth_range(const fc_frame *frame, const fc_group *group, uint64_t *near, uint64_t *far);
void fc_triangle_bounds(const fc_form *form, int64_t low[3], int64_t high[3]);

/* Strips are drawn whole: no draw, and no hides. */
#define FC_KIND_OF_TRIANGLES(check, extent, place, fetch)                                                                   \
  {                                                                                                                         \
    check, fc_mesh_memory, extent, place, fetch, fc_triangle_prepare, fc_triangle_test, fc_triangle_blocked,                \
        fc_triangle_facing, fc_triangle_normal, fc_triangle_side, fc_triangle_weights, fc_triangle_depth_range,             \
        fc_triangle_project, fc_triangle_window, NULL, fc_triangle_shadow, fc_triangle_between, NULL, fc_triangle_strip,    \
        fc_triangle_bounds, fc_triangle_casts                                                                               \
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

/* The eye in whole world coordinates, floor; false when it is out of their range. */
static FC_COLD bool whole_eye(const fc_view *view, int32_t eye[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    int64_t e = fc_floor_shift64(view->eye[i], view->fine);
    if (fc_abs64(e) > (uint64_t)FC_COORDINATE_MAX) return false;
    eye[i] = (int32_t)e;
  }
  return true;
}

static FC_COLD fc_num exact_distance(const fc_view *view, const fc_vec3 *v) {
  int64_t offset[3];
  fc_view_offset(view, v, offset);
  return fc_length(offset);
}

static fc_num extent(const fc_view *view, const fc_shapes *shapes) {
  fc_num most = {0, 0};
  int32_t eye[3] = {0, 0, 0};
  uint32_t all = 0, sure = 0, slack;
  uint16_t i;
  uint8_t shift, pass;
  bool quick = whole_eye(view, eye);
  if (quick)
    for (i = 0; i < shapes->vertex_count; i++) {
      fc_vec3 v;
      fc_read_world(shapes, i, &v);
      all |= fc_abs32(v.x - eye[0]) | fc_abs32(v.y - eye[1]) | fc_abs32(v.z - eye[2]);
    }
  shift = (uint8_t)(32 - (all == 0 ? 32 : fc_clz32(all)));
  slack = UINT32_C(6) << (shift < 14 ? shift : 14); /* (a - 1)^2 is a^2 less 2 a at most */
  shift = shift > 14 ? (uint8_t)(shift - 14) : 0;
  for (pass = quick ? 0 : 1; pass < 2; pass++) {
    if (pass == 1) sure = sure > slack ? sure - slack : 0;
    for (i = 0; i < shapes->vertex_count; i++) {
      fc_vec3 v;
      fc_read_world(shapes, i, &v);
      if (quick) {
        /* offsets are off by less than 1: below (a + 2) 2^shift, at least (a - 1) 2^shift, a below 2^14 */
        uint32_t x = fc_abs32(v.x - eye[0]) >> shift, y = fc_abs32(v.y - eye[1]) >> shift,
                 z = fc_abs32(v.z - eye[2]) >> shift;
        if (pass == 0) {
          if (x * x + y * y + z * z > sure) sure = x * x + y * y + z * z;
          continue;
        }
        if ((x + 2) * (x + 2) + (y + 2) * (y + 2) + (z + 2) * (z + 2) < sure) continue;
      }
      {
        fc_num distance = exact_distance(view, &v);
        if (fc_num_compare(distance, most) > 0) most = distance;
      }
    }
  }
  return most;
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
  form->u.triangle.hidden = !group->shapes.cull ? 0 : group->memory != NULL ? -1 : 1;
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
