/*
 * Reconstruction kernels that reach beyond their pixel, and what they make of a fine grid of samples.
 *
 * x is the distance from the pixel's centre in pixels. Both kernels are cut at 2 pixels and integrate to 1; in two dimensions a kernel is the product
 * of one across and one down. A sample of a grid of N x N a pixel weighs what the kernel integrates to over its cell.
 */
#ifndef FIXCAST_HOST_KERNEL_H
#define FIXCAST_HOST_KERNEL_H

#include <cstddef>
#include <vector>

namespace host {

enum class Kernel {
  gaussian, /* exp(-2 x^2): a standard deviation of half a pixel; blurs, never rings */
  mitchell  /* the cubic of Mitchell and Netravali 1988 with B = C = 1/3: sharper; negative beyond a pixel, so edges ring a little */
};

constexpr double kernel_radius = 2;

/* The kernel's integral from the pixel's centre to x: odd, from -1/2 to 1/2. In error by less than 2^-48. */
double kernel_integral(Kernel kernel, double x);

/* Weights of the cells of `n` a pixel (1 or more) that the kernel reaches, in order, the pixel's own in the middle: n + 2 ceil(3 n / 2) of them. */
std::vector<double> cell_weights(Kernel kernel, int n);

/* Samples of a plane of width * n columns and height * n rows become width x height pixels. At the plane's edges, beyond which nothing was sampled, the weights of
 * what is there are scaled to a sum of 1. */
std::vector<double> reconstruct(Kernel kernel, int n, std::size_t width, std::size_t height, const std::vector<double> &samples);

} // namespace host

#endif
