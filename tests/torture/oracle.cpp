/* Exact answers in GMP. Triangles by Moeller and Trumbore with a real, finite nudge; spheres by Lagrange's
 * identity. */
#include "oracle.h"

namespace oracle {

namespace {

struct ZVec {
  Z c[3];
  ZVec() {}
  ZVec(Vec v) {
    for (int i = 0; i < 3; i++) c[i] = static_cast<long>(v[i]);
  }
  Z &operator[](int i) { return c[i]; }
  const Z &operator[](int i) const { return c[i]; }
};

ZVec minus(const ZVec &a, const ZVec &b) {
  ZVec r;
  for (int i = 0; i < 3; i++) r[i] = a[i] - b[i];
  return r;
}

Z inner(const ZVec &a, const ZVec &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

ZVec outer(const ZVec &a, const ZVec &b) {
  ZVec r;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    r[i] = a[j] * b[k] - a[k] * b[j];
  }
  return r;
}

/* floor(sqrt(d) 2^bits) */
Z scaled_sqrt(const Z &d, unsigned bits) {
  Z r = d << (2 * bits);
  mpz_sqrt(r.get_mpz_t(), r.get_mpz_t());
  return r;
}

/* x + y sqrt(d), d the same for all that meet in one expression. */
struct Surd {
  Z x, y;
};
Surd operator+(const Surd &a, const Surd &b) { return {a.x + b.x, a.y + b.y}; }
Surd operator-(const Surd &a, const Surd &b) { return {a.x - b.x, a.y - b.y}; }

struct Field {
  const Z &d;
  Surd times(const Surd &a, const Surd &b) const {
    return {a.x * b.x + a.y * b.y * d, a.x * b.y + a.y * b.x};
  }
  int sign(const Surd &a) const {
    if (a.y == 0) return sgn(a.x);
    return surd_sign(a.x, a.y, d, 0, 0);
  }
  Surd inner(const Surd a[3], const Surd b[3]) const {
    return times(a[0], b[0]) + times(a[1], b[1]) + times(a[2], b[2]);
  }
};

Surd scaled(const Surd &a, const Z &k) { return {a.x * k, a.y * k}; }

/* m (P - v) */
void from_point(const Point &point, Vec v, Surd r[3]) {
  for (int i = 0; i < 3; i++) {
    r[i].x = point.u[i] - point.m * static_cast<long>(v[i]);
    r[i].y = point.v[i];
  }
}

Surd determinant(const Field &field, const Surd a[3], const Surd b[3], const Surd c[3]) {
  Surd sum = {0, 0};
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    sum = sum + field.times(a[i], field.times(b[j], c[k]) - field.times(b[k], c[j]));
  }
  return sum;
}

ZVec face(const Shape &s) { return outer(minus(s.b, s.a), minus(s.c, s.a)); }

/* normal and k of the plane of a plane or triangle */
void plane_of(const Shape &s, ZVec *n, Z *k) {
  if (s.kind == Shape::plane) {
    *n = s.a;
    *k = static_cast<long>(s.r);
  } else {
    *n = face(s);
    *k = inner(*n, s.a);
  }
}

/* Moeller and Trumbore: numerators of u, v, t over det. */
struct Numerators {
  Z det, u, v, t;
};
Numerators moller_trumbore(const Shape &s, const ZVec &origin, const ZVec &direction) {
  ZVec e1 = minus(s.b, s.a), e2 = minus(s.c, s.a), p = outer(direction, e2), offset = minus(origin, s.a),
       q = outer(offset, e1);
  Numerators n;
  n.det = inner(e1, p);
  n.u = inner(offset, p);
  n.v = inner(direction, q);
  n.t = inner(e2, q);
  if (n.det < 0) {
    n.det = -n.det;
    n.u = -n.u;
    n.v = -n.v;
    n.t = -n.t;
  }
  return n;
}

} // namespace

