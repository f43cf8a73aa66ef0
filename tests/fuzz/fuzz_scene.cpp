/* Scenes, cameras and rays of any bits: refused, or rendered the same in any strips and in agreement with fc_pick. */
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "fixcast/fixcast.h"
#include "fuzz.h"

namespace {

using fuzz::Exact;

/* Values that libFuzzer would be long in finding: any bits, or near a limit, or near a value used before, for
 * tangents, shared planes and ties. Unless `wild`, they are brought into their documented ranges. */
class Values {
public:
  Values(fuzz::Bytes &in, bool wild) : in_(in), wild_(wild) {}

  std::int32_t coordinate() {
    const std::uint8_t how = in_.u8();
    std::int64_t v = 0;
    if (how < 128) {
      v = static_cast<std::int32_t>(in_.u32());
      if (how >= 32) v >>= how % 32; /* of any length */
    } else if (how < 176) {
      v = (used_.empty() ? 0 : std::int64_t{used_[in_.u8() % used_.size()]} * (how & 1 ? -1 : 1)) +
          (how - 152) / 8;
    } else if (how < 240) {
      v = how - 208;
    } else {
      v = (how & 1 ? -1 : 1) * std::int64_t{FC_COORDINATE_MAX - in_.u8() % 4};
    }
    if (!wild_) v = std::clamp<std::int64_t>(v, -FC_COORDINATE_MAX, FC_COORDINATE_MAX);
    used_.push_back(static_cast<std::int32_t>(std::clamp<std::int64_t>(v, INT32_MIN, INT32_MAX)));
    return used_.back();
  }
  fc_vec3 vector() {
    const std::int32_t x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }
  std::int8_t exponent(int low, int high) {
    const std::uint8_t v = in_.u8();
    if (wild_) return static_cast<std::int8_t>(v);
    return static_cast<std::int8_t>(v < 128 ? std::clamp(0, low, high) : low + v % (high - low + 1));
  }
  std::uint16_t index(std::size_t count) {
    if (wild_) return in_.u8() & 0x80 ? in_.u16() : in_.u8();
    return static_cast<std::uint16_t>(count == 0 ? 0 : in_.u8() % count);
  }
  fc_rgb colour() {
    const std::uint16_t r = in_.u16(), g = in_.u16(), b = in_.u16();
    return {r, g, b};
  }
  std::uint8_t choice(int count) { return wild_ ? in_.u8() : static_cast<std::uint8_t>(in_.u8() % count); }
  bool wild() const { return wild_; }

private:
  fuzz::Bytes &in_;
  bool wild_;
  std::vector<std::int32_t> used_;
};

/* Layers that a colour picks, again without bytes of their own. */
const fc_phong phong = {FC_GREY(0.5), 1280};
const fc_mirror mirror = {FC_GREY(0.75), 3};
const fc_emission emission = {FC_GREY(0.25), 2};
const fc_mapping planar = {&fc_mapping_planar, {1000, 0, -7}, {300000, 5, 0}, {0, 40, 2000000}, 0, 3, 255};
const fc_mapping spherical = {&fc_mapping_spherical, {}, {}, {}, 0, 7, 5};
const fc_mapping by_vertices = {&fc_mapping_vertices, {}, {}, {}, 0, 1, 1};
const fc_checker checker = {{FC_GREY(0.25), FC_GREY(1)}};
const std::uint8_t texels[3 * 2] = {0, 50, 255, 128, 200, 1};
const fc_image image = {texels, 3, 2, FC_TEXEL_GREY8, 1, 0};
const fc_texture checkered = {&planar, &fc_texture_checker, &checker, 0}, round = {&spherical, &fc_texture_image, &image, 1},
                 cornered = {&by_vertices, &fc_texture_image, &image, 0};
const fc_layer shiny[] = {{&fc_layer_smooth, nullptr}, {&fc_layer_texture, &checkered}, {&fc_layer_phong, &phong}, {&fc_layer_mirror, &mirror}};
const fc_layer glowing[] = {{&fc_layer_texture, &round}, {&fc_layer_emission, &emission}, {&fc_layer_mirror, &mirror}};
const fc_layer by_corners[] = {{&fc_layer_texture, &cornered}, {&fc_layer_phong, &phong}};
const fc_sky sky = {&fc_sky_gradient, {3, 70000, -1}, FC_GREY(0.5)};

fc_material material_of(const fc_rgb &colour) {
  switch (colour.r % 8) {
    case 1: return {colour, 4, shiny};
    case 3: return {colour, 3, glowing};
    case 5: return {colour, 2, by_corners};
    default: return {colour, 0, nullptr};
  }
}

/* A scene whose tables each have a heap block of exactly their size. */
class Scene {
public:
  Scene(fuzz::Bytes &in, Values &values)
      : spheres_(in.u8() % 5),
        planes_(in.u8() % 4),
        vertices_(in.u8() % 7),
        triangles_(in.u8() % 5),
        materials_(values.wild() ? in.u8() % 3 : 1 + in.u8() % 2),
        lights_(in.u8() % 4),
        shapes_(in.u8() % 5) {
    for (std::size_t i = 0; i < spheres_.count(); i++) {
      spheres_[i] = {values.vector(), values.coordinate(), values.index(materials_.count()), in.u8()};
      if (!values.wild()) spheres_[i].radius = std::max(1, std::abs(spheres_[i].radius));
    }
    for (std::size_t i = 0; i < planes_.count(); i++) {
      planes_[i].normal = values.vector();
      if (!values.wild() && (planes_[i].normal.x | planes_[i].normal.y | planes_[i].normal.z) == 0)
        planes_[i].normal.y = 1;
      planes_[i].d = values.coordinate();
      planes_[i].d_exponent = values.exponent(0, 32);
      planes_[i].material = values.index(materials_.count());
      planes_[i].object = in.u8();
    }
    for (std::size_t i = 0; i < vertices_.count(); i++) vertices_[i] = values.vector();
    for (std::size_t i = 0; i < triangles_.count(); i++) {
      for (std::uint16_t &vertex : triangles_[i].vertex) vertex = values.index(vertices_.count());
      triangles_[i].material = values.index(materials_.count());
      triangles_[i].object = in.u8();
    }
    for (std::size_t i = 0; i < materials_.count(); i++) materials_[i] = material_of(values.colour());
    for (std::size_t i = 0; i < lights_.count(); i++) {
      lights_[i].position = values.vector();
      lights_[i].intensity = values.colour();
      lights_[i].exponent = values.exponent(-31, 32);
      lights_[i].intensity_exponent = values.exponent(-40, 40);
      lights_[i].inverse_square = in.u8();
      lights_[i].directional = lights_[i].inverse_square == 3; /* no bytes of its own: stored inputs keep their meaning */
      if (lights_[i].directional) lights_[i].inverse_square = lights_[i].exponent = 0;
    }
    for (std::size_t i = 0; i < shapes_.count(); i++) add_table(in, values, shapes_[i]);
    scene.shapes = shapes_.get();
    scene.materials = materials_.get();
    scene.lights = lights_.get();
    scene.shape_count = static_cast<std::uint16_t>(shapes_.count());
    scene.material_count = static_cast<std::uint16_t>(materials_.count());
    scene.light_count = static_cast<std::uint16_t>(lights_.count());
    scene.exponent = values.exponent(-60, 60);
    scene.far_exponent = values.exponent(-31, 32);
    scene.far_limit = values.coordinate();
    if (!values.wild()) scene.far_limit = scene.far_limit % 2 == 0 ? 0 : std::abs(scene.far_limit);
    scene.ambient = values.colour();
    scene.background = values.colour();
    if (scene.background.r % 4 == 1) scene.sky = &sky;
    if (values.wild() && in.u8() == 1) scene.shapes = nullptr;
    if (values.wild() && in.u8() == 1) scene.materials = nullptr;
    if (values.wild() && in.u8() == 1) scene.lights = nullptr;
  }

