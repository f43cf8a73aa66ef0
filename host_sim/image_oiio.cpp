/*
 * The image backend with OpenImageIO: every format that it writes.
 */
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "atomic_file.h"
#include "image.h"
#include "pnm.h"
#include "scene_file.h"

namespace host {
namespace {

/* OpenImageIO's own texts may have several lines. */
std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.empty() ? "OpenImageIO gives no reason" : text;
}

OIIO::TypeDesc oiio_type(SampleType type) {
  switch (type) {
    case SampleType::u8: return OIIO::TypeDesc::UINT8;
    case SampleType::u16: return OIIO::TypeDesc::UINT16;
    case SampleType::u32: return OIIO::TypeDesc::UINT32;
    case SampleType::f16: return OIIO::TypeDesc::HALF;
    case SampleType::f32: break;
  }
  return OIIO::TypeDesc::FLOAT;
}

/* OpenImageIO encodes into memory and write_file writes: a full disk is then reported rather than missed.
 * `stored`: what `samples` are; UNKNOWN: as each channel of the spec says, packed. */
void write(const std::string &path, OIIO::ImageSpec spec, OIIO::TypeDesc stored, const void *samples, const Metadata &metadata) {
  const std::string extension = image_extension(path);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path);
  if (!output || output->supports("ioproxy") == 0) {
    OIIO::geterror(); /* or it is printed at exit */
    const std::string what = extension.empty() ? "a name without extension" : "unknown image format " + extension;
    fail_write(path, what, "let the name end in .png, .tif or another format of OpenImageIO");
  }
  spec.attribute("DateTime", "1980:01:01 00:00:00"); /* or some formats store the time of day */
  spec.attribute("Software", "fixcast");             /* or OpenImageIO adds the command line */
  for (const auto &[name, text] : metadata) spec.attribute(name, text);
  OIIO::Filesystem::IOVecOutput bytes;
  output->set_ioproxy(&bytes);
  if (!output->open(path, spec)) fail_write(path, one_line(output->geterror()), "try .png");
  if (spec.format == OIIO::TypeDesc::UINT16 && output->spec().format != OIIO::TypeDesc::UINT16) {
    output->close(); /* it would reduce the samples without a word */
    fail_write(path, extension + " cannot hold 16-bit samples", "use .png, .tif or .pgm");
  }
  const bool written = output->write_image(stored, samples);
  const bool closed = output->close();
  if (!written || !closed) fail_write(path, one_line(output->geterror()), "try .png");
  write_file(path, std::string(bytes.buffer().begin(), bytes.buffer().end()));
}

[[noreturn]] void fail_read(const std::string &path, const std::string &reason, const std::string &advice) {
  throw UserError(path + ": cannot read: " + reason + "; " + advice);
}

/* Libraries below OpenImageIO print their complaints themselves, besides returning them: keeps stderr to one message. */
class QuietStderr {
public:
  QuietStderr() : kept_(dup(STDERR_FILENO)) {
    const int nowhere = open("/dev/null", O_WRONLY);
    if (kept_ >= 0 && nowhere >= 0) (void)dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) close(nowhere);
  }
  ~QuietStderr() {
    if (kept_ < 0) return;
    (void)dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  QuietStderr(const QuietStderr &) = delete;
  QuietStderr &operator=(const QuietStderr &) = delete;

private:
  int kept_;
};

SampleType sample_type(const std::string &path, OIIO::TypeDesc type) {
  switch (type.basetype) {
    case OIIO::TypeDesc::UINT8: return SampleType::u8;
    case OIIO::TypeDesc::UINT16: return SampleType::u16;
    case OIIO::TypeDesc::UINT32: return SampleType::u32;
    case OIIO::TypeDesc::HALF: return SampleType::f16;
    case OIIO::TypeDesc::FLOAT: return SampleType::f32;
    default: fail_read(path, "samples of an unusual type", "convert it to .png or .exr first");
  }
}

/* IEEE 754 binary16. */
double half_value(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, mantissa = bits & 1023;
  const double magnitude = exponent == 31  ? (mantissa == 0 ? HUGE_VAL : std::nan(""))
                           : exponent == 0 ? std::ldexp(mantissa, -24)
                                           : std::ldexp(1024 + mantissa, exponent - 25);
  return (bits & 0x8000) != 0 ? -magnitude : magnitude;
}

/* One sample of the file's own type. */
double sample_at(const unsigned char *from, SampleType type) {
  switch (type) {
    case SampleType::u8: return *from;
    case SampleType::u16: {
      std::uint16_t v = 0;
      std::memcpy(&v, from, sizeof v);
      return v;
    }
    case SampleType::u32: {
      std::uint32_t v = 0;
      std::memcpy(&v, from, sizeof v);
      return v;
    }
    case SampleType::f16: {
      std::uint16_t v = 0;
      std::memcpy(&v, from, sizeof v);
      return half_value(v);
    }
    case SampleType::f32: break;
  }
  float v = 0;
  std::memcpy(&v, from, sizeof v);
  return v;
}

