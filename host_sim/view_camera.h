/*
 * A camera that is moved by hand: rolled as a ball under the mouse, moved sideways, brought nearer, all in integers.
 *
 * Screen places are in pixels from the top left of the picture, its size being given with them.
 */
#ifndef FIXCAST_HOST_VIEW_CAMERA_H
#define FIXCAST_HOST_VIEW_CAMERA_H

#include <cstdint>

#include "camera_path.h"
#include "fixcast/rotation.h"
#include "to_core.h"
#include "turn.h"

namespace host {

class ViewCamera {
public:
  explicit ViewCamera(const CoreScene &core);

  /* The camera as it is now; the scene's own, to the bit, as long as nothing has moved it or everything was undone. */
  fc_camera camera() const;

  /* A drag from (x0, y0), where the button went down, to (x, y): of that turn and none of those that were made since. */
  void begin_drag();
  void roll(int x0, int y0, int x, int y, int width, int height);

  /* What is at the pivot's distance follows the mouse by so many pixels. */
  void pan(int dx, int dy, int width, int height);

  /* Nearer (above 0) or farther by steps of about a tenth of the distance; between 1/64 and 64 times the first. */
  void dolly(int steps);

  /* About the scene's up direction, in 1/65536 of a turn. */
  void spin(std::uint16_t angle);

  void reset();

private:
  IntVector world(const fc_vec3 &screen_q30) const;
  IntVector looked(const IntVector &v) const;

  fc_camera first_{};
  ViewAxis axis_;
  IntVector right_{}, above_{}, back_{};                                 /* of the first view, Q30 */
  fc_rotation turn_ = FC_ROTATION_NONE, before_drag_ = FC_ROTATION_NONE; /* of the scene, the camera being still; world axes */
  IntVector moved_{};                                                    /* of the pivot, on the axis' grid */
  int nearer_ = 0;
};

} // namespace host

#endif
