/* A frame's pixels as named channels. */
#include "frame_layers.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <utility>

#include "heat.h"
#include "scene_file.h"

namespace host {
namespace {

class Layers {
public:
  Layers(const CoreFrame &frame, const CoreScene &core, const Picture &picture) : frame_(frame), core_(core), picture_(picture) {
    raster_.width = picture.width;
    raster_.height = picture.height;
  }

  void add(const std::string &layer, const std::vector<float> &error) {
    if (layer == "color") {
      for (std::size_t c = 0; c < 3; c++)
        fill(std::string(1, "RGB"[c]), SampleType::f32,
             [&](std::size_t i) { return static_cast<double>(static_cast<float>(picture_.pixels[3 * i + c]) / 255.0f); });
      fill("A", SampleType::f32, [&](std::size_t i) { return picture_.surface[i] ? 1.0 : 0.0; });
    } else if (layer == "depth") {
      fill("Z", SampleType::f32, [&](std::size_t i) {
        const std::uint16_t code = picture_.depth[i];
        return code == 0 ? std::numeric_limits<double>::infinity() : static_cast<double>(static_cast<float>(frame_.depth_z(code)));
      });
    } else if (layer == "normal") {
      add_normals();
    } else if (layer == "id") {
      fill("id", SampleType::u32, [&](std::size_t i) { return static_cast<double>(picture_.object[i]); });
    } else if (layer == "samples") {
      const double alone = frame_.get().options.profile == FC_PROFILE_HALF ? 0.25 : 1;
      fill("samples", SampleType::f32, [&](std::size_t i) { return picture_.samples.empty() ? alone : picture_.samples[i]; });
    } else if (layer == "shadow") {
      add_shadow();
    } else if (layer == "error") {
      fill("error", SampleType::f32, [&](std::size_t i) { return static_cast<double>(error.at(i)); });
    }
  }

  Raster take() { return std::move(raster_); }

private:
  template <typename Value>
  void fill(const std::string &name, SampleType type, const Value &value) {
    Channel channel{name, type, {}};
    channel.samples.reserve(raster_.pixels());
    for (std::size_t i = 0; i < raster_.pixels(); i++) channel.samples.push_back(value(i));
    raster_.channels.push_back(std::move(channel));
  }

  void add_normals() {
    std::vector<fc_vec3> normals(raster_.pixels());
    for (std::size_t i = 0; i < normals.size(); i++) {
      if (!picture_.surface[i]) continue;
      fc_hit hit{};
      const std::size_t width = static_cast<std::size_t>(picture_.width);
      const int result =
          fc_pick(&frame_.get(), static_cast<std::uint16_t>(i % width), static_cast<std::uint16_t>(i / width), &hit, nullptr);
      if (result < 0) throw UserError(std::string("cannot tell normals: ") + fc_error_text(result));
      if (result > 0) normals[i] = hit.normal_q30;
    }
    const auto axis = [&](const char *name, std::int32_t fc_vec3::*member) {
      fill(name, SampleType::f32,
           [&](std::size_t i) { return static_cast<double>(static_cast<float>(std::ldexp(normals[i].*member, -30))); });
    };
    axis("N.X", &fc_vec3::x);
    axis("N.Y", &fc_vec3::y);
    axis("N.Z", &fc_vec3::z);
  }

  void add_shadow() {
    const std::size_t lights = std::min<std::size_t>(core_.lights.size(), 32);
    fill("shadow", SampleType::f32, [&](std::size_t i) {
      if (!picture_.surface[i] || lights == 0) return 0.0;
      const std::size_t reached = std::min(std::bitset<32>(picture_.lit[i]).count(), lights);
      return static_cast<double>(static_cast<float>(lights - reached) / static_cast<float>(lights));
    });
  }

