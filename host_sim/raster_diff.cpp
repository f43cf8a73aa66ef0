/* Two pictures, sample by sample. */
#include "raster_diff.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace host {
namespace {

std::string channel_list(const Raster &raster) {
  std::string names;
  for (const Channel &channel : raster.channels) names += (names.empty() ? "" : " ") + channel.name;
  return names;
}

std::string size_text(const Raster &raster) { return std::to_string(raster.width) + "x" + std::to_string(raster.height); }

std::string mismatch_of(const Raster &a, const Raster &b) {
  if (a.width != b.width || a.height != b.height) return "sizes differ: " + size_text(a) + " and " + size_text(b);
  if (channel_list(a) != channel_list(b)) return "channels differ: " + channel_list(a) + " and " + channel_list(b);
  for (std::size_t c = 0; c < a.channels.size(); c++)
    if (a.channels[c].type != b.channels[c].type)
      return "formats differ: channel " + a.channels[c].name + " is " + sample_type_name(a.channels[c].type) + " and " +
             sample_type_name(b.channels[c].type);
  return "";
}

bool equal(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/* Infinite where one of the two is no number or infinite. */
double distance(double a, double b) {
  if (equal(a, b)) return 0;
  const double d = std::fabs(a - b);
  return std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
}

/* What the channel's difference from black to white is. */
double range_of(const Channel &a, const Channel &b) {
  if (a.type == SampleType::u8 || a.type == SampleType::u16) return sample_white(a.type);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Channel *channel : {&a, &b})
    for (const double v : channel->samples)
      if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  return high > low ? high - low : 1;
}

} // namespace

RasterDifference difference(const Raster &a, const Raster &b) {
  RasterDifference result;
  result.mismatch = mismatch_of(a, b);
  if (!result.mismatch.empty()) return result;
  result.levels.resize(a.pixels());
  double worst_level = -1;
  for (std::size_t c = 0; c < a.channels.size(); c++) {
    const double range = range_of(a.channels[c], b.channels[c]);
    for (std::size_t i = 0; i < a.pixels(); i++) {
      const double d = distance(a.channels[c].samples[i], b.channels[c].samples[i]);
      if (d == 0) continue;
      const double level = 255 * d / range;
      result.levels[i] = std::max({result.levels[i], static_cast<float>(level), std::numeric_limits<float>::min()});
      if (level <= worst_level) continue;
      worst_level = level;
      result.worst = d;
      result.worst_channel = c;
      result.worst_x = static_cast<int>(i % static_cast<std::size_t>(a.width));
      result.worst_y = static_cast<int>(i / static_cast<std::size_t>(a.width));
    }
  }
  result.pixels = static_cast<std::size_t>(std::count_if(result.levels.begin(), result.levels.end(), [](float v) { return v > 0; }));
  return result;
}

Image8 picture_of(const Raster &raster) {
  const Channel *red = raster.find("R"), *green = raster.find("G"), *blue = raster.find("B");
  if (red == nullptr || green == nullptr || blue == nullptr) red = green = blue = &raster.channels.front();
  Image8 image{raster.width, raster.height, {}};
  image.rgb.reserve(3 * raster.pixels());
  for (std::size_t i = 0; i < raster.pixels(); i++)
    for (const Channel *channel : {red, green, blue}) {
      const double v = 255 * channel->samples[i] / sample_white(channel->type);
      image.rgb.push_back(static_cast<std::uint8_t>(std::lround(v > 0 ? std::min(v, 255.0) : 0.0)));
    }
  return image;
}

} // namespace host
