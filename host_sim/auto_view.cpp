/* A camera and lights for scenes that name none. */
#include "auto_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace host {
namespace {

using Triple = std::array<double, 3>;

constexpr double pi = 3.14159265358979323846;

Triple values(const Vector &v) { return {static_cast<double>(v.x.value), static_cast<double>(v.y.value), static_cast<double>(v.z.value)}; }

double dot(const Triple &a, const Triple &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Triple cross(const Triple &a, const Triple &b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }

Triple along(const Triple &from, double t, const Triple &direction) {
  return {from[0] + t * direction[0], from[1] + t * direction[1], from[2] + t * direction[2]};
}

/* Six digits are enough for a view that nobody asked for, and the same on every machine. */
Number rounded(double value) {
  char text[40];
  (void)std::snprintf(text, sizeof text, "%.6g", value);
  const Number number{text, std::strtold(text, nullptr)};
  return number.value == 0 ? Number{} : number;
}

Vector rounded(const Triple &v) { return {rounded(v[0]), rounded(v[1]), rounded(v[2])}; }

/* A ball around a point: what must be in the picture. */
struct Ball {
  Triple centre;
  double radius;
};

std::vector<Ball> finite_balls(const SceneFile &file) {
  std::vector<Ball> balls;
  for (const Sphere &s : file.spheres) balls.push_back({values(s.center), static_cast<double>(s.radius.value)});
  for (const Polygon &p : file.polygons)
    for (const Vector &v : p.vertices) balls.push_back({values(v), 0});
  return balls;
}

Triple middle(const std::vector<Ball> &balls) {
  Triple centre{};
  for (std::size_t k = 0; k < 3; k++) {
    double low = balls.front().centre[k], high = low;
    for (const Ball &ball : balls) {
      low = std::min(low, ball.centre[k] - ball.radius);
      high = std::max(high, ball.centre[k] + ball.radius);
    }
    centre[k] = low + (high - low) / 2;
  }
  return centre;
}

/* What was typed as it may stand in a message: short, and in printable characters only. */
std::string shown(const std::string &text) {
  std::string out = text.substr(0, 40);
  for (char &c : out)
    if (c < ' ' || c > '~') c = '?';
  return out + (text.size() > 40 ? "..." : "");
}

/* Decimal numbers separated by commas, `fewest` or `most` of them. */
std::vector<Number> numbers(const std::string &option, const std::string &text, std::size_t fewest, std::size_t most) {
  std::vector<Number> list;
  std::size_t at = 0;
  while (at <= text.size()) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string word = text.substr(at, end - at);
    at = end + 1;
    char *stop = nullptr;
    const long double value = std::strtold(word.c_str(), &stop);
    const bool decimal = !word.empty() && word.find_first_not_of("0123456789.eE+-") == std::string::npos && word.front() != '+';
    if (!decimal || *stop != '\0' || !(std::fabs(value) <= 1e30L) || (value != 0 && std::fabs(value) < 1e-30L))
      throw UserError(option + " " + shown(text) + ": \"" + shown(word) + "\" is not a number; give decimals such as 1.5,0,-3");
    list.push_back(value == 0 ? Number{} : Number{word, value});
  }
  if (list.size() != fewest && list.size() != most)
    throw UserError(option + " " + shown(text) + ": " + std::to_string(list.size()) + " numbers; give " + std::to_string(fewest) +
                    (most != fewest ? " or " + std::to_string(most) : std::string()) + " with commas between them");
  return list;
}

Vector point(const std::string &option, const std::string &text) {
  const std::vector<Number> n = numbers(option, text, 3, 3);
  return {n[0], n[1], n[2]};
}

Rgb colour(const std::string &option, const std::vector<Number> &n, std::size_t first, long double highest) {
  const std::size_t step = n.size() > first + 2 ? 1 : 0;
  for (std::size_t i = first; i < n.size(); i++)
    if (n[i].value < 0 || n[i].value > highest)
      throw UserError(option + ": " + n[i].text + " is out of range; give levels from 0 to " + (highest > 1 ? "1e6" : "1"));
  return {n[first], n[first + step], n[first + 2 * step]};
}

} // namespace

bool ViewOptions::empty() const {
  return from.empty() && at.empty() && up.empty() && angle.empty() && look.empty() && ambient.empty() && background.empty() &&
         lights.empty();
}

