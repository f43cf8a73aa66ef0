/*
 * The oracle: sets up a scene in 256-bit intervals and answers pixels from it.
 *
 * A pixel is worked out with Ball over the box tree. Only the shapes that leave a question open are looked at
 * again with Wide; what is open even then is an exact tie, and every answer the tie allows is listed.
 */
#include "oracle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "oracle_boxes.h"
#include "oracle_geometry.h"
#include "oracle_number.h"
#include "oracle_radiance.h"

namespace host {

namespace {

using namespace oracle;

constexpr std::size_t max_answers = 64;
constexpr int nudge_count = 16;

using Channels = std::array<long double, 3>;

/* Everything a pixel needs in number type T. The direction through picture position (a, b), in half pixels
 * from the centre, is right * a + up * b + forward: the camera's directions times the lengths that would
 * otherwise have to be divided by. Shapes stand in the order of the tie rule. */
template <class T>
struct World {
  Vec<T> eye, right, up, forward;
  T far2;
  std::vector<Shape<T>> shapes;
  std::vector<Vec<T>> lights;
};

/* What does not take part in decisions. */
struct Surface {
  std::uint16_t object = 0;
  Channels albedo{};
  long double normal_length = 0; /* a sphere's radius, so that the vector from its centre has this length */
  ShapeOf shape;
  bool layered = false; /* Radiance says what it looks like */
};

template <class T>
struct Candidate {
  int shape = -1;
  Hit<T> hit;
  Verdict verdict;
};

/* A surface the pixel may show; `wide` is filled when it is first needed. */
struct Visible {
  int shape = -1;
  Hit<Ball> hit;
  std::optional<Hit<Wide>> wide;
};

Wide number(const Number &n) {
  Wide out;
  if (!Wide::parse(n.text, out)) throw UserError("'" + n.text + "' is not a number");
  return out;
}

Vec<Wide> vector(const Vector &v) {
  return {number(v.x), number(v.y), number(v.z)};
}

Wide whole(std::int64_t n) {
  return Wide(static_cast<long double>(n));
}

long double nearest(const Wide &w) {
  return w.ball().mid();
}

Vec<Ball> ball(const Vec<Wide> &v) {
  return {v.x.ball(), v.y.ball(), v.z.ball()};
}

Hit<Ball> ball(const Hit<Wide> &h) {
  return {h.num.ball(), h.den.ball()};
}

World<Ball> ball(const World<Wide> &wide) {
  World<Ball> out;
  out.eye = ball(wide.eye);
  out.right = ball(wide.right);
  out.up = ball(wide.up);
  out.forward = ball(wide.forward);
  out.far2 = wide.far2.ball();
  for (const Shape<Wide> &s : wide.shapes) {
    Shape<Ball> b{s.kind, ball(s.center), s.radius2.ball(), ball(s.normal), s.d.ball(), s.eye_side.ball(), {}};
    for (const Vec<Wide> &v : s.vertices)
      b.vertices.push_back(ball(v));
    out.shapes.push_back(std::move(b));
  }
  for (const Vec<Wide> &light : wide.lights)
    out.lights.push_back(ball(light));
  return out;
}

Double3 doubles(const Vec<Ball> &v) {
  return {static_cast<double>(v.x.mid()), static_cast<double>(v.y.mid()), static_cast<double>(v.z.mid())};
}

double largest(const Double3 &p) {
  return std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])});
}

/* Zero on the shape, positive on one side (outside a sphere) and negative on the other. */
template <class T>
T side_of(const Shape<T> &shape, const Vec<T> &p) {
  if (shape.kind != Kind::sphere) return dot(shape.normal, p) + shape.d;
  const Vec<T> offset = p - shape.center;
  return dot(offset, offset) - shape.radius2;
}

/* Newell's normal; the plane passes through a triangle's vertices, or else through the mean of the vertices,
 * and is scaled by their number to avoid a division. False if the polygon has no area. */
