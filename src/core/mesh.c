/* Projection of vertices, culling and bins: once a frame, so that strips only meet what they show. */
#include "mesh.h"

#include "num.h"
#include "scan.h"
#include "scan_kinds.h"
#include "view.h"

/* Screen coordinates kept in 16 bits while the bins are filled, in steps of 2: beyond the guard band, which bit 0 tells; not in front of
 * the eye. USED: a corner of some triangle in a bin. */
#define SIDE INT32_C(32766)
#define USED UINT32_C(0x10000)
#define BEHIND UINT32_C(0x80018001)

uint32_t fc_recip_q63(uint32_t m) {
  /* r = 2^31 / m16 for m16 = m / 2^16 rounded: within (1 + 2^-1) 2^-15 of 2^47 / m, 17 bits. The rest 2^47 - m r is below
   * 2^47 2^-14.4 < 2^33, a quarter of it below 2^31 and so known by its low word; a Newton step squares the error: 2^-28.8. */
  uint32_t m16 = (m >> 16) + (m >> 15 & 1), r, rest_high;
  int32_t quarter;
  if (m16 > 0xffff) m16 = 0xffff;
  r = fc_recip_q31(m16);
  quarter = fc_to_i32(0u - (m >> 2) * r - (((m & 3) * r + 3) >> 2));
  /* r 2^16 + r rest / 2^31 = r 2^16 + quarter (r 2^14) / 2^32 * 2^17 / 2^14 ... in units of 2^12 after the product */
  rest_high = (uint32_t)fc_floor_shift32(fc_smulhi32(quarter, r << 15), 12);
  if (r >> 16) { /* 2^16: 2^32 less what the rest takes off */
    return fc_to_i32(rest_high) < 0 ? rest_high : UINT32_MAX;
  }
  r <<= 16;
  if (fc_to_i32(rest_high) > 0 && r + rest_high < r) return UINT32_MAX;
  return r + rest_high;
}

uint32_t fc_mesh_memory(const fc_shapes *shapes) { return (fc_mesh_bytes(shapes) + 7) / 8 * 8; }

/* v as m / 2^down with m in 2^31 .. 2^32-1. */
static uint32_t split(fc_num v, int32_t *down) {
  *down = -(v.e + 31);
  return (uint32_t)(v.m >> 31);
}

static uint8_t bits16(uint16_t v) { return fc_bits64(v); }

/* How this frame projects. */
static FC_COLD void set_scales(const fc_frame *frame, fc_placed_mesh *mesh) {
  uint16_t longest = frame->width > frame->height ? frame->width : frame->height;
  uint8_t guard = bits16(longest); /* coordinates within 2^guard pixels of the centre */
  fc_num focal = fc_num_from_u64((uint64_t)frame->view.focal, -(int32_t)frame->view.pixel_shift - 1);
  int32_t focal_down, depth_down, shift;
  mesh->focal = split(focal, &focal_down);
  mesh->depth = split(fc_num_div(fc_num_from_u64(frame->depth_near, 0), focal), &depth_down);
  mesh->focal_down = (uint8_t)focal_down;
  mesh->depth_down = (int16_t)depth_down;
  /* x F / z = x mantissa 2^(exponent - focal_down - 31), and screen units are 2^-fraction: x 2^(exponent - shift) mantissa / 2^32 */
  mesh->fraction = (uint8_t)(30 - guard);
  shift = focal_down - 1 - mesh->fraction;
  if (focal_down < 0 || focal_down > 200 || shift < -60 || shift > 60) mesh->fraction = 0;
  mesh->shift = (int8_t)shift;
  mesh->band_shift = 0;
  while ((frame->height - 1) >> mesh->band_shift >= 32) mesh->band_shift++;
}

/* F / z as fc_placed_vertex wants it, z > 0. */
static uint32_t see(const fc_placed_mesh *mesh, uint32_t z) {
  uint8_t zeros = fc_clz32(z);                                    /* at least 2 */
  uint32_t m = fc_mulhi32(fc_recip_q63(z << zeros), mesh->focal); /* 2^62 / 2^32 and up */
  if (!(m >> 31)) {
    m <<= 1;
    zeros--;
  }
  if (m < UINT32_MAX - 8) m += 8;
  return ((m << 1) & ~UINT32_C(31)) | zeros;
}

/* A screen coordinate in 16 bits, 2^15 units as one; beyond the guard band, the side. */
static int32_t short_coordinate(const fc_placed_mesh *mesh, int32_t a, uint32_t mantissa, uint8_t exponent) {
  int8_t up = (int8_t)(exponent - mesh->shift);
  int32_t at = 0;
  bool within = up <= 30;
  if (up >= 0) {
    within = within && fc_abs32(a) >> (31 - up) == 0;
    if (within) a *= INT32_C(1) << up;
  } else {
    a = fc_floor_shift32(a, up < -31 ? 31 : (uint8_t)-up);
  }
  if (within) {
    at = fc_floor_shift32(fc_smulhi32(a, mantissa), 15);
    if (at > -SIDE && at < SIDE) return at;
  }
  return a < 0 ? -SIDE : SIDE;
}

