/*
 * Searching a space for the primitives that a ray, a segment or a light may meet on its way to a region.
 *
 * A search only leaves out what cannot matter; what it hands over still has to be asked exactly. Without a bounding
 * volume hierarchy it hands over everything.
 */
#ifndef FC_SEARCH_H
#define FC_SEARCH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fixcast/bvh.h"
#include "quick.h"
#include "space.h"

/* Everything on the way from a point to a region: the hull of the two. Coordinates of the space that is searched, below
 * 2^62, radius below 2^31; whatever is further out is searched without a hierarchy. */
typedef struct fc_reach {
  const int64_t *from; /* a light, or a ray's origin */
  const int64_t *to;   /* three coordinates a corner ... */
  uint8_t corners;     /* ... of the region's hull; 0: `to` is the direction of a ray */
  int64_t radius;      /* the region reaches this far beyond its corners, an axis */
  fc_quick limit;      /* rays: a visitor that sets it, and `limited`, is no longer asked about what lies beyond that t, within 2^-24 */
  bool limited;
} fc_reach;

/* Called with a primitive's table and its place there; true ends the search. */
typedef bool fc_visit(void *context, const fc_cursor *at, uint16_t index);

struct fc_bvh_kind {
  /* FC_OK, or an error when the hierarchy does not fit the scene. */
  int (*check)(const fc_scene *scene, const fc_bvh *bvh);
  /* Visits what may be met among the finite primitives; true when a visitor ended it. */
  bool (*search)(const fc_bvh *bvh, const fc_space *space, fc_reach *reach, fc_visit *visit, void *context);
  /* Sets the bits (fc_space.entered) of nodes with a primitive below them that may cast a shadow (fc_kind.casts), and clears all
   * others, in fc_search_marks bytes. */
  void (*mark)(const fc_bvh *bvh, const fc_space *space, uint8_t *bits);
};

/* Bytes of those bits for a scene that has been checked, a multiple of 8; 0 where each primitive casts, or without a hierarchy. */
size_t fc_search_marks(const fc_scene *scene);

/* Finds them for a space in which what casts is known. */
void fc_search_mark(const fc_space *space, uint8_t *bits);

/* Visits every primitive that may be met, each once, in any order; true when a visitor ended it. `reach` NULL: all. */
bool fc_space_search(const fc_space *space, fc_reach *reach, fc_visit *visit, void *context);

#endif
