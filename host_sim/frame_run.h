/*
 * A whole frame from the core: set up, rendered in strips, kept in memory, counted.
 */
#ifndef FIXCAST_HOST_FRAME_RUN_H
#define FIXCAST_HOST_FRAME_RUN_H

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "sampling.h"
#include "scene_file.h"
#include "to_core.h"

namespace host {

/* A frame that is set up, and its working memory. `core` must outlive it. */
class CoreFrame {
public:
  /* Throws UserError when the core refuses the scene or the camera. */
  CoreFrame(const SceneFile &file, const CoreScene &core, const fc_options &options, int width, int height);
  CoreFrame(const CoreFrame &) = delete;
  CoreFrame &operator=(const CoreFrame &) = delete;

  const fc_frame &get() const {
    return frame_;
  }

  /* As asked for, whatever the profile draws. */
  int width() const {
    return width_;
  }

  int height() const {
    return height_;
  }

  std::size_t memory_bytes() const {
    return memory_bytes_;
  }

  /* The camera z, in world units, that a depth code other than 0 stands for. */
  double depth_z(std::uint16_t code) const;

private:
  const CoreScene &core_;
  fc_frame frame_{};
  int width_, height_;
  std::size_t memory_bytes_ = 0;
  std::vector<std::int64_t> memory_; /* of int64_t for its alignment */
};

/* What fc_render_profile or fc_sample_rows wrote, rows from top to bottom. */
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  std::vector<std::uint16_t> depth;
  std::vector<std::uint16_t> object; /* object ids, not primitive numbers; 0: background */
  std::vector<bool> surface;         /* false: background; a surface's object may be 0 too */
  std::vector<std::uint32_t> lit;
  std::vector<std::uint16_t> samples; /* rays a pixel; empty without sampling */
};

/* The frame in the two formats that reports need. */
struct Pictures {
  Picture rgb888, rgb565; /* FC_RGB888 and FC_RGB565_BE */
};

/* Renders the frame in strips of `strip_rows` rows, both formats at the same time. `quiet`: without progress of its own. */
Pictures render(const CoreFrame &frame, const Sampling &sampling, int strip_rows, bool quiet = false);

/* One format alone, without progress. */
Picture render_format(const CoreFrame &frame, const Sampling &sampling, fc_format format, int strip_rows);

/* What every report says about a frame. */
struct FrameCounts {
  std::uint32_t crc32 = 0; /* zlib's, of the RGB565 big-endian frame */
  std::map<std::uint16_t, std::size_t> pixels_by_id;
  std::size_t unlit_pixels = 0; /* of a surface that no light reaches */
};

/* `picture` must be FC_RGB565_BE. */
FrameCounts count(const Picture &picture);

} // namespace host

#endif
