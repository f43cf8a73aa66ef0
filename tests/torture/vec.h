/* Whole-number vectors and seeded random numbers of the torture tests. */
#ifndef TORTURE_VEC_H
#define TORTURE_VEC_H

#include <cstdint>
#include <cstdlib>

struct Vec {
  int64_t x, y, z;
  int64_t &operator[](int i) { return i == 0 ? x : i == 1 ? y
                                                          : z; }
  int64_t operator[](int i) const { return i == 0 ? x : i == 1 ? y
                                                               : z; }
};

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator-(Vec a) { return {-a.x, -a.y, -a.z}; }
inline Vec operator*(Vec a, int64_t k) { return {a.x * k, a.y * k, a.z * k}; }
inline bool operator==(Vec a, Vec b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
inline Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline int64_t dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline bool is_zero(Vec a) { return a.x == 0 && a.y == 0 && a.z == 0; }
inline int64_t largest(Vec a) {
  int64_t m = std::llabs(a.x);
  if (std::llabs(a.y) > m) m = std::llabs(a.y);
  if (std::llabs(a.z) > m) m = std::llabs(a.z);
  return m;
}

/* The core's range of coordinates. */
constexpr int64_t coordinate_max = 0x3fffffff;
inline bool fits(Vec a) { return largest(a) <= coordinate_max; }

/* splitmix64 (Steele, Lea, Flood 2014): a trial is its seed, nothing else. */
struct Random {
  uint64_t state;
  uint64_t next() {
    uint64_t z = (state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
  }
  /* low .. high inclusive */
  int64_t within(int64_t low, int64_t high) {
    return low + static_cast<int64_t>(next() % static_cast<uint64_t>(high - low + 1));
  }
  bool flip() { return (next() & 1) != 0; }
  /* Up to `bits` significant bits, any sign: small numbers come as often as large ones. */
  int64_t any_size(int bits) {
    int64_t most = (INT64_C(1) << within(1, bits)) - 1;
    return within(-most, most);
  }
  Vec vec(int bits) {
    Vec v;
    v.x = any_size(bits);
    v.y = any_size(bits);
    v.z = any_size(bits);
    return v;
  }
  /* The same, never 0. */
  Vec direction(int bits) {
    for (;;) {
      Vec v = vec(bits);
      if (!is_zero(v)) return v;
    }
  }
  Vec unit_step() {
    Vec v = {0, 0, 0};
    v[static_cast<int>(within(0, 2))] = flip() ? 1 : -1;
    return v;
  }
};

#endif
