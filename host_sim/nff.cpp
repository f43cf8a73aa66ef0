/*
 * Reads scenes in Haines' Neutral File Format (NFF), with the extensions that stand in "#fc:" lines.
 *
 * One entity per line, tokens split by blanks or tabs; '#' starts a comment that reaches to the end of the
 * line, so readers that don't know the extensions skip them. Every complaint is one sentence of the form
 * "FILE:LINE: what is wrong; what to do".
 */
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "cone_mesh.h"
#include "scene_file.h"
#include "text_file.h"
#include "text_lines.h"

namespace host {
namespace {

constexpr std::size_t max_primitives = 65535; /* the core takes no more */
constexpr std::size_t max_line_bytes = 4096;
constexpr int max_object = 65535;
constexpr int max_vertices = 65535;
constexpr std::size_t max_cone_triangles = 100000; /* more than the core takes */
constexpr std::size_t max_fraction_digits = 18;    /* both halves are exact in a long double: one rounding */
constexpr long double max_magnitude = 1e30L;
constexpr long double min_magnitude = 1e-4000L; /* below this a long double starts to lose digits */
constexpr long double max_intensity = 1e6L;
constexpr long double max_tan_half_fov = 1000;
constexpr long double parallel_tolerance = 1e-12L; /* sine of the angle between up and the view direction */

[[noreturn]] void fail(const std::string &path, int line, const std::string &sentence) {
  throw UserError(path + ":" + std::to_string(line) + ": " + sentence);
}

/* A token as it may stand in a message: short, and in printable characters only. */
std::string quoted(std::string_view token) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : token.substr(0, longest)) {
    text += c >= 0x20 && c < 0x7f ? c : '?';
  }
  return text + (token.size() > longest ? "...'" : "'");
}

/* A line without its end, after a look at its bytes. */
std::string_view checked_line(const std::string &path, int number, std::string_view line) {
  if (!line.empty() && line.back() == '\n') {
    line.remove_suffix(1);
  }
  if (!line.empty() && line.back() == '\r') {
    line.remove_suffix(1);
  }
  for (std::size_t i = 0; i < line.size(); i++) {
    const auto byte = static_cast<unsigned char>(line[i]);
    if ((byte < 0x20 && byte != '\t') || byte == 0x7f) {
      char message[100];
      std::snprintf(message, sizeof message,
                    "not a text file (byte 0x%02x in column %zu); "
                    "save the scene as plain text",
                    byte, i + 1);
      fail(path, number, message);
    }
  }
  if (line.size() > max_line_bytes) {
    fail(path, number, "a line of more than " + std::to_string(max_line_bytes) + " characters; put one entity on each line");
  }
  return line;
}

/* A run over the first bytes before anything is parsed, so that a file which is no scene at all is refused by its real fault. */
void check_ahead(const std::string &path, std::string_view text) {
  TextLines lines(text, LineEnd::lf);
  std::string_view line;
  for (int number = 1; lines.next(line) && (line.back() == '\n' || line.size() > max_line_bytes); number++) {
    (void)checked_line(path, number, line);
  }
}

std::vector<std::string_view> split_tokens(std::string_view line) {
  std::vector<std::string_view> tokens;
  constexpr const char *blanks = " \t";
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;
       begin = line.find_first_not_of(blanks, begin)) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    if (line[begin] == '#') {
      break;
    }
    tokens.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return tokens;
}

/* Splits the leading digits off `rest`. */
std::string_view take_digits(std::string_view &rest) {
  const std::size_t count = std::min(rest.find_first_not_of("0123456789"), rest.size());
  const std::string_view digits = rest.substr(0, count);
  rest.remove_prefix(count);
  return digits;
}

bool all_zero(std::string_view digits) {
  return digits.find_first_not_of('0') == std::string_view::npos;
}

class Reader {
public:
  explicit Reader(const std::string &path) : path_(path) {}