int surd_sign(const Z &x, const Z &y, const Z &d, const Z &z, const Z &e) {
  /* Multiplied with its conjugates a value that is not 0 is a whole number, and each of those three
   * factors is below 2^(bits + 3): so it is itself above 2^-3(bits + 3). */
  size_t bits = mpz_sizeinbase(x.get_mpz_t(), 2), more;
  more = mpz_sizeinbase(y.get_mpz_t(), 2) + mpz_sizeinbase(d.get_mpz_t(), 2) / 2 + 1;
  if (more > bits) bits = more;
  more = mpz_sizeinbase(z.get_mpz_t(), 2) + mpz_sizeinbase(e.get_mpz_t(), 2) / 2 + 1;
  if (more > bits) bits = more;
  unsigned widest = static_cast<unsigned>(4 * bits + 40);
  for (unsigned k = 64;; k = widest) {
    Z value = (x << k) + y * scaled_sqrt(d, k) + z * scaled_sqrt(e, k), error = abs(y) + abs(z);
    if (abs(value) > error) return sgn(value);
    if (k == widest) return 0;
  }
}

int compare(const Root &a, const Root &b) {
  return surd_sign(a.p * b.m - b.p * a.m, a.q * b.m, a.d, -b.q * a.m, b.d);
}

Q approximate(const Root &root) {
  /* d may be a perfect square or 0; t may be as small as 2^-64 */
  const unsigned k = 300;
  Q t(root.p << k, root.m << k);
  if (root.q != 0) t = Q((root.p << k) + root.q * scaled_sqrt(root.d, k), root.m << k);
  t.canonicalize();
  return t;
}

int compare(const Root &root, const Q &value) {
  return surd_sign(root.p * value.get_den() - value.get_num() * root.m, root.q * value.get_den(), root.d, 0,
                   0);
}

std::vector<Root> roots(const Shape &s, Vec origin, Vec direction) {
  std::vector<Root> found;
  if (s.kind == Shape::sphere) {
    /* |D x OC|^2 <= r^2 |D|^2 */
    ZVec d = direction, oc = minus(s.a, origin), across = outer(d, oc);
    Z length2 = inner(d, d), radius2 = Z(static_cast<long>(s.r)) * static_cast<long>(s.r),
      along = inner(d, oc);
    Z rest = radius2 * length2 - inner(across, across);
    if (rest < 0) return found;
    for (int q = -1; q <= 1; q += 2) {
      Root root = {along, length2, rest, q};
      if (surd_sign(along, q, rest, 0, 0) > 0 && !(q == 1 && rest == 0 && !found.empty()))
        found.push_back(root);
    }
  } else if (s.kind == Shape::plane) {
    ZVec n;
    Z k;
    plane_of(s, &n, &k);
    Z side = k - inner(n, origin), along = inner(n, direction);
    if (sgn(side) * sgn(along) > 0) found.push_back({abs(side), abs(along), 0, 0});
  } else {
    Numerators n = moller_trumbore(s, origin, direction);
    if (n.det == 0 || n.t <= 0) return found;
    Z w = n.det - n.u - n.v;
    if (n.u < 0 || n.v < 0 || w < 0) return found;
    if (n.u == 0 || n.v == 0 || w == 0) {
      /* The nudge by (e, e^2, e^3), with e = 2^-100 where everything that matters is above 2^-67. */
      ZVec nudged;
      for (int i = 0; i < 3; i++)
        nudged[i] =
            (Z(static_cast<long>(direction[i])) << 300) + (Z(1) << static_cast<unsigned>(200 - 100 * i));
      Numerators m = moller_trumbore(s, origin, nudged);
      if (m.det == 0 || m.u <= 0 || m.v <= 0 || m.det - m.u - m.v <= 0) return found;
    }
    found.push_back({n.t, n.det, 0, 0});
  }
  return found;
}

