/* What kinds of mapping and pattern can do. */
#ifndef FC_TEXTURE_H
#define FC_TEXTURE_H

#include "layer.h"

struct fc_mapping_kind {
  /* FC_OK or an error. */
  int (*check)(const fc_mapping *mapping);
  /* Texture coordinates of the point being shaded, in tiles, Q24, within +-2^50. */
  void (*locate)(const fc_shading *shading, const fc_mapping *mapping, int64_t uv_q24[2]);
};

struct fc_texture_kind {
  int (*check)(const void *data);
  /* The colour at (u, v), Q15. */
  void (*colour)(const void *data, const int64_t uv_q24[2], uint16_t colour[3]);
};

#endif
