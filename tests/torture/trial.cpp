/* Scenes and frames of the core built from the oracle's shapes, and every value of a hit compared. */
#include "trial.h"

#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "fixcast/error.h"

using oracle::Q;
using oracle::Z;

static const fc_material white = {{FC_ONE_Q15, FC_ONE_Q15, FC_ONE_Q15}, 0, NULL};

static std::string vprint(const char *format, va_list arguments) {
  char buffer[4096];
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  return buffer;
}

std::string print(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  std::string text = vprint(format, arguments);
  va_end(arguments);
  return text;
}

void fail(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  Failure failure = {vprint(format, arguments)};
  va_end(arguments);
  throw failure;
}

Scene::Scene(const std::vector<oracle::Shape> &list) : shapes(list) {
  /* no reallocation: tables point into these */
  spheres_.reserve(list.size());
  planes_.reserve(list.size());
  triangles_.reserve(list.size());
  vertices_.reserve(3 * list.size());
  std::memset(&scene, 0, sizeof scene);
  size_t table_start = 0;
  for (size_t i = 0; i < list.size(); i++) {
    const oracle::Shape &s = list[i];
    uint16_t object = static_cast<uint16_t>(i + 1);
    bool same = i > 0 && list[i - 1].kind == s.kind;
    fc_shapes table;
    std::memset(&table, 0, sizeof table);
    if (s.kind == oracle::Shape::sphere) {
      spheres_.push_back({to_core(s.a), static_cast<int32_t>(s.r), 0, object});
      table.kind = &fc_kind_sphere;
      table.items = &spheres_.back();
    } else if (s.kind == oracle::Shape::plane) {
      int64_t d = -s.r;
      int8_t exponent = 0;
      while (std::llabs(d) > coordinate_max) {
        if (d & 1) fail("test: plane offset %lld cannot be written", static_cast<long long>(s.r));
        d /= 2;
        exponent++;
      }
      planes_.push_back({to_core(s.a), static_cast<int32_t>(d), exponent, 0, object});
      table.kind = &fc_kind_plane;
      table.items = &planes_.back();
    } else {
      if (!same) table_start = vertices_.size();
      uint16_t first = static_cast<uint16_t>(vertices_.size() - table_start);
      fc_triangle t = {
          {first, static_cast<uint16_t>(first + 1), static_cast<uint16_t>(first + 2)}, 0, object};
      vertices_.push_back(to_core(s.a));
      vertices_.push_back(to_core(s.b));
      vertices_.push_back(to_core(s.c));
      triangles_.push_back(t);
      table.kind = &fc_kind_triangle;
      table.items = &triangles_.back();
      table.vertices = &vertices_[vertices_.size() - 3];
    }
    if (!same) tables_.push_back(table);
    tables_.back().count++;
    if (s.kind == oracle::Shape::triangle)
      tables_.back().vertex_count = static_cast<uint16_t>(tables_.back().vertex_count + 3);
  }
  scene.shapes = tables_.data();
  scene.shape_count = static_cast<uint16_t>(tables_.size());
  scene.materials = &white;
  scene.material_count = 1;
  int status = fc_scene_check(&scene);
  if (status != FC_OK) fail("test: scene refused (%s):%s", fc_error_text(status), text().c_str());
}

std::string Scene::text() const {
  std::string all;
  for (size_t i = 0; i < shapes.size() && i < 40; i++) all += print("\n  %zu: ", i) + oracle::text(shapes[i]);
  if (shapes.size() > 40) all += "\n  ...";
  return all;
}

static std::string ray_text(Vec origin, Vec direction, uint64_t t_min_q32, uint64_t t_max_q32) {
  return "ray from " + oracle::text(origin) + " along " + oracle::text(direction) +
         print(", t_q32 %llu .. %llu", static_cast<unsigned long long>(t_min_q32),
               static_cast<unsigned long long>(t_max_q32));
}

int shoot(const Scene &scene, Vec origin, Vec direction, fc_hit *hit, uint64_t t_min_q32,
          uint64_t t_max_q32) {
  fc_ray ray = {to_core(origin), to_core(direction), t_min_q32, t_max_q32};
  int result = fc_intersect(&scene.scene, &ray, hit);
  if (result < 0)
    fail("fc_intersect: %s\n  %s%s", fc_error_text(result),
         ray_text(origin, direction, t_min_q32, t_max_q32).c_str(), scene.text().c_str());
  return result;
}

/* |value - exact| <= bound, all in the same unit */
static bool within(const Q &value, const Q &exact, const Q &bound) { return abs(Q(value - exact)) <= bound; }