  SceneFile read(TextLines &lines) {
    check_ahead(path_, lines.ahead());
    scene_.path = path_;
    scene_.ambient.r = scene_.ambient.g = scene_.ambient.b = Number{"0.1", 0.1L};
    std::string_view line;
    while (lines.next(line)) {
      line_++;
      if (line_ == 1 && line.substr(0, 3) == "\xef\xbb\xbf") { /* the byte-order mark that some editors put first */
        line.remove_prefix(3);
      }
      read_line(checked_line(path_, line_, line));
    }
    if (line_ == 0) {
      fail(path_, 1, "the file is empty; a scene needs at least a v block");
    }
    if (vertices_missing_ > 0) {
      fail_truncated("the file ends");
    }
    if (cone_ends_missing_ > 0) {
      fail(path_, cone_pattern_.line, "the file ends within the cone; add lines X Y Z RADIUS for its base and apex");
    }
    check_camera();
    return std::move(scene_);
  }

private:
  using Tokens = std::vector<std::string_view>;

  [[noreturn]] void fail_here(const std::string &sentence) const { fail(path_, line_, sentence); }

  void read_line(std::string_view line) {
    const std::size_t first = std::min(line.find_first_not_of(" \t"), line.size());
    line.remove_prefix(first);
    constexpr std::string_view mark = "#fc:";
    if (line.substr(0, mark.size()) == mark) {
      read_extension(split_tokens(line.substr(mark.size())));
      return;
    }
    const Tokens tokens = split_tokens(line);
    if (tokens.empty()) {
      return;
    }
    if (vertices_missing_ > 0) {
      read_vertex(tokens);
    } else if (cone_ends_missing_ > 0) {
      read_cone_end(tokens);
    } else {
      read_entity(tokens);
    }
  }

  void read_entity(const Tokens &tokens) {
    const std::string_view keyword = tokens[0];
    if (is_view_field(keyword)) {
      if (!in_view_) {
        fail_here(quoted(keyword) + " outside a v block; put it directly below the line v");
      }
      read_view_field(tokens);
      return;
    }
    in_view_ = false;
    if (keyword == "s") {
      read_sphere(tokens);
    } else if (keyword == "p" || keyword == "pp") {
      read_polygon(tokens);
    } else if (keyword == "f") {
      read_material(tokens);
    } else if (keyword == "l") {
      read_light(tokens);
    } else if (keyword == "b") {
      expect(tokens, 3, "b R G B");
      once(has_background_, "a second background b");
      scene_.background = colour(tokens, 1, 1, "a background channel");
    } else if (keyword == "v") {
      expect(tokens, 0, "v alone and from, at, up and angle on lines of their own");
      once(has_view_, "a second v block");
      in_view_ = true;
      scene_.camera.line = line_;
    } else if (keyword == "c") {
      start_cone(tokens);
    } else {
      fail_here("unknown entity " + quoted(keyword) + "; use one of b v l f s p pp c, or # for a comment");
    }
  }

