/*
 * Reads Wavefront OBJ by tinyobjloader: polygons, normals, groups as objects, diffuse colours of materials.
 *
 * The numbers are the doubles that tinyobjloader reads, written out exactly; the core and the oracle take these. A file names no camera and
 * no light: the caller puts them in (auto_view.h).
 */
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#endif
#include <tiny_obj_loader.h>
#undef TINYOBJLOADER_IMPLEMENTATION
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <istream>
#include <map>
#include <streambuf>
#include <utility>

#include "obj.h"
#include "obj_materials.h"
#include "obj_words.h"
#include "text_lines.h"
#include "triangulate.h"

namespace host {
namespace {

constexpr std::size_t max_faces = 65535, max_corners = 65535;
constexpr double max_coordinate = 1e30;

[[noreturn]] void fail(const std::string &path, const std::string &sentence) { throw UserError(path + ": " + sentence); }

/* A corner of a face: 1, 1/2, 1//3 or 1/2/3, each number of at most nine digits, perhaps negative. */
bool is_corner(std::string_view text) {
  for (int part = 0; part < 3; part++) {
    if (!text.empty() && text[0] == '-') text.remove_prefix(1);
    const std::size_t digits = take_digits(text);
    if (digits > 9 || (digits == 0 && part != 1)) return false;
    if (text.empty()) return digits > 0;
    if (text[0] != '/') return false;
    text.remove_prefix(1);
  }
  return false;
}

/* What stands behind the keyword, word by word. */
void check_words(const std::string &path, std::size_t number, std::string_view keyword, std::string_view line) {
  const bool face = keyword == "f", numbers = keyword == "v" || keyword == "vn" || keyword == "vt";
  if (!face && !numbers) return;
  const std::vector<std::string_view> words = words_behind(keyword, line);
  for (const std::string_view word : words)
    if (face ? !is_corner(word) : !is_number(word))
      fail_line(path, number,
                std::string(face ? "a corner that is not written as 1, 1/2, 1//3 or 1/2/3" : "a word that is not a decimal number") +
                    "; correct it");
  if (words.size() < (keyword == "vt" ? 1u : 3u))
    fail_line(path, number, "fewer than three " + std::string(face ? "corners" : "numbers") + "; complete the line");
}

/* A read-only stream over the lines that are used here, each looked at before tinyobjloader sees it; others (vw, t, l, p, ...) would be read
 * by parts of it that trust them. What is wrong is kept and ends the stream, as streams swallow exceptions. */
class UsedLines : public std::streambuf {
public:
  UsedLines(const std::string &path, TextLines &lines) : path_(path), lines_(lines) {}

  void throw_if_wrong() const {
    if (wrong_) std::rethrow_exception(wrong_);
  }

protected:
  int_type underflow() override {
    try {
      std::string_view line;
      while (!wrong_ && lines_.next(line)) {
        number_++;
        check_line(path_, number_, line);
        const std::string_view keyword = keyword_of(line);
        if (keyword == "f" && ++faces_ > max_faces) fail_line(path_, number_, "more than 65535 faces; simplify the model");
        check_words(path_, number_, keyword, line);
        for (const char *const used : {"v", "vn", "vt", "f", "o", "g", "usemtl", "mtllib"}) {
          if (keyword != used) continue;
          char *const begin = const_cast<char *>(line.data()); /* only read from */
          setg(begin, begin, begin + line.size());
          return traits_type::to_int_type(*begin);
        }
      }
    } catch (const UserError &) {
      wrong_ = std::current_exception();
    }
    return traits_type::eof();
  }

private:
  const std::string &path_;
  TextLines &lines_;
  std::size_t number_ = 0, faces_ = 0;
  std::exception_ptr wrong_;
};

/* Materials from beside the model; what is missing is told, and grey. */
class Materials : public tinyobj::MaterialReader {
public:
  Materials(std::string directory, std::vector<std::string> &warnings) : directory_(std::move(directory)), warnings_(warnings) {}

  bool operator()(const std::string &name, std::vector<tinyobj::material_t> *materials, std::map<std::string, int> *index, std::string *,
                  std::string *) override {
    const std::string path = (std::filesystem::path(directory_) / name).string();
    std::error_code ignored;
    if (directory_.empty() || !std::filesystem::is_regular_file(path, ignored)) {
      warnings_.push_back("cannot open the material file " + printable(name) + "; its materials are grey");
      return false;
    }
    try {
      TextLines lines(path, LineEnd::any);
      textured_ = read_materials(path, lines, *materials, *index) || textured_;
    } catch (const UserError &) {
      wrong_ = std::current_exception();
      return false;
    }
    return true;
  }

  bool textured() const { return textured_; }

  void throw_if_wrong() const {
    if (wrong_) std::rethrow_exception(wrong_);
  }

private:
  static std::string printable(std::string name) {
    for (char &c : name)
      if (c < ' ' || c > '~') c = '?';
    return name;
  }

