/*
 * A bounding volume hierarchy over a scene's finite primitives (spheres and triangles): rays, shadow segments and the
 * search for occluders then visit few of them. Planes are infinite and always visited.
 *
 * It is made in world coordinates, so it does not depend on the camera: bake it as constants (`fixcast bake` does) or
 * build it once in the caller's memory. No answer and no picture changes by a bit; only the time does.
 * A scene that names none links none of it, and fc_bvh_build is linked only where it is called.
 */
#ifndef FIXCAST_BVH_H
#define FIXCAST_BVH_H

#include <stddef.h>
#include <stdint.h>

#include "fixcast/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A box in cells from fc_bvh.origin: for each axis the lowest cell border in the low half word, the highest in the
 * high one, both 0..65535. */
typedef struct fc_bvh_node {
  uint32_t axis[3];
} fc_bvh_node;

/* How it is searched. Opaque; the one below is all there is. */
typedef struct fc_bvh_kind fc_bvh_kind;
/* A balanced tree without links; the only kind there is. */
extern const fc_bvh_kind fc_bvh_balanced;

/*
 * A balanced binary tree without links (SPEC section 10): node i of 1 .. 2^(depth + 1) - 1 is nodes[i - 1] and has the
 * children 2 i and 2 i + 1; leaf j of the 2^depth leaves holds order[j count >> depth] up to, not including,
 * order[(j + 1) count >> depth].
 */
typedef struct fc_bvh {
  const fc_bvh_kind *kind;
  const fc_bvh_node *nodes; /* NULL when there are no finite primitives */
  const uint16_t *order;    /* primitive numbers */
  fc_vec3 origin;           /* world coordinates of cell border (0, 0, 0); any int32_t */
  uint16_t count;           /* finite primitives */
  uint8_t shift;            /* a cell is 2^shift world coordinates, 0..17 */
  uint8_t depth;            /* 0..15, 2^depth <= count */
} fc_bvh;

/* Bytes that fc_bvh_build needs for this scene (whose own bvh is ignored), 0 and an error through *error (may be NULL)
 * when the scene is refused. A scene without finite primitives needs none. */
size_t fc_bvh_memory(const fc_scene *scene, int *error);

/* Builds the hierarchy of a scene; put its address into the bvh field of the scene (a copy in RAM) afterwards. `memory`
 * is the caller's, aligned for uint32_t, at least fc_bvh_memory() bytes, and must live as long as the scene is used;
 * all but the first fc_bvh_bytes() of it may be used for something else when this returns. The same scene gives the
 * same bits on every machine. Time is O(n log n). Returns FC_OK or an error. */
int fc_bvh_build(fc_bvh *bvh, const fc_scene *scene, void *memory, size_t memory_bytes);

/* Bytes of a built hierarchy's nodes and order, in this order and without a gap. */
size_t fc_bvh_bytes(const fc_bvh *bvh);

#ifdef __cplusplus
}
#endif

#endif
