/* Depth formats: encoding, decoding and the mistakes they make without an exact tie rule. */
#include "depth_format.h"

#include <algorithm>
#include <cmath>

namespace host {
namespace {

constexpr double largest_code = 65535;

/* A float without sign: values below 1, exponent_bits of exponent, hidden one. Code 0 is kept free. */
std::uint16_t encode_float(double v, int exponent_bits) {
  const int mantissa_bits = 16 - exponent_bits, octaves = 1 << exponent_bits;
  int exponent = 0;
  const double fraction = std::frexp(v, &exponent); /* 1/2 <= fraction < 1; v < 1 has exponent <= 0 */
  const int octave = exponent + octaves - 1;
  if (octave < 0) return 1;
  const double code =
      std::ldexp(octave, mantissa_bits) + std::floor(std::ldexp(2 * fraction - 1, mantissa_bits) + 0.5);
  return static_cast<std::uint16_t>(std::clamp(code, 1.0, largest_code));
}

double decode_float(std::uint16_t code, int exponent_bits) {
  const int mantissa_bits = 16 - exponent_bits, octaves = 1 << exponent_bits;
  const int octave = code >> mantissa_bits, mantissa = code & ((1 << mantissa_bits) - 1);
  return std::ldexp((1 << mantissa_bits) + mantissa, octave - octaves - mantissa_bits);
}

/* IEEE half precision for 0 <= v <= 1, subnormals included; its bits are in the order of the values. */
std::uint16_t encode_half(double v) {
  int exponent = 0;
  (void)std::frexp(v, &exponent);
  exponent = std::max(exponent - 1, -14);
  const double steps = std::nearbyint(std::ldexp(v, 10 - exponent)); /* of 2^(exponent-10) */
  return static_cast<std::uint16_t>(std::ldexp(exponent + 14, 10) + steps);
}

double decode_half(std::uint16_t code) {
  const int exponent = code >> 10, mantissa = code & 1023;
  return exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
}

} // namespace

const std::vector<NamedDepthFormat> &depth_formats() {
  static const std::vector<NamedDepthFormat> all = {
      /* clang-format off */
      {"e2m14", DepthFormat::e2m14},   {"e3m13", DepthFormat::e3m13},     {"e4m12", DepthFormat::e4m12},
      {"linear", DepthFormat::linear}, {"inverse", DepthFormat::inverse}, {"half", DepthFormat::half_float}};
  /* clang-format on */
  return all;
}

std::uint16_t depth_encode(DepthFormat format, double z, double near, double far) {
  z = std::clamp(z, near, far);
  switch (format) {
    case DepthFormat::e2m14: return encode_float(near / z, 2);
    case DepthFormat::e3m13: return encode_float(near / z, 3);
    case DepthFormat::e4m12: return encode_float(near / z, 4);
    case DepthFormat::linear:
      return static_cast<std::uint16_t>(std::floor(largest_code * (far - z) / (far - near) + 0.5));
    case DepthFormat::inverse:
      return static_cast<std::uint16_t>(
          std::floor(largest_code * (1 / z - 1 / far) / (1 / near - 1 / far) + 0.5));
    case DepthFormat::half_float: return encode_half(near / z);
  }
  return 0;
}

double depth_decode(DepthFormat format, std::uint16_t code, double near, double far) {
  switch (format) {
    case DepthFormat::e2m14: return near / decode_float(code, 2);
    case DepthFormat::e3m13: return near / decode_float(code, 3);
    case DepthFormat::e4m12: return near / decode_float(code, 4);
    case DepthFormat::linear: return far - code * (far - near) / largest_code;
    case DepthFormat::inverse: return 1 / (1 / far + code * (1 / near - 1 / far) / largest_code);
    case DepthFormat::half_float: return near / decode_half(code);
  }
  return 0;
}

WrongOrder wrong_order(const Oracle &oracle, int width, int height, DepthFormat format) {
  std::vector<std::vector<OracleSurface>> pixels;
  WrongOrder result;
  for (int y = 0; y < height; y++) {
    for (int x = 0; x < width; x++) {
      pixels.push_back(oracle.surfaces(x, y));
      for (const OracleSurface &s : pixels.back()) {
        if (result.near == 0 || s.depth < result.near) result.near = s.depth;
        result.far = std::max(result.far, s.depth);
      }
    }
  }
  if (result.far <= result.near) return result; /* one depth at the most: nothing to confuse */
  for (const std::vector<OracleSurface> &surfaces : pixels) {
    const OracleSurface *shown = nullptr, *nearest = nullptr;
    std::uint16_t kept = 0;
    for (const OracleSurface &s : surfaces) {
      const std::uint16_t code = depth_encode(format, s.depth, result.near, result.far);
      if (shown == nullptr || code > kept) {
        shown = &s;
        kept = code;
      }
      if (nearest == nullptr || s.depth < nearest->depth) nearest = &s;
    }
    if (shown != nullptr && shown->object != nearest->object) result.pixels++;
  }
  return result;
}

} // namespace host
