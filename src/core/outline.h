/*
 * The shadow of a convex mesh, as a whole: the cone from the light over its outline.
 *
 * Seen from a light outside, the averted faces of a convex mesh cover it once, and their border is a convex polygon. A line
 * from the light meets one of them iff it passes inside every edge of that polygon; so some thirty edges stand for hundreds of faces,
 * which then cast nothing on their own. A face that faces the light is not shadowed by its own mesh at all.
 *
 * Convex is what the mesh must be in camera space, after vertices are rounded: the author's margin (fc_shapes.cull) says whether it is.
 */
#ifndef FC_OUTLINE_H
#define FC_OUTLINE_H

#include "mesh.h"
#include "planar.h"

/* fc_shapes.cull from here on: closed and convex. */
#define FC_CONVEX 2

/* In the mesh's memory, followed by a number a vertex: those before and after it on the outline, xor; 0 off the outline. */
typedef struct fc_outline {
  int32_t low[3], high[3]; /* a box around the faces that face the light; none: low > high */
  uint16_t edge[2];        /* an edge of the outline, as an averted face runs along it */
  uint8_t known;           /* 0: the faces cast one by one */
  uint8_t clear;           /* nothing keeps the light from what faces it */
  uint8_t unused[2];
} fc_outline;

/* Bytes of it. */
size_t fc_outline_memory(const fc_shapes *shapes);

/* Finds a placed mesh's outline and clears its casting bits; false when faces have to cast one by one. */
bool fc_outline_find(const fc_frame *frame, const fc_shapes *shapes, void *memory);

/* Whether nothing shadows what of a table of triangles faces the light. */
bool fc_outline_is_clear(const fc_group *group);

/* fc_kind.cast, fc_kind.settle */
void fc_outline_cast(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_group *group);
void fc_outline_settle(const fc_frame *frame, const fc_group *group);

#endif
