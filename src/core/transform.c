/* A view's transform of world points in 64 bits. */
#include "transform.h"

#include "i128.h"

FC_COLD bool fc_transform_find(const fc_view *view, fc_transform *to) {
  /* round((row . v 2^fine - row . eye) / 2^s) = floor((row . v + floor((2^(s-1) - row . eye) / 2^fine)) / 2^(s - fine)) */
  int32_t s = 30 + view->shift;
  uint8_t i;
  if (s < view->fine || s - view->fine > 62) return false;
  to->down = (uint8_t)(s - view->fine);
  for (i = 0; i < 3; i++) {
    int64_t row[3];
    fc_i128 c;
    row[0] = view->row[i][0];
    row[1] = view->row[i][1];
    row[2] = view->row[i][2];
    c = fc_i128_neg(fc_i128_dot(row, view->eye));
    if (s > 0) c = fc_i128_add(c, fc_i128_shift_left(fc_i128_from(1), (uint8_t)(s - 1)));
    c = fc_i128_floor_shift(c, view->fine);
    /* a unit row times a vector below 3 2^30: below 2^62 */
    if (fc_i128_bits(c) > 62) return false;
    to->constant[i] = fc_i128_to_i64(c);
  }
  return true;
}
