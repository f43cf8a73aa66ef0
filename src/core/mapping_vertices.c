/* The mapping by texture coordinates at a triangle's vertices. */
#include "fixcast/error.h"
#include "mesh.h"
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

/* u = sum of u_i w_i / sum of w_i with w_i = D.(V_i+1 x V_i+2), and those sum up to D.(B - A) x (C - A). */
static FC_COLD bool forms(const fc_coat *coat, const fc_mapping *mapping, fc_mapping_forms *of) {
  const fc_scan *scan = coat->scan;
  const fc_uv *uvs = scan->at->group.shapes.uvs;
  const fc_quick scale = fc_quick_from(1, 17);
  fc_triangle copy;
  const fc_triangle *triangle = fc_triangle_at(&scan->at->group.shapes, scan->index, &copy);
  int64_t normal[3];
  uint8_t i, j, k;
  (void)mapping;
  if (uvs == NULL || fc_kind_of(scan->at)->weights == NULL) return false;
  fc_face_normal(scan->form, normal);
  for (j = 0; j < 3; j++) {
    /* towards the far side, as fc_planar.exact; in 2^1, and m in 2^34 */
    of->n[j] = fc_floor_shift64(coat->planar->exact[j], 1);
    of->m[0][j] = of->m[1][j] = 0;
  }
  for (i = 0; i < 3; i++) {
    int64_t n[3];
    fc_uv uv;
    FC_READ_ONE(&uv, uvs + triangle->vertex[i]);
    fc_cross(scan->form->u.triangle.vertex[i == 2 ? 0 : i + 1], scan->form->u.triangle.vertex[i == 0 ? 2 : i - 1], n);
    for (j = 0; j < 3; j++) {
      const bool turned = (normal[j] < 0) != (coat->planar->exact[j] < 0);
      for (k = 0; k < 2; k++) {
        const int64_t part = fc_floor_shift64(fc_smul64hi(n[j], k == 0 ? uv.u : uv.v), 2);
        of->m[k][j] += turned ? -part : part;
      }
    }
  }
  of->scale[0] = of->scale[1] = scale;
  return true;
}

const fc_mapping_kind fc_mapping_vertices FC_ROM = {check, locate, forms};
