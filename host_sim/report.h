/*
 * The words and the JSON by which commands report a frame; keys are stable.
 */
#ifndef FIXCAST_HOST_REPORT_H
#define FIXCAST_HOST_REPORT_H

#include <cstddef>
#include <cstdint>
#include <string>

#include "frame_run.h"
#include "scene_options.h"

namespace host {

/* printf's %g with nine digits: enough to read back a float, no locale. JSON has no inf or nan, nor do we. */
std::string number_text(double value);

/* "0x1234abcd" */
std::string hex_text(std::uint32_t value);

/* "1 plane", "2 planes" */
std::string count_text(std::size_t count, const std::string &noun);

/* The members width height crc32 pixels_by_id unlit_pixels, without the braces of the object. */
std::string frame_json(const LoadedScene &scene, const FrameCounts &counts);

/* The same for people, some lines each ending in a newline. */
std::string frame_summary(const LoadedScene &scene, const FrameCounts &counts);

} // namespace host

#endif
