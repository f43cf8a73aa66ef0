/* Triangles with vertices of 16 bits a coordinate: half the flash where a scene's grid allows it. */
#include "fixcast/error.h"
#include "mesh_world.h"

#define SHIFT_MAX 15

/* At most 2^15 * 2^15. */
static inline void fc_read_world(const fc_shapes *shapes, uint16_t index, fc_vec3 *v) {
  const fc_short_vec3 *from = (const fc_short_vec3 *)shapes->vertices + index;
  const int32_t unit = INT32_C(1) << shapes->vertex_shift;
  fc_short_vec3 copy;
  FC_READ_ONE(&copy, from);
  v->x = copy.x * unit;
  v->y = copy.y * unit;
  v->z = copy.z * unit;
}

static int check_short(const fc_scene *scene, const fc_shapes *shapes) {
  return shapes->vertex_shift > SHIFT_MAX ? FC_ERR_EXPONENT : check(scene, shapes);
}

const fc_kind fc_kind_triangle_short FC_ROM = FC_KIND_OF_TRIANGLES(check_short, extent, place, fetch);
