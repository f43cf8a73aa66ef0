/* The virtual trackball against long double, and what a user expects of it. */
#include <cmath>

#include "trials.h"

extern "C" {
#include "fixcast/rotation.h"
}

namespace {

using Real = long double;
const Real ulp = ldexpl(1, -30);

struct Place {
  int32_t x, y;
};

Place any_place(Random &random, int32_t radius) {
  int64_t reach = random.flip() ? radius : random.within(1, FC_TRACKBALL_MAX);
  return {static_cast<int32_t>(random.within(-reach, reach)),
          static_cast<int32_t>(random.within(-reach, reach))};
}
int32_t any_radius(Random &random) {
  return static_cast<int32_t>(random.within(1, (INT64_C(1) << random.within(1, 16)) - 1));
}

/* The ball as the lecture draws it, sphere and hyperbola, made unit. */
void ball(Place p, int32_t radius, Real out[3]) {
  Real x = p.x, y = p.y, r = radius, d = hypotl(x, y), z;
  if (d > FC_TRACKBALL_REACH * r) {
    x *= FC_TRACKBALL_REACH * r / d;
    y *= FC_TRACKBALL_REACH * r / d;
    d = FC_TRACKBALL_REACH * r;
  }
  z = d * sqrtl(2) <= r ? sqrtl(r * r - d * d) : r * r / (2 * d);
  Real n = sqrtl(x * x + y * y + z * z);
  out[0] = x / n, out[1] = y / n, out[2] = z / n;
}

fc_vec3 point(Place p, int32_t radius) {
  fc_vec3 v;
  int error = fc_trackball_point(&v, p.x, p.y, radius);
  if (error != FC_OK) wrong("fc_trackball_point(%d, %d, %d): %d", p.x, p.y, radius, error);
  return v;
}
fc_rotation drag(Place a, Place b, int32_t radius) {
  fc_rotation r;
  int error = fc_trackball_drag(&r, a.x, a.y, b.x, b.y, radius);
  if (error != FC_OK) wrong("fc_trackball_drag(%d, %d, %d, %d, %d): %d", a.x, a.y, b.x, b.y, radius, error);
  return r;
}
bool none(const fc_rotation &r) { return r.w == FC_ONE_Q30 && r.x == 0 && r.y == 0 && r.z == 0; }

void points_lie_on_sphere_and_hyperbola(Random &random) {
  int32_t radius = any_radius(random);
  Place p = any_place(random, radius);
  if (random.within(0, 3) == 0) { /* at the seam and at the reach */
    p.x = static_cast<int32_t>(radius / (random.flip() ? sqrtl(2) : 1.0L / FC_TRACKBALL_REACH) +
                               random.any_size(2));
    p.y = static_cast<int32_t>(random.any_size(3));
    if (std::abs(p.x) > FC_TRACKBALL_MAX) p.x = FC_TRACKBALL_MAX;
  }
  fc_vec3 v = point(p, radius);
  Real exact[3], got[3] = {v.x * ulp, v.y * ulp, v.z * ulp};
  ball(p, radius, exact);
  for (int i = 0; i < 3; i++)
    if (!(fabsl(got[i] - exact[i]) <= ulp))
      wrong("(%d, %d) on radius %d: axis %d is %.12Lf instead of %.12Lf", p.x, p.y, radius, i, got[i],
            exact[i]);
}

void drags_turn_one_point_to_the_other(Random &random) {
  int32_t radius = any_radius(random);
  Place a = any_place(random, radius), b = any_place(random, radius);
  fc_rotation r = drag(a, b, radius);
  Real p[3], q[3];
  ball(a, radius, p);
  ball(b, radius, q);
  Real c[3] = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
  Real size = hypotl(hypotl(c[0], c[1]), c[2]),
       half = atan2l(size, p[0] * q[0] + p[1] * q[1] + p[2] * q[2]) / 2;
  Real exact[4] = {cosl(half), 0, 0, 0}, got[4] = {r.w * ulp, r.x * ulp, r.y * ulp, r.z * ulp};
  for (int i = 0; i < 3; i++) exact[i + 1] = size > 0 ? c[i] / size * sinl(half) : 0;
  Real bound = 2 * ulp / cosl(half);
  for (int i = 0; i < 4; i++)
    if (!(fabsl(got[i] - exact[i]) <= bound))
      wrong("(%d, %d) to (%d, %d) on radius %d: component %d off by %.3Lf * 2^-30, bound %.3Lf", a.x, a.y,
            b.x, b.y, radius, i, fabsl(got[i] - exact[i]) / ulp, bound / ulp);
}

void there_and_back_is_no_rotation(Random &random) {
  int32_t radius = any_radius(random);
  Place a = any_place(random, radius), b = any_place(random, radius);
  fc_rotation there = drag(a, b, radius), back = drag(b, a, radius), both;
  if (fc_rotation_compose(&both, &back, &there) != FC_OK) wrong("refused");
  if (!none(both))
    wrong("(%d, %d) to (%d, %d) and back on radius %d leaves (%d, %d, %d, %d)", a.x, a.y, b.x, b.y, radius,
          both.w, both.x, both.y, both.z);
  if (!none(drag(a, a, radius))) wrong("staying at (%d, %d) turns", a.x, a.y);
}

/* Many small drags out and the same ones back, as a mouse makes them: within two roundings a drag. */
void a_path_there_and_back_is_no_rotation(Random &random) {
  int32_t radius = static_cast<int32_t>(random.within(20, 400));
  Place path[100];
  path[0] = any_place(random, radius);
  for (int i = 1; i < 100; i++) {
    path[i].x = path[i - 1].x + static_cast<int32_t>(random.within(-9, 9));
    path[i].y = path[i - 1].y + static_cast<int32_t>(random.within(-9, 9));
  }
  fc_rotation r = FC_ROTATION_NONE, step;
  for (int i = 1; i < 100; i++) {
    step = drag(path[i - 1], path[i], radius);
    if (fc_rotation_compose(&r, &step, &r) != FC_OK) wrong("refused");
  }
  for (int i = 99; i > 0; i--) {
    step = drag(path[i], path[i - 1], radius);
    if (fc_rotation_compose(&r, &step, &r) != FC_OK) wrong("refused");
  }
  Real angle = 2 * asinl(sqrtl(static_cast<Real>(r.x) * r.x + static_cast<Real>(r.y) * r.y +
                               static_cast<Real>(r.z) * r.z) *
                         ulp);
  if (!(angle <= 198 * 2 * ulp)) wrong("%.3Lf * 2^-30 radians left", angle / ulp);
}

/* A turn of the screen by quarters and a mirror image turn the drag with it, to the bit. */
void the_ball_is_as_round_as_the_screen(Random &random) {
  int32_t radius = any_radius(random);
  Place a = any_place(random, radius), b = any_place(random, radius);
  fc_rotation r = drag(a, b, radius), quarter = drag({-a.y, a.x}, {-b.y, b.x}, radius),
              mirror = drag({-a.x, a.y}, {-b.x, b.y}, radius);
  if (quarter.w != r.w || quarter.x != -r.y || quarter.y != r.x || quarter.z != r.z)
    wrong("a quarter turn of the screen");
  if (mirror.w != r.w || mirror.x != r.x || mirror.y != -r.y || mirror.z != -r.z) wrong("a mirror image");
}

void the_surface_follows_the_mouse(Random &random) {
  int32_t radius = static_cast<int32_t>(random.within(16, 4000)), most = radius / 2;
  Place a = {static_cast<int32_t>(random.within(-most, most)),
             static_cast<int32_t>(random.within(-most, most))},
        b = {static_cast<int32_t>(random.within(-most, most)),
             static_cast<int32_t>(random.within(-most, most))};
  fc_rotation r = drag(a, b, radius);
  fc_matrix m;
  fc_vec3 p = point(a, radius), q = point(b, radius);
  /* fc_rotate_points takes world coordinates: half of the unit points */
  p.x /= 2, p.y /= 2, p.z /= 2;
  if (fc_rotation_matrix(&m, &r) != FC_OK || fc_rotate_points(&p, &p, 1, &m, nullptr) != FC_OK)
    wrong("refused");
  if (std::abs(p.x - q.x / 2) > 4 || std::abs(p.y - q.y / 2) > 4 || std::abs(p.z - q.z / 2) > 4)
    wrong("the point under the mouse is left behind: (%d, %d) instead of (%d, %d)", p.x, p.y, q.x / 2,
          q.y / 2);
  fc_rotation right = drag({0, 0}, {most, 0}, radius), up = drag({0, 0}, {0, most}, radius);
  if (!(right.y > 0 && right.x == 0 && right.z == 0)) wrong("to the right turns about y, towards the right");
  if (!(up.x < 0 && up.y == 0 && up.z == 0)) wrong("up turns about x, front side up");
}

/* A step of the mouse by one unit never jumps: at most 3 / radius radians, across the seam and the reach too. */
void no_kink_anywhere(Random &random) {
  int32_t radius = any_radius(random);
  Place a = any_place(random, radius);
  if (random.flip()) {
    a.x = static_cast<int32_t>(radius / (random.flip() ? sqrtl(2) : 1.0L / FC_TRACKBALL_REACH)), a.y = 0;
    if (a.x > FC_TRACKBALL_MAX) return;
  }
  Place b = {a.x > 0 ? a.x - 1 : a.x + 1, a.y};
  if (radius < 8) return;
  fc_rotation r = drag(a, b, radius);
  Real angle = 2 * acosl(fminl(1, r.w * ulp));
  if (!(angle <= 3.0L / radius))
    wrong("one unit from (%d, %d) on radius %d turns by %.6Lf", a.x, a.y, radius, angle);
}

void bad_arguments_are_refused(Random &) {
  fc_vec3 v = {1, 2, 3};
  fc_rotation r = {1, 2, 3, 4};
  const int32_t most = FC_TRACKBALL_MAX;
  if (fc_trackball_point(nullptr, 0, 0, 1) != FC_ERR_NULL || fc_trackball_point(&v, 0, 0, 0) != FC_ERR_SIZE ||
      fc_trackball_point(&v, 0, 0, -5) != FC_ERR_SIZE ||
      fc_trackball_point(&v, most + 1, 0, 9) != FC_ERR_SIZE ||
      fc_trackball_point(&v, 0, INT32_MIN, 9) != FC_ERR_SIZE ||
      fc_trackball_point(&v, 0, 0, most + 1) != FC_ERR_SIZE ||
      fc_trackball_drag(nullptr, 0, 0, 1, 1, 9) != FC_ERR_NULL ||
      fc_trackball_drag(&r, 0, 0, INT32_MAX, 1, 9) != FC_ERR_SIZE ||
      fc_trackball_drag(&r, 0, -most - 1, 0, 1, 9) != FC_ERR_SIZE || v.x != 1 || r.w != 1)
    wrong("a bad argument was taken, or something was written");
  if (fc_trackball_point(&v, most, -most, most) != FC_OK || fc_trackball_point(&v, most, most, 1) != FC_OK)
    wrong("an extreme was refused");
}

} // namespace

int main(int argc, char **argv) {
  return run_trials(argc, argv,
                    {{"bad_arguments_are_refused", 1, bad_arguments_are_refused},
                     {"points_lie_on_sphere_and_hyperbola", 100000, points_lie_on_sphere_and_hyperbola},
                     {"drags_turn_one_point_to_the_other", 100000, drags_turn_one_point_to_the_other},
                     {"there_and_back_is_no_rotation", 100000, there_and_back_is_no_rotation},
                     {"a_path_there_and_back_is_no_rotation", 2000, a_path_there_and_back_is_no_rotation},
                     {"the_ball_is_as_round_as_the_screen", 100000, the_ball_is_as_round_as_the_screen},
                     {"the_surface_follows_the_mouse", 20000, the_surface_follows_the_mouse},
                     {"no_kink_anywhere", 100000, no_kink_anywhere}});
}
