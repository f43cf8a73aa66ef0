/* Strips and picks by the ray engine: a ray a pixel against every primitive. The definition of every picture. */
#include "depth.h"
#include "fixcast/error.h"
#include "fixcast/render.h"
#include "scan.h"
#include "shade.h"
#include "space.h"
#include "view.h"

#define NO_PRIMITIVE UINT16_C(0xffff)

/* Shades one pixel; returns its primitive. */
static uint16_t resolve(const fc_frame *frame, const fc_space *space, uint16_t px, uint16_t py, uint64_t radiance_q39[3],
                        uint16_t *depth, uint32_t *lit) {
  int64_t d[3];
  fc_surface surface;
  uint16_t nearest;
  fc_view_direction(frame, px, py, d);
  nearest = fc_space_nearest(space, fc_eye, d, 0, UINT64_MAX, NULL);
  *lit = 0;
  *depth = 0;
  if (nearest == NO_PRIMITIVE || !fc_surface_meet(&surface, space, nearest, fc_eye, d) ||
      fc_too_far(frame, &surface.root, d)) {
    fc_shade_background(frame, d, radiance_q39);
    return NO_PRIMITIVE;
  }
  *depth = fc_depth_code(frame, &surface.root);
  fc_surface_complete(&surface);
  fc_shade(frame, space, &surface, radiance_q39, lit);
  return nearest;
}

FC_COLD int fc_render_rows_by_rays(const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target) {
  fc_space space;
  uint16_t px, py;
  int pixel_bytes = fc_render_check(frame, y, rows, target);
  if (pixel_bytes < 0) return pixel_bytes;
  space = fc_space_of_frame(frame);
  for (py = 0; py < rows; py++) {
    uint8_t *to = (uint8_t *)target->pixels + (size_t)py * target->pitch_bytes;
    for (px = 0; px < frame->width; px++, to += pixel_bytes) {
      size_t at = (size_t)py * frame->width + px;
      uint64_t radiance_q39[3];
      uint32_t lit;
      uint16_t primitive = resolve(frame, &space, px, (uint16_t)(y + py), radiance_q39, &target->depth[at], &lit);
      fc_shade_put(frame, radiance_q39, target->format, to);
      if (target->primitive != NULL) target->primitive[at] = primitive;
      if (target->lit != NULL) target->lit[at] = lit;
    }
  }
  return FC_OK;
}

/* A camera-space unit vector in world axes. */
static void rotate_to_world(const fc_view *view, fc_vec3 *n_q30) {
  int64_t c[3];
  int32_t out[3];
  uint8_t i;
  c[0] = n_q30->x;
  c[1] = n_q30->y;
  c[2] = n_q30->z;
  for (i = 0; i < 3; i++) {
    /* unit vectors in Q30: at most 2^60 and rounding */
    int64_t q = view->row[0][i] * c[0] + view->row[1][i] * c[1] + view->row[2][i] * c[2];
    out[i] = (int32_t)fc_i128_to_i64(fc_i128_round_shift(fc_i128_from(q), 30));
  }
  n_q30->x = out[0];
  n_q30->y = out[1];
  n_q30->z = out[2];
}

FC_COLD int fc_pick(const fc_frame *frame, uint16_t x, uint16_t y, fc_hit *hit, uint32_t *lit) {
  fc_space space;
  fc_surface surface;
  int64_t d[3];
  uint64_t radiance_q39[3];
  uint32_t mask;
  uint16_t nearest;
  if (frame == NULL || hit == NULL) return FC_ERR_NULL;
  if (x >= fc_view_columns(frame) || y >= fc_view_rows(frame)) return FC_ERR_SIZE;
  if (frame->options.profile == FC_PROFILE_HALF) {
    x /= 2;
    y /= 2;
  }
  space = fc_space_of_frame(frame);
  fc_view_direction(frame, x, y, d);
  nearest = fc_space_nearest(&space, fc_eye, d, 0, UINT64_MAX, NULL);
  if (lit != NULL) *lit = 0;
  if (nearest == NO_PRIMITIVE || !fc_surface_meet(&surface, &space, nearest, fc_eye, d) ||
      fc_too_far(frame, &surface.root, d))
    return 0;
  fc_surface_complete(&surface);
  fc_surface_hit(&surface, hit);
  hit->t_q32 = fc_num_round(fc_num_mul(fc_root_value(&surface.root), fc_num_from_u64((uint64_t)d[2], 0)),
                            32 + frame->view.shift - frame->view.fine);
  fc_view_to_world(&frame->view, fc_root_value(&surface.root), d, &hit->position);
  rotate_to_world(&frame->view, &hit->normal_q30);
  if (lit != NULL) {
    fc_shade(frame, &space, &surface, radiance_q39, &mask);
    *lit = mask;
  }
  return 1;
}

FC_COLD uint16_t fc_object(const fc_frame *frame, uint16_t primitive) {
  fc_space space = fc_space_of_frame(frame);
  fc_cursor cursor;
  fc_form form;
  uint16_t index;
  if (!fc_cursor_find(&cursor, &space, primitive, &index)) return 0;
  fc_kind_of(&cursor)->fetch(&cursor.group, index, &form);
  return form.object;
}
