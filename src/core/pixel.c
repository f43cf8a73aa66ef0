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

FC_COLD uint8_t fc_pixel_transfer(const fc_transfer *transfer_rom, uint32_t value, uint8_t scale, uint8_t most) {
  fc_transfer transfer;
  const uint32_t *table;
  uint8_t low = 0, high = most; /* the level is in low .. high */
  FC_READ_ONE(&transfer, transfer_rom);
  table = most == 31 ? transfer.level31 : most == 63 ? transfer.level63
                                                     : transfer.level255;
  while (low < high) {
    const uint8_t middle = (uint8_t)(low + (high - low + 1) / 2);
    uint32_t threshold;
    FC_READ_ONE(&threshold, table + middle - 1);
    /* 24 + 8 bits */
    if ((threshold * scale + 1) / 2 <= value)
      low = middle;
    else
      high = (uint8_t)(middle - 1);
  }
  return low;
}

FC_COLD uint8_t fc_pixel_level(const fc_transfer *transfer, uint64_t value_q39, uint8_t most) {
  uint64_t level;
  if (transfer != NULL) {
    const uint64_t value_q24 = value_q39 >> 15; /* floored: thresholds are whole */
    return fc_pixel_transfer(transfer, value_q24 > INT32_MAX ? (uint32_t)INT32_MAX : (uint32_t)value_q24, 2, most);
  }
  /* 48 + 8 bits */
  level = (value_q39 * most + (UINT64_C(1) << 38)) >> 39;
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
