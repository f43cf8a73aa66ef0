/* The pattern of squares in two colours. */
#include "fixcast/error.h"
#include "texture.h"

static FC_COLD int check(const void *data) {
  (void)data; /* any colours will do */
  return FC_OK;
}

static FC_COLD void colour(const void *data, const int64_t uv_q24[2], uint16_t to[3]) {
  fc_checker checker;
  uint64_t square = (uint64_t)fc_floor_shift64(uv_q24[0], 23) + (uint64_t)fc_floor_shift64(uv_q24[1], 23);
  FC_READ(&checker, data, sizeof checker);
  fc_channels(&checker.colour[square & 1], to);
}

const fc_texture_kind fc_texture_checker FC_ROM = {check, colour, NULL, NULL};