  void read_extension(const Tokens &tokens) {
    const std::string_view keyword = tokens.empty() ? std::string_view() : tokens[0];
    if (cone_ends_missing_ > 0) {
      fail_here("an extension within a cone; put it above the line c");
    }
    if (keyword == "plane") {
      if (vertices_missing_ > 0) {
        fail_truncated("line " + std::to_string(line_) + " is a plane");
      }
      read_plane(tokens);
    } else if (keyword == "object") {
      read_object(tokens);
    } else if (keyword == "tan_half_fov") {
      expect(tokens, 1, "#fc: tan_half_fov T");
      only_if(!scene_.camera.tan_half_fov, "a second #fc: tan_half_fov");
      const Number tangent = number(tokens[1]);
      if (tangent.value <= 0 || tangent.value > max_tan_half_fov) {
        fail_here("tan_half_fov " + tangent.text + " is out of range; use a number above 0, at most 1000");
      }
      scene_.camera.tan_half_fov = tangent;
    } else if (keyword == "cone_error") {
      expect(tokens, 1, "#fc: cone_error E");
      const Number error = number(tokens[1]);
      if (error.value < 1e-5L || error.value > 0.5L) {
        fail_here("cone_error " + error.text + " is out of range; use a part of the radius from 0.00001 to 0.5");
      }
      cone_error_ = error.value;
    } else if (keyword == "far") {
      expect(tokens, 1, "#fc: far DISTANCE");
      only_if(!scene_.far, "a second #fc: far");
      const Number distance = number(tokens[1]);
      if (distance.value <= 0) {
        fail_here("far " + distance.text + " is out of range; use a distance above 0");
      }
      scene_.far = distance;
    } else if (keyword == "ambient") {
      once(has_ambient_, "a second #fc: ambient");
      if (tokens.size() == 2) {
        const Number level = ranged(tokens[1], max_intensity, "an ambient level");
        scene_.ambient.r = scene_.ambient.g = scene_.ambient.b = level;
      } else {
        expect(tokens, 3, "#fc: ambient A or #fc: ambient R G B");
        scene_.ambient = colour(tokens, 1, max_intensity, "an ambient channel");
      }
    } else if (keyword == "falloff") {
      once(has_falloff_, "a second #fc: falloff");
      if (tokens.size() == 1 || (tokens.size() == 2 && tokens[1] == "inverse-square")) {
        scene_.falloff = Falloff::inverse_square;
      } else if (tokens.size() != 2 || tokens[1] != "none") {
        fail_here(
            "a falloff that is neither inverse-square nor none; write #fc: falloff inverse-square "
            "or #fc: falloff none");
      }
    } else if (keyword == "gradient") {
      expect(tokens, 6, "#fc: gradient UPX UPY UPZ R G B");
      only_if(!scene_.gradient, "a second #fc: gradient");
      scene_.gradient = Gradient{vector(tokens, 1), colour(tokens, 4, 1, "a background channel"), line_};
    } else if (keyword == "sun") {
      read_sun(tokens);
    } else if (keyword == "mirror" || keyword == "emission" || keyword == "checker" || keyword == "image") {
      read_layer(tokens);
    } else {
      fail_here("unknown extension " + quoted(keyword) +
                " after #fc:; use one of plane object tan_half_fov "
                "far ambient falloff cone_error gradient sun mirror emission checker image, or # alone for a comment");
    }
  }

  void read_sun(const Tokens &tokens) {
    expect(tokens, 6, "#fc: sun X Y Z R G B, X Y Z the direction towards it");
    Light light;
    light.directional = true;
    light.position = vector(tokens, 1);
    light.colour = colour(tokens, 4, max_intensity, "a light channel");
    light.line = line_;
    if (light.position.x.value == 0 && light.position.y.value == 0 && light.position.z.value == 0) {
      fail_here("the sun's direction is 0 0 0; say where it stands, such as 1 2 1");
    }
    scene_.lights.push_back(std::move(light));
  }

  /* What is said about the material of the last line f. */
  void read_layer(const Tokens &tokens) {
    Material &material = scene_.materials.at(static_cast<std::size_t>(current_material()));
    const std::string_view keyword = tokens[0];
    if (keyword == "mirror") {
      if (tokens.size() != 5) expect(tokens, 3, "#fc: mirror R G B or #fc: mirror R G B BOUNCES");
      only_if(!material.mirror, "a second #fc: mirror of this material");
      material.mirror = Mirror{colour(tokens, 1, 1, "a mirror's reflectance"),
                               tokens.size() == 5 ? integer(tokens[4], 1, 16, "a number of bounces") : 4};
    } else if (keyword == "emission") {
      expect(tokens, 3, "#fc: emission R G B");
      only_if(!material.emission, "a second #fc: emission of this material");
      material.emission = colour(tokens, 1, 200, "an emission channel");
    } else {
      only_if(!material.texture, "a second texture of this material");
      material.texture = keyword == "checker" ? read_checker(tokens) : read_image(tokens);
    }
  }

  Texture read_checker(const Tokens &tokens) const {
    if (tokens.size() < 8) fail_here("a checker of too few values; write #fc: checker R G B R G B MAPPING");
    Texture texture;
    texture.checker = {colour(tokens, 1, 1, "a checker's colour"), colour(tokens, 4, 1, "a checker's colour")};
    texture.mapping = read_mapping(tokens, 7);
    return texture;
  }

