/*
 * A scene as its author wrote it: every number keeps its text, nothing is rounded.
 *
 * The reader (nff.cpp) fills it, the conversion (to_core.cpp) rounds it into the core's integers, and
 * the oracle (oracle.cpp) takes it as it stands. Conventions: right-handed world, right = forward x up.
 */
#ifndef FIXCAST_HOST_SCENE_FILE_H
#define FIXCAST_HOST_SCENE_FILE_H

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace host {

/* A number as written: `text` is a finite decimal such as "-0.272166" or "1.11022e-16", or a fraction of
 * two integers such as "1/2" (accepted wherever a number is). `value` is the nearest long double. */
struct Number {
  std::string text = "0";
  long double value = 0;
};

struct Vector {
  Number x, y, z;
};

struct Rgb {
  Number r, g, b;
};

/* How a texture's coordinates are made: include/fixcast/material.h has the kinds. */
struct Mapping {
  enum class Kind {
    planar,
    spherical,
    vertices
  } kind = Kind::spherical;
  Vector origin, u, v; /* planar */
  int repeat_u = 1, repeat_v = 1;
};

/* A checker of two colours, or an image when it has texels. */
struct Texture {
  Mapping mapping;
  std::array<Rgb, 2> checker;
  int width = 0, height = 0;
  std::shared_ptr<const std::vector<std::uint8_t>> texels; /* width * height * 3 bytes, levels proportional to light */
  bool bilinear = false, clamp = false, modulate = false;
};

struct Mirror {
  Rgb reflectance;
  int bounces = 4;
};

/* Diffuse reflectance is colour * kd, channel by channel. Above 0, ks is the grey of Phong's highlight and shine its exponent. The last two
 * NFF fields are kept for later. The rest stands in "#fc:" lines after the material's. */
struct Material {
  Rgb colour;
  Number kd, ks, shine, transmittance, index_of_refraction;
  std::optional<Mirror> mirror;
  std::optional<Rgb> emission;
  std::optional<Texture> texture;
  int line = 0;
};

/* `object` is the id a pixel reports: 1 for the first entity of the file, then counting up, an entity being
 * one s, p, pp, c or "#fc: plane" line; "#fc: object N" gives N to every entity up to the next such line.
 * 0 is the background. */
struct Sphere {
  Vector center;
  Number radius;
  int material = 0;
  std::uint16_t object = 0;
  int line = 0;
};

/* Points with normal . p + d = 0 (the lectures' form). */
struct Plane {
  Vector normal;
  Number d;
  int material = 0;
  std::uint16_t object = 0;
  int line = 0;
};

/* A simple (perhaps concave) polygon of three or more vertices; normals is empty or one per vertex. */
struct Polygon {
  std::vector<Vector> vertices;
  std::vector<Vector> normals;            /* shaded smoothly with them */
  std::vector<std::array<Number, 2>> uvs; /* texture coordinates, empty or one per vertex */
  int material = 0;
  std::uint16_t object = 0;
  int line = 0;
};

/* Without a colour, each of n lights has intensity 1/sqrt(n) (NFF's rule). */
struct Light {
  Vector position;
  bool directional = false; /* position is the direction towards it; no falloff */
  std::optional<Rgb> colour;
  int line = 0;
};

/* The field of view spans the shorter side of the picture.
 * angle: degrees, between the centres of the outer pixels (NFF).
 * tan_half_fov: tangent of half the angle, between the outer edges of the outer pixels ("#fc: tan_half_fov");
 * when present it wins over angle. */
struct Camera {
  Vector from, at, up;
  Number angle_degrees;
  std::optional<Number> tan_half_fov;
  Number hither; /* NFF's near plane, for renderers with a z-buffer; rays start at the eye and don't need it */
  int line = 0;
};

/* A background that goes from SceneFile::background, against `up`, to `top`, along it: linear in the cosine. */
struct Gradient {
  Vector up;
  Rgb top;
  int line = 0;
};

enum class Falloff {
  none,
  inverse_square
};

struct SceneFile {
  std::string path;
  std::vector<std::string> warnings; /* what was read otherwise than its author may think; one sentence each */
  Rgb background;
  std::optional<Gradient> gradient;
  Rgb ambient; /* default 0.1 0.1 0.1 */
  Falloff falloff = Falloff::none;
  std::optional<Number> far; /* surfaces farther along the ray than this are background */
  Camera camera;
  std::vector<Material> materials;
  std::vector<Sphere> spheres;
  std::vector<Plane> planes;
  std::vector<Polygon> polygons;
  std::vector<Light> lights;
  int cones = 0;              /* that became polygons (cone_mesh.h), */
  long double cone_error = 0; /* none of which is farther from its cone than this part of the cone's larger radius */
  int width = 0, height = 0;  /* the file's "resolution", 0 when absent */
  /* --world-scale N/D: every length (positions, radii, d, far) is to be multiplied by this; with inverse-square
   * falloff light intensities are multiplied by its square, so that the picture stays the same. */
  std::int64_t scale_numerator = 1, scale_denominator = 1;
};

/* What a person did wrong, in one sentence with file and line. main() prints it and exits with 2. */
class UserError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/* Reads Haines' Neutral File Format with the "#fc:" extensions. Throws UserError. */
SceneFile read_nff(const std::string &path);

/* The same from memory; `name` stands for the file in messages and in SceneFile::path. */
SceneFile read_nff_text(const std::string &name, std::string_view text);

} // namespace host

#endif
