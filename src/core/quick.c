/* Tables of the short reciprocals: the best constant of each cell. */
#include "quick.h"

/* 2^15 / sqrt(x) for x in [i, i + 1) / 256, i = 64 .. 255. */
const uint16_t fc_rsqrt_table[192] FC_ROM = {
    65283, 64783, 64294, 63816, 63348, 62891, 62443, 62005, 61576, 61155, 60743, 60340,
    59944, 59556, 59175, 58802, 58436, 58076, 57723, 57376, 57036, 56701, 56373, 56049,
    55732, 55420, 55113, 54811, 54513, 54221, 53933, 53650, 53372, 53097, 52827, 52561,
    52299, 52040, 51786, 51535, 51288, 51044, 50804, 50567, 50334, 50103, 49876, 49652,
    49431, 49212, 48997, 48785, 48575, 48368, 48163, 47961, 47762, 47565, 47370, 47178,
    46988, 46801, 46615, 46432, 46251, 46072, 45895, 45720, 45547, 45377, 45208, 45040,
    44875, 44712, 44550, 44390, 44232, 44075, 43920, 43767, 43615, 43465, 43316, 43169,
    43024, 42880, 42737, 42596, 42456, 42317, 42180, 42044, 41910, 41776, 41644, 41514,
    41384, 41256, 41129, 41003, 40878, 40754, 40632, 40510, 40390, 40270, 40152, 40035,
    39919, 39804, 39689, 39576, 39464, 39352, 39242, 39133, 39024, 38916, 38810, 38704,
    38599, 38495, 38391, 38289, 38187, 38086, 37986, 37887, 37788, 37690, 37593, 37497,
    37402, 37307, 37213, 37119, 37027, 36935, 36843, 36753, 36663, 36573, 36485, 36397,
    36309, 36223, 36136, 36051, 35966, 35882, 35798, 35715, 35632, 35550, 35469, 35388,
    35307, 35228, 35148, 35070, 34991, 34914, 34837, 34760, 34684, 34608, 34533, 34458,
    34384, 34311, 34237, 34165, 34092, 34020, 33949, 33878, 33808, 33737, 33668, 33599,
    33530, 33461, 33394, 33326, 33259, 33192, 33126, 33060, 32994, 32929, 32864, 32800};

/* 2^15 / x for x in [i, i + 1) / 256, i = 128 .. 255. */
const uint16_t fc_recip_table[128] FC_ROM = {
    65281, 64777, 64281, 63792, 63310, 62836, 62369, 61909, 61455, 61008, 60568, 60133,
    59705, 59283, 58867, 58457, 58053, 57654, 57260, 56872, 56489, 56111, 55738, 55370,
    55007, 54649, 54295, 53946, 53601, 53261, 52925, 52593, 52265, 51942, 51622, 51306,
    50995, 50686, 50382, 50081, 49784, 49490, 49200, 48913, 48630, 48349, 48072, 47798,
    47528, 47260, 46995, 46733, 46474, 46218, 45965, 45714, 45467, 45222, 44979, 44739,
    44502, 44267, 44035, 43805, 43577, 43352, 43129, 42908, 42690, 42474, 42260, 42048,
    41838, 41631, 41425, 41222, 41020, 40820, 40623, 40427, 40233, 40041, 39851, 39662,
    39476, 39291, 39108, 38926, 38746, 38568, 38392, 38217, 38044, 37872, 37702, 37533,
    37366, 37200, 37036, 36873, 36712, 36552, 36393, 36236, 36080, 35926, 35772, 35620,
    35470, 35320, 35172, 35026, 34880, 34735, 34592, 34450, 34309, 34169, 34031, 33893,
    33757, 33622, 33487, 33354, 33222, 33091, 32961, 32832};

#ifdef FC_SHORT_MULTIPLIER
int64_t fc_product(int32_t a, int32_t b) { return fc_smul32(a, b); }
#endif

