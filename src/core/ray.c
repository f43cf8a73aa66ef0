/* The ray engine's public face: single rays, segments and offsets in world coordinates. */
#include "fixcast/ray.h"

#include "bits.h"
#include "fixcast/error.h"
#include "search.h"
#include "shade.h"
#include "space.h"
#include "view.h"

#define NO_PRIMITIVE UINT16_C(0xffff)

static int32_t clamp(int64_t v) {
  if (v > FC_COORDINATE_MAX) return FC_COORDINATE_MAX;
  return v < -FC_COORDINATE_MAX ? -FC_COORDINATE_MAX : (int32_t)v;
}

/* origin + t direction on one axis, rounded and clamped. */
static int32_t coordinate_at(fc_num t, int64_t origin, int64_t direction) {
  uint64_t step = fc_num_round(fc_num_mul(t, fc_num_from_u64(fc_abs64(direction), 0)), 0);
  int64_t reach = step >> 40 ? INT64_C(1) << 40 : (int64_t)step; /* far beyond any coordinate */
  return clamp(direction < 0 ? origin - reach : origin + reach);
}

/* Makes the root the primitive's first within t_min < t < t_max. */
static FC_COLD bool first_within(fc_root *root, uint8_t count, uint64_t t_min_q32, uint64_t t_max_q32) {
  if (t_min_q32 != 0 && fc_root_compare_q32(root, t_min_q32) <= 0) {
    if (count < 2) return false;
    root->q = 1;
    if (fc_root_compare_q32(root, t_min_q32) <= 0) return false;
  }
  return fc_root_compare_q32(root, t_max_q32) < 0;
}

/* The nearest primitive so far. */
typedef struct nearest_test {
  const int64_t *origin, *direction;
  uint64_t t_min_q32, t_max_q32;
  fc_reach *reach; /* NULL: nobody wants to know how far it is */
  fc_room *room;   /* `best` is found so far */
  uint16_t found;
  bool bounded;
} nearest_test;

static FC_COLD uint8_t meet(const fc_cursor *at, uint16_t index, const nearest_test *test, fc_root *root) {
  fc_form *form = &test->room->form;
  fc_kind_of(at)->fetch(&at->group, index, form);
  return fc_form_meet_in(&test->room->prepared, fc_kind_of(at), form, test->origin, test->direction, root);
}

static FC_COLD bool nearer(void *context, const fc_cursor *at, uint16_t index) {
  nearest_test *test = context;
  uint16_t primitive = (uint16_t)(at->group.first + index);
  fc_root *first = &test->room->next;
  uint8_t count = meet(at, index, test, first);
  if (count == 0) return false;
  if (test->bounded && !first_within(first, count, test->t_min_q32, test->t_max_q32)) return false;
  if (test->found != NO_PRIMITIVE) {
    int8_t order = fc_root_compare_in(&test->room->segment.wide, first, &test->room->best);
    if (order > 0 || (order == 0 && primitive > test->found)) return false;
  }
  test->room->best = *first;
  test->found = primitive;
  if (test->reach != NULL) {
    test->reach->limit = fc_root_quick(first);
    test->reach->limited = true;
  }
  return false;
}

static FC_COLD uint16_t nearest_in(fc_room *room, const fc_space *space, const int64_t origin[3], const int64_t direction[3],
                                   uint64_t t_min_q32, uint64_t t_max_q32, fc_root *nearest) {
  nearest_test test;
  fc_reach reach;
  test.origin = origin;
  test.direction = direction;
  test.t_min_q32 = t_min_q32;
  test.t_max_q32 = t_max_q32;
  test.room = room;
  test.reach = space->scene->bvh == NULL ? NULL : &reach;
  test.found = NO_PRIMITIVE;
  test.bounded = nearest != NULL;
  reach.from = origin;
  reach.to = direction;
  reach.corners = 0;
  reach.radius = 0;
  reach.limited = test.bounded && t_max_q32 != UINT64_MAX;
  if (reach.limited) reach.limit = fc_quick_from(t_max_q32, -32);
  (void)fc_space_search(space, &reach, nearer, &test);
  if (test.found != NO_PRIMITIVE && nearest != NULL) *nearest = room->best;
  return test.found;
}

static FC_COLD uint16_t nearest_here(const fc_space *space, const int64_t origin[3], const int64_t direction[3], uint64_t t_min_q32,
                                     uint64_t t_max_q32, fc_root *nearest) {
  fc_room room;
  return nearest_in(&room, space, origin, direction, t_min_q32, t_max_q32, nearest);
}

FC_COLD uint16_t fc_space_nearest(const fc_space *space, const int64_t origin[3], const int64_t direction[3], uint64_t t_min_q32,
                                  uint64_t t_max_q32, fc_root *nearest) {
  return space->room != NULL ? nearest_in(space->room, space, origin, direction, t_min_q32, t_max_q32, nearest)
                             : nearest_here(space, origin, direction, t_min_q32, t_max_q32, nearest);
}

