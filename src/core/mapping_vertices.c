/* The mapping by texture coordinates at a triangle's vertices. */
#include "fixcast/error.h"
#include "texture.h"
#include "vertex.h"

static FC_COLD int check(const fc_mapping *mapping) {
  (void)mapping; /* nothing of its own */
  return FC_OK;
}

static FC_COLD void locate(const fc_shading *shading, const fc_mapping *mapping, int64_t uv_q24[2]) {
  const fc_uv *uvs = shading->surface->at.group.shapes.uvs;
  fc_corner corner[3];
  uint8_t i;
  (void)mapping;
  uv_q24[0] = uv_q24[1] = 0;
  if (uvs == NULL || !fc_corners_of(shading->surface, corner)) return;
  for (i = 0; i < 3; i++) {
    fc_uv uv;
    FC_READ_ONE(&uv, uvs + corner[i].vertex);
    /* 31 + 31 bits, weights that add up to 1: Q46 */
    uv_q24[0] += uv.u * (int64_t)corner[i].weight_q30;
    uv_q24[1] += uv.v * (int64_t)corner[i].weight_q30;
  }
  uv_q24[0] = fc_floor_shift64(uv_q24[0], 22);
  uv_q24[1] = fc_floor_shift64(uv_q24[1], 22);
}

const fc_mapping_kind fc_mapping_vertices FC_ROM = {check, locate};
