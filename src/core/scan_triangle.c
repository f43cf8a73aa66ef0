/* The scan engine on triangles. */
#include "planar.h"
#include "scan_kinds.h"

void fc_triangle_draw(fc_scan *scan) {
  int64_t n[3];
  uint16_t row;
  for (row = 0; row < scan->rows * scan->words; row++) scan->mask[row] = 0;
  fc_scan_slowly(scan);
  fc_face_normal(scan->form, n);
  fc_planar_light(scan, n, fc_i128_dot(n, scan->form->u.triangle.vertex[0]));
}

void fc_triangle_project(const fc_frame *frame, const fc_shapes *shapes, void *memory) {
  (void)frame;
  (void)shapes;
  (void)memory;
}

void fc_triangle_shadow(fc_scan *scan, const fc_planar *receiver, const fc_kind *kind, const fc_form *form) {
  (void)receiver;
  fc_planar_ask(scan, kind, form);
}

bool fc_triangle_between(const fc_frame *frame, const fc_form *form, const int64_t light[3], const int64_t center[3],
                         int64_t radius, fc_window *window) {
  uint8_t i, j;
  window->x0 = window->y0 = 0;
  window->x1 = frame->width - 1;
  window->y1 = frame->height - 1;
  for (j = 0; j < 3; j++) {
    int64_t low = light[j] < center[j] - radius ? light[j] : center[j] - radius;
    int64_t high = light[j] > center[j] + radius ? light[j] : center[j] + radius;
    bool below = true, above = true;
    for (i = 0; i < 3; i++) {
      below = below && form->u.triangle.vertex[i][j] < low;
      above = above && form->u.triangle.vertex[i][j] > high;
    }
    if (below || above) return false;
  }
  return true;
}

bool fc_triangle_window(const fc_frame *frame, const fc_group *group, uint16_t index, fc_window *box) {
  fc_form form;
  uint8_t i, behind = 0;
  fc_triangle_fetch(group, index, &form);
  box->x0 = box->y0 = 0;
  box->x1 = frame->width - 1;
  box->y1 = frame->height - 1;
  for (i = 0; i < 3; i++) behind = (uint8_t)(behind + (form.u.triangle.vertex[i][2] <= 0));
  if (behind == 3) return false;
  if (behind > 0) return true;
  for (i = 0; i < 3; i++) {
    const int64_t *v = form.u.triangle.vertex[i];
    int32_t x = fc_view_project(frame, 0, v[0], v[2]), y = fc_view_project(frame, 1, v[1], v[2]);
    if (i == 0 || x - 1 < box->x0) box->x0 = x - 1;
    if (i == 0 || x + 1 > box->x1) box->x1 = x + 1;
    if (i == 0 || y - 1 < box->y0) box->y0 = y - 1;
    if (i == 0 || y + 1 > box->y1) box->y1 = y + 1;
  }
  return fc_window_cut(frame, box);
}