FC_COLD void fc_surface_hit(const fc_surface *surface, fc_hit *hit) {
  int64_t n[3], point[3];
  fc_num length, t = fc_root_value(&surface->root);
  int32_t unit[3];
  uint8_t i;
  (void)fc_point_at(t, surface->origin, surface->direction, point);
  fc_kind_of(&surface->at)->normal(&surface->form, point, n);
  length = fc_length(n);
  for (i = 0; i < 3; i++) {
    int32_t q = 0;
    if (length.m != 0) q = (int32_t)fc_num_round(fc_num_div(fc_num_from_u64(fc_abs64(n[i]), 0), length), 30);
    unit[i] = (n[i] < 0) != surface->inside ? -q : q;
    hit->barycentric_q30[i] = 0;
  }
  hit->normal_q30.x = unit[0];
  hit->normal_q30.y = unit[1];
  hit->normal_q30.z = unit[2];
  hit->t_q32 = fc_num_round(t, 32);
  hit->position.x = coordinate_at(t, surface->origin[0], surface->direction[0]);
  hit->position.y = coordinate_at(t, surface->origin[1], surface->direction[1]);
  hit->position.z = coordinate_at(t, surface->origin[2], surface->direction[2]);
  if (fc_kind_of(&surface->at)->weights != NULL) {
    fc_prepared prepared;
    fc_kind_of(&surface->at)->prepare(&surface->form, surface->origin, &prepared);
    fc_kind_of(&surface->at)->weights(&prepared, surface->direction, hit->barycentric_q30);
  }
  hit->primitive = surface->primitive;
  hit->object = surface->form.object;
  hit->inside = surface->inside;
}

FC_COLD int fc_intersect(const fc_scene *scene_rom, const fc_ray *ray, fc_hit *hit) {
  fc_scene scene;
  fc_space space;
  fc_surface surface;
  fc_root root;
  int64_t origin[3], direction[3];
  uint16_t nearest;
  if (scene_rom == NULL || ray == NULL || hit == NULL) return FC_ERR_NULL;
  if (!fc_load(&ray->origin, origin) || !fc_load(&ray->direction, direction)) return FC_ERR_COORDINATE;
  if ((direction[0] | direction[1] | direction[2]) == 0) return FC_ERR_DIRECTION;
  FC_READ_ONE(&scene, scene_rom);
  space = fc_space_of_world(&scene);
  nearest = fc_space_nearest(&space, origin, direction, ray->t_min_q32, ray->t_max_q32, &root);
  if (nearest == NO_PRIMITIVE) return 0;
  (void)fc_surface_meet(&surface, &space, nearest, origin, direction);
  surface.root = root;
  fc_surface_complete(&surface);
  fc_surface_hit(&surface, hit);
  return 1;
}

FC_COLD int fc_blocked(const fc_scene *scene_rom, const fc_vec3 *from, const fc_vec3 *to) {
  fc_scene scene;
  fc_space space;
  fc_segment segment;
  if (scene_rom == NULL || from == NULL || to == NULL) return FC_ERR_NULL;
  if (!fc_load(from, segment.point) || !fc_load(to, segment.light)) return FC_ERR_COORDINATE;
  FC_READ_ONE(&scene, scene_rom);
  space = fc_space_of_world(&scene);
  segment.point_error = 0;
  segment.outside = false;
  segment.root = NULL;
  segment.direction = NULL;
  fc_segment_prepare(&segment);
  return fc_space_blocked(&space, &segment, NO_PRIMITIVE);
}

FC_COLD int fc_offset(const fc_scene *scene_rom, const fc_hit *hit, int rule, int32_t epsilon, fc_vec3 *point) {
  fc_scene scene;
  fc_space space;
  fc_surface surface;
  int64_t moved[3];
  uint16_t index;
  if (scene_rom == NULL || hit == NULL || point == NULL) return FC_ERR_NULL;
  if (rule < FC_OFFSET_EXACT || rule > FC_OFFSET_NONE) return FC_ERR_FORMAT;
  if (epsilon < 0 || epsilon > FC_COORDINATE_MAX || !fc_load(&hit->position, surface.point)) return FC_ERR_COORDINATE;
  FC_READ_ONE(&scene, scene_rom);
  space = fc_space_of_world(&scene);
  if (!fc_cursor_find(&surface.at, &space, hit->primitive, &index)) return FC_ERR_INDEX;
  fc_kind_of(&surface.at)->fetch(&surface.at.group, index, &surface.form);
  surface.inside = hit->inside;
  surface.point_error = 1;
  /* normal_q30 is turned to the ray's side; a surface's own normal is not */
  surface.normal[0] = hit->inside ? -hit->normal_q30.x : hit->normal_q30.x;
  surface.normal[1] = hit->inside ? -hit->normal_q30.y : hit->normal_q30.y;
  surface.normal[2] = hit->inside ? -hit->normal_q30.z : hit->normal_q30.z;
  fc_surface_offset(&surface, rule, epsilon, moved);
  point->x = clamp(moved[0]);
  point->y = clamp(moved[1]);
  point->z = clamp(moved[2]);
  return FC_OK;
}
