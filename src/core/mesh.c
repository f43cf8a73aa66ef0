/* Projection of vertices, culling and bins: once a frame, so that strips only meet what they show. */
#include "mesh.h"

#include "num.h"
#include "scan_kinds.h"
#include "view.h"

/* Screen coordinates kept in 16 bits while the bins are filled: y above x. */
#define UNKNOWN INT16_MIN

uint32_t fc_recip_q63(uint32_t m) {
  /* r = 2^31 / m16 for m16 = m / 2^16 rounded: within (1 + 2^-1) 2^-15 of 2^47 / m, 17 bits. The rest 2^47 - m r is below
   * 2^47 2^-14.4 < 2^33, a quarter of it below 2^31; a Newton step squares the error: 2^-28.8. */
  uint32_t m16 = (m >> 16) + (m >> 15 & 1), r, rest_high;
  uint64_t rest;
  int32_t quarter;
  if (m16 > 0xffff) m16 = 0xffff;
  r = fc_recip_q31(m16);
  rest = (UINT64_C(1) << 47) - fc_mul32(m, r);
  quarter = fc_to_i32((uint32_t)(rest >> 2));
  /* r 2^16 + r rest / 2^31 = r 2^16 + quarter (r 2^14) / 2^32 * 2^17 / 2^14 ... in units of 2^12 after the product */
  rest_high = (uint32_t)fc_floor_shift32(fc_smulhi32(quarter, r << 15), 12);
  if (r >> 16) { /* 2^16: 2^32 less what the rest takes off */
    return fc_to_i32(rest_high) < 0 ? rest_high : UINT32_MAX;
  }
  r <<= 16;
  if (fc_to_i32(rest_high) > 0 && r + rest_high < r) return UINT32_MAX;
  return r + rest_high;
}

size_t fc_mesh_memory(const fc_shapes *shapes) {
  size_t bytes = sizeof(fc_placed_mesh) + (size_t)shapes->vertex_count * sizeof(fc_placed_vertex) +
                 (size_t)shapes->count * sizeof(uint16_t);
  return (bytes + 7) / 8 * 8;
}

/* v as m / 2^down with m in 2^31 .. 2^32-1. */
static uint32_t split(fc_num v, int32_t *down) {
  *down = -(v.e + 31);
  return (uint32_t)(v.m >> 31);
}

static uint8_t bits16(uint16_t v) { return fc_bits64(v); }

/* How this frame projects. */
static void set_scales(const fc_frame *frame, fc_placed_mesh *mesh) {
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
  uint8_t zeros = fc_clz32(z); /* at least 2 */
  uint32_t m = fc_mulhi32(fc_recip_q63(z << zeros), mesh->focal); /* 2^62 / 2^32 and up */
  if (!(m >> 31)) {
    m <<= 1;
    zeros--;
  }
  if (m < UINT32_MAX - 8) m += 8;
  return ((m << 1) & ~UINT32_C(31)) | zeros;
}

/* A screen coordinate; false when it is beyond the guard band. */
static bool on_screen(const fc_placed_mesh *mesh, int32_t a, uint32_t seen, int32_t *at) {
  int8_t up = (int8_t)(fc_seen_exponent(seen) - mesh->shift);
  if (up > 30) return false;
  if (up >= 0) {
    if (fc_abs32(a) >> (31 - up) != 0) return false;
    a *= INT32_C(1) << up;
  } else {
    a = fc_floor_shift32(a, up < -31 ? 31 : (uint8_t)-up);
  }
  *at = fc_smulhi32(a, fc_seen_mantissa(seen));
  return fc_abs32(*at) < UINT32_C(1) << 30;
}

/* 16 bits of it; beyond the guard band, the side. */
static uint32_t short_form(bool within, int32_t at, int32_t a) {
  int32_t v = within ? fc_floor_shift32(at, 15) : a < 0 ? -INT16_MAX : INT16_MAX;
  return (uint32_t)v & 0xffffu;
}

/* Screen coordinates in place of `seen`, y downwards. */
static void see_shortly(const fc_placed_mesh *mesh, fc_placed_vertex *v) {
  uint32_t seen;
  int32_t x = 0, y = 0, down = -v->p[1];
  bool x_within, y_within;
  if (v->p[2] <= 0) {
    v->seen = (uint32_t)(uint16_t)UNKNOWN << 16;
    return;
  }
  seen = see(mesh, (uint32_t)v->p[2]);
  x_within = on_screen(mesh, v->p[0], seen, &x);
  y_within = on_screen(mesh, down, seen, &y);
  v->seen = short_form(y_within, y, down) << 16 | short_form(x_within, x, v->p[0]);
}

