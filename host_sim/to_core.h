/*
 * From the scene as written to the core's integers: every number is rounded once, here and nowhere else.
 *
 * The scene's exponent is the finest one that holds every sphere and vertex; camera, lights, planes and the
 * far limit get exponents of their own, relative to it. A scale by a power of two therefore changes exponents
 * only.
 */
#ifndef FIXCAST_HOST_TO_CORE_H
#define FIXCAST_HOST_TO_CORE_H

#include <cstdint>
#include <string>
#include <memory>
#include <vector>

#include "fixcast/fixcast.h"
#include "scene_file.h"

namespace host {

/* A run of triangles, and the vertices they index, counted from the run's first. */
struct TriangleTable {
  std::size_t triangle = 0, triangles = 0, vertex = 0, vertices = 0;
  std::uint8_t cull = 0; /* of its fc_shapes (closed_mesh.h) */
};

/* A material's layers and all that they point to; stays where it is. */
struct CoreLayers {
  CoreLayers() = default;
  CoreLayers(const CoreLayers &) = delete;
  CoreLayers &operator=(const CoreLayers &) = delete;

  std::vector<fc_layer> list;
  fc_phong phong{};
  fc_mirror mirror{};
  fc_emission emission{};
  fc_texture texture{};
  fc_mapping mapping{};
  fc_checker checker{};
  fc_image image{};
  std::vector<std::uint8_t> texels;
};

/* What is to be known of the triangles as a mesh, edges counted within each object. */
struct MeshCounts {
  std::size_t dropped = 0;            /* triangles without area on the core's grid: never hit, left out */
  std::size_t boundary_edges = 0;     /* of one triangle */
  std::size_t non_manifold_edges = 0; /* of more than two */
};

/* The core's tables and the memory they live in. Moving keeps the pointers inside; copying would not. */
struct CoreScene {
  CoreScene() = default;
  CoreScene(CoreScene &&) = default;
  CoreScene &operator=(CoreScene &&) = default;
  CoreScene(const CoreScene &) = delete;
  CoreScene &operator=(const CoreScene &) = delete;

  std::vector<fc_sphere> spheres;
  std::vector<fc_plane> planes;
  std::vector<fc_vec3> vertices;  /* no two of a table alike */
  std::vector<fc_normal> normals; /* empty, or one a vertex */
  std::vector<fc_uv> uvs;         /* empty, or one a vertex */
  std::vector<fc_triangle> triangles;
  std::vector<TriangleTable> triangle_tables;      /* in the scene's order: closed meshes apart from the rest */
  std::vector<fc_material> materials;              /* no two alike without layers */
  std::vector<std::unique_ptr<CoreLayers>> layers; /* of materials, nullptr for a matte one */
  std::vector<fc_light> lights;
  std::vector<fc_shapes> shapes; /* spheres, planes, triangles, without the empty ones */
  std::vector<std::uint32_t> bvh_memory;
  std::vector<fc_bvh> bvh; /* one, or none (hierarchy.h) */
  std::vector<fc_sky> sky; /* one, or none */
  fc_scene scene{};
  fc_camera camera{};
  MeshCounts mesh;
};

/* Throws UserError, with file and line, when the scene doesn't fit the core's ranges. */
CoreScene to_core(const SceneFile &file);

/* One world coordinate in world units. */
long double world_unit(const fc_scene &scene);

/* The rule for shadow tests: "exact", "residual", "none" or "epsilon=N", N in world units. Throws
 * UserError. */
fc_options to_options(const std::string &offset, const fc_scene &scene);

} // namespace host

#endif
