/* The rival "q16": rays.c in Q16.16 with 64-bit products and quotients. */
#include "pixel.h"
#include "scene.h"

#define ONE 65536
#define EPSILON R(1.0 / 512)

static int32_t mul(int32_t a, int32_t b) { return (int32_t)((int64_t)a * b >> 16); }
static int32_t divide(int32_t a, int32_t b) { return (int32_t)((int64_t)a * ONE / b); }

static vec add(vec a, vec b) { return (vec){a.x + b.x, a.y + b.y, a.z + b.z}; }
static vec sub(vec a, vec b) { return (vec){a.x - b.x, a.y - b.y, a.z - b.z}; }
static vec scale(vec a, int32_t s) { return (vec){mul(a.x, s), mul(a.y, s), mul(a.z, s)}; }
static int64_t dot_q32(vec a, vec b) { return (int64_t)a.x * b.x + (int64_t)a.y * b.y + (int64_t)a.z * b.z; }
static int32_t dot(vec a, vec b) { return (int32_t)(dot_q32(a, b) >> 16); }

/* The root of a Q32 number as Q16. */
static int32_t root_of_q32(uint64_t square) {
  uint64_t root = 0, bit = UINT64_C(1) << 62;
  while (bit > square) bit >>= 2;
  for (; bit != 0; bit >>= 2) {
    if (square >= root + bit) {
      square -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
  }
  return (int32_t)root;
}

/* The smaller positive root times `square`, as Q16, or 0. */
static int32_t hit_sphere(vec origin, vec direction, int32_t square, const sphere *s) {
  const vec from = sub(origin, s->center);
  const int32_t b = dot(from, direction);
  const int32_t c = (int32_t)((dot_q32(from, from) - (int64_t)s->radius * s->radius) >> 16);
  const int64_t discriminant = (int64_t)b * b - (int64_t)square * c;
  int32_t root;
  if (discriminant < 0) return 0;
  root = root_of_q32((uint64_t)discriminant);
  if (-b - root > 0) return -b - root;
  return -b + root > 0 ? -b + root : 0;
}

/* t, at most `most`, or 0. */
static int32_t hit_plane(vec origin, vec direction, const plane *p, int32_t most) {
  const int32_t along = dot(p->normal, direction), away = dot(p->normal, origin) + p->d;
  int64_t t;
  if (along == 0) return 0;
  t = -(int64_t)away * ONE / along;
  return t > 0 && t <= most ? (int32_t)t : 0;
}

static int blocked(vec point, vec to_light) {
  const int32_t square = dot(to_light, to_light);
  uint16_t i;
  for (i = 0; i < SCENE.sphere_count; i++) {
    const int32_t t = hit_sphere(point, to_light, square, &SCENE.spheres[i]);
    if (t > 0 && t < square) return 1;
  }
  for (i = 0; i < SCENE.plane_count; i++)
    if (hit_plane(point, to_light, &SCENE.planes[i], ONE - 1) > 0) return 1;
  return 0;
}

static uint32_t colour_of(vec rgb, int32_t shade) {
  const int32_t half = ONE / 2;
  return pack((mul(rgb.x, shade) * RED_MAX + half) >> 16, (mul(rgb.y, shade) * GREEN_MAX + half) >> 16,
              (mul(rgb.z, shade) * BLUE_MAX + half) >> 16);
}

static void trace(vec direction, const strip *to, size_t at) {
  const int32_t square = dot(direction, direction);
  const sphere *on_sphere = NULL;
  const plane *on_plane = NULL;
  int32_t nearest = 0, shade = SCENE.ambient, facing;
  vec point, normal, off, to_light;
  uint16_t i, material, object;
  int lit = 0;
  for (i = 0; i < SCENE.sphere_count; i++) {
    const int32_t scaled = hit_sphere(SCENE.eye, direction, square, &SCENE.spheres[i]);
    if (scaled > 0) {
      const int32_t t = divide(scaled, square);
      if (nearest == 0 || t < nearest) {
        nearest = t;
        on_sphere = &SCENE.spheres[i];
      }
    }
  }
  for (i = 0; i < SCENE.plane_count; i++) {
    const int32_t t = hit_plane(SCENE.eye, direction, &SCENE.planes[i], SCENE.far_limit);
    if (t > 0 && (nearest == 0 || t < nearest)) {
      nearest = t;
      on_plane = &SCENE.planes[i];
    }
  }
  if (nearest == 0 || mul(mul(nearest, nearest), square) > mul(SCENE.far_limit, SCENE.far_limit)) {
    put_pixel(to, at, colour_of(SCENE.background, ONE), 0, 0);
    return;
  }
  point = add(SCENE.eye, scale(direction, nearest));
  if (on_plane != NULL) {
    normal = dot(on_plane->normal, direction) > 0 ? scale(on_plane->normal, -ONE) : on_plane->normal;
    material = on_plane->material;
    object = on_plane->object;
  } else {
    normal = scale(sub(point, on_sphere->center), divide(ONE, on_sphere->radius));
    material = on_sphere->material;
    object = on_sphere->object;
  }
  off = add(point, scale(normal, EPSILON));
  to_light = sub(SCENE.light, off);
  facing = dot(normal, to_light);
  if (facing > 0 && !blocked(off, to_light)) {
    lit = 1;
    shade += mul(SCENE.intensity, divide(facing, root_of_q32((uint64_t)dot_q32(to_light, to_light))));
  }
  put_pixel(to, at, colour_of(SCENE.materials[material], shade), object, lit);
}

static int32_t half_step; /* half of the distance between neighbours, at distance 1; Q24 */

size_t renderer_prepare(void) { return sizeof half_step; }

int renderer_setup(void) {
  half_step = (int32_t)((int64_t)SCENE.tan_half_fov * 256 / (WIDTH < HEIGHT ? WIDTH : HEIGHT));
  return 0;
}

/* A whole number of half pixels, at distance 1. */
static int32_t across(int32_t half_pixels) {
  return (int32_t)(((int64_t)half_step * half_pixels + 128) >> 8);
}

int renderer_rows(uint16_t y, uint16_t rows, const strip *to) {
  uint16_t row, x;
  for (row = 0; row < rows; row++) {
    const vec ahead = add(SCENE.forward, scale(SCENE.up, across(HEIGHT - 1 - 2 * (y + row))));
    for (x = 0; x < WIDTH; x++)
      trace(add(ahead, scale(SCENE.right, across(2 * x + 1 - WIDTH))), to, (size_t)row * WIDTH + x);
  }
  return 0;
}