  Texture read_image(const Tokens &tokens) const {
    if (tokens.size() < 3) fail_here("an image of too few values; write #fc: image FILE.ppm [bilinear] [clamp] [modulate] MAPPING");
    Texture texture;
    const std::filesystem::path name(std::string{tokens[1]});
    const std::string path = name.is_absolute() ? name.string() : (std::filesystem::path(path_).parent_path() / name).string();
    std::size_t next = 2;
    for (; next < tokens.size(); next++) {
      if (tokens[next] == "bilinear") texture.bilinear = true;
      else if (tokens[next] == "clamp") texture.clamp = true;
      else if (tokens[next] == "modulate") texture.modulate = true;
      else break;
    }
    texture.mapping = read_mapping(tokens, next);
    texture.texels = load_texels(path, texture.width, texture.height);
    return texture;
  }

  std::shared_ptr<const std::vector<std::uint8_t>> load_texels(const std::string &path, int &width, int &height) const {
    std::string bytes;
    try {
      bytes = load_text(path);
    } catch (const UserError &error) {
      fail_here(std::string("the image cannot be read: ") + error.what());
    }
    std::istringstream in(bytes);
    std::string magic;
    int most = 0;
    in >> magic >> width >> height >> most;
    if (!in || magic != "P6" || most != 255 || width < 1 || height < 1 || width > 4096 || height > 4096 || in.get() == EOF) {
      fail_here(path + " is not a PPM file of 8 bits (P6, 1x1 to 4096x4096); convert it");
    }
    auto texels = std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    in.read(reinterpret_cast<char *>(texels->data()), static_cast<std::streamsize>(texels->size()));
    if (static_cast<std::size_t>(in.gcount()) != texels->size()) fail_here(path + " ends before its last pixel; save it again");
    return texels;
  }

  Mapping read_mapping(const Tokens &tokens, std::size_t first) const {
    Mapping mapping;
    const std::string_view kind = first < tokens.size() ? tokens[first] : std::string_view();
    std::size_t next = first + 1;
    if (kind == "planar" && tokens.size() >= first + 10) {
      mapping.kind = Mapping::Kind::planar;
      mapping.origin = vector(tokens, first + 1);
      mapping.u = vector(tokens, first + 4);
      mapping.v = vector(tokens, first + 7);
      next = first + 10;
      for (const Vector *axis : {&mapping.u, &mapping.v}) {
        if (axis->x.value == 0 && axis->y.value == 0 && axis->z.value == 0) fail_here("a mapping's axis is 0 0 0; give it a length");
      }
    } else if (kind == "spherical") {
      mapping.kind = Mapping::Kind::spherical;
    } else if (kind == "vertices") {
      mapping.kind = Mapping::Kind::vertices;
    } else {
      fail_here("a texture without a mapping; end the line with spherical, vertices, or planar and nine numbers (origin, u, v)");
    }
    if (next < tokens.size()) {
      if (tokens[next] != "repeat" || tokens.size() != next + 3) fail_here("unknown words after the mapping; write repeat N M, or nothing");
      mapping.repeat_u = integer(tokens[next + 1], 1, 255, "a number of tiles");
      mapping.repeat_v = integer(tokens[next + 2], 1, 255, "a number of tiles");
    }
    return mapping;
  }

  static bool is_view_field(std::string_view keyword) {
    for (const char *const field : {"from", "at", "up", "angle", "hither", "resolution"}) {
      if (keyword == field) {
        return true;
      }
    }
    return false;
  }

  void read_view_field(const Tokens &tokens) {
    const std::string_view keyword = tokens[0];
    if (keyword == "from") {
      expect(tokens, 3, "from X Y Z");
      once(has_from_, "a second from");
      scene_.camera.from = vector(tokens, 1);
    } else if (keyword == "at") {
      expect(tokens, 3, "at X Y Z");
      once(has_at_, "a second at");
      scene_.camera.at = vector(tokens, 1);
    } else if (keyword == "up") {
      expect(tokens, 3, "up X Y Z");
      once(has_up_, "a second up");
      scene_.camera.up = vector(tokens, 1);
    } else if (keyword == "angle") {
      expect(tokens, 1, "angle DEGREES");
      once(has_angle_, "a second angle");
      scene_.camera.angle_degrees = number(tokens[1]);
      const long double angle = scene_.camera.angle_degrees.value;
      if (angle <= 0 || angle >= 180) {
        fail_here("angle " + scene_.camera.angle_degrees.text +
                  " is out of range; use degrees between 0 and 180");
      }
    } else if (keyword == "hither") {
      expect(tokens, 1, "hither DISTANCE");
      scene_.camera.hither = number(tokens[1]);
    } else {
      expect(tokens, 2, "resolution WIDTH HEIGHT");
      only_if(scene_.width == 0, "a second resolution");
      scene_.width = integer(tokens[1], 1, 65535, "a width in pixels");
      scene_.height = integer(tokens[2], 1, 65535, "a height in pixels");
    }
  }

