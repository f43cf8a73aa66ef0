/* Tables of a scene: checks, cursors and single primitives. */
#include "space.h"

#include "bits.h"
#include "fixcast/error.h"
#include "layer.h"
#include "search.h"
#include "sky.h"

FC_COLD void fc_cursor_start(fc_cursor *cursor, const fc_space *space) {
  cursor->space = space;
  cursor->table = 0;
  cursor->bytes = 0;
  cursor->group.shapes.count = 0;
  cursor->group.first = 0;
}

FC_COLD bool fc_cursor_next(fc_cursor *cursor) {
  const fc_space *space = cursor->space;
  if (cursor->table > 0) cursor->bytes += (size_t)fc_kind_of(cursor)->memory(&cursor->group.shapes);
  if (cursor->table == space->scene->shape_count) return false;
  cursor->group.first = (uint16_t)(cursor->group.first + cursor->group.shapes.count);
  FC_READ_ONE(&cursor->group.shapes, space->scene->shapes + cursor->table);
#ifdef FC_ROM_FAR
  FC_READ_ONE(&cursor->kind, cursor->group.shapes.kind);
#endif
  cursor->group.memory = space->memory == NULL ? NULL : (const unsigned char *)space->memory + cursor->bytes;
  cursor->table++;
  return true;
}

FC_COLD bool fc_cursor_find(fc_cursor *cursor, const fc_space *space, uint16_t primitive, uint16_t *index) {
  fc_cursor_start(cursor, space);
  while (fc_cursor_next(cursor)) {
    *index = (uint16_t)(primitive - cursor->group.first);
    if (*index < cursor->group.shapes.count) return true;
  }
  return false;
}

static int check_light(const fc_scene *scene, uint16_t index) {
  fc_light light;
  FC_READ_ONE(&light, scene->lights + index);
  if (fc_abs32(light.position.x) > (uint32_t)FC_COORDINATE_MAX ||
      fc_abs32(light.position.y) > (uint32_t)FC_COORDINATE_MAX ||
      fc_abs32(light.position.z) > (uint32_t)FC_COORDINATE_MAX)
    return FC_ERR_COORDINATE;
  if (light.directional > 1 || (light.directional == 1 && ((light.position.x | light.position.y | light.position.z) == 0 ||
                                                           light.exponent != 0 || light.inverse_square != 0)))
    return FC_ERR_DIRECTION;
  if (light.exponent < -31 || light.exponent > 32 || light.intensity_exponent < -40 || light.intensity_exponent > 40)
    return FC_ERR_EXPONENT;
  return FC_OK;
}

static FC_COLD int check_material(const fc_scene *scene, uint16_t index) {
  fc_material material;
  uint16_t i;
  FC_READ_ONE(&material, scene->materials + index);
  if (material.layer_count > FC_LAYERS_MAX || (material.layers == NULL && material.layer_count > 0)) return FC_ERR_MATERIAL;
  for (i = 0; i < material.layer_count; i++) {
    fc_layer layer;
    fc_layer_kind kind;
    int error;
    FC_READ_ONE(&layer, material.layers + i);
    if (layer.kind == NULL) return FC_ERR_MATERIAL;
    FC_READ_ONE(&kind, layer.kind);
    error = kind.check(layer.data);
    if (error != FC_OK) return error;
  }
  return FC_OK;
}

FC_COLD int fc_scene_check_tables(const fc_scene *scene) {
  uint32_t primitives = 0;
  uint16_t i;
  if ((scene->shapes == NULL && scene->shape_count > 0) || (scene->materials == NULL && scene->material_count > 0) ||
      (scene->lights == NULL && scene->light_count > 0))
    return FC_ERR_NULL;
  if (scene->exponent < -60 || scene->exponent > 60 || scene->far_exponent < -31 || scene->far_exponent > 32)
    return FC_ERR_EXPONENT;
  if (scene->far_limit < 0 || scene->far_limit > FC_COORDINATE_MAX) return FC_ERR_COORDINATE;
  for (i = 0; i < scene->shape_count; i++) {
    fc_shapes shapes;
    fc_kind kind;
    int error;
    FC_READ_ONE(&shapes, scene->shapes + i);
    if (shapes.kind == NULL || (shapes.items == NULL && shapes.count > 0)) return FC_ERR_NULL;
    primitives += shapes.count;
    if (primitives > FC_PRIMITIVES_MAX) return FC_ERR_COUNT;
    FC_READ_ONE(&kind, shapes.kind);
    error = kind.check(scene, &shapes);
    if (error != FC_OK) return error;
  }
  for (i = 0; i < scene->light_count; i++) {
    int error = check_light(scene, i);
    if (error != FC_OK) return error;
  }
  if (scene->sky != NULL) {
    fc_sky sky;
    fc_sky_kind kind;
    int error;
    FC_READ_ONE(&sky, scene->sky);
    if (sky.kind == NULL) return FC_ERR_NULL;
    FC_READ_ONE(&kind, sky.kind);
    error = kind.check(&sky);
    if (error != FC_OK) return error;
  }
  for (i = 0; i < scene->material_count; i++) {
    uint16_t layers;
    int error;
    FC_READ_ONE(&layers, &scene->materials[i].layer_count);
    if (layers == 0) continue; /* a mesh may have a colour a face */
    error = check_material(scene, i);
    if (error != FC_OK) return error;
  }
  return FC_OK;
}