static Q power_of_two(int e) {
  return e >= 0 ? Q(Z(1) << static_cast<unsigned>(e)) : Q(Z(1), Z(1) << static_cast<unsigned>(-e));
}

/* What is wrong with the values of a hit, or nothing. */
static std::string wrong_values(const fc_hit &hit, const oracle::Shape &s, const oracle::Root &root,
                                Vec origin, Vec direction) {
  oracle::Point point = oracle::point_at(root, origin, direction);
  Q t = oracle::approximate(root) * power_of_two(32), slack = power_of_two(-60);
  /* rounded to nearest, and the value's own relative error of 2^-58 */
  if (!within(Q(Z(static_cast<unsigned long>(hit.t_q32))), t, Q(Q(1, 2) + t * power_of_two(-58) + slack)))
    return print("t_q32 is %.3f", Q(t).get_d()) +
           print(" (%llu reported)", static_cast<unsigned long long>(hit.t_q32));
  Vec position = from_core(hit.position), normal = from_core(hit.normal_q30);
  for (int i = 0; i < 3; i++) {
    Q exact = oracle::coordinate(point, i);
    bool clamped = std::llabs(position[i]) == coordinate_max && abs(exact) >= coordinate_max &&
                   sgn(exact) * position[i] > 0;
    if (!clamped && !within(static_cast<long>(position[i]), exact, Q(1 + slack)))
      return print("position's axis %d is %.6f (%lld reported)", i, exact.get_d(),
                   static_cast<long long>(position[i]));
    Q bound = power_of_two(-28), n = oracle::normal_component(s, direction, point, i);
    if (s.kind == oracle::Shape::sphere) bound += Q(2, static_cast<unsigned long>(s.r));
    if (!within(Q(Q(static_cast<long>(normal[i])) * power_of_two(-30)), n, bound))
      return print("normal's axis %d is %.12f (%lld / 2^30 = %.12f reported)", i, n.get_d(),
                   static_cast<long long>(normal[i]), static_cast<double>(normal[i]) / 1073741824.0);
    Q part = s.kind == oracle::Shape::triangle ? oracle::weight(s, origin, direction, i) : Q(0);
    if (!within(Q(Q(static_cast<unsigned long>(hit.barycentric_q30[i])) * power_of_two(-30)), part,
                power_of_two(-29)))
      return print("weight %d is %.12f (%lu / 2^30 reported)", i, part.get_d(),
                   static_cast<unsigned long>(hit.barycentric_q30[i]));
  }
  if (hit.inside != oracle::from_inside(s, direction, point)) return print("inside is %d", !hit.inside);
  return "";
}

int check_ray(const Scene &scene, Vec origin, Vec direction, uint64_t t_min_q32, uint64_t t_max_q32) {
  fc_hit hit;
  oracle::Root root;
  int result = shoot(scene, origin, direction, &hit, t_min_q32, t_max_q32);
  int expected = oracle::nearest(scene.shapes, origin, direction, t_min_q32, t_max_q32, &root);
  std::string wrong;
  if ((result == 1 ? hit.primitive : -1) != expected)
    wrong = print("primitive is %d (%d reported)", expected, result == 1 ? hit.primitive : -1);
  else if (expected >= 0)
    wrong = wrong_values(hit, scene.shapes[static_cast<size_t>(expected)], root, origin, direction);
  if (!wrong.empty())
    fail("fc_intersect: %s\n  %s%s", wrong.c_str(), ray_text(origin, direction, t_min_q32, t_max_q32).c_str(),
         scene.text().c_str());
  return expected;
}

void expect_ray(const Scene &scene, Vec origin, Vec direction, int primitive) {
  int result = check_ray(scene, origin, direction);
  if (result != primitive)
    fail("core and oracle agree on primitive %d, the family says %d\n  %s%s", result, primitive,
         ray_text(origin, direction, 0, UINT64_MAX).c_str(), scene.text().c_str());
}

bool check_segment(const Scene &scene, Vec from, Vec to) {
  fc_vec3 a = to_core(from), b = to_core(to);
  int result = fc_blocked(&scene.scene, &a, &b);
  oracle::Point point = oracle::point_of(from);
  bool expected = false;
  for (const oracle::Shape &s : scene.shapes) expected = expected || oracle::blocked(s, point, to);
  if (result != (expected ? 1 : 0))
    fail("fc_blocked: %d is right (%d reported)\n  from %s to %s%s", expected, result,
         oracle::text(from).c_str(), oracle::text(to).c_str(), scene.text().c_str());
  return expected;
}

