/* Triangles: edges and vertices hit exactly and missed by one unit, extreme shapes, origins on them (1-16,
 * 18). */
#include <algorithm>
#include <memory>

#include "trial.h"

using oracle::Shape;
using oracle::triangle;

namespace {

int64_t volume_sign(Vec a, Vec b, Vec c) {
  __int128 v = 0;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    v += static_cast<__int128>(a[i]) *
         (static_cast<__int128>(b[j]) * c[k] - static_cast<__int128>(b[k]) * c[j]);
  }
  return (v > 0) - (v < 0);
}

/* Rotates and reflects the list of vertices. */
Shape any_order(Random &random, Vec a, Vec b, Vec c) {
  Vec v[3] = {a, b, c};
  int64_t first = random.within(0, 2);
  bool flip = random.flip();
  return triangle(v[first], v[(first + (flip ? 2 : 1)) % 3], v[(first + (flip ? 1 : 2)) % 3]);
}

/* A point that a ray reaches in whole steps: point = origin + s direction. */
struct Aim {
  Vec origin, direction, point;
  int64_t steps;
};

Aim aim(Random &random) {
  for (;;) {
    Aim a;
    a.origin = random.vec(30);
    a.direction = random.direction(static_cast<int>(random.within(1, 30)));
    int64_t most = 2 * coordinate_max / largest(a.direction);
    a.steps = random.within(1, random.flip() || most < 2 ? std::min<int64_t>(most, 9) : most);
    a.point = a.origin + a.direction * a.steps;
    if (fits(a.origin) && fits(a.direction) && fits(a.point)) return a;
  }
}

/* A pair with a common edge through the aimed-at point, on different sides of it as seen from the origin. */
struct Pair {
  Aim ray;
  Vec a, b, left, right;
};

Pair pair(Random &random) {
  for (;;) {
    Pair p;
    p.ray = aim(random);
    int bits = static_cast<int>(random.within(2, 29));
    Vec v = random.direction(bits);
    int64_t steps = std::max<int64_t>(1, coordinate_max / largest(v));
    if (random.flip()) steps = std::min<int64_t>(steps, 3);
    p.a = p.ray.point + v * random.within(1, steps);
    p.b = p.ray.point - v * random.within(1, steps);
    int spread = static_cast<int>(random.within(2, 29));
    p.left = p.ray.point + random.vec(spread);
    p.right = p.ray.point + random.vec(spread);
    if (!fits(p.a) || !fits(p.b) || !fits(p.left) || !fits(p.right)) continue;
    Vec a = p.a - p.ray.origin, b = p.b - p.ray.origin;
    int64_t left = volume_sign(a, b, p.left - p.ray.origin),
            right = volume_sign(a, b, p.right - p.ray.origin);
    if (left * right < 0) return p;
  }
}

uint64_t edge_exact(Random &random) {
  Pair p = pair(random);
  Scene scene({any_order(random, p.a, p.b, p.left), any_order(random, p.a, p.b, p.right)});
  int hits = hits_alone(scene, p.ray.origin, p.ray.direction);
  /* a triangle whose plane holds the ray is seen edge-on along it, its neighbour then has t too, or none
   * has */
  if (hits != 1) fail("%d of the two triangles are hit%s", hits, scene.text().c_str());
  check_ray(scene, p.ray.origin, p.ray.direction);
  /* the limits of t are open */
  uint64_t t = static_cast<uint64_t>(p.ray.steps) << 32;
  check_ray(scene, p.ray.origin, p.ray.direction, 0, t + static_cast<uint64_t>(random.within(0, 1)));
  check_ray(scene, p.ray.origin, p.ray.direction, t - static_cast<uint64_t>(random.within(0, 1)));
  return 5;
}

struct Fan {
  Aim ray;
  std::vector<Vec> rim;
};

