/*
 * The two binary PNM formats; pnm.h says for whom.
 */
#include "pnm.h"

#include <filesystem>

#include "atomic_file.h"

namespace host {
namespace {

bool is_pnm(const std::string &path, const char *right, const char *wrong, const char *why)
{
  const std::string extension = image_extension(path);
  if (extension == wrong) {
    fail_write(path, why, std::string("let the name end in ") + right);
  }
  return extension == right || extension == ".pnm";
}

std::string header(const char *magic, int width, int height, int maximum)
{
  return std::string(magic) + "\n" + std::to_string(width) + " " + std::to_string(height) + "\n" +
         std::to_string(maximum) + "\n";
}

} // namespace

std::string image_extension(const std::string &path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for (char &c : extension) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return extension;
}

bool write_if_pnm(const std::string &path, const Image8 &image)
{
  if (!is_pnm(path, ".ppm", ".pgm", "a .pgm file has no colours")) {
    return false;
  }
  std::string bytes = header("P6", image.width, image.height, 255);
  bytes.append(image.rgb.begin(), image.rgb.end());
  write_file(path, bytes);
  return true;
}

bool write_if_pnm(const std::string &path, const Image16 &image)
{
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

} // namespace host
