/*
 * A table of triangles in a frame's memory: placed vertices, how they are seen, and which rows each triangle touches.
 *
 * Filled by fc_triangle_place and fc_triangle_project; not changed while strips are drawn.
 */
#ifndef FC_MESH_H
#define FC_MESH_H

#include <stdint.h>

#include "kind.h"
#include "quick.h"

/* seen: F / z for the half focal length F in pixels, as (2^31 + mantissa bits 31..5 / 2) 2^(bits 4..0 - focal_down - 31), relative error
 * below 2^-27; 0 when the vertex is not in front of the eye, or too far to the side, or of no triangle in a bin. */
typedef struct fc_placed_vertex {
  int32_t p[3];
  uint32_t seen;
} fc_placed_vertex;

/* Rows are cut into at most 32 bands, the bands into pairs, and so on: 6 levels of bins. A triangle is kept in the
 * first level whose bins are as high as itself, in the bin of its first row: so it touches that bin and the next at most. */
#define FC_BIN_LEVELS 6
#define FC_BINS 63
#define FC_BIN_END UINT16_C(0xffff)

typedef struct fc_placed_mesh {
  uint32_t focal; /* F = focal / 2^focal_down */
  uint32_t depth; /* near / F = depth / 2^depth_down */
  int16_t depth_down;
  uint8_t focal_down;
  uint8_t fraction;   /* screen coordinates have this many bits after the point; 0: nothing is projected */
  int8_t shift;       /* x, y 2^(exponent of seen - shift) times seen's mantissa / 2^32: on the screen */
  uint8_t band_shift; /* rows of a band: 2^band_shift */
  uint16_t head[FC_BINS];
  uint16_t unused[2]; /* 144 bytes on every machine */
} fc_placed_mesh;

typedef char fc_placed_mesh_is_whole[sizeof(fc_placed_mesh) == 144 && sizeof(fc_placed_vertex) == 16 ? 1 : -1];

static inline const fc_placed_vertex *fc_mesh_vertices(const fc_placed_mesh *mesh) {
  return (const fc_placed_vertex *)(const void *)(mesh + 1);
}

static inline void fc_read_triangle(const fc_shapes *shapes, uint16_t index, fc_triangle *t) {
#ifdef FC_ROM_FAR
  FC_READ_ONE(t, (const fc_triangle *)shapes->items + index);
#else
  /* field by field: a copy of the whole is a call on chips that copy words only */
  const fc_triangle *from = (const fc_triangle *)shapes->items + index;
  t->vertex[0] = from->vertex[0];
  t->vertex[1] = from->vertex[1];
  t->vertex[2] = from->vertex[2];
  t->material = from->material;
  t->object = from->object;
#endif
}

/* The triangle where it lies, or a copy where that cannot be read in place. */
static inline const fc_triangle *fc_triangle_at(const fc_shapes *shapes, uint16_t index, fc_triangle *copy) {
#ifdef FC_ROM_FAR
  fc_read_triangle(shapes, index, copy);
  return copy;
#else
  (void)copy;
  return (const fc_triangle *)shapes->items + index;
#endif
}

static inline void fc_read_vertex(const fc_shapes *shapes, uint16_t index, fc_vec3 *v) {
#ifdef FC_ROM_FAR
  FC_READ_ONE(v, (const fc_vec3 *)shapes->vertices + index);
#else
  *v = ((const fc_vec3 *)shapes->vertices)[index];
#endif
}

/* The next triangle of the same bin. */
static inline const uint16_t *fc_mesh_next(const fc_placed_mesh *mesh, const fc_shapes *shapes) {
  return (const uint16_t *)(const void *)(fc_mesh_vertices(mesh) + shapes->vertex_count);
}

/* A bit a triangle: it may cast shadows. */
static inline const uint8_t *fc_mesh_casts(const fc_placed_mesh *mesh, const fc_shapes *shapes) {
  return (const uint8_t *)(const void *)(fc_mesh_next(mesh, shapes) + shapes->count);
}

/* Where those end; a convex mesh keeps its outline after them (outline.h). */
static inline uint32_t fc_mesh_bytes(const fc_shapes *shapes) {
  /* 16 + 5 bits at most */
  const uint32_t bytes = (uint32_t)sizeof(fc_placed_mesh) + shapes->vertex_count * (uint32_t)sizeof(fc_placed_vertex) +
                         shapes->count * (uint32_t)sizeof(uint16_t) + ((uint32_t)shapes->count + 7) / 8;
  return (bytes + 3) / 4 * 4;
}

static inline uint8_t fc_mesh_level(uint8_t level) { return (uint8_t)(64 - (64 >> level)); }

/* Mantissa and exponent of a vertex's `seen`. */
static inline uint32_t fc_seen_mantissa(uint32_t seen) { return UINT32_C(1) << 31 | (seen & ~UINT32_C(31)) >> 1; }
static inline uint8_t fc_seen_exponent(uint32_t seen) { return (uint8_t)(seen & 31); }

/* A coordinate p[0] or -p[1] of a vertex that is seen, on the screen, from its middle in 2^-fraction pixels: mantissa is that of `seen`, up
 * its exponent less `shift`; up 2^exponent that fits, as the mesh has made sure. Within FC_CORNER_ERROR. */
static inline int32_t fc_mesh_screen(int32_t a, int32_t up, uint32_t mantissa) {
  a = up >= 0 ? a * (INT32_C(1) << up) : fc_floor_shift32(a, up < -31 ? 31 : (uint8_t)-up);
  return fc_smulhi32(a, mantissa);
}

/* 2^63 / m for m in 2^31 .. 2^32-1, relative error below 2^-28.5, at most 2^32 - 1. */
uint32_t fc_recip_q63(uint32_t m);

uint32_t fc_mesh_memory(const fc_shapes *shapes);

/* Fills a placed mesh, all but the casting bits. */
void fc_mesh_project(const fc_frame *frame, const fc_shapes *shapes, void *memory);

/* Under an only light, who casts shadows: of a closed mesh, the triangles that turn away from the light, or may. */
void fc_mesh_set_casts(const fc_frame *frame, const fc_shapes *shapes, void *memory);

/* The strip's items in a table, bin by bin: start, then call until it says FC_BIN_END. */
typedef struct fc_bin_walk {
  const fc_placed_mesh *mesh;
  const uint16_t *next;
  uint16_t y0, y1, item;
  uint8_t level, bin, last;
} fc_bin_walk;

void fc_bin_start(fc_bin_walk *walk, const fc_group *group, uint16_t y0, uint16_t y1);
uint16_t fc_bin_next(fc_bin_walk *walk);

#endif
