/* Sines of whole angles. */
#include "bits.h"
#include "fixcast/config.h"
#include "fixcast/rotation.h"

/* round(2^31 sin(i pi / 32)) */
static const uint32_t sines_q31[17] FC_ROM = {0, 210490206, 418953276, 623381598, 821806413, 1012316784,
                                              1193077991, 1362349204, 1518500250, 1660027308, 1785567396, 1893911494,
                                              1984016189, 2055013723, 2106220352, 2137142927, UINT32_C(1) << 31};

/* sin(u / 2^30 of a quarter turn), u 0..2^30. */
static FC_COLD int32_t quarter_wave(uint32_t u) {
  const uint8_t i = (uint8_t)((u + (UINT32_C(1) << 25)) >> 26); /* the nearest of the table */
  /* the rest in radians: 26 bits times round(2^31 pi / 2), 32 bits; |x| <= pi / 64 < 2^-4.3, Q35 */
  const int64_t d = (int64_t)u - ((int64_t)i << 26);
  const int64_t x = fc_floor_shift64(d * INT64_C(3373259426) + (INT64_C(1) << 25), 26);
  const int64_t x2 = fc_floor_shift64(x * x, 35); /* 62 bits; x^2 below 2^26.4 in Q35 */
  /* sin x = x - x w, w = x^2/6 (1 - x^2/20); cos x = 1 - h, h = x^2/2 (1 - x^2/12); what is left out is below 2^-35 */
  const int64_t w = (x2 - fc_floor_shift64(x2 * x2, 35) / 20) / 6;
  const int64_t h = (x2 - fc_floor_shift64(x2 * x2, 35) / 12) / 2;
  uint32_t s, c;
  int64_t change;
  FC_READ_ONE(&s, &sines_q31[i]);
  FC_READ_ONE(&c, &sines_q31[16 - i]);
  /* s cos x + c sin x = s + change: 31 + 31 bits and 31 + 26; Q66 to Q36 */
  change = fc_floor_shift64((int64_t)c * (x - fc_floor_shift64(x * w, 35)) - (int64_t)s * h, 30);
  return (int32_t)fc_floor_shift64(((int64_t)s << 5) + change + 32, 6);
}

FC_COLD int32_t fc_sin_q30(uint32_t angle_q32) {
  const uint32_t quarter = UINT32_C(1) << 30, u = angle_q32 & (quarter - 1);
  const int32_t s = quarter_wave(angle_q32 & quarter ? quarter - u : u);
  return angle_q32 >> 31 ? -s : s;
}