bool set_polygon_plane(Shape<Wide> &shape) {
  const std::vector<Vec<Wide>> &v = shape.vertices;
  if (v.size() < 3) return false;
  Vec<Wide> normal, sum;
  for (std::size_t i = 0; i < v.size(); ++i) {
    normal = normal + cross(v[i] - v[0], v[(i + 1) % v.size()] - v[0]);
    sum = sum + v[i];
  }
  if (sign_of(dot(normal, normal)).value == 0) return false;
  if (v.size() == 3) {
    shape.normal = normal;
    shape.d = -dot(normal, v[0]);
  } else {
    shape.normal = normal * Wide(static_cast<long double>(v.size()));
    shape.d = -dot(normal, sum);
  }
  return true;
}

/* Directions spread evenly around the line, to look at what lies beside an exact tie. */
Vec<Wide> nudge(const Line<Wide> &line, int k) {
  const Double3 d = doubles(ball(line.dir)), a = doubles(ball(line.across));
  Double3 b{d[1] * a[2] - d[2] * a[1], d[2] * a[0] - d[0] * a[2], d[0] * a[1] - d[1] * a[0]};
  const double length_a = std::hypot(a[0], a[1], a[2]), length_b = std::hypot(b[0], b[1], b[2]);
  const double angle = (k + 0.3183) * 2 * std::acos(-1.0) / nudge_count;
  const double u = std::cos(angle) / length_a, v = std::sin(angle) / length_b;
  return vec<Wide>(a[0] * u + b[0] * v, a[1] * u + b[1] * v, a[2] * u + b[2] * v);
}

Line<Wide> nudged(const Line<Wide> &line, int k) {
  Line<Wide> out = line;
  out.nudged = true;
  out.nudge = nudge(line, k);
  return out;
}

/* What takes a direction of any length to 2^80 times the scene's size. */
Wide far_away(const SceneFile &scene) {
  long double most = 1;
  const auto include = [&](const Vector &v) {
    most = std::max({most, std::fabs(v.x.value), std::fabs(v.y.value), std::fabs(v.z.value)});
  };
  for (const Sphere &s : scene.spheres)
    include(s.center);
  for (const Polygon &p : scene.polygons)
    std::for_each(p.vertices.begin(), p.vertices.end(), include);
  include(scene.camera.from);
  const long double scale = static_cast<long double>(scene.scale_numerator) / static_cast<long double>(scene.scale_denominator);
  return Wide(std::ldexp(most * std::max(scale, 1.0L), 80));
}

/* Does the ray meet the shape, given what `reaches` says? Only a polygon has an outline to test as well. */
template <class T>
Verdict meets(const Shape<T> &shape, const Verdict &reached, const Line<T> &ray) {
  if (shape.kind != Kind::polygon || (!reached.value && reached.certain)) return reached;
  const Verdict outline = pierces(ray, shape.vertices);
  if (!outline.value && outline.certain) return outline;
  return {reached.value && outline.value, reached.certain && outline.certain};
}

bool same(const OracleAnswer &a, const OracleAnswer &b) {
  const auto close = [](double x, double y) { return std::fabs(x - y) <= 1e-9 * (1 + std::fabs(x)); };
  return a.object == b.object && a.lit == b.lit && a.any_light == b.any_light && close(a.depth, b.depth) &&
         close(a.colour[0], b.colour[0]) && close(a.colour[1], b.colour[1]) &&
         close(a.colour[2], b.colour[2]);
}

void add_answer(std::vector<OracleAnswer> &answers, const OracleAnswer &answer) {
  if (answers.size() >= max_answers) return;
  for (const OracleAnswer &known : answers) {
    if (same(known, answer)) return;
  }
  answers.push_back(answer);
}

template <typename T>
std::size_t index_in(const std::vector<T> &table, const T &item) {
  return static_cast<std::size_t>(&item - table.data());
}

Real3 middles(const Vec<Ball> &v) {
  return {v.x.mid(), v.y.mid(), v.z.mid()};
}

