/* Depth codes: format choice, encoding with an exact tie break, decoding. */
#include "depth.h"

#include "bits.h"
#include "num.h"

FC_COLD void fc_depth_choose(fc_frame *frame, uint64_t near, uint64_t far) {
  uint8_t bits = frame->options.depth_exponent_bits;
  /* Something touches the eye's plane or has no end: sixteen octaves below the coordinates' range. */
  if (near == 0) near = ((far < (UINT64_C(1) << 30) ? far : (UINT64_C(1) << 30)) >> 16) + 1;
  if (near > UINT32_MAX) near = UINT32_MAX;
  /* The greatest codes stay free, so that fast forms need not saturate. Not by a power of two: rows of a level plane would
   * meet the boundaries of rounding exactly. */
  near -= near * 23 >> 16;
  frame->depth_near = (uint32_t)near;
  if (bits == 0) {
    /* codes run down to near / 2^(2^bits); the lowest is kept free, hence the small margin */
    uint64_t reach = far > UINT64_MAX / 2 ? UINT64_MAX : far + far / 512;
    bits = reach <= near << 4 ? 2 : reach <= near << 8 ? 3
                                                       : 4;
  }
  frame->depth_exponent_bits = bits;
}

/* The sign of near / z - odd 2^exponent. */
static FC_COLD int8_t compare_depth(fc_wide *w, const fc_frame *frame, const fc_root *root, uint32_t odd, int8_t exponent) {
  const fc_quick no_value = {0, 0};
  fc_num value = fc_root_value(root), near = fc_num_from_u64(frame->depth_near, 0);
  const fc_num half = fc_num_from_u64(odd, exponent);
  /* by 63-bit values, all within 2^-56, ... */
  fc_num_times_u64(&value, (uint64_t)frame->view.focal);
  fc_num_over(&near, &value);
  if (near.e == half.e && fc_abs64(fc_to_i64(near.m - half.m)) >> 10 != 0) {
    FC_TALLY(FC_DECIDE_DEPTH, false);
    return near.m > half.m ? 1 : -1;
  }
  /* ... and cleared of fractions: 32 + 29 bits against 18 + 30 */
  fc_wide_start(w);
  fc_wide_push64(w, (int64_t)frame->depth_near << -exponent);
  fc_wide_push64(w, -(int64_t)odd * frame->view.focal);
  fc_wide_push64(w, 0);
  return fc_root_sign(root, no_value, w, FC_DECIDE_DEPTH);
}

FC_COLD uint16_t fc_depth_code_in(fc_wide *w, const fc_frame *frame, const fc_root *root) {
  uint8_t e_bits = frame->depth_exponent_bits, m_bits = (uint8_t)(16 - e_bits);
  int32_t octaves = INT32_C(1) << e_bits, octave;
  fc_quick z = fc_quick_mul(fc_root_quick(root), fc_quick_from((uint64_t)frame->view.focal, 0));
  fc_quick v = fc_quick_mul(fc_quick_from(frame->depth_near, 0), fc_quick_recip(z));
  uint32_t mantissa = v.m >> (31 - m_bits), code;                        /* its highest bit included */
  int32_t over = fc_to_i32((v.m << (m_bits + 1)) - (UINT32_C(1) << 31)); /* the fraction of a step, less its half */
  int8_t up = over < 0 ? -1 : 1;
  octave = v.e + 31 + octaves; /* 1/2 <= v < 1 is the highest, octaves - 1 */
  if (octave >= octaves) return UINT16_MAX;
  if (octave < 0) return 1;
  code = ((uint32_t)octave << m_bits) + mantissa - (UINT32_C(1) << m_bits);
  /* v is within 2^-24, 2^8 units of its mantissa. Where it is just off a step, either step is rounded to the same code. */
  if (fc_abs32(over) >> (m_bits + 9) == 0)
    up = compare_depth(w, frame, root, 2 * mantissa + 1, (int8_t)(octave - octaves - m_bits - 1));
  else
    FC_TALLY(FC_DECIDE_DEPTH, false);
  if (up >= 0) code++;
  if (code == 0) return 1;
  return code > UINT16_MAX ? UINT16_MAX : (uint16_t)code;
}

FC_COLD uint16_t fc_depth_code(const fc_frame *frame, const fc_root *root) {
  fc_wide w;
  return fc_depth_code_in(&w, frame, root);
}

FC_COLD uint32_t fc_depth_z(const fc_frame *frame, uint16_t code, int *exponent) {
  uint8_t m_bits = (uint8_t)(16 - frame->depth_exponent_bits);
  int32_t octave = code >> m_bits, octaves = INT32_C(1) << frame->depth_exponent_bits;
  uint32_t mantissa = (UINT32_C(1) << m_bits) | (code & ((UINT32_C(1) << m_bits) - 1));
  fc_num z = fc_num_div(fc_num_from_u64(frame->depth_near, 0), fc_num_from_u64(mantissa, 0));
  z = fc_num_scale(z, octaves + m_bits - octave);
  *exponent = (int)(z.e + 31 + frame->view.shift - frame->view.fine);
  return (uint32_t)(z.m >> 31);
}
