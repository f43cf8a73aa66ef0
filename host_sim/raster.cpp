/* Pictures of named channels. */
#include "raster.h"

namespace host {

const char *sample_type_name(SampleType type) {
  switch (type) {
    case SampleType::u8: return "8-bit";
    case SampleType::u16: return "16-bit";
    case SampleType::u32: return "32-bit";
    case SampleType::f16: return "half float";
    case SampleType::f32: return "float";
  }
  return "unknown";
}

double sample_white(SampleType type) {
  switch (type) {
    case SampleType::u8: return 255;
    case SampleType::u16: return 65535;
    case SampleType::u32: return 4294967295.0;
    case SampleType::f16:
    case SampleType::f32: return 1;
  }
  return 1;
}

const Channel *Raster::find(const std::string &name) const {
  for (const Channel &channel : channels)
    if (channel.name == name) return &channel;
  return nullptr;
}

} // namespace host
