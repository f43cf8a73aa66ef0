/*
 * A frame that another renderer drew, from a file: what `compare --frame` reads.
 *
 * Nine bytes a pixel, rows from the top, pixels from the left: the object's id (two bytes, low byte first; 0:
 * background), the light mask (four, low byte first; bit i: light i reaches the point), red, green, blue.
 */
#ifndef FIXCAST_HOST_FRAME_FILE_H
#define FIXCAST_HOST_FRAME_FILE_H

#include <string>

#include "frame_run.h"

namespace host {

/* The picture as FC_RGB888, without depth. Throws UserError when the file is not width * height pixels long. */
Picture read_frame_file(const std::string &path, int width, int height);

} // namespace host

#endif