  void read_sphere(const Tokens &tokens) {
    expect(tokens, 4, "s X Y Z RADIUS");
    Sphere sphere;
    sphere.material = current_material();
    sphere.object = next_object();
    sphere.line = line_;
    sphere.center = vector(tokens, 1);
    sphere.radius = number(tokens[4]);
    if (sphere.radius.value <= 0) {
      fail_here("radius " + sphere.radius.text +
                " is not above 0; give a positive radius or remove the sphere");
    }
    scene_.spheres.push_back(std::move(sphere));
  }

  void read_plane(const Tokens &tokens) {
    expect(tokens, 4, "#fc: plane NX NY NZ D");
    Plane plane;
    plane.material = current_material();
    plane.object = next_object();
    plane.line = line_;
    plane.normal = vector(tokens, 1);
    plane.d = number(tokens[4]);
    if (plane.normal.x.value == 0 && plane.normal.y.value == 0 && plane.normal.z.value == 0) {
      fail_here("the plane's normal is 0 0 0; give it a direction, such as 0 1 0");
    }
    scene_.planes.push_back(std::move(plane));
  }

  void read_polygon(const Tokens &tokens) {
    with_normals_ = tokens[0] == "pp";
    expect(tokens, 1, with_normals_ ? "pp COUNT" : "p COUNT");
    const int count = integer(tokens[1], 3, max_vertices, "a polygon's vertex count");
    Polygon polygon;
    polygon.material = current_material();
    polygon.object = next_object();
    polygon.line = line_;
    polygon.vertices.reserve(static_cast<std::size_t>(count));
    scene_.polygons.push_back(std::move(polygon));
    vertices_missing_ = vertices_announced_ = count;
  }

  /* "c" with base and apex on lines of their own, X Y Z RADIUS each, or on its own line. */
  void start_cone(const Tokens &tokens) {
    if (tokens.size() != 1 && tokens.size() != 9) {
      expect(tokens, 0, "c alone, then two lines X Y Z RADIUS, or all eight numbers behind it");
    }
    cone_pattern_ = Polygon{};
    cone_pattern_.material = current_material();
    cone_pattern_.object = next_object();
    cone_pattern_.line = line_;
    cone_ends_missing_ = 2;
    if (tokens.size() == 9) {
      cone_.base = vector(tokens, 1);
      cone_.base_radius = number(tokens[4]);
      cone_.apex = vector(tokens, 5);
      cone_.apex_radius = number(tokens[8]);
      finish_cone();
    }
  }

  void read_cone_end(const Tokens &tokens) {
    if (tokens.size() != 4) {
      fail_here("an end of a cone with " + std::to_string(tokens.size()) + " numbers; write X Y Z RADIUS");
    }
    (cone_ends_missing_ == 2 ? cone_.base : cone_.apex) = vector(tokens, 0);
    (cone_ends_missing_ == 2 ? cone_.base_radius : cone_.apex_radius) = number(tokens[3]);
    if (--cone_ends_missing_ == 0) {
      finish_cone();
    }
  }