bool is_tie(const Shape &s, Vec origin, Vec direction) {
  if (s.kind != Shape::triangle) return false;
  Numerators n = moller_trumbore(s, origin, direction);
  Z w = n.det - n.u - n.v;
  return n.det != 0 && n.u >= 0 && n.v >= 0 && w >= 0 && (n.u == 0 || n.v == 0 || w == 0);
}

int nearest(const std::vector<Shape> &shapes, Vec origin, Vec direction, uint64_t t_min_q32,
            uint64_t t_max_q32, Root *root, bool endless) {
  int best = -1;
  Q low(Z(static_cast<unsigned long>(t_min_q32)), Z(1) << 32),
      high(Z(static_cast<unsigned long>(t_max_q32)), Z(1) << 32);
  low.canonicalize();
  high.canonicalize();
  for (size_t i = 0; i < shapes.size(); i++)
    for (const Root &candidate : roots(shapes[i], origin, direction)) {
      if (compare(candidate, low) <= 0) continue;
      if (!endless && compare(candidate, high) >= 0) break;
      if (best < 0 || compare(candidate, *root) < 0) {
        best = static_cast<int>(i);
        *root = candidate;
      }
      break;
    }
  return best;
}

Point point_of(Vec p) {
  Point r;
  for (int i = 0; i < 3; i++) r.u[i] = static_cast<long>(p[i]);
  r.m = 1;
  return r;
}

Point point_at(const Root &root, Vec origin, Vec direction) {
  Point r;
  for (int i = 0; i < 3; i++) {
    r.u[i] = root.m * static_cast<long>(origin[i]) + root.p * static_cast<long>(direction[i]);
    r.v[i] = root.q * static_cast<long>(direction[i]);
  }
  r.m = root.m;
  r.d = root.d;
  return r;
}

bool blocked(const Shape &s, const Point &point, Vec light) {
  Field field = {point.d};
  Surd w[3]; /* m (L - P) */
  from_point(point, light, w);
  for (Surd &c : w) c = Surd{0, 0} - c;
  if (s.kind == Shape::sphere) {
    Surd g[3]; /* m (P - C) */
    from_point(point, s.a, g);
    Z radius = static_cast<long>(s.r), reach = radius * point.m;
    ZVec gl = minus(light, s.a);
    Surd at_point = field.inner(g, g) - Surd{reach * reach, 0};
    int start = field.sign(at_point), end = sgn(Z(inner(gl, gl) - radius * radius));
    if (start * end < 0) return true;
    if (start < 0 || end < 0) return false; /* a ball holds the chords between its points */
    if (start == 0 && end == 0) return false;
    Surd a = field.inner(w, w), b = Surd{0, 0} - field.inner(w, g);
    if (field.sign(b) <= 0 || field.sign(a - b) <= 0) return false;
    return field.sign(field.times(b, b) - field.times(a, at_point)) >= 0;
  }
  ZVec n;
  Z k;
  plane_of(s, &n, &k);
  Surd side = {-k * point.m, 0};
  for (int i = 0; i < 3; i++) side = side + Surd{n[i] * point.u[i], n[i] * point.v[i]};
  if (field.sign(side) * sgn(Z(inner(n, light) - k)) >= 0) return false;
  if (s.kind == Shape::plane) return true;
  const Vec *v[3] = {&s.a, &s.b, &s.c};
  int seen = 0;
  for (int i = 0; i < 3; i++) {
    Surd p[3], q[3];
    from_point(point, *v[i], p);
    from_point(point, *v[(i + 1) % 3], q);
    int sign = field.sign(determinant(field, p, q, w));
    if (sign * seen < 0) return false;
    if (sign != 0) seen = sign;
  }
  return true;
}

bool from_inside(const Shape &s, Vec direction, const Point &point) {
  if (s.kind != Shape::sphere) {
    ZVec n;
    Z k;
    plane_of(s, &n, &k);
    return inner(n, direction) > 0;
  }
  Surd g[3], along = {0, 0};
  from_point(point, s.a, g);
  for (int i = 0; i < 3; i++) along = along + scaled(g[i], Z(static_cast<long>(direction[i])));
  return Field{point.d}.sign(along) > 0;
}

