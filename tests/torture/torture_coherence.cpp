/* The same answers for the same question: coincident shapes, moved, scaled and turned scenes, extreme
 * fields, corners of pixels (35, 38, 39, 40). */
#include <algorithm>

#include "trial.h"

extern "C" {
#include "view.h"
}

using oracle::plane;
using oracle::Shape;
using oracle::sphere;
using oracle::triangle;

namespace {

/* ---- 35 ---- */

template <typename T>
void shuffle(Random &random, std::vector<T> *list) {
  for (size_t i = list->size(); i > 1; i--)
    std::swap((*list)[i - 1], (*list)[static_cast<size_t>(random.within(0, static_cast<int64_t>(i) - 1))]);
}

uint64_t coincident(Random &random) {
  for (;;) {
    Vec row[3], origin = random.vec(27);
    int64_t n = quaternion_frame(random, 1 << random.within(0, 5), row), s = random.within(1, 1 << 8);
    Vec d = row[0] * random.within(1, 3) + row[1] * random.within(-2, 2) + row[2] * random.within(-2, 2);
    Vec p = origin + d * random.within(1, 1 << random.within(0, 12)), normal = row[0];
    std::vector<Shape> shapes;
    int64_t i = random.within(1, 9), j = random.within(1, 9);
    /* all touch the plane of row 1 and row 2 at p */
    shapes.push_back(sphere(p + row[0] * s, n * s));
    shapes.push_back(triangle(p + row[1] * i, p + row[2] * i, p - (row[1] + row[2]) * j));
    shapes.push_back(triangle(p - row[1] * i, p - row[2] * j, p + (row[1] + row[2]) * i));
    __int128 k = 0;
    for (int c = 0; c < 3; c++) k += static_cast<__int128>(normal[c]) * p[c];
    if (k <= coordinate_max && k >= -coordinate_max) shapes.push_back(plane(normal, static_cast<int64_t>(k)));
    if (random.flip())
      shapes.push_back(
          shapes[static_cast<size_t>(random.within(0, static_cast<int64_t>(shapes.size()) - 1))]);
    if (random.within(0, 3) == 0)
      shapes.push_back(sphere(p - row[0] * s + d * 4, n * s)); /* somewhere near */
    bool good = fits(origin) && fits(d) && n * s <= coordinate_max;
    for (const Shape &shape : shapes) good = good && fits(shape.a) && fits(shape.b) && fits(shape.c);
    if (!good) continue;
    shuffle(random, &shapes);
    Scene scene(shapes);
    int first = check_ray(scene, origin, d);
    if (first < 0) fail("all are missed%s", scene.text().c_str());

    /* copies in a picture: the lowest number of each */
    if (random.within(0, 7) == 0) {
      std::vector<Shape> twice = shapes;
      twice.insert(twice.end(), shapes.begin(), shapes.end());
      Scene doubled(twice);
      fc_camera camera = {};
      Vec target = origin + d;
      camera.eye = to_core(origin);
      camera.target = to_core(target);
      Vec up = random.direction(6);
      if (!fits(target) || is_zero(cross(d, up))) continue;
      camera.up = to_core(up);
      camera.tan_half_fov_numerator = static_cast<uint32_t>(random.within(1, 100));
      camera.tan_half_fov_denominator = 100;
      Frame frame(doubled, {}, camera, 3, 3, FC_OFFSET_EXACT);
      frame.render(static_cast<uint16_t>(random.within(1, 3)));
      for (uint16_t at = 0; at < 9; at = static_cast<uint16_t>(at + 2)) {
        int seen = frame.check_pixel(at % 3, at / 3);
        if (seen >= static_cast<int>(shapes.size()))
          fail("the second copy %d is seen%s", seen, frame.text().c_str());
      }
    }
    return 1;
  }
}

/* ---- 39 ---- */

Shape any_shape(Random &random, int bits) {
  switch (random.within(0, 2)) {
    case 0: return sphere(random.vec(bits), random.within(1, INT64_C(1) << random.within(0, bits)));
    case 1: return plane(random.direction(8), random.any_size(bits + 2));
    default: return triangle(random.vec(bits), random.vec(bits), random.vec(bits));
  }
}

struct Turn {
  int axis[3];
  int64_t sign[3];
  Vec operator()(Vec v) const { return {v[axis[0]] * sign[0], v[axis[1]] * sign[1], v[axis[2]] * sign[2]}; }
};

uint64_t moved_scaled_turned(Random &random) {
  for (;;) {
    std::vector<Shape> shapes, away, large, turned;
    Vec origin = random.vec(20), d = random.direction(14), end = origin + d * random.within(1, 1 << 5);
    for (int64_t i = random.within(1, 3); i > 0; i--) shapes.push_back(any_shape(random, 18));
    if (shapes[0].kind == Shape::sphere && random.flip()) d = shapes[0].a - origin;
    if (shapes[0].kind == Shape::triangle)
      d = random.flip() ? shapes[0].a - origin : shapes[0].a + shapes[0].b + shapes[0].c - origin * 3;
    if (is_zero(d)) continue;
    Vec shift = random.vec(28);
    int scale = static_cast<int>(random.within(0, 7));
    Turn turn = {{0, 1, 2}, {random.flip() ? 1 : -1, random.flip() ? 1 : -1, random.flip() ? 1 : -1}};
    std::swap(turn.axis[0], turn.axis[random.within(0, 2)]);
    std::swap(turn.axis[1], turn.axis[random.within(1, 2)]);
    int64_t two = INT64_C(1) << scale;
    bool tie = false;
    for (const Shape &s : shapes) {
      tie = tie || oracle::is_tie(s, origin, d);
      large.push_back(s);
      turned.push_back(s);
      turned.back().a = turn(s.a);
      turned.back().b = turn(s.b);
      turned.back().c = turn(s.c);
      large.back().r = s.r * two;
      if (s.kind != Shape::plane) large.back().a = s.a * two;
      large.back().b = s.b * two;
      large.back().c = s.c * two;
    }
    bool writable = true;
    for (const Shape &s : shapes) {
      away.push_back(s);
      if (s.kind == Shape::plane) {
        int64_t r = s.r + dot(s.a, shift);
        away.back().r = r;
        while (std::llabs(r) > coordinate_max && (r & 1) == 0) r /= 2;
        writable = writable && std::llabs(r) <= coordinate_max;
      } else {
        away.back().a = s.a + shift;
        away.back().b = s.b + shift;
        away.back().c = s.c + shift;
      }
    }
    if (!writable) shift = {0, 0, 0}, away = shapes;
    Scene base(shapes), shifted(away), scaled(large), swapped(turned);
    fc_hit a = {}, b = {};
    int hit = shoot(base, origin, d, &a);
    check_ray(base, origin, d);

    auto differ = [&](const char *what, const Scene &scene) {
      fail("%s: %s\n  ray from %s along %s%s\n becomes%s", what, hit ? "hit" : "miss",
           oracle::text(origin).c_str(), oracle::text(d).c_str(), base.text().c_str(), scene.text().c_str());
    };
    bool same = shoot(shifted, origin + shift, d, &b) == hit;
    if (same && hit)
      same = a.primitive == b.primitive && a.t_q32 == b.t_q32 &&
             from_core(a.normal_q30) == from_core(b.normal_q30) && a.inside == b.inside &&
             (largest(from_core(a.position)) >= INT64_C(1) << 29 ||
              from_core(a.position) + shift == from_core(b.position));
    if (!same) differ("moved", shifted);

    Vec wide = d * two;
    if (fits(origin * two) && fits(wide)) {
      same = shoot(scaled, origin * two, wide, &b) == hit;
      if (same && hit)
        same =
            a.primitive == b.primitive && a.t_q32 == b.t_q32 && a.inside == b.inside &&
            std::equal(a.barycentric_q30, a.barycentric_q30 + 3, b.barycentric_q30) &&
            (shapes[a.primitive].kind == Shape::sphere || from_core(a.normal_q30) == from_core(b.normal_q30));
      if (!same) differ("times a power of two", scaled);
    }

    if (!tie) {
      same = shoot(swapped, turn(origin), turn(d), &b) == hit;
      if (same && hit)
        same = a.primitive == b.primitive && a.t_q32 == b.t_q32 &&
               turn(from_core(a.normal_q30)) == from_core(b.normal_q30) &&
               turn(from_core(a.position)) == from_core(b.position);
      if (!same) differ("axes swapped", swapped);
    }

    bool dark = check_segment(base, origin, end);
    auto blocked = [](const Scene &scene, Vec p, Vec q) {
      fc_vec3 from = to_core(p), to = to_core(q);
      return fc_blocked(&scene.scene, &from, &to) == 1;
    };
    if (blocked(shifted, origin + shift, end + shift) != dark) differ("blocked, moved", shifted);
    if (blocked(scaled, origin * two, end * two) != dark) differ("blocked, times a power of two", scaled);
    if (blocked(swapped, turn(origin), turn(end)) != dark) differ("blocked, axes swapped", swapped);
    if (blocked(base, end, origin) != dark) differ("blocked, from the other end", base);
    return 8;
  }
}

/* ---- 40 ---- */

int64_t extreme(Random &random) {
  static const int64_t values[] = {
      coordinate_max, coordinate_max, coordinate_max - 1, coordinate_max / 2, coordinate_max / 2 + 1, 1, 0};
  int64_t v = values[random.within(0, 6)];
  return random.flip() ? v : -v;
}

Vec extreme_vec(Random &random) {
  Vec v;
  v.x = extreme(random);
  v.y = extreme(random);
  v.z = extreme(random);
  return v;
}

Vec extreme_direction(Random &random) {
  for (;;) {
    Vec v = extreme_vec(random);
    if (!is_zero(v)) return v;
  }
}

uint64_t extremes(Random &random) {
  std::vector<Shape> shapes;
  for (int64_t i = random.within(1, 3); i > 0; i--) {
    int64_t r = std::llabs(extreme(random));
    switch (random.within(0, 2)) {
      case 0: shapes.push_back(sphere(extreme_vec(random), r < 1 ? 1 : r)); break;
      case 1:
        shapes.push_back(
            plane(extreme_direction(random),
                  extreme(random) * (INT64_C(1) << (random.flip() ? 32 : random.within(0, 32)))));
        break;
      default: shapes.push_back(triangle(extreme_vec(random), extreme_vec(random), extreme_vec(random)));
    }
  }
  Scene scene(shapes);
  Vec origin = extreme_vec(random), d = extreme_direction(random), end = extreme_vec(random);
  uint64_t t_min = random.within(0, 3) == 0 ? random.next() >> random.within(0, 63) : 0;
  check_ray(scene, origin, d);
  check_ray(scene, origin, d, t_min,
            t_min == 0 || random.flip() ? UINT64_MAX : t_min + (random.next() >> 30));
  check_segment(scene, origin, end);
  if (random.within(0, 3) != 0) return 3;

  /* a picture of it: any camera, lights near and far */
  fc_camera camera = {};
  Vec target = extreme_vec(random), up = extreme_vec(random);
  Vec view = target - origin;
  bool flat = true;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    flat = flat && static_cast<__int128>(view[j]) * up[k] == static_cast<__int128>(view[k]) * up[j];
  }
  if (flat) return 3;
  camera.eye = to_core(origin);
  camera.target = to_core(target);
  camera.up = to_core(up);
  camera.exponent = static_cast<int8_t>(random.flip() ? 0 : random.within(-31, 0));
  camera.fov_rule = random.flip() ? FC_FOV_EDGES : FC_FOV_CENTRES;
  camera.tan_half_fov_numerator = static_cast<uint32_t>(random.within(1, 1 << 12));
  camera.tan_half_fov_denominator = static_cast<uint32_t>(random.within(1, 1 << 12));
  std::vector<fc_light> lights = {light_at(extreme_vec(random), static_cast<int>(random.within(-31, 0))),
                                  light_at(extreme_vec(random), static_cast<int>(random.within(0, 28)))};
  uint16_t width = static_cast<uint16_t>(random.within(1, 5)),
           height = static_cast<uint16_t>(random.within(1, 5));
  Frame frame(scene, lights, camera, width, height, FC_OFFSET_EXACT);
  if (frame.refused) return 3;
  frame.render(static_cast<uint16_t>(random.within(1, height)));
  for (int i = 0; i < 3; i++)
    frame.check_pixel(static_cast<uint16_t>(random.within(0, width - 1)),
                      static_cast<uint16_t>(random.within(0, height - 1)));
  return 6;
}

