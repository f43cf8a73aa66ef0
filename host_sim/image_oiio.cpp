/*
 * The image backend with OpenImageIO: every format that it writes.
 */
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>

#include "atomic_file.h"
#include "image.h"
#include "pnm.h"

namespace host {
namespace {

/* OpenImageIO's own texts may have several lines. */
std::string one_line(std::string text)
{
  while (!text.empty() && text.back() == '\n') {
    text.pop_back();
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.empty() ? "OpenImageIO gives no reason" : text;
}

/* OpenImageIO encodes into memory and write_file writes: a full disk is then reported rather than missed. */
void write(const std::string &path, OIIO::ImageSpec spec, const void *samples)
{
  const std::string extension = image_extension(path);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path);
  if (!output || output->supports("ioproxy") == 0) {
    OIIO::geterror(); /* or it is printed at exit */
    const std::string what =
        extension.empty() ? "a name without extension" : "unknown image format " + extension;
    fail_write(path, what, "let the name end in .png, .tif or another format of OpenImageIO");
  }
  spec.attribute("DateTime", ""); /* or some formats store the time of day */
  OIIO::Filesystem::IOVecOutput bytes;
  output->set_ioproxy(&bytes);
  if (!output->open(path, spec)) {
    fail_write(path, one_line(output->geterror()), "try .png");
  }
  if (spec.format == OIIO::TypeDesc::UINT16 && output->spec().format != OIIO::TypeDesc::UINT16) {
    output->close(); /* it would reduce the samples without a word */
    fail_write(path, extension + " cannot hold 16-bit samples", "use .png, .tif or .pgm");
  }
  const bool written = output->write_image(spec.format, samples);
  const bool closed = output->close();
  if (!written || !closed) {
    fail_write(path, one_line(output->geterror()), "try .png");
  }
  write_file(path, std::string(bytes.buffer().begin(), bytes.buffer().end()));
}

} // namespace

std::string write_image(const std::string &path, const Image8 &image)
{
  if (!write_if_pnm(path, image)) {
    write(path, OIIO::ImageSpec(image.width, image.height, 3, OIIO::TypeDesc::UINT8), image.rgb.data());
  }
  return path;
}

std::string write_depth(const std::string &path, const Image16 &image)
{
  if (!write_if_pnm(path, image)) {
    write(path, OIIO::ImageSpec(image.width, image.height, 1, OIIO::TypeDesc::UINT16), image.grey.data());
  }
  return path;
}

#define FIXCAST_TEXT(x) #x
#define FIXCAST_VERSION(major, minor, patch) \
  FIXCAST_TEXT(major) "." FIXCAST_TEXT(minor) "." FIXCAST_TEXT(patch)

const char *image_backend()
{
  return "OpenImageIO " FIXCAST_VERSION(OIIO_VERSION_MAJOR, OIIO_VERSION_MINOR, OIIO_VERSION_PATCH);
}

} // namespace host
