/* Camera set-up: exact cross products, correctly scaled unit rows, and the projection of coordinates. */
#include "view.h"

#include "bits.h"
#include "fixcast/error.h"
#include "kind.h"
#include "quick.h"
#include "segment.h"

FC_COLD void fc_length_to(fc_num *length, const int64_t v[3]) {
  /* components below 2^63: squares below 2^126 as values, no overflow */
  uint8_t i;
  fc_num_set(length, 0, 0);
  for (i = 0; i < 3; i++) {
    fc_num square;
    fc_num_set(&square, fc_abs64(v[i]), 0);
    fc_num_times(&square, &square);
    fc_num_plus(length, &square);
  }
  fc_num_root(length);
}

/* v / |v| in Q60, within 2^-58. */
static FC_COLD void unit_q60(int64_t v[3]) {
  fc_num length;
  uint8_t i;
  fc_length_to(&length, v);
  for (i = 0; i < 3; i++) {
    fc_num part;
    int64_t q;
    fc_num_set(&part, fc_abs64(v[i]), 0);
    fc_num_over(&part, &length);
    q = (int64_t)fc_num_rounded(&part, 60);
    v[i] = v[i] < 0 ? -q : q;
  }
}

FC_COLD bool fc_load(const fc_vec3 *v, int64_t r[3]) {
  r[0] = v->x;
  r[1] = v->y;
  r[2] = v->z;
  return fc_abs32(v->x) <= (uint32_t)FC_COORDINATE_MAX && fc_abs32(v->y) <= (uint32_t)FC_COORDINATE_MAX &&
         fc_abs32(v->z) <= (uint32_t)FC_COORDINATE_MAX;
}

static FC_COLD int set_rows(fc_view *view, const fc_camera *camera) {
  int64_t f[3], u[3], r[3];
  uint8_t i;
  if (!fc_load(&camera->eye, u) || !fc_load(&camera->target, f)) return FC_ERR_COORDINATE;
  for (i = 0; i < 3; i++) f[i] -= u[i];
  if (!fc_load(&camera->up, u)) return FC_ERR_COORDINATE;
  if ((f[0] | f[1] | f[2]) == 0) return FC_ERR_CAMERA_TARGET;
  /* 31 + 30 bits, two products: below 2^62 */
  fc_cross(f, u, r);
  if ((r[0] | r[1] | r[2]) == 0) return FC_ERR_CAMERA_UP;
  unit_q60(r);
  unit_q60(f);
  for (i = 0; i < 3; i++) {
    /* up' = r x f, Q120: two products below 2^121 */
    uint8_t j = i == 2 ? 0 : (uint8_t)(i + 1), k = i == 0 ? 2 : (uint8_t)(i - 1);
    fc_i128 up = fc_i128_mul(r[j], f[k]), down = fc_i128_mul(r[k], f[j]);
    fc_i128_minus(&up, &down);
    view->row[0][i] = (int32_t)fc_floor_shift64(r[i] + (INT32_C(1) << 29), 30);
    view->row[1][i] = (int32_t)fc_i128_to_i64(fc_i128_round_shift(up, 90));
    view->row[2][i] = (int32_t)fc_floor_shift64(f[i] + (INT32_C(1) << 29), 30);
  }
  return FC_OK;
}

static FC_COLD int set_eye(fc_view *view, const fc_camera *camera) {
  int8_t e = camera->exponent;
  uint8_t i;
  if (e < -31 || e > 31) return FC_ERR_EXPONENT;
  view->fine = (uint8_t)(e < 0 ? -e : 0);
  (void)fc_load(&camera->eye, view->eye);
  for (i = 0; e > 0 && i < 3; i++) view->eye[i] *= INT64_C(1) << e; /* 30 + 31 bits */
  return FC_OK;
}

FC_COLD bool fc_view_tangent_valid(const fc_camera *camera) {
  const uint32_t numerator = camera->tan_half_fov_numerator, denominator = camera->tan_half_fov_denominator;
  return numerator != 0 && denominator != 0 && numerator <= (uint64_t)denominator << 16 && (uint64_t)numerator << 16 >= denominator;
}