void put_sample(unsigned char *to, SampleType type, double value) {
  if (type == SampleType::u32) {
    const auto v = static_cast<std::uint32_t>(value);
    std::memcpy(to, &v, sizeof v);
  } else {
    const auto v = static_cast<float>(value);
    std::memcpy(to, &v, sizeof v);
  }
}

} // namespace

std::string write_image(const std::string &path, const Image8 &image, const Metadata &metadata) {
  if (!write_if_pnm(path, image))
    write(path, OIIO::ImageSpec(image.width, image.height, 3, OIIO::TypeDesc::UINT8), OIIO::TypeDesc::UINT8, image.rgb.data(), metadata);
  return path;
}

std::string write_image16(const std::string &path, const Image8 &image, const Metadata &metadata) {
  std::vector<std::uint16_t> wide;
  wide.reserve(image.rgb.size());
  for (const std::uint8_t v : image.rgb) wide.push_back(static_cast<std::uint16_t>(v * 257));
  write(path, OIIO::ImageSpec(image.width, image.height, 3, OIIO::TypeDesc::UINT16), OIIO::TypeDesc::UINT16, wide.data(), metadata);
  return path;
}

std::string write_depth(const std::string &path, const Image16 &image, const Metadata &metadata) {
  if (!write_if_pnm(path, image))
    write(path, OIIO::ImageSpec(image.width, image.height, 1, OIIO::TypeDesc::UINT16), OIIO::TypeDesc::UINT16, image.grey.data(), metadata);
  return path;
}

std::string write_raster(const std::string &path, const Raster &raster, const Metadata &metadata) {
  if (image_extension(path) != ".exr") fail_write(path, "only EXR holds named channels", "let the name end in .exr");
  OIIO::ImageSpec spec(raster.width, raster.height, static_cast<int>(raster.channels.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  for (std::size_t c = 0; c < raster.channels.size(); c++) {
    const Channel &channel = raster.channels[c];
    spec.channelnames.push_back(channel.name);
    spec.channelformats.push_back(oiio_type(channel.type));
    if (channel.name == "A") spec.alpha_channel = static_cast<int>(c);
    if (channel.name == "Z") spec.z_channel = static_cast<int>(c);
  }
  spec.attribute("compression", "zip");
  /* Floats and 32-bit integers: four bytes either way. */
  std::vector<unsigned char> packed(raster.pixels() * raster.channels.size() * 4);
  for (std::size_t c = 0; c < raster.channels.size(); c++)
    for (std::size_t i = 0; i < raster.pixels(); i++)
      put_sample(&packed[(i * raster.channels.size() + c) * 4], raster.channels[c].type, raster.channels[c].samples[i]);
  write(path, spec, OIIO::TypeDesc::UNKNOWN, packed.data(), metadata);
  return path;
}

Raster read_raster(const std::string &path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) fail_read(path, "no such file", "check the name");
  if (std::filesystem::is_directory(path, ignored)) fail_read(path, "this is a directory", "name a picture in it");
  Raster raster;
  if (read_if_pnm(path, raster)) return raster; /* OpenImageIO's own reader scales what is not 8 or 16 bits */
  const QuietStderr quiet;
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1; /* or colours come multiplied by alpha */
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &config);
  if (!input) fail_read(path, one_line(OIIO::geterror()), "name a picture such as .png or .exr");
  const OIIO::ImageSpec spec = input->spec();
  constexpr int largest = 1 << 14;
  if (spec.width > largest || spec.height > largest || spec.depth > 1 || spec.nchannels > 64)
    fail_read(path, "larger than 16384x16384 or more than 64 channels", "cut it");
  raster.width = spec.width;
  raster.height = spec.height;
  std::vector<unsigned char> packed(spec.image_bytes(true));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UNKNOWN, packed.data()))
    fail_read(path, one_line(input->geterror()), "the file is damaged; make it again");
  std::size_t offset = 0;
  for (int c = 0; c < spec.nchannels; c++) {
    Channel channel;
    channel.name = spec.channel_name(c);
    channel.type = sample_type(path, spec.channelformat(c));
    channel.samples.resize(raster.pixels());
    for (std::size_t i = 0; i < raster.pixels(); i++)
      channel.samples[i] = sample_at(&packed[i * spec.pixel_bytes(true) + offset], channel.type);
    offset += spec.channelformat(c).size();
    raster.channels.push_back(std::move(channel));
  }
  return raster;
}

#define FIXCAST_TEXT(x) #x
#define FIXCAST_JOIN(major, minor, patch) FIXCAST_TEXT(major) "." FIXCAST_TEXT(minor) "." FIXCAST_TEXT(patch)

const char *image_backend() { return "OpenImageIO " FIXCAST_JOIN(OIIO_VERSION_MAJOR, OIIO_VERSION_MINOR, OIIO_VERSION_PATCH); }

} // namespace host
