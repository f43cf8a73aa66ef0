/* Lambert's law over exact visibility of the lights. */
#include "shade.h"

#include "bits.h"
#include "layer.h"
#include "pixel.h"
#include "sky.h"
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

FC_COLD fc_quick fc_inverse_length(const int64_t v[3]) {
  const uint64_t square = (uint64_t)fc_dot(v, v);
  const fc_quick none = {0, 0};
  return square == 0 ? none : fc_quick_rsqrt(fc_quick_from(square, 0));
}

/* The light at hand: its direction and strength; returns cos (n, L - P) times 2^24, and by the squared distance in world units
 * when it falls off: within 2^-22 of it. */
static FC_COLD uint32_t irradiance_q24(fc_shading *shading, const fc_light *light, const int64_t position[3]) {
  const fc_frame *frame = shading->frame;
  int64_t along;
  uint8_t i, shift;
  fc_quick inverse, value, strength;
  for (i = 0; i < 3; i++) shading->light.to[i] = position[i] - shading->surface->point[i];
  shift = fc_shrink(shading->light.to, shading->light.to);
  inverse = fc_inverse_length(shading->light.to);
  shading->light.to_scale = inverse;
  fc_channels(&light->intensity, shading->light.colour);
  strength = fc_quick_from(1, light->intensity_exponent);
  if (light->inverse_square) {
    int16_t unit = (int16_t)(frame->view.shift - frame->view.fine + frame->scene.exponent - 16 + shift);
    strength = fc_quick_mul(strength, fc_quick_scale(fc_quick_mul(inverse, inverse), (int16_t)(-2 * unit)));
  }
  shading->light.strength = strength;
  along = fc_dot(shading->normal, shading->light.to);
  if (along <= 0) return 0; /* grazing, and the rounded vectors say so */
  value = fc_quick_mul(fc_quick_from((uint64_t)along, 0), inverse);
  value = fc_quick_mul(fc_quick_mul(value, shading->normal_scale), strength);
  value.e += 24;
  return value.e > 0 ? UINT32_MAX : (uint32_t)fc_quick_to_u64(value);
}

/* A light from a point that a mirror shows: from the rounded point, stepped off its surface. */
static FC_COLD bool reaches_rounded(const fc_space *space, fc_segment *segment, const fc_surface *surface, const int64_t position[3]) {
  fc_i128 along;
  int64_t n[3], to[3];
  uint8_t i;
  for (i = 0; i < 3; i++) segment->light[i] = position[i];
  segment->root = NULL;
  segment->direction = NULL;
  segment->outside = false; /* rounded, it may have slipped through */
  segment->point_error = 0;
  fc_surface_offset(surface, FC_OFFSET_RESIDUAL, 0, segment->point);
  fc_kind_of(&surface->at)->normal(&surface->form, segment->point, n);
  for (i = 0; i < 3; i++) to[i] = position[i] - segment->point[i];
  along = fc_i128_dot(n, to);
  if (fc_i128_sign(along) != (surface->inside ? -1 : 1)) return false;
  fc_segment_prepare(segment);
  /* a surface that faces the light is not in its way, but for a sphere around the point */
  return !fc_space_blocked(space, segment, surface->inside ? FC_PRIMITIVES_MAX : surface->primitive);
}

static FC_COLD bool light_reaches(const fc_frame *frame, const fc_space *space, fc_segment *segment, const fc_surface *surface,
                                  const int64_t position[3]) {
  if ((surface->origin[0] | surface->origin[1] | surface->origin[2]) != 0) return reaches_rounded(space, segment, surface, position);
  fc_segment_from(segment, &surface->root, surface->direction, position);
  if (!fc_kind_of(&surface->at)->facing(&surface->form, segment)) return false;
  if (frame->options.offset_rule == FC_OFFSET_EXACT) return !fc_space_blocked(space, segment, surface->primitive);
  segment->root = NULL;
  segment->outside = false; /* rounded, it may have slipped through */
  segment->point_error = 0;
  fc_surface_offset(surface, frame->options.offset_rule, frame->epsilon_grid, segment->point);
  fc_segment_prepare(segment);
  return !fc_space_blocked(space, segment, FC_PRIMITIVES_MAX);
}

/* Where the space has no room for it, on the stack. */
static FC_COLD bool light_reaches_here(const fc_frame *frame, const fc_space *space, const fc_surface *surface,
                                       const int64_t position[3]) {
  fc_segment segment;
  return light_reaches(frame, space, &segment, surface, position);
}

FC_COLD bool fc_light_reaches(const fc_frame *frame, const fc_space *space, const fc_surface *surface, const int64_t position[3]) {
  return space->room != NULL ? light_reaches(frame, space, &space->room->segment, surface, position)
                             : light_reaches_here(frame, space, surface, position);
}

/* ---- layers ---- */

FC_COLD void fc_radiance_add(uint64_t radiance_q39[3], const uint16_t weight[3], const uint64_t more_q39[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    /* 48 + 16 bits fit; sums below 2^49 + 2^48 */
    uint64_t more = more_q39[i] > FC_RADIANCE_MAX - 1 ? FC_RADIANCE_MAX - 1 : more_q39[i];
    radiance_q39[i] += (more * weight[i] + (1u << 14)) >> 15;
    if (radiance_q39[i] > FC_RADIANCE_MAX) radiance_q39[i] = FC_RADIANCE_MAX;
  }
}

