/* Oriented boxes and k-DOPs of volume_extra.h against exact fractions. */
#include "exact.h"
#include "trials.h"

extern "C" {
#include "fixcast/volume_extra.h"
}

using exact::Q;

namespace {

std::vector<exact::Half> halves_of(const std::vector<fc_slab> &slabs) {
  std::vector<exact::Half> halves;
  for (const fc_slab &s : slabs) {
    exact::Point n = exact::point(from_core(s.normal));
    halves.push_back({n, exact::whole(s.high)});
    halves.push_back({exact::point(-from_core(s.normal)), exact::whole(-s.low)});
  }
  return halves;
}

std::string text(const std::vector<fc_slab> &slabs) {
  std::string all;
  for (const fc_slab &s : slabs)
    all += "\n  " + std::to_string(s.low) + " <= " + text(from_core(s.normal)) +
           " . p <= " + std::to_string(s.high);
  return all;
}

void check_ray(Vec o, Vec d, const std::vector<fc_slab> &slabs) {
  fc_vec3 origin = to_core(o), direction = to_core(d);
  fc_span span = {-7, -7, -7, -7};
  int got = fc_ray_slabs(&origin, &direction, slabs.data(), static_cast<uint8_t>(slabs.size()), &span);
  std::vector<exact::Half> halves = halves_of(slabs);
  Q enter, leave;
  bool expected = exact::ray_meets(o, d, halves, &enter, &leave), open = true;
  for (const exact::Half &h : halves) open = open && sgn(exact::dot(h.n, exact::point(d))) == 0;
  saw(expected);
  if (got != (expected ? 1 : 0))
    wrong("ray %s along %s: %d is right (%d)%s", text(o).c_str(), text(d).c_str(), expected, got,
          text(slabs).c_str());
  if (!expected && span.enter != -7) wrong("a miss wrote the span");
  if (!expected) return;
  if (exact::whole(span.enter) / exact::whole(span.enter_of) != enter)
    wrong("enters at %s%s", enter.get_str().c_str(), text(slabs).c_str());
  if (open ? span.leave_of != 0
           : span.leave_of <= 0 || exact::whole(span.leave) / exact::whole(span.leave_of) != leave)
    wrong("leaves at %s, not %lld / %lld%s", leave.get_str().c_str(), static_cast<long long>(span.leave),
          static_cast<long long>(span.leave_of), text(slabs).c_str());
}

/* 3 to 13 normals as k-DOPs have them, of a set of points. */
std::vector<fc_slab> kdop_of(Random &random, const std::vector<fc_vec3> &points) {
  /* clang-format off */
  static const int8_t normals[13][3] = {{1, 0, 0},  {0, 1, 0},   {0, 0, 1}, {1, 1, 1},  {1, -1, 1},
                                        {1, 1, -1}, {1, -1, -1}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1},
                                        {1, 0, -1}, {0, 1, 1},   {0, 1, -1}};
  /* clang-format on */
  std::vector<fc_slab> slabs(static_cast<size_t>(random.within(3, 13)));
  for (size_t i = 0; i < slabs.size(); i++) slabs[i] = {{normals[i][0], normals[i][1], normals[i][2]}, 0, 0};
  if (fc_slabs_fit(slabs.data(), static_cast<uint8_t>(slabs.size()), points.data(),
                   static_cast<uint16_t>(points.size())) != FC_OK)
    wrong("fc_slabs_fit refuses");
  return slabs;
}

std::vector<fc_vec3> cloud(Random &random, int bits) {
  std::vector<fc_vec3> points(static_cast<size_t>(random.within(1, 9)));
  Vec center = random.vec(bits);
  int spread = static_cast<int>(random.within(1, bits));
  for (fc_vec3 &p : points) {
    Vec v = center + random.vec(spread);
    for (int i = 0; i < 3; i++) v[i] = std::llabs(v[i]) > coordinate_max ? 0 : v[i];
    p = to_core(v);
  }
  return points;
}

void rays_against_k_dops(Random &random) {
  int bits = static_cast<int>(random.within(1, 30));
  std::vector<fc_vec3> points = cloud(random, bits);
  std::vector<fc_slab> slabs = kdop_of(random, points);
  Vec o = random.vec(bits), d = random.direction(bits);
  if (random.within(0, 3) != 0) { /* at a point of the cloud, on the surface, or one unit beside it */
    d = from_core(points[random.next() % points.size()]) - o;
    if (random.flip()) d = d + random.unit_step();
  }
  for (int i = 0; i < 3; i++)
    if (random.within(0, 5) == 0) d[i] = 0;
  if (is_zero(d) || !fits(d)) return;
  check_ray(o, d, slabs);
}

