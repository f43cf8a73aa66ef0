/* The rival "float" or "double": a ray a pixel, the nearest of all hits, a shadow ray that starts 1/512 off the surface.
 * -DREAL=float -DSQRT=sqrtf or the same of double. */
#include <math.h>

#include "pixel.h"
#include "scene.h"

#define EPSILON R(1.0 / 512)

static vec add(vec a, vec b) { return (vec){a.x + b.x, a.y + b.y, a.z + b.z}; }
static vec sub(vec a, vec b) { return (vec){a.x - b.x, a.y - b.y, a.z - b.z}; }
static vec scale(vec a, real s) { return (vec){a.x * s, a.y * s, a.z * s}; }
static real dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/* The smallest positive t with origin + t direction on the sphere, or 0. `square` is direction . direction. */
static real hit_sphere(vec origin, vec direction, real square, const sphere *s) {
  const vec from = sub(origin, s->center);
  const real b = dot(from, direction), c = dot(from, from) - s->radius * s->radius;
  const real discriminant = b * b - square * c;
  real root, t;
  if (discriminant < 0) return 0;
  root = SQRT(discriminant);
  t = (-b - root) / square;
  if (t <= 0) t = (-b + root) / square;
  return t > 0 ? t : 0;
}

static real hit_plane(vec origin, vec direction, const plane *p) {
  const real along = dot(p->normal, direction);
  real t;
  if (along == 0) return 0;
  t = -(dot(p->normal, origin) + p->d) / along;
  return t > 0 ? t : 0;
}

/* Whether something lies between a point and the light that is at point + to_light. */
static int blocked(vec point, vec to_light) {
  const real square = dot(to_light, to_light);
  uint16_t i;
  for (i = 0; i < SCENE.sphere_count; i++) {
    const real t = hit_sphere(point, to_light, square, &SCENE.spheres[i]);
    if (t > 0 && t < 1) return 1;
  }
  for (i = 0; i < SCENE.plane_count; i++) {
    const real t = hit_plane(point, to_light, &SCENE.planes[i]);
    if (t > 0 && t < 1) return 1;
  }
  return 0;
}

static uint32_t colour_of(vec rgb, real shade) {
  const real half = R(0.5);
  return pack((int)(rgb.x * shade * RED_MAX + half), (int)(rgb.y * shade * GREEN_MAX + half),
              (int)(rgb.z * shade * BLUE_MAX + half));
}

static void trace(vec direction, const strip *to, size_t at) {
  const real square = dot(direction, direction);
  const sphere *on_sphere = NULL;
  const plane *on_plane = NULL;
  real nearest = 0, shade = SCENE.ambient;
  vec point, normal, off, to_light;
  uint16_t i, material, object;
  int lit = 0;
  for (i = 0; i < SCENE.sphere_count; i++) {
    const real t = hit_sphere(SCENE.eye, direction, square, &SCENE.spheres[i]);
    if (t > 0 && (nearest == 0 || t < nearest)) {
      nearest = t;
      on_sphere = &SCENE.spheres[i];
    }
  }
  for (i = 0; i < SCENE.plane_count; i++) {
    const real t = hit_plane(SCENE.eye, direction, &SCENE.planes[i]);
    if (t > 0 && (nearest == 0 || t < nearest)) {
      nearest = t;
      on_plane = &SCENE.planes[i];
    }
  }
  if (nearest == 0 || nearest * nearest * square > SCENE.far_limit * SCENE.far_limit) {
    put_pixel(to, at, colour_of(SCENE.background, 1), 0, 0);
    return;
  }
  point = add(SCENE.eye, scale(direction, nearest));
  if (on_plane != NULL) {
    normal = dot(on_plane->normal, direction) > 0 ? scale(on_plane->normal, -1) : on_plane->normal;
    material = on_plane->material;
    object = on_plane->object;
  } else {
    normal = scale(sub(point, on_sphere->center), 1 / on_sphere->radius);
    material = on_sphere->material;
    object = on_sphere->object;
  }
  off = add(point, scale(normal, EPSILON));
  to_light = sub(SCENE.light, off);
  if (dot(normal, to_light) > 0 && !blocked(off, to_light)) {
    lit = 1;
    shade += SCENE.intensity * dot(normal, to_light) / SQRT(dot(to_light, to_light));
  }
  put_pixel(to, at, colour_of(SCENE.materials[material], shade), object, lit);
}

static real pixel_step; /* between neighbours, at distance 1 */

size_t renderer_prepare(void) { return sizeof pixel_step; }

int renderer_setup(void) {
  pixel_step = 2 * SCENE.tan_half_fov / (WIDTH < HEIGHT ? WIDTH : HEIGHT);
  return 0;
}

int renderer_rows(uint16_t y, uint16_t rows, const strip *to) {
  uint16_t row, x;
  for (row = 0; row < rows; row++) {
    const real up = (R(0.5) * (HEIGHT - 1) - (y + row)) * pixel_step;
    const vec ahead = add(SCENE.forward, scale(SCENE.up, up));
    for (x = 0; x < WIDTH; x++)
      trace(add(ahead, scale(SCENE.right, (x - R(0.5) * (WIDTH - 1)) * pixel_step)), to,
            (size_t)row * WIDTH + x);
  }
  return 0;
}
