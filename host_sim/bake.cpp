/* A scene as C. */
#include "bake.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "narrow.h"
#include "version.h"

namespace host {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/* Beyond 16 bits a plain constant would depend on the chip's int. */
std::string c_int(std::int32_t v) {
  const std::string text = std::to_string(v);
  return v >= -32767 && v <= 32767 ? text : "INT32_C(" + text + ")";
}

std::string c_uint(std::uint32_t v) {
  const std::string text = std::to_string(v);
  return v <= 32767 ? text : "UINT32_C(" + text + ")";
}

std::string c_u16(std::uint16_t v) {
  const std::string text = std::to_string(v);
  return v <= 32767 ? text : text + "u";
}

std::string c_vec3(const fc_vec3 &v) { return "{" + c_int(v.x) + ", " + c_int(v.y) + ", " + c_int(v.z) + "}"; }
std::string c_rgb(const fc_rgb &c) { return "{" + c_u16(c.r) + ", " + c_u16(c.g) + ", " + c_u16(c.b) + "}"; }

std::string c_item(std::uint16_t v) {
  return c_u16(v);
}
std::string c_item(const fc_bvh_node &n) {
  return "{{" + c_uint(n.axis[0]) + ", " + c_uint(n.axis[1]) + ", " + c_uint(n.axis[2]) + "}}";
}
std::string c_item(const fc_vec3 &v) {
  return c_vec3(v);
}
std::string c_item(const fc_short_vec3 &v) {
  return "{" + c_int(v.x) + ", " + c_int(v.y) + ", " + c_int(v.z) + "}";
}
std::string c_item(const fc_normal &n) {
  return "{" + c_int(n.x) + ", " + c_int(n.y) + ", " + c_int(n.z) + "}";
}
std::string c_item(const fc_uv &t) {
  return "{" + c_int(t.u) + ", " + c_int(t.v) + "}";
}
std::string c_item(const fc_sphere &s) {
  return "{" + c_vec3(s.center) + ", " + c_int(s.radius) + ", " + c_u16(s.material) + ", " + c_u16(s.object) + "}";
}
std::string c_item(const fc_plane &p) {
  return "{" + c_vec3(p.normal) + ", " + c_int(p.d) + ", " + c_int(p.d_exponent) + ", " + c_u16(p.material) + ", " + c_u16(p.object) + "}";
}
std::string c_item(const fc_triangle &t) {
  return "{{" + c_u16(t.vertex[0]) + ", " + c_u16(t.vertex[1]) + ", " + c_u16(t.vertex[2]) + "}, " + c_u16(t.material) + ", " +
         c_u16(t.object) + "}";
}
std::string c_item(const fc_light &l) {
  return "{" + c_vec3(l.position) + ", " + c_rgb(l.intensity) + ", " + c_int(l.exponent) + ", " +
         c_int(l.intensity_exponent) + ", " + c_int(l.inverse_square) + ", " + c_int(l.directional) + "}";
}

/* One table, and a blank line; nothing when it would be empty, which C does not allow. */
template <typename T>
std::string c_table(const char *type, const std::string &name, const char *fields, const std::vector<T> &table) {
  if (table.empty()) return "";
  std::string text = "/* " + std::string(fields) + " */\nstatic const " + type + " " + name + "[] FC_ROM = {\n";
  for (const T &item : table) text += "  " + c_item(item) + ",\n";
  return text + "};\n\n";
}

/* One table has the plain name, several are numbered. */
std::string table_name(const std::string &name, const std::string &what, const CoreScene &core, std::size_t table) {
  return name + "_" + what + (core.triangle_tables.size() > 1 ? "_" + std::to_string(table + 1) : "");
}

template <typename T>
std::vector<T> part(const std::vector<T> &whole, std::size_t first, std::size_t count) {
  const auto from = whole.begin() + static_cast<std::ptrdiff_t>(first);
  return {from, from + static_cast<std::ptrdiff_t>(count)};
}

template <typename T>
std::string c_numbers(const std::string &type, const std::string &name, const std::vector<T> &numbers) {
  std::string text = "static const " + type + " " + name + "[] FC_ROM = {";
  for (std::size_t i = 0; i < numbers.size(); i++) text += (i % 24 == 0 ? "\n  " : "") + c_u16(numbers[i]) + ",";
  return text + "};\n";
}

/* An image's texels and record, NAME_image. */
std::string c_image(const std::string &name, const CoreLayers &layers) {
  const NarrowTexels texels = narrow_texels(layers);
  const bool palette = texels.format == NarrowTexels::Format::palette;
  std::string text = texels.format == NarrowTexels::Format::rgb565 ? c_numbers("uint16_t", name + "_texels", texels.packed)
                                                                   : c_numbers("uint8_t", name + "_texels", texels.bytes);
  const char *format = texels.format == NarrowTexels::Format::rgb565  ? "FC_TEXEL_RGB565"
                       : texels.format == NarrowTexels::Format::grey8 ? "FC_TEXEL_GREY8"
                                                                      : "FC_TEXEL_RGB888";
  if (palette) text += c_numbers("uint8_t", name + "_colours", texels.colours);
  std::string image = name + "_texels, " + c_int(layers.image.width) + ", " + c_int(layers.image.height) + ", " + format + ", " +
                      c_int(layers.image.bilinear) + ", " + c_int(layers.image.clamp);
  if (palette) image = "{" + image + "}, " + name + "_colours, " + std::to_string(texels.colours.size() / 3);
  return text + "static const " + (palette ? "fc_palette_image " : "fc_image ") + name + "_image FC_ROM = {" + image + "};\n";
}

/* Everything that a material's layers point to, and their list. */
std::string c_layers(const std::string &name, const CoreLayers &layers) {
  const auto record = [&](const char *type, const char *what, const std::string &fields) {
    return std::string("static const ") + type + " " + name + what + " FC_ROM = {" + fields + "};\n";
  };
  std::string text, list;
  for (const fc_layer &layer : layers.list) {
    std::string kind, data = "NULL";
    if (layer.kind == &fc_layer_smooth) {
      kind = "smooth";
    } else if (layer.kind == &fc_layer_phong) {
      kind = "phong";
      text += record("fc_phong", "_phong", c_rgb(layers.phong.specular) + ", " + c_uint(layers.phong.shininess_q8));
    } else if (layer.kind == &fc_layer_mirror) {
      kind = "mirror";
      text += record("fc_mirror", "_mirror", c_rgb(layers.mirror.reflectance) + ", " + c_int(layers.mirror.bounces));
    } else if (layer.kind == &fc_layer_emission) {
      kind = "emission";
      text += record("fc_emission", "_emission", c_rgb(layers.emission.light) + ", " + c_int(layers.emission.exponent));
    } else {
      kind = "texture";
      const fc_mapping &m = layers.mapping;
      const char *how = m.kind == &fc_mapping_planar ? "planar" : m.kind == &fc_mapping_spherical ? "spherical"
                                                                                                  : "vertices";
      /* clang-format off */
      text += record("fc_mapping", "_mapping", std::string("&fc_mapping_") + how + ", " + c_vec3(m.origin) + ", " + c_vec3(m.u) + ", " +
                                                   c_vec3(m.v) + ", " + c_int(m.exponent) + ", " + c_int(m.repeat_u) + ", " + c_int(m.repeat_v));
      /* clang-format on */
      std::string pattern = "checker", what = "_checker";
      if (layers.texture.pattern == &fc_texture_image) {
        text += c_image(name, layers);
        what = "_image";
        pattern = narrow_texels(layers).format == NarrowTexels::Format::palette ? "palette" : "image";
      } else {
        text += record("fc_checker", "_checker", "{" + c_rgb(layers.checker.colour[0]) + ", " + c_rgb(layers.checker.colour[1]) + "}");
      }
      /* clang-format off */
      text += record("fc_texture", "_texture", "&" + name + "_mapping, &fc_texture_" + pattern + ", &" + name + what + ", " +
                                                   c_int(layers.texture.modulate));
      /* clang-format on */
    }
    if (layer.data != nullptr) data = "&" + name + "_" + kind;
    list += "{&fc_layer_" + kind + ", " + data + "}, ";
  }
  return text + "static const fc_layer " + name + "[] FC_ROM = {" + list.substr(0, list.size() - 2) + "};\n\n";
}

std::string c_materials(const std::string &name, const CoreScene &core) {
  std::string text, table;
  for (std::size_t i = 0; i < core.materials.size(); i++) {
    const std::string layers = name + "_layers_" + std::to_string(i);
    if (core.layers[i]) text += c_layers(layers, *core.layers[i]);
    table += "  {" + c_rgb(core.materials[i].diffuse) + ", " +
             (core.layers[i] ? "FC_COUNT_OF(" + layers + "), " + layers : std::string("0, NULL")) + "},\n";
  }
  if (table.empty()) return "";
  return text + "/* diffuse, Q1.15, and layers */\nstatic const fc_material " + name + "_materials[] FC_ROM = {\n" + table + "};\n\n";
}

std::string c_vertices(const std::string &name, const std::vector<fc_vec3> &vertices, const std::optional<std::uint8_t> &shift) {
  if (!shift) return c_table("fc_vec3", name, "x, y, z", vertices);
  const std::int32_t unit = std::int32_t{1} << *shift;
  std::vector<fc_short_vec3> narrow;
  for (const fc_vec3 &v : vertices)
    narrow.push_back({static_cast<std::int16_t>(v.x / unit), static_cast<std::int16_t>(v.y / unit), static_cast<std::int16_t>(v.z / unit)});
  return c_table("fc_short_vec3", name, ("x, y, z, times 2^" + std::to_string(*shift)).c_str(), narrow);
}

std::string c_shapes(const std::string &name, const CoreScene &core) {
  if (core.shapes.empty()) return "";
  std::string text = "static const fc_shapes " + name + "_shapes[] FC_ROM = {\n";
  if (!core.spheres.empty()) text += "  FC_SPHERES(" + name + "_spheres),\n";
  if (!core.planes.empty()) text += "  FC_PLANES(" + name + "_planes),\n";
  for (std::size_t i = 0; i < core.triangle_tables.size(); i++) {
    const std::string vertices = table_name(name, "vertices", core, i), triangles = table_name(name, "triangles", core, i);
    const int cull = core.triangle_tables[i].cull;
    const std::string attributes = (core.normals.empty() ? "NULL" : table_name(name, "normals", core, i)) + ", " +
                                   (core.uvs.empty() ? "NULL" : table_name(name, "uvs", core, i));
    if (cull > 1)
      text += "  FC_TRIANGLES_CONVEX(" + vertices + ", " + attributes + ", " + triangles + ", " + std::to_string(cull - 2) + "),\n";
    else if (const std::optional<std::uint8_t> shift = short_vertex_shift(core))
      text += "  FC_TRIANGLES_SHORT(" + vertices + ", " + std::to_string(*shift) + ", " + attributes + ", " + triangles +
              (cull == 1 ? ", 1),\n" : ", 0),\n");
    else if (core.normals.empty() && core.uvs.empty())
      text += std::string(cull == 1 ? "  FC_TRIANGLES_CLOSED(" : "  FC_TRIANGLES(") + vertices + ", " + triangles + "),\n";
    else
      text += "  FC_TRIANGLES_WITH(" + vertices + ", " + attributes + ", " + triangles + (cull == 1 ? ", 1),\n" : ", 0),\n");
  }
  return text + "};\n\n";
}

std::string c_bvh(const std::string &name, const CoreScene &core) {
  if (core.bvh.empty()) return "";
  const fc_bvh &bvh = core.bvh.front();
  const std::size_t nodes = bvh.count == 0 ? 0 : (std::size_t{2} << bvh.depth) - 1;
  std::string text = c_table("fc_bvh_node", name + "_nodes", "boxes of the hierarchy in cells, low | high << 16",
                             std::vector<fc_bvh_node>(bvh.nodes, bvh.nodes + nodes));
  text += c_table("uint16_t", name + "_order", "primitives, leaf by leaf", std::vector<std::uint16_t>(bvh.order, bvh.order + bvh.count));
  text += "static const fc_bvh " + name + "_bvh FC_ROM = {\n  .kind = &fc_bvh_balanced,\n";
  if (nodes > 0) text += "  .nodes = " + name + "_nodes,\n  .order = " + name + "_order,\n";
  return text + "  .origin = " + c_vec3(bvh.origin) + ",\n  .count = " + c_u16(bvh.count) + ",\n  .shift = " + std::to_string(bvh.shift) +
         ",\n  .depth = " + std::to_string(bvh.depth) + ",\n};\n\n";
}

/* Pointer and count of a table that may be missing. */
std::string c_reference(const std::string &field, const std::string &count, const std::string &table, bool empty) {
  return "  ." + field + " = " + (empty ? "NULL" : table) + ",\n  ." + count + " = " + (empty ? "0" : "FC_COUNT_OF(" + table + ")") + ",\n";
}

/* A file name inside a comment: printable, and no trigraph. */
std::string printable(std::string text) {
  for (char &c : text)
    if (c < ' ' || c > '~' || c == '?' || c == '\\') c = '_';
  return text;
}

std::string head_comment(const SceneFacts &facts) {
  std::string text = "/*\n * Baked by fixcast " + std::string(version) + "; do not edit.\n *\n";
  for (const std::string &line : fact_lines(facts)) text += " * " + printable(line) + "\n";
  return text + " */\n";
}

} // namespace

