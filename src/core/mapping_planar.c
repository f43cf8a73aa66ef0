/* The mapping by two axes in the world. */
#include "fixcast/error.h"
#include "segment.h"
#include "texture.h"
#include "view.h"

static FC_COLD int check(const fc_mapping *mapping) {
  int64_t v[3];
  if (mapping->exponent < -31 || mapping->exponent > 32) return FC_ERR_EXPONENT;
  if (!fc_load(&mapping->origin, v)) return FC_ERR_COORDINATE;
  if (!fc_load(&mapping->u, v)) return FC_ERR_COORDINATE;
  if ((v[0] | v[1] | v[2]) == 0) return FC_ERR_MATERIAL;
  if (!fc_load(&mapping->v, v)) return FC_ERR_COORDINATE;
  return (v[0] | v[1] | v[2]) == 0 ? FC_ERR_MATERIAL : FC_OK;
}

/* offset . axis / axis.axis, Q24: the offset in 2^far camera units, at most 30 bits. */
static FC_COLD int64_t along(const fc_view *view, const int64_t offset[3], uint8_t far, const fc_vec3 *axis, int8_t exponent) {
  int64_t world[3], camera[3], dot;
  uint8_t shift;
  fc_quick scale, value;
  (void)fc_load(axis, world);
  fc_view_turn(view, world, camera);
  shift = fc_shrink(camera, camera);
  scale = fc_quick_recip(fc_quick_from((uint64_t)fc_dot(world, world), 0)); /* below 3 2^60 */
  scale = fc_quick_scale(scale, (int16_t)(view->shift - view->fine + shift + far - exponent - 30 + 24));
  dot = fc_dot(offset, camera); /* 30 + 30 bits, three of them: below 2^62 */
  value = fc_quick_mul(fc_quick_from(dot < 0 ? (uint64_t)-dot : (uint64_t)dot, 0), scale);
  if (value.m != 0 && value.e > 18) { /* 2^50 and more: so far away that no texel can be told */
    value.m = UINT32_C(1) << 31;
    value.e = 18;
  }
  return dot < 0 ? -(int64_t)fc_quick_to_u64(value) : (int64_t)fc_quick_to_u64(value);
}

static FC_COLD void locate(const fc_shading *shading, const fc_mapping *mapping, int64_t uv_q24[2]) {
  const fc_view *view = &shading->frame->view;
  int64_t offset[3];
  uint8_t i, far;
  uv_q24[0] = uv_q24[1] = 0;
  if (!fc_view_point(view, &mapping->origin, mapping->exponent, offset)) return;
  for (i = 0; i < 3; i++) offset[i] = shading->surface->point[i] - offset[i]; /* planes reach farther than 30 bits */
  far = fc_shrink(offset, offset);
  uv_q24[0] = along(view, offset, far, &mapping->u, mapping->exponent);
  uv_q24[1] = along(view, offset, far, &mapping->v, mapping->exponent);
}

/* (P - origin).u / u.u with P = k D / (n.D) is D.(k u - n (origin.u)) / (n.D) / u.u: with the exact normal, as planes may be seen edge-on. */
static FC_COLD bool forms(const fc_coat *coat, const fc_mapping *mapping, fc_mapping_forms *of) {
  const fc_view *view = &coat->scan->frame->view;
  const fc_planar *planar = coat->planar;
  const uint8_t n_bits = fc_vector_bits(planar->exact);
  int64_t origin[3];
  uint8_t i, j;
  if (!fc_view_point(view, &mapping->origin, mapping->exponent, origin) || fc_vector_bits(origin) > 30) return false;
  /* to 62 bits */
  for (j = 0; j < 3; j++) of->n[j] = n_bits > 62 ? fc_floor_shift64(planar->exact[j], 1) : planar->exact[j] * (INT64_C(1) << (62 - n_bits));
  for (i = 0; i < 2; i++) {
    int64_t world[3], axis[3], dot;
    fc_i128 m[3];
    uint8_t shift, bits = 0, down;
    (void)fc_load(i == 0 ? &mapping->u : &mapping->v, world);
    fc_view_turn(view, world, axis);
    shift = fc_shrink(axis, axis);
    dot = fc_dot(origin, axis); /* 30 + 30 bits, three of them */
    for (j = 0; j < 3; j++) {
      /* k below 2^95 and 30 bits, and 63 + 62: below 2^126 */
      fc_i128 back = fc_i128_mul(planar->exact[j], dot);
      m[j] = fc_i128_scale(planar->exact_k, axis[j]);
      fc_i128_minus(&m[j], &back);
      if (fc_i128_bits(fc_i128_abs(m[j])) > bits) bits = fc_i128_bits(fc_i128_abs(m[j]));
    }
    down = bits > 61 ? (uint8_t)(bits - 61) : 0;
    for (j = 0; j < 3; j++) of->m[i][j] = fc_i128_to_i64(fc_i128_floor_shift(m[j], down));
    if (down == 0 && bits < 61)
      for (j = 0; j < 3; j++) of->m[i][j] *= INT64_C(1) << (61 - bits);
    /* as `along`; m in 2^(bits - 61), n in 2^(n_bits - 62) */
    of->scale[i] = fc_quick_recip(fc_quick_from((uint64_t)fc_dot(world, world), 0));
    of->scale[i] = fc_quick_scale(of->scale[i], (int16_t)(view->shift - view->fine + shift - mapping->exponent - 30 + bits - 61 + 62 - n_bits));
  }
  return true;
}

const fc_mapping_kind fc_mapping_planar FC_ROM = {check, locate, forms};
