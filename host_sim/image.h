/*
 * Pictures as files. One of two sources implements it, as the build finds OpenImageIO or not: image_oiio.cpp
 * writes and reads every format that OpenImageIO knows, image_pnm.cpp writes and reads PPM and PGM. (Both need pnm.cpp;
 * animations are gif.h's.)
 *
 * Files appear complete or not at all, and the same picture gives the same bytes on every run: the time that formats want to
 * store is always the same. Samples are stored as they are: no gamma, no colour profile. Errors are a UserError
 * "PATH: cannot write: reason; what to do".
 */
#ifndef FIXCAST_HOST_IMAGE_H
#define FIXCAST_HOST_IMAGE_H

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "raster.h"

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

/* What a file says about its origin: name and text. PNG, EXR, TIFF and GIF keep it, PNM does not. */
using Metadata = std::vector<std::pair<std::string, std::string>>;

/* Both pick the format by the extension of `path` and return the path that was really written: without
 * OpenImageIO, "frame.png" becomes "frame.ppm" (a depth image "frame.pgm") and a line on stderr says so. */
std::string write_image(const std::string &path, const Image8 &image, const Metadata &metadata = {});
std::string write_depth(const std::string &path, const Image16 &image, const Metadata &metadata = {});

/* The same picture in 16 bits a channel (v * 257, which is exact). PNM has no such form here. */
std::string write_image16(const std::string &path, const Image8 &image, const Metadata &metadata = {});

/* Named channels: .exr only, and only with OpenImageIO. */
std::string write_raster(const std::string &path, const Raster &raster, const Metadata &metadata = {});

/* Any picture, its samples as they are stored. Throws UserError "PATH: cannot read: reason; what to do". */
Raster read_raster(const std::string &path);

/* "OpenImageIO 2.4.7" or "built without OpenImageIO: PPM/PGM only". */
const char *image_backend();

} // namespace host

#endif
