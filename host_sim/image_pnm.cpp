/*
 * The image backend without any library: PPM and PGM, whatever format the name asks for.
 */
#include <cstdio>
#include <filesystem>

#include "atomic_file.h"
#include "image.h"
#include "pnm.h"
#include "scene_file.h"

namespace host {
namespace {

template <typename Image>
std::string write(const std::string &path, const char *own, const Image &image) {
  if (write_if_pnm(path, image)) return path;
  const std::string extension = image_extension(path);
  for (const char *const known : {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".tga", ".hdr", ".webp"}) {
    if (extension == known) {
      const std::string written = std::filesystem::path(path).replace_extension(own).string();
      write_if_pnm(written, image);
      std::fprintf(stderr, "%s: built without OpenImageIO, so the picture went to %s\n", path.c_str(), written.c_str());
      return written;
    }
  }
  if (extension == ".exr") fail_write(path, "built without OpenImageIO, which .exr needs", "use .ppm or install it and build again");
  const std::string what = extension.empty() ? "a name without extension" : "unknown image format " + extension;
  fail_write(path, what, std::string("let the name end in ") + own);
}

} // namespace

std::string write_image(const std::string &path, const Image8 &image, const Metadata &) { return write(path, ".ppm", image); }

std::string write_image16(const std::string &path, const Image8 &, const Metadata &) {
  fail_write(path, "built without OpenImageIO, which 16-bit colours need", "use --bits 8");
}

std::string write_depth(const std::string &path, const Image16 &image, const Metadata &) { return write(path, ".pgm", image); }

std::string write_raster(const std::string &path, const Raster &, const Metadata &) {
  fail_write(path, "built without OpenImageIO, which .exr needs", "use .ppm or install it and build again");
}

Raster read_raster(const std::string &path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) throw UserError(path + ": cannot read: no such file; check the name");
  Raster raster;
  if (!read_if_pnm(path, raster)) throw UserError(path + ": cannot read: built without OpenImageIO; name a .ppm or .pgm file");
  return raster;
}

const char *image_backend() { return "built without OpenImageIO: PPM/PGM only"; }

} // namespace host
