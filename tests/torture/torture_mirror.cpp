/* Mirrors: grazing rays stay outside (33), corner reflectors send a ray back along exactly the way it came (34). */
#include "trial.h"

extern "C" {
#include "fixcast/reflect.h"
}

using oracle::Q;
using oracle::Z;

namespace {

Z z(int64_t v) { return static_cast<long>(v); }

/* n^2 R, whole. */
void exact_reflection(Vec d, Vec n, Z out[3]) {
  Z n2 = 0, nd = 0;
  for (int i = 0; i < 3; i++) {
    n2 += z(n[i]) * z(n[i]);
    nd += z(n[i]) * z(d[i]);
  }
  for (int i = 0; i < 3; i++) out[i] = n2 * z(d[i]) - 2 * nd * z(n[i]);
}

Vec reflect(Vec d, Vec n) {
  fc_vec3 direction = to_core(d), normal = to_core(n), r;
  int error = fc_reflect(&r, &direction, &normal);
  if (error != FC_OK)
    fail("fc_reflect: %s; %s on %s", fc_error_text(error), oracle::text(d).c_str(), oracle::text(n).c_str());
  return from_core(r);
}

/* The sign of n . R, and every component within 1/2 + 2^-30 of a power of two times R, but for up to 2 units along one axis when the
 * exact n . R is less than rounding could make of it. */
void check_reflection(Vec d, Vec n) {
  Vec r = reflect(d, n);
  Z exact[3], n2 = 0, along = 0, out = 0, norm1 = 0;
  exact_reflection(d, n, exact);
  int big = 0, dominant = 0;
  for (int i = 0; i < 3; i++) {
    n2 += z(n[i]) * z(n[i]);
    along += z(n[i]) * z(d[i]);
    out += z(n[i]) * z(r[i]);
    norm1 += z(std::llabs(n[i]));
    if (abs(exact[i]) > abs(exact[big])) big = i;
    if (std::llabs(n[i]) > std::llabs(n[dominant])) dominant = i;
  }
  std::string what = oracle::text(d) + " on " + oracle::text(n) + " gives " + oracle::text(r);
  if (sgn(out) != -sgn(along)) fail("n . R has the wrong sign: %s", what.c_str());
  if (largest(r) > coordinate_max || largest(r) < (INT64_C(1) << 28) - 3)
    fail("not scaled to 30 bits: %s", what.c_str());
  /* the power of two */
  Q scale = Q(1, n2);
  while (abs(Q(exact[big])) * scale * 2 <= Q(z(largest(r) + 3))) scale *= 2;
  while (abs(Q(exact[big])) * scale > Q(z(largest(r) + 3))) scale /= 2;
  bool grazing = abs(Q(along)) * scale * n2 <= Q(norm1) * Q(3, 4);
  for (int i = 0; i < 3; i++) {
    Q off = abs(Q(Q(exact[i]) * scale - Q(z(r[i])))), bound = Q(1, 2) + Q(1, 1ul << 30);
    if (i == dominant && grazing) bound += 2;
    if (off > bound) fail("axis %d is off by %.6f: %s", i, off.get_d(), what.c_str());
  }
}

/* ---- 33 ---- */

uint64_t grazing(Random &random) {
  int bits = static_cast<int>(random.within(2, 30));
  Vec n = random.direction(bits), d = random.direction(static_cast<int>(random.within(2, 30)));
  if (random.within(0, 3) != 0) { /* n . d = 0 or next to it: across, then a unit or so along */
    Vec across = cross({n.x >> 1, n.y >> 1, n.z >> 1}, random.vec(bits > 28 ? 28 : bits));
    while (largest(across) > coordinate_max / 2) across = {across.x / 2, across.y / 2, across.z / 2};
    d = across;
    switch (random.within(0, 2)) {
      case 0: break;
      case 1: d = d + random.unit_step(); break;
      default: { /* exactly perpendicular in a plane of two axes, then one off on the third */
        int k = static_cast<int>(random.within(0, 2));
        d = {0, 0, 0};
        d[(k + 1) % 3] = n[(k + 2) % 3];
        d[(k + 2) % 3] = -n[(k + 1) % 3];
        d[k] = random.within(-1, 1);
      }
    }
  }
  if (random.within(0, 15) == 0)
    for (int i = 0; i < 3; i++) d[i] = random.flip() ? coordinate_max : -coordinate_max;
  if (is_zero(d) || !fits(d) || !fits(n)) return 0;
  check_reflection(d, n);
  check_reflection(d, -n);
  if (!(reflect(d, n) == reflect(d, -n))) {
    /* only where a half is rounded or a ray is kept out may the mirror's two faces differ: never by more */
    Vec difference = reflect(d, n) - reflect(d, -n);
    if (largest(difference) > 4)
      fail("front and back of %s reflect %s differently", oracle::text(n).c_str(), oracle::text(d).c_str());
  }
  return 2;
}

/* ---- 34 ---- */

/* d (2^k) = -back for some k >= 0, or, of a direction with more than 30 bits, k < 0 */
bool is_back(Vec d, Vec back, int *k) {
  for (*k = 0; *k < 31; ++*k, d = d * 2)
    if (d == -back) return true;
  return false;
}

uint64_t corner_reflector(Random &random) {
  /* along the axes: any lengths, signs and order */
  Vec d = random.direction(30), mirror[3];
  int k, order = static_cast<int>(random.within(0, 5)),
         axes[3] = {order / 2, (order / 2 + 1 + order % 2) % 3, 0};
  axes[2] = 3 - axes[0] - axes[1];
  if (random.within(0, 7) == 0) d = {coordinate_max, -coordinate_max, random.flip() ? coordinate_max : 1};
  Vec r = d;
  for (int i = 0; i < 3; i++) {
    mirror[i] = {0, 0, 0};
    mirror[i][axes[i]] = random.any_size(30) | 1;
    check_reflection(r, mirror[i]);
    r = reflect(r, mirror[i]);
  }
  if (!is_back(d, r, &k)) fail("axes: %s comes back as %s", oracle::text(d).c_str(), oracle::text(r).c_str());
  if (largest(d) > coordinate_max / 2 && k != 0)
    fail("axes: %s is scaled by 2^%d", oracle::text(d).c_str(), k);

  /* askew, three mirrors at right angles of a whole length: exact where every reflection on the way is whole */
  Vec row[3];
  int64_t n = quaternion_frame(random, random.within(1, 4), row), n2 = n * n;
  d = random.direction(8) * n2;
  r = d;
  for (int i = 0; i < 3; i++) r = reflect(r, row[i]);
  if (largest(d) < INT64_C(1) << 26 && !is_back(d, r, &k))
    fail("frame of %lld: %s comes back as %s", static_cast<long long>(n), oracle::text(d).c_str(),
         oracle::text(r).c_str());

  /* through a scene: into the corner and out of it, a plane after the other */
  std::vector<oracle::Shape> planes;
  for (int i = 0; i < 3; i++) {
    Vec normal = {0, 0, 0};
    normal[i] = random.within(1, 1000);
    planes.push_back(oracle::plane(normal, 0));
  }
  Scene corner(planes);
  Vec at, start, way = random.direction(12);
  for (int i = 0; i < 3; i++) {
    way[i] = -std::llabs(way[i]) - 1;
    start[i] = random.within(1, INT64_C(1) << 20);
  }
  at = start;
  r = way;
  uint32_t met = 0;
  for (int i = 0; i < 3; i++) {
    fc_hit hit;
    if (shoot(corner, at, r, &hit) != 1) {
      if (met != 0 && (at.x == 0) + (at.y == 0) + (at.z == 0) > 1)
        return 5; /* ends on an edge of the corner */
      fail("leaves the corner after %d mirrors: from %s along %s", i, oracle::text(at).c_str(),
           oracle::text(r).c_str());
    }
    met |= UINT32_C(1) << hit.primitive;
    at = from_core(hit.position);
    for (int j = 0; j < 3; j++)
      if (at[j] < 0) at[j] = 0; /* rounded within a unit: back to this side of an edge */
    r = reflect(r, from_core(hit.normal_q30));
  }
  if (met != 7) return 5; /* as above */
  if (!is_back(way, r, &k))
    fail("scene: %s comes back as %s", oracle::text(way).c_str(), oracle::text(r).c_str());
  return 6;
}

} // namespace

const std::vector<Family> mirror_families = {
    {33, "grazing mirror", 1000000, 25, grazing},
    {34, "corner reflector", 500000, 30, corner_reflector},
};