double level(long double value) {
  return static_cast<double>(std::min(std::max(255 * value, 0.0L), 255.0L));
}

} // namespace

struct Oracle::State {
  State(const SceneFile &scene, int width, int height);

  OraclePixel pixel(int x, int y, double dx, double dy) const;
  std::vector<OracleSurface> surfaces(int x, int y) const;

private:
  /* One pixel's ray, with the 256-bit version made on demand. */
  struct Ray {
    long double a, b, dx2, dy2;
    Line<Ball> line;
    std::optional<Line<Wide>> wide;
  };

  template <class T>
  Line<T> make_line(const World<T> &world, const Ray &ray) const {
    const T a = T(ray.a) + T(ray.dx2), b = T(ray.b) - T(ray.dy2);
    return {world.eye, world.right * a + world.up * b + world.forward};
  }
  const Line<Wide> &wide_line(Ray &ray) const {
    if (!ray.wide) ray.wide = make_line(wide_, ray);
    return *ray.wide;
  }
  const Hit<Wide> &wide_hit(Visible &seen, Ray &ray) const;

  void set_camera(const SceneFile &scene);
  void add_shape(Shape<Wide> shape, std::uint16_t object, const Material &material, long double normal_length, const ShapeOf &what,
                 bool has_normals);
  void finish_shapes();

  Sign light_side(int shape, std::size_t light) const {
    return light_sides_[static_cast<std::size_t>(shape) * wide_.lights.size() + light];
  }

  std::vector<Candidate<Ball>> nearest_shapes(const Line<Ball> &line) const;
  std::vector<Visible> visible(Ray &ray, bool &escalated, bool &background_possible,
                               bool &background_first) const;
  Verdict beyond_far(Visible &seen, Ray &ray, bool &escalated) const;
  Verdict is_lit(Visible &seen, Ray &ray, const Point<Ball> &p, std::size_t light, bool &escalated) const;
  Verdict blocked_wide(const std::vector<int> &doubtful, const Point<Wide> &p, std::size_t light) const;
  void shade(Visible &seen, Ray &ray, std::vector<OracleAnswer> &answers, bool &escalated) const;

  int width_, height_;
  World<Wide> wide_;
  World<Ball> ball_;
  std::vector<Surface> surfaces_;
  std::vector<Sign> eye_sides_, light_sides_; /* these do not depend on the pixel: decided with Wide once */
  std::vector<int> planes_;                   /* infinite, so not in the tree */
  BoxTree tree_;
  bool has_far_ = false;
  bool inverse_square_ = false;
  long double depth_factor_ = 0; /* depth = t * depth_factor_ */
  Channels ambient_{};
  Radiance radiance_;
  std::vector<bool> directional_; /* lights */
  std::vector<Channels> light_colours_;
};

