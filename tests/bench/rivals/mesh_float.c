/* The rivals "float" and "double" for meshes: edge functions over each triangle's box, 1/z in a 16-bit buffer. */
#include "pixel.h"
#include "scene.h"

enum {
  VERTICES_MAX = 2200,
  MATERIALS_MAX = 4100
};

/* On the screen, in pixels, y downwards; w is 1/z. */
typedef struct corner {
  real x, y, w;
} corner;

static corner corners[VERTICES_MAX];
static uint32_t colours[MATERIALS_MAX];
static uint16_t depth[STRIP_ROWS * WIDTH];

static real dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

size_t renderer_prepare(void) {
  if (SCENE.vertex_count > VERTICES_MAX || SCENE.material_count > MATERIALS_MAX || SCENE.intensity != 0) {
    bench_put("mesh_float draws flat scenes of 2200 vertices\n");
    return 0;
  }
  return SCENE.vertex_count * sizeof(corner) + SCENE.material_count * sizeof(uint32_t);
}

static uint32_t colour_of(vec rgb) {
  const real half = R(0.5);
  return pack((int)(rgb.x * RED_MAX + half), (int)(rgb.y * GREEN_MAX + half), (int)(rgb.z * BLUE_MAX + half));
}

int renderer_setup(void) {
  const real focal = (WIDTH < HEIGHT ? WIDTH : HEIGHT) / (2 * SCENE.tan_half_fov);
  uint16_t i;
  for (i = 0; i < SCENE.vertex_count; i++) {
    const vec *v = &SCENE.vertices[i];
    const vec from = {v->x - SCENE.eye.x, v->y - SCENE.eye.y, v->z - SCENE.eye.z};
    const real w = 1 / dot(SCENE.forward, from);
    corners[i].x = R(0.5) * WIDTH + dot(SCENE.right, from) * w * focal;
    corners[i].y = R(0.5) * HEIGHT - dot(SCENE.up, from) * w * focal;
    corners[i].w = w;
  }
  for (i = 0; i < SCENE.material_count; i++)
    colours[i] = colour_of((vec){SCENE.materials[i].x * SCENE.ambient, SCENE.materials[i].y * SCENE.ambient,
                                 SCENE.materials[i].z * SCENE.ambient});
  return 0;
}

static real least(real a, real b, real c) { return a < b ? (a < c ? a : c) : b < c ? b
                                                                                   : c; }
static real most(real a, real b, real c) { return a > b ? (a > c ? a : c) : b > c ? b
                                                                                  : c; }

/* The first pixel whose centre is at or beyond `v`, within 0..end. */
static int first_centre(real v, int end) {
  int at;
  if (v <= R(0.5)) return 0;
  if (v >= end) return end;
  at = (int)(v + R(0.5));
  return at + R(0.5) < v ? at + 1 : at;
}

/* An edge's function at pixel centres: positive inside. On the edge itself, left and top edges count as inside. */
typedef struct edge {
  real dx, dy, value;
  int closed;
} edge;

static edge edge_of(const corner *a, const corner *b, real x, real y) {
  edge e;
  e.dx = b->y - a->y;
  e.dy = a->x - b->x;
  e.value = (x - a->x) * e.dx + (y - a->y) * e.dy;
  e.closed = e.dx > 0 || (e.dx == 0 && e.dy > 0);
  return e;
}

static int inside(const edge *e, real value) { return value > 0 || (value == 0 && e->closed); }

static void draw(const face *f, int top, int rows, const strip *to) {
  const corner *a = &corners[f->vertex[0]], *b = &corners[f->vertex[1]], *c = &corners[f->vertex[2]];
  const real low = least(a->y, b->y, c->y), high = most(a->y, b->y, c->y);
  real area, wx, wy, w;
  edge e[3];
  int x, y, x0, x1, y0, y1;
  if (high <= top || low >= top + rows) return;
  /* Anticlockwise with y up is positive here, as y runs down and the order of the corners is turned. */
  area = (c->x - a->x) * (b->y - a->y) - (b->x - a->x) * (c->y - a->y);
  if (area <= 0) return;
  x0 = first_centre(least(a->x, b->x, c->x), WIDTH);
  x1 = first_centre(most(a->x, b->x, c->x), WIDTH);
  y0 = first_centre(low - top, rows);
  y1 = first_centre(high - top, rows);
  if (x0 >= x1 || y0 >= y1) return;
  e[0] = edge_of(a, b, x0 + R(0.5), top + y0 + R(0.5));
  e[1] = edge_of(b, c, x0 + R(0.5), top + y0 + R(0.5));
  e[2] = edge_of(c, a, x0 + R(0.5), top + y0 + R(0.5));
  area = R(65535) / area; /* 1/z = 1 fills the buffer's 16 bits */
  wx = ((b->w - a->w) * e[2].dx + (c->w - a->w) * e[0].dx) * area;
  wy = ((b->w - a->w) * e[2].dy + (c->w - a->w) * e[0].dy) * area;
  w = a->w * R(65535) + wx * (x0 + R(0.5) - a->x) + wy * (top + y0 + R(0.5) - a->y);
  for (y = y0; y < y1; y++) {
    real e0 = e[0].value, e1 = e[1].value, e2 = e[2].value, z = w;
    for (x = x0; x < x1; x++) {
      if (inside(&e[0], e0) && inside(&e[1], e1) && inside(&e[2], e2)) {
        const size_t at = (size_t)y * WIDTH + (size_t)x;
        const uint16_t z16 = (uint16_t)(int32_t)z;
        if (z16 > depth[at]) {
          depth[at] = z16;
          put_pixel(to, at, colours[f->material], f->object, 0);
        }
      }
      e0 += e[0].dx;
      e1 += e[1].dx;
      e2 += e[2].dx;
      z += wx;
    }
    e[0].value += e[0].dy;
    e[1].value += e[1].dy;
    e[2].value += e[2].dy;
    w += wy;
  }
}

int renderer_rows(uint16_t y, uint16_t rows, const strip *to) {
  const uint32_t background = colour_of(SCENE.background);
  uint16_t i;
  size_t at;
  for (at = 0; at < (size_t)rows * WIDTH; at++) {
    depth[at] = 0;
    put_pixel(to, at, background, 0, 0);
  }
  for (i = 0; i < SCENE.face_count; i++) draw(&SCENE.faces[i], y, rows, to);
  return 0;
}
