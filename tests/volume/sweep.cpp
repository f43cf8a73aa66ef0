/* Swept spheres of volume_extra.h: the decision and the tick of first contact, by minima of exact distances. */
#include "exact_convex.h"
#include "trials.h"

extern "C" {
#include "fixcast/volume_extra.h"
}

using exact::Point;
using exact::Q;

namespace {

constexpr uint32_t ticks = 1 << 16;

/* Whether an answer and its tick are right, `touches_by(t)` being the exact decision for 0..t. */
template <typename TouchesBy>
void check(const char *what, int got, uint32_t tick, TouchesBy touches_by) {
  bool expected = touches_by(Q(1));
  saw(expected);
  if (got != (expected ? 1 : 0)) wrong("%s: %d is right (%d)", what, expected, got);
  if (!expected) {
    if (tick != 77777) wrong("%s: a miss wrote the tick", what);
    return;
  }
  if (tick > ticks) wrong("%s: tick %u", what, tick);
  if (!touches_by(Q(tick, ticks))) wrong("%s: apart at tick %u already said to touch", what, tick);
  if (tick > 0 && touches_by(Q(tick - 1, ticks))) wrong("%s: touches before tick %u", what, tick);
}

fc_sphere ball(Vec center, int64_t radius) { return {to_core(center), static_cast<int32_t>(radius), 0, 0}; }
bool radius_fits(int64_t r) { return r >= 1 && r <= coordinate_max; }

void against_planes(Random &random) {
  int bits = static_cast<int>(random.within(2, 30));
  Vec a = random.vec(bits), b = random.vec(bits), n = random.direction(bits);
  int64_t r = std::llabs(random.any_size(bits > 3 ? bits - 2 : bits)) + 1, d = random.any_size(30);
  int8_t exponent = static_cast<int8_t>(random.within(0, 32));
  if (random.flip()) { /* ends with the sphere touching exactly, or one off */
    static const int64_t triples[][4] = {{1, 0, 0, 1}, {1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {-2, 6, 9, 11}, {0, 3, -4, 5}};
    const int64_t *t = triples[random.within(0, 5)];
    n = {t[0], t[1], t[2]};
    d = -dot(n, random.flip() ? b : a) + (random.flip() ? r : -r) * t[3] + random.within(-1, 1);
    exponent = 0;
  }
  if (!radius_fits(r) || std::llabs(d) > coordinate_max) return;
  fc_sphere sphere = ball(a, r);
  fc_plane plane = {to_core(n), static_cast<int32_t>(d), exponent, 0, 0};
  fc_vec3 to = to_core(b);
  uint32_t tick = 77777;
  int got = fc_sweep_sphere_plane(&sphere, &to, &plane, &tick);
  Q offset = exact::whole(d) * Q(mpz_class(1) << static_cast<unsigned>(exponent));
  Q f0 = exact::dot(exact::point(n), exact::point(a)) + offset,
    f1 = exact::dot(exact::point(n), exact::point(b)) + offset;
  Q reach2 = exact::whole(r) * exact::whole(r) * exact::dot(exact::point(n), exact::point(n));
  check("plane", got, tick, [&](const Q &t) {
    /* the least of |f| on 0..t: at an end, or 0 where it changes its sign */
    Q f = f0 + (f1 - f0) * t, least = sgn(f0) * sgn(f) <= 0 ? Q(0) : Q(abs(f0) < abs(f) ? abs(f0) : abs(f));
    return least * least <= reach2;
  });
  if (fc_sweep_sphere_plane(&sphere, &to, &plane, nullptr) != got) wrong("without a tick the answer differs");
}

void against_spheres(Random &random) {
  int bits = static_cast<int>(random.within(2, 30));
  Vec a = random.vec(bits), a_to = random.vec(bits), b = random.vec(bits), b_to = random.vec(bits);
  int64_t r = std::llabs(random.any_size(bits)) + 1,
          s = std::llabs(random.any_size(bits > 4 ? bits - 3 : bits)) + 1;
  if (random
          .flip()) { /* passes at exactly r + s, or one off: across the shortest line of a quaternion's frame */
    static const int64_t frames[][9] = {{1, 2, 2, 2, 1, -2, 2, -2, 1},
                                        {2, 3, 6, 3, -6, 2, 6, 2, -3},
                                        {1, 0, 0, 0, 1, 0, 0, 0, 1},
                                        {4, 3, 0, -3, 4, 0, 0, 0, 5}};
    const int64_t lengths[] = {3, 7, 1, 5};
    int64_t f = random.within(0, 3), k = random.within(1, (INT64_C(1) << bits) / 32 + 1);
    const int64_t *m = frames[f];
    Vec across = {m[0] * k, m[1] * k, m[2] * k}, along = {m[3], m[4], m[5]};
    b_to = b;
    Vec foot = b + across;
    a = foot + along * random.within(-k, k);
    a_to = foot + along * random.within(-k, k);
    int64_t both = lengths[f] * k + random.within(-1, 1);
    r = random.within(1, both > 1 ? both - 1 : 1);
    s = both - r;
  }
  if (!radius_fits(r) || !radius_fits(s) || !fits(a) || !fits(a_to) || !fits(b) || !fits(b_to)) return;
  fc_sphere one = ball(a, r), two = ball(b, s);
  fc_vec3 one_to = to_core(a_to), two_to = to_core(b_to);
  uint32_t tick = 77777, mirrored = 77777;
  int got = fc_sweep_sphere_sphere(&one, &one_to, &two, &two_to, &tick);
  if (fc_sweep_sphere_sphere(&two, &two_to, &one, &one_to, &mirrored) != got || mirrored != tick)
    wrong("not the same the other way about");
  Point p = exact::point(a) - exact::point(b), v = exact::point(a_to) - exact::point(b_to) - p;
  Q reach = exact::whole(r + s), A = exact::dot(v, v), B = exact::dot(p, v), C = exact::dot(p, p);
  check("sphere", got, tick, [&](const Q &t) {
    /* the least of C + 2 B s + A s^2 on 0..t */
    Q at = sgn(A) == 0 ? Q(0) : Q(-B / A);
    if (sgn(at) < 0) at = 0;
    if (at > t) at = t;
    return C + 2 * B * at + A * at * at <= reach * reach;
  });
}

void check_triangle(Vec a, Vec b, int64_t r, const Vec v[3]) {
  for (int i = 0; i < 3; i++)
    if (!fits(v[i])) return;
  if (!radius_fits(r) || !fits(a) || !fits(b)) return;
  fc_sphere sphere = ball(a, r);
  fc_vec3 to = to_core(b), triangle[3] = {to_core(v[0]), to_core(v[1]), to_core(v[2])};
  uint32_t tick = 77777;
  int got = fc_sweep_sphere_triangle(&sphere, &to, triangle, &tick);
  Point p[3] = {exact::point(v[0]), exact::point(v[1]), exact::point(v[2])}, from = exact::point(a),
        along = exact::point(b) - from;
  Q reach2 = exact::whole(r) * exact::whole(r);
  std::string what = "triangle " + text(v[0]) + text(v[1]) + text(v[2]) + ", from " + text(a) + " to " +
                     text(b) + ", radius " + std::to_string(r);
  check(what.c_str(), got, tick,
        [&](const Q &t) { return exact::segment_triangle_distance2(from, from + along * t, p) <= reach2; });
}

void against_triangles(Random &random) {
  int bits = static_cast<int>(random.flip() ? random.within(2, 30) : random.within(1, 5));
  Vec v[3] = {random.vec(bits), random.vec(bits), random.vec(bits)}, a = random.vec(bits),
      b = random.vec(bits);
  int64_t r = std::llabs(random.any_size(bits > 3 ? bits - 2 : bits)) + 1;
  switch (random.within(0, 9)) {
    case 0: v[1] = v[0]; break;
    case 1: v[1] = v[2] = v[0]; break;
    case 2: v[2] = v[0] + (v[0] - v[1]) * random.within(-2, 2); break; /* in line */
    case 3: b = a; break;                                              /* at rest */
    case 4: a.z = b.z = v[0].z = v[1].z = v[2].z; break;               /* along the plane */
    case 5: {                                                          /* over the face by exactly r, in a plane of the axes */
      v[0].z = v[1].z = v[2].z;
      a.z = b.z = v[0].z + r + random.within(-1, 1);
      break;
    }
    default: break;
  }
  check_triangle(a, b, r, v);
}

/* Past a corner or an edge at exactly r, or one off. */
void passing_corners_and_edges(Random &random) {
  int64_t k = random.within(1, INT64_C(1) << random.within(1, 24));
  Vec corner = random.vec(20), out = {2 * k, 3 * k, 6 * k}; /* 7 k away */
  Vec along = Vec{3, -6, 2} * random.within(-k, k), back = Vec{6, 2, -3} * random.within(-k, k);
  int64_t r = 7 * k + random.within(-1, 1);
  Vec v[3] = {corner, corner - out + back, corner - out * random.within(1, 3) - back};
  if (random.flip()) { /* an edge through the corner point, across the path */
    v[0] = corner + Vec{6, 2, -3} * random.within(0, k);
    v[1] = corner - Vec{6, 2, -3} * random.within(0, k);
  }
  Vec a = corner + out + along * random.within(-2, 2), b = corner + out + along * random.within(-2, 2);
  if (random.flip()) a = a + out * random.within(0, 3); /* comes down on it */
  check_triangle(a, b, r, v);
}

void extremes(Random &random) {
  auto any = [&] {
    Vec p;
    for (int i = 0; i < 3; i++)
      p[i] = (random.flip() ? 1 : -1) * (coordinate_max - (random.within(0, 3) == 0 ? 1 : 0));
    return p;
  };
  Vec v[3] = {any(), any(), any()};
  check_triangle(any(), any(), random.flip() ? 1 : coordinate_max, v);
  fc_sphere one = ball(any(), 1 + random.within(0, 1) * (coordinate_max - 1)), two = ball(any(), 1);
  fc_vec3 one_to = to_core(any()), two_to = to_core(any());
  uint32_t tick = 77777;
  int got = fc_sweep_sphere_sphere(&one, &one_to, &two, &two_to, &tick);
  Point p = exact::point(from_core(one.center)) - exact::point(from_core(two.center)),
        w = exact::point(from_core(one_to)) - exact::point(from_core(two_to)) - p;
  Q A = exact::dot(w, w), B = exact::dot(p, w), C = exact::dot(p, p), reach = exact::whole(one.radius) + 1;
  check("extreme spheres", got, tick, [&](const Q &t) {
    Q at = sgn(A) == 0 ? Q(0) : Q(-B / A);
    if (sgn(at) < 0) at = 0;
    if (at > t) at = t;
    return C + 2 * B * at + A * at * at <= reach * reach;
  });
}

void bad_arguments_are_refused(Random &) {
  const fc_vec3 zero = {0, 0, 0}, far = {INT32_MIN, 0, 0}, t[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                astray[3] = {{0, 0, 0}, {1, 0, 0}, far};
  const fc_sphere s = {{5, 5, 5}, 1, 0, 0}, hole = {{5, 5, 5}, 0, 0, 0}, out = {far, 1, 0, 0};
  const fc_plane plane = {{0, 1, 0}, 0, 0, 0, 0}, flat = {{0, 0, 0}, 0, 0, 0, 0};
  uint32_t tick = 77777;
  const struct {
    int got, expected;
  } cases[] = {{fc_sweep_sphere_plane(nullptr, &zero, &plane, &tick), FC_ERR_NULL},
               {fc_sweep_sphere_plane(&s, nullptr, &plane, &tick), FC_ERR_NULL},
               {fc_sweep_sphere_plane(&s, &zero, nullptr, &tick), FC_ERR_NULL},
               {fc_sweep_sphere_plane(&s, &far, &plane, &tick), FC_ERR_COORDINATE},
               {fc_sweep_sphere_plane(&s, &zero, &flat, &tick), FC_ERR_NORMAL},
               {fc_sweep_sphere_plane(&hole, &zero, &plane, &tick), FC_ERR_RADIUS},
               {fc_sweep_sphere_sphere(&s, &zero, nullptr, &zero, &tick), FC_ERR_NULL},
               {fc_sweep_sphere_sphere(&s, nullptr, &s, &zero, &tick), FC_ERR_NULL},
               {fc_sweep_sphere_sphere(&s, &zero, &hole, &zero, &tick), FC_ERR_RADIUS},
               {fc_sweep_sphere_sphere(&out, &zero, &s, &zero, &tick), FC_ERR_COORDINATE},
               {fc_sweep_sphere_sphere(&s, &zero, &s, &far, &tick), FC_ERR_COORDINATE},
               {fc_sweep_sphere_triangle(nullptr, &zero, t, &tick), FC_ERR_NULL},
               {fc_sweep_sphere_triangle(&s, &zero, nullptr, &tick), FC_ERR_NULL},
               {fc_sweep_sphere_triangle(&s, &zero, astray, &tick), FC_ERR_COORDINATE},
               {fc_sweep_sphere_triangle(&hole, &zero, t, &tick), FC_ERR_RADIUS},
               {fc_sweep_sphere_triangle(&s, &far, t, &tick), FC_ERR_COORDINATE}};
  int i = 0;
  for (const auto &c : cases) {
    if (c.got != c.expected) wrong("case %d: error %d is right (%d)", i, c.expected, c.got);
    i++;
  }
  if (tick != 77777) wrong("a tick was written");
}

} // namespace

int main(int argc, char **argv) {
  return run_trials(argc, argv,
                    {{"bad_arguments_are_refused", 1, bad_arguments_are_refused},
                     {"against_planes", 20000, against_planes},
                     {"against_spheres", 20000, against_spheres},
                     {"against_triangles", 6000, against_triangles},
                     {"passing_corners_and_edges", 4000, passing_corners_and_edges},
                     {"extremes", 2000, extremes}});
}
