/* The pattern that is an image in at most 256 colours, a byte a texel. */
#include "texture_texels.h"

static FC_COLD int check(const void *data) {
  fc_palette_image palette;
  uint32_t i;
  FC_READ(&palette, data, sizeof palette);
  if (!is_image(&palette.image) || palette.colours == NULL || palette.image.format != FC_TEXEL_RGB888) return FC_ERR_MATERIAL;
  for (i = 0; i < (uint32_t)palette.image.width * palette.image.height; i++) { /* 24 bits */
    uint8_t index;
    FC_READ(&index, (const uint8_t *)palette.image.texels + i, 1);
    if (index >= palette.colour_count) return FC_ERR_INDEX;
  }
  return FC_OK;
}

static void read_texel(const void *data, const fc_image *image, uint32_t at, uint8_t bytes[3]) {
  fc_palette_image palette;
  uint8_t index;
  FC_READ(&palette, data, sizeof palette);
  FC_READ(&index, (const uint8_t *)image->texels + at, 1);
  FC_READ(bytes, palette.colours + 3 * (size_t)index, 3);
}

const fc_texture_kind fc_texture_palette FC_ROM = {check, colour};
