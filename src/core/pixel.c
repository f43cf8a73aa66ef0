/* Pixel formats and rounding. */
#include "pixel.h"

#include "bits.h"
#include "fixcast/error.h"

FC_COLD int fc_format_bytes(int format) {
  switch (format) {
    case FC_RGB888: return 3;
    case FC_RGB565_BE:
    case FC_RGB565_LE: return 2;
    default: return FC_ERR_FORMAT;
  }
}

FC_COLD void fc_pixel_most(uint8_t format, uint8_t most[3]) {
  most[0] = most[2] = format == FC_RGB888 ? 255 : 31;
  most[1] = format == FC_RGB888 ? 255 : 63;
}

FC_COLD uint8_t fc_pixel_level(uint16_t reflectance_q15, uint8_t most, uint32_t light_q24) {
  /* 16 + 32 + 8 bits */
  uint64_t level = ((uint64_t)reflectance_q15 * light_q24 * most + (UINT64_C(1) << 38)) >> 39;
  return level > most ? most : (uint8_t)level;
}

void fc_pixel_put(uint8_t format, const uint8_t level[3], uint8_t *to) {
  uint16_t packed;
  if (format == FC_RGB888) {
    to[0] = level[0];
    to[1] = level[1];
    to[2] = level[2];
    return;
  }
  packed = (uint16_t)((uint16_t)(level[0] << 11) | (uint16_t)(level[1] << 5) | level[2]);
  to[format == FC_RGB565_BE ? 0 : 1] = (uint8_t)(packed >> 8);
  to[format == FC_RGB565_BE ? 1 : 0] = (uint8_t)(packed & 0xff);
}

FC_COLD void fc_pixel_background(const fc_scene *scene, uint8_t format, uint8_t *to) {
  const uint32_t full_q24 = UINT32_C(1) << 24;
  uint8_t most[3], level[3];
  fc_pixel_most(format, most);
  level[0] = fc_pixel_level(scene->background.r, most[0], full_q24);
  level[1] = fc_pixel_level(scene->background.g, most[1], full_q24);
  level[2] = fc_pixel_level(scene->background.b, most[2], full_q24);
  fc_pixel_put(format, level, to);
}
