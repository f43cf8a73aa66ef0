/* What a scene costs on a chip. */
#include "scene_facts.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>

#include "frame_run.h"
#include "hierarchy.h"
#include "narrow.h"
#include "report.h"
#include "sha256.h"
#include "text_file.h"

namespace host {
namespace {

constexpr int strip_rows = 8;

template <typename T>
std::size_t bytes(const std::vector<T> &table) {
  return table.size() * sizeof(T);
}

std::size_t pattern_bytes(const CoreLayers &layers, const NarrowTexels &texels) {
  if (layers.texels.empty()) return sizeof(fc_checker);
  return texels.format == NarrowTexels::Format::palette ? sizeof(fc_palette_image) : sizeof(fc_image);
}

/* The lists, the layers' data and the images. */
std::size_t layer_bytes(const CoreScene &core) {
  std::size_t sum = 0;
  for (const std::unique_ptr<CoreLayers> &layers : core.layers) {
    if (!layers) continue;
    const NarrowTexels texels = narrow_texels(*layers);
    sum += bytes(layers->list) + texels.size();
    for (const fc_layer &layer : layers->list) {
      if (layer.kind == &fc_layer_phong) sum += sizeof(fc_phong);
      if (layer.kind == &fc_layer_mirror) sum += sizeof(fc_mirror);
      if (layer.kind == &fc_layer_emission) sum += sizeof(fc_emission);
      if (layer.kind == &fc_layer_texture) sum += sizeof(fc_texture) + sizeof(fc_mapping) + pattern_bytes(*layers, texels);
    }
  }
  return sum;
}

unsigned bits_of(std::int32_t v) {
  unsigned bits = 0;
  for (auto magnitude = static_cast<std::uint32_t>(std::abs(v)); magnitude != 0; magnitude >>= 1) bits++;
  return bits;
}

unsigned bits_of(const fc_vec3 &v) { return std::max({bits_of(v.x), bits_of(v.y), bits_of(v.z)}); }

/* Names of parts of the core that are linked, or entered, for this scene only because of what it holds. */
std::vector<std::string> features_of(const CoreScene &core, std::size_t closed_triangles) {
  std::vector<std::string> features;
  if (!core.spheres.empty()) features.emplace_back("spheres");
  if (!core.planes.empty()) features.emplace_back("planes");
  if (closed_triangles < core.triangles.size()) features.emplace_back("triangles");
  if (closed_triangles > 0) features.emplace_back("closed meshes");
  if (short_vertex_shift(core)) features.emplace_back("vertices of 16 bits");
  if (!core.bvh.empty()) features.emplace_back("hierarchy");
  if (core.lights.empty()) features.emplace_back("no lights");
  const bool falloff = std::any_of(core.lights.begin(), core.lights.end(), [](const fc_light &l) { return l.inverse_square != 0; });
  if (core.lights.size() == 1 && !falloff) features.emplace_back("one light, by the scan engine");
  if (core.lights.size() > 1) features.emplace_back("several lights, by a ray a pixel");
  if (falloff) features.emplace_back("inverse-square falloff, by a ray a pixel");
  const auto has = [&](const fc_layer_kind *kind, const char *name) {
    const bool used = std::any_of(core.layers.begin(), core.layers.end(), [&](const std::unique_ptr<CoreLayers> &layers) {
      return layers && std::any_of(layers->list.begin(), layers->list.end(), [&](const fc_layer &l) { return l.kind == kind; });
    });
    if (used) features.push_back(std::string(name) + ", by a ray a pixel");
  };
  has(&fc_layer_smooth, "smooth shading");
  has(&fc_layer_texture, "textures");
  has(&fc_layer_emission, "emission");
  has(&fc_layer_phong, "highlights");
  has(&fc_layer_mirror, "mirrors");
  if (!core.sky.empty()) features.emplace_back("a gradient sky");
  if (core.scene.far_limit != 0) features.emplace_back("far limit");
  return features;
}

std::string quoted(const std::string &text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c >= 0 && c < ' ' ? '?' : c;
  }
  return out + "\"";
}

} // namespace

