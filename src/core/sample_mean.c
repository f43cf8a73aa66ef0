/* Patterns whose rays weigh alike: the mean of them, placed by the box or the tent. */
#include "bits.h"
#include "num.h"
#include "sample.h"

/* Where the tent's integral is part: from the pixel's own upper left corner, -32768 .. 98303. A tent over -1..1 has u = (1 + v)^2 / 2
 * below it up to v <= 0, hence v = sqrt(2 u) - 1; the other half is its mirror image. */
static FC_COLD int32_t tent(uint32_t part_q16) {
  const uint32_t half = UINT32_C(32768);
  int32_t v;
  /* 2 u in Q32 is below 2^33; its root is Q16 */
  if (part_q16 < half)
    v = (int32_t)fc_sqrt64((uint64_t)part_q16 << 17) - FC_PLACE_ONE;
  else
    v = FC_PLACE_ONE - (int32_t)fc_sqrt64((uint64_t)(2 * half - part_q16) << 17);
  return FC_PLACE_HALF + v;
}

FC_COLD void fc_sample_mean(const fc_sampler *sampler, uint16_t count, fc_place *place) {
  uint16_t x, row, i;
  uint8_t j;
  for (row = 0; row < sampler->rows; row++)
    for (x = 0; x < sampler->frame.width; x++) {
      uint64_t sum[3] = {0, 0, 0}; /* 2^48 times up to 2^12 */
      fc_seen seen, centre;
      int32_t at[2], middle[2];
      bool met = false;
      fc_sample_centre(sampler, x, row, middle);
      for (i = 0; i < count; i++) {
        uint32_t part[2];
        place(&sampler->how, x, (uint16_t)(sampler->y + row), i, part);
        for (j = 0; j < 2; j++)
          at[j] = middle[j] - FC_PLACE_HALF + (sampler->how.filter == FC_FILTER_TENT ? tent(part[j]) : (int32_t)part[j]);
        fc_sample_trace(sampler, at, &seen);
        for (j = 0; j < 3; j++) sum[j] += seen.radiance_q39[j];
        if (at[0] == middle[0] && at[1] == middle[1]) {
          centre = seen;
          met = true;
        }
      }
      for (j = 0; j < 3; j++) sum[j] = (sum[j] + count / 2) / count;
      fc_sample_put(sampler, x, row, sum, count, met ? &centre : NULL);
    }
}
