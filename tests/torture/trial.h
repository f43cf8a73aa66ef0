/* What a family of trials is, how it fails, and the core seen through the oracle's shapes. */
#ifndef TORTURE_TRIAL_H
#define TORTURE_TRIAL_H

#include <string>
#include <vector>

#include "oracle.h"
#include "vec.h"

extern "C" {
#include "depth.h"
#include "fixcast/fixcast.h"
#include "num.h"
#include "space.h"
}

/* Thrown by a trial: the inputs and both answers. */
struct Failure {
  std::string text;
};

/* printf, then Failure. */
[[noreturn]] __attribute__((format(printf, 1, 2))) void fail(const char *format, ...);
__attribute__((format(printf, 1, 2))) std::string print(const char *format, ...);

/* One trial from its seed; returns how many rays, segments or values it checked. */
using Run = uint64_t (*)(Random &random);

struct Family {
  int number;
  const char *name;
  uint64_t trials; /* in the long run */
  double cost;     /* microseconds a trial, for the estimate of the first minute */
  Run run;
};

extern const std::vector<Family> triangle_families, closed_mesh_families, sphere_families, secondary_families,
    coherence_families, depth_families, engine_families, number_families, mirror_families;

/* The core's scene of a list of shapes, in the same order; planes' k must be a whole number of
 * coordinates. */
class Scene {
public:
  explicit Scene(const std::vector<oracle::Shape> &shapes);
  Scene(const Scene &) = delete;
  Scene &operator=(const Scene &) = delete;

  std::vector<oracle::Shape> shapes;
  fc_scene scene;
  std::string text() const;

private:
  std::vector<fc_sphere> spheres_;
  std::vector<fc_plane> planes_;
  std::vector<fc_triangle> triangles_;
  std::vector<fc_vec3> vertices_;
  std::vector<fc_shapes> tables_;
};

inline fc_vec3 to_core(Vec v) {
  fc_vec3 r = {static_cast<int32_t>(v.x), static_cast<int32_t>(v.y), static_cast<int32_t>(v.z)};
  return r;
}
inline Vec from_core(fc_vec3 v) { return {v.x, v.y, v.z}; }

/* fc_intersect, without a check. */
int shoot(const Scene &scene, Vec origin, Vec direction, fc_hit *hit, uint64_t t_min_q32 = 0,
          uint64_t t_max_q32 = UINT64_MAX);

/* fc_intersect against the oracle: which primitive, and every value of the hit. Returns the primitive or
 * -1. */
int check_ray(const Scene &scene, Vec origin, Vec direction, uint64_t t_min_q32 = 0,
              uint64_t t_max_q32 = UINT64_MAX);

/* The same, when the answer is known beforehand: a miss (-1) or a primitive. */
void expect_ray(const Scene &scene, Vec origin, Vec direction, int primitive);

/* fc_blocked against the oracle. */
bool check_segment(const Scene &scene, Vec from, Vec to);
void expect_segment(const Scene &scene, Vec from, Vec to, bool blocked);

/* How many of the shapes, each alone, the ray hits; each answer is checked too. */
int hits_alone(const Scene &scene, Vec origin, Vec direction);

/* A camera whose axes are world axes and whose grid is at least as fine as the world's, so that camera
 * space holds the scene's own integers (times a power of two). */
struct ExactCamera {
  Vec eye;
  int axis, sign; /* forward */
  int up_axis;    /* not axis */
  uint16_t width, height;
  uint32_t focal; /* z of a pixel's direction in half pixels */
};
/* Any camera at all. */
fc_camera to_core(const ExactCamera &camera);

/* A frame of a scene, with the shapes as camera space holds them. */
class Frame {
public:
  Frame(const Scene &scene, const std::vector<fc_light> &lights, const fc_camera &camera, uint16_t width,
        uint16_t height, int offset_rule);
  Frame(const Frame &) = delete;
  Frame &operator=(const Frame &) = delete;

  /* Renders everything in strips of some rows. */
  void render(uint16_t rows);
  /* The pixel against the oracle: primitive, depth code and, by FC_OFFSET_EXACT, the lights that reach it.
   * Returns the primitive or -1; *faced are the lights that the surface faces. */
  int check_pixel(uint16_t x, uint16_t y, uint32_t *lit = nullptr, uint32_t *faced = nullptr);
  Vec direction(uint16_t x, uint16_t y) const;
  std::string text() const;

  const Scene &world;
  fc_frame frame;
  std::vector<oracle::Shape> shapes; /* camera space */
  std::vector<Vec> lights;
  std::vector<uint16_t> depth, primitive;
  std::vector<uint32_t> lit;
  bool refused; /* a light too far away for this grid: nothing else holds then */

private:
  fc_scene scene_;
  fc_camera camera_;
  std::vector<fc_light> lights_;
  std::vector<int64_t> memory_;
};

fc_light light_at(Vec position, int exponent = 0);

/* A vector across `v`, not zero unless v is. */
Vec some_normal(Random &random, Vec v);

/* Three orthogonal whole vectors of one whole length (Euler and Rodrigues), quaternion entries up to
 * `most`. */
int64_t quaternion_frame(Random &random, int64_t most, Vec row[3]);

#endif
