/* Convex bodies of volume_extra.h against linear programming in fractions. */
#include "exact_convex.h"
#include "trials.h"

extern "C" {
#include "fixcast/volume_extra.h"
}

namespace {

/* A body with its faces and edges. */
class Body {
public:
  std::vector<Vec> points;
  fc_polytope core() {
    vertices_.clear();
    for (Vec p : points) vertices_.push_back(to_core(p));
    return {vertices_.data(),
            faces_.empty() ? nullptr : reinterpret_cast<const uint16_t(*)[3]>(faces_.data()),
            edges_.empty() ? nullptr : reinterpret_cast<const uint16_t(*)[2]>(edges_.data()),
            static_cast<uint16_t>(points.size()),
            static_cast<uint16_t>(faces_.size()),
            static_cast<uint16_t>(edges_.size())};
  }
  bool in_range() const {
    for (Vec p : points)
      if (!fits(p)) return false;
    return true;
  }
  std::string text() const {
    std::string all;
    for (Vec p : points) all += ::text(p) + " ";
    return all;
  }
  void move(Vec by) {
    for (Vec &p : points) p = p + by;
  }
  void face(int a, int b, int c) {
    faces_.push_back({{static_cast<uint16_t>(a), static_cast<uint16_t>(b), static_cast<uint16_t>(c)}});
  }
  void edge(int a, int b) { edges_.push_back({{static_cast<uint16_t>(a), static_cast<uint16_t>(b)}}); }

private:
  struct Three {
    uint16_t v[3];
  };
  struct Two {
    uint16_t v[2];
  };
  std::vector<fc_vec3> vertices_;
  std::vector<Three> faces_;
  std::vector<Two> edges_;
};

void every_face_and_edge_of_a_tetrahedron(Body *b) {
  for (int i = 0; i < 4; i++) b->face((i + 1) % 4, (i + 2) % 4, (i + 3) % 4);
  for (int i = 0; i < 4; i++)
    for (int j = i + 1; j < 4; j++) b->edge(i, j);
}

/* A tetrahedron, parallelepiped, octahedron, prism, triangle, parallelogram, segment or point. */
Body any_body(Random &random, int bits, int kinds = 7) {
  Body b;
  Vec p = random.vec(bits), u = random.direction(bits), v = random.direction(bits),
      w = random.direction(bits);
  switch (random.within(0, kinds)) {
    case 0:
      b.points = {p, p + u, p + v, p + w};
      every_face_and_edge_of_a_tetrahedron(&b);
      break;
    case 1:
      for (int i = 0; i < 8; i++) b.points.push_back(p + u * (i & 1) + v * (i >> 1 & 1) + w * (i >> 2));
      for (int i = 0; i < 8; i++)
        for (int k = 1; k < 8; k *= 2)
          if (!(i & k)) b.edge(i, i | k);
      for (int i : {0, 7}) {
        b.face(i, i ^ 1, i ^ 2);
        b.face(i, i ^ 2, i ^ 4);
        b.face(i, i ^ 4, i ^ 1);
      }
      break;
    case 2: /* around a center, along three directions and back */
      b.points = {p + u, p - u, p + v, p - v, p + w, p - w};
      for (int i = 0; i < 8; i++) b.face(i & 1, 2 + (i >> 1 & 1), 4 + (i >> 2));
      for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
          b.edge(i, 2 + j);
          b.edge(2 + i, 4 + j);
          b.edge(i, 4 + j);
        }
      break;
    case 3:
      b.points = {p, p + u, p + v, p + w, p + u + w, p + v + w};
      b.face(0, 1, 2);
      b.face(3, 4, 5);
      for (int i = 0; i < 3; i++) {
        b.face(i, (i + 1) % 3, i + 3);
        b.edge(i, (i + 1) % 3);
        b.edge(i + 3, (i + 1) % 3 + 3);
        b.edge(i, i + 3);
      }
      break;
    case 4:
      b.points = {p, p + u, p + v};
      b.face(0, 1, 2);
      for (int i = 0; i < 3; i++) b.edge(i, (i + 1) % 3);
      break;
    case 5:
      b.points = {p, p + u, p + u + v, p + v};
      b.face(0, 1, 2);
      for (int i = 0; i < 4; i++) b.edge(i, (i + 1) % 4);
      break;
    case 6:
      b.points = {p, p + u};
      b.edge(0, 1);
      break;
    default: b.points = {p};
  }
  return b;
}

void check(Body &a, Body &b) {
  if (!a.in_range() || !b.in_range()) return;
  fc_polytope one = a.core(), two = b.core();
  bool expected = exact::hulls_meet(a.points, b.points);
  int got = fc_convex_convex(&one, &two);
  saw(expected);
  if (got != (expected ? 1 : 0) || fc_convex_convex(&two, &one) != got)
    wrong("%s and %s: %d is right (%d)", a.text().c_str(), b.text().c_str(), expected, got);
}