/* ---- 38 ---- */

/* The corner that four pixels share, half a pixel from each of their centres: the same direction to the bit, and what is seen along it is
 * what exact arithmetic sees. */
uint64_t shared_corners(Random &random) {
  uint16_t width = static_cast<uint16_t>(random.within(2, 300)),
           height = static_cast<uint16_t>(random.within(2, 300));
  ExactCamera camera = {{0, 0, 0}, 2, 1, 1, width, height, static_cast<uint32_t>(random.within(1, 1000))};
  int bits = static_cast<int>(random.within(4, 24));
  std::vector<Shape> shapes;
  /* one corner's ray: tangent to a sphere, along a triangle's edge; the rest anywhere */
  uint16_t x = static_cast<uint16_t>(random.within(1, width - 1)),
           y = static_cast<uint16_t>(random.within(1, height - 1));
  Vec to = {2 * x - static_cast<int64_t>(width), static_cast<int64_t>(height) - 2 * y,
            static_cast<int64_t>(camera.focal)};
  Vec p = to * random.within(1, 1 << random.within(1, 12)), across = some_normal(random, to);
  shapes.push_back(triangle(p + across, p - across, p + random.direction(bits)));
  shapes.push_back(sphere(p + random.direction(bits), random.within(1, INT64_C(1) << bits)));
  shapes.push_back(sphere(p + random.direction(bits), random.within(1, INT64_C(1) << bits)));
  if (random.flip()) shapes.push_back(plane(random.direction(6), random.within(-1000, 1000)));
  for (const Shape &shape : shapes)
    if (!fits(shape.a) || !fits(shape.b) || !fits(shape.c)) return 0;
  Scene scene(shapes);
  Frame frame(scene, {}, to_core(camera), width, height, FC_OFFSET_EXACT);
  uint64_t checked = 0;
  for (int tries = 0; tries < 8; tries++) {
    Vec corner[4];
    for (int i = 0; i < 4; i++) {
      int64_t d[3], beside[3], below[3];
      uint16_t column = static_cast<uint16_t>(x - (i & 1)), row = static_cast<uint16_t>(y - (i >> 1));
      fc_view_direction(&frame.frame, column, row, d);
      fc_view_direction(&frame.frame, static_cast<uint16_t>(column + 1), row, beside);
      fc_view_direction(&frame.frame, column, static_cast<uint16_t>(row + 1), below);
      /* a pixel's step is whole and even: half of it is a half pixel */
      int64_t right = beside[0] - d[0], down = below[1] - d[1];
      if (right <= 0 || down >= 0 || (right & 1) || (down & 1))
        fail("steps of a pixel: %lld, %lld", static_cast<long long>(right), static_cast<long long>(down));
      corner[i] = {d[0] + (i & 1 ? right / 2 : -right / 2), d[1] + (i >> 1 ? down / 2 : -down / 2), d[2]};
      if (!(corner[i] == corner[0]))
        fail("corner (%u, %u) is %s from one pixel, %s from another%s", x, y, oracle::text(corner[0]).c_str(),
             oracle::text(corner[i]).c_str(), frame.text().c_str());
    }
    const int64_t eye[3] = {0, 0, 0}, direction[3] = {corner[0].x, corner[0].y, corner[0].z};
    fc_space space = fc_space_of_frame(&frame.frame);
    oracle::Root root;
    uint16_t seen = fc_space_nearest(&space, eye, direction, 0, UINT64_MAX, nullptr);
    int expected = oracle::nearest(frame.shapes, {0, 0, 0}, corner[0], 0, UINT64_MAX, &root, true);
    if ((seen == 0xffff ? -1 : seen) != expected)
      fail("corner (%u, %u): primitive %d is right (%d)%s", x, y, expected, seen == 0xffff ? -1 : seen,
           frame.text().c_str());
    checked += 5;
    x = static_cast<uint16_t>(random.within(1, width - 1));
    y = static_cast<uint16_t>(random.within(1, height - 1));
  }
  return checked;
}

} // namespace

const std::vector<Family> coherence_families = {
    {35, "coincident shapes", 500000, 64, coincident},
    {38, "corners that pixels share", 200000, 75, shared_corners},
    {39, "moved, scaled, turned", 500000, 45, moved_scaled_turned},
    {40, "all-maximum magnitudes", 1000000, 38, extremes},
};
