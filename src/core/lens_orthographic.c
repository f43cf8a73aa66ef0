/* Parallel rays. */
#include "bits.h"
#include "fixcast/error.h"
#include "num.h"
#include "sample.h"
#include "view.h"

/* Round(scale |offset|), scale grid units a unit of the offset; the sign is that of the offset. */
static FC_COLD int64_t coordinate(const fc_num *scale, int64_t offset_q16) {
  fc_num v = *scale;
  int64_t size;
  fc_num_times_u64(&v, fc_abs64(offset_q16));
  size = (int64_t)fc_num_rounded(&v, 0);
  return offset_q16 < 0 ? -size : size;
}

static FC_COLD int prepare(fc_lens_state *state, fc_frame *frame, const void *data) {
  const uint16_t shorter = frame->width < frame->height ? frame->width : frame->height;
  const uint16_t longer = frame->width < frame->height ? frame->height : frame->width;
  fc_orthographic lens;
  fc_num reach;
  if (data == NULL) return FC_ERR_LENS;
  FC_READ(&lens, data, sizeof lens);
  if (lens.span < 1 || lens.span > FC_COORDINATE_MAX || lens.span_exponent < -31 || lens.span_exponent > 32) return FC_ERR_LENS;
  /* A grid unit is 2^shift world coordinates / 2^fine; the shorter side is 2 `shorter` half pixels, Q16. */
  fc_num_set(&state->scale, (uint64_t)lens.span, lens.span_exponent + frame->view.fine - frame->view.shift - 17);
  fc_num_over_u64(&state->scale, shorter);
  /* A tent reaches half a pixel beyond the edge. */
  reach = state->scale;
  fc_num_times_u64(&reach, (uint64_t)(longer + UINT32_C(1)) << 16);
  return fc_num_rounded(&reach, 0) <= (uint64_t)FC_COORDINATE_MAX ? FC_OK : FC_ERR_LENS;
}

static FC_COLD bool ray(const fc_lens_state *state, const fc_frame *frame, const int32_t place_q16[2], int64_t origin[3],
                        int64_t direction[3]) {
  int64_t offset[2];
  fc_lens_offset(frame, place_q16, offset);
  origin[0] = coordinate(&state->scale, offset[0]);
  origin[1] = coordinate(&state->scale, offset[1]);
  origin[2] = 0;
  direction[0] = direction[1] = 0;
  direction[2] = frame->view.focal; /* so that depth, t times that, is the camera z */
  return true;
}

const fc_lens_kind fc_lens_orthographic FC_ROM = {prepare, ray};

FC_COLD int fc_orthographic_of_camera(fc_orthographic *lens, const fc_camera *camera_rom) {
  fc_camera camera;
  int64_t eye[3], way[3];
  fc_num span;
  int32_t exponent;
  uint64_t rounded;
  uint8_t i;
  if (lens == NULL || camera_rom == NULL) return FC_ERR_NULL;
  FC_READ_ONE(&camera, camera_rom);
  if (!fc_load(&camera.eye, eye) || !fc_load(&camera.target, way)) return FC_ERR_COORDINATE;
  if (camera.exponent < -31 || camera.exponent > 31) return FC_ERR_EXPONENT;
  for (i = 0; i < 3; i++) way[i] -= eye[i];
  if ((way[0] | way[1] | way[2]) == 0) return FC_ERR_CAMERA_TARGET;
  if (!fc_view_tangent_valid(&camera)) return FC_ERR_FIELD_OF_VIEW;
  fc_length_to(&span, way);
  fc_num_times_u64(&span, camera.tan_half_fov_numerator);
  fc_num_over_u64(&span, camera.tan_half_fov_denominator);
  span.e += camera.exponent + 1;
  /* 29 bits where exponents allow: 2^62 <= m, and the span is below 2^(31 + 31 + 16 + 2) */
  exponent = span.e + 63 - 29;
  if (exponent < -31) exponent = -31;
  rounded = exponent > 32 ? 0 : fc_num_rounded(&span, -exponent);
  if (rounded == 0) return FC_ERR_LENS;
  lens->span = (int32_t)rounded;
  lens->span_exponent = (int8_t)exponent;
  return FC_OK;
}