FC_COLD uint64_t fc_packed_from(uint64_t v, int32_t e) {
  uint8_t s;
  if (v >> 32 == 0) { /* mostly */
    if (v == 0) return 0;
    s = fc_clz32((uint32_t)v);
    return fc_quick_pack((uint32_t)v << s, e - s);
  }
  s = fc_clz64(v);
  return fc_quick_pack((uint32_t)(v << s >> 32), e + 32 - s);
}

FC_COLD uint64_t fc_packed_mul(fc_quick a, fc_quick b) {
  fc_quick r;
  r.m = fc_mulhi32(a.m, b.m);
  r.e = (int16_t)(a.e + b.e + 32);
  if (!(r.m >> 31)) {
    /* at least 2^30 when neither is 0: the lost bit costs 2^-30 */
    r.m <<= 1;
    r.e--;
  }
  return fc_quick_pack(r.m, r.e);
}

FC_COLD uint64_t fc_packed_add(fc_quick a, fc_quick b) {
  if (fc_quick_less(a, b)) {
    fc_quick c = a;
    a = b;
    b = c;
  }
  if (b.m == 0 || a.e - b.e > 31) return fc_quick_pack(a.m, a.e);
  return fc_packed_from((uint64_t)a.m + (b.m >> (a.e - b.e)), a.e);
}

FC_COLD uint64_t fc_packed_recip(fc_quick a) {
  /* x = m / 2^32 in [1/2, 1): r = 2^31 / m16, Q15 of 1 / x, 2^-14; one more Newton step on 31 bits */
  fc_quick q;
  uint32_t r = fc_recip_q31(a.m >> 16) << 15; /* Q30 of 1 / x: up to 2^31 */
  uint32_t rest = fc_mulhi32(a.m, r);         /* Q30, 2^30 (1 +- 2^-14) */
  int32_t e = (int32_t)(UINT32_C(1) << 30) - (int32_t)rest;
  /* r (1 + e): |e| below 2^17, r >> 14 below 2^17 + 1: 34 bits, so e is cut to 14 */
  int32_t add = fc_floor_shift32((int32_t)(r >> 16) * fc_floor_shift32(e, 2), 12);
  r += (uint32_t)add;
  q.m = r;
  q.e = (int16_t)(-a.e - 62);
  while (!(q.m >> 31)) {
    q.m <<= 1;
    q.e--;
  }
  return fc_quick_pack(q.m, q.e);
}

FC_COLD uint64_t fc_packed_rsqrt(fc_quick a) {
  /* even exponents: x = m / 2^32 in [1/4, 1) */
  fc_quick q;
  uint32_t m = a.m, y, rest;
  int16_t e = (int16_t)(a.e + 32);
  int32_t left, add;
  if (e & 1) {
    m >>= 1;
    e++;
  }
  y = fc_rsqrt_q15(m);                                /* Q15, up to 2^16 */
  rest = fc_mulhi32(m, y >> 16 ? UINT32_MAX : y * y); /* x y^2, Q30 */
  left = (int32_t)(UINT32_C(1) << 30) - (int32_t)rest;
  /* y (1 + left / 2): |left| below 2^17 */
  y <<= 15; /* Q30 */
  add = fc_floor_shift32((int32_t)(y >> 16) * fc_floor_shift32(left, 2), 13);
  q.m = y + (uint32_t)add;
  q.e = (int16_t)(-30 - e / 2);
  while (!(q.m >> 31)) {
    q.m <<= 1;
    q.e--;
  }
  return fc_quick_pack(q.m, q.e);
}

FC_COLD int32_t fc_quick_to_int(fc_quick a, int16_t e) {
  int16_t down = (int16_t) - (a.e + e);
  if (a.m == 0 || down > 31) return 0;
  return down < 1 ? INT32_MAX : (int32_t)(a.m >> down);
}

FC_COLD int32_t fc_quick_times(fc_quick a, int64_t v, int16_t e) {
  int32_t r = fc_quick_to_int(fc_quick_mul(a, fc_quick_from(fc_abs64(v), 0)), e);
  return v < 0 ? -r : r;
}