Oracle::State::State(const SceneFile &scene, int width, int height)
    : width_(width), height_(height), radiance_(scene) {
  const Wide scale = whole(scene.scale_numerator) / whole(scene.scale_denominator);
  set_camera(scene);
  wide_.eye = vector(scene.camera.from) * scale;
  if (scene.far) {
    has_far_ = true;
    const Wide far = number(*scene.far) * scale;
    wide_.far2 = far * far;
  }

  inverse_square_ = scene.falloff == Falloff::inverse_square;
  const Wide brighter = inverse_square_ ? scale * scale : whole(1);
  for (const Light &light : scene.lights) {
    /* a directional light is so far away that its rays are parallel as far as any picture can tell */
    wide_.lights.push_back(light.directional ? wide_.eye + vector(light.position) * far_away(scene) : vector(light.position) * scale);
    directional_.push_back(light.directional);
    const auto intensity = [&](const Wide &w) { return nearest(w * brighter); };
    if (light.colour) {
      const Rgb &c = *light.colour;
      light_colours_.push_back({intensity(number(c.r)), intensity(number(c.g)), intensity(number(c.b))});
    } else {
      const long double grey =
          intensity(whole(1) / root(Wide(static_cast<long double>(scene.lights.size()))));
      light_colours_.push_back({grey, grey, grey});
    }
  }
  const auto channels = [](const Rgb &c) {
    return Channels{nearest(number(c.r)), nearest(number(c.g)), nearest(number(c.b))};
  };
  ambient_ = channels(scene.ambient);

  const auto material = [&](int index) -> const Material & {
    return scene.materials.at(static_cast<std::size_t>(index));
  };
  for (const Sphere &sphere : scene.spheres) {
    const Wide radius = number(sphere.radius) * scale;
    Shape<Wide> shape;
    shape.kind = Kind::sphere;
    shape.center = vector(sphere.center) * scale;
    shape.radius2 = radius * radius;
    add_shape(std::move(shape), sphere.object, material(sphere.material), std::fabs(nearest(radius)),
              {ShapeOf::Kind::sphere, index_in(scene.spheres, sphere)}, false);
  }
  for (const Plane &plane : scene.planes) {
    Shape<Wide> shape;
    shape.kind = Kind::plane;
    shape.normal = vector(plane.normal);
    shape.d = number(plane.d) * scale;
    planes_.push_back(static_cast<int>(wide_.shapes.size()));
    const long double length = nearest(root(dot(shape.normal, shape.normal)));
    add_shape(std::move(shape), plane.object, material(plane.material), length,
              {ShapeOf::Kind::plane, index_in(scene.planes, plane)}, false);
  }
  for (const Polygon &polygon : scene.polygons) {
    Shape<Wide> shape;
    shape.kind = Kind::polygon;
    for (const Vector &v : polygon.vertices)
      shape.vertices.push_back(vector(v) * scale);
    if (!set_polygon_plane(shape)) continue; /* no area: never seen, never in the way */
    const long double length = nearest(root(dot(shape.normal, shape.normal)));
    add_shape(std::move(shape), polygon.object, material(polygon.material), length,
              {ShapeOf::Kind::polygon, index_in(scene.polygons, polygon)}, !polygon.normals.empty());
  }
  finish_shapes();
}

void Oracle::State::set_camera(const SceneFile &scene) {
  const Camera &camera = scene.camera;
  const int side = std::min(width_, height_);
  const Wide distance = camera.tan_half_fov
                            ? whole(side) / number(*camera.tan_half_fov)
                            : whole(std::max(side - 1, 1)) / Wide::tan_half_degrees(number(camera.angle_degrees));
  const Vec<Wide> forward = vector(camera.at) - vector(camera.from);
  const Vec<Wide> right = cross(forward, vector(camera.up));
  const Wide forward_length = root(dot(forward, forward)), right_length = root(dot(right, right));
  wide_.right = right * forward_length;
  wide_.up = cross(right, forward);
  wide_.forward = forward * (distance * right_length);
  depth_factor_ = nearest(distance * right_length * forward_length);
}

void Oracle::State::add_shape(Shape<Wide> shape, std::uint16_t object, const Material &material, long double normal_length,
                              const ShapeOf &what, bool has_normals) {
  const auto albedo = [&](const Number &channel) { return nearest(number(channel) * number(material.kd)); };
  const Rgb &c = material.colour;
  surfaces_.push_back({object, {albedo(c.r), albedo(c.g), albedo(c.b)}, normal_length, what, Radiance::layered(material, has_normals)});
  shape.eye_side = side_of(shape, wide_.eye);
  eye_sides_.push_back(sign_of(shape.eye_side));
  for (const Vec<Wide> &light : wide_.lights)
    light_sides_.push_back(sign_of(side_of(shape, light)));
  wide_.shapes.push_back(std::move(shape));
}

