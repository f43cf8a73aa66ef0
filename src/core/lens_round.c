/* Lenses whose places are angles: the equidistant fisheye and the equirectangular panorama. */
#include "bits.h"
#include "fixcast/error.h"
#include "fixcast/rotation.h"
#include "num.h"
#include "sample.h"

/* Directions are this long, so that depth, t times that, is the distance: products of two sines, Q60, to Q29. */
#define LENGTH_BITS 29

static FC_COLD int64_t component(int32_t a_q30, int32_t b_q30) {
  const int64_t half = INT64_C(1) << (60 - LENGTH_BITS - 1);
  return fc_floor_shift64((int64_t)a_q30 * b_q30 + half, 60 - LENGTH_BITS);
}

static FC_COLD int32_t divide_q30(int64_t part, uint64_t whole) {
  /* |part| <= whole < 2^33: 63 bits */
  const int32_t q = (int32_t)((((fc_abs64(part)) << 30) + whole / 2) / whole);
  return part < 0 ? -q : q;
}

/* ---- fisheye ---- */

static FC_COLD int prepare_fisheye(fc_lens_state *state, fc_frame *frame, const void *data) {
  fc_fisheye lens;
  if (data == NULL) return FC_ERR_LENS;
  FC_READ(&lens, data, sizeof lens);
  if (lens.angle_q16 < 1 || lens.angle_q16 > UINT32_C(65536)) return FC_ERR_LENS;
  state->angle = lens.angle_q16 << 15; /* half of it, at most half a turn */
  frame->view.focal = INT32_C(1) << LENGTH_BITS;
  return FC_OK;
}

static FC_COLD bool ray_fisheye(const fc_lens_state *state, const fc_frame *frame, const int32_t place_q16[2], int64_t origin[3],
                                int64_t direction[3]) {
  const uint64_t shorter = (uint64_t)(frame->width < frame->height ? frame->width : frame->height) << 16; /* its half, in half pixels */
  int64_t offset[2];
  uint64_t square, radius, angle;
  int32_t sine;
  uint8_t i, up;
  fc_lens_offset(frame, place_q16, offset);
  origin[0] = origin[1] = origin[2] = 0;
  direction[0] = direction[1] = 0;
  direction[2] = INT64_C(1) << LENGTH_BITS;
  /* below 2^30 each; scaled up so that the root has 30 bits and more */
  square = (uint64_t)(offset[0] * offset[0]) + (uint64_t)(offset[1] * offset[1]);
  if (square == 0) return true;
  up = (uint8_t)(fc_clz64(square) / 2);
  radius = fc_sqrt64(square << (2 * up)); /* times 2^up, within 1 */
  /* 32 bits times 31 */
  angle = radius * state->angle;
  /* beyond the circle: whole numbers, so that its edge is where it should be */
  if (square > shorter * shorter) return false;
  angle = ((angle >> up) + shorter / 2) / shorter;
  sine = fc_sin_q30((uint32_t)angle);
  for (i = 0; i < 2; i++) direction[i] = component(sine, divide_q30(offset[i] * (INT64_C(1) << up), radius));
  direction[2] = component(fc_cos_q30((uint32_t)angle), FC_ONE_Q30);
  return true;
}

const fc_lens_kind fc_lens_fisheye FC_ROM = {prepare_fisheye, ray_fisheye};

/* ---- panorama ---- */

static int prepare_panorama(fc_lens_state *state, fc_frame *frame, const void *data) {
  (void)state;
  (void)data;
  frame->view.focal = INT32_C(1) << LENGTH_BITS;
  return FC_OK;
}

/* round(turns 2^32 offset / whole) for an offset of up to 2^30 and a whole of up to 2^28: what is more than a turn is dropped. */
static FC_COLD uint32_t part_of_turn(int64_t offset_q16, uint32_t whole_q16, uint8_t bits) {
  const uint64_t size = ((fc_abs64(offset_q16) << bits) + whole_q16 / 2) / whole_q16;
  return (uint32_t)(offset_q16 < 0 ? 0 - size : size);
}

static FC_COLD bool ray_panorama(const fc_lens_state *state, const fc_frame *frame, const int32_t place_q16[2], int64_t origin[3],
                                 int64_t direction[3]) {
  int64_t offset[2];
  uint32_t longitude, latitude;
  int32_t level;
  (void)state;
  fc_lens_offset(frame, place_q16, offset);
  /* The width's half pixels are a turn, the height's half a turn. Tents that reach beyond a pole come down on its other side. */
  longitude = part_of_turn(offset[0], (uint32_t)frame->width << 16, 31);
  latitude = part_of_turn(offset[1], (uint32_t)frame->height << 16, 30);
  level = fc_cos_q30(latitude);
  direction[0] = component(fc_sin_q30(longitude), level);
  direction[1] = component(fc_sin_q30(latitude), FC_ONE_Q30);
  direction[2] = component(fc_cos_q30(longitude), level);
  origin[0] = origin[1] = origin[2] = 0;
  return true;
}

const fc_lens_kind fc_lens_panorama FC_ROM = {prepare_panorama, ray_panorama};