void expect_segment(const Scene &scene, Vec from, Vec to, bool blocked) {
  if (check_segment(scene, from, to) != blocked)
    fail("core and oracle agree on blocked = %d, the family does not\n  from %s to %s%s", !blocked,
         oracle::text(from).c_str(), oracle::text(to).c_str(), scene.text().c_str());
}

int hits_alone(const Scene &scene, Vec origin, Vec direction) {
  int hits = 0;
  for (const oracle::Shape &s : scene.shapes) hits += check_ray(Scene({s}), origin, direction) == 0;
  return hits;
}

fc_camera to_core(const ExactCamera &c) {
  fc_camera r;
  Vec target = c.eye, up = {0, 0, 0};
  std::memset(&r, 0, sizeof r);
  target[c.axis] += c.sign;
  up[c.up_axis] = 1;
  r.eye = to_core(c.eye);
  r.target = to_core(target);
  r.up = to_core(up);
  r.tan_half_fov_numerator = c.width < c.height ? c.width : c.height;
  r.tan_half_fov_denominator = c.focal;
  return r;
}

fc_light light_at(Vec position, int exponent) {
  fc_light r;
  std::memset(&r, 0, sizeof r);
  r.position = to_core(position);
  r.exponent = static_cast<int8_t>(exponent);
  r.intensity.r = r.intensity.g = r.intensity.b = FC_ONE_Q15;
  return r;
}

Frame::Frame(const Scene &scene, const std::vector<fc_light> &list, const fc_camera &camera, uint16_t width,
             uint16_t height, int offset_rule)
    : world(scene), scene_(scene.scene), camera_(camera), lights_(list) {
  fc_options options;
  fc_space space;
  fc_cursor cursor;
  std::memset(&options, 0, sizeof options);
  options.offset_rule = static_cast<uint8_t>(offset_rule);
  scene_.lights = lights_.data();
  scene_.light_count = static_cast<uint16_t>(lights_.size());
  memory_.resize(fc_frame_memory(&scene_, nullptr) / sizeof(int64_t) + 1);
  int status = fc_frame_setup(&frame, &scene_, &camera_, &options, width, height, memory_.data(),
                              memory_.size() * sizeof(int64_t));
  refused = status == FC_ERR_LIGHT;
  if (refused) return;
  if (status != FC_OK) fail("fc_frame_setup: %s%s", fc_error_text(status), text().c_str());
  /* what camera space holds: the decisions are exact on these */
  space.scene = &frame.scene;
  space.memory = frame.memory;
  fc_cursor_start(&cursor, &space);
  while (fc_cursor_next(&cursor))
    for (uint16_t i = 0; i < cursor.group.shapes.count; i++) {
      fc_form form{};
      fc_kind_of(&cursor)->fetch(&cursor.group, i, &form);
      auto vec = [](const int64_t v[3]) { return Vec{v[0], v[1], v[2]}; };
      switch (world.shapes[shapes.size()].kind) {
        case oracle::Shape::sphere:
          shapes.push_back(oracle::sphere(vec(form.u.sphere.center), form.u.sphere.radius));
          break;
        case oracle::Shape::plane:
          shapes.push_back(oracle::plane(vec(form.u.plane.normal), form.u.plane.k));
          break;
        case oracle::Shape::triangle:
          shapes.push_back(oracle::triangle(vec(form.u.triangle.vertex[0]), vec(form.u.triangle.vertex[1]),
                                            vec(form.u.triangle.vertex[2])));
          break;
      }
    }
  for (size_t i = 0; i < lights_.size(); i++)
    lights.push_back({frame.lights[3 * i], frame.lights[3 * i + 1], frame.lights[3 * i + 2]});
}

std::string Frame::text() const {
  Vec eye = from_core(camera_.eye), target = from_core(camera_.target), up = from_core(camera_.up);
  std::string all =
      print("\n  %u x %u pixels, eye ", frame.width, frame.height) + oracle::text(eye) + " target " +
      oracle::text(target) + " up " + oracle::text(up) +
      print(" tan %lu / %lu, offset rule %d; world:",
            static_cast<unsigned long>(camera_.tan_half_fov_numerator),
            static_cast<unsigned long>(camera_.tan_half_fov_denominator), frame.options.offset_rule) +
      world.text() + "\n  camera space:";
  for (size_t i = 0; i < shapes.size() && i < 40; i++) all += print("\n  %zu: ", i) + oracle::text(shapes[i]);
  for (size_t i = 0; i < lights.size(); i++) all += print("\n  light %zu: ", i) + oracle::text(lights[i]);
  return all;
}

