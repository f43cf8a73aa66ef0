/*
 * The oracle: what exact arithmetic says a pixel shows, from the scene as written, with no code of the core.
 *
 * long double with a running error bound decides nearly every sign; where the bound is not enough the same
 * templates run again in 256-bit intervals (MPFI), and a sign that is still open is an exact tie.
 */
#ifndef FIXCAST_HOST_ORACLE_H
#define FIXCAST_HOST_ORACLE_H

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "scene_file.h"

namespace host {

/* One admissible answer for a ray. */
struct OracleAnswer {
  std::uint16_t object = 0;       /* 0: background */
  std::uint32_t lit = 0;          /* bit i: light i (of the first 32) reaches the point; all lights count below */
  bool any_light = false;         /* some light reaches the point */
  std::array<double, 3> colour{}; /* real-valued, 8-bit levels, clamped to 0..255 */
  double depth = 0;               /* distance along the viewing axis (camera z), world units; 0: background */
};

struct OraclePixel {
  /* The first answer is the preferred one; further ones exist only for exact ties (a ray through the edge of
   * two polygons, surfaces that coincide), where SPEC's tie rule may pick any of them. */
  std::vector<OracleAnswer> answers;
  bool escalated = false; /* needed the 256-bit intervals */
  bool tie = false;
};

/* A surface that a ray meets, hidden or not. */
struct OracleSurface {
  std::uint16_t object = 0;
  double depth = 0; /* camera z, world units */
};

class Oracle {
public:
  Oracle(const SceneFile &scene, int width, int height);
  ~Oracle();
  Oracle(const Oracle &) = delete;
  Oracle &operator=(const Oracle &) = delete;

  /* The ray through (x + 0.5 + dx, y + 0.5 + dy) in pixels, y downwards; dx = dy = 0 is the pixel's centre.
   * Safe to call from several threads at once. */
  OraclePixel pixel(int x, int y, double dx = 0, double dy = 0) const;

  /* Every surface that the ray through the pixel's centre meets in front of the eye (a sphere's near side only), within the
   * far limit, in the order of the file: spheres, planes, polygons. Depths to the precision of long double. */
  std::vector<OracleSurface> surfaces(int x, int y) const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace host

#endif
