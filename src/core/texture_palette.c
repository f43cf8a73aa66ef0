/* The pattern that is an image in at most 256 colours, a byte a texel. */
#include "coat_texels.h"
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

FC_INLINE texel texel_at(const fc_coat_texture *texture, uint32_t at) {
  const uint8_t *from = texture->texels + at;
  texel t;
#ifdef FC_ROM_FAR
  uint8_t bytes[3];
  FC_READ(bytes, from, 1);
  FC_READ(bytes, texture->colours + 3 * (size_t)bytes[0], 3);
  from = bytes;
#else
  from = texture->colours + 3 * (size_t)*from;
#endif
  t.rb = (uint32_t)from[0] << 16 | from[2];
  t.g = from[1];
  return t;
}

/* Few colours make areas of one. */
FC_INLINE bool is_flat(const fc_coat_texture *texture, const texel_square *at) {
#ifdef FC_ROM_FAR
  (void)texture;
  (void)at;
  return false;
#else
  const uint8_t *texels = texture->texels;
  const uint8_t first = texels[at->a];
  return texels[at->d] == first && texels[at->b] == first && texels[at->c] == first;
#endif
}

static FC_COLD void open_texels(const void *data, fc_coat_texture *texture) {
  fc_palette_image palette;
  FC_READ(&palette, data, sizeof palette);
  texture->texels = palette.image.texels;
  texture->colours = palette.colours;
}

const fc_texture_kind fc_texture_palette FC_ROM = {check, colour, open_texels, put};