void Oracle::State::finish_shapes() {
  ball_ = ball(wide_);
  double reach = largest(doubles(ball_.eye));
  for (const Vec<Ball> &light : ball_.lights)
    reach = std::max(reach, largest(doubles(light)));
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < ball_.shapes.size(); ++i) {
    const Shape<Ball> &shape = ball_.shapes[i];
    if (shape.kind == Kind::plane) continue;
    Box box;
    box.shape = static_cast<int>(i);
    if (shape.kind == Kind::sphere)
      box.include(doubles(shape.center), static_cast<double>(surfaces_[i].normal_length));
    for (const Vec<Ball> &v : shape.vertices)
      box.include(doubles(v), 0);
    reach = std::max({reach, largest(box.low), largest(box.high)});
    boxes.push_back(box);
  }
  tree_.build(std::move(boxes), reach);
}

const Hit<Wide> &Oracle::State::wide_hit(Visible &seen, Ray &ray) const {
  if (!seen.wide) {
    const auto i = static_cast<std::size_t>(seen.shape);
    seen.wide.emplace();
    reaches(wide_.shapes[i], eye_sides_[i], wide_line(ray), *seen.wide);
  }
  return *seen.wide;
}

/* The nearest shape if Ball can tell, else all that may be nearest. */
std::vector<Candidate<Ball>> Oracle::State::nearest_shapes(const Line<Ball> &line) const {
  std::vector<Candidate<Ball>> found;
  std::optional<Hit<Ball>> best;
  double limit = HUGE_VAL;
  const auto is_farther = [&](const Hit<Ball> &hit) { return best && compare(*best, hit).value < 0; };
  const auto look_at = [&](int shape, double &end) {
    const auto i = static_cast<std::size_t>(shape);
    Candidate<Ball> c;
    c.shape = shape;
    const Verdict reached = reaches(ball_.shapes[i], eye_sides_[i], line, c.hit);
    if ((!reached.value && reached.certain) || is_farther(c.hit)) return true;
    c.verdict = meets(ball_.shapes[i], reached, line);
    if (!c.verdict.value && c.verdict.certain) return true;
    if (c.verdict.certain && (!best || compare(c.hit, *best).value < 0)) {
      best = c.hit;
      /* Rounding in double is far smaller than this margin. */
      end = limit = static_cast<double>(c.hit.num.mid() / c.hit.den.mid()) * (1 + 1e-9);
    }
    found.push_back(std::move(c));
    return true;
  };
  for (int shape : planes_)
    look_at(shape, limit);
  tree_.walk(doubles(line.apex), doubles(line.dir), 0, limit, look_at);
  found.erase(std::remove_if(found.begin(), found.end(), [&](const auto &c) { return is_farther(c.hit); }),
              found.end());
  return found;
}