static FC_COLD int set_focal(fc_view *view, const fc_camera *camera, uint16_t width, uint16_t height) {
  uint32_t span = width < height ? width : height;
  uint32_t longest = width < height ? height : width;
  fc_num focal, largest;
  int32_t shift;
  if (camera->fov_rule == FC_FOV_CENTRES)
    span = span > 1 ? span - 1 : 1;
  else if (camera->fov_rule != FC_FOV_EDGES)
    return FC_ERR_FORMAT;
  if (!fc_view_tangent_valid(camera)) return FC_ERR_FIELD_OF_VIEW;
  /* 12 + 32 bits; F = span / tan, in half pixels */
  fc_num_set(&focal, (uint64_t)span * camera->tan_half_fov_denominator, 0);
  fc_num_over_u64(&focal, camera->tan_half_fov_numerator);
  fc_num_set(&largest, longest, 0);
  if (fc_num_order_of(&focal, &largest) > 0) largest = focal;
  /* the largest component gets 29 bits: largest < 2^(e+63), so at most 2^29 after the shift and rounding */
  shift = 29 - (largest.e + 63);
  view->pixel_shift = (uint8_t)(shift < 0 ? 0 : shift);
  view->focal = (int32_t)fc_num_rounded(&focal, view->pixel_shift);
  if (view->focal < 1) return FC_ERR_FIELD_OF_VIEW;
  return FC_OK;
}

FC_COLD int fc_view_from_camera(fc_view *view, const fc_camera *camera, uint16_t width, uint16_t height) {
  int error = set_rows(view, camera);
  if (error == FC_OK) error = set_eye(view, camera);
  if (error == FC_OK) error = set_focal(view, camera, width, height);
  view->shift = 0;
  return error;
}

FC_COLD void fc_view_offset(const fc_view *view, const fc_vec3 *v, int64_t offset[3]) {
  /* 30 + 31 bits minus 61 bits: below 2^62 */
  uint8_t i;
  (void)fc_load(v, offset);
  for (i = 0; i < 3; i++) offset[i] = offset[i] * (INT64_C(1) << view->fine) - view->eye[i];
}

FC_COLD bool fc_view_point(const fc_view *view, const fc_vec3 *v, int8_t exponent, int64_t point[3]) {
  int64_t p[3];
  uint8_t i, j;
  int16_t up = (int16_t)(exponent + view->fine); /* -31 .. 63 */
  (void)fc_load(v, p);
  for (i = 0; i < 3; i++) {
    int64_t row[3];
    fc_i128 q, eye;
    for (j = 0; j < 3; j++) row[j] = view->row[i][j];
    /* A unit row times 30-bit coordinates: below 2^62 * 2^63 = 2^125; the eye 2^30 * 2^62 * sqrt 3 < 2^93. */
    q = fc_i128_dot(row, p);
    fc_i128_move(&q, up);
    eye = fc_i128_dot(row, view->eye);
    fc_i128_minus(&q, &eye);
    fc_i128_move(&q, (int16_t)(-30 - view->shift));
    if (fc_i128_bits(q) > 61) return false;
    point[i] = fc_i128_to_i64(q);
  }
  return true;
}

FC_COLD void fc_view_turn(const fc_view *view, const int64_t world[3], int64_t camera[3]) {
  uint8_t i;
  /* rows are unit vectors in Q30: below 2^62 */
  for (i = 0; i < 3; i++) {
    const int32_t *row = view->row[i];
    camera[i] = row[0] * world[0] + row[1] * world[1] + row[2] * world[2];
  }
}

static FC_COLD int32_t clamp_coordinate(int64_t v) {
  if (v > FC_COORDINATE_MAX) return FC_COORDINATE_MAX;
  return v < -FC_COORDINATE_MAX ? -FC_COORDINATE_MAX : (int32_t)v;
}

FC_COLD void fc_view_to_world(const fc_view *view, fc_num t, const int64_t direction[3], fc_vec3 *v) {
  int32_t out[3];
  uint8_t i;
  for (i = 0; i < 3; i++) {
    /* the direction's world component, Q30: unit rows times components below 2^30, below 2^62 */
    int64_t along = view->row[0][i] * direction[0] + view->row[1][i] * direction[1] + view->row[2][i] * direction[2];
    uint64_t step = fc_num_round(fc_num_mul(t, fc_num_from_u64(fc_abs64(along), 0)), view->shift - 30);
    if (step >> 62) { /* far beyond any coordinate: the eye's below 2^62 too */
      out[i] = along < 0 ? -FC_COORDINATE_MAX : FC_COORDINATE_MAX;
    } else {
      fc_i128 fine = fc_i128_from(view->eye[i] + (along < 0 ? -(int64_t)step : (int64_t)step));
      out[i] = clamp_coordinate(fc_i128_to_i64(fc_i128_round_shift(fine, view->fine)));
    }
  }
  v->x = out[0];
  v->y = out[1];
  v->z = out[2];
}

