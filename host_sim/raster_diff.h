/* Two pictures, sample by sample: equal or not, exactly. */
#ifndef FIXCAST_HOST_RASTER_DIFF_H
#define FIXCAST_HOST_RASTER_DIFF_H

#include <cstddef>
#include <string>
#include <vector>

#include "image.h"
#include "raster.h"

namespace host {

struct RasterDifference {
  std::string mismatch;   /* why samples cannot be compared: size, channels, sample types; empty when they can */
  std::size_t pixels = 0; /* in which any sample differs */
  int worst_x = 0, worst_y = 0;
  std::size_t worst_channel = 0;
  double worst = 0; /* |a - b| of that sample in its own units */
  /* A pixel: its largest difference in 8-bit levels. 255 is from black to white; of floats and 32-bit integers, from the lowest to the highest
   * value in either picture. Never 0 where any sample differs. */
  std::vector<float> levels;

  bool same() const { return mismatch.empty() && pixels == 0; }
};

/* Undefined values (NaN) equal one another and differ from everything else. Metadata does not count. */
RasterDifference difference(const Raster &a, const Raster &b);

/* A raster as a picture for people: R G B or Y when it has them, or its first channel as a grey. */
Image8 picture_of(const Raster &raster);

} // namespace host

#endif
