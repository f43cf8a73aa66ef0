/* Seeded random numbers for tests: the same on every machine; a failure is replayed by running the test again. */
#ifndef TEST_RANDOM_H
#define TEST_RANDOM_H

#include <stdint.h>

static uint64_t random_state = UINT64_C(0x9e3779b97f4a7c15);

/* xorshift64 (Marsaglia 2003) */
static inline uint64_t random_u64(void) {
  random_state ^= random_state << 13;
  random_state ^= random_state >> 7;
  random_state ^= random_state << 17;
  return random_state;
}

/* low .. high inclusive */
static inline int32_t random_within(int32_t low, int32_t high) {
  return (int32_t)(low + (int64_t)(random_u64() % ((uint64_t)((int64_t)high - low) + 1)));
}

/* Up to `bits` significant bits, any sign: small numbers come as often as large ones. */
static inline int32_t random_any_size(uint8_t bits) {
  int32_t most = (int32_t)((UINT32_C(1) << (1 + random_u64() % bits)) - 1);
  return random_within(-most, most);
}

#endif