std::string c_name_of(const std::string &path) {
  std::string name = std::filesystem::path(path).stem().string();
  for (char &c : name)
    if (!is_letter(c) && !is_digit(c)) c = '_';
  return is_c_name(name) ? name : "scene_" + name;
}

bool is_c_name(const std::string &name) {
  static const std::array<const char *, 37> keywords = {
      "auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else",
      "enum", "extern", "float", "for", "goto", "if", "inline", "int", "long", "main",
      "register", "restrict", "return", "short", "signed", "sizeof", "static", "struct", "switch", "typedef",
      "union", "unsigned", "void", "volatile", "while", "asm", "NULL"};
  if (name.empty() || !is_letter(name[0]) || name[0] == '_' || name.size() > 100) return false;
  if (!std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); })) return false;
  if (name.rfind("fc_", 0) == 0 || name.rfind("FC_", 0) == 0) return false;
  return std::find(keywords.begin(), keywords.end(), name) == keywords.end();
}

std::string bake_header(const SceneFacts &facts, const std::string &name) {
  return head_comment(facts) + "#ifndef " + name + "_SCENE_H\n#define " + name +
         "_SCENE_H\n\n#include \"fixcast/fixcast.h\"\n\nextern const fc_scene " + name + ";\nextern const fc_camera " + name +
         "_camera;\n\n#endif\n";
}

