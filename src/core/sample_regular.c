/* Regular patterns: the centre, and the centres of n x n cells. */
#include "bits.h"
#include "sample.h"

static bool check_one(const fc_sampling *how) {
  (void)how;
  return true;
}

static void place_one(const fc_sampling *how, uint16_t x, uint16_t y, uint16_t index, uint32_t part_q16[2]) {
  (void)how;
  (void)x;
  (void)y;
  (void)index;
  part_q16[0] = part_q16[1] = (uint32_t)FC_PLACE_HALF;
}

static FC_COLD void strip_one(const fc_sampler *sampler, void *scratch) {
  (void)scratch;
  fc_sample_mean(sampler, 1, place_one);
}

const fc_pattern fc_pattern_one FC_ROM = {check_one, NULL, strip_one};

static FC_COLD bool check(const fc_sampling *how) { return how->count >= 1 && how->count <= FC_SAMPLE_SIDE_MAX; }

static FC_COLD void place(const fc_sampling *how, uint16_t x, uint16_t y, uint16_t index, uint32_t part_q16[2]) {
  const uint16_t n = how->count;
  (void)x;
  (void)y;
  part_q16[0] = (2 * (uint32_t)(index % n) + 1) * (uint32_t)FC_PLACE_HALF / n;
  part_q16[1] = (2 * (uint32_t)(index / n) + 1) * (uint32_t)FC_PLACE_HALF / n;
}

static FC_COLD void strip(const fc_sampler *sampler, void *scratch) {
  (void)scratch;
  fc_sample_mean(sampler, (uint16_t)(sampler->how.count * sampler->how.count), place);
}

const fc_pattern fc_pattern_regular FC_ROM = {check, NULL, strip};