void bodies_anywhere(Random &random) {
  int bits = static_cast<int>(random.flip() ? random.within(1, 28) : random.within(1, 3));
  Body a = any_body(random, bits), b = any_body(random, bits);
  check(a, b);
}

/* A point of the one (corner, middle of an edge or face) is put on a point of the other, or one unit beside it. */
void bodies_that_touch(Random &random) {
  int bits = static_cast<int>(random.within(2, 27));
  Body a = any_body(random, bits), b = any_body(random, bits);
  for (Vec &p : a.points) p = p * 2; /* so that middles are whole */
  for (Vec &p : b.points) p = p * 2;
  auto some = [&](const Body &body) {
    size_t n = body.points.size();
    Vec p = body.points[random.next() % n], q = body.points[random.next() % n];
    return Vec{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
  };
  b.move(some(a) - some(b));
  if (random.flip()) b.move(random.unit_step());
  check(a, b);
}

/* All in one plane, or in one line: the normal tells nothing, the sides must. */
void flat_bodies_in_one_plane(Random &random) {
  int bits = static_cast<int>(random.within(1, 12));
  Vec o = random.vec(bits), u = random.direction(bits), v = random.direction(bits);
  if (random.within(0, 4) == 0) v = u; /* in line */
  int64_t reach = random.within(1, 40);
  auto place = [&] { return o + u * random.within(-reach, reach) + v * random.within(-reach, reach); };
  Body body[2];
  for (Body &b : body) {
    Vec p = place(), q = place(), r = place();
    int64_t n = random.within(1, 3);
    if (n == 3 && is_zero(cross(q - p, r - p))) n = 2;
    if (n == 2 && p == q) n = 1;
    b.points = {p};
    if (n > 1) b.points.push_back(q), b.edge(0, 1);
    if (n > 2) b.points.push_back(r), b.edge(1, 2), b.edge(2, 0), b.face(0, 1, 2);
  }
  if (random.within(0, 9) == 0) body[1].move(random.unit_step());
  check(body[0], body[1]);
}

void extremes(Random &random) {
  Body body[2];
  for (Body &b : body) {
    for (int i = 0; i < 4; i++) {
      Vec p;
      for (int c = 0; c < 3; c++)
        p[c] = (random.flip() ? 1 : -1) * (coordinate_max - (random.within(0, 3) == 0 ? 1 : 0));
      b.points.push_back(p);
    }
    Vec p = b.points[0];
    __int128 volume = 0;
    Vec e[3] = {b.points[1] - p, b.points[2] - p, b.points[3] - p};
    for (int c = 0; c < 3; c++) {
      int j = (c + 1) % 3, k = (c + 2) % 3;
      volume +=
          (static_cast<__int128>(e[0][j]) * e[1][k] - static_cast<__int128>(e[0][k]) * e[1][j]) * e[2][c];
    }
    if (volume == 0) return;
    every_face_and_edge_of_a_tetrahedron(&b);
  }
  check(body[0], body[1]);
}

void bad_arguments_are_refused(Random &) {
  const fc_vec3 points[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, far[1] = {{0, 0, INT32_MIN}};
  const uint16_t faces[1][3] = {{0, 1, 2}}, edges[2][2] = {{0, 1}, {2, 3}};
  const fc_polytope good = {points, faces, edges, 3, 1, 1}, empty = {points, faces, edges, 0, 1, 1},
                    none = {nullptr, faces, edges, 3, 1, 1}, faceless = {points, nullptr, edges, 3, 1, 1},
                    edgeless = {points, faces, nullptr, 3, 1, 1}, astray = {points, faces, edges, 3, 1, 2},
                    small = {points, faces, edges, 2, 1, 1}, out = {far, nullptr, nullptr, 1, 0, 0};
  if (fc_convex_convex(nullptr, &good) != FC_ERR_NULL || fc_convex_convex(&good, nullptr) != FC_ERR_NULL ||
      fc_convex_convex(&good, &empty) != FC_ERR_COUNT || fc_convex_convex(&none, &good) != FC_ERR_NULL ||
      fc_convex_convex(&faceless, &good) != FC_ERR_NULL ||
      fc_convex_convex(&good, &edgeless) != FC_ERR_NULL || fc_convex_convex(&good, &astray) != FC_ERR_INDEX ||
      fc_convex_convex(&small, &good) != FC_ERR_INDEX || fc_convex_convex(&out, &good) != FC_ERR_COORDINATE ||
      fc_convex_convex(&good, &good) != 1)
    wrong("a bad argument was taken, or a good one refused");
}

} // namespace

int main(int argc, char **argv) {
  return run_trials(argc, argv,
                    {{"bad_arguments_are_refused", 1, bad_arguments_are_refused},
                     {"bodies_anywhere", 6000, bodies_anywhere},
                     {"bodies_that_touch", 6000, bodies_that_touch},
                     {"flat_bodies_in_one_plane", 20000, flat_bodies_in_one_plane},
                     {"extremes", 6000, extremes}});
}
