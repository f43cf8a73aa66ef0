/* The layer of perfect mirrors: a path of rays, one after the other. */
#include "fixcast/error.h"
#include "layer.h"
#include "space.h"
#include "view.h"

static FC_COLD int check(const void *data) {
  fc_mirror mirror;
  FC_READ(&mirror, data, sizeof mirror);
  if (mirror.bounces < 1 || mirror.bounces > FC_BOUNCES_MAX) return FC_ERR_MATERIAL;
  return mirror.reflectance.r > FC_ONE_Q15 || mirror.reflectance.g > FC_ONE_Q15 || mirror.reflectance.b > FC_ONE_Q15
             ? FC_ERR_MATERIAL
             : FC_OK;
}

/* d (n.n) - 2 n (n.d), as long as 30 bits allow. */
static FC_COLD void reflect(const int64_t d[3], const int64_t n[3], int64_t to[3]) {
  /* 30 bits each: n.n below 2^62, 2 n.d too; products below 2^92 and their differences below 2^93 */
  const int64_t square = fc_dot(n, n), along = 2 * fc_dot(n, d);
  fc_i128 r[3];
  uint8_t i, bits = 0;
  for (i = 0; i < 3; i++) {
    fc_i128 part = fc_i128_mul(n[i], along);
    uint8_t length;
    r[i] = fc_i128_mul(d[i], square);
    fc_i128_minus(&r[i], &part);
    length = (uint8_t)fc_i128_bits(r[i]);
    if (length > bits) bits = length;
  }
  for (i = 0; i < 3; i++) to[i] = fc_i128_to_i64(bits > 29 ? fc_i128_round_shift(r[i], (uint8_t)(bits - 29)) : r[i]);
}

static FC_COLD void follow(fc_shading *first, const void *data) {
  const fc_frame *frame = first->frame;
  fc_mirror mirror;
  fc_surface surface = *first->surface;
  fc_shading shading;
  int64_t origin[3], direction[3], normal[3];
  uint16_t weight[3];
  uint8_t bounce, bounces, i;
  FC_READ(&mirror, data, sizeof mirror);
  bounces = mirror.bounces;
  fc_channels(&mirror.reflectance, weight);
  for (i = 0; i < 3; i++) {
    normal[i] = first->normal[i];
    direction[i] = surface.direction[i];
  }
  for (bounce = 1;; bounce++) {
    uint64_t radiance_q39[3];
    uint32_t lit;
    uint16_t nearest, reflectance[3];
    int64_t from[3];
    for (i = 0; i < 3; i++) from[i] = direction[i];
    reflect(from, normal, direction);
    fc_surface_offset(&surface, FC_OFFSET_RESIDUAL, 0, origin);
    nearest = fc_space_nearest(first->space, origin, direction, 0, UINT64_MAX, NULL);
    if (nearest == FC_PRIMITIVES_MAX || !fc_surface_meet(&surface, first->space, nearest, origin, direction) ||
        fc_too_far(frame, &surface.root, direction)) {
      fc_shade_background(frame, radiance_q39);
      fc_radiance_add(first->added, weight, radiance_q39);
      return;
    }
    fc_surface_complete(&surface);
    /* rounded to a unit, for the next ray starts there */
    if (fc_point_at(fc_root_value(&surface.root), origin, direction, surface.point)) surface.point_error = 1;
    fc_kind_of(&surface.at)->normal(&surface.form, surface.point, surface.normal);
    fc_shading_light(&shading, frame, first->space, &surface, &lit);
    fc_shading_radiance(&shading, radiance_q39);
    fc_radiance_add(first->added, weight, radiance_q39);
    data = fc_layer_data(&shading.material, &fc_layer_mirror);
    if (data == NULL || bounce == bounces) return;
    FC_READ(&mirror, data, sizeof mirror);
    fc_channels(&mirror.reflectance, reflectance);
    for (i = 0; i < 3; i++) {
      weight[i] = (uint16_t)(((uint32_t)weight[i] * reflectance[i] + (1u << 14)) >> 15); /* at most 2^15 each */
      normal[i] = shading.normal[i];
    }
  }
}

const fc_layer_kind fc_layer_mirror FC_ROM = {check, NULL, NULL, follow};