FC_COLD int fc_scene_check(const fc_scene *scene_rom) {
  fc_scene scene;
  fc_bvh bvh;
  fc_bvh_kind kind;
  int error;
  if (scene_rom == NULL) return FC_ERR_NULL;
  FC_READ_ONE(&scene, scene_rom);
  error = fc_scene_check_tables(&scene);
  if (error != FC_OK || scene.bvh == NULL) return error;
  FC_READ_ONE(&bvh, scene.bvh);
  if (bvh.kind == NULL) return FC_ERR_NULL;
  FC_READ_ONE(&kind, bvh.kind);
  return kind.check(&scene, &bvh);
}

static FC_COLD bool search_bvh(const fc_space *space, fc_reach *reach, fc_visit *visit, void *context) {
  fc_bvh bvh;
  fc_bvh_kind kind;
  FC_READ_ONE(&bvh, space->scene->bvh);
  FC_READ_ONE(&kind, bvh.kind);
  return kind.search(&bvh, space, reach, visit, context);
}

FC_COLD size_t fc_search_marks(const fc_scene *scene) {
  const fc_space space = fc_space_of_world(scene);
  fc_cursor cursor;
  fc_bvh bvh;
  if (scene->bvh == NULL) return 0;
  FC_READ_ONE(&bvh, scene->bvh);
  fc_cursor_start(&cursor, &space);
  while (bvh.count > 0 && fc_cursor_next(&cursor))
    if (fc_kind_of(&cursor)->casts != NULL) return (((size_t)2 << bvh.depth) + 63) / 64 * 8; /* nodes 1 .. 2^(depth + 1) - 1 */
  return 0;
}

FC_COLD void fc_search_mark(const fc_space *space, uint8_t *bits) {
  fc_bvh bvh;
  fc_bvh_kind kind;
  FC_READ_ONE(&bvh, space->scene->bvh);
  FC_READ_ONE(&kind, bvh.kind);
  kind.mark(&bvh, space, bits);
}

FC_COLD bool fc_space_search(const fc_space *space, fc_reach *reach, fc_visit *visit, void *context) {
  bool sieve = reach != NULL && space->scene->bvh != NULL;
  fc_cursor cursor;
  fc_cursor_start(&cursor, space);
  while (fc_cursor_next(&cursor)) {
    uint16_t i;
    if (sieve && fc_kind_of(&cursor)->bounds != NULL) continue;
    for (i = 0; i < cursor.group.shapes.count; i++)
      if (visit(context, &cursor, i)) return true;
  }
  return sieve && search_bvh(space, reach, visit, context);
}

/* What is being tested for lying on a segment. */
typedef struct block_test {
  fc_segment *segment;
  fc_form *form; /* what is tested */
  uint16_t skip;
} block_test;

static bool blocks(void *context, const fc_cursor *at, uint16_t index) {
  const block_test *test = context;
  if ((uint16_t)(at->group.first + index) == test->skip) return false;
  fc_kind_of(at)->fetch(&at->group, index, test->form);
  return fc_kind_of(at)->blocked(test->form, test->segment);
}

static FC_COLD bool blocked_in(fc_form *form, const fc_space *space, fc_segment *segment, uint16_t skip) {
  block_test test;
  fc_reach reach;
  test.segment = segment;
  test.form = form;
  test.skip = skip;
  reach.from = segment->light;
  reach.to = segment->point;
  reach.corners = 1;
  reach.radius = segment->point_error;
  reach.limited = false;
  return fc_space_search(space, segment->point_error != UINT32_MAX ? &reach : NULL, blocks, &test);
}

static FC_COLD bool blocked_here(const fc_space *space, fc_segment *segment, uint16_t skip) {
  fc_form form;
  return blocked_in(&form, space, segment, skip);
}

FC_COLD bool fc_space_blocked(const fc_space *space, fc_segment *segment, uint16_t skip) {
  return space->room != NULL ? blocked_in(&space->room->form, space, segment, skip) : blocked_here(space, segment, skip);
}

FC_COLD uint8_t fc_form_meet_in(fc_prepared *prepared, const fc_kind *kind, const fc_form *form, const int64_t origin[3],
                                const int64_t direction[3], fc_root *root) {
  kind->prepare(form, origin, prepared);
  return kind->test(prepared, direction, root);
}

FC_COLD uint8_t fc_form_meet(const fc_kind *kind, const fc_form *form, const int64_t origin[3], const int64_t direction[3],
                             fc_root *root) {
  fc_prepared prepared;
  return fc_form_meet_in(&prepared, kind, form, origin, direction, root);
}

FC_COLD bool fc_surface_meet(fc_surface *surface, const fc_space *space, uint16_t primitive, const int64_t origin[3],
                             const int64_t direction[3]) {
  uint16_t index;
  if (!fc_cursor_find(&surface->at, space, primitive, &index)) return false;
  surface->primitive = primitive;
  surface->origin = origin;
  surface->direction = direction;
  fc_kind_of(&surface->at)->fetch(&surface->at.group, index, &surface->form);
  return fc_form_meet(fc_kind_of(&surface->at), &surface->form, origin, direction, &surface->root) != 0;
}

FC_COLD void fc_surface_complete(fc_surface *surface) {
  surface->point_error = fc_point_near(fc_root_quick(&surface->root), surface->origin, surface->direction, surface->point);
  fc_kind_of(&surface->at)->normal(&surface->form, surface->point, surface->normal);
  /* inside a sphere the root says so; elsewhere the origin, which is not on the surface, is behind it */
  surface->inside = surface->root.q > 0 ||
                    (surface->root.q == 0 && fc_kind_of(&surface->at)->side(&surface->form, surface->origin) < 0);
}

FC_COLD void fc_surface_round(fc_surface *surface) {
  if (fc_point_at(fc_root_value(&surface->root), surface->origin, surface->direction, surface->point)) surface->point_error = 1;
  fc_kind_of(&surface->at)->normal(&surface->form, surface->point, surface->normal);
}