  void finish_cone() {
    cone_ends_missing_ = 0;
    if (cone_.base_radius.value <= 0 && cone_.apex_radius.value <= 0) { /* NFF: seen from inside only; here from both sides */
      for (Number *radius : {&cone_.base_radius, &cone_.apex_radius}) {
        if (radius->value < 0) {
          *radius = Number{radius->text.substr(1), -radius->value};
        }
      }
    }
    const long double low = cone_.base_radius.value, high = cone_.apex_radius.value;
    if (low < 0 || high < 0 || (low == 0 && high == 0)) {
      fail_here("a cone of radii " + cone_.base_radius.text + " and " + cone_.apex_radius.text +
                "; give both one sign, and one of them a size");
    }
    const Direction axis = direction({cone_.apex.x.value - cone_.base.x.value, cone_.apex.y.value - cone_.base.y.value,
                                      cone_.apex.z.value - cone_.base.z.value});
    if (axis.length == 0) {
      fail_here("a cone whose base and apex are one point; move one of them");
    }
    for (Polygon &triangle : cone_mesh(cone_, cone_error_, cone_pattern_)) {
      if (scene_.polygons.size() >= max_cone_triangles) {
        fail_here("cones of more than " + std::to_string(max_cone_triangles) + " triangles; raise #fc: cone_error or use fewer");
      }
      scene_.polygons.push_back(std::move(triangle));
    }
    scene_.cones++;
    scene_.cone_error = std::max(scene_.cone_error, cone_error_);
  }

  void read_vertex(const Tokens &tokens) {
    for (const char *const keyword : {"b", "v", "l", "f", "s", "p", "pp", "c"}) {
      if (tokens[0] == keyword) {
        fail_truncated("line " + std::to_string(line_) + " starts with " + quoted(keyword));
      }
    }
    const std::size_t count = with_normals_ ? 6 : 3;
    if (tokens.size() != count) {
      fail_here("a vertex of " + std::to_string(tokens.size()) + " numbers; write " +
                (with_normals_ ? "X Y Z NX NY NZ" : "X Y Z"));
    }
    Polygon &polygon = scene_.polygons.back();
    polygon.vertices.push_back(vector(tokens, 0));
    if (with_normals_) {
      polygon.normals.push_back(vector(tokens, 3));
    }
    vertices_missing_--;
  }

  [[noreturn]] void fail_truncated(const std::string &instead) const {
    /* clang-format off */
    fail(path_, scene_.polygons.back().line, "polygon of " + std::to_string(vertices_announced_) +
         " vertices with only " + std::to_string(vertices_announced_ - vertices_missing_) + " of them (" +
         instead + "); add the missing vertices or correct the count");
    /* clang-format on */
  }

  void read_material(const Tokens &tokens) {
    expect(tokens, 8, "f R G B Kd Ks SHINE T INDEX");
    Material material;
    material.colour = colour(tokens, 1, 1, "a colour channel");
    material.kd = ranged(tokens[4], 1, "Kd");
    material.ks = ranged(tokens[5], max_magnitude, "Ks");
    material.shine = ranged(tokens[6], max_magnitude, "shine");
    material.transmittance = ranged(tokens[7], max_magnitude, "T");
    material.index_of_refraction = ranged(tokens[8], max_magnitude, "the index of refraction");
    material.line = line_;
    scene_.materials.push_back(std::move(material));
  }

  void read_light(const Tokens &tokens) {
    Light light;
    if (tokens.size() == 7) {
      light.colour = colour(tokens, 4, max_intensity, "a light channel");
    } else {
      expect(tokens, 3, "l X Y Z or l X Y Z R G B");
    }
    light.position = vector(tokens, 1);
    light.line = line_;
    scene_.lights.push_back(std::move(light));
  }

  void read_object(const Tokens &tokens) {
    expect(tokens, 1, "#fc: object N or #fc: object auto");
    fixed_object_ = tokens[1] == "auto" ? 0 : integer(tokens[1], 1, max_object, "an object id");
  }

  /* Counts the entity and tells its id; under "#fc: object N" entities are counted all the same. */
  std::uint16_t next_object() {
    entities_++;
    if (scene_.spheres.size() + scene_.planes.size() + scene_.polygons.size() >= max_primitives) {
      fail_here("more than " + std::to_string(max_primitives) + " primitives; simplify the scene or split it");
    }
    const int object = fixed_object_ != 0 ? fixed_object_ : entities_;
    if (object > max_object) {
      fail_here("this is entity " + std::to_string(entities_) +
                ", but ids end at 65535; "
                "group entities with #fc: object N");
    }
    return static_cast<std::uint16_t>(object);
  }

