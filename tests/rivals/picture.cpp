/* Scenes into camera space in double, and the exact picture. */
#include "picture.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

static Vector<double> world(fc_vec3 v, int exponent) {
  const double unit = std::ldexp(1.0, exponent - 16);
  return {v.x * unit, v.y * unit, v.z * unit};
}
static Vector<double> unit(Vector<double> v) { return v * (1 / std::sqrt(dot(v, v))); }

static std::vector<uint16_t> render(const fc_frame &frame, bool by_rays) {
  std::vector<uint16_t> pixels(static_cast<size_t>(frame.width) * frame.height), depth(pixels.size()),
      primitive(pixels.size());
  fc_target target = {};
  target.pixels = pixels.data();
  target.pitch_bytes = static_cast<uint32_t>(frame.width * 2);
  target.format = FC_RGB565_BE;
  target.depth = depth.data();
  target.primitive = primitive.data();
  int error = by_rays ? fc_render_rows_by_rays(&frame, 0, frame.height, &target)
                      : fc_render_rows(&frame, 0, frame.height, &target);
  if (error != FC_OK) {
    std::fprintf(stderr, "rivals: cannot render: %s\n", fc_error_text(error));
    std::exit(2);
  }
  return primitive;
}

uint32_t crc_of(const Pixels &pixels) {
  uint32_t crc = UINT32_C(0xffffffff);
  for (uint16_t pixel : pixels) {
    crc ^= pixel;
    for (int bit = 0; bit < 16; bit++) crc = (crc >> 1) ^ (UINT32_C(0xedb88320) & -(crc & 1));
  }
  return ~crc;
}

Picture picture_of(const fc_scene &scene, const fc_camera &camera, int width, int height) {
  Picture p = shapes_of(scene, camera, width, height);
  int error = FC_OK;
  std::vector<int64_t> memory(fc_frame_memory(&scene, &error) / 8 + 1);
  fc_frame frame;
  if (error == FC_OK)
    error = fc_frame_setup(&frame, &scene, &camera, nullptr, static_cast<uint16_t>(width),
                           static_cast<uint16_t>(height), memory.data(), memory.size() * 8);
  if (error != FC_OK) {
    std::fprintf(stderr, "rivals: cannot set up a frame: %s\n", fc_error_text(error));
    std::exit(2);
  }
  p.exact = render(frame, true);
  p.ours = render(frame, false);
  return p;
}

Picture shapes_of(const fc_scene &scene, const fc_camera &camera, int width, int height) {
  Picture p = {};
  p.width = width;
  p.height = height;
  const int shorter = width < height ? width : height,
            s = camera.fov_rule == FC_FOV_CENTRES ? (shorter > 1 ? shorter - 1 : 1) : shorter;
  p.focal = s * static_cast<double>(camera.tan_half_fov_denominator) / camera.tan_half_fov_numerator;
  const Vector<double> eye = world(camera.eye, scene.exponent + camera.exponent),
                       target = world(camera.target, scene.exponent + camera.exponent);
  const Vector<double> forward = unit(target - eye), right = unit(cross(forward, world(camera.up, 16))),
                       up = cross(right, forward);
  p.far = scene.far_limit == 0 ? 1e9 : std::ldexp(scene.far_limit, scene.far_exponent + scene.exponent - 16);
  auto seen = [&](Vector<double> v) { return Vector<double>{dot(v, right), dot(v, up), dot(v, forward)}; };
  for (uint16_t t = 0; t < scene.shape_count; t++) {
    const fc_shapes &table = scene.shapes[t];
    for (uint16_t i = 0; i < table.count; i++) {
      Shape shape = {};
      if (table.kind == &fc_kind_sphere) {
        const fc_sphere &ball = static_cast<const fc_sphere *>(table.items)[i];
        shape.kind = Shape::sphere;
        shape.a = seen(world(ball.center, scene.exponent) - eye);
        shape.r = std::ldexp(ball.radius, scene.exponent - 16);
        p.object.push_back(ball.object);
      } else if (table.kind == &fc_kind_plane) {
        const fc_plane &plane = static_cast<const fc_plane *>(table.items)[i];
        const Vector<double> n = world(plane.normal, 16);
        const double length = std::sqrt(dot(n, n));
        shape.kind = Shape::plane;
        shape.a = seen(n * (1 / length));
        shape.r = (dot(n, eye) + std::ldexp(plane.d, plane.d_exponent + scene.exponent - 16)) / length;
        p.object.push_back(plane.object);
      } else {
        const fc_triangle &triangle = static_cast<const fc_triangle *>(table.items)[i];
        const auto *vertices = static_cast<const fc_vec3 *>(table.vertices);
        shape.kind = Shape::triangle;
        shape.a = seen(world(vertices[triangle.vertex[0]], scene.exponent) - eye);
        shape.b = seen(world(vertices[triangle.vertex[1]], scene.exponent) - eye);
        shape.c = seen(world(vertices[triangle.vertex[2]], scene.exponent) - eye);
        p.object.push_back(triangle.object);
      }
      p.shapes.push_back(shape);
    }
  }
  return p;
}
