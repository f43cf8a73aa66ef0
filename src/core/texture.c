/* The layer of textures: a pattern laid over a surface by a mapping. */
#include "texture.h"

#include "fixcast/error.h"

static FC_COLD int check(const void *data) {
  fc_texture texture;
  fc_mapping mapping;
  fc_mapping_kind mapping_kind;
  fc_texture_kind pattern_kind;
  int error;
  if (data == NULL) return FC_ERR_MATERIAL;
  FC_READ(&texture, data, sizeof texture);
  if (texture.mapping == NULL || texture.pattern == NULL || texture.pattern_data == NULL || texture.modulate > 1) return FC_ERR_MATERIAL;
  FC_READ_ONE(&mapping, texture.mapping);
  if (mapping.kind == NULL || mapping.repeat_u < 1 || mapping.repeat_v < 1) return FC_ERR_MATERIAL;
  FC_READ_ONE(&mapping_kind, mapping.kind);
  error = mapping_kind.check(&mapping);
  if (error != FC_OK) return error;
  FC_READ_ONE(&pattern_kind, texture.pattern);
  return pattern_kind.check(texture.pattern_data);
}

static FC_COLD void surface(fc_shading *shading, const void *data) {
  fc_texture texture;
  fc_mapping mapping;
  fc_mapping_kind mapping_kind;
  fc_texture_kind pattern_kind;
  int64_t uv_q24[2];
  uint16_t colour[3];
  uint8_t i;
  FC_READ(&texture, data, sizeof texture);
  FC_READ_ONE(&mapping, texture.mapping);
  FC_READ_ONE(&mapping_kind, mapping.kind);
  FC_READ_ONE(&pattern_kind, texture.pattern);
  mapping_kind.locate(shading, &mapping, uv_q24);
  uv_q24[0] *= mapping.repeat_u; /* 50 + 8 bits */
  uv_q24[1] *= mapping.repeat_v;
  pattern_kind.colour(texture.pattern_data, uv_q24, colour);
  for (i = 0; i < 3; i++) {
    /* Q15 each: 16 + 16 bits */
    uint32_t mixed = colour[i];
    if (texture.modulate) mixed = (mixed * shading->diffuse[i] + (1u << 14)) >> 15;
    shading->diffuse[i] = mixed > UINT16_MAX ? UINT16_MAX : (uint16_t)mixed;
  }
}

const fc_layer_kind fc_layer_texture FC_ROM = {check, surface, NULL, NULL, &fc_coat_layer_texture};
