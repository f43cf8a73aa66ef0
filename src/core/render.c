/* Strips: depth and primitive first, then one shade a pixel. */
#include <string.h>

#include "depth.h"
#include "fixcast/error.h"
#include "fixcast/render.h"
#include "pixel.h"
#include "shade.h"
#include "space.h"
#include "view.h"

#define NO_PRIMITIVE UINT16_C(0xffff)

static const int64_t eye[3] = {0, 0, 0}; /* camera space */

static fc_space space_of(const fc_frame *frame) {
  fc_space space;
  space.scene = &frame->scene;
  space.memory = frame->memory;
  return space;
}

/* Whether a hit is beyond the scene's far limit. */
static bool too_far(const fc_frame *frame, const fc_root *root, const int64_t d[3]) {
  if (frame->scene.far_limit == 0) return false;
  /* 30-bit components: below 3 * 2^60 */
  return fc_root_compare_distance(root, d[0] * d[0] + d[1] * d[1] + d[2] * d[2], frame->scene.far_limit,
                                  fc_view_far_exponent(frame)) > 0;
}

/* Whether a hit is nearer than the primitive kept in a pixel with the same depth code. */
static bool nearer_than(const fc_space *space, const fc_root *root, uint16_t kept, const int64_t d[3]) {
  fc_surface other;
  return !fc_surface_meet(&other, space, kept, eye, d) || fc_root_compare(root, &other.root) < 0;
}

/* Draws one primitive's depth and number into the strip. */
static void draw(const fc_frame *frame, const fc_space *space, const fc_cursor *at, uint16_t index, uint16_t y,
                 uint16_t rows, const fc_target *target) {
  fc_form form;
  fc_prepared prepared;
  fc_window box;
  int32_t px, py;
  box.x0 = 0;
  box.x1 = frame->width - 1;
  box.y0 = 0;
  box.y1 = frame->height - 1;
  at->kind.fetch(&at->group, index, &form);
  if (!at->kind.window(frame, &form, &box)) return;
  if (box.x0 < 0) box.x0 = 0;
  if (box.x1 > frame->width - 1) box.x1 = frame->width - 1;
  if (box.y0 < y) box.y0 = y;
  if (box.y1 > (int32_t)y + rows - 1) box.y1 = (int32_t)y + rows - 1;
  if (box.x0 > box.x1 || box.y0 > box.y1) return;
  at->kind.prepare(&form, eye, &prepared);
  for (py = box.y0; py <= box.y1; py++) {
    size_t row = (size_t)(py - y) * frame->width;
    for (px = box.x0; px <= box.x1; px++) {
      size_t at_pixel = row + (size_t)px;
      int64_t d[3];
      fc_root root[2];
      uint16_t code;
      fc_view_direction(frame, (uint16_t)px, (uint16_t)py, d);
      if (at->kind.test(&prepared, d, root) == 0) continue;
      code = fc_depth_code(frame, &root[0]);
      if (code < target->depth[at_pixel]) continue;
      if (code == target->depth[at_pixel] && !nearer_than(space, &root[0], target->primitive[at_pixel], d)) continue;
      target->depth[at_pixel] = code;
      target->primitive[at_pixel] = (uint16_t)(at->group.first + index);
    }
  }
}

static void background(const fc_scene *scene, uint8_t rgb[3]) {
  const uint32_t full_q24 = UINT32_C(1) << 24;
  rgb[0] = fc_pixel_level(scene->background.r, full_q24);
  rgb[1] = fc_pixel_level(scene->background.g, full_q24);
  rgb[2] = fc_pixel_level(scene->background.b, full_q24);
}

