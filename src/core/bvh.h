/* What the builder of hierarchies and their search share: cells, and how a box is counted in them. */
#ifndef FC_BVH_H
#define FC_BVH_H

#include "fixcast/bvh.h"
#include "space.h"

#define FC_BVH_CELLS INT64_C(65535) /* the highest cell border */

static inline uint32_t fc_bvh_leaves(const fc_bvh *bvh) { return UINT32_C(1) << bvh->depth; }

/* Where the share of part `index` of 2^level begins in the order: 16 + 16 bits. A node's share is its children's. */
static inline uint16_t fc_bvh_share(const fc_bvh *bvh, uint32_t index, uint8_t level) {
  return (uint16_t)((index * (uint32_t)bvh->count) >> level);
}

static inline uint16_t fc_bvh_low(uint32_t axis) { return (uint16_t)(axis & 0xffffu); }
static inline uint16_t fc_bvh_high(uint32_t axis) { return (uint16_t)(axis >> 16); }

/* The box of a primitive in world coordinates, below 2^31 each; false when it has none. */
static inline bool fc_bvh_bounds(const fc_cursor *at, uint16_t index, int64_t low[3], int64_t high[3]) {
  fc_form form;
  if (fc_kind_of(at)->bounds == NULL) return false;
  fc_kind_of(at)->fetch(&at->group, index, &form);
  fc_kind_of(at)->bounds(&form, low, high);
  return true;
}

/* Finite primitives of a scene. */
uint32_t fc_bvh_count(const fc_scene *scene);

#endif
