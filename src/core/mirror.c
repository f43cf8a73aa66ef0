/* The layer of perfect mirrors: a path of rays, one after the other. */
#include "coat.h"
#include "fixcast/error.h"
#include "fixcast/reflect.h"
#include "layer.h"
#include "search.h"
#include "space.h"
#include "view.h"

static FC_COLD int check(const void *data) {
  fc_mirror mirror;
  if (data == NULL) return FC_ERR_MATERIAL;
  FC_READ(&mirror, data, sizeof mirror);
  if (mirror.bounces < 1 || mirror.bounces > FC_BOUNCES_MAX) return FC_ERR_MATERIAL;
  return mirror.reflectance.r > FC_ONE_Q15 || mirror.reflectance.g > FC_ONE_Q15 || mirror.reflectance.b > FC_ONE_Q15
             ? FC_ERR_MATERIAL
             : FC_OK;
}

static FC_COLD fc_vec3 vec3_of(const int64_t v[3]) {
  fc_vec3 r;
  r.x = (int32_t)v[0];
  r.y = (int32_t)v[1];
  r.z = (int32_t)v[2];
  return r;
}

/* Vectors of up to 30 bits; a zero normal, which no shape has, sends the ray on. */
static FC_COLD void reflect(const int64_t d[3], const int64_t n[3], int64_t to[3]) {
  fc_vec3 direction = vec3_of(d), normal = vec3_of(n);
  (void)fc_reflect(&direction, &direction, &normal);
  to[0] = direction.x;
  to[1] = direction.y;
  to[2] = direction.z;
}

/* A mirrored ray. Planes are met beyond the 30 bits within which the other forms hold, so it may start far out there: all others are met from where
 * it enters the cube that holds them. */
typedef struct mirrored {
  int64_t origin[3], direction[3];
  int64_t near[3]; /* in the cube: the origin, or a point of the ray, rounded */
  fc_num ahead;    /* near's ray parameter */
  bool far;        /* the origin is not in the cube */
  bool misses;     /* and the ray never is */
  uint16_t found;  /* 0xffff: nothing yet */
  bool found_near; /* and met from near */
  fc_num t;        /* where it is, from the origin */
} mirrored;

static FC_COLD void bring_near(mirrored *ray) {
  const int64_t cube = INT64_C(1) << 30;
  uint8_t i;
  ray->far = ray->misses = false;
  fc_num_set(&ray->ahead, 0, 0);
  for (i = 0; i < 3; i++) {
    const uint64_t out = fc_abs64(ray->origin[i]);
    fc_num t;
    ray->near[i] = ray->origin[i];
    if (out <= (uint64_t)cube) continue;
    ray->far = true;
    if (fc_sign64(ray->origin[i]) * fc_sign64(ray->direction[i]) >= 0) {
      ray->misses = true;
    } else {
      fc_num_set(&t, out - (uint64_t)cube, 0);
      fc_num_over_u64(&t, fc_abs64(ray->direction[i]));
      if (fc_num_order_of(&t, &ray->ahead) > 0) ray->ahead = t;
    }
  }
  if (!ray->far || ray->misses) return;
  (void)fc_point_at(ray->ahead, ray->origin, ray->direction, ray->near);
  for (i = 0; i < 3; i++) {
    if (fc_abs64(ray->near[i]) > (uint64_t)cube + 2) ray->misses = true;
    if (ray->near[i] > cube) ray->near[i] = cube;
    if (ray->near[i] < -cube) ray->near[i] = -cube;
  }
}

static FC_COLD bool visit(void *context, const fc_cursor *at, uint16_t index) {
  mirrored *ray = context;
  const bool from_near = ray->far && fc_kind_of(at)->bounds != NULL;
  fc_form form;
  fc_root root;
  fc_num t;
  if (from_near && ray->misses) return false;
  fc_kind_of(at)->fetch(&at->group, index, &form);
  if (fc_form_meet(fc_kind_of(at), &form, from_near ? ray->near : ray->origin, ray->direction, &root) == 0) return false;
  t = fc_root_value(&root);
  if (from_near) fc_num_plus(&t, &ray->ahead);
  if (ray->found == FC_PRIMITIVES_MAX || fc_num_order_of(&t, &ray->t) < 0) {
    ray->found = (uint16_t)(at->group.first + index);
    ray->found_near = from_near;
    ray->t = t;
  }
  return false;
}

static FC_COLD bool too_far(const fc_frame *frame, const mirrored *ray) {
  fc_num limit, distance = fc_length(ray->direction);
  if (frame->scene.far_limit == 0) return false;
  fc_num_set(&limit, (uint64_t)frame->scene.far_limit, fc_view_far_exponent(frame));
  fc_num_times(&distance, &ray->t);
  return fc_num_order_of(&distance, &limit) > 0;
}

/* The surface that the ray meets first, completed, its point within a unit; false for none within the far limit. */
static FC_COLD bool meet(const fc_frame *frame, const fc_space *space, mirrored *ray, fc_surface *surface) {
  const int64_t *from;
  fc_reach reach;
  bring_near(ray);
  reach.from = ray->near;
  reach.to = ray->direction;
  reach.corners = 0;
  reach.radius = 0;
  reach.limited = false;
  ray->found = FC_PRIMITIVES_MAX;
  (void)fc_space_search(space, &reach, visit, ray);
  if (ray->found == FC_PRIMITIVES_MAX || too_far(frame, ray)) return false;
  from = ray->found_near ? ray->near : ray->origin;
  if (!fc_surface_meet(surface, space, ray->found, from, ray->direction)) return false;
  fc_surface_complete(surface);
  fc_surface_round(surface); /* the next ray starts there */
  return true;
}

static FC_COLD void follow(fc_shading *first, const void *data) {
  const fc_frame *frame = first->frame;
  fc_mirror mirror;
  fc_surface surface = *first->surface;
  fc_shading shading;
  mirrored ray;
  int64_t normal[3], from[3];
  uint16_t weight[3];
  uint8_t bounce, bounces, i;
  FC_READ(&mirror, data, sizeof mirror);
  bounces = mirror.bounces;
  fc_channels(&mirror.reflectance, weight);
  for (i = 0; i < 3; i++) {
    normal[i] = first->normal[i];
    from[i] = surface.direction[i];
  }
  for (bounce = 1;; bounce++) {
    uint64_t radiance_q39[3];
    uint16_t reflectance[3];
    reflect(from, normal, ray.direction);
    fc_surface_offset(&surface, FC_OFFSET_RESIDUAL, 0, ray.origin);
    if (!meet(frame, first->space, &ray, &surface)) {
      fc_shade_background(frame, ray.direction, radiance_q39);
      fc_radiance_add(first->added, weight, radiance_q39);
      return;
    }
    fc_shading_light(&shading, frame, first->space, &surface, fc_lights_reaching(frame, first->space, &surface));
    fc_shading_radiance(&shading, radiance_q39);
    fc_radiance_add(first->added, weight, radiance_q39);
    data = fc_layer_data(&shading.material, &fc_layer_mirror);
    if (data == NULL || bounce == bounces) return;
    FC_READ(&mirror, data, sizeof mirror);
    fc_channels(&mirror.reflectance, reflectance);
    for (i = 0; i < 3; i++) {
      weight[i] = (uint16_t)(((uint32_t)weight[i] * reflectance[i] + (1u << 14)) >> 15); /* at most 2^15 each */
      normal[i] = shading.normal[i];
      from[i] = ray.direction[i];
    }
  }
}

const fc_layer_kind fc_layer_mirror FC_ROM = {check, NULL, NULL, follow, &fc_coat_layer_mirror};