/* The surfaces the ray may show, the preferred one first. Only a tie gives more than one. */
std::vector<Visible> Oracle::State::visible(Ray &ray, bool &escalated, bool &background_possible,
                                            bool &background_first) const {
  std::vector<Visible> out;
  std::vector<Candidate<Ball>> found = nearest_shapes(ray.line);
  background_possible = background_first = found.empty();
  if (found.empty()) return out;
  if (found.size() == 1 && found[0].verdict.certain) {
    out.push_back({found[0].shape, found[0].hit, std::nullopt});
    return out;
  }

  escalated = true;
  const Line<Wide> &line = wide_line(ray);
  std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) { return a.shape < b.shape; });
  std::vector<Candidate<Wide>> closer;
  std::vector<Verdict> reached;
  for (const Candidate<Ball> &f : found) {
    const auto i = static_cast<std::size_t>(f.shape);
    Candidate<Wide> c;
    c.shape = f.shape;
    const Verdict r = reaches(wide_.shapes[i], eye_sides_[i], line, c.hit);
    c.verdict = meets(wide_.shapes[i], r, line);
    if (c.verdict.value || !c.verdict.certain) {
      closer.push_back(std::move(c));
      reached.push_back(r);
    }
  }

  /* Adds those of the shapes taken to be hit that no other is in front of. */
  const auto add_nearest = [&](const std::vector<bool> &taken) {
    bool any = false;
    for (std::size_t i = 0; i < closer.size(); ++i) {
      bool nearest = taken[i];
      for (std::size_t j = 0; j < closer.size() && nearest; ++j)
        nearest = j == i || !taken[j] || compare(closer[j].hit, closer[i].hit).value >= 0;
      if (!nearest) continue;
      any = true;
      const bool known =
          std::any_of(out.begin(), out.end(), [&](const Visible &v) { return v.shape == closer[i].shape; });
      if (!known) out.push_back({closer[i].shape, ball(closer[i].hit), closer[i].hit});
    }
    return any;
  };

  std::vector<bool> taken;
  bool outline_tie = false, other_tie = false;
  for (std::size_t i = 0; i < closer.size(); ++i) {
    taken.push_back(closer[i].verdict.value);
    outline_tie = outline_tie || (!closer[i].verdict.certain && reached[i].certain);
    other_tie = other_tie || !reached[i].certain;
  }
  background_possible = background_first = !add_nearest(taken);
  /* Beside a shared edge the ray meets one polygon or the other, never neither: hence the nudged rays, which
   * treat all polygons alike. */
  for (int k = outline_tie ? 0 : nudge_count - 1; (outline_tie || other_tie) && k < nudge_count; ++k) {
    const Line<Wide> beside = nudged(line, k);
    std::vector<bool> either(closer.size());
    for (std::size_t i = 0; i < closer.size(); ++i) {
      if (closer[i].verdict.certain) continue;
      const Verdict v = meets(wide_.shapes[static_cast<std::size_t>(closer[i].shape)], reached[i], beside);
      taken[i] = v.value || !v.certain;
      either[i] = !v.certain;
    }
    background_possible = !add_nearest(taken) || background_possible;
    for (std::size_t i = 0; i < closer.size(); ++i)
      taken[i] = taken[i] && !either[i];
    background_possible = !add_nearest(taken) || background_possible;
  }
  return out;
}

Verdict Oracle::State::beyond_far(Visible &seen, Ray &ray, bool &escalated) const {
  if (!has_far_) return {false, true};
  const auto test = [](const auto &far2, const auto &dir, const auto &hit) {
    return judge<1>({sign_of(dot(dir, dir) * (hit.num * hit.num) - far2 * (hit.den * hit.den))},
                    [](const auto &s) { return s[0] > 0; });
  };
  const Verdict rough = test(ball_.far2, ray.line.dir, seen.hit);
  if (rough.certain) return rough;
  escalated = true;
  return test(wide_.far2, wide_line(ray).dir, wide_hit(seen, ray));
}

Verdict Oracle::State::is_lit(Visible &seen, Ray &ray, const Point<Ball> &p, std::size_t light,
                              bool &escalated) const {
  const auto receiver = static_cast<std::size_t>(seen.shape);
  const Sign eye_side = eye_sides_[receiver], own_light_side = light_side(seen.shape, light);
  const Vec<Ball> to_light = ball_.lights[light] * p.w - p.x;
  Verdict facing = faces(ball_.shapes[receiver], eye_side, own_light_side, p, to_light);
  if (!facing.certain) {
    escalated = true;
    const Point<Wide> exact = point_at(wide_line(ray), wide_hit(seen, ray));
    facing = faces(wide_.shapes[receiver], eye_side, own_light_side, exact,
                   wide_.lights[light] * exact.w - exact.x);
  }
  if (!facing.value && facing.certain) return facing;

  const Line<Ball> line(ball_.lights[light], to_light);
  bool blocked = false;
  std::vector<int> doubtful;
  const auto look_at = [&](int shape, double &) {
    if (shape == seen.shape) return true;
    const auto i = static_cast<std::size_t>(shape);
    const Verdict v = blocks(ball_.shapes[i], light_side(shape, light), line, p, to_light);
    if (!v.certain) doubtful.push_back(shape);
    blocked = blocked || (v.value && v.certain);
    return !blocked;
  };
  double unused = 0;
  for (int shape : planes_) {
    if (!blocked) look_at(shape, unused);
  }
  if (!blocked) {
    const Double3 from = doubles(ball_.lights[light]);
    const long double w = p.w.mid();
    const Double3 along{static_cast<double>(-to_light.x.mid() / w),
                        static_cast<double>(-to_light.y.mid() / w),
                        static_cast<double>(-to_light.z.mid() / w)};
    tree_.walk(from, along, -1e-9, 1 + 1e-9, look_at);
  }
  if (blocked) return {false, true};
  if (doubtful.empty()) return facing;
  escalated = true;
  const Verdict b = blocked_wide(doubtful, point_at(wide_line(ray), wide_hit(seen, ray)), light);
  if (b.certain && b.value) return {false, true};
  return {facing.value && !b.value, facing.certain && b.certain};
}

