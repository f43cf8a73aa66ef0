/*
 * Where the camera is in each frame of a sequence.
 *
 * Everything is computed in integers on the scene's own grid, and the result is written back into the scene file as exact
 * numbers: the core, the oracle and every machine see the same camera.
 */
#ifndef FIXCAST_HOST_CAMERA_PATH_H
#define FIXCAST_HOST_CAMERA_PATH_H

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "scene_file.h"
#include "to_core.h"
#include "turn.h"

namespace host {

/* A point on a grid of 2^exponent world units as an exact number. */
Number grid_number(std::int64_t value, int exponent);
Vector grid_vector(const IntVector &value, int exponent);

/* Where a view turns: eye, target and pivot on a grid of 2^exponent world coordinates, 0 or coarser. The pivot is that point of the view's axis
 * which is nearest to the middle of everything finite, or, when that is behind the eye, the target. */
struct ViewAxis {
  int exponent = 0;
  IntVector eye{}, target{}, pivot{};
};
ViewAxis view_axis(const CoreScene &core);

class CameraPath {
public:
  virtual ~CameraPath() = default;
  /* The scene as frame `frame` of `frames` shows it; 0 <= frame < frames. */
  virtual SceneFile at(int frame, int frames) const = 0;
};

/*
 * `name` is one of
 *   orbit       the camera once around what it sees, about its up direction; lights stay
 *   turntable   the scene turns, as seen by a camera and lights that stay: both go around it the other way
 *   a file      key frames (key_frames.h)
 * `core` is `file` as converted by to_core. Throws UserError.
 */
std::unique_ptr<CameraPath> make_camera_path(const std::string &name, const SceneFile &file, const CoreScene &core);

} // namespace host

#endif
