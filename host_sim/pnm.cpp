/*
 * The two binary PNM formats; pnm.h says for whom.
 */
#include "pnm.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "atomic_file.h"
#include "scene_file.h"

namespace host {
namespace {

bool is_pnm(const std::string &path, const char *right, const char *wrong, const char *why) {
  const std::string extension = image_extension(path);
  if (extension == wrong) {
    fail_write(path, why, std::string("let the name end in ") + right);
  }
  return extension == right || extension == ".pnm";
}

std::string header(const char *magic, int width, int height, int maximum) {
  return std::string(magic) + "\n" + std::to_string(width) + " " + std::to_string(height) + "\n" +
         std::to_string(maximum) + "\n";
}

} // namespace

std::string image_extension(const std::string &path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char &c : extension) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return extension;
}

bool write_if_pnm(const std::string &path, const Image8 &image) {
  if (!is_pnm(path, ".ppm", ".pgm", "a .pgm file has no colours")) {
    return false;
  }
  std::string bytes = header("P6", image.width, image.height, 255);
  bytes.append(image.rgb.begin(), image.rgb.end());
  write_file(path, bytes);
  return true;
}

bool write_if_pnm(const std::string &path, const Image16 &image) {
  if (!is_pnm(path, ".pgm", ".ppm", "a .ppm file is for colours, not for depth")) {
    return false;
  }
  std::string bytes = header("P5", image.width, image.height, 65535);
  for (const std::uint16_t sample : image.grey) {
    bytes += static_cast<char>(sample >> 8);
    bytes += static_cast<char>(sample & 0xff);
  }
  write_file(path, bytes);
  return true;
}

bool read_if_pnm(const std::string &path, Raster &raster) {
  const std::string extension = image_extension(path);
  if (extension != ".pnm" && extension != ".ppm" && extension != ".pgm") {
    return false;
  }
  const auto refuse = [&path](const char *reason) {
    throw UserError(path + ": cannot read: " + reason + "; make it again with fixcast render");
  };
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file || bytes.size() < 2 || bytes[0] != 'P' || (bytes[1] != '5' && bytes[1] != '6')) {
    refuse("not a binary PPM or PGM file");
  }
  std::size_t at = 2;
  const auto header_number = [&](long limit) {
    while (at < bytes.size() && (std::isspace(static_cast<unsigned char>(bytes[at])) != 0 || bytes[at] == '#')) {
      at = bytes[at] == '#' ? std::min(bytes.find('\n', at), bytes.size()) : at + 1;
    }
    long value = 0;
    const std::size_t first = at;
    while (at < bytes.size() && bytes[at] >= '0' && bytes[at] <= '9' && value <= limit) {
      value = 10 * value + (bytes[at++] - '0');
    }
    if (at == first || value < 1 || value > limit) {
      refuse("a header number that is missing or too large");
    }
    return value;
  };
  raster.width = static_cast<int>(header_number(16384));
  raster.height = static_cast<int>(header_number(16384));
  const long maximum = header_number(65535);
  at++; /* one blank after the maximum */
  const std::size_t channels = bytes[1] == '6' ? 3 : 1, width = maximum > 255 ? 2 : 1;
  if (maximum != 255 && maximum != 65535) {
    refuse("a maximum that is neither 255 nor 65535");
  }
  if (bytes.size() != at + raster.pixels() * channels * width) {
    refuse("shorter or longer than its header says");
  }
  for (std::size_t c = 0; c < channels; c++) {
    Channel channel{channels == 1 ? "Y" : std::string(1, "RGB"[c]), width == 1 ? SampleType::u8 : SampleType::u16, {}};
    channel.samples.reserve(raster.pixels());
    for (std::size_t i = 0; i < raster.pixels(); i++) {
      const std::size_t sample = at + (i * channels + c) * width;
      unsigned value = static_cast<unsigned char>(bytes[sample]);
      if (width == 2) {
        value = value << 8 | static_cast<unsigned char>(bytes[sample + 1]);
      }
      channel.samples.push_back(value);
    }
    raster.channels.push_back(std::move(channel));
  }
  return true;
}

} // namespace host
