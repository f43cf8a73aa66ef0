/* The mapping by two axes in the world. */
#include "fixcast/error.h"
#include "segment.h"
#include "texture.h"
#include "view.h"

static FC_COLD int check(const fc_mapping *mapping) {
  int64_t v[3];
  if (!fc_load(&mapping->origin, v)) return FC_ERR_COORDINATE;
  if (!fc_load(&mapping->u, v)) return FC_ERR_COORDINATE;
  if ((v[0] | v[1] | v[2]) == 0) return FC_ERR_MATERIAL;
  if (!fc_load(&mapping->v, v)) return FC_ERR_COORDINATE;
  return (v[0] | v[1] | v[2]) == 0 ? FC_ERR_MATERIAL : FC_OK;
}

/* offset . axis / axis.axis, Q24: the offset in camera units. */
static FC_COLD int64_t along(const fc_view *view, const int64_t offset[3], const fc_vec3 *axis) {
  int64_t world[3], camera[3], dot;
  uint8_t i, shift;
  fc_quick scale, value;
  (void)fc_load(axis, world);
  for (i = 0; i < 3; i++) {
    /* Q30 rows times 30 bits: below 2^62 */
    const int32_t *row = view->row[i];
    camera[i] = row[0] * world[0] + row[1] * world[1] + row[2] * world[2];
  }
  shift = fc_shrink(camera, camera);
  scale = fc_quick_recip(fc_quick_from((uint64_t)fc_dot(world, world), 0)); /* below 3 2^60 */
  scale = fc_quick_scale(scale, (int16_t)(view->shift - view->fine + shift - 30 + 24));
  dot = fc_dot(offset, camera); /* 32 + 30 bits, three of them: below 2^63 */
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
  uint8_t i;
  uv_q24[0] = uv_q24[1] = 0;
  if (!fc_view_point(view, &mapping->origin, 0, offset)) return;
  for (i = 0; i < 3; i++) {
    offset[i] = shading->surface->point[i] - offset[i];
    if (fc_abs64(offset[i]) >> 32 != 0) offset[i] = offset[i] < 0 ? -(INT64_C(1) << 32) : INT64_C(1) << 32; /* a plane, far away */
  }
  uv_q24[0] = along(view, offset, &mapping->u);
  uv_q24[1] = along(view, offset, &mapping->v);
}

const fc_mapping_kind fc_mapping_planar FC_ROM = {check, locate};
