/* Secondary rays: no acne on convex bodies, occluders at the light and just over the surface, concave
 * corners (28-32). */
#include <algorithm>
#include <memory>

#include "fixcast/error.h"
#include "trial.h"

using oracle::plane;
using oracle::Q;
using oracle::Shape;
using oracle::sphere;
using oracle::triangle;
using oracle::Z;

namespace {

Z square_of(Vec v) {
  Z sum = 0;
  for (int i = 0; i < 3; i++) sum += Z(static_cast<long>(v[i])) * static_cast<long>(v[i]);
  return sum;
}

Z product(Vec a, Vec b) {
  Z sum = 0;
  for (int i = 0; i < 3; i++) sum += Z(static_cast<long>(a[i])) * static_cast<long>(b[i]);
  return sum;
}

/* n . p - k of a plane or a triangle's plane (edges below 2^30 here, so the normal fits), or |p - c|^2 -
 * r^2 */
Z residual(const Shape &s, Vec p, Z *normal2) {
  if (s.kind == Shape::sphere) return square_of(p - s.a) - Z(static_cast<long>(s.r)) * static_cast<long>(s.r);
  Vec n = s.kind == Shape::plane ? s.a : cross(s.b - s.a, s.c - s.a);
  *normal2 = square_of(n);
  return s.kind == Shape::plane ? Z(product(n, p) - static_cast<long>(s.r)) : Z(product(n, p - s.a));
}

/* fc_offset by the residual rule: strictly on the ray's side, at most sqrt(3) units above the surface. */
Vec step_off(const Scene &scene, const fc_hit &hit) {
  fc_vec3 moved;
  int status = fc_offset(&scene.scene, &hit, FC_OFFSET_RESIDUAL, 0, &moved);
  if (status != FC_OK) fail("fc_offset: %s", fc_error_text(status));
  const Shape &s = scene.shapes[hit.primitive];
  Vec p = from_core(moved);
  Z normal2 = 0, side = residual(s, p, &normal2);
  if (hit.inside) side = -side;
  bool close;
  if (s.kind == Shape::sphere) {
    /* | |p - c| - r | <= sqrt 3: the excess of the square over r^2 + 3 (or of r^2 + 3 over it) at most 2
     * sqrt(3) r */
    Z over = hit.inside ? Z(side + 3) : Z(side - 3);
    close = over <= 0 || over * over <= Z(12) * static_cast<long>(s.r) * static_cast<long>(s.r);
  } else {
    close = side * side <= 3 * normal2;
  }
  if (side <= 0 || !close)
    fail("fc_offset moves %s to %s: %s%s", oracle::text(from_core(hit.position)).c_str(),
         oracle::text(p).c_str(), side <= 0 ? "not on the ray's side" : "more than sqrt(3) above the surface",
         scene.text().c_str());
  return p;
}

/* ---- 28 ---- */

std::vector<Shape> box(Random &random, Vec center, int64_t size) {
  static const uint8_t side[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  Vec e[3], v[8];
  do {
    for (Vec &c : e) c = {random.within(-size, size), random.within(-size, size), random.within(-size, size)};
    if (random.flip())
      e[0] = {random.within(1, size), 0, 0}, e[1] = {0, random.within(1, size), 0},
      e[2] = {0, 0, random.within(1, size)};
  } while (product(cross(e[0], e[1]), e[2]) == 0);
  for (int i = 0; i < 8; i++)
    v[i] = center + e[0] * ((i & 1) ? 1 : -1) + e[1] * ((i & 2) ? 1 : -1) + e[2] * ((i & 4) ? 1 : -1);
  std::vector<Shape> shapes;
  for (const uint8_t *s : side) {
    int k = random.flip();
    shapes.push_back(triangle(v[s[k]], v[s[k + 1]], v[s[k + 2]]));
    shapes.push_back(triangle(v[s[k]], v[s[k + 2]], v[s[(k + 3) % 4]]));
  }
  return shapes;
}

int64_t integer_root(int64_t v) {
  int64_t r = 0;
  for (int64_t bit = INT64_C(1) << 31; bit != 0; bit >>= 1)
    if ((r + bit) * (r + bit) <= v) r += bit;
  return r;
}

/* An icosahedron with whole vertices, or its faces cut in four and pushed out to the sphere. */
std::vector<Shape> icosphere(Random &random, Vec center, int64_t size) {
  /* clang-format off */
  static const uint8_t faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                       {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                       {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                       {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  /* clang-format on */
  int64_t a = size, b = size * 1618 / 1000;
  /* clang-format off */
  const Vec v[12] = {{-a, b, 0},  {a, b, 0},  {-a, -b, 0}, {a, -b, 0}, {0, -a, b},  {0, a, b},
                     {0, -a, -b}, {0, a, -b}, {b, 0, -a},  {b, 0, a},  {-b, 0, -a}, {-b, 0, a}};
  /* clang-format on */
  int64_t radius = integer_root(a * a + b * b);
  bool fine = size > 1000 && random.within(0, 7) == 0;
  std::vector<Shape> shapes;
  auto middle = [&](Vec p, Vec q) {
    Vec m = p + q;
    int64_t length = integer_root(dot(m, m));
    return Vec{m.x * radius / length, m.y * radius / length, m.z * radius / length};
  };
  auto add = [&](Vec p, Vec q, Vec r) { shapes.push_back(triangle(center + p, center + q, center + r)); };
  for (const uint8_t *f : faces) {
    Vec p = v[f[0]], q = v[f[1]], r = v[f[2]];
    if (!fine) {
      add(p, q, r);
      continue;
    }
    Vec pq = middle(p, q), qr = middle(q, r), rp = middle(r, p);
    add(p, pq, rp);
    add(q, qr, pq);
    add(r, rp, qr);
    add(pq, qr, rp);
  }
  return shapes;
}

/* Whether no vertex is in front of a face, seen from the center. */
bool is_convex(const std::vector<Shape> &shapes, Vec center) {
  for (const Shape &f : shapes) {
    Z unused;
    int inner = sgn(residual(f, center, &unused));
    if (inner == 0) return false;
    for (const Shape &s : shapes)
      for (const Vec &v : {s.a, s.b, s.c})
        if (sgn(residual(f, v, &unused)) * inner < 0) return false;
  }
  return true;
}

uint64_t convex_body(Random &random) {
  for (;;) {
    int64_t size = random.within(2, INT64_C(1) << random.within(2, 26));
    Vec center = random.vec(27);
    std::vector<Shape> shapes;
    int64_t kind = random.within(0, 3);
    if (kind < 2)
      shapes = {sphere(center, size)};
    else if (kind == 2)
      shapes = box(random, center, size);
    else
      shapes = icosphere(random, center, size / 2 + 2);
    if (kind >= 2 && !is_convex(shapes, center)) continue;

    /* an eye that looks straight along an axis at some place of the body */
    int axis = static_cast<int>(random.within(0, 2)), sign = random.flip() ? 1 : -1;
    Vec forward = {0, 0, 0}, eye = center + Vec{random.within(-size, size), random.within(-size, size),
                                                random.within(-size, size)};
    forward[axis] = sign;
    eye[axis] = center[axis] - sign * (4 * size + random.within(0, INT64_C(1) << random.within(0, 26)));
    Scene scene(shapes);
    oracle::Root root;
    int seen = oracle::nearest(shapes, eye, forward, 0, UINT64_MAX, &root);
    if (seen < 0) continue;
    const Shape &s = shapes[static_cast<size_t>(seen)];
    oracle::Point point = oracle::point_at(root, eye, forward);
    Vec p, normal;
    /* A ray that only touches a ridge enters and leaves at one t; the lower number may be the face it
     * leaves by. */
    bool front = true;
    if (kind >= 2) {
      Z unused;
      front = sgn(residual(s, eye, &unused)) * sgn(residual(s, center, &unused)) < 0;
    }
    if (!front) continue;
    for (int i = 0; i < 3; i++) p[i] = static_cast<long>(oracle::coordinate(point, i).get_d());
    if (s.kind == Shape::sphere)
      normal = p - s.a;
    else
      normal = cross(s.b - s.a, s.c - s.a);
    while (largest(normal) > (1 << 20)) normal = {normal.x / 2, normal.y / 2, normal.z / 2};
    /* lights along the surface, a little above or below its horizon */
    std::vector<fc_light> lights;
    for (int i = 0; i < 3; i++) {
      Vec along = some_normal(random, normal);
      if (is_zero(along)) break;
      int64_t reach = std::max<int64_t>(1, (INT64_C(1) << random.within(0, 28)) / largest(along));
      int little = static_cast<int>(random.within(1, 12));
      Vec light =
          p + along * reach + Vec{random.any_size(little), random.any_size(little), random.any_size(little)};
      if (fits(light)) lights.push_back(light_at(light));
    }
    if (lights.empty()) continue;

    ExactCamera camera = {
        eye, axis, sign, (axis + 1) % 3, 3, 3, static_cast<uint32_t>(random.within(1, 60000))};
    uint32_t lit, faced;
    uint64_t checked = 0;
    {
      Frame frame(scene, lights, to_core(camera), 3, 3, FC_OFFSET_EXACT);
      bool exact_grid = frame.frame.view.shift <= 0;
      frame.render(3);
      for (int i = 0; i < 3; i++) {
        uint16_t x = i == 0 ? 1 : static_cast<uint16_t>(random.within(0, 2)),
                 y = i == 0 ? 1 : static_cast<uint16_t>(random.within(0, 2));
        if (frame.check_pixel(x, y, &lit, &faced) < 0) continue;
        checked++;
        if (kind >= 2) {
          Z unused;
          const Shape &face = shapes[frame.primitive[static_cast<size_t>(y) * 3 + x]];
          if (sgn(residual(face, eye, &unused)) * sgn(residual(face, center, &unused)) > 0) continue;
        }
        if ((exact_grid || kind < 2) && lit != faced)
          fail("a convex body shadows itself: pixel (%u, %u), lit %#x of the faced %#x%s", x, y, lit, faced,
               frame.text().c_str());
      }
    }
    {
      Frame frame(scene, lights, to_core(camera), 3, 3, FC_OFFSET_RESIDUAL);
      if (frame.check_pixel(1, 1, &lit, &faced) >= 0 && kind >= 2 && frame.frame.view.shift <= 0 &&
          lit != faced)
        fail("a convex body shadows itself by the residual rule: lit %#x of the faced %#x%s", lit, faced,
             frame.text().c_str());
    }
    fc_hit hit;
    if (shoot(scene, eye, forward, &hit) != 1) fail("test: lost the body");
    Vec off = step_off(scene, hit);
    for (const fc_light &light : lights) {
      Vec l = from_core(light.position);
      if (!oracle::faces(s, eye, forward, point, l)) continue;
      /* a light under the moved point's own horizon may be hidden from it: the rule's error, not acne */
      if (kind < 2 && product(off - center, l - off) < 0) continue;
      expect_segment(scene, off, l, false);
      checked++;
    }
    return checked + 1;
  }
}

/* ---- 29 ---- */

/* A plane of whole points: normal (1, a, b), lattice vectors e1 and e2 with e1 x e2 = normal; axes turned. */
struct Lattice {
  Vec normal, e1, e2;
};

Lattice lattice(Random &random, int bits) {
  int64_t a = random.any_size(bits), b = random.any_size(bits), turn = random.within(0, 2);
  Lattice l = {{1, a, b}, {-a, 1, 0}, {-b, 0, 1}};
  for (Vec *v : {&l.normal, &l.e1, &l.e2})
    for (int64_t i = 0; i < turn; i++) *v = {v->y, v->z, v->x};
  return l;
}

uint64_t minimum_cosine(Random &random) {
  for (;;) {
    Lattice l = lattice(random, 10);
    Vec p = random.vec(26), step = {0, 0, 0}, forward = {0, 0, 0};
    for (int i = 0; i < 3; i++)
      if (l.normal[i] == 1) step[i] = 1;
    int axis = static_cast<int>(random.within(0, 2)), sign = random.flip() ? 1 : -1;
    if (l.normal[axis] == 0) continue;
    forward[axis] = sign;
    int64_t distance = random.within(1, 1 << random.within(0, 26)), k = dot(l.normal, p);
    Vec eye = p - forward * distance;
    int64_t spread = random.within(1, 1 << random.within(0, 16));
    Vec a = p + l.e1 * spread, b = p + l.e2 * spread, c = p - l.e1 * spread - l.e2 * spread, d = a + b - p;
    if (!fits(a) || !fits(b) || !fits(c) || !fits(d) || std::llabs(k) > coordinate_max) continue;
    std::vector<Shape> shapes;
    if (random.flip())
      shapes = {plane(l.normal, k)};
    else
      shapes = {triangle(a, b, c), triangle(a, d, b)};
    /* one unit of n . p above the plane, in it and below: any way off along it */
    std::vector<fc_light> lights;
    std::vector<int64_t> height;
    for (int64_t h = -1; h <= 1; h++) {
      Vec light = p + step * h + l.e1 * random.any_size(16) + l.e2 * random.any_size(16);
      if (!fits(light)) continue;
      lights.push_back(light_at(light));
      height.push_back(h);
    }
    int eye_side = dot(l.normal, eye) > k ? 1 : -1;
    Scene scene(shapes);
    ExactCamera camera = {
        eye, axis, sign, (axis + 2) % 3, 3, 3, static_cast<uint32_t>(random.within(1, 1000))};
    for (int rule : {FC_OFFSET_EXACT, FC_OFFSET_RESIDUAL}) {
      Frame frame(scene, lights, to_core(camera), 3, 3, rule);
      if (frame.frame.view.shift > 0) continue;
      uint32_t expected = 0, lit;
      for (size_t i = 0; i < height.size(); i++)
        if (height[i] == eye_side) expected |= UINT32_C(1) << i;
      for (uint16_t i = 0; i < 9; i = static_cast<uint16_t>(i + 4)) {
        if (frame.check_pixel(i % 3, i / 3, &lit) < 0) continue;
        if (lit != expected)
          fail("offset rule %d: pixel %u: lights %#x, expected %#x%s", rule, i, lit, expected,
               frame.text().c_str());
      }
    }
    return 6;
  }
}

/* ---- 30 ---- */

uint64_t occluder_at_the_light(Random &random) {
  for (;;) {
    Lattice l = lattice(random, 10);
    Vec light = random.vec(26), from = random.vec(29);
    std::vector<Shape> shapes;
    bool known = true, expected = false;
    switch (random.within(0, 2)) {
      case 0: shapes = {plane(l.normal, dot(l.normal, light))}; break;
      case 1: {
        int64_t s = random.within(1, 1 << 16);
        shapes = {triangle(light + l.e1 * s, light + l.e2 * s, light - (l.e1 + l.e2) * random.within(0, s))};
        break;
      }
      default: {
        Vec row[3];
        int64_t n = quaternion_frame(random, 1 << random.within(0, 7), row), s = random.within(1, 1 << 10);
        Vec center = light + row[0] * s;
        if (!fits(center)) continue;
        shapes = {sphere(center, n * s)};
        Z inward = product(from - light, center - light);
        Z power = square_of(from - center) - Z(static_cast<long>(n * s)) * static_cast<long>(n * s);
        known = power != 0;
        expected = power > 0 && inward > 0; /* passes through to the other side first */
      }
    }
    bool good = fits(light) && fits(from);
    for (const Shape &s : shapes)
      if (s.kind == Shape::triangle) good = good && fits(s.a) && fits(s.b) && fits(s.c);
    if (!good || (shapes[0].kind == Shape::plane && std::llabs(shapes[0].r) > coordinate_max)) continue;
    Scene scene(shapes);
    if (known) {
      expect_segment(scene, from, light, expected);
      expect_segment(scene, light, from, expected);
    }
    check_segment(scene, from, light);
    /* one unit beyond, either way */
    Vec beyond = light + random.unit_step();
    if (fits(beyond)) check_segment(scene, from, beyond);
    if (shapes[0].kind == Shape::sphere) { /* from one point of the sphere to another, and to the same one */
      Vec opposite = shapes[0].a * 2 - light;
      if (fits(opposite)) check_segment(scene, light, opposite);
      check_segment(scene, light, light);
    }
    return 4;
  }
}

/* ---- 31 ---- */

uint64_t occluder_gap(Random &random) {
  for (;;) {
    int64_t gap = random.within(1, 3);
    /* moved by the residual rule, under a parallel occluder */
    Lattice l = lattice(random, 9);
    Vec p = random.vec(18), origin = random.vec(18);
    int64_t k = dot(l.normal, p);
    int up = dot(l.normal, origin) > k ? 1 : -1;
    if (dot(l.normal, origin) == k) continue;
    int64_t n2 = dot(l.normal, l.normal), rise = integer_root(gap * gap * n2 - 1) + 1; /* ceil(gap |n|) */
    Vec light = random.vec(26), d = p - origin + random.vec(5);
    if (is_zero(d) || product(l.normal, light) * up <= Z(static_cast<long>(k)) * up + static_cast<long>(rise))
      continue;
    Scene alone({plane(l.normal, k)}), both({plane(l.normal, k), plane(l.normal, k + up * rise)});
    fc_hit hit;
    if (check_ray(alone, origin, d) != 0 || shoot(alone, origin, d, &hit) != 1) continue;
    if (!fits(from_core(hit.position)) || largest(from_core(hit.position)) == coordinate_max) continue;
    Vec off = step_off(alone, hit);
    if (!fits(off)) continue;
    if (gap * gap > 3)
      expect_segment(both, off, light, true);
    else
      check_segment(both, off, light);
    expect_segment(alone, off, light, false);

    /* exactly, with no offset: a small triangle over a floor, in the way of a low light, beside the line
     * of sight */
    int axis = static_cast<int>(random.within(0, 2)), side = random.flip() ? 1 : -1, u = (axis + 1) % 3,
        v = (axis + 2) % 3;
    Vec floor = {0, 0, 0}, eye, slope = {0, 0, 0}, at, corner[3], at_light;
    floor[axis] = 1;
    slope[axis] = side;
    slope[u] = random.within(100, 2000) * (random.flip() ? 1 : -1);
    slope[v] = random.within(100, 2000) * (random.flip() ? 1 : -1);
    eye = p;
    eye[axis] += side * random.within(4, 1 << 20);
    at = p + slope * gap;
    at_light = p + slope * random.within(gap + 1, 1 << 10);
    for (Vec &c : corner) c = at;
    corner[0][u] += random.within(1, 30);
    corner[1][u] -= random.within(1, 15);
    corner[2][u] -= random.within(1, 15);
    corner[1][v] += 31;
    corner[2][v] -= 31;
    Scene scene({plane(floor, p[axis]), triangle(corner[0], corner[1], corner[2])});
    ExactCamera camera = {eye, axis, -side, u, 1, 1, static_cast<uint32_t>(random.within(1, 1000))};
    Frame frame(scene, {light_at(at_light)}, to_core(camera), 1, 1, FC_OFFSET_EXACT);
    uint32_t lit, faced;
    if (frame.frame.view.shift > 0) continue;
    if (frame.check_pixel(0, 0, &lit, &faced) != 0 || lit != 0 || faced != 1)
      fail("a gap of %lld lets light through%s", static_cast<long long>(gap), frame.text().c_str());
    return 4;
  }
}

/* ---- 32 ---- */

/* A point of a floor with something else within a unit of it: only the exact point tells their order. */
void touching_exactly(Random &random) {
  for (;;) {
    int axis = static_cast<int>(random.within(0, 2)), sign = random.flip() ? 1 : -1, across = (axis + 1) % 3;
    Vec n1 = random.direction(7), contact = random.vec(16), forward = {0, 0, 0}, far = {0, 0, 0}, p;
    if (n1[axis] == 0) continue;
    forward[axis] = sign;
    Vec eye = contact + random.vec(6) - forward * random.within(64, 1 << random.within(7, 24));
    Shape floor = plane(n1, dot(n1, contact));
    oracle::Root root;
    if (oracle::nearest({floor}, eye, forward, 0, UINT64_MAX, &root) != 0) continue;
    oracle::Point point = oracle::point_at(root, eye, forward);
    for (int i = 0; i < 3; i++) {
      Q exact = oracle::coordinate(point, i);
      p[i] = static_cast<long>(Z(exact.get_num() / exact.get_den()).get_si()) + random.within(0, 1);
    }
    std::vector<Shape> shapes = {floor};
    Vec v = random.direction(12), w = random.direction(12);
    switch (random.within(0, 2)) {
      case 0: shapes.push_back(plane(v, dot(v, p) + random.within(-1, 1))); break;
      case 1: shapes.push_back(sphere(p + v, integer_root(dot(v, v)) + random.within(0, 1))); break;
      default: shapes.push_back(triangle(p + v, p + w, p - v - w + random.unit_step())); break;
    }
    if (shapes[1].kind == Shape::sphere && shapes[1].r == 0) continue;
    /* something far away, so that the camera's grid is the world's */
    far[across] = INT64_C(3) << 28;
    shapes.push_back(triangle(eye + far, eye + far + Vec{1, 0, 0}, eye + far + Vec{0, 1, 1}));
    if (largest(p) > (1 << 27) || largest(eye) > (1 << 27)) continue;
    Scene scene(shapes);
    std::vector<fc_light> lights;
    for (int i = 0; i < 3; i++)
      lights.push_back(light_at(random.vec(static_cast<int>(random.within(4, 28)))));
    ExactCamera camera = {eye, axis, sign, across, 1, 1, static_cast<uint32_t>(random.within(1, 1000))};
    Frame frame(scene, lights, to_core(camera), 1, 1, FC_OFFSET_EXACT);
    if (frame.frame.view.shift != frame.frame.view.fine) fail("test: the camera's grid is not the world's");
    frame.check_pixel(0, 0);
    return;
  }
}

uint64_t concave_corner(Random &random) {
  for (;;) {
    Vec contact = random.vec(16), n1 = random.direction(8), n2 = random.direction(8), origin = random.vec(24),
        light = random.vec(28);
    Vec along = some_normal(random, n1);
    /* a few units from the contact */
    Vec d = contact + along * random.within(-1, 1) + random.vec(3) - origin;
    if (is_zero(d) || is_zero(cross(n1, n2))) continue;
    Shape floor = plane(n1, dot(n1, contact)), wall = plane(n2, dot(n2, contact));
    Scene alone({floor}), both({floor, wall});
    fc_hit hit;
    oracle::Root root;
    if (oracle::nearest(alone.shapes, origin, d, 0, UINT64_MAX, &root) != 0) continue;
    if (shoot(alone, origin, d, &hit) != 1) fail("the floor is lost%s", alone.text().c_str());
    if (largest(from_core(hit.position)) > coordinate_max - 8) continue;
    oracle::Point point = oracle::point_at(root, origin, d);
    if (!oracle::faces(floor, origin, d, point, light)) continue;
    Vec off = step_off(alone, hit);
    bool exact = oracle::blocked(wall, point, light), moved = check_segment(both, off, light);
    if (exact != moved) {
      Q side = -wall.r;
      for (int i = 0; i < 3; i++) side += Q(oracle::coordinate(point, i) * static_cast<long>(n2[i]));
      Q limit = Q(3 * square_of(n2));
      if (side * side > limit + limit / 1000000)
        fail("%.3f units from the contact the moved point is %s%s",
             side.get_d() / Q(sqrt(mpf_class(square_of(n2)))).get_d(), moved ? "dark" : "lit",
             both.text().c_str());
    }
    touching_exactly(random);
    /* and exactly, over floor and wall, by pictures */
    if (random.within(0, 15) == 0) {
      Vec target = origin + d, up = random.direction(8);
      if (!fits(target) || is_zero(cross(d, up))) continue;
      fc_camera camera = {};
      camera.eye = to_core(origin);
      camera.target = to_core(target);
      camera.up = to_core(up);
      camera.tan_half_fov_numerator = static_cast<uint32_t>(random.within(1, 1000));
      camera.tan_half_fov_denominator = 1000;
      Frame frame(both, {light_at(light)}, camera, 5, 3, FC_OFFSET_EXACT);
      frame.render(2);
      for (int i = 0; i < 3; i++)
        frame.check_pixel(static_cast<uint16_t>(random.within(0, 4)),
                          static_cast<uint16_t>(random.within(0, 2)));
    }
    return 3;
  }
}

} // namespace

const std::vector<Family> secondary_families = {
    {28, "acne on convex bodies", 100000, 1500, convex_body},
    {29, "minimum cosine", 300000, 52, minimum_cosine},
    {30, "occluder at the light", 1000000, 20, occluder_at_the_light},
    {31, "occluder close to the surface", 500000, 38, occluder_gap},
    {32, "concave corner", 500000, 27, concave_corner},
};
