/* The pattern that is an image: nearest or between texels, tiled or clamped. */
#include "coat_texels.h"
#include "texture_texels.h"

static FC_COLD int check(const void *data) {
  fc_image image;
  FC_READ(&image, data, sizeof image);
  return is_image(&image) && image.format <= FC_TEXEL_GREY8 ? FC_OK : FC_ERR_MATERIAL;
}

static void read_texel(const void *data, const fc_image *image, uint32_t at, uint8_t bytes[3]) {
  uint16_t packed;
  (void)data;
  switch (image->format) {
    case FC_TEXEL_RGB565:
      FC_READ(&packed, (const uint16_t *)image->texels + at, sizeof packed);
      /* 31 and 63 levels as 255: rounded */
      bytes[0] = (uint8_t)(((uint32_t)(packed >> 11) * 255 + 15) / 31);
      bytes[1] = (uint8_t)(((uint32_t)(packed >> 5 & 63) * 255 + 31) / 63);
      bytes[2] = (uint8_t)(((uint32_t)(packed & 31) * 255 + 15) / 31);
      break;
    case FC_TEXEL_GREY8:
      FC_READ(bytes, (const uint8_t *)image->texels + at, 1);
      bytes[1] = bytes[2] = bytes[0];
      break;
    default: FC_READ(bytes, (const uint8_t *)image->texels + (size_t)3 * at, 3); break;
  }
}

/* RGB565 and grey. */
static FC_NOINLINE void short_texel(const fc_coat_texture *texture, uint32_t at, texel *to) {
  fc_image image;
  uint8_t bytes[3];
  image.texels = texture->texels;
  image.format = texture->format;
  read_texel(NULL, &image, at, bytes);
  to->rb = (uint32_t)bytes[0] << 16 | bytes[2];
  to->g = bytes[1];
}

FC_INLINE texel texel_at(const fc_coat_texture *texture, uint32_t at) {
  texel t;
  if (texture->format == FC_TEXEL_RGB888) {
    const uint8_t *from = texture->texels + 3 * at; /* 24 bits, three times */
#ifdef FC_ROM_FAR
    uint8_t bytes[3];
    FC_READ(bytes, from, 3);
    from = bytes;
#endif
    t.rb = (uint32_t)from[0] << 16 | from[2];
    t.g = from[1];
  } else {
    short_texel(texture, at, &t);
  }
  return t;
}

FC_INLINE bool is_flat(const fc_coat_texture *texture, const texel_square *at) {
  (void)texture;
  (void)at;
  return false; /* loads are all there is to save */
}

static FC_COLD void open_texels(const void *data, fc_coat_texture *texture) {
  fc_image image;
  FC_READ(&image, data, sizeof image);
  texture->texels = image.texels;
  texture->format = image.format;
}

const fc_texture_kind fc_texture_image FC_ROM = {check, colour, open_texels, put};
