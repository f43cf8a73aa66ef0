/* volume.h against exact fractions: random sizes, touching exactly, one off, degenerate, parallel, extreme. */
#include "exact.h"
#include "trials.h"

extern "C" {
#include "fixcast/volume.h"
}

using exact::Q;

namespace {

/* Any vector within the range, all sizes. */
Vec any(Random &random, int bits) {
  Vec v = random.vec(bits);
  if (bits == 30 && random.within(0, 7) == 0)
    for (int i = 0; i < 3; i++)
      if (random.flip()) v[i] = random.flip() ? coordinate_max : -coordinate_max;
  return v;
}
int any_bits(Random &random) {
  return static_cast<int>(random.flip() ? random.within(1, 30) : random.within(1, 4));
}

struct Box {
  Vec low, high;
  fc_aabb core() const { return {to_core(low), to_core(high)}; }
  std::string text() const { return ::text(low) + " .. " + ::text(high); }
};
Box box_of(Vec a, Vec b) {
  Box box;
  for (int i = 0; i < 3; i++) {
    box.low[i] = a[i] < b[i] ? a[i] : b[i];
    box.high[i] = a[i] < b[i] ? b[i] : a[i];
  }
  return box;
}
Box any_box(Random &random, int bits) {
  Vec a = any(random, bits), b = any(random, bits);
  for (int i = 0; i < 3; i++)
    if (random.within(0, 9) == 0) b[i] = a[i]; /* flat */
  return box_of(a, b);
}
Vec corner(const Box &box, int i) {
  return {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z};
}

fc_sphere ball(Vec center, int64_t radius) { return {to_core(center), static_cast<int32_t>(radius), 0, 0}; }

void check_ray(Vec o, Vec d, const Box &box) {
  fc_vec3 origin = to_core(o), direction = to_core(d);
  fc_aabb core = box.core();
  fc_span span = {-7, -7, -7, -7};
  int got = fc_ray_aabb(&origin, &direction, &core, &span);
  Q enter, leave;
  bool expected = exact::ray_meets(o, d, exact::box(box.low, box.high), &enter, &leave);
  saw(expected);
  if (got != (expected ? 1 : 0) || fc_ray_aabb(&origin, &direction, &core, nullptr) != got)
    wrong("ray %s along %s, box %s: %d is right (%d)", text(o).c_str(), text(d).c_str(), box.text().c_str(),
          expected, got);
  if (!expected && span.enter != -7) wrong("a miss wrote the span");
  if (!expected) return;
  if (span.enter_of <= 0 || span.leave_of <= 0)
    wrong("denominators %lld %lld", static_cast<long long>(span.enter_of),
          static_cast<long long>(span.leave_of));
  if (exact::whole(span.enter) / exact::whole(span.enter_of) != enter ||
      exact::whole(span.leave) / exact::whole(span.leave_of) != leave)
    wrong("ray %s along %s, box %s: t is %s .. %s, not %lld/%lld .. %lld/%lld", text(o).c_str(),
          text(d).c_str(), box.text().c_str(), enter.get_str().c_str(), leave.get_str().c_str(),
          static_cast<long long>(span.enter), static_cast<long long>(span.enter_of),
          static_cast<long long>(span.leave), static_cast<long long>(span.leave_of));
}

void ray_against_box(Random &random) {
  int bits = any_bits(random);
  Box box = any_box(random, bits);
  Vec o = any(random, bits), d = random.direction(bits);
  for (int i = 0; i < 3; i++)
    if (random.within(0, 4) == 0) d[i] = 0; /* parallel to a slab */
  if (random.within(0, 4) == 0) {           /* through a point of an edge or corner, or one beside it */
    Vec p = corner(box, static_cast<int>(random.within(0, 7)));
    int along = static_cast<int>(random.within(0, 2));
    p[along] = random.within(box.low[along], box.high[along]);
    d = p - o;
    if (random.flip()) d = d + random.unit_step();
  }
  if (random.within(0, 9) == 0)
    o[static_cast<int>(random.within(0, 2))] = random.flip() ? box.low.x : box.high.z; /* in a face's plane */
  if (is_zero(d) || !fits(d) || !fits(o)) return;
  check_ray(o, d, box);
}

std::string plane_text(const fc_plane &p) {
  return text(from_core(p.normal)) + " . p + " + std::to_string(p.d) + " * 2^" +
         std::to_string(p.d_exponent) + " = 0";
}
Q plane_value(const fc_plane &p, Vec at) {
  mpz_class shift = mpz_class(1) << static_cast<unsigned>(p.d_exponent);
  return exact::dot(exact::point(from_core(p.normal)), exact::point(at)) + exact::whole(p.d) * Q(shift);
}
int side(int sign) { return sign == 0 ? FC_SIDE_ON : sign > 0 ? FC_SIDE_FRONT
                                                              : FC_SIDE_BACK; }

/* A plane through, or a few units beside, a point. */
fc_plane plane_near(Random &random, Vec p, int bits) {
  for (;;) {
    Vec n = random.direction(bits);
    if (random.within(0, 4) == 0) n[static_cast<int>(random.within(0, 2))] = 0;
    if (is_zero(n)) continue;
    int64_t d = -dot(n, p) + (random.flip() ? random.any_size(2) : random.any_size(bits));
    int8_t exponent = 0;
    while (std::llabs(d) > coordinate_max) {
      d /= 2; /* towards 0: beside the point then */
      exponent++;
    }
    return {to_core(n), static_cast<int32_t>(d), exponent, 0, 0};
  }
}

void point_against_plane(Random &random) {
  int bits = any_bits(random);
  Vec p = any(random, bits);
  fc_plane plane = plane_near(random, p, bits);
  fc_vec3 point = to_core(p);
  int got = fc_point_plane(&point, &plane), expected = side(sgn(plane_value(plane, p)));
  saw(expected == FC_SIDE_ON);
  if (got != expected)
    wrong("%s, %s: %d is right (%d)", text(p).c_str(), plane_text(plane).c_str(), expected, got);
}

void extremes_of_planes(Random &random) {
  fc_plane plane = {
      {0, 0, 0}, static_cast<int32_t>(random.flip() ? coordinate_max : -coordinate_max), 32, 0, 0};
  Vec p;
  Vec n;
  for (int i = 0; i < 3; i++) {
    p[i] = random.flip() ? coordinate_max : -coordinate_max;
    n[i] = random.flip() ? coordinate_max : -coordinate_max;
  }
  plane.normal = to_core(n);
  fc_vec3 point = to_core(p);
  fc_sphere sphere = ball(p, 1);
  Box box = {{-coordinate_max, -coordinate_max, -coordinate_max},
             {coordinate_max, coordinate_max, coordinate_max}};
  fc_aabb core = box.core();
  int expected = side(sgn(plane_value(plane, p)));
  if (fc_point_plane(&point, &plane) != expected || fc_sphere_plane(&sphere, &plane) != expected ||
      fc_aabb_plane(&core, &plane) != side(sgn(Q(plane.d))))
    wrong("%s, %s", text(p).c_str(), plane_text(plane).c_str());
  plane.d = 0;
  if (fc_aabb_plane(&core, &plane) != FC_SIDE_ON) wrong("a plane through the largest box");
}

/* Touching exactly: normals of a whole length (quaternion frames), the center r normals away. */
void sphere_against_plane(Random &random) {
  int bits = any_bits(random);
  Vec c = any(random, bits);
  int64_t radius = std::llabs(random.any_size(bits)) + 1;
  fc_plane plane = plane_near(random, c, bits);
  if (random.flip()) {
    static const int64_t triples[][4] = {{1, 0, 0, 1}, {1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {-2, 6, 9, 11}, {0, 3, -4, 5}, {2, -10, 11, 15}};
    const int64_t *t = triples[random.within(0, 6)];
    Vec n = {t[0], t[1], t[2]};
    int64_t d = -dot(n, c) + (random.flip() ? 1 : -1) * radius * t[3] + random.within(-1, 1);
    if (std::llabs(d) > coordinate_max) return;
    plane = {to_core(n), static_cast<int32_t>(d), 0, 0, 0};
  }
  if (radius > coordinate_max) return;
  fc_sphere sphere = ball(c, radius);
  int got = fc_sphere_plane(&sphere, &plane);
  /* the nearest point of the plane, and how far it is */
  exact::Point n = exact::point(from_core(plane.normal)), center = exact::point(c);
  Q value = plane_value(plane, c);
  exact::Point foot = center - n * Q(value / exact::dot(n, n)), to = foot - center;
  int expected = exact::dot(to, to) <= exact::whole(radius) * exact::whole(radius)
                     ? static_cast<int>(FC_SIDE_ON)
                     : side(sgn(value));
  saw(expected == FC_SIDE_ON);
  if (got != expected)
    wrong("%s radius %lld, %s: %d is right (%d)", text(c).c_str(), static_cast<long long>(radius),
          plane_text(plane).c_str(), expected, got);
}

void box_against_plane(Random &random) {
  int bits = any_bits(random);
  Box box = any_box(random, bits);
  fc_plane plane = plane_near(
      random, random.flip() ? corner(box, static_cast<int>(random.within(0, 7))) : any(random, bits), bits);
  fc_aabb core = box.core();
  int got = fc_aabb_plane(&core, &plane), front = 0, back = 0;
  for (int i = 0; i < 8; i++) {
    int s = sgn(plane_value(plane, corner(box, i)));
    front += s > 0;
    back += s < 0;
  }
  int expected = front == 8 ? FC_SIDE_FRONT : back == 8 ? FC_SIDE_BACK
                                                        : FC_SIDE_ON;
  saw(expected == FC_SIDE_ON);
  if (got != expected)
    wrong("%s, %s: %d is right (%d)", box.text().c_str(), plane_text(plane).c_str(), expected, got);
}

void sphere_against_sphere(Random &random) {
  int bits = any_bits(random);
  Vec a = any(random, bits), b = any(random, bits);
  int64_t r = std::llabs(random.any_size(bits)) + 1, s = std::llabs(random.any_size(bits)) + 1;
  if (random.flip()) { /* touching, or one unit off: whole distances */
    Vec row[3];
    static const int64_t triples[][4] = {{1, 0, 0, 1}, {1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {-2, 6, 9, 11}, {2, -10, 11, 15}};
    const int64_t *t = triples[random.within(0, 5)];
    int64_t k = random.within(1, (INT64_C(1) << bits) / 4 + 1), length = k * t[3];
    row[0] = {k * t[0], k * t[1], k * t[2]};
    b = a + row[0];
    r = random.within(1, length > 1 ? length - 1 : 1);
    s = length - r + random.within(-1, 1);
  }
  if (!fits(b) || r < 1 || s < 1 || r > coordinate_max || s > coordinate_max) return;
  fc_sphere one = ball(a, r), two = ball(b, s);
  exact::Point to = exact::point(a) - exact::point(b);
  Q reach = exact::whole(r) + exact::whole(s);
  int got = fc_sphere_sphere(&one, &two);
  bool expected = exact::dot(to, to) <= reach * reach;
  saw(expected);
  if (got != (expected ? 1 : 0) || fc_sphere_sphere(&two, &one) != got)
    wrong("%s radius %lld, %s radius %lld: %d is right (%d)", text(a).c_str(), static_cast<long long>(r),
          text(b).c_str(), static_cast<long long>(s), expected, got);
}

void box_against_box(Random &random) {
  int bits = any_bits(random);
  Box a = any_box(random, bits), b = any_box(random, bits);
  int axis = static_cast<int>(random.within(0, 2));
  if (random.flip()) { /* face to face, or one off */
    int64_t width = b.high[axis] - b.low[axis];
    b.low[axis] = a.high[axis] + random.within(-1, 1);
    b.high[axis] = b.low[axis] + width;
  }
  if (!fits(b.low) || !fits(b.high)) return;
  fc_aabb one = a.core(), two = b.core();
  /* the box that both share is not empty */
  bool expected = true;
  for (int i = 0; i < 3; i++) {
    int64_t low = a.low[i] > b.low[i] ? a.low[i] : b.low[i],
            high = a.high[i] < b.high[i] ? a.high[i] : b.high[i];
    expected = expected && low <= high;
  }
  int got = fc_aabb_aabb(&one, &two);
  saw(expected);
  if (got != (expected ? 1 : 0) || fc_aabb_aabb(&two, &one) != got)
    wrong("%s, %s: %d is right (%d)", a.text().c_str(), b.text().c_str(), expected, got);
}

void check_triangle(const Vec t[3], const Box &box) {
  fc_vec3 triangle[3] = {to_core(t[0]), to_core(t[1]), to_core(t[2])};
  fc_aabb core = box.core();
  bool expected = exact::polygon_meets({exact::point(t[0]), exact::point(t[1]), exact::point(t[2])},
                                       exact::box(box.low, box.high));
  int got = fc_triangle_aabb(triangle, &core);
  saw(expected);
  if (got != (expected ? 1 : 0))
    wrong("%s %s %s, box %s: %d is right (%d)", text(t[0]).c_str(), text(t[1]).c_str(), text(t[2]).c_str(),
          box.text().c_str(), expected, got);
}

void triangle_against_box(Random &random) {
  int bits = any_bits(random);
  Vec t[3] = {any(random, bits), any(random, bits), any(random, bits)};
  Box box = any_box(random, static_cast<int>(random.within(1, bits)));
  Vec shift = any(random, bits);
  switch (random.within(0, 9)) {
    case 0: t[1] = t[0]; break;        /* a segment */
    case 1: t[1] = t[2] = t[0]; break; /* a point */
    case 2: {                          /* collinear */
      Vec step = random.vec(bits > 4 ? bits - 4 : 1);
      t[1] = t[0] + step * random.within(-3, 3);
      t[2] = t[0] + step * random.within(-3, 3);
      break;
    }
    case 3: { /* in a plane of the axes, at the box's face or beside it */
      int axis = static_cast<int>(random.within(0, 2));
      int64_t at = (random.flip() ? box.low[axis] : box.high[axis]) + random.within(-1, 1);
      for (Vec &v : t) v[axis] = at;
      break;
    }
    default: break;
  }
  if (random.flip() && fits(box.low + shift) && fits(box.high + shift)) {
    box.low = box.low + shift;
    box.high = box.high + shift;
  }
  for (Vec v : t)
    if (!fits(v)) return;
  check_triangle(t, box);
}

/* A corner of the box, or a point of one of its edges, lies exactly on the triangle's inside or edge; or one unit off. */
void triangle_touches_box(Random &random) {
  int bits = any_bits(random);
  Vec p = any(random, bits), u = random.direction(bits), v = random.direction(bits);
  Vec t[3] = {p + u * random.within(0, 3), p + v * random.within(0, 3),
              p - u * random.within(0, 2) - v * random.within(0, 2)};
  if (random.within(0, 3) == 0) t[1] = p - u * random.within(0, 2); /* p on an edge */
  Vec n = cross({(t[1] - t[0]).x >> 8, (t[1] - t[0]).y >> 8, (t[1] - t[0]).z >> 8},
                {(t[2] - t[0]).x >> 8, (t[2] - t[0]).y >> 8, (t[2] - t[0]).z >> 8});
  Vec size = {std::llabs(random.any_size(bits)), std::llabs(random.any_size(bits)),
              std::llabs(random.any_size(bits))};
  Box box;
  bool outside = random.flip();
  for (int i = 0; i < 3; i++) { /* to the side that the normal points to */
    bool up = random.within(0, 9) == 0 ? random.flip() : (n[i] > 0) == outside;
    box.low[i] = up ? p[i] : p[i] - size[i];
    box.high[i] = up ? p[i] + size[i] : p[i];
  }
  int64_t off = random.within(0, 2);
  if (off != 0) {
    Vec step = random.unit_step();
    box.low = box.low + step;
    box.high = box.high + step;
  }
  for (Vec w : t)
    if (!fits(w)) return;
  if (!fits(box.low) || !fits(box.high)) return;
  check_triangle(t, box);
}

/* An edge of the triangle against an edge of the box: only a cross product tells. */
void triangle_edge_against_box_edge(Random &random) {
  int bits = static_cast<int>(random.within(4, 29)), k = static_cast<int>(random.within(0, 2));
  Box box = any_box(random, bits);
  Vec p = corner(box, static_cast<int>(random.within(0, 7)));
  p[k] = random.within(box.low[k], box.high[k]);
  Vec outward = {0, 0, 0};
  for (int i = 0; i < 3; i++)
    if (i != k) outward[i] = p[i] == box.high[i] ? 1 : -1;
  /* an edge through p + off, along the bisector's normal but for a tilt */
  Vec along = {0, 0, 0};
  along[(k + 1) % 3] = outward[(k + 2) % 3] * random.within(1, 9);
  along[(k + 2) % 3] = -outward[(k + 1) % 3] * random.within(1, 9);
  along[k] = random.within(-9, 9);
  Vec off = random.within(0, 2) == 0 ? Vec{0, 0, 0} : random.unit_step();
  int64_t reach = random.within(1, (INT64_C(1) << bits) / 9);
  Vec t[3] = {p + off + along * reach, p + off - along * random.within(1, reach),
              p + off + outward * random.within(1, reach) + along * random.within(-1, 1)};
  for (Vec v : t)
    if (!fits(v)) return;
  check_triangle(t, box);
}

void extremes_of_triangles(Random &random) {
  Vec t[3];
  for (Vec &v : t)
    for (int i = 0; i < 3; i++) v[i] = random.flip() ? coordinate_max : -coordinate_max;
  Vec low, high;
  for (int i = 0; i < 3; i++) {
    low[i] = random.flip() ? -coordinate_max : coordinate_max - random.within(0, 2);
    high[i] = random.flip() || low[i] > 0 ? coordinate_max : -coordinate_max + random.within(0, 2);
    if (low[i] > high[i]) high[i] = low[i];
  }
  check_triangle(t, {low, high});
  Vec d = t[0] - t[1];
  for (int i = 0; i < 3; i++) d[i] /= 2;
  if (!is_zero(d)) check_ray(t[2], d, {low, high});
}

void bad_arguments_are_refused(Random &) {
  const int32_t beyond = FC_COORDINATE_MAX + 1;
  const fc_vec3 zero = {0, 0, 0}, one = {1, 1, 1}, x = {1, 0, 0}, far = {0, beyond, 0},
                low = {0, 0, INT32_MIN};
  const fc_aabb box = {zero, one}, inverted = {one, {2, 0, 2}}, outside = {low, one};
  const fc_sphere sphere = {one, 1, 0, 0}, point = {one, 0, 0, 0}, hole = {one, -1, 0, 0},
                  out = {far, 1, 0, 0}, large = {one, beyond, 0, 0};
  const fc_plane plane = {x, 0, 0, 0, 0}, flat = {zero, 0, 0, 0, 0}, up = {x, 1, 33, 0, 0},
                 down = {x, 1, -1, 0, 0}, off = {x, beyond, 0, 0, 0};
  const fc_vec3 triangle[3] = {zero, one, x}, astray[3] = {zero, one, far};
  fc_span span;
  const struct {
    int got, expected;
  } cases[] = {
      {fc_ray_aabb(nullptr, &x, &box, &span), FC_ERR_NULL},
      {fc_ray_aabb(&zero, nullptr, &box, &span), FC_ERR_NULL},
      {fc_ray_aabb(&zero, &x, nullptr, &span), FC_ERR_NULL},
      {fc_ray_aabb(&zero, &zero, &box, &span), FC_ERR_DIRECTION},
      {fc_ray_aabb(&far, &x, &box, &span), FC_ERR_COORDINATE},
      {fc_ray_aabb(&zero, &low, &box, &span), FC_ERR_COORDINATE},
      {fc_ray_aabb(&zero, &x, &inverted, &span), FC_ERR_COORDINATE},
      {fc_ray_aabb(&zero, &x, &outside, &span), FC_ERR_COORDINATE},
      {fc_point_plane(nullptr, &plane), FC_ERR_NULL},
      {fc_point_plane(&one, nullptr), FC_ERR_NULL},
      {fc_point_plane(&far, &plane), FC_ERR_COORDINATE},
      {fc_point_plane(&one, &flat), FC_ERR_NORMAL},
      {fc_point_plane(&one, &up), FC_ERR_EXPONENT},
      {fc_point_plane(&one, &down), FC_ERR_EXPONENT},
      {fc_point_plane(&one, &off), FC_ERR_COORDINATE},
      {fc_sphere_plane(nullptr, &plane), FC_ERR_NULL},
      {fc_sphere_plane(&point, &plane), FC_ERR_RADIUS},
      {fc_sphere_plane(&hole, &plane), FC_ERR_RADIUS},
      {fc_sphere_plane(&out, &plane), FC_ERR_COORDINATE},
      {fc_sphere_plane(&large, &plane), FC_ERR_COORDINATE},
      {fc_sphere_plane(&sphere, &flat), FC_ERR_NORMAL},
      {fc_aabb_plane(nullptr, &plane), FC_ERR_NULL},
      {fc_aabb_plane(&inverted, &plane), FC_ERR_COORDINATE},
      {fc_aabb_plane(&box, nullptr), FC_ERR_NULL},
      {fc_sphere_sphere(nullptr, &sphere), FC_ERR_NULL},
      {fc_sphere_sphere(&sphere, nullptr), FC_ERR_NULL},
      {fc_sphere_sphere(&sphere, &hole), FC_ERR_RADIUS},
      {fc_sphere_sphere(&large, &sphere), FC_ERR_COORDINATE},
      {fc_aabb_aabb(nullptr, &box), FC_ERR_NULL},
      {fc_aabb_aabb(&box, nullptr), FC_ERR_NULL},
      {fc_aabb_aabb(&box, &inverted), FC_ERR_COORDINATE},
      {fc_aabb_aabb(&outside, &box), FC_ERR_COORDINATE},
      {fc_triangle_aabb(nullptr, &box), FC_ERR_NULL},
      {fc_triangle_aabb(triangle, nullptr), FC_ERR_NULL},
      {fc_triangle_aabb(astray, &box), FC_ERR_COORDINATE},
      {fc_triangle_aabb(triangle, &inverted), FC_ERR_COORDINATE},
  };
  int i = 0;
  for (const auto &c : cases) {
    if (c.got != c.expected) wrong("case %d: error %d is right (%d)", i, c.expected, c.got);
    i++;
  }
}

} // namespace

int main(int argc, char **argv) {
  return run_trials(argc, argv,
                    {{"bad_arguments_are_refused", 1, bad_arguments_are_refused},
                     {"ray_against_box", 100000, ray_against_box},
                     {"point_against_plane", 100000, point_against_plane},
                     {"extremes_of_planes", 200, extremes_of_planes},
                     {"sphere_against_plane", 100000, sphere_against_plane},
                     {"box_against_plane", 100000, box_against_plane},
                     {"sphere_against_sphere", 100000, sphere_against_sphere},
                     {"box_against_box", 100000, box_against_box},
                     {"triangle_against_box", 50000, triangle_against_box},
                     {"triangle_touches_box", 50000, triangle_touches_box},
                     {"triangle_edge_against_box_edge", 50000, triangle_edge_against_box_edge},
                     {"extremes_of_triangles", 2000, extremes_of_triangles}});
}