/* The vertex on the screen, and short coordinates in place of `seen`: y, downwards, above x. */
static void see_shortly(const fc_placed_mesh *mesh, fc_placed_vertex *v) {
  uint32_t seen, mantissa;
  uint8_t exponent;
  int32_t x, y;
  if (v->p[2] <= 0) {
    v->seen = BEHIND;
    return;
  }
  seen = see(mesh, (uint32_t)v->p[2]);
  mantissa = fc_seen_mantissa(seen);
  exponent = fc_seen_exponent(seen);
  x = short_coordinate(mesh, v->p[0], mantissa, exponent);
  y = short_coordinate(mesh, -v->p[1], mantissa, exponent);
  v->seen = ((uint32_t)y & 0xfffeu) << 16 | ((uint32_t)x & 0xfffeu) | (x == SIDE || x == -SIDE || y == SIDE || y == -SIDE);
}

static int32_t short_x(uint32_t seen) { return 2 * fc_floor_shift32(fc_to_i32(seen << 16), 17); }
static int32_t short_y(uint32_t seen) { return 2 * fc_floor_shift32(fc_to_i32(seen), 17); }

static void see_fully(const fc_placed_mesh *mesh, fc_placed_vertex *v) {
  v->seen = (v->seen & (USED | 1)) == USED ? see(mesh, (uint32_t)v->p[2]) : 0;
}

/* What turns short coordinates into the pixels whose centres may lie between them. */
typedef struct lines {
  int32_t before, after, last; /* added to the least and the greatest; the last pixel */
} lines;

static lines lines_of(uint16_t size, uint8_t point) {
  /* a short coordinate is short by less than 2, and its pixel by less than 1; the centre of pixel i is (2 i + 1 - size) / 2 from the
   * middle */
  lines r;
  int32_t middle = ((int32_t)size - 1) * (INT32_C(1) << (point - 1));
  r.before = middle - 2 + (INT32_C(1) << point) - 1;
  r.after = middle + 4;
  r.last = size - 1;
  return r;
}

/* Least and greatest short coordinate to pixels; false when there are none. */
static inline bool pixels_of(const lines *line, uint8_t point, int32_t *low, int32_t *high) {
  *low = fc_floor_shift32(*low + line->before, point);
  *high = fc_floor_shift32(*high + line->after, point);
  if (*low < 0) *low = 0;
  if (*high > line->last) *high = line->last;
  return *low <= *high;
}

/* How short coordinates are read. */
typedef struct glance {
  lines x, y;
  uint8_t point;
} glance;

#define SORT(a, b, c, low, high) \
  do { \
    low = high = a; \
    if (b < low) low = b; \
    if (b > high) high = b; \
    if (c < low) low = c; \
    if (c > high) high = c; \
  } while (0)

/* Whether corners within the guard band say that the front is turned away. */
static FC_NOINLINE bool averted(uint32_t a, uint32_t b, uint32_t c) {
  /* In units of 2 a coordinate is short by little more than 1, so a difference is off by less than 2, and below 2^15. y runs down:
   * the front is clockwise. */
  const int32_t ax = fc_floor_shift32(fc_to_i32(a << 16), 17), ay = fc_floor_shift32(fc_to_i32(a), 17);
  const int32_t ux = fc_floor_shift32(fc_to_i32(b << 16), 17) - ax, uy = fc_floor_shift32(fc_to_i32(b), 17) - ay;
  const int32_t vx = fc_floor_shift32(fc_to_i32(c << 16), 17) - ax, vy = fc_floor_shift32(fc_to_i32(c), 17) - ay;
  /* two products below 2^30 */
  const int32_t area = ux * vy - vx * uy;
  return area > 0 && (uint32_t)area > 2 * (fc_abs32(ux) + fc_abs32(uy) + fc_abs32(vx) + fc_abs32(vy)) + 8;
}

/* Rows of a triangle that may be seen; false when it is not. */
static inline bool rows_of(const glance *g, uint32_t a, uint32_t b, uint32_t c, int32_t *top, int32_t *bottom) {
  int32_t ax = short_x(a), bx = short_x(b), cx = short_x(c), ay = short_y(a), by = short_y(b), cy = short_y(c);
  int32_t left, right;
  SORT(ay, by, cy, *top, *bottom);
  if (!pixels_of(&g->y, g->point, top, bottom)) return false;
  SORT(ax, bx, cx, left, right);
  return pixels_of(&g->x, g->point, &left, &right);
}

bool fc_triangle_casts(const fc_group *group, uint16_t index) {
  return fc_mesh_casts(group->memory, &group->shapes)[index / 8] >> (index % 8) & 1;
}

