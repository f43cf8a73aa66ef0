/*
 * Rows of FC_RGB888 pixels as FC_RGB565_BE ones by ordered dither, so that gradients show no bands.
 *
 * Each channel, m = 255, becomes n = 31 or 63 by the pixel's one B (bayer.h).
 */
#include "bayer.h"
#include "fixcast/display.h"
#include "fixcast/error.h"

/*
 * floor(most v / 255 + (2 B + 1) / 128) without a division. N = most v is at most 63 * 255; N = 255 q + r with r < 255 is 256 q + (r - q). Where
 * r >= q, N >> 8 is q and N + 1 + q is 256 q + r + 1; elsewhere N >> 8 is q - 1 and N + 1 + (q - 1) is 256 q + r: both 256 q and 0..255 more.
 * The remainder r times 128 is at most 32512, 127 * 255 is 32385.
 */
static uint8_t level(uint8_t v, uint8_t most, uint8_t missing) {
  const uint16_t n = (uint16_t)((uint16_t)most * v);
  const uint8_t floored = (uint8_t)((uint16_t)(n + 1u + (n >> 8)) >> 8);
  const uint16_t rest = (uint16_t)(n - floored * 255u);
  return (uint8_t)(floored + (rest * 128u >= missing * 255u));
}

int fc_display_dither565(uint16_t x, uint16_t y, uint16_t width, uint16_t rows, const void *from, size_t from_pitch_bytes, void *to,
                         size_t to_pitch_bytes) {
  const uint8_t *source = from;
  uint8_t *target = to;
  uint16_t row, i;
  if (from == NULL || to == NULL) return FC_ERR_NULL;
  if (width == 0 || rows == 0) return FC_ERR_AREA;
  if (from_pitch_bytes < (size_t)width * 3u || to_pitch_bytes < (size_t)width * 2u) return FC_ERR_AREA;
  for (row = 0; row < rows; row++) {
    const uint8_t *pixel = source;
    uint8_t *at = target, b[8];
    fc_bayer_row(b, x, (uint16_t)(y + row));
    for (i = 0; i < width; i++) {
      const uint8_t missing = fc_bayer_missing(b[i & 7u]);
      const uint8_t red = level(pixel[0], 31, missing), green = level(pixel[1], 63, missing), blue = level(pixel[2], 31, missing);
      pixel += 3;
      *at++ = (uint8_t)((red << 3) | (green >> 3));
      *at++ = (uint8_t)((green << 5) | blue);
    }
    source += from_pitch_bytes;
    target += to_pitch_bytes;
  }
  return FC_OK;
}
