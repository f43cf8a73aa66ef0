/* Rays through slabs. */
#include <stddef.h>

#include "bits.h"
#include "i128.h"
#include "volume.h"

FC_COLD void fc_span_start(fc_span *span) {
  span->enter = 0;
  span->enter_of = 1;
  span->leave = 1; /* 1 / 0: beyond all fractions in the order below */
  span->leave_of = 0;
}

/* a / b < c / d for b, d >= 0, not both 0: by products of up to 63 + 63 bits. */
static FC_COLD bool below(int64_t a, int64_t b, int64_t c, int64_t d) {
  return fc_i128_compare(fc_i128_mul(a, d), fc_i128_mul(c, b)) < 0;
}

FC_COLD bool fc_span_cut(fc_span *span, int64_t low, int64_t high, int64_t speed) {
  int64_t enter = low, leave = high;
  if (speed == 0) return low <= 0 && high >= 0; /* parallel: between the planes, or not */
  if (speed < 0) {
    speed = -speed;
    enter = -high;
    leave = -low;
  }
  if (below(span->enter, span->enter_of, enter, speed)) {
    span->enter = enter;
    span->enter_of = speed;
  }
  if (below(leave, speed, span->leave, span->leave_of)) {
    span->leave = leave;
    span->leave_of = speed;
  }
  return !below(span->leave, span->leave_of, span->enter, span->enter_of);
}

FC_COLD int fc_ray_aabb(const fc_vec3 *origin, const fc_vec3 *direction, const fc_aabb *box, fc_span *span) {
  int64_t o[3], d[3], low[3], high[3];
  fc_span inside;
  uint8_t i;
  int error = fc_volume_load(o, origin);
  if (error == FC_OK) error = fc_volume_load_direction(d, direction);
  if (error == FC_OK) error = fc_volume_load_box(low, high, box);
  if (error != FC_OK) return error;
  fc_span_start(&inside);
  for (i = 0; i < 3; i++)
    if (!fc_span_cut(&inside, low[i] - o[i], high[i] - o[i], d[i])) return 0; /* 31 bits */
  if (span != NULL) *span = inside;
  return 1;
}
