/*
 * The rival "scan_float": fixcast's way of drawing in hardware floating point, for spheres and one plane. It separates
 * what the algorithm gains from what integers cost.
 *
 * In camera space a pixel's ray is d = (u, v, 1), v constant along a row. Everything along a row is then a polynomial in
 * u: the rows' spans of spheres, of the plane and of shadows on it are where quadratics are positive; inside a span
 * their values come by adding differences. A row is first resolved to (object, 1/z), then each pixel is shaded once.
 */
#include <math.h>

#include "pixel.h"
#include "scene.h"

enum {
  SPHERES_MAX = 512,
  CASTERS_MAX = 16384
};

/* A sphere in camera space. Along d its hits have t^2 d.d - 2 t d.c + k = 0. */
typedef struct ball {
  vec c;
  real radius, k, inverse_k, inverse_radius;
  vec from_light;            /* its centre seen from the light */
  real cone;                 /* |from_light|^2 - radius^2: what of (p - light) lies in the cone that the sphere shadows */
  real facing_0, distance_0; /* of its shading, see shade_sphere */
  int first_row, end_row;
  uint16_t first_caster, end_caster; /* in casters[]: spheres that may shadow this one */
} ball;

/* Pixels first..end-1 of a row. */
typedef struct span {
  int first, end;
} span;

static ball balls[SPHERES_MAX];
static uint16_t casters[CASTERS_MAX];
static vec light, ground; /* ground: the plane's normal in camera space, towards the eye */
static real ground_d, light_height, light_square, step, first_u;
static real row_w[WIDTH];
static uint16_t row_thing[WIDTH]; /* 0: background, 1: plane, 2 + i: sphere i */
static uint8_t row_dark[WIDTH];   /* shadows on the plane */

static vec sub(vec a, vec b) { return (vec){a.x - b.x, a.y - b.y, a.z - b.z}; }
static real dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vec to_camera(vec a) { return (vec){dot(SCENE.right, a), dot(SCENE.up, a), dot(SCENE.forward, a)}; }

size_t renderer_prepare(void) {
  if (SCENE.sphere_count > SPHERES_MAX || SCENE.plane_count != 1 || SCENE.face_count != 0) {
    bench_put("scan_float draws up to 512 spheres and one plane\n");
    return 0;
  }
  if (renderer_setup() != 0) return 0;
  return SCENE.sphere_count * sizeof(ball) + sizeof row_w + sizeof row_thing + sizeof row_dark;
}

/* The rows whose rays may meet the sphere: between the tangents of its shadow on the plane u = 0. */
static void find_rows(ball *b) {
  const real a = b->c.z * b->c.z - b->radius * b->radius, half = b->c.y * b->c.z;
  const real root = b->radius * sqrtf(b->c.y * b->c.y + a);
  const real first = R(0.5) * (HEIGHT - 1) - (half + root) / a / step;
  const real last = R(0.5) * (HEIGHT - 1) - (half - root) / a / step;
  b->first_row = first > 0 ? (int)first : 0;
  b->end_row = last < HEIGHT - 1 ? (int)last + 1 : HEIGHT;
}

/* Whether sphere `a` may shadow a point of `b`: whether somewhere between the light and b's centre, the way narrowed
 * by b's radius in proportion comes closer to a than a's radius. */
static int may_shadow(const ball *a, const ball *b) {
  const real square = dot(b->from_light, b->from_light) - b->radius * b->radius;
  const real half = dot(a->from_light, b->from_light) + a->radius * b->radius;
  real at = half / square;
  if (half <= 0) return 0;
  if (at > 1) at = 1;
  return (square * at - 2 * half) * at + a->cone <= 0;
}

int renderer_setup(void) {
  uint16_t i, j, used = 0;
  step = 2 * SCENE.tan_half_fov / (WIDTH < HEIGHT ? WIDTH : HEIGHT);
  first_u = R(-0.5) * (WIDTH - 1) * step;
  light = to_camera(sub(SCENE.light, SCENE.eye));
  light_square = dot(light, light);
  ground = to_camera(SCENE.planes[0].normal);
  ground_d = dot(SCENE.planes[0].normal, SCENE.eye) + SCENE.planes[0].d;
  if (ground_d < 0) {
    ground = (vec){-ground.x, -ground.y, -ground.z};
    ground_d = -ground_d;
  }
  light_height = dot(ground, light) + ground_d;
  for (i = 0; i < SCENE.sphere_count; i++) {
    ball *b = &balls[i];
    b->c = to_camera(sub(SCENE.spheres[i].center, SCENE.eye));
    b->radius = SCENE.spheres[i].radius;
    b->k = dot(b->c, b->c) - b->radius * b->radius;
    if (b->c.z <= b->radius || light_height <= 0 || dot(ground, b->c) + ground_d < b->radius * R(0.999)) {
      bench_put("scan_float needs spheres before the eye, and spheres and light on one side of the plane\n");
      return 1;
    }
    b->inverse_k = 1 / b->k;
    b->inverse_radius = 1 / b->radius;
    b->from_light = sub(b->c, light);
    b->cone = dot(b->from_light, b->from_light) - b->radius * b->radius;
    b->facing_0 = b->k - dot(b->c, light);
    b->distance_0 = light_square - b->k;
    find_rows(b);
  }
  for (i = 0; i < SCENE.sphere_count; i++) {
    balls[i].first_caster = used;
    for (j = 0; j < SCENE.sphere_count; j++)
      if (i != j && may_shadow(&balls[j], &balls[i])) {
        if (used == CASTERS_MAX) return 1;
        casters[used++] = j;
      }
    balls[i].end_caster = used;
  }
  return 0;
}

