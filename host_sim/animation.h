/*
 * Pictures to a display, one after another: drawn in strips, each sent while the next is drawn, at a pace.
 */
#ifndef FIXCAST_HOST_ANIMATION_H
#define FIXCAST_HOST_ANIMATION_H

#include <cstdint>
#include <functional>

#include "fixcast/display.h"
#include "stop_signal.h"

namespace host {

/* What is drawn. A picture is begun, then its rows are drawn from top to bottom. */
class PictureSource {
public:
  virtual ~PictureSource() = default;
  /* The next picture; throws UserError. */
  virtual void begin() = 0;
  /* `rows` rows from row y as FC_RGB565_BE, one after the other. */
  virtual void rows(std::uint16_t y, std::uint16_t rows, std::uint8_t *pixels) = 0;
};

struct AnimationOptions {
  unsigned frames = 0;       /* how many to show; 0: until a signal comes */
  double fps = 0;            /* at most so many a second; 0: as many as can be */
  int strip_rows = 16;       /* rounded up to what the display can take */
  bool whole_frames = false; /* a signal ends the animation after a frame only, not after a strip */
};

struct AnimationFigures {
  unsigned frames = 0;
  double seconds = 0, drawing_seconds = 0;
  bool stopped = false; /* by a signal */
  int error = 0;        /* of the display: FC_OK, or what ended the animation */
};

/*
 * Shows frames until there have been enough, a signal has come or the display has failed; then nothing is under way.
 * `shown` is called after each frame with its number, from 0, and the CRC-32 (zlib's) of its FC_RGB565_BE rows.
 */
AnimationFigures animate(const fc_display &display, PictureSource &source, const AnimationOptions &options, StopSignal &stop,
                         const std::function<void(unsigned, std::uint32_t)> &shown);

} // namespace host

#endif