Fan fan(Random &random) {
  static const int8_t circle[12][2] = {{10, 0}, {9, 5}, {5, 9}, {0, 10}, {-5, 9}, {-9, 5}, {-10, 0}, {-9, -5}, {-5, -9}, {0, -10}, {5, -9}, {9, -5}};
  for (;;) {
    Fan f;
    f.ray = aim(random);
    int64_t count = random.within(3, 12);
    int bits = static_cast<int>(random.within(1, 25));
    Vec u = random.direction(bits), w = random.direction(bits);
    if (volume_sign(u, w, f.ray.direction) == 0) continue;
    bool good = true;
    for (int64_t i = 0; i < count; i++) {
      const int8_t *c = circle[i * 12 / count];
      Vec v = f.ray.point + u * c[0] + w * c[1];
      /* along the ray the rim may rise and sink without leaving its place around it */
      Vec risen = v + f.ray.direction * random.within(-3, 3);
      f.rim.push_back(fits(risen) ? risen : v);
      good = good && fits(f.rim.back());
    }
    if (good) return f;
  }
}

Scene *fan_scene(Random &random, const Fan &f) {
  std::vector<Shape> shapes;
  for (size_t i = 0; i < f.rim.size(); i++)
    shapes.push_back(any_order(random, f.ray.point, f.rim[i], f.rim[(i + 1) % f.rim.size()]));
  return new Scene(shapes);
}

uint64_t vertex_exact(Random &random) {
  Fan f = fan(random);
  std::unique_ptr<Scene> scene(fan_scene(random, f));
  int hits = hits_alone(*scene, f.ray.origin, f.ray.direction);
  if (hits != 1) fail("%d triangles of the fan are hit%s", hits, scene->text().c_str());
  return f.rim.size();
}

uint64_t edge_off_by_one(Random &random) {
  Pair p = pair(random);
  Vec *moved[] = {&p.a, &p.b, &p.ray.origin, &p.ray.direction};
  Vec *v = moved[random.within(0, 3)];
  Vec old = *v;
  do *v = old + random.unit_step();
  while (!fits(*v) || is_zero(p.ray.direction));
  Scene scene({any_order(random, p.a, p.b, p.left), any_order(random, p.a, p.b, p.right)});
  if (hits_alone(scene, p.ray.origin, p.ray.direction) == 2 &&
      volume_sign(p.a - p.ray.origin, p.b - p.ray.origin, p.left - p.ray.origin) *
              volume_sign(p.a - p.ray.origin, p.b - p.ray.origin, p.right - p.ray.origin) <
          0)
    fail("both triangles are hit%s", scene.text().c_str());
  return 2;
}

uint64_t vertex_off_by_one(Random &random) {
  Fan f = fan(random);
  Vec old = f.ray.point;
  do f.ray.point = old + random.unit_step();
  while (!fits(f.ray.point));
  std::unique_ptr<Scene> scene(fan_scene(random, f));
  hits_alone(*scene, f.ray.origin, f.ray.direction);
  return f.rim.size();
}

/* A ray from somewhere to the neighbourhood of a point; the point itself when near is 0. */
bool ray_to(Random &random, Vec point, int64_t near, Vec *origin, Vec *direction) {
  *origin = random.vec(30);
  Vec target =
      point + Vec{random.within(-near, near), random.within(-near, near), random.within(-near, near)};
  *direction = target - *origin;
  return fits(*origin) && !is_zero(*direction) && fits(*direction);
}

uint64_t needle(Random &random) {
  for (;;) {
    Vec a = random.vec(29), along = random.direction(18), b, c, origin, direction;
    if (largest(along) < (1 << 17)) continue;
    int64_t steps = random.within(1, 64);
    b = a + along * steps;
    /* 1 to 3 units beside the line, anywhere along it */
    c = a + along * random.within(0, steps) + random.unit_step() * random.within(1, 3);
    Vec at = a + along * random.within(0, steps);
    if (!fits(b) || !fits(c) || !fits(at) || !ray_to(random, at, 2, &origin, &direction)) continue;
    Scene scene({any_order(random, a, b, c)});
    check_ray(scene, origin, direction);
    return 1;
  }
}