FC_COLD void fc_view_direction(const fc_frame *frame, uint16_t x, uint16_t y, int64_t direction[3]) {
  /* below 2^29 by the choice of pixel_shift */
  int32_t one = INT32_C(1) << frame->view.pixel_shift;
  direction[0] = (2 * (int32_t)x + 1 - frame->width) * one;
  direction[1] = (frame->height - 2 * (int32_t)y - 1) * one;
  direction[2] = frame->view.focal;
}

FC_COLD bool fc_too_far_in(fc_wide *w, const fc_frame *frame, const fc_root *root, const int64_t d[3]) {
  if (frame->scene.far_limit == 0) return false;
  /* 30-bit components: below 3 * 2^60 */
  return fc_root_compare_distance_in(w, root, fc_dot(d, d), frame->scene.far_limit,
                                     fc_view_far_exponent(frame)) > 0;
}

FC_COLD bool fc_too_far(const fc_frame *frame, const fc_root *root, const int64_t d[3]) {
  fc_wide w;
  return fc_too_far_in(&w, frame, root, d);
}

FC_COLD bool fc_window_cut(const fc_frame *frame, fc_window *box) {
  if (box->x0 < 0) box->x0 = 0;
  if (box->y0 < 0) box->y0 = 0;
  if (box->x1 > frame->width - 1) box->x1 = frame->width - 1;
  if (box->y1 > frame->height - 1) box->y1 = frame->height - 1;
  return box->x0 <= box->x1 && box->y0 <= box->y1;
}

/* The first and last pixel of an axis at which a ball in front of the eye is seen: a, z of its center. The tangents through
 * the eye touch it where a / z = (a z +- r sqrt(a^2 + square)) / square, square = z^2 - r^2; scale: F / square, in half pixels. */
static FC_COLD void ball_span(const fc_frame *frame, uint8_t axis, int32_t a, int32_t z, int32_t r, int64_t square, fc_quick scale,
                              int32_t *first, int32_t *last) {
  /* 30-bit factors; z > r > 0 */
  int64_t across = fc_smul32(a, z), reach[2];
  fc_quick root = fc_quick_from((uint64_t)(fc_smul32(a, a) + square), 0);
  uint8_t i;
  reach[0] = (int64_t)fc_quick_to_u64(fc_quick_mul(fc_quick_mul(root, fc_quick_rsqrt(root)), fc_quick_from((uint64_t)r, 0)));
  /* the product's error, and its floor: where the eye is close to the ball the difference below all but vanishes */
  reach[0] += (reach[0] >> 22) + 2;
  reach[1] = across + reach[0];
  reach[0] = across - reach[0];
  for (i = 0; i < 2; i++) {
    /* half pixels from the centre; the values are off by 2^-24 of at most 2^13 where that matters */
    int32_t half = fc_quick_times(scale, reach[i], 0), pixel;
    if (half > INT32_C(20000)) half = INT32_C(20000);
    if (half < -INT32_C(20000)) half = -INT32_C(20000);
    pixel = axis == 0 ? frame->width + half : frame->height - half;
    pixel = pixel < -2 ? -2 : pixel / 2;
    if ((i == 0) == (axis == 0))
      *first = pixel - 1;
    else
      *last = pixel + 1;
  }
}

FC_COLD bool fc_ball_window(const fc_frame *frame, const int64_t c[3], int64_t r, fc_window *box) {
  box->x0 = box->y0 = 0;
  box->x1 = frame->width - 1;
  box->y1 = frame->height - 1;
  if (c[2] + r <= 0) return false;
  if (c[2] > r && fc_vector_bits(c) <= 30) {
    const int32_t z = (int32_t)c[2], radius = (int32_t)r;
    const int64_t square = fc_smul32(z, z) - fc_smul32(radius, radius);
    const fc_quick scale = fc_quick_mul(fc_quick_recip(fc_quick_from((uint64_t)square, 0)),
                                        fc_quick_from((uint64_t)frame->view.focal, (int16_t)-frame->view.pixel_shift));
    ball_span(frame, 0, (int32_t)c[0], z, radius, square, scale, &box->x0, &box->x1);
    ball_span(frame, 1, (int32_t)c[1], z, radius, square, scale, &box->y0, &box->y1);
  }
  return fc_window_cut(frame, box);
}
