/* Strips by several rays a pixel: checks, one ray, one pixel. */
#include "sample.h"

#include "bits.h"
#include "depth.h"
#include "fixcast/error.h"
#include "scan.h"
#include "shade.h"
#include "view.h"

/* C99's alignof(uint32_t). */
struct aligned_u32 {
  char before;
  uint32_t value;
};

FC_COLD void fc_sample_centre(const fc_sampler *sampler, uint16_t x, uint16_t row, int32_t place_q16[2]) {
  place_q16[0] = x * FC_PLACE_ONE + FC_PLACE_HALF;
  place_q16[1] = (int32_t)(sampler->y + row) * FC_PLACE_ONE + FC_PLACE_HALF;
}

FC_COLD void fc_lens_offset(const fc_frame *frame, const int32_t place_q16[2], int64_t offset_q16[2]) {
  offset_q16[0] = 2 * (int64_t)place_q16[0] - frame->width * FC_PLACE_ONE;
  offset_q16[1] = frame->height * FC_PLACE_ONE - 2 * (int64_t)place_q16[1];
}

FC_COLD void fc_sample_trace(const fc_sampler *sampler, const int32_t place_q16[2], fc_seen *seen) {
  const fc_frame *frame = &sampler->frame;
  fc_surface surface;
  int64_t origin[3], direction[3];
  seen->primitive = FC_PRIMITIVES_MAX;
  seen->object = 0;
  seen->depth = 0;
  seen->lit = 0;
  if (sampler->lens.ray(&sampler->state, frame, place_q16, origin, direction)) {
    uint16_t nearest = fc_space_nearest(&sampler->space, origin, direction, 0, UINT64_MAX, NULL);
    if (nearest != FC_PRIMITIVES_MAX && fc_surface_meet(&surface, &sampler->space, nearest, origin, direction) &&
        !fc_too_far(frame, &surface.root, direction)) {
      seen->primitive = nearest;
      seen->object = surface.form.object;
      seen->depth = fc_depth_code(frame, &surface.root);
      fc_surface_complete(&surface);
      fc_shade(frame, &sampler->space, &surface, seen->radiance_q39, &seen->lit);
      return;
    }
  } else {
    /* outside a lens's picture: the sky straight ahead */
    direction[0] = direction[1] = 0;
    direction[2] = 1;
  }
  fc_shade_background(frame, direction, seen->radiance_q39);
}

FC_COLD void fc_sample_put(const fc_sampler *sampler, uint16_t x, uint16_t row, const uint64_t radiance_q39[3], uint16_t count,
                           const fc_seen *centre) {
  const fc_target *target = sampler->target;
  const size_t at = (size_t)row * sampler->frame.width + x;
  uint8_t *to = (uint8_t *)target->pixels + (size_t)row * target->pitch_bytes + (size_t)x * sampler->pixel_bytes;
  fc_seen seen;
  fc_shade_put(&sampler->frame, radiance_q39, target->format, to);
  if (sampler->samples != NULL) sampler->samples[at] = count;
  if (!sampler->centre_wanted) return;
  if (centre == NULL) {
    int32_t place[2];
    fc_sample_centre(sampler, x, row, place);
    fc_sample_trace(sampler, place, &seen);
    centre = &seen;
  }
  if (target->depth != NULL) target->depth[at] = centre->depth;
  if (target->primitive != NULL) target->primitive[at] = centre->primitive;
  if (target->lit != NULL) target->lit[at] = centre->lit;
}

/* Everything but the target: fills what the sampler knows of frame, pattern and lens. */
static FC_COLD int set_up(fc_sampler *sampler, fc_pattern *pattern, const fc_frame *frame, const fc_sampling *how_rom) {
  fc_sampling *how = &sampler->how;
  if (frame == NULL || how_rom == NULL) return FC_ERR_NULL;
  FC_READ_ONE(how, how_rom);
  if (how->pattern == NULL || how->filter > FC_FILTER_TENT) return FC_ERR_SAMPLING;
  FC_READ_ONE(pattern, how->pattern);
  if (!pattern->check(how)) return FC_ERR_SAMPLING;
  if (how->lens.kind == NULL) return FC_ERR_LENS;
  FC_READ_ONE(&sampler->lens, how->lens.kind);
  sampler->frame = *frame;
  return sampler->lens.prepare(&sampler->state, &sampler->frame, how->lens.data);
}

static FC_COLD size_t scratch_of(const fc_pattern *pattern, const fc_sampling *how, uint16_t width) {
  return pattern->scratch == NULL ? 0 : pattern->scratch(how, width);
}

FC_COLD size_t fc_sample_scratch(const fc_frame *frame, const fc_sampling *how, int *error) {
  fc_sampler sampler;
  fc_pattern pattern;
  int status = set_up(&sampler, &pattern, frame, how);
  if (error != NULL) *error = status;
  return status == FC_OK ? scratch_of(&pattern, &sampler.how, frame->width) : 0;
}

FC_COLD int fc_sample_rows(const fc_frame *frame, const fc_sampling *how, uint16_t y, uint16_t rows, const fc_target *target,
                           uint16_t *samples, void *scratch, size_t scratch_bytes) {
  fc_sampler sampler;
  fc_pattern pattern;
  fc_target checked;
  size_t bytes;
  uint16_t unused;
  int error = set_up(&sampler, &pattern, frame, how);
  if (error != FC_OK) return error;
  if (target == NULL) return FC_ERR_NULL;
  checked = *target;
  if (checked.depth == NULL) checked.depth = &unused; /* here it need not be */
  error = fc_render_check(frame, y, rows, &checked);
  if (error < 0) return error;
  bytes = scratch_of(&pattern, &sampler.how, frame->width);
  if (bytes > 0 &&
      (scratch == NULL || scratch_bytes < bytes || (uintptr_t)scratch % offsetof(struct aligned_u32, value) != 0))
    return FC_ERR_MEMORY;
  sampler.space = fc_space_of_frame(&sampler.frame);
  sampler.target = target;
  sampler.samples = samples;
  sampler.y = y;
  sampler.rows = rows;
  sampler.pixel_bytes = (uint8_t)error;
  sampler.centre_wanted = target->depth != NULL || target->primitive != NULL || target->lit != NULL;
  pattern.strip(&sampler, scratch);
  return FC_OK;
}
