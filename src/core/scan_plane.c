/* The scan engine on infinite planes: 1 / z is affine, and the horizon is where its sign changes. */
#include "bits.h"
#include "planar.h"
#include "scan_kinds.h"

/* n.D in units of 2^(gain - 62) of near / z: below 2^63, the factor 32 bits. */
static FC_COLD int64_t scaled(const fc_placed_plane *placed, int64_t along) {
  int64_t factor = placed->factor;
  return fc_i128_to_i64(fc_i128_floor_shift(fc_i128_mul(along, placed->k < 0 ? -factor : factor), placed->shift));
}

static FC_COLD void draw_rows(fc_scan *scan, const fc_placed_plane *placed) {
  const int64_t *n = scan->form->u.plane.normal;
  uint16_t row;
  int64_t d[3], step, dx = 0, dy = 0;
  uint64_t v; /* wraps past the tile */
  fc_coder coder;
  fc_coder_start(&coder, scan->frame, (int16_t)-placed->gain, UINT32_C(1) << 29);
  fc_scan_direction(scan, d, &step);
  v = (uint64_t)scaled(placed, fc_dot(n, d));
  /* values differ by less than 2^63; a single column or row has no step, which need not fit */
  if (scan->columns > 1) dx = scaled(placed, n[0] * step);
  if (scan->rows > 1) dy = scaled(placed, -n[1] * step);
  for (row = 0; row <= scan->last_row; row++, v += (uint64_t)dy)
    if (row >= scan->first_row && !fc_scan_skips(scan, row))
      fc_scan_affine(scan, row, 0, (uint16_t)(scan->columns - 1), fc_to_i64(v), dx, placed->gain, 3, &coder);
}

FC_COLD void fc_plane_draw(fc_scan *scan) {
  const fc_placed_plane *placed = (const fc_placed_plane *)scan->at->group.memory + scan->index;
  uint16_t word;
  for (word = 0; word < scan->rows * scan->words; word++) scan->mask[word] = 0;
  if (placed->gain == FC_GAIN_NONE)
    fc_scan_slowly(scan);
  else
    draw_rows(scan, placed);
  fc_planar_light(scan, scan->form->u.plane.normal, fc_i128_from(placed->k), NULL, 0);
}

FC_COLD void fc_plane_project(const fc_frame *frame, const fc_shapes *shapes, void *memory) {
  fc_placed_plane *placed = memory;
  uint16_t i;
  for (i = 0; i < shapes->count; i++) {
    fc_num factor, most, part;
    fc_quick inverse;
    int64_t d[3], n[3];
    uint8_t j;
    placed[i].gain = FC_GAIN_NONE;
    for (j = 0; j < 3; j++) n[j] = placed[i].normal[j];
    inverse = fc_quick_rsqrt(fc_quick_from((uint64_t)fc_dot(n, n), 0)); /* below 2^62 */
    for (j = 0; j < 3; j++) placed[i].unit[j] = fc_quick_times(inverse, n[j], 30);
    if (placed[i].k == 0) continue;
    fc_num_set(&factor, frame->depth_near, 0);
    fc_num_over_u64(&factor, fc_abs64(placed[i].k));
    fc_num_over_u64(&factor, (uint64_t)frame->view.focal);
    /* the greatest |near / z| of any pixel is below 2^(30 + gain - 30) */
    fc_view_direction(frame, 0, 0, d);
    fc_num_set(&most, 0, 0);
    for (j = 0; j < 3; j++) {
      fc_num_set(&part, fc_abs64(n[j]) * fc_abs64(d[j]), 0); /* 30 + 30 bits */
      fc_num_plus(&most, &part);
    }
    fc_num_times(&most, &factor);
    /* value = near / z times 2^(62 - gain), below 2^62 */
    j = most.e + 63 <= 0 ? 0 : most.e + 63 > 20 ? FC_GAIN_NONE
                                                : (uint8_t)(most.e + 63);
    /* factor = m 2^e: the top 32 bits, and n.D times it shifted to 2^(62 - gain) */
    if (j != FC_GAIN_NONE && factor.e + 31 + 62 - j <= 0 && factor.e + 31 + 62 - j > -100) {
      placed[i].factor = (uint32_t)(factor.m >> 31);
      placed[i].shift = (uint8_t) - (factor.e + 31 + 62 - j);
      placed[i].gain = j;
    }
  }
}

FC_COLD bool fc_plane_window(const fc_frame *frame, const fc_group *group, uint16_t index, fc_window *box) {
  (void)group;
  (void)index;
  box->x0 = box->y0 = 0;
  box->x1 = frame->width - 1;
  box->y1 = frame->height - 1;
  return true;
}

FC_COLD void fc_plane_shadow(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_form *form) {
  (void)receiver;
  fc_planar_ask(scan, kind, form);
}

FC_COLD bool fc_plane_between(const fc_frame *frame, const fc_form *form, const int64_t light[3], const int64_t center[3],
                              int64_t radius, fc_window *window) {
  /* 62 and 30 + 30 + 2 bits; lights of the scan engine are within 2^30 */
  const int64_t *n = form->u.plane.normal;
  int64_t ball = form->u.plane.k - fc_dot(n, center), lamp = form->u.plane.k - fc_dot(n, light), foot[3];
  int64_t dip = fc_ball_foot(n, form->u.plane.unit, ball, center, radius, foot);
  (void)fc_plane_window(frame, NULL, 0, window);
  /* the center is strictly on one side: a point of the ball there is kept from no light on that side, or on the plane */
  if (fc_sign64(ball) * fc_sign64(lamp) < 0) return true;
  if (dip <= 0) return false;
  if (dip > radius) return true;
  /* The part below the plane is within sqrt(2 r dip) of the foot of the center. */
  return fc_ball_window(frame, foot, (int64_t)fc_sqrt64(2 * (uint64_t)(radius * dip)) + 4 * fc_ball_margin(radius) + 4, window);
}

FC_COLD int8_t fc_plane_hides(const fc_form *form, const int64_t light[3], const int32_t point[3], uint32_t error) {
  /* sides: 62 and 30 + 30 + 2 bits; an error moves them by up to |n|_1 of it, below 2^52 */
  const int64_t *n = form->u.plane.normal;
  int64_t lamp = form->u.plane.k - fc_dot(n, light), wide[3], side;
  wide[0] = point[0];
  wide[1] = point[1];
  wide[2] = point[2];
  side = form->u.plane.k - fc_dot(n, wide);
  if (lamp == 0) return 0;
  if ((int64_t)fc_abs64(side) <= fc_small_norm1(n) * (int64_t)error) return -1;
  return (side < 0) != (lamp < 0);
}
