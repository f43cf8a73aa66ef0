/* Heat maps and pictures next to one another. */
#include "heat.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace host {

std::array<std::uint8_t, 3> heat_colour(double levels) {
  static constexpr std::array<std::array<double, 3>, 5> ramp = {{{0, 0, 0}, {40, 60, 220}, {220, 30, 60}, {255, 210, 40}, {255, 255, 255}}};
  if (!(levels < 255)) return {255, 255, 255};
  const double t = std::log2(1 + levels) / 8 * (ramp.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(t), ramp.size() - 2);
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t c = 0; c < 3; c++)
    colour[c] = static_cast<std::uint8_t>(std::lround(ramp[i][c] + (t - static_cast<double>(i)) * (ramp[i + 1][c] - ramp[i][c])));
  return colour;
}

Image8 heat_map(int width, int height, const std::vector<float> &levels) {
  Image8 image{width, height, {}};
  image.rgb.reserve(3 * levels.size());
  for (const float level : levels)
    for (const std::uint8_t v : heat_colour(level)) image.rgb.push_back(v);
  return image;
}

Image8 side_by_side(const std::vector<Image8> &pictures) {
  constexpr int gap = 4;
  constexpr std::uint8_t grey = 96;
  Image8 whole;
  for (const Image8 &picture : pictures) {
    whole.height = std::max(whole.height, picture.height);
    whole.width += picture.width + (whole.width > 0 ? gap : 0);
  }
  whole.rgb.assign(static_cast<std::size_t>(3 * whole.width) * static_cast<std::size_t>(whole.height), grey);
  std::size_t left = 0;
  for (const Image8 &picture : pictures) {
    const std::size_t row = static_cast<std::size_t>(picture.width) * 3;
    for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); y++)
      std::copy_n(picture.rgb.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                  whole.rgb.begin() + static_cast<std::ptrdiff_t>(y * static_cast<std::size_t>(whole.width) * 3 + left));
    left += row + gap * 3;
  }
  return whole;
}

Image8 zoomed(const Image8 &image, int zoom) {
  Image8 large{image.width * zoom, image.height * zoom, {}};
  large.rgb.reserve(image.rgb.size() * static_cast<std::size_t>(zoom) * static_cast<std::size_t>(zoom));
  for (int y = 0; y < large.height; y++)
    for (int x = 0; x < large.width; x++) {
      const std::size_t from =
          3 * (static_cast<std::size_t>(y / zoom) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x / zoom));
      for (std::size_t c = 0; c < 3; c++) large.rgb.push_back(image.rgb[from + c]);
    }
  return large;
}

} // namespace host