  fc_scene scene{};

private:
  /* A table may be used more than once, and in part. */
  void add_table(fuzz::Bytes &in, Values &values, fc_shapes &shapes) {
    const std::uint8_t kind = in.u8(), part = in.u8();
    shapes = {};
    if (kind % 3 == 0) {
      shapes.kind = &fc_kind_sphere;
      shapes.items = spheres_.get();
      shapes.count = static_cast<std::uint16_t>(spheres_.count());
    } else if (kind % 3 == 1) {
      shapes.kind = &fc_kind_plane;
      shapes.items = planes_.get();
      shapes.count = static_cast<std::uint16_t>(planes_.count());
    } else {
      shapes.kind = &fc_kind_triangle;
      shapes.items = triangles_.get();
      shapes.vertices = vertices_.get();
      shapes.vertex_count = static_cast<std::uint16_t>(vertices_.count());
      if (vertices_.count() > 0 || values.wild())
        shapes.count = static_cast<std::uint16_t>(triangles_.count());
    }
    if (part & 0x80) shapes.count = static_cast<std::uint16_t>(shapes.count / 2);
    if (values.wild() && part == 1) shapes.kind = nullptr;
    if (values.wild() && part == 2) shapes.items = nullptr;
    if (values.wild() && part == 3) shapes.vertices = nullptr;
  }