/* A basis of the lattice in a plane whose normal is small: e1 x e2 = n, |n|_inf 1 to 3. */
void thin_basis(Random &random, Vec *e1, Vec *e2) {
  static const Vec basis[3][2] = {{{1, 0, 0}, {0, 1, 0}}, {{1, -1, 0}, {0, 0, 1}}, {{1, -1, 0}, {0, 1, -1}}};
  int64_t kind = random.within(0, 2), turn = random.within(0, 2);
  *e1 = basis[kind][0] * random.within(1, 3);
  *e2 = basis[kind][1];
  for (int i = 0; i < 3; i++) {
    int64_t k = random.any_size(8);
    if (i & 1)
      *e1 = *e1 + *e2 * k;
    else
      *e2 = *e2 + *e1 * k;
  }
  for (Vec *v : {e1, e2})
    for (int64_t i = 0; i < turn; i++) *v = {v->y, v->z, -v->x};
}

uint64_t minimum_area(Random &random) {
  for (;;) {
    Vec e1, e2, a = random.vec(29), origin, direction;
    thin_basis(random, &e1, &e2);
    if (!fits(a + e1) || !fits(a + e2) || largest(cross(e1, e2)) > 3) continue;
    Vec corner[3] = {a, a + e1, a + e2};
    if (!ray_to(random, corner[random.within(0, 2)], random.within(0, 1), &origin, &direction)) continue;
    if (random.flip()) { /* between the corners: three times the grid from a far origin */
      direction = corner[0] + corner[1] + corner[2] - origin * 3;
      if (!fits(direction) || is_zero(direction)) continue;
    }
    Scene scene({any_order(random, corner[0], corner[1], corner[2])});
    check_ray(scene, origin, direction);
    return 1;
  }
}

uint64_t tiny_and_far(Random &random) {
  for (;;) {
    Vec a = random.vec(30), origin, direction;
    Vec b = a + Vec{random.within(-8, 8), random.within(-8, 8), random.within(-8, 8)};
    Vec c = a + Vec{random.within(-8, 8), random.within(-8, 8), random.within(-8, 8)};
    if (!fits(a) || !fits(b) || !fits(c)) continue;
    if (!ray_to(random, a, random.within(0, 8), &origin, &direction) || largest(direction) < (1 << 26))
      continue;
    Scene scene({triangle(a, b, c)});
    check_ray(scene, origin, direction);
    return 1;
  }
}

uint64_t huge_and_near(Random &random) {
  for (;;) {
    /* opposite corners of the range, a point half-way along two edges, and then a few units off the plane */
    Vec v[3], origin;
    for (Vec &c : v)
      for (int i = 0; i < 3; i++)
        c[i] = (random.flip() ? 1 : -1) * (coordinate_max - random.within(0, 1 << random.within(0, 29)));
    int64_t k = random.within(0, 4);
    Vec middle = {(v[0].x + v[1].x) / 2, (v[0].y + v[1].y) / 2, (v[0].z + v[1].z) / 2};
    origin = {middle.x + (v[2].x - middle.x) / 8 * k, middle.y + (v[2].y - middle.y) / 8 * k,
              middle.z + (v[2].z - middle.z) / 8 * k};
    origin = origin + random.unit_step() * random.within(1, 4);
    Vec direction = random.direction(static_cast<int>(random.within(1, 30)));
    if (!fits(origin) || !fits(direction)) continue;
    Scene scene({triangle(v[0], v[1], v[2])});
    check_ray(scene, origin, direction);
    check_ray(scene, origin, -direction);
    return 2;
  }
}

