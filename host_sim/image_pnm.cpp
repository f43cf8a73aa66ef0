/*
 * The image backend without any library: PPM and PGM, whatever format the name asks for.
 */
#include <cstdio>
#include <filesystem>

#include "atomic_file.h"
#include "image.h"
#include "pnm.h"

namespace host {
namespace {

template <typename Image> std::string write(const std::string &path, const char *own, const Image &image)
{
  if (write_if_pnm(path, image)) {
    return path;
  }
  const std::string extension = image_extension(path);
  for (const char *const known : {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".bmp", ".tga", ".hdr",
                                  ".gif", ".webp"}) {
    if (extension == known) {
      const std::string written = std::filesystem::path(path).replace_extension(own).string();
      write_if_pnm(written, image);
      std::fprintf(stderr, "%s: built without OpenImageIO, so the picture went to %s\n", path.c_str(),
                   written.c_str());
      return written;
    }
  }
  const std::string what =
      extension.empty() ? "a name without extension" : "unknown image format " + extension;
  fail_write(path, what, std::string("let the name end in ") + own);
}

} // namespace

std::string write_image(const std::string &path, const Image8 &image)
{
  return write(path, ".ppm", image);
}

std::string write_depth(const std::string &path, const Image16 &image)
{
  return write(path, ".pgm", image);
}

const char *image_backend()
{
  return "built without OpenImageIO: PPM/PGM only";
}

} // namespace host
