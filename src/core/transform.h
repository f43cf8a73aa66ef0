/* Many world points into camera space: fc_view_point in 64 bits, where the view allows it. */
#ifndef FC_TRANSFORM_H
#define FC_TRANSFORM_H

#include <stdbool.h>
#include <stdint.h>

#include "bits.h"
#include "fixcast/vec3.h"
#include "quick.h"
#include "view.h"

/* floor((row . v + constant) / 2^down) for each row of the view. */
typedef struct fc_transform {
  int64_t constant[3];
  uint8_t down;
} fc_transform;

/* False where 64 bits do not hold it. */
bool fc_transform_find(const fc_view *view, fc_transform *to);

/* What fc_view_point(view, v, 0, ...) gives for a world point whose place fits 32 bits. */
static inline void fc_transform_point(const fc_view *view, const fc_transform *t, const fc_vec3 *v, int32_t point[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    const int32_t *row = view->row[i];
    /* below 2^61 2^0.8, and the constant's 2^62 */
    const int64_t sum = fc_product(row[0], v->x) + fc_product(row[1], v->y) + fc_product(row[2], v->z) + t->constant[i];
    const uint32_t low = (uint32_t)(uint64_t)sum;
    if (t->down >= 32)
      point[i] = fc_floor_shift32(fc_high_word(sum), (uint8_t)(t->down - 32));
    else
      point[i] = t->down == 0 ? fc_to_i32(low) : fc_to_i32(low >> t->down | (uint32_t)fc_high_word(sum) << (32 - t->down));
  }
}

#endif