void fits_are_the_least(Random &random) {
  std::vector<fc_vec3> points = cloud(random, static_cast<int>(random.within(1, 30)));
  std::vector<fc_slab> slabs = kdop_of(random, points);
  for (fc_slab s : slabs) {
    bool low = false, high = false;
    for (fc_vec3 p : points) {
      Q at = exact::dot(exact::point(from_core(s.normal)), exact::point(from_core(p)));
      low = low || at == exact::whole(s.low);
      high = high || at == exact::whole(s.high);
      if (at < exact::whole(s.low) || at > exact::whole(s.high))
        wrong("a point is outside%s", text(slabs).c_str());
    }
    if (!low || !high) wrong("a slab touches no point%s", text(slabs).c_str());
  }
  for (fc_vec3 p : points)
    if (fc_point_slabs(&p, slabs.data(), static_cast<uint8_t>(slabs.size())) != 1)
      wrong("fc_point_slabs says a point is outside");
}

/* |row . (p - center)| <= half 2^30, with any rotation; rays at a corner or an edge. */
void rays_against_oriented_boxes(Random &random) {
  fc_rotation r;
  fc_matrix m;
  fc_vec3 axis = to_core(random.direction(20));
  uint16_t angle = static_cast<uint16_t>(
      random.within(0, 3) == 0 ? random.within(0, 7) * 0x2000 : static_cast<int64_t>(random.next() & 0xffff));
  if (fc_rotation_about(&r, &axis, angle) != FC_OK || fc_rotation_matrix(&m, &r) != FC_OK)
    wrong("no rotation");
  int bits = static_cast<int>(random.within(2, 29));
  Vec c = random.vec(bits), h = random.vec(bits), o = random.vec(bits), d = random.direction(bits);
  for (int i = 0; i < 3; i++) h[i] = std::llabs(h[i]);
  fc_vec3 center = to_core(c), half = to_core(h);
  std::vector<fc_slab> slabs(3);
  if (fc_slabs_of_box(slabs.data(), &center, &half, &m) != FC_OK) wrong("fc_slabs_of_box refuses");
  for (int i = 0; i < 3; i++) {
    Q middle = exact::dot(exact::point({m.row[i][0], m.row[i][1], m.row[i][2]}), exact::point(c)),
      reach = exact::whole(h[i]) * exact::whole(FC_ONE_Q30);
    if (exact::whole(slabs[static_cast<size_t>(i)].low) != middle - reach ||
        exact::whole(slabs[static_cast<size_t>(i)].high) != middle + reach)
      wrong("slab %d", i);
  }
  if (random.flip()) { /* towards a corner: the box turned back to the world */
    fc_vec3 corner =
        to_core({random.flip() ? h.x : -h.x, random.flip() ? h.y : -h.y, random.flip() ? h.z : -h.z});
    fc_matrix back;
    for (int i = 0; i < 9; i++) back.row[i / 3][i % 3] = m.row[i % 3][i / 3];
    if (fc_rotate_points(&corner, &corner, 1, &back, nullptr) != FC_OK) return;
    d = c + from_core(corner) - o;
  }
  if (is_zero(d) || !fits(d)) return;
  check_ray(o, d, slabs);
}

void k_dops_overlap(Random &random) {
  int bits = static_cast<int>(random.within(1, 30));
  std::vector<fc_slab> a = kdop_of(random, cloud(random, bits)), b = a;
  std::vector<fc_vec3> points = cloud(random, bits);
  uint8_t count = static_cast<uint8_t>(a.size());
  if (fc_slabs_fit(b.data(), count, points.data(), static_cast<uint16_t>(points.size())) != FC_OK)
    wrong("fc_slabs_fit refuses");
  if (random.flip()) { /* one pair of bounds touches, or is one off */
    size_t i = random.next() % a.size();
    int64_t width = b[i].high - b[i].low;
    b[i].low = a[i].high + random.within(0, 1);
    b[i].high = b[i].low + width;
  }
  bool expected = true;
  for (size_t i = 0; i < a.size(); i++) {
    mpz_class low = exact::whole(std::max(a[i].low, b[i].low)).get_num(),
              high = exact::whole(std::min(a[i].high, b[i].high)).get_num();
    expected = expected && low <= high;
  }
  saw(expected);
  if (fc_slabs_slabs(a.data(), b.data(), count) != (expected ? 1 : 0))
    wrong("%d is right%s and%s", expected, text(a).c_str(), text(b).c_str());
}

