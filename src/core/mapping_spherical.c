/* The mapping by longitude and latitude of the normal. */
#include "fixcast/error.h"
#include "segment.h"
#include "texture.h"

static FC_COLD int check(const fc_mapping *mapping) {
  (void)mapping; /* nothing of its own */
  return FC_OK;
}

/* atan(2^-i) in turns, Q32 (Volder 1959). */
static const uint32_t turn_q32[] FC_ROM = {536870912, 316933406, 167458907, 85004756, 42667331, 21354465, 10679838, 5340245,
                                           2670163, 1335087, 667544, 333772, 166886, 83443, 41722, 20861,
                                           10430, 5215, 2608, 1304, 652, 326, 163, 81};

/* The angle of (x, y), x >= 0, in turns, Q32, within 2^-23; *length becomes |(x, y)| times 1.6468. Components below 2^29. */
static FC_COLD int64_t angle_of(int32_t x, int32_t y, int32_t *length) {
  int64_t angle = 0;
  uint8_t i;
  for (i = 0; i < sizeof turn_q32 / sizeof turn_q32[0]; i++) {
    const int32_t dx = fc_floor_shift32(x, i), dy = fc_floor_shift32(y, i);
    uint32_t step;
    FC_READ_ONE(&step, turn_q32 + i);
    if (y > 0) {
      x += dy;
      y -= dx;
      angle += step;
    } else {
      x -= dy;
      y += dx;
      angle -= step;
    }
  }
  *length = x;
  return angle;
}

static FC_COLD void locate(const fc_shading *shading, const fc_mapping *mapping, int64_t uv_q24[2]) {
  const int64_t half = INT64_C(1) << 31;
  const fc_surface *surface = shading->surface;
  int64_t world[3], n[3], around;
  int32_t flat, unused;
  uint8_t i, j, bits;
  (void)mapping;
  (void)fc_shrink(surface->normal, n);
  for (i = 0; i < 3; i++) {
    /* Q30 columns times 30 bits: below 2^62 */
    world[i] = 0;
    for (j = 0; j < 3; j++) world[i] += shading->frame->view.row[j][i] * n[j];
  }
  /* as long as angle_of allows with its growth: 28 bits */
  bits = fc_vector_bits(world);
  for (i = 0; i < 3; i++)
    world[i] = bits > 28 ? fc_floor_shift64(world[i], (uint8_t)(bits - 28)) : world[i] * (INT64_C(1) << (28 - bits));
  /* u: from +z over +x; behind, half a turn away */
  around = angle_of((int32_t)fc_abs64(world[2]), (int32_t)world[0], &flat);
  if (world[2] < 0) around = half - around;
  uv_q24[0] = fc_floor_shift64(around, 8) & 0xffffff;
  /* v: from +y; the flat length is 1.6468 times too long: times 19898 / 2^15 */
  flat = (int32_t)fc_floor_shift64((int64_t)flat * 19898, 15);
  uv_q24[1] = (INT64_C(1) << 23) - fc_floor_shift64(angle_of(flat, (int32_t)world[1], &unused), 7);
}

const fc_mapping_kind fc_mapping_spherical FC_ROM = {check, locate, NULL};