  std::string directory_;
  std::vector<std::string> &warnings_;
  bool textured_ = false;
  std::exception_ptr wrong_;
};

/* The shortest decimals that read back as this double. */
Number number_of(double value) {
  if (value == 0) return Number{};
  char text[40];
  for (int digits = 6; digits <= 17; digits++) {
    (void)std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return {text, std::strtold(text, nullptr)};
}

Rgb colour_of(const double *rgb) {
  std::array<Number, 3> c;
  for (std::size_t i = 0; i < 3; i++) c[i] = number_of(rgb[i] > 0 ? std::min(rgb[i], 1.0) : 0.0);
  return {c[0], c[1], c[2]};
}

Material material_of(const double *rgb) {
  Material material;
  material.colour = colour_of(rgb);
  material.kd = {"1", 1};
  return material;
}

class Converter {
public:
  Converter(const std::string &path, const tinyobj::attrib_t &attributes) : path_(path), attributes_(attributes) {}

  void add_materials(SceneFile &scene, const std::vector<tinyobj::material_t> &materials) const {
    const double grey[3] = {0.8, 0.8, 0.8};
    scene.materials.push_back(material_of(grey)); /* of faces without one */
    for (const tinyobj::material_t &material : materials) scene.materials.push_back(material_of(material.diffuse));
  }

  void add_shape(SceneFile &scene, const tinyobj::shape_t &shape, std::uint16_t object) {
    std::size_t first = 0;
    for (std::size_t f = 0; f < shape.mesh.num_face_vertices.size(); f++) {
      face_++;
      const std::size_t corners = shape.mesh.num_face_vertices[f];
      if (corners >= 3) add_triangles(scene, polygon_of(shape, f, first, corners, object, scene.materials.size()));
      first += corners;
    }
  }

private:
  [[noreturn]] void fail_face(const std::string &sentence) const { fail(path_, "face " + std::to_string(face_) + " " + sentence); }

  /* A face need not be flat, but a polygon must. */
  static void add_triangles(SceneFile &scene, const Polygon &face) {
    if (face.vertices.size() == 3) {
      scene.polygons.push_back(face);
      return;
    }
    for (const std::array<int, 3> &corners : triangulate(face)) {
      Polygon triangle;
      triangle.material = face.material;
      triangle.object = face.object;
      for (const int corner : corners) {
        triangle.vertices.push_back(face.vertices[static_cast<std::size_t>(corner)]);
        if (!face.normals.empty()) triangle.normals.push_back(face.normals[static_cast<std::size_t>(corner)]);
      }
      scene.polygons.push_back(std::move(triangle));
    }
  }

  Polygon polygon_of(const tinyobj::shape_t &shape, std::size_t face, std::size_t first, std::size_t corners, std::uint16_t object,
                     std::size_t materials) const {
    if (corners > max_corners || first + corners > shape.mesh.indices.size()) fail_face("has more than 65535 corners; split it");
    Polygon polygon;
    polygon.object = object;
    const int material = face < shape.mesh.material_ids.size() ? shape.mesh.material_ids[face] : -1;
    polygon.material = material >= 0 && static_cast<std::size_t>(material) + 1 < materials ? material + 1 : 0;
    bool with_normals = true;
    for (std::size_t i = 0; i < corners; i++) {
      const tinyobj::index_t &index = shape.mesh.indices[first + i];
      polygon.vertices.push_back(triple(attributes_.vertices, index.vertex_index, "a vertex"));
      with_normals = with_normals && index.normal_index >= 0;
      if (with_normals) polygon.normals.push_back(triple(attributes_.normals, index.normal_index, "a normal"));
    }
    if (!with_normals) polygon.normals.clear();
    return polygon;
  }

  Vector triple(const std::vector<double> &from, int index, const char *what) const {
    if (index < 0 || static_cast<std::size_t>(index) >= from.size() / 3)
      fail_face(std::string("names ") + what + " that does not exist; correct its numbers");
    const std::size_t at = 3 * static_cast<std::size_t>(index);
    for (std::size_t i = 0; i < 3; i++)
      if (!(std::fabs(from[at + i]) <= max_coordinate))
        fail_face(std::string("names ") + what + " with a coordinate that is no number or beyond 1e30; correct it");
    return {number_of(from[at]), number_of(from[at + 1]), number_of(from[at + 2])};
  }

  const std::string &path_;
  const tinyobj::attrib_t &attributes_;
  std::size_t face_ = 0;
};

SceneFile read_obj_lines(const std::string &name, TextLines &text, const std::string &material_directory) {
  SceneFile scene;
  scene.path = name;
  Materials reader(material_directory, scene.warnings);
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  UsedLines lines(name, text);
  std::istream stream(&lines);
  const bool loaded = tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, &reader, false, false);
  lines.throw_if_wrong();
  reader.throw_if_wrong();
  if (!loaded) {
    std::replace(error.begin(), error.end(), '\n', ' ');
    fail(name, "not a readable OBJ: " + error + "; save the model again");
  }
  Converter converter(name, attributes);
  converter.add_materials(scene, materials);
  if (shapes.size() > 65535) fail(name, "more than 65535 groups; merge some");
  for (std::size_t i = 0; i < shapes.size(); i++) converter.add_shape(scene, shapes[i], static_cast<std::uint16_t>(i + 1));
  if (scene.polygons.empty()) fail(name, "no faces; a model needs lines f");
  if (reader.textured()) scene.warnings.emplace_back("textures are not drawn; their materials show Kd alone");
  return scene;
}

} // namespace

SceneFile read_obj_text(const std::string &name, std::string_view text, const std::string &material_directory) {
  TextLines lines(text, LineEnd::any);
  return read_obj_lines(name, lines, material_directory);
}

SceneFile read_obj(const std::string &path) {
  const std::string directory = std::filesystem::path(path).parent_path().string();
  TextLines lines(path, LineEnd::any);
  return read_obj_lines(path, lines, directory.empty() ? "." : directory);
}

} // namespace host
