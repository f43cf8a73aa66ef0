/*
 * A picture of any number of named channels, each with a sample type of its own: what EXR holds and what diff compares.
 */
#ifndef FIXCAST_HOST_RASTER_H
#define FIXCAST_HOST_RASTER_H

#include <cstddef>
#include <string>
#include <vector>

namespace host {

enum class SampleType {
  u8,
  u16,
  u32,
  f16,
  f32
};

/* "8-bit", "16-bit", "32-bit", "half float", "float". */
const char *sample_type_name(SampleType type);

/* The value that stands for white in an integer type; 1 for floats. */
double sample_white(SampleType type);

/* One channel: width * height samples, rows from the top. A double holds every value of every type as it is. */
struct Channel {
  std::string name; /* "R", "N.X", "id" */
  SampleType type = SampleType::f32;
  std::vector<double> samples;
};

struct Raster {
  int width = 0, height = 0;
  std::vector<Channel> channels;

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }

  /* NULL when there is no channel of that name. Valid as long as the raster. */
  const Channel *find(const std::string &name) const;
};

} // namespace host

#endif
