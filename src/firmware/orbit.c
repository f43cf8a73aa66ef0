#include "orbit.h"

#include "fixcast/config.h"

/* Sines of 0, 6, ... 90 degrees, Q15, rounded to nearest. */
static const uint16_t sines[16] FC_ROM = {0, 3425, 6813, 10126, 13328, 16384, 19261, 21926,
                                          24351, 26510, 28378, 29935, 31164, 32052, 32588, 32768};

static int32_t sine_q15(uint16_t step) {
  const uint8_t in_half = (uint8_t)(step % 30u);
  uint16_t value;
  FC_READ(&value, &sines[in_half <= 15 ? in_half : 30 - in_half], sizeof value);
  return step % FC_ORBIT_STEPS < 30 ? (int32_t)value : -(int32_t)value;
}

/* |value| below 2^62. */
static int32_t round_q15(int64_t value) {
  return value < 0 ? -(int32_t)((16384 - value) >> 15) : (int32_t)((value + 16384) >> 15);
}

static void turn(fc_vec3 *point, int32_t x, int32_t z, int32_t sine, int32_t cosine) {
  const int64_t from_x = (int64_t)point->x - x, from_z = (int64_t)point->z - z;
  point->x = x + round_q15(from_x * cosine + from_z * sine);
  point->z = z + round_q15(from_z * cosine - from_x * sine);
}

void fc_orbit(const fc_camera *start, int32_t x, int32_t z, uint16_t step, fc_camera *to) {
  const uint16_t within = (uint16_t)(step % FC_ORBIT_STEPS);
  const int32_t sine = sine_q15(within), cosine = sine_q15((uint16_t)(within + FC_ORBIT_STEPS / 4));
  FC_READ(to, start, sizeof *to);
  turn(&to->eye, x, z, sine, cosine);
  turn(&to->target, x, z, sine, cosine);
}
