/*
 * What a scene costs on a chip: counts, flash, memory for a frame, and which parts of the core it needs.
 */
#ifndef FIXCAST_HOST_SCENE_FACTS_H
#define FIXCAST_HOST_SCENE_FACTS_H

#include <cstddef>
#include <string>
#include <vector>

#include "scene_options.h"

namespace host {

struct SceneFacts {
  std::string source, hash; /* the file's name without its directory, and its bytes' SHA-256 */
  std::size_t spheres = 0, planes = 0, triangles = 0, closed_triangles = 0, vertices = 0, materials = 0, lights = 0;
  std::size_t cones = 0; /* among the triangles */
  double cone_error = 0; /* of a cone's larger radius */
  MeshCounts mesh;
  unsigned coordinate_bits = 0;                     /* of the largest coordinate, without its sign; 30 at most */
  std::size_t vertex_bytes = 0;                     /* of each in flash: the smallest sufficient width (narrow.h) */
  int exponent = 0;                                 /* a coordinate is value * 2^(exponent - 16) world units */
  std::size_t table_bytes = 0, hierarchy_bytes = 0; /* flash */
  std::size_t frame_bytes = 0;                      /* fc_frame_memory */
  int width = 0, height = 0;                        /* of the frame that the next is for */
  std::size_t strip_bytes = 0;                      /* pixels (RGB565) and depth codes of 8 rows */
  std::vector<std::string> features;                /* of the core: "spheres", "closed meshes", "hierarchy", ... */
};

/* Sets a frame up, so that nothing is said of a scene which the core refuses. Throws UserError. */
SceneFacts scene_facts(const LoadedScene &scene);

/* For people, one line a fact, no line longer than 150 characters, no newlines. */
std::vector<std::string> fact_lines(const SceneFacts &facts);

/* One JSON object and a newline. */
std::string fact_json(const SceneFacts &facts);

} // namespace host

#endif