bool faces(const Shape &s, Vec origin, Vec direction, const Point &point, Vec light) {
  if (s.kind != Shape::sphere) {
    ZVec n;
    Z k;
    plane_of(s, &n, &k);
    return sgn(Z(inner(n, origin) - k)) * sgn(Z(inner(n, light) - k)) > 0;
  }
  Field field = {point.d};
  Surd g[3], w[3];
  from_point(point, s.a, g);
  from_point(point, light, w);
  int along = -field.sign(field.inner(g, w));
  if (!from_inside(s, direction, point)) return along > 0;
  ZVec gl = minus(light, s.a);
  return along < 0 && inner(gl, gl) <= Z(static_cast<long>(s.r)) * static_cast<long>(s.r);
}

Q coordinate(const Point &point, int i) {
  const unsigned k = 300;
  Q r((point.u[i] << k) + point.v[i] * scaled_sqrt(point.d, k), point.m << k);
  r.canonicalize();
  return r;
}

Q normal_component(const Shape &s, Vec direction, const Point &point, int i) {
  Q length, component;
  if (s.kind == Shape::sphere) {
    component = coordinate(point, i) - static_cast<long>(s.a[i]);
    length = static_cast<long>(s.r);
  } else {
    ZVec n;
    Z k;
    plane_of(s, &n, &k);
    component = n[i];
    length = Q(scaled_sqrt(inner(n, n), 200), Z(1) << 200);
    length.canonicalize();
  }
  component /= length;
  return from_inside(s, direction, point) ? Q(-component) : component;
}

Q weight(const Shape &s, Vec origin, Vec direction, int i) {
  Numerators n = moller_trumbore(s, origin, direction);
  Z over = i == 1 ? n.u : i == 2 ? n.v
                                 : Z(n.det - n.u - n.v);
  Q r(over, n.det);
  r.canonicalize();
  return r;
}

bool depth_code_holds(uint16_t code, int exponent_bits, uint32_t near, const Root &root, int64_t focal) {
  int m_bits = 16 - exponent_bits, octaves = 1 << exponent_bits;
  auto boundary_below = [&](uint32_t c) {
    /* half-way between c - 1 and c: a c that starts an octave has a neighbour half as far below */
    auto value = [&](uint32_t v) {
      Q q(Z((1u << m_bits) + (v & ((1u << m_bits) - 1))) << (v >> m_bits),
          Z(1) << static_cast<unsigned>(octaves + m_bits));
      q.canonicalize();
      return q;
    };
    return Q((value(c - 1) + value(c)) / 2);
  };
  /* v >= boundary <=> near / boundary >= t focal */
  auto at_least = [&](uint32_t c) {
    return compare(root, Q(Q(static_cast<unsigned long>(near)) / boundary_below(c) /
                           static_cast<long>(focal))) <= 0;
  };
  if (code == 0) return false;
  if (code > 1 && !at_least(code)) return false;
  return code == UINT16_MAX || !at_least(static_cast<uint32_t>(code) + 1);
}

std::string text(Vec v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

std::string text(const Shape &s) {
  if (s.kind == Shape::sphere) return "sphere " + text(s.a) + " radius " + std::to_string(s.r);
  if (s.kind == Shape::plane) return "plane " + text(s.a) + " . p = " + std::to_string(s.r);
  return "triangle " + text(s.a) + " " + text(s.b) + " " + text(s.c);
}

std::string text(const Root &root) {
  return "t = (" + root.p.get_str() + (root.q < 0 ? " - " : " + ") + (root.q == 0 ? "0" : "1") + " sqrt(" +
         root.d.get_str() + ")) / " + root.m.get_str();
}

} // namespace oracle
