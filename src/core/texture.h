/* What kinds of mapping and pattern can do. */
#ifndef FC_TEXTURE_H
#define FC_TEXTURE_H

#include "coat.h"
#include "layer.h"

/* Coordinates on a plane: scale (m.D) / (n.D), in tiles, seen along D. Vectors below 2^62. */
typedef struct fc_mapping_forms {
  int64_t n[3], m[2][3];
  fc_quick scale[2];
} fc_mapping_forms;

struct fc_mapping_kind {
  /* FC_OK or an error. */
  int (*check)(const fc_mapping *mapping);
  /* Texture coordinates of the point being shaded, in tiles, Q24, within +-2^50. */
  void (*locate)(const fc_shading *shading, const fc_mapping *mapping, int64_t uv_q24[2]);
  /* The same on a plane, as forms over a tile; NULL where there are none, false where they do not hold. */
  bool (*forms)(const fc_coat *coat, const fc_mapping *mapping, fc_mapping_forms *forms);
};

struct fc_texture_kind {
  int (*check)(const void *data);
  /* The colour at (u, v), Q15. */
  void (*colour)(const void *data, const int64_t uv_q24[2], uint16_t colour[3]);
  /* Opens it for the scan engine, texels and colours; and colours a run. NULL: not an image, whose record begins with an fc_image. */
  void (*open)(const void *data, fc_coat_texture *texture);
  void (*put)(const fc_coat_texture *texture, const fc_coat_span *span);
};

#endif
