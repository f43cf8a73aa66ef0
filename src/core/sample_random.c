/* Random patterns: anywhere in the pixel, and anywhere in each of n x n cells. No state: a place is a hash of pixel, sample and seed. */
#include "bits.h"
#include "sample.h"

/* Every bit of the result depends on every bit of v: the finaliser of MurmurHash3 (Appleby 2011). */
static FC_COLD uint32_t mix(uint32_t v) {
  v ^= v >> 16;
  v *= UINT32_C(0x85ebca6b);
  v ^= v >> 13;
  v *= UINT32_C(0xc2b2ae35);
  return v ^ v >> 16;
}

/* Two random parts: the halves of one hash. */
static FC_COLD void place_random(const fc_sampling *how, uint16_t x, uint16_t y, uint16_t index, uint32_t part_q16[2]) {
  uint32_t hash = mix(how->seed + UINT32_C(0x9e3779b9)); /* so that seed 0 is not a fixed point */
  hash = mix(hash ^ ((uint32_t)y << 16 | x));
  hash = mix(hash + index);
  part_q16[0] = hash & 0xffffu;
  part_q16[1] = hash >> 16;
}

static FC_COLD void place_jittered(const fc_sampling *how, uint16_t x, uint16_t y, uint16_t index, uint32_t part_q16[2]) {
  const uint16_t n = how->count;
  place_random(how, x, y, index, part_q16);
  part_q16[0] = (((uint32_t)(index % n) << 16) + part_q16[0]) / n;
  part_q16[1] = (((uint32_t)(index / n) << 16) + part_q16[1]) / n;
}

static FC_COLD bool check_random(const fc_sampling *how) { return how->count >= 1 && how->count <= FC_SAMPLE_COUNT_MAX; }

static FC_COLD void strip_random(const fc_sampler *sampler, void *scratch) {
  (void)scratch;
  fc_sample_mean(sampler, sampler->how.count, place_random);
}

const fc_pattern fc_pattern_random FC_ROM = {check_random, NULL, strip_random};

static FC_COLD bool check_jittered(const fc_sampling *how) { return how->count >= 1 && how->count <= FC_SAMPLE_SIDE_MAX; }

static FC_COLD void strip_jittered(const fc_sampler *sampler, void *scratch) {
  (void)scratch;
  fc_sample_mean(sampler, (uint16_t)(sampler->how.count * sampler->how.count), place_jittered);
}

const fc_pattern fc_pattern_jittered FC_ROM = {check_jittered, NULL, strip_jittered};
