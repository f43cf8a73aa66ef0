/* Spheres and planes: tangents, origins on and inside, refusals, planes through the eye (19-27). */
#include <algorithm>

#include "fixcast/error.h"
#include "trial.h"

using oracle::plane;
using oracle::Shape;
using oracle::sphere;

namespace {

/* A ray that touches a sphere: k steps of the direction, then s lengths across it. */
struct Tangent {
  Vec origin, direction, center;
  int64_t radius;
};

Tangent tangent(Random &random) {
  for (;;) {
    Vec row[3];
    Tangent t;
    int64_t n = quaternion_frame(random, INT64_C(1) << random.within(0, 10), row);
    int64_t most = std::max<int64_t>(1, coordinate_max / n), turn = random.within(0, 2);
    int64_t k = random.within(1, random.flip() ? std::min<int64_t>(most, 4) : most);
    int64_t s = random.within(1, random.flip() ? std::min<int64_t>(most, 4) : most);
    t.origin = random.vec(30);
    t.direction = row[turn];
    t.radius = s * n;
    t.center = t.origin + t.direction * k + row[(turn + 1) % 3] * (random.flip() ? s : -s);
    if (t.radius <= coordinate_max - 1 && fits(t.center) && fits(t.origin) && fits(t.direction * 2)) return t;
  }
}

uint64_t touching(Random &random) {
  Tangent t = tangent(random);
  Scene scene({sphere(t.center, t.radius)});
  expect_ray(scene, t.origin, t.direction, 0);
  expect_ray(scene, t.origin, t.direction * 2, 0);
  Vec away = -t.direction;
  expect_ray(scene, t.origin, away, -1);
  return 3;
}

uint64_t touching_off_by_one(Random &random) {
  Tangent t = tangent(random);
  expect_ray(Scene({sphere(t.center, t.radius + 1)}), t.origin, t.direction, 0);
  if (t.radius > 1) expect_ray(Scene({sphere(t.center, t.radius - 1)}), t.origin, t.direction, -1);
  Vec d = t.direction + random.unit_step();
  if (!is_zero(d)) check_ray(Scene({sphere(t.center, t.radius)}), t.origin, d);
  return 3;
}

uint64_t tiny_and_far(Random &random) {
  for (;;) {
    Vec center = random.vec(30), origin = random.vec(30);
    int64_t radius = random.within(1, 8);
    Vec d = center - origin + Vec{random.within(-9, 9), random.within(-9, 9), random.within(-9, 9)};
    if (!fits(d) || largest(d) < (1 << 24) || !fits(center) || !fits(origin)) continue;
    check_ray(Scene({sphere(center, radius)}), origin, d);
    return 1;
  }
}

int64_t integer_root(int64_t v) {
  int64_t r = 0;
  for (int64_t bit = INT64_C(1) << 31; bit != 0; bit >>= 1)
    if ((r + bit) * (r + bit) <= v) r += bit;
  return r;
}

uint64_t horizon(Random &random) {
  for (;;) {
    int64_t radius = random.within((1 << 19) - 1000, (1 << 19) + 1000),
            height = random.within(0, 1 << random.within(0, 12));
    Vec center = random.vec(28), row[3];
    int64_t n = quaternion_frame(random, 6, row);
    /* the eye over the surface, looking at the horizon: sin = r / (r + h) */
    int64_t away = radius + height, across = integer_root(away * away - radius * radius);
    Vec origin = center + Vec{row[0].x * away / n, row[0].y * away / n, row[0].z * away / n};
    /* direction (-across^2, across radius) / away, in the frame */
    __int128 down = -static_cast<__int128>(across) * across, aside = static_cast<__int128>(across) * radius;
    Vec d;
    for (int i = 0; i < 3; i++)
      d[i] = static_cast<int64_t>((row[0][i] * down + row[1][i] * aside) / n / away);
    d = d + Vec{random.within(-1, 1), random.within(-1, 1), random.within(-1, 1)};
    if (is_zero(d) || !fits(d)) continue;
    check_ray(Scene({sphere(center, radius)}), origin, d);
    return 1;
  }
}

uint64_t origin_on_it(Random &random) {
  for (;;) {
    Vec row[3], center = random.vec(29);
    int64_t n = quaternion_frame(random, INT64_C(1) << random.within(0, 9), row);
    int64_t s = random.within(1, std::max<int64_t>(1, (coordinate_max >> 1) / n));
    Vec origin = center + row[0] * s, d = random.direction(30);
    if (!fits(origin) || n * s > coordinate_max || !fits(center)) continue;
    Scene scene({sphere(center, n * s)});
    __int128 inward = 0;
    for (int i = 0; i < 3; i++) inward += static_cast<__int128>(d[i]) * (center[i] - origin[i]);
    expect_ray(scene, origin, d, inward > 0 ? 0 : -1);
    expect_ray(scene, origin, row[1], -1); /* along the surface */
    /* from outside, past the near root: the far one is seen from inside */
    Vec outside = origin + row[0];
    if (fits(outside)) check_ray(scene, outside, -row[0], UINT64_C(1) << 32);
    if (fits(outside)) check_ray(scene, outside, -row[0], (UINT64_C(1) << 32) - 1);
    return 4;
  }
}

uint64_t inside(Random &random) {
  for (;;) {
    Vec center = random.vec(29), origin = center;
    int64_t radius = random.within(1, INT64_C(1) << random.within(1, 29));
    if (random.flip())
      origin = center + Vec{random.within(-radius, radius), random.within(-radius, radius),
                            random.within(-radius, radius)};
    Vec g = origin - center;
    if (!fits(origin)) continue;
    if (static_cast<__int128>(g.x) * g.x + static_cast<__int128>(g.y) * g.y +
            static_cast<__int128>(g.z) * g.z >=
        static_cast<__int128>(radius) * radius)
      continue;
    expect_ray(Scene({sphere(center, radius)}), origin, random.direction(30), 0);
    return 1;
  }
}

uint64_t behind(Random &random) {
  for (;;) {
    Vec origin = random.vec(29), d = random.direction(30), center = random.vec(30);
    int64_t radius = random.within(1, INT64_C(1) << random.within(1, 29));
    __int128 along = 0, power = -static_cast<__int128>(radius) * radius;
    for (int i = 0; i < 3; i++) {
      along += static_cast<__int128>(d[i]) * (center[i] - origin[i]);
      power += static_cast<__int128>(center[i] - origin[i]) * (center[i] - origin[i]);
    }
    if (power <= 0 || along > 0 || !fits(center)) continue;
    expect_ray(Scene({sphere(center, radius)}), origin, d, -1);
    return 1;
  }
}

uint64_t refused(Random &random) {
  fc_sphere items[3];
  const fc_material white = {{1, 1, 1}, 0, NULL};
  fc_shapes table = {&fc_kind_sphere, items, nullptr, 3, 0, nullptr, nullptr, 0, 0};
  fc_scene scene = {};
  for (fc_sphere &s : items) {
    s.center = to_core(random.vec(30));
    s.radius = static_cast<int32_t>(random.within(1, coordinate_max));
    s.material = s.object = 0;
  }
  scene.shapes = &table;
  scene.shape_count = 1;
  scene.materials = &white;
  scene.material_count = 1;
  if (fc_scene_check(&scene) != FC_OK) fail("a good sphere is refused");
  int64_t bad[] = {0, -1, random.within(INT32_MIN, 0), INT32_MIN};
  int32_t radius = static_cast<int32_t>(bad[random.within(0, 3)]);
  items[random.within(0, 2)].radius = radius;
  ExactCamera camera = {{0, 0, 0}, 2, 1, 1, 4, 4, 4};
  fc_camera core_camera = to_core(camera);
  fc_frame frame;
  int64_t memory[64];
  int first = fc_scene_check(&scene),
      second = fc_frame_setup(&frame, &scene, &core_camera, nullptr, 4, 4, memory, sizeof memory);
  if (first != FC_ERR_RADIUS || second != FC_ERR_RADIUS)
    fail("radius %ld: %d and %d", static_cast<long>(radius), first, second);
  return 2;
}

uint64_t planes(Random &random) {
  Vec n = random.direction(30), origin = random.vec(30), d = random.direction(30);
  __int128 k128 = 0;
  for (int i = 0; i < 3; i++) k128 += static_cast<__int128>(n[i]) * origin[i];
  int64_t k = static_cast<int64_t>(k128);
  switch (random.within(0, 4)) {
    case 0: { /* through the eye */
      Vec small = random.direction(15);
      Vec o = random.vec(14);
      expect_ray(Scene({plane(small, dot(small, o))}), o, d, -1);
      break;
    }
    case 1: { /* parallel to the ray, at any distance */
      Vec small = random.direction(14);
      Vec across = some_normal(random, small);
      expect_ray(Scene({plane(small, random.within(-coordinate_max, coordinate_max))}), origin, across, -1);
      break;
    }
    case 2: { /* two, 1 unit apart, far away */
      Vec small = random.direction(8);
      int64_t far = random.within(-coordinate_max + 1, coordinate_max - 1);
      std::vector<Shape> both = {plane(small, far), plane(small, far + (random.flip() ? 1 : -1))};
      Vec o = random.vec(20);
      check_ray(Scene(both), o, d);
      Vec along = d;
      if (dot(small, along) != 0) check_ray(Scene(both), o, along);
      break;
    }
    case 3: { /* the widest offsets */
      int64_t exponent = random.within(0, 32);
      Scene scene({plane(n, (random.within(-coordinate_max, coordinate_max)) * (INT64_C(1) << exponent))});
      check_ray(scene, origin, d);
      check_ray(scene, origin, -d);
      break;
    }
    default: { /* just beside the eye, grazing */
      if (std::llabs(k) > coordinate_max) return planes(random);
      Scene scene({plane(n, k + random.within(-2, 2))});
      check_ray(scene, origin, d);
      Vec across = some_normal(random, {n.x >> 4, n.y >> 4, n.z >> 4});
      if (!is_zero(across) && fits(across)) {
        check_ray(scene, origin, across);
        check_ray(scene, origin, -across);
      }
    }
  }
  return 2;
}

} // namespace

const std::vector<Family> sphere_families = {
    {19, "tangent", 300000, 100, touching},
    {20, "tangent, one unit off", 300000, 100, touching_off_by_one},
    {21, "tiny and far", 1000000, 18, tiny_and_far},
    {22, "horizon", 500000, 40, horizon},
    {23, "origin on the sphere", 300000, 160, origin_on_it},
    {24, "origin inside", 500000, 52, inside},
    {25, "behind", 1000000, 4, behind},
    {26, "radius refused", 100000, 1.5, refused},
    {27, "planes", 1000000, 30, planes},
};
