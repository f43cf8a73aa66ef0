/* Reconstruction kernels and their sums. */
#include "kernel.h"

#include <algorithm>
#include <cmath>

namespace host {
namespace {

/* A row of samples, `stride` apart, reduced to `count` values, `to_stride` apart. */
void reduce(const std::vector<double> &weights, int n, std::size_t count, const double *from, std::size_t stride, double *to, std::size_t to_stride) {
  const auto last = static_cast<std::ptrdiff_t>(count) * n;
  const auto reach = (static_cast<std::ptrdiff_t>(weights.size()) - n) / 2; /* cells beyond the pixel */
  for (std::size_t i = 0; i < count; i++) {
    const auto first = static_cast<std::ptrdiff_t>(i) * n - reach;
    double sum = 0, weight = 0;
    for (std::size_t k = 0; k < weights.size(); k++) {
      const auto at = first + static_cast<std::ptrdiff_t>(k);
      if (at < 0 || at >= last) continue;
      sum += weights[k] * from[static_cast<std::size_t>(at) * stride];
      weight += weights[k];
    }
    to[i * to_stride] = sum / weight;
  }
}

} // namespace

double kernel_integral(Kernel kernel, double x) {
  const double a = std::min(std::fabs(x), kernel_radius);
  double integral = 0;
  if (kernel == Kernel::gaussian)
    integral = std::erf(std::sqrt(2.0) * a) / std::erf(std::sqrt(2.0) * kernel_radius) / 2;
  else if (a <= 1) /* of (7 x^3 - 12 x^2 + 16/3) / 6 */
    integral = a * (7 * a * a * a - 16 * a * a + 64.0 / 3) / 24;
  else /* of (-7/3 x^3 + 12 x^2 - 20 x + 32/3) / 6, 1/2 at 2 */
    integral = (a * (-7 * a * a * a + 48 * a * a - 120 * a + 128) - 12) / 72;
  return x < 0 ? -integral : integral;
}

std::vector<double> cell_weights(Kernel kernel, int n) {
  const int reach = (3 * n + 1) / 2, count = n + 2 * reach;
  std::vector<double> weights;
  for (int i = 0; i < count; i++) {
    const double left = (2.0 * (i - reach) - n) / (2.0 * n), right = (2.0 * (i + 1 - reach) - n) / (2.0 * n); /* mirrored without a bit's difference */
    weights.push_back(kernel_integral(kernel, right) - kernel_integral(kernel, left));
  }
  return weights;
}

std::vector<double> reconstruct(Kernel kernel, int n, std::size_t width, std::size_t height, const std::vector<double> &samples) {
  const std::vector<double> weights = cell_weights(kernel, n);
  const std::size_t rows = height * static_cast<std::size_t>(n), columns = width * static_cast<std::size_t>(n);
  std::vector<double> across(width * rows), pixels(width * height);
  for (std::size_t y = 0; y < rows; y++) reduce(weights, n, width, &samples[y * columns], 1, &across[y * width], 1);
  for (std::size_t x = 0; x < width; x++) reduce(weights, n, height, &across[x], width, &pixels[x], width);
  return pixels;
}

} // namespace host
