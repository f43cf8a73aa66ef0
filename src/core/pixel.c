/* Pixel formats and rounding. */
#include "pixel.h"

#include "fixcast/error.h"

int fc_format_bytes(int format) {
  switch (format) {
    case FC_RGB888: return 3;
    case FC_RGB565_BE:
    case FC_RGB565_LE: return 2;
    default: return FC_ERR_FORMAT;
  }
}

uint8_t fc_pixel_level(uint16_t reflectance_q15, uint32_t light_q24) {
  /* 16 + 32 + 8 bits */
  uint64_t level = ((uint64_t)reflectance_q15 * light_q24 * 255u + (UINT64_C(1) << 38)) >> 39;
  return level > 255 ? 255 : (uint8_t)level;
}

/* round(v * max / 255): no halves occur, as 255 is odd */
static uint16_t narrow(uint8_t v, uint16_t max) { return (uint16_t)((v * max + 127u) / 255u); }

void fc_pixel_put(uint8_t format, const uint8_t rgb[3], uint8_t *to) {
  uint16_t packed;
  if (format == FC_RGB888) {
    to[0] = rgb[0];
    to[1] = rgb[1];
    to[2] = rgb[2];
    return;
  }
  packed = (uint16_t)((uint16_t)(narrow(rgb[0], 31) << 11) | (uint16_t)(narrow(rgb[1], 63) << 5) | narrow(rgb[2], 31));
  to[format == FC_RGB565_BE ? 0 : 1] = (uint8_t)(packed >> 8);
  to[format == FC_RGB565_BE ? 1 : 0] = (uint8_t)(packed & 0xff);
}
