/* The layer of light of a surface's own. */
#include "fixcast/error.h"
#include "layer.h"

static FC_COLD int check(const void *data) {
  fc_emission emission;
  if (data == NULL) return FC_ERR_MATERIAL;
  FC_READ(&emission, data, sizeof emission);
  return emission.exponent < 0 || emission.exponent > 7 ? FC_ERR_MATERIAL : FC_OK;
}

static FC_COLD void surface(fc_shading *shading, const void *data) {
  fc_emission emission;
  uint16_t own[3];
  uint8_t i;
  FC_READ(&emission, data, sizeof emission);
  fc_channels(&emission.light, own);
  /* 16 + 24 + 7 bits a layer */
  for (i = 0; i < 3; i++) shading->added[i] += (uint64_t)own[i] << (24 + emission.exponent);
}

const fc_layer_kind fc_layer_emission FC_ROM = {check, surface, NULL, NULL, NULL};