void frame_all(SceneFile &file, double azimuth, double elevation) {
  const std::vector<Ball> balls = finite_balls(file);
  if (balls.empty()) throw UserError(file.path + ": no sphere or face to look at; give --from and --at");
  const double a = azimuth * pi / 180, e = elevation * pi / 180;
  const Triple back = {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)}; /* from the scene to the eye */
  const Triple right = {std::cos(a), 0, -std::sin(a)}, up = cross(back, right);
  Triple centre = middle(balls);
  constexpr double tangent = 0.4, fill = 0.9;
  double distance = 0;
  /* Perspective puts the middle of the box beside the middle of the picture: moved there, a few times. */
  for (int round = 0;; round++) {
    distance = 0;
    for (const Ball &ball : balls) {
      const Triple d = along(ball.centre, -1, centre);
      const double wide = std::max(std::fabs(dot(d, right)), std::fabs(dot(d, up)));
      distance = std::max(distance, dot(d, back) + ball.radius + (wide + 1.1 * ball.radius) / (tangent * fill));
    }
    if (round == 8 || !(distance > 0)) break;
    for (const Triple &axis : {right, up}) {
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const Ball &ball : balls) {
        const Triple d = along(ball.centre, -1, centre);
        const double depth = distance - dot(d, back);
        low = std::min(low, (dot(d, axis) - ball.radius) / depth);
        high = std::max(high, (dot(d, axis) + ball.radius) / depth);
      }
      centre = along(centre, (low + high) / 2 * distance, axis);
    }
  }
  if (!(distance > 0)) distance = 1; /* a single point */
  file.camera.from = rounded(along(centre, distance, back));
  file.camera.at = rounded(centre);
  file.camera.up = rounded(up);
  file.camera.tan_half_fov = Number{"0.4", 0.4L};
  file.camera.line = 0;
}

void light_up(SceneFile &file) {
  const Triple eye = values(file.camera.from), at = values(file.camera.at);
  const Triple back = along(eye, -1, at);
  const double distance = std::sqrt(dot(back, back));
  const Triple up = values(file.camera.up), right = cross(up, back);
  const double up_length = std::sqrt(dot(up, up)), right_length = std::sqrt(dot(right, right));
  Light light;
  light.position = rounded(along(along(along(at, 1.2, back), 0.9 * distance / up_length, up), -0.8 * distance / right_length, right));
  const Number level{"0.85", 0.85L};
  light.colour = Rgb{level, level, level};
  file.lights = {light};
  const Number ambient{"0.18", 0.18L};
  file.ambient = {ambient, ambient, ambient};
  file.background = {{"0.16", 0.16L}, {"0.2", 0.2L}, {"0.26", 0.26L}};
}

void apply(const ViewOptions &options, SceneFile &file) {
  if (!options.look.empty()) {
    const std::vector<Number> look = numbers("--look", options.look, 2, 2);
    if (std::fabs(look[0].value) > 360 || std::fabs(look[1].value) > 90)
      throw UserError("--look " + shown(options.look) + " is out of range; give degrees: azimuth -360 to 360, elevation -90 to 90");
    frame_all(file, static_cast<double>(look[0].value), static_cast<double>(look[1].value));
  }
  Camera &camera = file.camera;
  if (!options.from.empty()) camera.from = point("--from", options.from);
  if (!options.at.empty()) camera.at = point("--at", options.at);
  if (!options.up.empty()) camera.up = point("--up", options.up);
  if (!options.angle.empty()) {
    const Number angle = numbers("--angle", options.angle, 1, 1)[0];
    if (angle.value <= 0 || angle.value >= 180)
      throw UserError("--angle " + shown(options.angle) + " is out of range; give degrees between 0 and 180");
    camera.angle_degrees = angle;
    camera.tan_half_fov.reset();
  }
  if (!options.lights.empty()) file.lights.clear();
  for (const std::string &text : options.lights) {
    const std::vector<Number> n = numbers("--light", text, 3, 6);
    Light light;
    light.position = {n[0], n[1], n[2]};
    if (n.size() == 6) light.colour = colour("--light " + shown(text), n, 3, 1e6L);
    file.lights.push_back(light);
  }
  if (!options.ambient.empty())
    file.ambient = colour("--ambient " + shown(options.ambient), numbers("--ambient", options.ambient, 1, 3), 0, 1e6L);
  if (!options.background.empty())
    file.background = colour("--background " + shown(options.background), numbers("--background", options.background, 1, 3), 0, 1);
}

} // namespace host