uint64_t grazing(Random &random) {
  for (;;) {
    /* normal . direction = +-1 for the plane's least normal; the triangle is a multiple of the lattice's
     * cell */
    Vec e1, e2;
    thin_basis(random, &e1, &e2);
    int64_t s = random.within(1, 1 << 18);
    Vec a = random.vec(28), b = a + e1 * s, c = a + e2 * random.within(1, 1 << 18), n = cross(e1, e2),
        across = {0, 0, 0};
    for (int i = 0; i < 3; i++)
      if (std::llabs(n[i]) == 1) across[i] = random.flip() ? 1 : -1;
    if (std::llabs(dot(n, across)) != 1) continue;
    Vec direction = e1 * random.any_size(10) + e2 * random.any_size(10) + across;
    Vec at = a + (b - a + c - a) * 1; /* beyond the triangle, scaled back below */
    at = {a.x + (at.x - a.x) / 3, a.y + (at.y - a.y) / 3, a.z + (at.z - a.z) / 3};
    Vec origin = at - direction * random.within(1, 1 << random.within(0, 20));
    if (!fits(b) || !fits(c) || !fits(direction) || !fits(origin)) continue;
    Scene scene({any_order(random, a, b, c)});
    check_ray(scene, origin, direction);
    check_ray(scene, origin, -direction);
    return 2;
  }
}

/* A triangle and a lattice of its plane around a whole point in or near it. */
struct Patch {
  Vec e1, e2, middle, a, b, c;
};

Patch patch(Random &random) {
  for (;;) {
    Patch p;
    p.e1 = random.direction(20);
    p.e2 = random.direction(20);
    p.middle = random.vec(29);
    if (is_zero(cross(p.e1, p.e2))) continue;
    /* middle = (a + b + c) / 3 plus nothing: strictly inside */
    int64_t i = random.within(1, 64), j = random.within(1, 64);
    p.a = p.middle + p.e1 * i;
    p.b = p.middle + p.e2 * j;
    p.c = p.middle - p.e1 * random.within(1, 64) - p.e2 * random.within(1, 64);
    if (fits(p.a) && fits(p.b) && fits(p.c)) return p;
  }
}

uint64_t parallel(Random &random) {
  for (;;) {
    Patch p = patch(random);
    Vec direction = p.e1 * random.any_size(9) + p.e2 * random.any_size(9), origin = p.middle;
    if (is_zero(direction) || !fits(direction)) continue;
    origin = origin - direction * random.within(-64, 64);
    if (random.flip()) origin = origin + random.vec(static_cast<int>(random.within(1, 20)));
    if (!fits(origin)) continue;
    expect_ray(Scene({any_order(random, p.a, p.b, p.c)}), origin, direction, -1);
    return 1;
  }
}

uint64_t origin_inside(Random &random) {
  Patch p = patch(random);
  Vec direction = random.direction(30), at[] = {p.middle, p.a, p.b};
  expect_ray(Scene({any_order(random, p.a, p.b, p.c)}), at[random.within(0, 2)], direction, -1);
  return 1;
}

uint64_t origin_off_by_one(Random &random) {
  for (;;) {
    Patch p = patch(random);
    Vec origin = p.middle + random.unit_step(), direction = random.direction(30);
    if (!fits(origin)) continue;
    Scene scene({any_order(random, p.a, p.b, p.c)});
    check_ray(scene, origin, direction);
    check_ray(scene, origin, -direction);
    return 2;
  }
}

uint64_t behind(Random &random) {
  Patch p = patch(random);
  for (;;) {
    Vec direction = random.direction(25), origin = p.middle + direction * random.within(1, 64);
    if (!fits(origin)) continue;
    expect_ray(Scene({any_order(random, p.a, p.b, p.c)}), origin, direction, -1);
    return 1;
  }
}