FC_COLD const void *fc_layer_data(const fc_material *material, const fc_layer_kind *kind) {
  uint16_t i;
  for (i = 0; i < material->layer_count; i++) {
    fc_layer layer;
    FC_READ_ONE(&layer, material->layers + i);
    if (layer.kind == kind) return layer.data;
  }
  return NULL;
}

FC_COLD void fc_layers_apply(fc_shading *shading, uint8_t which) {
  uint16_t i;
  for (i = 0; i < shading->material.layer_count; i++) {
    fc_layer layer;
    fc_layer_kind kind;
    void (*act)(fc_shading *, const void *);
    FC_READ_ONE(&layer, shading->material.layers + i);
    FC_READ_ONE(&kind, layer.kind);
    act = which == FC_LAYER_SURFACE ? kind.surface : which == FC_LAYER_LIGHT ? kind.light
                                                                             : kind.follow;
    if (act != NULL) act(shading, layer.data);
  }
}

/* ---- a point ---- */

FC_COLD uint32_t fc_lights_reaching(const fc_frame *frame, const fc_space *space, const fc_surface *surface) {
  uint32_t lit = 0;
  uint16_t i;
  for (i = 0; i < frame->scene.light_count; i++)
    if (fc_light_reaches(frame, space, surface, frame->lights + 3 * (size_t)i)) lit |= UINT32_C(1) << (i < 31 ? i : 31);
  return lit;
}

FC_COLD void fc_shading_light(fc_shading *shading, const fc_frame *frame, const fc_space *space, const fc_surface *surface,
                              uint32_t lit) {
  const fc_scene *scene = &frame->scene;
  uint16_t ambient[3], i;
  uint8_t j;
  shading->frame = frame;
  shading->space = space;
  shading->surface = surface;
  FC_READ_ONE(&shading->material, scene->materials + surface->form.material);
  fc_channels(&shading->material.diffuse, shading->diffuse);
  fc_channels(&scene->ambient, ambient);
  (void)fc_shrink(surface->normal, shading->normal);
  for (j = 0; j < 3; j++) {
    if (surface->inside) shading->normal[j] = -shading->normal[j];
    shading->arriving[j] = (uint64_t)ambient[j] << 24;
    shading->added[j] = 0;
  }
  fc_layers_apply(shading, FC_LAYER_SURFACE);
  shading->normal_scale = fc_inverse_length(shading->normal);
  for (i = 0; i < scene->light_count; i++) {
    fc_light light;
    uint32_t q24;
    const int64_t *position = frame->lights + 3 * (size_t)i;
    if ((lit >> (i < 31 ? i : 31) & 1) == 0) continue;
    if (i >= 31 && !fc_light_reaches(frame, space, surface, position)) continue; /* the last bit stands for several */
    FC_READ_ONE(&light, scene->lights + i);
    q24 = irradiance_q24(shading, &light, position);
    for (j = 0; j < 3; j++) shading->arriving[j] += (uint64_t)shading->light.colour[j] * q24;
    fc_layers_apply(shading, FC_LAYER_LIGHT);
  }
}

FC_COLD void fc_shading_radiance(const fc_shading *shading, uint64_t radiance_q39[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    uint64_t q24 = (shading->arriving[i] + (1u << 14)) >> 15;
    if (q24 > UINT32_MAX) q24 = UINT32_MAX;
    /* 16 + 32 bits, and what layers add */
    radiance_q39[i] = shading->diffuse[i] * q24 + shading->added[i];
    if (radiance_q39[i] > FC_RADIANCE_MAX) radiance_q39[i] = FC_RADIANCE_MAX;
  }
}

static FC_COLD void shade_lit(const fc_frame *frame, const fc_space *space, const fc_surface *surface, uint32_t lit, uint64_t radiance_q39[3]) {
  fc_shading shading;
  fc_shading_light(&shading, frame, space, surface, lit);
  fc_layers_apply(&shading, FC_LAYER_FOLLOW);
  fc_shading_radiance(&shading, radiance_q39);
}

FC_COLD void fc_shade(const fc_frame *frame, const fc_space *space, const fc_surface *surface, uint64_t radiance_q39[3],
                      uint32_t *lit) {
  *lit = fc_lights_reaching(frame, space, surface); /* the deepest calls come before the shading's record */
  shade_lit(frame, space, surface, *lit, radiance_q39);
}

FC_COLD void fc_shade_background(const fc_frame *frame, const int64_t direction[3], uint64_t radiance_q39[3]) {
  uint16_t colour[3];
  uint8_t i;
  if (frame->scene.sky != NULL) {
    fc_sky sky;
    fc_sky_kind kind;
    FC_READ_ONE(&sky, frame->scene.sky);
    FC_READ_ONE(&kind, sky.kind);
    kind.radiance(frame, &sky, direction, radiance_q39);
    return;
  }
  fc_channels(&frame->scene.background, colour);
  for (i = 0; i < 3; i++) radiance_q39[i] = (uint64_t)colour[i] << 24;
}

FC_COLD void fc_shade_put(const fc_frame *frame, const uint64_t radiance_q39[3], uint8_t format, uint8_t *to) {
  uint8_t most[3], level[3], i;
  fc_pixel_most(format, most);
  for (i = 0; i < 3; i++) level[i] = fc_pixel_level(frame->options.transfer, radiance_q39[i], most[i]);
  fc_pixel_put(format, level, to);
}
