/* Pictures to a display, one after another. */
#include "animation.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include <zlib.h>

#include "fixcast/error.h"

namespace host {
namespace {

using Clock = StopSignal::Clock;

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

/* Strips of a display: where they are drawn, and the two buffers that are sent in turn. */
class Strips {
public:
  Strips(const fc_display &display, int rows) : display_(display) {
    fc_display_capabilities_get(&display, &capabilities_);
    const int align = capabilities_.y_align;
    rows_ = static_cast<std::uint16_t>(std::min((rows + align - 1) / align * align, static_cast<int>(capabilities_.height)));
    pitch_ = fc_display_row_bytes(capabilities_.format, capabilities_.width);
    const std::size_t drawn = std::size_t(2) * capabilities_.width * rows_;
    for (std::vector<std::uint8_t> &buffer : sent_) buffer.resize(pitch_ * rows_);
    if (capabilities_.format != FC_DISPLAY_RGB565) drawn_.resize(drawn);
  }

  std::uint16_t rows() const { return rows_; }
  std::uint16_t height() const { return capabilities_.height; }

  /* Where the next strip is drawn: a buffer that is not under way. */
  std::uint8_t *pixels() { return drawn_.empty() ? sent_[turn_].data() : drawn_.data(); }

  std::size_t bytes(std::uint16_t rows) const { return std::size_t(2) * capabilities_.width * rows; }

  /* Sends the strip that was drawn and returns while it is on its way; the one before has left by then. */
  int send(std::uint16_t y, std::uint16_t rows) {
    const fc_area area = {0, y, capabilities_.width, rows};
    std::uint8_t *buffer = sent_[turn_].data();
    int error = FC_OK;
    if (!drawn_.empty())
      error = fc_display_convert(capabilities_.format, 0, y, capabilities_.width, rows, drawn_.data(), bytes(1), buffer, pitch_);
    if (error == FC_OK) error = fc_display_write_start(&display_, &area, buffer, pitch_, nullptr, nullptr);
    turn_ ^= 1;
    return error;
  }

private:
  fc_display display_;
  fc_display_capabilities capabilities_{};
  std::uint16_t rows_;
  std::size_t pitch_, turn_ = 0;
  std::vector<std::uint8_t> drawn_, sent_[2];
};

} // namespace

AnimationFigures animate(const fc_display &display, PictureSource &source, const AnimationOptions &options, StopSignal &stop,
                         const std::function<void(unsigned, std::uint32_t)> &shown) {
  AnimationFigures figures;
  Strips strips(display, options.strip_rows);
  const Clock::time_point began = Clock::now();
  const Clock::duration period =
      options.fps > 0 ? std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / options.fps)) : Clock::duration(0);
  Clock::time_point due = began;
  while (figures.error == FC_OK && !figures.stopped && (options.frames == 0 || figures.frames < options.frames)) {
    std::uint32_t crc = 0;
    figures.stopped = stop.came_before(due);
    if (figures.stopped) break;
    due = std::max(due + period, Clock::now()); /* late frames are not made up for by a burst */
    Clock::time_point from = Clock::now();
    source.begin();
    for (std::uint16_t y = 0; y < strips.height() && figures.error == FC_OK && !figures.stopped;) {
      const std::uint16_t rows = static_cast<std::uint16_t>(std::min<int>(strips.rows(), strips.height() - y));
      source.rows(y, rows, strips.pixels());
      crc = static_cast<std::uint32_t>(crc32_z(crc, strips.pixels(), strips.bytes(rows)));
      figures.drawing_seconds += seconds(Clock::now() - from);
      figures.error = strips.send(y, rows);
      from = Clock::now();
      y = static_cast<std::uint16_t>(y + rows);
      if (!options.whole_frames && y < strips.height()) figures.stopped = stop.came();
    }
    if (figures.error == FC_OK && !figures.stopped) shown(figures.frames++, crc);
  }
  const int left = fc_display_wait(&display);
  if (figures.error == FC_OK) figures.error = left;
  figures.seconds = seconds(Clock::now() - began);
  return figures;
}

} // namespace host