Verdict Oracle::State::blocked_wide(const std::vector<int> &doubtful, const Point<Wide> &p,
                                    std::size_t light) const {
  const Vec<Wide> to_light = wide_.lights[light] * p.w - p.x;
  const Line<Wide> line(wide_.lights[light], to_light);
  const auto ask = [&](int shape, const Line<Wide> &along) {
    return blocks(wide_.shapes[static_cast<std::size_t>(shape)], light_side(shape, light), along, p,
                  to_light);
  };
  bool by_rule = false;
  std::vector<int> tied;
  for (int shape : doubtful) {
    const Verdict v = ask(shape, line);
    if (v.certain && v.value) return v;
    if (!v.certain) tied.push_back(shape);
    by_rule = by_rule || v.value;
  }
  if (tied.empty()) return {false, true};
  /* As for eye rays: a line along a shared edge cannot slip between the polygons. */
  bool other = false;
  for (int k = 0; k < nudge_count && !other; ++k) {
    const Line<Wide> beside = nudged(line, k);
    bool can_block = false, can_pass = true;
    for (int shape : tied) {
      const Verdict v = ask(shape, beside);
      can_block = can_block || v.value || !v.certain;
      can_pass = can_pass && (!v.value || !v.certain);
    }
    other = by_rule ? can_pass : can_block;
  }
  return {by_rule, !other};
}

void Oracle::State::shade(Visible &seen, Ray &ray, std::vector<OracleAnswer> &answers,
                          bool &escalated) const {
  const auto index = static_cast<std::size_t>(seen.shape);
  const Shape<Ball> &shape = ball_.shapes[index];
  const Surface &surface = surfaces_[index];
  const Point<Ball> p = point_at(ray.line, seen.hit);

  const std::size_t n = ball_.lights.size();
  std::vector<bool> lit(n);
  std::vector<long double> strength(n); /* cosine times falloff */
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < n; ++i) {
    const Verdict v = is_lit(seen, ray, p, i, escalated);
    lit[i] = v.value;
    if (!v.certain) open.push_back(i);
    if (!v.value && v.certain) continue;
    const Vec<Ball> to_light = ball_.lights[i] * p.w - p.x;
    const Vec<Ball> normal = shape.kind == Kind::sphere ? p.x - shape.center * p.w : shape.normal;
    const long double normal_length =
        shape.kind == Kind::sphere ? surface.normal_length * p.w.mid() : surface.normal_length;
    const long double length = root(dot(to_light, to_light)).mid();
    const long double distance = length / p.w.mid();
    const long double cosine = std::fabs(dot(normal, to_light).mid()) / (normal_length * length);
    strength[i] = length > 0 ? (inverse_square_ && !directional_[i] ? cosine / (distance * distance) : cosine) : 0;
  }

  OracleAnswer answer;
  answer.object = surface.object;
  answer.depth = static_cast<double>(seen.hit.num.mid() / seen.hit.den.mid() * depth_factor_);
  const std::vector<bool> by_rule = lit;
  const std::size_t free = std::min<std::size_t>(open.size(), 6);
  for (std::size_t flips = 0; flips < (std::size_t{1} << free); ++flips) {
    lit = by_rule;
    for (std::size_t i = 0; i < free; ++i)
      lit[open[i]] = by_rule[open[i]] != ((flips >> i & 1) != 0);
    Channels sum = ambient_;
    answer.lit = 0;
    answer.any_light = false;
    for (std::size_t i = 0; i < n; ++i) {
      if (!lit[i]) continue;
      answer.any_light = true;
      if (i < 32) answer.lit |= std::uint32_t{1} << i;
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += light_colours_[i][k] * strength[i];
    }
    if (surface.layered) {
      Real3 point = middles(p.x);
      for (long double &c : point)
        c /= p.w.mid();
      sum = radiance_.surface(surface.shape, point, middles(ray.line.dir), lit);
    } else {
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] *= surface.albedo[k];
    }
    for (std::size_t k = 0; k < 3; ++k)
      answer.colour[k] = level(sum[k]);
    add_answer(answers, answer);
  }
}