std::string bake(const CoreScene &core, const SceneFacts &facts, const std::string &name) {
  const fc_scene &scene = core.scene;
  const fc_camera &camera = core.camera;
  std::string text = head_comment(facts);
  text += "#include \"fixcast/fixcast.h\"\n\n";
  text += "extern const fc_scene " + name + ";\nextern const fc_camera " + name + "_camera;\n\n";
  text += c_table("fc_sphere", name + "_spheres", "centre, radius, material, object", core.spheres);
  text += c_table("fc_plane", name + "_planes", "normal, d, d_exponent, material, object", core.planes);
  for (std::size_t i = 0; i < core.triangle_tables.size(); i++) {
    const TriangleTable &table = core.triangle_tables[i];
    text += c_vertices(table_name(name, "vertices", core, i), part(core.vertices, table.vertex, table.vertices), short_vertex_shift(core));
    if (!core.normals.empty())
      text += c_table("fc_normal", table_name(name, "normals", core, i), "x, y, z, Q14",
                      part(core.normals, table.vertex, table.vertices));
    if (!core.uvs.empty())
      text += c_table("fc_uv", table_name(name, "uvs", core, i), "u, v, Q16", part(core.uvs, table.vertex, table.vertices));
    text += c_table("fc_triangle", table_name(name, "triangles", core, i), "vertices, material, object",
                    part(core.triangles, table.triangle, table.triangles));
  }
  text += c_materials(name, core);
  text += c_table("fc_light", name + "_lights",
                  "position, intensity, exponent, intensity_exponent, inverse_square, directional", core.lights);
  text += c_shapes(name, core);
  text += c_bvh(name, core);
  if (!core.sky.empty())
    text += "static const fc_sky " + name + "_sky FC_ROM = {&fc_sky_gradient, " + c_vec3(core.sky.front().up) + ", " +
            c_rgb(core.sky.front().top) + "};\n\n";
  text += "const fc_scene " + name + " FC_ROM = {\n";
  text += c_reference("shapes", "shape_count", name + "_shapes", core.shapes.empty());
  text += c_reference("materials", "material_count", name + "_materials", core.materials.empty());
  text += c_reference("lights", "light_count", name + "_lights", core.lights.empty());
  text += "  .exponent = " + c_int(scene.exponent) + ",\n  .far_exponent = " + c_int(scene.far_exponent) +
          ",\n  .far_limit = " + c_int(scene.far_limit) + ",\n  .ambient = " + c_rgb(scene.ambient) +
          ",\n  .background = " + c_rgb(scene.background) + ",\n" +
          (core.sky.empty() ? "" : "  .sky = &" + name + "_sky,\n") +
          (core.bvh.empty() ? "" : "  .bvh = &" + name + "_bvh,\n") + "};\n\n";
  text += "const fc_camera " + name + "_camera FC_ROM = {\n  .eye = " + c_vec3(camera.eye) +
          ",\n  .target = " + c_vec3(camera.target) + ",\n  .up = " + c_vec3(camera.up) +
          ",\n  .exponent = " + c_int(camera.exponent) +
          ",\n  .fov_rule = " + (camera.fov_rule == FC_FOV_EDGES ? "FC_FOV_EDGES" : "FC_FOV_CENTRES") +
          ",\n  .tan_half_fov_numerator = " + c_uint(camera.tan_half_fov_numerator) +
          ",\n  .tan_half_fov_denominator = " + c_uint(camera.tan_half_fov_denominator) + ",\n};\n";
  return text;
}

} // namespace host