  Exact<fc_sphere> spheres_;
  Exact<fc_plane> planes_;
  Exact<fc_vec3> vertices_;
  Exact<fc_triangle> triangles_;
  Exact<fc_material> materials_;
  Exact<fc_light> lights_;
  Exact<fc_shapes> shapes_;
};

fc_camera any_camera(fuzz::Bytes &in, Values &values) {
  fc_camera camera{};
  camera.eye = values.vector();
  camera.target = values.vector();
  camera.up = values.vector();
  camera.exponent = values.exponent(-31, 31);
  camera.fov_rule = values.choice(2);
  if (values.wild()) {
    camera.tan_half_fov_numerator = in.u32();
    camera.tan_half_fov_denominator = in.u32();
  } else {
    camera.tan_half_fov_numerator = 1 + (in.u32() >> 1 >> in.u8() % 31);
    camera.tan_half_fov_denominator = 1 + (in.u32() >> 1 >> in.u8() % 31);
  }
  return camera;
}

fc_options any_options(Values &values) {
  fc_options options{};
  options.offset_rule = values.choice(4);
  options.depth_exponent_bits = values.choice(4);
  if (!values.wild() && options.depth_exponent_bits != 0) options.depth_exponent_bits++;
  options.epsilon_exponent = values.exponent(-31, 31);
  options.epsilon = values.coordinate();
  if (!values.wild()) options.epsilon = std::abs(options.epsilon);
  return options;
}

/* A second opinion on fc_blocked, in plain 128-bit arithmetic. 1 blocked, 0 not, -1: too large to tell here. */
__extension__ typedef __int128 Wide;

struct Point {
  explicit Point(const fc_vec3 &v) : x(v.x), y(v.y), z(v.z) {}
  Point(std::int64_t a, std::int64_t b, std::int64_t c) : x(a), y(b), z(c) {}
  std::int64_t x, y, z;
};

Point operator-(const Point &a, const Point &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Wide dot(const Point &a, const Point &b) { return Wide{a.x} * b.x + Wide{a.y} * b.y + Wide{a.z} * b.z; }
int sign(Wide v) { return (v > 0) - (v < 0); }

Wide determinant(const Point &a, const Point &b, const Point &c) {
  return Wide{a.x} * (Wide{b.y} * c.z - Wide{b.z} * c.y) + Wide{a.y} * (Wide{b.z} * c.x - Wide{b.x} * c.z) +
         Wide{a.z} * (Wide{b.x} * c.y - Wide{b.y} * c.x);
}

int sphere_blocks(const fc_sphere &sphere, const Point &from, const Point &to) {
  const Point center(sphere.center), p = from - center, q = to - center, d = to - from;
  for (const std::int64_t v : {p.x, p.y, p.z, q.x, q.y, q.z, d.x, d.y, d.z, std::int64_t{sphere.radius}})
    if (std::abs(v) >= INT64_C(1) << 30) return -1;
  const Wide square = Wide{sphere.radius} * sphere.radius;
  const Wide at_from = dot(p, p) - square, at_to = dot(q, q) - square, length = dot(d, d), along = dot(p, d);
  if (length == 0) return -1;
  if (sign(at_from) * sign(at_to) < 0) return 1;
  if (at_from == 0 && at_to == 0) return 0; /* a chord */
  if (at_from < 0 || at_to < 0) return 0;
  return along < 0 && -along < length && along * along >= length * at_from;
}

int plane_blocks(const fc_plane &plane, const Point &from, const Point &to) {
  const Point normal(plane.normal);
  const Wide d = Wide{plane.d} * (Wide{1} << plane.d_exponent);
  return sign(dot(normal, from) + d) * sign(dot(normal, to) + d) < 0;
}

int triangle_blocks(const fc_vec3 *vertices, const fc_triangle &triangle, const Point &from,
                    const Point &to) {
  const Point a = Point(vertices[triangle.vertex[0]]) - from, b = Point(vertices[triangle.vertex[1]]) - from,
              c = Point(vertices[triangle.vertex[2]]) - from, d = to - from;
  if (sign(determinant(a, b, c)) * sign(determinant(a - d, b - d, c - d)) >= 0) return 0;
  const int ab = sign(determinant(a, b, d)), bc = sign(determinant(b, c, d)), ca = sign(determinant(c, a, d));
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

int expect_blocked(const fc_scene &scene, const fc_vec3 &from, const fc_vec3 &to) {
  int expected = 0;
  for (int table = 0; table < scene.shape_count; table++) {
    const fc_shapes &shapes = scene.shapes[table];
    for (int i = 0; i < shapes.count; i++) {
      int one = 0;
      if (shapes.kind == &fc_kind_sphere)
        one = sphere_blocks(static_cast<const fc_sphere *>(shapes.items)[i], Point(from), Point(to));
      else if (shapes.kind == &fc_kind_plane)
        one = plane_blocks(static_cast<const fc_plane *>(shapes.items)[i], Point(from), Point(to));
      else
        one = triangle_blocks(static_cast<const fc_vec3 *>(shapes.vertices), static_cast<const fc_triangle *>(shapes.items)[i], Point(from),
                              Point(to));
      if (one == 1) return 1;
      if (one < 0) expected = -1;
    }
  }
  return expected;
}

struct Picture {
  explicit Picture(std::size_t size) : pixels(3 * size), depth(size), primitive(size), lit(size) {}
  Exact<std::uint8_t> pixels;
  Exact<std::uint16_t> depth, primitive;
  Exact<std::uint32_t> lit;
};

/* Both fields, where it is drawn by fields. */
void render(const fc_frame &frame, std::uint16_t width, std::uint16_t y, std::uint16_t rows, const Picture &to) {
  fc_target target{};
  target.pixels = to.pixels.get();
  target.pitch_bytes = width * std::size_t{3};
  target.format = FC_RGB888;
  target.depth = to.depth.get();
  target.primitive = to.primitive.get();
  target.lit = to.lit.get();
  CHECK(fc_render_profile(&frame, 0, y, rows, &target) == FC_OK);
  CHECK(frame.options.profile != FC_PROFILE_INTERLACED || fc_render_profile(&frame, 1, y, rows, &target) == FC_OK);
}

template <typename T>
void check_part(const Exact<T> &whole, std::size_t first, const Exact<T> &part) {
  CHECK(std::memcmp(whole.get() + first, part.get(), part.bytes()) == 0);
}

std::uint32_t count_primitives(const fc_scene &scene) {
  std::uint32_t count = 0;
  for (int i = 0; i < scene.shape_count; i++) count += scene.shapes[i].count;
  return count;
}

void check_hit(const fc_scene &scene, const fc_hit &hit) {
  CHECK(hit.primitive < count_primitives(scene));
  for (const std::int32_t c : {hit.position.x, hit.position.y, hit.position.z})
    CHECK(std::abs(c) <= FC_COORDINATE_MAX);
  for (const std::int32_t c : {hit.normal_q30.x, hit.normal_q30.y, hit.normal_q30.z})
    CHECK(std::abs(std::int64_t{c}) <= (INT64_C(1) << 30) + 4);
  const std::uint64_t weights =
      std::uint64_t{hit.barycentric_q30[0]} + hit.barycentric_q30[1] + hit.barycentric_q30[2];
  CHECK(weights == 0 || (weights + 4 >= UINT64_C(1) << 30 && weights <= (UINT64_C(1) << 30) + 4));
}

/* The position of a pick against eye + depth * direction, where the depth is not saturated. */
void check_position(const fc_frame &frame, std::uint16_t x, std::uint16_t y, const fc_hit &hit) {
  if (hit.t_q32 == UINT64_MAX) return;
  const fc_view &view = frame.view;
  if (frame.options.profile == FC_PROFILE_HALF) {
    x /= 2;
    y /= 2;
  }
  const long double half = std::ldexp(1.0L, view.pixel_shift), focal = view.focal;
  const long double across[3] = {(2 * x + 1 - frame.width) * half / focal,
                                 (frame.height - 2 * y - 1) * half / focal, 1};
  const long double depth = std::ldexp(static_cast<long double>(hit.t_q32), -32);
  const long double distance = depth * std::hypot(across[0], across[1], 1.0L);
  const long double allowed = 2 + distance * 0x1p-28L;
  const std::int32_t position[3] = {hit.position.x, hit.position.y, hit.position.z};
  for (int i = 0; i < 3; i++) {
    long double expected = std::ldexp(static_cast<long double>(view.eye[i]), -view.fine);
    for (int j = 0; j < 3; j++) expected += std::ldexp(view.row[j][i] * across[j] * depth, -30);
    const long double limit = FC_COORDINATE_MAX;
    CHECK(std::fabs(std::clamp(expected, -limit, limit) - position[i]) <= allowed);
  }
}

void check_pixel(const fc_scene &scene, const fc_frame &frame, const Picture &picture, std::uint16_t width, std::uint16_t x,
                 std::uint16_t y) {
  const std::size_t i = static_cast<std::size_t>(y) * width + x;
  fc_hit hit{}, again{};
  std::uint32_t lit = 0;
  const int got = fc_pick(&frame, x, y, &hit, &lit);
  CHECK(got == 0 || got == 1);
  CHECK(got == (picture.primitive[i] != 0xffff) && got == (picture.depth[i] != 0));
  CHECK(lit == picture.lit[i] || frame.options.profile == FC_PROFILE_FAST);
  CHECK(fc_pick(&frame, x, y, &again, nullptr) == got);
  if (got == 0) return;
  CHECK(hit.primitive == picture.primitive[i] && hit.object == fc_object(&frame, hit.primitive));
  CHECK(hit.primitive == again.primitive && hit.t_q32 == again.t_q32);
  check_hit(scene, hit);
  check_position(frame, x, y, hit);
}

void render_all(fuzz::Bytes &in, Values &values, const fc_scene &scene) {
  const fc_camera camera = any_camera(in, values);
  fc_options options = any_options(values);
  const std::uint8_t size = in.u8();
  const bool any_size = values.wild() && in.u8() == 1;
  const auto width = static_cast<std::uint16_t>(any_size ? in.u16() : 1 + size % 8);
  const auto height = static_cast<std::uint16_t>(any_size ? in.u16() : 1 + size / 8 % 8);
  int error = FC_OK;
  options.profile = size >> 6;
  const std::size_t bytes = fc_frame_memory(&scene, &error);
  CHECK(error == fc_scene_check(&scene));
  const Exact<std::uint8_t> memory(bytes);
  fc_frame frame;
  error = fc_frame_setup(&frame, &scene, &camera, &options, width, height, memory.get(), memory.bytes());
  CHECK(error <= 0 && error >= FC_ERR_LENS);
  if (error != FC_OK || width > 8 || height > 8) return;
  if (bytes > 0) {
    fc_frame unused;
    CHECK(fc_frame_setup(&unused, &scene, &camera, &options, width, height, memory.get(), bytes - 1) ==
          FC_ERR_MEMORY);
  }
  const Picture whole(static_cast<std::size_t>(width) * height);
  render(frame, width, 0, height, whole);
  const auto strip = static_cast<std::uint16_t>(1 + in.u8() % height);
  for (std::uint16_t y = 0; y < height; y = static_cast<std::uint16_t>(y + strip)) {
    const auto rows = std::min(strip, static_cast<std::uint16_t>(height - y));
    const Picture part(static_cast<std::size_t>(width) * rows);
    render(frame, width, y, rows, part);
    const std::size_t first = static_cast<std::size_t>(y) * width;
    check_part(whole.pixels, 3 * first, part.pixels);
    check_part(whole.depth, first, part.depth);
    check_part(whole.primitive, first, part.primitive);
    check_part(whole.lit, first, part.lit);
  }
  for (std::uint16_t y = 0; y < height; y++)
    for (std::uint16_t x = 0; x < width; x++) check_pixel(scene, frame, whole, width, x, y);
}

void shoot(fuzz::Bytes &in, Values &values, const fc_scene &scene) {
  fc_ray ray{};
  ray.origin = values.vector();
  ray.direction = values.vector();
  const std::uint8_t limits = in.u8();
  ray.t_min_q32 = limits & 1 ? in.u64() : 0;
  ray.t_max_q32 = limits & 2 ? in.u64() : UINT64_MAX;
  fc_hit hit{};
  const int got = fc_intersect(&scene, &ray, &hit);
  CHECK(got <= 1 && (got >= 0 || got == FC_ERR_COORDINATE || got == FC_ERR_DIRECTION));
  if (got == 1) {
    check_hit(scene, hit);
    CHECK(hit.t_q32 >= ray.t_min_q32 && (hit.t_q32 <= ray.t_max_q32 || ray.t_max_q32 >> 63 != 0));
    for (int rule = -1; rule <= 4; rule++) {
      fc_vec3 point{};
      const std::int32_t epsilon = values.coordinate();
      const int error = fc_offset(&scene, &hit, rule, epsilon, &point);
      const bool right = rule >= 0 && rule <= 3 && epsilon >= 0 && epsilon <= FC_COORDINATE_MAX;
      CHECK((error == FC_OK) == right);
    }
  }
  /* A segment has no direction. */
  const fc_vec3 from = values.vector(), to = values.vector();
  const int blocked = fc_blocked(&scene, &from, &to);
  CHECK(blocked == 0 || blocked == 1 || blocked == FC_ERR_COORDINATE);
  CHECK(fc_blocked(&scene, &to, &from) == blocked);
  if (blocked < 0) return;
  const int expected = expect_blocked(scene, from, to);
  CHECK(expected < 0 || blocked == expected);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t count) {
  fuzz::Bytes in(data, count);
  Values values(in, (in.u8() & 1) != 0);
  const Scene made(in, values);
  render_all(in, values, made.scene);
  if (fc_scene_check(&made.scene) != FC_OK) return 0;
  for (int rays = 0; rays < 8 && !in.empty(); rays++) shoot(in, values, made.scene);
  return 0;
}