static void see_fully(const fc_placed_mesh *mesh, fc_placed_vertex *v) {
  int32_t unused;
  v->seen = 0;
  if (v->p[2] <= 0 || mesh->fraction == 0) return;
  v->seen = see(mesh, (uint32_t)v->p[2]);
  if (!on_screen(mesh, v->p[0], v->seen, &unused) || !on_screen(mesh, v->p[1], v->seen, &unused)) v->seen = 0;
}

static int32_t short_x(uint32_t seen) { return fc_floor_shift32(fc_to_i32(seen << 16), 16); }
static int32_t short_y(uint32_t seen) { return fc_floor_shift32(fc_to_i32(seen), 16); }

typedef struct range {
  int32_t low, high;
} range;

static range range_of(int32_t a, int32_t b, int32_t c) {
  range r;
  r.low = a < b ? a : b;
  r.high = a < b ? b : a;
  if (c < r.low) r.low = c;
  if (c > r.high) r.high = c;
  return r;
}

/* From short coordinates to the pixels whose centres may lie between, `size` of them from edge to edge; false when there are none. */
static bool pixels_of(const fc_placed_mesh *mesh, uint16_t size, range *r) {
  /* a short coordinate is off by less than 2; the centre of pixel i is at (2 i + 1 - size) / 2 */
  uint8_t point = (uint8_t)(mesh->fraction - 15);
  int32_t middle = ((int32_t)size - 1) * (INT32_C(1) << point) / 2, one = INT32_C(1) << point;
  int32_t low = fc_floor_shift32(r->low + middle - 2 + one - 1, point), high = fc_floor_shift32(r->high + middle + 3, point);
  if (r->low == -INT16_MAX || low < 0) low = 0;
  if (r->high == INT16_MAX || high > size - 1) high = size - 1;
  r->low = low;
  r->high = high;
  return low <= high;
}

/* Rows of a triangle that may be seen; false when it is not. */
static bool rows_of(const fc_frame *frame, const fc_placed_mesh *mesh, const fc_placed_vertex *const v[3], uint8_t cull, range *rows) {
  int32_t ax, ay, bx, by, cx, cy, area, slack;
  range x, y;
  ax = short_x(v[0]->seen);
  ay = short_y(v[0]->seen);
  bx = short_x(v[1]->seen);
  by = short_y(v[1]->seen);
  cx = short_x(v[2]->seen);
  cy = short_y(v[2]->seen);
  x = range_of(ax, bx, cx);
  y = range_of(ay, by, cy);
  rows->low = 0;
  rows->high = frame->height - 1;
  if (y.low == UNKNOWN || mesh->fraction == 0) return v[0]->p[2] > 0 || v[1]->p[2] > 0 || v[2]->p[2] > 0;
  if (cull && x.high - x.low < 0x4000 && y.high - y.low < 0x4000 && x.low > -INT16_MAX && y.low > -INT16_MAX && x.high < INT16_MAX &&
      y.high < INT16_MAX) {
    /* 14 + 14 bits, two products; each coordinate off by less than 2. y runs down: the front is clockwise */
    area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    slack = 8 * (x.high - x.low + y.high - y.low) + 32;
    if (area > slack) return false;
  }
  if (!pixels_of(mesh, frame->width, &x) || !pixels_of(mesh, frame->height, &y)) return false;
  *rows = y;
  return true;
}

void fc_triangle_project(const fc_frame *frame, const fc_shapes *shapes, void *memory) {
  fc_placed_mesh *mesh = memory;
  fc_placed_vertex *vertices = (fc_placed_vertex *)(void *)(mesh + 1);
  uint16_t *next = (uint16_t *)(void *)(vertices + shapes->vertex_count), i;
  uint8_t j;
  set_scales(frame, mesh);
  for (j = 0; j < FC_BINS; j++) mesh->head[j] = FC_BIN_END;
  if (mesh->fraction != 0)
    for (i = 0; i < shapes->vertex_count; i++) see_shortly(mesh, &vertices[i]);
  for (i = shapes->count; i > 0; i--) {
    const fc_placed_vertex *v[3];
    fc_triangle t;
    range rows;
    uint8_t level = 0, shift = mesh->band_shift;
    uint16_t *head;
    fc_read_triangle(shapes, (uint16_t)(i - 1), &t);
    for (j = 0; j < 3; j++) v[j] = &vertices[t.vertex[j]];
    if (!rows_of(frame, mesh, v, shapes->cull, &rows)) continue;
    while ((rows.high - rows.low) >> shift != 0) {
      shift++;
      level++;
    }
    head = &mesh->head[fc_mesh_level(level) + (rows.low >> shift)];
    next[i - 1] = *head;
    *head = (uint16_t)(i - 1);
  }
  for (i = 0; i < shapes->vertex_count; i++) see_fully(mesh, &vertices[i]);
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
