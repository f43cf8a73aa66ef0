/*
 * The simulator's reconstruction kernels against other definitions of them, integrated numerically in long double: mitchell as a third of the cubic
 * B-spline, by truncated powers, and two thirds of Catmull-Rom; gaussian as e to a power, divided by its own numeric integral.
 */
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "kernel.h"

namespace {

int failures = 0;

void near(const char *what, int n, long double expected, double got, long double within) {
  if (std::fabs(expected - static_cast<long double>(got)) <= within) return;
  std::printf("FAIL: %s, %d: expected %.18Lg, got %.18g\n", what, n, expected, got);
  failures++;
}

long double b_spline(long double x) {
  const long double choose[] = {1, -4, 6, -4, 1};
  long double sum = 0;
  for (int k = 0; k < 5; k++) {
    const long double at = std::max(0.0L, x + 2 - static_cast<long double>(k));
    sum += choose[k] * at * at * at;
  }
  return sum / 6;
}

long double catmull_rom(long double x) {
  x = std::fabs(x);
  return x < 1 ? (1.5L * x - 2.5L) * x * x + 1 : x < 2 ? ((-0.5L * x + 2.5L) * x - 4) * x + 2
                                                       : 0;
}

long double gauss(long double x) { return std::fabs(x) > 2 ? 0 : std::exp(-2 * x * x); }

/* Of a function that is smooth between whole numbers: Simpson's rule on 2^11 parts of each piece. */
long double integral(const std::function<long double(long double)> &f, long double from, long double to) {
  long double sum = 0;
  while (from < to) {
    const long double end = std::min(to, std::floor(from) + 1), step = (end - from) / 2048;
    for (int i = 0; i < 2048; i++) {
      /* just inside: at the cut a kernel has two values */
      const long double at = static_cast<long double>(i), a = from + step * (at + 1e-15L), b = from + step * (at + 1 - 1e-15L);
      sum += (f(a) + 4 * f((a + b) / 2) + f(b)) * step / 6;
    }
    from = end;
  }
  return sum;
}

void check_weights(host::Kernel kernel, const char *name, const std::function<long double(long double)> &f) {
  const long double total = integral(f, -2, 2);
  for (int n = 1; n <= 9; n++) {
    const std::vector<double> weights = host::cell_weights(kernel, n);
    const int count = static_cast<int>(weights.size()), before = (count - n) / 2; /* cells left of the pixel */
    long double sum = 0;
    for (int i = 0; i < count; i++) {
      const long double left = static_cast<long double>(i - before) / n - 0.5L, right = static_cast<long double>(i - before + 1) / n - 0.5L;
      near(name, n, integral(f, std::max(left, -2.0L), std::min(right, 2.0L)) / total, weights[static_cast<std::size_t>(i)], 1e-14L);
      const double mirrored = weights[static_cast<std::size_t>(count - 1 - i)];
      near("the mirror image", n, static_cast<long double>(mirrored), weights[static_cast<std::size_t>(i)], 0);
      sum += static_cast<long double>(weights[static_cast<std::size_t>(i)]);
    }
    near("all weights together", n, 1, static_cast<double>(sum), 1e-15L);
    if (static_cast<long double>(before) / n < 1.5L) near("the cells reach 2 pixels", n, 1.5L, static_cast<double>(before) / n, 0);
  }
}

/* What is uniform stays so to the edges; a single bright cell becomes the product of two weights, and none is lost or moved. */
void check_planes(host::Kernel kernel) {
  const int n = 3;
  const std::size_t width = 7, height = 6, columns = width * n, rows = height * n;
  const std::vector<double> flat = host::reconstruct(kernel, n, width, height, std::vector<double>(columns * rows, 0.625));
  for (double pixel : flat) near("a uniform plane", n, 0.625L, pixel, 1e-15L);
  const std::vector<double> weights = host::cell_weights(kernel, n);
  const int before = (static_cast<int>(weights.size()) - n) / 2;
  std::vector<double> spot(columns * rows, 0);
  const int at_x = 10, at_y = 8;
  spot[static_cast<std::size_t>(at_y) * columns + static_cast<std::size_t>(at_x)] = 1;
  const std::vector<double> pixels = host::reconstruct(kernel, n, width, height, spot);
  const auto weight = [&](int cell, int pixel) {
    const int k = cell - (pixel * n - before);
    return k < 0 || k >= static_cast<int>(weights.size()) ? 0.0L : static_cast<long double>(weights[static_cast<std::size_t>(k)]);
  };
  for (int y = 2; y + 2 < static_cast<int>(height); y++) /* where no edge is near */
    for (int x = 2; x + 2 < static_cast<int>(width); x++)
      near("a spot", y * 7 + x, weight(at_x, x) * weight(at_y, y), pixels[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)], 1e-16L);
}

} // namespace

int main() {
  const auto mitchell = [](long double x) { return b_spline(x) / 3 + 2 * catmull_rom(x) / 3; };
  check_weights(host::Kernel::mitchell, "mitchell", mitchell);
  check_weights(host::Kernel::gaussian, "gaussian", gauss);
  check_planes(host::Kernel::mitchell);
  check_planes(host::Kernel::gaussian);
  long double beyond = 0, within = 0;
  for (double w : host::cell_weights(host::Kernel::mitchell, 8)) (w < 0 ? beyond : within) += static_cast<long double>(w);
  near("mitchell's negative part", 8, 2 * integral(mitchell, 8.0L / 7, 2), static_cast<double>(beyond), 0.002L);
  if (failures == 0) std::puts("kernels: as integrated");
  return failures == 0 ? 0 : 1;
}
