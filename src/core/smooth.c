/* The layer of smooth shading: normals between those of a triangle's vertices. */
#include "coat.h"
#include "fixcast/error.h"
#include "layer.h"
#include "segment.h"
#include "vertex.h"
#include "view.h"

static FC_COLD int check(const void *data) { return data == NULL ? FC_OK : FC_ERR_MATERIAL; }

static FC_COLD void surface(fc_shading *shading, const void *data) {
  const fc_normal *normals = shading->surface->at.group.shapes.normals;
  const fc_view *view = &shading->frame->view;
  fc_corner corner[3];
  int64_t world[3] = {0, 0, 0}, n[3];
  uint8_t i;
  (void)data;
  if (normals == NULL || !fc_corners_of(shading->surface, corner)) return;
  for (i = 0; i < 3; i++) {
    fc_normal normal;
    FC_READ_ONE(&normal, normals + corner[i].vertex);
    /* Q14 and 15 bits of a weight */
    world[0] += normal.x * (int64_t)corner[i].weight_q30;
    world[1] += normal.y * (int64_t)corner[i].weight_q30;
    world[2] += normal.z * (int64_t)corner[i].weight_q30;
  }
  for (i = 0; i < 3; i++) world[i] = fc_floor_shift64(world[i], 15); /* Q44 as Q29 */
  fc_view_turn(view, world, n);
  if ((n[0] | n[1] | n[2]) == 0) return;
  (void)fc_shrink(n, n);
  /* to the side that the flat triangle is seen from */
  if (fc_dot(n, shading->normal) < 0)
    for (i = 0; i < 3; i++) n[i] = -n[i];
  for (i = 0; i < 3; i++) shading->normal[i] = n[i];
}

const fc_layer_kind fc_layer_smooth FC_ROM = {check, surface, NULL, NULL, &fc_coat_layer_smooth};