  int current_material() const {
    if (scene_.materials.empty()) {
      fail_here("an entity before the first material; put a line f R G B Kd Ks SHINE T INDEX above it");
    }
    return static_cast<int>(scene_.materials.size()) - 1;
  }

  /* Complains unless exactly `count` tokens follow the keyword. */
  void expect(const Tokens &tokens, std::size_t count, const char *usage) const {
    if (tokens.size() != count + 1) {
      fail_here(quoted(tokens[0]) + " is followed by " + std::to_string(tokens.size() - 1) +
                (tokens.size() == 2 ? " value" : " values") + "; write " + usage);
    }
  }

  /* For what a file may say only once. */
  void only_if(bool first, const char *what) const {
    if (!first) {
      fail_here(std::string(what) + "; keep only one");
    }
  }

  void once(bool &seen, const char *what) const {
    only_if(!seen, what);
    seen = true;
  }

  int integer(std::string_view token, int lowest, int highest, const char *what) const {
    std::string_view rest = token;
    std::string_view digits = take_digits(rest);
    while (digits.size() > 1 && digits[0] == '0') {
      digits.remove_prefix(1);
    }
    const bool readable = rest.empty() && !digits.empty() && digits.size() <= 8;
    const int value = readable ? std::atoi(std::string(digits).c_str()) : -1;
    if (value < lowest || value > highest) {
      fail_here(quoted(token) + " cannot be " + what + "; use a whole number from " + std::to_string(lowest) +
                " to " + std::to_string(highest));
    }
    return value;
  }

  /* The text is kept but for spellings that only make work for its readers: no '+' in front, digits on both
   * sides of a point, and every zero is "0". */
  Number number(std::string_view token) const {
    std::string_view rest = token;
    std::string text;
    if (!rest.empty() && (rest[0] == '+' || rest[0] == '-')) {
      text = rest[0] == '-' ? "-" : "";
      rest.remove_prefix(1);
    }
    const std::string_view whole = take_digits(rest);
    if (!rest.empty() && rest[0] == '/') {
      return fraction(token, text, whole, rest.substr(1));
    }
    std::string_view decimals;
    if (!rest.empty() && rest[0] == '.') {
      rest.remove_prefix(1);
      decimals = take_digits(rest);
    }
    bool valid = !whole.empty() || !decimals.empty();
    std::string exponent;
    if (!rest.empty() && (rest[0] == 'e' || rest[0] == 'E')) {
      exponent = "e";
      rest.remove_prefix(1);
      if (!rest.empty() && (rest[0] == '+' || rest[0] == '-')) {
        exponent += rest[0];
        rest.remove_prefix(1);
      }
      const std::string_view digits = take_digits(rest);
      exponent += digits;
      valid = valid && !digits.empty();
    }
    if (!valid || !rest.empty()) {
      fail_not_a_number(token);
    }
    if (all_zero(whole) && all_zero(decimals)) {
      return Number{};
    }
    text += whole.empty() ? "0" : whole;
    if (!decimals.empty()) {
      text.append(".").append(decimals);
    }
    text += exponent;
    const long double value = std::strtold(text.c_str(), nullptr); /* the program stays in the C locale */
    if (std::fabs(value) > max_magnitude) {
      fail_here(quoted(token) + " is beyond 1e30; write the scene in larger units");
    }
    if (std::fabs(value) < min_magnitude) {
      fail_here(quoted(token) + " is nearer to 0 than 1e-4000; write 0");
    }
    return Number{text, value};
  }

  Number fraction(std::string_view token, const std::string &sign, std::string_view above,
                  std::string_view below) const {
    std::string_view rest = below;
    const std::string_view digits = take_digits(rest);
    if (above.empty() || digits.empty() || !rest.empty()) {
      fail_not_a_number(token);
    }
    if (above.size() > max_fraction_digits || digits.size() > max_fraction_digits) {
      fail_here(quoted(token) + " has more than 18 digits above or below the line; write it as a decimal");
    }
    if (all_zero(digits)) {
      fail_here(quoted(token) + " divides by zero, so it is not a finite number; give another denominator");
    }
    if (all_zero(above)) {
      return Number{};
    }
    const std::string numerator = sign + std::string(above);
    const std::string denominator(digits);
    return Number{numerator + "/" + denominator,
                  std::strtold(numerator.c_str(), nullptr) / std::strtold(denominator.c_str(), nullptr)};
  }

