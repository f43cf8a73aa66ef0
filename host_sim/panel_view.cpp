/* What a panel's glass would show of a frame. */
#include "panel_view.h"

#include <cstddef>
#include <cstdint>

#include "scene_file.h"

namespace host {
namespace {

/* A level of `bits` bits as one of 8. */
std::uint8_t widened(unsigned level, unsigned bits) {
  const unsigned white = (1u << bits) - 1;
  return static_cast<std::uint8_t>((level * 255 + white / 2) / white);
}

/* One pixel of what fc_display_convert wrote; `row` begins its row, or in FC_DISPLAY_MONO8 its page of eight rows. */
void decode(std::uint8_t *rgb, std::uint8_t format, const std::uint8_t *row, std::size_t x, std::size_t y) {
  if (format == FC_DISPLAY_RGB565) {
    const unsigned v = static_cast<unsigned>(row[2 * x] << 8 | row[2 * x + 1]);
    rgb[0] = widened(v >> 11, 5), rgb[1] = widened(v >> 5 & 63, 6), rgb[2] = widened(v & 31, 5);
  } else if (format == FC_DISPLAY_RGB444) {
    for (std::size_t c = 0; c < 3; c++) {
      const std::size_t nibble = 3 * x + c; /* the high half of a byte is the earlier one */
      rgb[c] = widened(row[nibble / 2] >> (nibble % 2 == 0 ? 4 : 0) & 15u, 4);
    }
  } else if (format == FC_DISPLAY_GREY4) {
    rgb[0] = rgb[1] = rgb[2] = widened(row[x / 2] >> (x % 2 == 0 ? 4 : 0) & 15u, 4);
  } else {
    rgb[0] = rgb[1] = rgb[2] = widened(row[x] >> (y % 8) & 1u, 1);
  }
}

} // namespace

Image8 panel_picture(const fc_panel &panel, const Picture &picture) {
  if (picture.width != panel.width || picture.height != panel.height)
    throw UserError(std::string(panel.name) + " has " + std::to_string(panel.width) + "x" + std::to_string(panel.height) +
                    " pixels, the frame " + std::to_string(picture.width) + "x" + std::to_string(picture.height) + "; leave --size out");
  const std::size_t width = panel.width, height = panel.height;
  const std::size_t pitch = fc_display_row_bytes(panel.format, panel.width);
  const bool pages = panel.format == FC_DISPLAY_MONO8;
  std::vector<std::uint8_t> shown(pitch * (pages ? (height + 7) / 8 : height));
  const int error =
      fc_display_convert(panel.format, 0, 0, panel.width, panel.height, picture.pixels.data(), 2 * width, shown.data(), pitch);
  if (error < 0) throw UserError(std::string(panel.name) + ": " + fc_error_text(error));
  Image8 image{picture.width, picture.height, std::vector<std::uint8_t>(3 * width * height)};
  for (std::size_t y = 0; y < height; y++)
    for (std::size_t x = 0; x < width; x++)
      decode(&image.rgb[3 * (y * width + x)], panel.format, &shown[pitch * (pages ? y / 8 : y)], x, y);
  return image;
}

std::vector<std::uint8_t> dithered565(const Picture &rgb888) {
  const std::size_t width = static_cast<std::size_t>(rgb888.width), height = static_cast<std::size_t>(rgb888.height);
  std::vector<std::uint8_t> pixels(2 * width * height);
  const int error = fc_display_dither565(0, 0, static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height), rgb888.pixels.data(),
                                         3 * width, pixels.data(), 2 * width);
  if (error < 0) throw UserError(std::string("cannot dither: ") + fc_error_text(error));
  return pixels;
}

} // namespace host
