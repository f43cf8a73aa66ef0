/* The numbers that rivals count in: float, double, and fixed point with 16 fraction bits as integer renderers use. */
#ifndef RIVALS_NUMBER_H
#define RIVALS_NUMBER_H

#include <cmath>
#include <cstdint>

#ifdef __SIZEOF_INT128__ /* not on chips of 32 bits */
/* Q47.16, products and quotients by way of 128 bits and cut off: what is lost is fraction bits, never the top. */
struct Fixed {
  int64_t v;
  Fixed() : v(0) {}
  explicit Fixed(double d) : v(static_cast<int64_t>(std::floor(d * 65536 + 0.5))) {}
};
inline Fixed raw(int64_t v) {
  Fixed r;
  r.v = v;
  return r;
}
inline int64_t cut(__int128 v) {
  const __int128 most = INT64_MAX;
  return static_cast<int64_t>(v > most ? most : v < -most ? -most
                                                          : v);
}
inline Fixed operator+(Fixed a, Fixed b) { return raw(a.v + b.v); }
inline Fixed operator-(Fixed a, Fixed b) { return raw(a.v - b.v); }
inline Fixed operator-(Fixed a) { return raw(-a.v); }
inline Fixed operator*(Fixed a, Fixed b) { return raw(cut(static_cast<__int128>(a.v) * b.v >> 16)); }
inline Fixed operator/(Fixed a, Fixed b) {
  return b.v == 0 ? raw(a.v < 0 ? -INT64_MAX : INT64_MAX)
                  : raw(cut((static_cast<__int128>(a.v) << 16) / b.v));
}
inline bool operator<(Fixed a, Fixed b) { return a.v < b.v; }
inline bool operator>(Fixed a, Fixed b) { return a.v > b.v; }
inline bool operator<=(Fixed a, Fixed b) { return a.v <= b.v; }
inline bool operator>=(Fixed a, Fixed b) { return a.v >= b.v; }

#endif

inline float root(float a) { return std::sqrt(a); }
inline double root(double a) { return std::sqrt(a); }
#ifdef __SIZEOF_INT128__
inline Fixed root(Fixed a) { /* floor(sqrt(v 2^16)), digit by digit */
  if (a.v <= 0) return raw(0);
  unsigned __int128 rest = static_cast<unsigned __int128>(a.v) << 16, r = 0;
  for (int s = 40; s >= 0; s--) {
    unsigned __int128 next = r | static_cast<unsigned __int128>(1) << s;
    if (next * next <= rest) r = next;
  }
  return raw(static_cast<int64_t>(r));
}
#endif

template <typename T>
struct Vector {
  T x, y, z;
  T operator[](int i) const { return i == 0 ? x : i == 1 ? y
                                                         : z; }
};
template <typename T>
Vector<T> operator+(Vector<T> a, Vector<T> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename T>
Vector<T> operator-(Vector<T> a, Vector<T> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename T>
Vector<T> operator*(Vector<T> a, T k) {
  return {a.x * k, a.y * k, a.z * k};
}
template <typename T>
T dot(Vector<T> a, Vector<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename T>
Vector<T> cross(Vector<T> a, Vector<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename T>
T magnitude(T a) {
  return a < T(0.0) ? -a : a;
}

#endif