/* Shades one pixel of the strip. */
static void resolve(const fc_frame *frame, const fc_space *space, uint16_t px, uint16_t py, size_t at_pixel,
                    const fc_target *target, uint8_t rgb[3]) {
  int64_t d[3];
  fc_surface surface;
  uint32_t lit = 0;
  uint16_t kept = target->primitive[at_pixel];
  fc_view_direction(frame, px, py, d);
  if (kept != NO_PRIMITIVE && fc_surface_meet(&surface, space, kept, eye, d) && !too_far(frame, &surface.root, d)) {
    fc_surface_complete(&surface);
    fc_shade(frame, space, &surface, rgb, &lit);
  } else {
    target->primitive[at_pixel] = NO_PRIMITIVE;
    target->depth[at_pixel] = 0;
    background(&frame->scene, rgb);
  }
  if (target->lit != NULL) target->lit[at_pixel] = lit;
}

int fc_render_rows(const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target) {
  fc_space space;
  fc_cursor cursor;
  int pixel_bytes;
  uint16_t px, py;
  size_t i, pixels;
  if (frame == NULL || target == NULL || target->pixels == NULL || target->depth == NULL || target->primitive == NULL)
    return FC_ERR_NULL;
  pixel_bytes = fc_format_bytes(target->format);
  if (pixel_bytes < 0) return pixel_bytes;
  if (rows < 1 || y >= frame->height || rows > frame->height - y ||
      target->pitch_bytes < (size_t)frame->width * (size_t)pixel_bytes)
    return FC_ERR_SIZE;
  pixels = (size_t)rows * frame->width;
  for (i = 0; i < pixels; i++) {
    target->depth[i] = 0;
    target->primitive[i] = NO_PRIMITIVE;
  }
  space = space_of(frame);
  fc_cursor_start(&cursor, &space);
  while (fc_cursor_next(&cursor)) {
    uint16_t index;
    for (index = 0; index < cursor.group.shapes.count; index++) draw(frame, &space, &cursor, index, y, rows, target);
  }
  for (py = 0; py < rows; py++) {
    uint8_t *to = (uint8_t *)target->pixels + (size_t)py * target->pitch_bytes;
    for (px = 0; px < frame->width; px++) {
      uint8_t rgb[3];
      resolve(frame, &space, px, (uint16_t)(y + py), (size_t)py * frame->width + px, target, rgb);
      fc_pixel_put(target->format, rgb, to);
      to += pixel_bytes;
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

int fc_pick(const fc_frame *frame, uint16_t x, uint16_t y, fc_hit *hit, uint32_t *lit) {
  fc_space space;
  fc_surface surface;
  int64_t d[3];
  uint8_t rgb[3];
  uint32_t mask;
  uint16_t nearest;
  if (frame == NULL || hit == NULL) return FC_ERR_NULL;
  if (x >= frame->width || y >= frame->height) return FC_ERR_SIZE;
  space = space_of(frame);
  fc_view_direction(frame, x, y, d);
  nearest = fc_space_nearest(&space, eye, d, 0, UINT64_MAX, NULL);
  if (lit != NULL) *lit = 0;
  if (nearest == NO_PRIMITIVE || !fc_surface_meet(&surface, &space, nearest, eye, d) ||
      too_far(frame, &surface.root, d))
    return 0;
  fc_surface_complete(&surface);
  fc_surface_hit(&surface, hit);
  hit->t_q32 = fc_num_round(fc_num_mul(fc_root_value(&surface.root), fc_num_from_u64((uint64_t)d[2], 0)),
                            32 + frame->view.shift - frame->view.fine);
  fc_view_to_world(&frame->view, fc_root_value(&surface.root), d, &hit->position);
  rotate_to_world(&frame->view, &hit->normal_q30);
  if (lit != NULL) {
    fc_shade(frame, &space, &surface, rgb, &mask);
    *lit = mask;
  }
  return 1;
}

uint16_t fc_object(const fc_frame *frame, uint16_t primitive) {
  fc_space space = space_of(frame);
  fc_cursor cursor;
  fc_form form;
  uint16_t index;
  if (!fc_cursor_find(&cursor, &space, primitive, &index)) return 0;
  cursor.kind.fetch(&cursor.group, index, &form);
  return form.object;
}
