/* The pattern that is an image: nearest or between texels, tiled or clamped. */
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

const fc_texture_kind fc_texture_image FC_ROM = {check, colour};
