/*
 * 16-bit depth formats side by side: the core's floats of 1/z and the rivals that a teacher wants to compare.
 */
#ifndef FIXCAST_HOST_DEPTH_FORMAT_H
#define FIXCAST_HOST_DEPTH_FORMAT_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "oracle.h"

namespace host {

enum class DepthFormat {
  e2m14, /* float of near/z, 2 exponent bits */
  e3m13,
  e4m12,
  linear,    /* z between near and far in equal steps */
  inverse,   /* 1/z between 1/far and 1/near in equal steps: the usual z-buffer */
  half_float /* near/z as an IEEE half */
};

struct NamedDepthFormat {
  const char *name;
  DepthFormat format;
};
const std::vector<NamedDepthFormat> &depth_formats();

/* The code of depth z, larger is nearer, rounded to nearest; z beyond near and far saturates. */
std::uint16_t depth_encode(DepthFormat format, double z, double near, double far);
/* The depth a code stands for. */
double depth_decode(DepthFormat format, std::uint16_t code, double near, double far);

/* Pixels in which a z-buffer of this format, with no rule for equal codes but first come first kept, shows another
 * object than the nearest. near and far are taken from what the picture shows, as a careful author would set them. */
struct WrongOrder {
  std::size_t pixels = 0;
  double near = 0, far = 0;
};
WrongOrder wrong_order(const Oracle &oracle, int width, int height, DepthFormat format);

} // namespace host

#endif
