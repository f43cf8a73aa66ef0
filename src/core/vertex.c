/* The vertices of a hit triangle, with their weights. */
#include "vertex.h"

#include "bits.h"

FC_COLD bool fc_corners_of(const fc_surface *surface, fc_corner corner[3]) {
  const fc_kind *kind = fc_kind_of(&surface->at);
  const fc_group *group = &surface->at.group;
  fc_triangle triangle;
  fc_prepared prepared;
  uint32_t weight_q30[3];
  uint8_t i;
  if (kind->weights == NULL) return false;
  FC_READ_ONE(&triangle, (const fc_triangle *)group->shapes.items + (surface->primitive - group->first));
  kind->prepare(&surface->form, surface->origin, &prepared);
  kind->weights(&prepared, surface->direction, weight_q30);
  for (i = 0; i < 3; i++) {
    corner[i].weight_q30 = weight_q30[i];
    corner[i].vertex = triangle.vertex[i];
  }
  return true;
}