/* Every field as large as it may be, and volumes that are open along the ray. */
void extremes(Random &random) {
  std::vector<fc_slab> slabs(static_cast<size_t>(random.within(1, 3)));
  for (fc_slab &s : slabs) {
    Vec n;
    do
      for (int i = 0; i < 3; i++) n[i] = random.within(-1, 1) * FC_ONE_Q30;
    while (is_zero(n));
    s.normal = to_core(n);
    s.low = -(INT64_C(1) << 62) + random.within(0, 1);
    s.high = random.flip() ? (INT64_C(1) << 62) : s.low + random.within(0, INT64_C(1) << 61);
    if (random.flip()) {
      int64_t low = s.low;
      s.low = -s.high;
      s.high = -low;
    }
  }
  Vec o, d;
  do
    for (int i = 0; i < 3; i++) {
      o[i] = random.within(-1, 1) * coordinate_max;
      d[i] = random.within(-1, 1) * coordinate_max;
    }
  while (is_zero(d));
  check_ray(o, d, slabs);
}

void bad_arguments_are_refused(Random &) {
  const fc_vec3 zero = {0, 0, 0}, x = {1, 0, 0}, far = {0, INT32_MIN, 0}, minus = {1, -1, 1};
  const int64_t most = INT64_C(1) << 62;
  const fc_slab good = {x, -1, 1}, flat = {zero, -1, 1}, inverted = {x, 1, -1}, deep = {x, INT64_MIN, 1},
                high = {x, 1, most + 1}, wide = {far, 0, 0}, other = {minus, -1, 1};
  fc_slab out[3] = {good, good, good};
  fc_matrix m = {{{FC_ONE_Q30, 0, 0}, {0, FC_ONE_Q30, 0}, {0, 0, 0}}},
            wild = {{{INT32_MIN, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  fc_span span;
  const struct {
    int got, expected;
  } cases[] = {{fc_ray_slabs(nullptr, &x, &good, 1, &span), FC_ERR_NULL},
               {fc_ray_slabs(&x, nullptr, &good, 1, &span), FC_ERR_NULL},
               {fc_ray_slabs(&x, &x, nullptr, 1, &span), FC_ERR_NULL},
               {fc_ray_slabs(&x, &x, &good, 0, &span), FC_ERR_COUNT},
               {fc_ray_slabs(&x, &zero, &good, 1, &span), FC_ERR_DIRECTION},
               {fc_ray_slabs(&far, &x, &good, 1, &span), FC_ERR_COORDINATE},
               {fc_ray_slabs(&x, &x, &flat, 1, &span), FC_ERR_NORMAL},
               {fc_ray_slabs(&x, &x, &inverted, 1, &span), FC_ERR_COORDINATE},
               {fc_ray_slabs(&x, &x, &deep, 1, &span), FC_ERR_COORDINATE},
               {fc_ray_slabs(&x, &x, &high, 1, &span), FC_ERR_COORDINATE},
               {fc_ray_slabs(&x, &x, &wide, 1, &span), FC_ERR_COORDINATE},
               {fc_point_slabs(nullptr, &good, 1), FC_ERR_NULL},
               {fc_point_slabs(&x, nullptr, 1), FC_ERR_NULL},
               {fc_point_slabs(&x, &flat, 1), FC_ERR_NORMAL},
               {fc_point_slabs(&x, &good, 0), FC_ERR_COUNT},
               {fc_slabs_slabs(&good, &other, 1), FC_ERR_NORMAL},
               {fc_slabs_slabs(nullptr, &other, 1), FC_ERR_NULL},
               {fc_slabs_slabs(&good, &inverted, 1), FC_ERR_COORDINATE},
               {fc_slabs_slabs(&good, &good, 0), FC_ERR_COUNT},
               {fc_slabs_fit(nullptr, 1, &x, 1), FC_ERR_NULL},
               {fc_slabs_fit(out, 1, nullptr, 1), FC_ERR_NULL},
               {fc_slabs_fit(out, 1, &x, 0), FC_ERR_COUNT},
               {fc_slabs_fit(out, 1, &far, 1), FC_ERR_COORDINATE},
               {fc_slabs_of_box(nullptr, &x, &x, &m), FC_ERR_NULL},
               {fc_slabs_of_box(out, &x, &x, nullptr), FC_ERR_NULL},
               {fc_slabs_of_box(out, &x, &x, &m), FC_ERR_NORMAL},
               {fc_slabs_of_box(out, &x, &minus, &m), FC_ERR_COORDINATE},
               {fc_slabs_of_box(out, &x, &x, &wild), FC_ERR_COORDINATE},
               {fc_slabs_of_box(out, &far, &x, &m), FC_ERR_COORDINATE},
               {out[0].low == -1 ? 0 : 1, 0}};
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
                     {"rays_against_k_dops", 40000, rays_against_k_dops},
                     {"fits_are_the_least", 20000, fits_are_the_least},
                     {"rays_against_oriented_boxes", 50000, rays_against_oriented_boxes},
                     {"k_dops_overlap", 50000, k_dops_overlap},
                     {"extremes", 50000, extremes}});
}
