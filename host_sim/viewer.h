/*
 * What the interactive view shows, without any window: a scene, a camera that moves, and a choice of what to see of it.
 */
#ifndef FIXCAST_HOST_VIEWER_H
#define FIXCAST_HOST_VIEWER_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "fixcast/panel.h"
#include "frame_run.h"
#include "image.h"
#include "scene_options.h"
#include "view_camera.h"

namespace host {

class Viewer {
public:
  /* `panel` may be NULL. Throws UserError when the core refuses the scene. */
  Viewer(LoadedScene scene, const fc_panel *panel);

  int width() const { return scene_.width; }
  int height() const { return scene_.height; }
  ViewCamera &camera() { return camera_; }

  /* A name of layer_names(). */
  void show(const std::string &layer) { layer_ = layer; }
  void next_profile();
  void next_offset();   /* exact shadows, none (acne), an epsilon of 1/256 of the scene */
  void next_depth();    /* exponent bits of a depth code: the scene's, 2, 3, 4 */
  void next_transfer(); /* linear, sRGB, gamma 2.2 */
  void next_samples();  /* a ray a pixel, 2 x 2, quincunx; exact rays, so the profile becomes exact */
  void toggle_panel();  /* what the panel shows, where there is one */

  /* Renders. Where the camera ended up inside of something degenerate, the picture stays as it was and status() says why. */
  const Image8 &render();

  /* "s1.nff 128x128, color, exact profile, exact shadows" and what else is not as usual; in the error layer the errors; of other profiles than
   * exact how many pixels they change, and what the profile costs a chip where that was counted (counted.h). */
  const std::string &status() const { return status_; }
  const std::string &layer() const { return layer_; }

private:
  struct Box {
    std::size_t shape;
    std::array<std::int64_t, 3> low, high;
    std::uint8_t cull; /* as long as the eye is outside */
  };

  void guard_back_faces();
  Image8 draw();
  Image8 draw_error();
  std::string describe() const;
  std::string cost_of_profile(const Picture &picture) const;

  LoadedScene scene_;
  const fc_panel *panel_;
  bool on_panel_ = false;
  ViewCamera camera_;
  std::string layer_ = "color", status_;
  int offset_ = 0, transfer_ = 0, samples_ = 0;
  std::vector<Box> closed_; /* tables whose back faces are left out, as long as the eye is outside */
  Image8 picture_;
};

} // namespace host

#endif
