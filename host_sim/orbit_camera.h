/* The camera going round a scene: the boards' orbit (src/firmware/orbit.h) for any scene, whichever way is up in it. */
#ifndef FIXCAST_HOST_ORBIT_CAMERA_H
#define FIXCAST_HOST_ORBIT_CAMERA_H

#include "to_core.h"

namespace host {

class OrbitCamera {
public:
  /* Round the vertical line through the middle of the scene's spheres and triangles, or, without any, through the camera's target. Vertical is the
   * axis that the camera's up is nearest to. */
  explicit OrbitCamera(const CoreScene &scene);

  /* After `step` of FC_ORBIT_STEPS steps; step 0 is the scene's own camera, to the bit. */
  fc_camera at(unsigned step) const;

private:
  fc_camera start_, turned_from_; /* as the scene has it; with the vertical axis as y, and room to turn */
  int axis_ = 1;                  /* 0, 1, 2: which coordinate is vertical */
  fc_vec3 middle_{};
};

} // namespace host

#endif