SceneFacts scene_facts(const LoadedScene &scene) {
  const CoreScene &core = scene.core;
  const CoreFrame frame(scene.file, core, scene.options, scene.width, scene.height);
  SceneFacts facts;
  facts.source = std::filesystem::path(scene.file.path).filename().string();
  facts.hash = sha256(load_text(scene.file.path));
  facts.spheres = core.spheres.size();
  facts.planes = core.planes.size();
  facts.triangles = core.triangles.size();
  for (const TriangleTable &table : core.triangle_tables)
    if (table.cull != 0) facts.closed_triangles += table.triangles;
  facts.vertices = core.vertices.size();
  facts.materials = core.materials.size();
  facts.lights = core.lights.size();
  facts.cones = static_cast<std::size_t>(scene.file.cones);
  facts.cone_error = static_cast<double>(scene.file.cone_error);
  facts.mesh = core.mesh;
  facts.exponent = core.scene.exponent;
  for (const fc_sphere &s : core.spheres) facts.coordinate_bits = std::max({facts.coordinate_bits, bits_of(s.center), bits_of(s.radius)});
  for (const fc_vec3 &v : core.vertices) facts.coordinate_bits = std::max(facts.coordinate_bits, bits_of(v));
  facts.vertex_bytes = short_vertex_shift(core) ? sizeof(fc_short_vec3) : sizeof(fc_vec3);
  facts.table_bytes = bytes(core.spheres) + bytes(core.planes) + facts.vertex_bytes * core.vertices.size() +
                      bytes(core.triangles) + bytes(core.materials) +
                      bytes(core.lights) + bytes(core.normals) + bytes(core.uvs) + bytes(core.sky) + layer_bytes(core);
  facts.hierarchy_bytes = hierarchy_bytes(core);
  facts.frame_bytes = frame.memory_bytes();
  facts.width = scene.width;
  facts.height = scene.height;
  facts.strip_bytes = static_cast<std::size_t>(scene.width) * strip_rows * 4;
  facts.features = features_of(core, facts.closed_triangles);
  return facts;
}

std::vector<std::string> fact_lines(const SceneFacts &f) {
  std::vector<std::string> lines;
  lines.push_back("Source: " + f.source + ", SHA-256");
  lines.push_back("  " + f.hash);
  lines.push_back("Holds: " + count_text(f.spheres, "sphere") + ", " + count_text(f.planes, "plane") + ", " +
                  count_text(f.triangles, "triangle") + ", " + std::to_string(f.vertices) +
                  (f.vertices == 1 ? " vertex, " : " vertices, ") + count_text(f.materials, "material") + ", " +
                  count_text(f.lights, "light") + ".");
  if (f.cones > 0)
    lines.push_back(count_text(f.cones, "cone") + " became triangles, within " + number_text(100 * f.cone_error) +
                    " % of the larger radius.");
  if (f.triangles > 0)
    lines.push_back("Mesh: " + std::to_string(f.closed_triangles) + " triangles of closed meshes, " +
                    count_text(f.mesh.boundary_edges, "edge") + " of one triangle, " + std::to_string(f.mesh.non_manifold_edges) +
                    " of more than two, " + std::to_string(f.mesh.dropped) + " triangles without area left out.");
  lines.push_back("Coordinates: " + std::to_string(f.coordinate_bits) + " bits and a sign, of 30; a unit is 2^" +
                  std::to_string(f.exponent - 16) + " world units" +
                  (f.vertices == 0 ? "." : "; " + std::to_string(8 * f.vertex_bytes / 3) + " bits a vertex's coordinate in flash."));
  const std::size_t flash = f.table_bytes + f.hierarchy_bytes;
  std::string line = "Flash: " + std::to_string(flash) + " bytes, " + std::to_string(f.hierarchy_bytes) + " of them the hierarchy";
  if (f.triangles > 0 && f.spheres == 0) {
    /* Three decimals at most, rounded up: it is a cost. */
    const std::size_t tenths = (10 * flash + f.triangles - 1) / f.triangles;
    line += "; " + std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " bytes a triangle";
  }
  lines.push_back(line + ".");
  lines.push_back("Memory: " + std::to_string(f.frame_bytes) + " bytes a frame, and " + std::to_string(f.strip_bytes) + " for a strip of " +
                  std::to_string(strip_rows) + " rows of " + std::to_string(f.width) + " pixels (colour and depth).");
  line = "Core: ";
  for (std::size_t i = 0; i < f.features.size(); i++) line += (i > 0 ? "; " : "") + f.features[i];
  lines.push_back(line + ".");
  return lines;
}

std::string fact_json(const SceneFacts &f) {
  std::string text = "{\"source\": " + quoted(f.source) + ", \"sha256\": \"" + f.hash + "\"";
  const auto add = [&text](const char *name, std::size_t value) { text += std::string(", \"") + name + "\": " + std::to_string(value); };
  add("spheres", f.spheres);
  add("planes", f.planes);
  add("triangles", f.triangles);
  add("closed_triangles", f.closed_triangles);
  add("vertices", f.vertices);
  add("materials", f.materials);
  add("lights", f.lights);
  add("cones", f.cones);
  text += ", \"cone_error\": " + number_text(f.cone_error);
  add("dropped_triangles", f.mesh.dropped);
  add("boundary_edges", f.mesh.boundary_edges);
  add("non_manifold_edges", f.mesh.non_manifold_edges);
  add("coordinate_bits", f.coordinate_bits);
  add("vertex_bytes", f.vertex_bytes);
  text += ", \"exponent\": " + std::to_string(f.exponent);
  add("flash_bytes", f.table_bytes + f.hierarchy_bytes);
  add("hierarchy_bytes", f.hierarchy_bytes);
  add("frame_bytes", f.frame_bytes);
  add("strip_bytes", f.strip_bytes);
  text += ", \"features\": [";
  for (std::size_t i = 0; i < f.features.size(); i++) text += (i > 0 ? ", " : "") + quoted(f.features[i]);
  return text + "]}\n";
}

} // namespace host
