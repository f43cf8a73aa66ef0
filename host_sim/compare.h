/*
 * The core's frame against the oracle, pixel by pixel.
 */
#ifndef FIXCAST_HOST_COMPARE_H
#define FIXCAST_HOST_COMPARE_H

#include <cstddef>
#include <array>
#include <cstdint>
#include <vector>

#include "frame_run.h"
#include "image.h"
#include "oracle.h"

namespace host {

struct WrongPixel {
  int x = 0, y = 0;
  bool wrong_id = false; /* otherwise the shadow */
  std::uint16_t core_object = 0, oracle_object = 0;
  std::uint32_t core_lit = 0, oracle_lit = 0;
};

struct WrongColour {
  int x = 0, y = 0;
  std::array<std::uint8_t, 3> core{};
  std::array<double, 3> oracle{};
};

/* Where the oracle admits several answers (exact ties), the one nearest to the core's counts. */
struct Comparison {
  std::size_t wrong_id = 0;     /* pixels of another object */
  std::size_t wrong_shadow = 0; /* pixels of the right object lit by other lights */
  /* Over pixels of the right object and the lights of the first 32: */
  std::size_t light_tests = 0;   /* surface pixels times lights */
  std::size_t false_shadows = 0; /* lit, but the core says not: acne */
  std::size_t leaks = 0;         /* not lit, but the core says so */
  double colour_rmse = 0;        /* over all channels of all pixels, in 8-bit levels */
  double colour_max = 0;
  std::size_t wrong_colour = 0; /* pixels of the right object and lights that are more than a level off: what a mirror or a texture shows there */
  double depth_rel_max = 0;     /* |z - true z| / true z over surface pixels of the right object */
  std::size_t escalated = 0, ties = 0;
  std::vector<WrongPixel> wrong;
  std::vector<WrongColour> off; /* the pixels of wrong_colour */
  std::vector<float> error;     /* a pixel: the largest error of a colour channel, 8-bit levels */
  Image8 truth;                 /* the oracle's picture, rounded to 8 bits */
};

/* Whether light masks, the core's and the oracle's, agree; with more than 32 lights the core's last bit
 * stands for several, which the oracle's any_light covers. */
bool same_light(std::uint32_t core_lit, const OracleAnswer &answer, std::size_t lights);

/* `picture` is the frame as FC_RGB888; where it has no depth, depth_rel_max is 0. */
Comparison compare(const SceneFile &file, const Oracle &oracle, const CoreFrame &frame,
                   const Picture &picture);

} // namespace host

#endif
