/*
 * Key-framed cameras from a text file.
 *
 * Each line is "FRAME from X Y Z at X Y Z"; '#' starts a comment. Frames are whole numbers, rising from line to line, at least two. Between two
 * keys the camera follows a Catmull-Rom curve, which goes through every key; before the first and after the last it stands still.
 */
#ifndef FIXCAST_HOST_KEY_FRAMES_H
#define FIXCAST_HOST_KEY_FRAMES_H

#include <string>
#include <vector>

#include "turn.h"

namespace host {

struct CameraKey {
  int frame = 0;
  IntVector from{}, at{}; /* on the grid below, components up to 2^29 */
};

struct KeyFrames {
  std::vector<CameraKey> keys;
  int exponent = 0; /* the grid is 2^exponent world units */

  /* The camera at a frame, any frame. */
  CameraKey at(int frame) const;
};

/* Throws UserError "PATH:LINE: what is wrong; what to do". */
KeyFrames read_key_frames(const std::string &path);

} // namespace host

#endif
