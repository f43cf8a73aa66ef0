/*
 * Pictures as PPM (P6, 8 bits) and PGM (P5, 16 bits, big-endian), for both image backends: OpenImageIO's own
 * PNM writer stops at 8 bits.
 */
#ifndef FIXCAST_HOST_PNM_H
#define FIXCAST_HOST_PNM_H

#include <string>

#include "image.h"

namespace host {

/* The extension of `path` in lower case with its point, or "". */
std::string image_extension(const std::string &path);

/* Writes the image if `path` ends in .pnm or in .ppm (colour) or .pgm (depth), and tells whether it did.
 * Throws UserError when writing fails, and for .ppm and .pgm taken for each other. */
bool write_if_pnm(const std::string &path, const Image8 &image);
bool write_if_pnm(const std::string &path, const Image16 &image);

/* Reads a binary PPM or PGM of 8 or 16 bits (maximum 255 or 65535) if `path` ends in .pnm, .ppm or .pgm, and tells whether it
 * did. Throws UserError "PATH: cannot read: reason; what to do". */
bool read_if_pnm(const std::string &path, Raster &raster);

} // namespace host

#endif