void Frame::render(uint16_t rows) {
  if (refused) fail("fc_frame_setup refuses a light%s", text().c_str());
  size_t pixels = static_cast<size_t>(frame.width) * frame.height;
  std::vector<uint8_t> colours(3 * pixels);
  depth.assign(pixels, 0);
  primitive.assign(pixels, 0);
  lit.assign(pixels, 0);
  for (uint32_t y = 0; y < frame.height; y += rows) {
    size_t first = static_cast<size_t>(y) * frame.width;
    uint16_t count = static_cast<uint16_t>(frame.height - y < rows ? frame.height - y : rows);
    fc_target target = {&colours[3 * first], 3u * frame.width, FC_RGB888,
                        &depth[first], &primitive[first], &lit[first]};
    int status = fc_render_rows(&frame, static_cast<uint16_t>(y), count, &target);
    if (status != FC_OK) fail("fc_render_rows: %s%s", fc_error_text(status), text().c_str());
  }
}

Vec Frame::direction(uint16_t x, uint16_t y) const {
  int64_t one = INT64_C(1) << frame.view.pixel_shift;
  return {(2 * static_cast<int64_t>(x) + 1 - frame.width) * one,
          (frame.height - 2 * static_cast<int64_t>(y) - 1) * one, frame.view.focal};
}

int Frame::check_pixel(uint16_t x, uint16_t y, uint32_t *lit_out, uint32_t *faced_out) {
  const Vec eye = {0, 0, 0};
  Vec d = direction(x, y);
  oracle::Root root;
  fc_hit hit;
  uint32_t reported = 0, expected_lit = 0, faced = 0;
  int expected = oracle::nearest(shapes, eye, d, 0, UINT64_MAX, &root, true);
  int result = fc_pick(&frame, x, y, &hit, &reported);
  size_t at = static_cast<size_t>(y) * frame.width + x;
  std::string wrong;
  if ((result == 1 ? hit.primitive : -1) != expected)
    wrong = print("fc_pick: primitive is %d (%d reported)", expected, result == 1 ? hit.primitive : -1);
  else if (!primitive.empty() && (primitive[at] == 0xffff ? -1 : primitive[at]) != expected)
    wrong = print("fc_render_rows: primitive is %d (%u reported)", expected, primitive[at]);
  if (wrong.empty() && expected >= 0) {
    oracle::Point point = oracle::point_at(root, eye, d);
    const oracle::Shape &s = shapes[static_cast<size_t>(expected)];
    for (size_t i = 0; i < lights.size(); i++) {
      if (!oracle::faces(s, eye, d, point, lights[i])) continue;
      faced |= UINT32_C(1) << i;
      bool blocked = false;
      for (size_t j = 0; j < shapes.size() && !blocked; j++)
        blocked = static_cast<int>(j) != expected && oracle::blocked(shapes[j], point, lights[i]);
      if (!blocked) expected_lit |= UINT32_C(1) << i;
    }
    if ((reported & ~faced) != 0)
      wrong = print("lights %#x are faced (%#x reported as lit)", faced, reported);
    else if (frame.options.offset_rule == FC_OFFSET_EXACT && reported != expected_lit)
      wrong = print("lights %#x reach the point (%#x reported)", expected_lit, reported);
    else if (!lit.empty() && lit[at] != reported)
      wrong = print("fc_render_rows says lights %#x, fc_pick %#x", lit[at], reported);
    else if (!depth.empty() && !oracle::depth_code_holds(depth[at], frame.depth_exponent_bits,
                                                         frame.depth_near, root, frame.view.focal))
      wrong = print("depth code %u does not round near / z (near %lu)", depth[at],
                    static_cast<unsigned long>(frame.depth_near));
    wrong += wrong.empty() ? "" : "; " + oracle::text(root);
  }
  if (!wrong.empty()) fail("pixel (%u, %u): %s%s", x, y, wrong.c_str(), text().c_str());
  if (lit_out != nullptr) *lit_out = reported;
  if (faced_out != nullptr) *faced_out = faced;
  return expected;
}

Vec some_normal(Random &random, Vec v) {
  for (;;) {
    Vec n = cross(v, random.vec(4));
    if (!is_zero(n) || is_zero(v)) return n;
  }
}

int64_t quaternion_frame(Random &random, int64_t most, Vec row[3]) {
  int64_t a, b, c, d;
  do {
    a = random.within(-most, most);
    b = random.within(-most, most);
    c = random.within(-most, most);
    d = random.within(-most, most);
  } while (a == 0 && b == 0 && c == 0 && d == 0);
  row[0] = {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)};
  row[1] = {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)};
  row[2] = {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d};
  return a * a + b * b + c * c + d * d;
}