  const CoreFrame &frame_;
  const CoreScene &core_;
  const Picture &picture_;
  Raster raster_;
};

const Channel &channel(const Raster &raster, const char *name) {
  const Channel *found = raster.find(name);
  if (found == nullptr) throw UserError(std::string("no channel ") + name + " to show; ask for its layer");
  return *found;
}

std::uint8_t level(double v) { return static_cast<std::uint8_t>(std::lround(std::min(std::max(v, 0.0), 255.0))); }

/* A hue a number, far from those of its neighbours: the golden angle; 0 is black. */
std::array<std::uint8_t, 3> id_colour(std::uint32_t id) {
  if (id == 0) return {0, 0, 0};
  const std::uint32_t turn = id * 2654435769u; /* 2^32 / golden ratio */
  std::array<std::uint8_t, 3> colour{};
  for (std::uint32_t c = 0; c < 3; c++) {
    const double hue = std::ldexp(turn + c * 1431655765u, -32); /* thirds of a turn */
    const double wave = std::fabs(hue - std::floor(hue) - 0.5) * 2;
    colour[c] = level(70 + 185 * wave);
  }
  return colour;
}

} // namespace

const std::vector<std::string> &layer_names() {
  static const std::vector<std::string> names = {"color", "depth", "normal", "id", "samples", "shadow", "error"};
  return names;
}

Raster frame_layers(const CoreFrame &frame, const CoreScene &core, const Picture &picture, const std::vector<float> &error,
                    const std::vector<std::string> &wanted) {
  Layers layers(frame, core, picture);
  for (const std::string &name : layer_names())
    if (std::find(wanted.begin(), wanted.end(), name) != wanted.end()) layers.add(name, error);
  return layers.take();
}

Image8 layer_picture(const Raster &raster, const std::string &layer) {
  Image8 image{raster.width, raster.height, std::vector<std::uint8_t>(3 * raster.pixels())};
  const auto paint = [&](const auto &colour_of) {
    for (std::size_t i = 0; i < raster.pixels(); i++) {
      const std::array<std::uint8_t, 3> c = colour_of(i);
      std::copy(c.begin(), c.end(), image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
  };
  const auto grey = [](double v) {
    const std::uint8_t g = level(v);
    return std::array<std::uint8_t, 3>{g, g, g};
  };
  if (layer == "depth") {
    const std::vector<double> &z = channel(raster, "Z").samples;
    double nearest = 0, farthest = 0; /* as 1 / z, in which pictures are even */
    for (const double v : z) {
      if (!std::isfinite(v)) continue;
      nearest = std::max(nearest, 1 / v);
      farthest = farthest == 0 ? 1 / v : std::min(farthest, 1 / v);
    }
    const double range = nearest > farthest ? nearest - farthest : 1;
    paint([&](std::size_t i) { return std::isfinite(z[i]) ? grey(40 + 215 * (1 / z[i] - farthest) / range) : grey(0); });
  } else if (layer == "normal") {
    const Channel &x = channel(raster, "N.X"), &y = channel(raster, "N.Y"), &z = channel(raster, "N.Z");
    paint([&](std::size_t i) {
      return std::array<std::uint8_t, 3>{level(128 + 127 * x.samples[i]), level(128 + 127 * y.samples[i]), level(128 + 127 * z.samples[i])};
    });
  } else if (layer == "id") {
    const std::vector<double> &id = channel(raster, "id").samples;
    paint([&](std::size_t i) { return id_colour(static_cast<std::uint32_t>(id[i])); });
  } else if (layer == "samples") {
    const std::vector<double> &samples = channel(raster, "samples").samples;
    const double white = std::max(4.0, *std::max_element(samples.begin(), samples.end()));
    paint([&](std::size_t i) { return grey(255 * samples[i] / white); });
  } else if (layer == "shadow") {
    const std::vector<double> &shadow = channel(raster, "shadow").samples;
    paint([&](std::size_t i) { return grey(255 * shadow[i]); });
  } else if (layer == "error") {
    const std::vector<double> &error = channel(raster, "error").samples;
    paint([&](std::size_t i) { return heat_colour(error[i]); });
  } else {
    const Channel &r = channel(raster, "R"), &g = channel(raster, "G"), &b = channel(raster, "B");
    paint([&](std::size_t i) {
      return std::array<std::uint8_t, 3>{level(255 * r.samples[i]), level(255 * g.samples[i]), level(255 * b.samples[i])};
    });
  }
  return image;
}

} // namespace host
