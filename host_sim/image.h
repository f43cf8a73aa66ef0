/*
 * Pictures as files. One of two sources implements it, as the build finds OpenImageIO or not: image_oiio.cpp
 * writes every format that OpenImageIO knows, image_pnm.cpp writes PPM and PGM. (Both need pnm.cpp.)
 *
 * Files appear complete or not at all, and the same picture gives the same bytes on every run (OpenImageIO's
 * GIF excepted). Samples are stored as they are: no gamma, no colour profile. Errors are a UserError
 * "PATH: cannot write: reason; what to do".
 */
#ifndef FIXCAST_HOST_IMAGE_H
#define FIXCAST_HOST_IMAGE_H

#include <cstdint>
#include <string>
#include <vector>

namespace host {

/* Rows from top to bottom, pixels from left to right, three bytes each. */
struct Image8 {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

struct Image16 {
  int width = 0, height = 0;
  std::vector<std::uint16_t> grey;
};

/* Both pick the format by the extension of `path` and return the path that was really written: without
 * OpenImageIO, "frame.png" becomes "frame.ppm" (a depth image "frame.pgm") and a line on stderr says so. */
std::string write_image(const std::string &path, const Image8 &image);
std::string write_depth(const std::string &path, const Image16 &image);

/* "OpenImageIO 2.4.7" or "built without OpenImageIO: PPM/PGM only". */
const char *image_backend();

} // namespace host

#endif
