/* Edges seen from the light, as forms over a tile: what the shadows of triangles and of whole meshes are made of. */
#ifndef FC_TRIANGLE_SHADOW_H
#define FC_TRIANGLE_SHADOW_H

#include "planar.h"

/*
 * Vertices and edges cut to 15 bits (-2^15 .. 2^15 - 1), off by less than 1 a component: N = A x E, within 2^31 - 2^15, is off by
 * less than 2^17 + 2; cut by 2^16 to 15 bits by less than 3.001. W, rounded to 14 bits, is off by less than 3/4 (w.error is
 * below 2^14). So N.W, below 3 2^29, is off by less than 3 (3.001 2^14 + 3/4 2^15 + 3) = 147515 + 73728.
 */
#define FC_GLANCE_ERROR 221300

/* What vertices relative to the light are cut by: `all` has the bits of their magnitudes. */
static inline uint8_t fc_glance_shift(uint32_t all) { return all >> 15 == 0 ? 0 : (uint8_t)(17 - fc_clz32(all)); }

/* N in 15 bits, of an edge between vertices relative to the light; false where the two are the same. */
static inline bool fc_glance_edge(const int32_t from[3], const int32_t to[3], uint8_t shift, int32_t n[3]) {
  int32_t v[3], e[3];
  uint32_t all = 0;
  uint8_t j, cut;
  for (j = 0; j < 3; j++) {
    e[j] = to[j] - from[j]; /* vertices within 2^30 */
    all |= fc_abs32(e[j]);
    v[j] = fc_floor_shift32(from[j], shift);
  }
  if (all == 0) return false;
  cut = fc_clz32(all);
  if (cut < 17) {
    cut = (uint8_t)(17 - cut);
    e[0] = fc_floor_shift32(e[0], cut);
    e[1] = fc_floor_shift32(e[1], cut);
    e[2] = fc_floor_shift32(e[2], cut);
  } else {
    for (j = 0; j < 3; j++) e[j] *= INT32_C(1) << (cut - 17);
  }
  n[0] = fc_floor_shift32(v[1] * e[2] - v[2] * e[1], 16);
  n[1] = fc_floor_shift32(v[2] * e[0] - v[0] * e[2], 16);
  n[2] = fc_floor_shift32(v[0] * e[1] - v[1] * e[0], 16);
  return true;
}

/* An edge over a tile: outside for certain below 0, inside for certain from `certain` on. */
typedef struct fc_shadow_edge {
  int32_t at, dx, dy, certain;
} fc_shadow_edge;

/* sign W.(A x B) over the tile; false when it is below 0 everywhere. Vertices relative to the light, below 2^31. */
bool fc_shadow_edge_find(const fc_scan *scan, const fc_planar *receiver, const int32_t a[3], const int32_t b[3], int8_t sign,
                         fc_shadow_edge *edge);

/* Whether a triangle seen from the light darkens nothing that the mask shows, at a glance; `hidden` as in fc_form. The receiver's
 * w.error is below 2^14. */
bool fc_shadow_is_clear(const fc_scan *scan, fc_planar *receiver, const int32_t a[3][3], int8_t hidden);

/* Darkens the masked pixels of a row between two columns. */
void fc_shadow_darken(fc_scan *scan, uint16_t row, int32_t first, int32_t last);

#endif
