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

/* (P - origin).u / u.u with P = k D / (n.D) is D.(k u - n (origin.u)) / (n.D) / u.u. */
static FC_COLD bool forms(const fc_coat *coat, const fc_mapping *mapping, fc_mapping_forms *of) {
  const fc_view *view = &coat->scan->frame->view;
  const fc_planar *planar = coat->planar;
  int64_t origin[3];
  uint8_t i, j;
  if (!fc_view_point(view, &mapping->origin, mapping->exponent, origin) || fc_vector_bits(origin) > 30) return false;
  for (j = 0; j < 3; j++) of->n[j] = planar->normal[j] * (INT64_C(1) << 32); /* 30 + 32 bits */
  for (i = 0; i < 2; i++) {
    int64_t world[3], axis[3], dot;
    uint8_t shift;
    (void)fc_load(i == 0 ? &mapping->u : &mapping->v, world);
    fc_view_turn(view, world, axis);
    shift = fc_shrink(axis, axis);
    dot = fc_dot(origin, axis); /* 30 + 30 bits, three of them */
    for (j = 0; j < 3; j++) of->m[i][j] = fc_smul64hi(planar->k, (int32_t)axis[j]) - fc_smul64hi(dot, (int32_t)planar->normal[j]);
    /* as `along`; m is in 2^32 and n in 2^-32 */
    of->scale[i] = fc_quick_recip(fc_quick_from((uint64_t)fc_dot(world, world), 0));
    of->scale[i] = fc_quick_scale(of->scale[i], (int16_t)(view->shift - view->fine + shift - mapping->exponent - 30 + 64));
  }
  return true;
}

const fc_mapping_kind fc_mapping_planar FC_ROM = {check, locate, forms};