/* The first pixel at or beyond u, within 0..WIDTH. */
static int pixel_from(real u) {
  const real x = (u - first_u) * (1 / step);
  int at;
  if (!(x > 0)) return 0;
  if (x > WIDTH - 1) return WIDTH;
  at = (int)x;
  return at < x ? at + 1 : at;
}

/* Where a u^2 + 2 b u + c >= 0 and p + q u > 0: up to two spans, of which the empty ones are left out. */
static int positive(real a, real b, real c, real p, real q, span *out) {
  const real discriminant = b * b - a * c;
  span found[2] = {{0, WIDTH}, {WIDTH, WIDTH}}, side = {0, WIDTH};
  int i, count = 0;
  if (discriminant <= 0) {
    if (a < 0 || (a == 0 && c < 0)) return 0;
  } else {
    const real root = sqrtf(discriminant), sum = -(b < 0 ? b - root : b + root);
    real low = sum / a, high = c / sum;
    if (a == 0) { /* a straight line */
      low = b < 0 ? R(-1e30) : c / sum;
      high = b < 0 ? c / sum : R(1e30);
      a = -1;
    }
    if (low > high) {
      const real swap = low;
      low = high;
      high = swap;
    }
    if (a < 0) {
      found[0] = (span){pixel_from(low), pixel_from(high)};
    } else {
      found[0].end = pixel_from(low);
      found[1].first = pixel_from(high);
    }
  }
  if (q > 0)
    side.first = pixel_from(-p / q);
  else if (q < 0)
    side.end = pixel_from(-p / q);
  else if (p <= 0)
    return 0;
  for (i = 0; i < 2; i++) {
    if (found[i].first < side.first) found[i].first = side.first;
    if (found[i].end > side.end) found[i].end = side.end;
    if (found[i].first < found[i].end) out[count++] = found[i];
  }
  return count;
}

/* ---- who is seen ---- */

static void scan_sphere(uint16_t i, real v) {
  const ball *b = &balls[i];
  const real along = b->c.y * v + b->c.z;
  const real a = b->c.x * b->c.x - b->k, half = b->c.x * along, c = along * along - b->k * (1 + v * v);
  real u, value, slope, ray_c;
  span s;
  int x;
  if (positive(a, half, c, 1, 0, &s) == 0) return;
  u = first_u + s.first * step;
  value = (a * u + 2 * half) * u + c;
  slope = (2 * (a * u + half) + a * step) * step;
  ray_c = b->c.x * u + along;
  for (x = s.first; x < s.end; x++) {
    const real w = (ray_c + (value > 0 ? sqrtf(value) : 0)) * b->inverse_k;
    if (w > row_w[x]) {
      row_w[x] = w;
      row_thing[x] = (uint16_t)(2 + i);
    }
    value += slope;
    slope += 2 * a * step * step;
    ray_c += b->c.x * step;
  }
}

/* 1/z = w0 + w1 u where the far limit allows, |d| <= far w. */
static void scan_ground(real v, real w0, real w1) {
  const real far = SCENE.far_limit * SCENE.far_limit;
  span spans[2];
  int i, x;
  for (x = 0; x < WIDTH; x++) {
    row_w[x] = 0;
    row_thing[x] = 0;
  }
  for (i = positive(far * w1 * w1 - 1, far * w0 * w1, far * w0 * w0 - (1 + v * v), w0, w1, spans); i-- > 0;) {
    real w = w0 + w1 * (first_u + spans[i].first * step);
    for (x = spans[i].first; x < spans[i].end; x++) {
      row_w[x] = w;
      row_thing[x] = 1;
      w += w1 * step;
    }
  }
}

/* ---- what light they get ---- */

static uint32_t colour_of(const vec *rgb, real shade) {
  const real half = R(0.5);
  return pack((int)(rgb->x * shade * RED_MAX + half), (int)(rgb->y * shade * GREEN_MAX + half),
              (int)(rgb->z * shade * BLUE_MAX + half));
}