OraclePixel Oracle::State::pixel(int x, int y, double dx, double dy) const {
  const long double a = 2.0L * x + 1 - width_, b = height_ - 2.0L * y - 1;
  Ray ray{a, b, 2.0L * dx, 2.0L * dy, Line<Ball>({}, {}), std::nullopt};
  ray.line = make_line(ball_, ray);

  OraclePixel out;
  OracleAnswer background;
  const Real3 sky = radiance_.background(middles(ray.line.dir));
  for (std::size_t k = 0; k < 3; ++k)
    background.colour[k] = level(sky[k]);
  bool background_possible = false, background_first = false;
  std::vector<Visible> seen = visible(ray, out.escalated, background_possible, background_first);
  if (background_first) add_answer(out.answers, background);
  for (Visible &v : seen) {
    const Verdict beyond = beyond_far(v, ray, out.escalated);
    if (beyond.value)
      add_answer(out.answers, background);
    else
      shade(v, ray, out.answers, out.escalated);
    background_possible = background_possible || !beyond.certain;
  }
  if (background_possible) add_answer(out.answers, background);
  out.tie = out.answers.size() > 1;
  return out;
}

std::vector<OracleSurface> Oracle::State::surfaces(int x, int y) const {
  const Ray ray{2.0L * x + 1 - width_, height_ - 2.0L * y - 1, 0, 0, Line<Ball>({}, {}), std::nullopt};
  const Line<Ball> line = make_line(ball_, ray);
  const long double length = root(dot(line.dir, line.dir)).mid(), far = root(ball_.far2).mid();
  std::vector<std::pair<int, OracleSurface>> found;
  const auto look_at = [&](int shape, double &) {
    const auto i = static_cast<std::size_t>(shape);
    Hit<Ball> hit;
    if (meets(ball_.shapes[i], reaches(ball_.shapes[i], eye_sides_[i], line, hit), line).value) {
      const long double t = hit.num.mid() / hit.den.mid();
      if (!has_far_ || t * length <= far)
        found.push_back({shape, {surfaces_[i].object, static_cast<double>(t * depth_factor_)}});
    }
    return true;
  };
  double unused = 0;
  for (int shape : planes_)
    look_at(shape, unused);
  tree_.walk(doubles(line.apex), doubles(line.dir), 0, HUGE_VAL, look_at);
  std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
  std::vector<OracleSurface> out;
  for (const auto &[shape, surface] : found)
    out.push_back(surface);
  return out;
}

Oracle::Oracle(const SceneFile &scene, int width, int height)
    : state_(std::make_unique<State>(scene, width, height)) {}

Oracle::~Oracle() = default;

OraclePixel Oracle::pixel(int x, int y, double dx, double dy) const {
  return state_->pixel(x, y, dx, dy);
}

std::vector<OracleSurface> Oracle::surfaces(int x, int y) const {
  return state_->surfaces(x, y);
}

} // namespace host
