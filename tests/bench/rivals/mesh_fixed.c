/* The rival "fixed" for meshes: corners in sixteenths of a pixel, integer edge functions over each triangle's box, 1/z in
 * a 32-bit buffer. */
#include "pixel.h"
#include "scene.h"

enum {
  VERTICES_MAX = 2200,
  MATERIALS_MAX = 4100,
  SUBPIXELS = 16
};

/* On the screen, in sixteenths of a pixel, y downwards; w is 2^30 / z. */
typedef struct corner {
  int32_t x, y, w;
} corner;

static corner corners[VERTICES_MAX];
static uint32_t colours[MATERIALS_MAX];
static int32_t depth[STRIP_ROWS * WIDTH];

static int32_t dot(vec a, vec b) {
  return (int32_t)(((int64_t)a.x * b.x + (int64_t)a.y * b.y + (int64_t)a.z * b.z) >> 16);
}

size_t renderer_prepare(void) {
  if (SCENE.vertex_count > VERTICES_MAX || SCENE.material_count > MATERIALS_MAX || SCENE.intensity != 0) {
    bench_put("mesh_fixed draws flat scenes of 2200 vertices\n");
    return 0;
  }
  /* Half of the buffer is what every renderer may have for depth. */
  return SCENE.vertex_count * sizeof(corner) + SCENE.material_count * sizeof(uint32_t) + sizeof depth / 2;
}

static int channel(int32_t value, int most) { return (value * most + 0x8000) >> 16; }

static uint32_t colour_of(vec rgb) {
  return pack(channel(rgb.x, RED_MAX), channel(rgb.y, GREEN_MAX), channel(rgb.z, BLUE_MAX));
}

int renderer_setup(void) {
  const int32_t size = WIDTH < HEIGHT ? WIDTH : HEIGHT;
  const int32_t focal =
      (int32_t)((int64_t)size * SUBPIXELS * 65536 / 2 / SCENE.tan_half_fov); /* in sixteenths */
  uint16_t i;
  for (i = 0; i < SCENE.vertex_count; i++) {
    const vec *v = &SCENE.vertices[i];
    const vec from = {v->x - SCENE.eye.x, v->y - SCENE.eye.y, v->z - SCENE.eye.z};
    const int32_t w = (int32_t)((INT64_C(1) << 46) / dot(SCENE.forward, from));
    const int64_t scale = (int64_t)w * focal >> 14; /* sixteenths a unit of x, Q16 */
    corners[i].x = SUBPIXELS / 2 * WIDTH +
                   (int32_t)(((int64_t)dot(SCENE.right, from) * scale + INT64_C(0x80000000)) >> 32);
    corners[i].y = SUBPIXELS / 2 * HEIGHT -
                   (int32_t)(((int64_t)dot(SCENE.up, from) * scale + INT64_C(0x80000000)) >> 32);
    corners[i].w = w;
  }
  for (i = 0; i < SCENE.material_count; i++) colours[i] = colour_of(SCENE.materials[i]);
  return 0;
}

static int32_t least(int32_t a, int32_t b, int32_t c) { return a < b ? (a < c ? a : c) : b < c ? b
                                                                                               : c; }
static int32_t most(int32_t a, int32_t b, int32_t c) { return a > b ? (a > c ? a : c) : b > c ? b
                                                                                              : c; }

/* The first pixel whose centre is at or beyond `v`, within 0..end. */
static int first_centre(int32_t v, int end) {
  const int32_t at = (v + SUBPIXELS / 2 - 1) >> 4;
  return at < 0 ? 0 : at > end ? end
                               : (int)at;
}

/* An edge's function at pixel centres, less 1 on edges that are not a triangle's left or top one: inside is >= 0. */
typedef struct edge {
  int32_t dx, dy, value;
} edge;

static edge edge_of(const corner *a, const corner *b, int32_t x, int32_t y) {
  edge e;
  e.dx = b->y - a->y;
  e.dy = a->x - b->x;
  e.value = (x - a->x) * e.dx + (y - a->y) * e.dy;
  if (!(e.dx > 0 || (e.dx == 0 && e.dy > 0))) e.value--;
  return e;
}

/* (p u + q v) / area, within 32 bits. */
static int32_t slope(int32_t p, int32_t u, int32_t q, int32_t v, int32_t area) {
  const int64_t s = ((int64_t)p * u + (int64_t)q * v) * SUBPIXELS / area;
  return s > INT32_MAX ? INT32_MAX : s < -INT32_MAX ? -INT32_MAX
                                                    : (int32_t)s;
}

static void draw(const face *f, int top, int rows, const strip *to) {
  const corner *a = &corners[f->vertex[0]], *b = &corners[f->vertex[1]], *c = &corners[f->vertex[2]];
  const int32_t low = least(a->y, b->y, c->y), high = most(a->y, b->y, c->y), above = top * SUBPIXELS;
  int32_t area, wx, wy, w, x_centre, y_centre;
  edge e[3];
  int x, y, x0, x1, y0, y1;
  if (high <= above || low >= above + rows * SUBPIXELS) return;
  /* Anticlockwise with y up is positive here, as y runs down and the order of the corners is turned. */
  area = (c->x - a->x) * (b->y - a->y) - (b->x - a->x) * (c->y - a->y);
  if (area <= 0) return;
  x0 = first_centre(least(a->x, b->x, c->x), WIDTH);
  x1 = first_centre(most(a->x, b->x, c->x), WIDTH);
  y0 = first_centre(low - above, rows);
  y1 = first_centre(high - above, rows);
  if (x0 >= x1 || y0 >= y1) return;
  x_centre = x0 * SUBPIXELS + SUBPIXELS / 2;
  y_centre = above + y0 * SUBPIXELS + SUBPIXELS / 2;
  e[0] = edge_of(a, b, x_centre, y_centre);
  e[1] = edge_of(b, c, x_centre, y_centre);
  e[2] = edge_of(c, a, x_centre, y_centre);
  wx = slope(b->w - a->w, e[2].dx, c->w - a->w, e[0].dx, area);
  wy = slope(b->w - a->w, e[2].dy, c->w - a->w, e[0].dy, area);
  w = (int32_t)(a->w + (((int64_t)wx * (x_centre - a->x) + (int64_t)wy * (y_centre - a->y)) >> 4));
  for (y = y0; y < y1; y++) {
    int32_t e0 = e[0].value, e1 = e[1].value, e2 = e[2].value, z = w;
    size_t at = (size_t)y * WIDTH + (size_t)x0;
    for (x = x0; x < x1; x++, at++) {
      if ((e0 | e1 | e2) >= 0 && z > depth[at]) {
        depth[at] = z;
        put_pixel(to, at, colours[f->material], f->object, 0);
      }
      e0 += e[0].dx * SUBPIXELS;
      e1 += e[1].dx * SUBPIXELS;
      e2 += e[2].dx * SUBPIXELS;
      z = (int32_t)((uint32_t)z + (uint32_t)wx);
    }
    e[0].value += e[0].dy * SUBPIXELS;
    e[1].value += e[1].dy * SUBPIXELS;
    e[2].value += e[2].dy * SUBPIXELS;
    w = (int32_t)((uint32_t)w + (uint32_t)wy);
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