  [[noreturn]] void fail_not_a_number(std::string_view token) const {
    fail_here(quoted(token) +
              " is not a finite number; write a decimal such as -1.5e3 or a fraction such as 1/2");
  }

  Number ranged(std::string_view token, long double highest, const char *what) const {
    const Number result = number(token);
    if (result.value < 0 || result.value > highest) {
      char range[60];
      std::snprintf(range, sizeof range, "use a number from 0 to %Lg", highest);
      fail_here(result.text + " is out of range for " + what + "; " + range);
    }
    return result;
  }

  Vector vector(const Tokens &tokens, std::size_t first) const {
    return Vector{number(tokens[first]), number(tokens[first + 1]), number(tokens[first + 2])};
  }

  Rgb colour(const Tokens &tokens, std::size_t first, long double highest, const char *what) const {
    return Rgb{ranged(tokens[first], highest, what), ranged(tokens[first + 1], highest, what),
               ranged(tokens[first + 2], highest, what)};
  }

  void check_camera() const {
    const Camera &camera = scene_.camera;
    if (!has_view_) {
      fail_here(
          "the file ends without a v block; "
          "add the lines v, from X Y Z, at X Y Z, up X Y Z and angle DEGREES");
    }
    if (!has_from_ || !has_at_ || !has_up_) {
      const std::string field = !has_from_ ? "from" : !has_at_ ? "at"
                                                               : "up";
      fail(path_, camera.line, "the v block has no " + field + "; add a line " + field + " X Y Z to it");
    }
    if (!has_angle_ && !camera.tan_half_fov) {
      fail(path_, camera.line, "the v block has no angle; add a line angle DEGREES or #fc: tan_half_fov T");
    }
    const Direction forward = direction({camera.at.x.value - camera.from.x.value,
                                         camera.at.y.value - camera.from.y.value,
                                         camera.at.z.value - camera.from.z.value});
    if (forward.length == 0) {
      fail(path_, camera.line, "from and at are the same point; move one of them");
    }
    const Direction up = direction({camera.up.x.value, camera.up.y.value, camera.up.z.value});
    if (up.length == 0) {
      fail(path_, camera.line, "up is 0 0 0; give it a direction, such as 0 1 0");
    }
    const Direction right = {forward.y * up.z - forward.z * up.y, forward.z * up.x - forward.x * up.z,
                             forward.x * up.y - forward.y * up.x};
    if (std::hypot(right.x, right.y, right.z) <= parallel_tolerance * forward.length * up.length) {
      fail(path_, camera.line, "up is parallel to the view direction; choose an up that leans away from it");
    }
  }

  struct Direction {
    long double x, y, z, length = 0;
  };

  /* Scaled so that the largest component is 1: no product of two components can underflow. */
  static Direction direction(Direction v) {
    const long double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (largest > 0) {
      v = {v.x / largest, v.y / largest, v.z / largest};
      v.length = std::hypot(v.x, v.y, v.z);
    }
    return v;
  }

  const std::string &path_;
  int line_ = 0;
  SceneFile scene_;
  int entities_ = 0;
  int fixed_object_ = 0;     /* 0: ids count */
  int vertices_missing_ = 0; /* of the polygon being read */
  int vertices_announced_ = 0;
  Cone cone_; /* being read */
  Polygon cone_pattern_;
  int cone_ends_missing_ = 0;
  long double cone_error_ = default_cone_error;
  bool with_normals_ = false;
  bool in_view_ = false;
  bool has_view_ = false, has_from_ = false, has_at_ = false, has_up_ = false, has_angle_ = false;
  bool has_background_ = false, has_ambient_ = false, has_falloff_ = false;
};

} // namespace

SceneFile read_nff(const std::string &path) {
  TextLines lines(path, LineEnd::lf);
  return Reader(path).read(lines);
}

SceneFile read_nff_text(const std::string &name, std::string_view text) {
  TextLines lines(text, LineEnd::lf);
  return Reader(name).read(lines);
}

} // namespace host