uint64_t degenerate(Random &random) {
  for (;;) {
    Aim r = aim(random);
    Vec v = random.direction(24), a = r.point + v * random.within(-8, 8),
        b = r.point + v * random.within(-8, 8), c = r.point + v * random.within(-8, 8);
    if (random.within(0, 3) == 0) b = a;
    if (random.within(0, 3) == 0) c = b;
    if (!fits(a) || !fits(b) || !fits(c)) continue;
    expect_ray(Scene({triangle(a, b, c)}), r.origin, r.direction, -1);
    return 1;
  }
}

uint64_t vertex_order(Random &random) {
  static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (;;) {
    Pair p = pair(random);
    Vec v[3] = {p.a, p.b, p.left}, direction = p.ray.direction;
    if (random.flip()) {
      direction = direction + random.vec(static_cast<int>(random.within(1, 28)));
      if (is_zero(direction) || !fits(direction)) continue;
    }
    fc_hit first = {}, hit;
    int result = 0;
    for (int i = 0; i < 6; i++) {
      Scene scene({triangle(v[order[i][0]], v[order[i][1]], v[order[i][2]])});
      int now = shoot(scene, p.ray.origin, direction, &hit);
      if (i == 0) {
        result = now;
        first = hit;
        check_ray(scene, p.ray.origin, direction);
      }
      bool same = now == result;
      if (same && now == 1) {
        same = hit.t_q32 == first.t_q32 && from_core(hit.position) == from_core(first.position) &&
               from_core(hit.normal_q30) == from_core(first.normal_q30) &&
               hit.inside == (first.inside != (i >= 3));
        for (int j = 0; j < 3; j++)
          same = same && hit.barycentric_q30[j] == first.barycentric_q30[order[i][j]];
      }
      if (!same)
        fail("vertex order %d%d%d changes the answer: ray from %s along %s%s", order[i][0], order[i][1],
             order[i][2], oracle::text(p.ray.origin).c_str(), oracle::text(direction).c_str(),
             scene.text().c_str());
    }
    return 6;
  }
}

/* Family 16. A net whose knots lie exactly behind pixel centres, at any depth: seen from the eye it is a
 * plane net. */
uint64_t screen_mesh(Random &random) {
  const int width = 7, height = 5;
  ExactCamera camera = {{0, 0, 0}, 2, 1, 1, width, height, static_cast<uint32_t>(random.within(1, 200))};
  Scene empty({});
  Frame probe(empty, {}, to_core(camera), width, height, FC_OFFSET_EXACT); /* for the view's directions */
  int64_t one = INT64_C(1) << probe.frame.view.pixel_shift, focal = static_cast<int64_t>(camera.focal);
  int step = static_cast<int>(random.within(1, 3));
  std::vector<std::vector<Vec>> knots;
  std::vector<Shape> shapes;
  for (int y = -step; y < height + step; y += step) {
    knots.push_back({});
    for (int x = -step; x < width + step; x += step) {
      Vec d = {2 * x + 1 - width, height - 2 * y - 1, focal};
      int64_t depth = random.within(1, 1 << random.within(0, 20));
      /* the view's right is (forward x up): -x here */
      knots.back().push_back({-d.x * depth, d.y * depth, d.z * depth});
    }
  }
  for (size_t y = 0; y + 1 < knots.size(); y++)
    for (size_t x = 0; x + 1 < knots[y].size(); x++) {
      Vec a = knots[y][x], b = knots[y][x + 1], c = knots[y + 1][x], d = knots[y + 1][x + 1];
      bool diagonal = random.flip();
      shapes.push_back(any_order(random, a, b, diagonal ? c : d));
      shapes.push_back(any_order(random, diagonal ? b : a, c, d));
    }
  Scene scene(shapes);
  Frame frame(scene, {}, to_core(camera), width, height, FC_OFFSET_EXACT);
  frame.render(static_cast<uint16_t>(random.within(1, height)));
  if (frame.frame.view.shift > 0 || probe.frame.view.focal != focal * one)
    fail("test: the camera is not exact");
  for (uint16_t y = 0; y < height; y++)
    for (uint16_t x = 0; x < width; x++) {
      Vec d = frame.direction(x, y);
      int64_t origin[3] = {0, 0, 0}, direction[3] = {d.x, d.y, d.z};
      int cover = 0;
      for (const Shape &s : frame.shapes) {
        fc_form form{};
        fc_prepared prepared;
        fc_root root[2];
        const Vec *v[3] = {&s.a, &s.b, &s.c};
        for (int i = 0; i < 3; i++)
          for (int j = 0; j < 3; j++) form.u.triangle.vertex[i][j] = (*v[i])[j];
        fc_kind_triangle.prepare(&form, origin, &prepared);
        cover += fc_kind_triangle.test(&prepared, direction, root);
      }
      uint16_t seen = frame.primitive[static_cast<size_t>(y) * width + x];
      if (cover != 1 || seen == 0xffff)
        fail("pixel (%u, %u) is covered %d times, primitive %u%s", x, y, cover, seen, frame.text().c_str());
    }
  frame.check_pixel(static_cast<uint16_t>(random.within(0, width - 1)),
                    static_cast<uint16_t>(random.within(0, height - 1)));
  return width * height;
}

