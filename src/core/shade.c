/* Lambert's law over exact visibility of the lights. */
#include "shade.h"

#include "bits.h"
#include "pixel.h"
#include "view.h"

FC_COLD void fc_surface_offset(const fc_surface *surface, int rule, int64_t epsilon, int64_t point[3]) {
  int64_t n[3];
  uint8_t i;
  (void)fc_shrink(surface->normal, n);
  for (i = 0; i < 3; i++) {
    point[i] = surface->point[i];
    if (surface->inside) n[i] = -n[i];
  }
  if (rule == FC_OFFSET_RESIDUAL && surface->point_error != UINT32_MAX) {
    /* Along the normal's dominant axis: a point within e units an axis is at most 3 e + 1 from a plane there, as |n|_1 <= 3 |n|_max.
     * Out by e at a time, then back as far as the side allows. */
    int64_t step = surface->point_error;
    uint8_t axis = 0, out = 5;
    for (i = 1; i < 3; i++)
      if (fc_abs64(n[i]) > fc_abs64(n[axis])) axis = i;
    if (n[axis] < 0) step = -step;
    for (;;) {
      int8_t side = fc_kind_of(&surface->at)->side(&surface->form, point);
      bool right = side != 0 && (side < 0) == surface->inside;
      if (right) out = 0;
      if (out == 0) {
        if (!right) point[axis] += step;
        step /= 2;
        if (step == 0) break;
        point[axis] -= step;
      } else {
        out--;
        point[axis] += step;
      }
    }
  } else if (rule == FC_OFFSET_EPSILON) {
    /* along a unit normal in Q30 that is within 2^-24 */
    fc_quick length = fc_quick_from((uint64_t)fc_dot(n, n), 0);
    if (length.m == 0) return;
    length = fc_quick_rsqrt(length);
    for (i = 0; i < 3; i++)
      point[i] += fc_i128_to_i64(fc_i128_round_shift(fc_i128_mul(fc_quick_times(length, n[i], 30), epsilon), 30));
  }
}

/* cos (n, L - P), divided by the squared distance in world units when the light falls off, times 2^24: within 2^-22 of it. */
static FC_COLD uint32_t irradiance_q24(const fc_frame *frame, const fc_surface *surface, const fc_light *light,
                                       const int64_t position[3]) {
  int64_t v[3], n[3], along;
  uint8_t i, v_shift;
  fc_quick inverse, value;
  for (i = 0; i < 3; i++) v[i] = position[i] - surface->point[i];
  v_shift = fc_shrink(v, v);
  (void)fc_shrink(surface->normal, n);
  along = fc_dot(n, v);
  if (surface->inside) along = -along;
  if (along <= 0) return 0; /* grazing, and the rounded vectors say so */
  inverse = fc_quick_rsqrt(fc_quick_from((uint64_t)fc_dot(v, v), 0));
  value = fc_quick_mul(fc_quick_from((uint64_t)along, 0), inverse);
  value = fc_quick_mul(value, fc_quick_rsqrt(fc_quick_from((uint64_t)fc_dot(n, n), 0)));
  if (light->inverse_square) {
    int16_t unit = (int16_t)(frame->view.shift - frame->view.fine + frame->scene.exponent - 16 + v_shift);
    value = fc_quick_scale(fc_quick_mul(value, fc_quick_mul(inverse, inverse)), (int16_t)(-2 * unit));
  }
  value.e = (int16_t)(value.e + 24 + light->intensity_exponent);
  return value.e > 0 ? UINT32_MAX : (uint32_t)fc_quick_to_u64(value);
}

FC_COLD void fc_surface_segment(const fc_surface *surface, const int64_t light[3], fc_segment *segment) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    segment->light[i] = light[i];
    segment->point[i] = surface->point[i];
  }
  segment->root = &surface->root;
  segment->direction = surface->direction;
  segment->point_error = surface->point_error;
  segment->outside = true;
  fc_segment_prepare(segment);
}

FC_COLD bool fc_light_reaches(const fc_frame *frame, const fc_space *space, const fc_surface *surface, const int64_t position[3]) {
  fc_segment segment;
  fc_surface_segment(surface, position, &segment);
  if (!fc_kind_of(&surface->at)->facing(&surface->form, &surface->prepared, &segment)) return false;
  if (frame->options.offset_rule == FC_OFFSET_EXACT) return !fc_space_blocked(space, &segment, surface->primitive);
  segment.root = NULL;
  segment.outside = false; /* rounded, it may have slipped through */
  segment.point_error = 0;
  fc_surface_offset(surface, frame->options.offset_rule, frame->epsilon_grid, segment.point);
  fc_segment_prepare(&segment);
  return !fc_space_blocked(space, &segment, FC_PRIMITIVES_MAX);
}

FC_COLD void fc_shade(const fc_frame *frame, const fc_space *space, const fc_surface *surface, const uint8_t most[3],
              uint8_t level[3], uint32_t *lit) {
  /* light arriving a channel, Q39: 16 + 32 bits a light, 65535 lights and ambient: below 2^64 */
  uint64_t sum[3];
  fc_material material;
  const fc_scene *scene = &frame->scene;
  uint16_t i;
  uint8_t j;
  uint16_t diffuse[3];
  FC_READ(&material, scene->materials + surface->form.material, sizeof material);
  diffuse[0] = material.diffuse.r;
  diffuse[1] = material.diffuse.g;
  diffuse[2] = material.diffuse.b;
  sum[0] = (uint64_t)scene->ambient.r << 24;
  sum[1] = (uint64_t)scene->ambient.g << 24;
  sum[2] = (uint64_t)scene->ambient.b << 24;
  *lit = 0;
  for (i = 0; i < scene->light_count; i++) {
    fc_light light;
    uint32_t q24;
    const int64_t *position = frame->lights + 3 * (size_t)i;
    if (!fc_light_reaches(frame, space, surface, position)) continue;
    *lit |= UINT32_C(1) << (i < 31 ? i : 31);
    FC_READ(&light, scene->lights + i, sizeof light);
    q24 = irradiance_q24(frame, surface, &light, position);
    sum[0] += (uint64_t)light.intensity.r * q24;
    sum[1] += (uint64_t)light.intensity.g * q24;
    sum[2] += (uint64_t)light.intensity.b * q24;
  }
  for (j = 0; j < 3; j++) {
    uint64_t q24 = (sum[j] + (1u << 14)) >> 15;
    level[j] = fc_pixel_level(diffuse[j], most[j], q24 > UINT32_MAX ? UINT32_MAX : (uint32_t)q24);
  }
}