/* A point of the plane, d / w, lies in a sphere's shadow where (d - w light) lies in the cone from the light. */
static void darken(vec beam_0, vec beam_1) {
  const real square_0 = dot(beam_0, beam_0), square_01 = dot(beam_0, beam_1), square_1 = dot(beam_1, beam_1);
  uint16_t i;
  int x;
  for (x = 0; x < WIDTH; x++) row_dark[x] = 0;
  for (i = 0; i < SCENE.sphere_count; i++) {
    const ball *b = &balls[i];
    const real p = dot(beam_0, b->from_light), q = dot(beam_1, b->from_light);
    span spans[2];
    int n = positive(q * q - b->cone * square_1, p * q - b->cone * square_01, p * p - b->cone * square_0, p,
                     q, spans);
    while (n-- > 0)
      for (x = spans[n].first; x < spans[n].end; x++) row_dark[x] = 1;
  }
}

/* Pixels first..end-1 show the plane. Lambert's cosine is height w / |d - w light|. */
static void shade_ground(int first, int end, vec beam_0, vec beam_1, real w1, const strip *to, size_t at) {
  const plane *p = &SCENE.planes[0];
  const vec *rgb = &SCENE.materials[p->material];
  const uint32_t dark = colour_of(rgb, SCENE.ambient);
  const real u = first_u + first * step, a = dot(beam_1, beam_1), half = dot(beam_0, beam_1);
  const real scale = SCENE.intensity * light_height;
  real square = (a * u + 2 * half) * u + dot(beam_0, beam_0);
  real slope = (2 * (a * u + half) + a * step) * step, w = row_w[first];
  int x;
  for (x = first; x < end; x++) {
    if (row_dark[x])
      put_pixel(to, at + (size_t)x, dark, p->object, 0);
    else
      put_pixel(to, at + (size_t)x, colour_of(rgb, SCENE.ambient + scale * w / sqrtf(square)), p->object, 1);
    square += slope;
    slope += 2 * a * step * step;
    w += w1 * step;
  }
}

static int in_shadow(const ball *b, vec point) {
  const vec beam = sub(point, light);
  uint16_t i;
  for (i = b->first_caster; i < b->end_caster; i++) {
    const ball *other = &balls[casters[i]];
    const real along = dot(beam, other->from_light), square = dot(beam, beam);
    if (along > 0 && along < square && along * along >= square * other->cone) return 1;
  }
  return 0;
}

/* With q = t d.(light - c), the point's n.l |l| radius is q + facing_0 and |l|^2 is distance_0 - 2 q. */
static void shade_sphere(uint16_t i, int first, int end, real v, const strip *to, size_t at) {
  const ball *b = &balls[i];
  const uint16_t object = SCENE.spheres[i].object;
  const vec *rgb = &SCENE.materials[SCENE.spheres[i].material];
  const uint32_t dark = colour_of(rgb, SCENE.ambient);
  const real scale = SCENE.intensity * b->inverse_radius, across = -b->from_light.x * step;
  real u = first_u + first * step, g = -(b->from_light.x * u + b->from_light.y * v + b->from_light.z);
  int x;
  for (x = first; x < end; x++) {
    const real t = 1 / row_w[x], q = t * g, facing = q + b->facing_0;
    if (facing <= 0 || (b->first_caster != b->end_caster && in_shadow(b, (vec){t * u, t * v, t})))
      put_pixel(to, at + (size_t)x, dark, object, 0);
    else
      put_pixel(to, at + (size_t)x,
                colour_of(rgb, SCENE.ambient + scale * facing / sqrtf(b->distance_0 - 2 * q)), object, 1);
    g += across;
    u += step;
  }
}

static void shade_row(real v, vec beam_0, vec beam_1, real w1, const strip *to, size_t at) {
  const uint32_t background = colour_of(&SCENE.background, 1);
  int first = 0, end, x;
  while (first < WIDTH) {
    const uint16_t thing = row_thing[first];
    for (end = first + 1; end < WIDTH && row_thing[end] == thing;) end++;
    if (thing == 0)
      for (x = first; x < end; x++) put_pixel(to, at + (size_t)x, background, 0, 0);
    else if (thing == 1)
      shade_ground(first, end, beam_0, beam_1, w1, to, at);
    else
      shade_sphere((uint16_t)(thing - 2), first, end, v, to, at);
    first = end;
  }
}

int renderer_rows(uint16_t y, uint16_t rows, const strip *to) {
  uint16_t row, i;
  for (row = 0; row < rows; row++) {
    const real v = (R(0.5) * (HEIGHT - 1) - (y + row)) * step;
    const real w1 = -ground.x / ground_d, w0 = -(ground.y * v + ground.z) / ground_d;
    const vec beam_0 = {-w0 * light.x, v - w0 * light.y, 1 - w0 * light.z};
    const vec beam_1 = {1 - w1 * light.x, -w1 * light.y, -w1 * light.z};
    scan_ground(v, w0, w1);
    darken(beam_0, beam_1);
    for (i = 0; i < SCENE.sphere_count; i++)
      if (y + row >= balls[i].first_row && y + row < balls[i].end_row) scan_sphere(i, v);
    shade_row(v, beam_0, beam_1, w1, to, (size_t)row * WIDTH);
  }
  return 0;
}