uint64_t across_the_eye_plane(Random &random) {
  for (;;) {
    const uint16_t width = 6, height = 4;
    ExactCamera camera = {
        random.vec(20), static_cast<int>(random.within(0, 2)), random.flip() ? 1 : -1, 0, width,
        height, static_cast<uint32_t>(random.within(1, 20))};
    camera.up_axis = (camera.axis + (random.flip() ? 1 : 2)) % 3;
    int bits = static_cast<int>(random.within(3, 27));
    std::vector<Shape> shapes;
    for (int i = 0; i < 3; i++) {
      Vec v[3] = {camera.eye + random.vec(bits), camera.eye + random.vec(bits),
                  camera.eye + random.vec(bits)};
      /* one vertex before the eye's plane, one behind it or in it */
      v[0][camera.axis] = camera.eye[camera.axis] + camera.sign * random.within(1, 1 << bits);
      v[1][camera.axis] =
          camera.eye[camera.axis] - camera.sign * random.within(0, random.flip() ? 1 : 1 << bits);
      shapes.push_back(any_order(random, v[0], v[1], v[2]));
    }
    Scene scene(shapes);
    Frame frame(scene, {light_at(random.vec(24))}, to_core(camera), width, height, FC_OFFSET_EXACT);
    frame.render(static_cast<uint16_t>(random.within(1, height)));
    for (int i = 0; i < 6; i++)
      frame.check_pixel(static_cast<uint16_t>(random.within(0, width - 1)),
                        static_cast<uint16_t>(random.within(0, height - 1)));
    return 6;
  }
}

} // namespace

const std::vector<Family> triangle_families = {
    {1, "shared edge hit exactly", 500000, 200, edge_exact},
    {2, "fan centre hit exactly", 300000, 110, vertex_exact},
    {3, "edge one unit off", 500000, 95, edge_off_by_one},
    {4, "fan centre one unit off", 300000, 135, vertex_off_by_one},
    {5, "needle", 1000000, 10, needle},
    {6, "minimum area", 1000000, 57, minimum_area},
    {7, "tiny and far", 1000000, 9, tiny_and_far},
    {8, "huge and near", 1000000, 36, huge_and_near},
    {9, "grazing", 500000, 73, grazing},
    {10, "parallel", 1000000, 3, parallel},
    {11, "origin in the triangle", 1000000, 3, origin_inside},
    {12, "origin one unit off", 500000, 60, origin_off_by_one},
    {13, "behind", 1000000, 5, behind},
    {14, "degenerate", 1000000, 3, degenerate},
    {15, "vertex order", 1000000, 26, vertex_order},
    {16, "net over the screen", 100000, 780, screen_mesh},
    {18, "across the eye's plane", 200000, 240, across_the_eye_plane},
};