void fc_mesh_set_casts(const fc_frame *frame, const fc_shapes *shapes, void *memory) {
  const fc_placed_vertex *vertices = fc_mesh_vertices(memory);
  uint8_t *casts = (uint8_t *)memory + (fc_mesh_casts(memory, shapes) - (const uint8_t *)memory);
  uint16_t i;
  if (frame->light != FC_LIGHT_ONE) return;
  for (i = 0; i < shapes->count; i++) {
    bool may = true;
    if (i % 8 == 0) casts[i / 8] = 0;
    if (shapes->cull) {
      fc_triangle t;
      fc_read_triangle(shapes, i, &t);
      may = fc_triangle_turn(vertices[t.vertex[0]].p, vertices[t.vertex[1]].p, vertices[t.vertex[2]].p, frame->lights) <= 0;
    }
    if (may) casts[i / 8] = (uint8_t)(casts[i / 8] | 1u << (i % 8));
  }
}

void fc_mesh_project(const fc_frame *frame, const fc_shapes *shapes, void *memory) {
  fc_placed_mesh *mesh = memory;
  fc_placed_vertex *vertices = (fc_placed_vertex *)(void *)(mesh + 1);
  uint16_t *next = (uint16_t *)(void *)(vertices + shapes->vertex_count), i;
  uint8_t j;
  glance g = {{0, 0, 0}, {0, 0, 0}, 0};
  set_scales(frame, mesh);
  for (j = 0; j < FC_BINS; j++) mesh->head[j] = FC_BIN_END;
  g.point = (uint8_t)(mesh->fraction - 15);
  if (mesh->fraction != 0) {
    g.x = lines_of(frame->width, g.point);
    g.y = lines_of(frame->height, g.point);
  }
  for (i = 0; i < shapes->vertex_count; i++) {
    if (mesh->fraction != 0)
      see_shortly(mesh, &vertices[i]);
    else
      vertices[i].seen = BEHIND;
  }
  for (i = shapes->count; i-- > 0;) {
    fc_triangle t;
    int32_t top = 0, bottom = frame->height - 1;
    uint32_t a, b, c;
    uint8_t level = 0, shift = mesh->band_shift;
    uint16_t *head;
    bool odd;
    fc_read_triangle(shapes, i, &t);
    a = vertices[t.vertex[0]].seen;
    b = vertices[t.vertex[1]].seen;
    c = vertices[t.vertex[2]].seen;
    odd = ((a | b | c) & 1) != 0;
    if (!odd && shapes->cull && averted(a, b, c)) continue;
    if (odd && (a == BEHIND || b == BEHIND || c == BEHIND)) {
      if (vertices[t.vertex[0]].p[2] <= 0 && vertices[t.vertex[1]].p[2] <= 0 && vertices[t.vertex[2]].p[2] <= 0) continue;
    } else if (!rows_of(&g, a, b, c, &top, &bottom)) {
      continue;
    }
    while ((bottom - top) >> shift != 0) {
      shift++;
      level++;
    }
    vertices[t.vertex[0]].seen = a | USED;
    vertices[t.vertex[1]].seen = b | USED;
    vertices[t.vertex[2]].seen = c | USED;
    head = &mesh->head[fc_mesh_level(level) + (top >> shift)];
    next[i] = *head;
    *head = i;
  }
  for (i = 0; i < shapes->vertex_count; i++) see_fully(mesh, &vertices[i]);
}

void fc_triangle_project(const fc_frame *frame, const fc_shapes *shapes, void *memory) {
  fc_mesh_project(frame, shapes, memory);
  fc_mesh_set_casts(frame, shapes, memory);
}

void fc_bin_start(fc_bin_walk *walk, const fc_group *group, uint16_t y0, uint16_t y1) {
  walk->mesh = group->memory;
  walk->next = fc_mesh_next(walk->mesh, &group->shapes);
  walk->y0 = y0;
  walk->y1 = y1;
  walk->item = FC_BIN_END;
  walk->level = UINT8_MAX; /* before the first */
  walk->bin = 1;
  walk->last = 0;
}

uint16_t fc_bin_next(fc_bin_walk *walk) {
  if (walk->item != FC_BIN_END) walk->item = walk->next[walk->item];
  while (walk->item == FC_BIN_END) {
    if (walk->bin > walk->last) {
      uint8_t shift;
      uint16_t first;
      walk->level++;
      if (walk->level == FC_BIN_LEVELS) {
        walk->level--;
        return FC_BIN_END;
      }
      shift = (uint8_t)(walk->mesh->band_shift + walk->level);
      first = (uint16_t)(walk->y0 >> shift);
      if (first > 0) first--;
      walk->bin = (uint8_t)first;
      walk->last = (uint8_t)(walk->y1 >> shift);
    }
    walk->item = walk->mesh->head[fc_mesh_level(walk->level) + walk->bin++];
  }
  return walk->item;
}
