/* From the scene as written to the core's integers. */
#include "to_core.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <optional>
#include <tuple>

#include "closed_mesh.h"
#include "triangulate.h"

namespace host {
namespace {

using Triple = std::array<long double, 3>;

[[noreturn]] void fail(const SceneFile &file, int line, const std::string &what) {
  throw UserError(file.path + (line > 0 ? ":" + std::to_string(line) : std::string()) + ": " + what);
}

/* Smallest e for which magnitude / 2^e, rounded, still fits a coordinate. */
int finest_exponent(long double magnitude) {
  int e = 0;
  (void)std::frexp(magnitude, &e);
  e -= 30;
  if (std::round(std::ldexp(magnitude, -e)) > static_cast<long double>(FC_COORDINATE_MAX)) ++e;
  return e;
}

/* value / 2^e, rounded to nearest, halves away from zero; e comes from finest_exponent or is coarser. */
std::int32_t on_grid(long double value, int e) {
  return static_cast<std::int32_t>(std::round(std::ldexp(value, -e)));
}

fc_vec3 on_grid(const Triple &v, int e) {
  return {on_grid(v[0], e), on_grid(v[1], e), on_grid(v[2], e)};
}

long double largest(std::initializer_list<Triple> vectors) {
  long double m = 0;
  for (const Triple &v : vectors)
    for (long double c : v)
      m = std::max(m, std::fabs(c));
  return m;
}

/* The exponent, relative to a grid of 2^unit, of the finest grid in lowest..highest that holds all the
 * vectors, or nothing if none does. 0 wherever that is exact: finer would only make the tables harder to
 * read. */
std::optional<int> own_exponent(std::initializer_list<Triple> vectors, int unit, int lowest, int highest) {
  const long double m = largest(vectors);
  if (m == 0) return 0;
  const int e = std::max(finest_exponent(m) - unit, lowest);
  if (e > highest) return std::nullopt;
  if (e > 0) return e;
  for (const Triple &v : vectors)
    for (long double c : v)
      if (std::ldexp(c, -unit) != std::round(std::ldexp(c, -unit))) return e;
  return 0;
}

/* Whether the corners are on one line: differences have 31 bits, products 62. */
bool is_flat(const std::array<fc_vec3, 3> &c) {
  const std::int64_t ax = std::int64_t{c[1].x} - c[0].x, ay = std::int64_t{c[1].y} - c[0].y, az = std::int64_t{c[1].z} - c[0].z;
  const std::int64_t bx = std::int64_t{c[2].x} - c[0].x, by = std::int64_t{c[2].y} - c[0].y, bz = std::int64_t{c[2].z} - c[0].z;
  return ay * bz == az * by && az * bx == ax * bz && ax * by == ay * bx;
}

Triple values(const Vector &v) {
  return {v.x.value, v.y.value, v.z.value};
}
Triple values(const Rgb &c) {
  return {c.r.value, c.g.value, c.b.value};
}

class Converter {
public:
  explicit Converter(const SceneFile &file) : file_(file) {}

  CoreScene run() {
    choose_unit();
    material_index_.resize(2 * file_.materials.size());
    for (std::size_t i = 0; i < file_.materials.size(); i++)
      (void)material(static_cast<int>(i));
    for (const Sphere &s : file_.spheres)
      add(s);
    for (const Plane &p : file_.planes)
      add(p);
    for (const Polygon &p : file_.polygons)
      add(p);
    for (const Light &l : file_.lights)
      add(l);
    set_camera();
    count_edges();
    split_triangles();
    finish_scene();
    return std::move(out_);
  }

private:
  long double scaled(const Number &n) const {
    return n.value * static_cast<long double>(file_.scale_numerator) /
           static_cast<long double>(file_.scale_denominator);
  }
  Triple scaled(const Vector &v) const {
    return {scaled(v.x), scaled(v.y), scaled(v.z)};
  }

  /* One world coordinate is 2^unit_ world units. */
  void choose_unit() {
    long double m = 0;
    for (const Sphere &s : file_.spheres)
      m = std::max(m, largest({scaled(s.center), {scaled(s.radius), 0, 0}}));
    for (const Polygon &p : file_.polygons)
      for (const Vector &v : p.vertices)
        m = std::max(m, largest({scaled(v)}));
    if (m == 0) { /* no finite shape: what the camera and the planes span */
      m = largest({scaled(file_.camera.from), scaled(file_.camera.at)});
      for (const Plane &p : file_.planes) {
        const Triple n = values(p.normal);
        const long double length = std::hypot(std::hypot(n[0], n[1]), n[2]);
        if (length > 0) m = std::max(m, std::fabs(scaled(p.d)) / length);
      }
    }
    unit_ = m > 0 ? finest_exponent(m) : -16;
    if (unit_ + 16 < -60 || unit_ + 16 > 60)
      fail(file_, 0,
           "the scene is too large or too small; bring its largest coordinate between 1e-13 and 1e22");
    out_.scene.exponent = static_cast<std::int8_t>(unit_ + 16);
  }

  fc_rgb q15(const Triple &c, long double limit, int line, const char *what) const {
    std::array<std::uint16_t, 3> q{};
    for (std::size_t i = 0; i < 3; i++) {
      const long double v = std::round(std::ldexp(c[i], 15));
      if (!(v >= 0 && v <= limit))
        fail(file_, line, std::string(what) + " is outside 0.." + (limit > 32768 ? "1.99" : "1"));
      q[i] = static_cast<std::uint16_t>(v);
    }
    return {q[0], q[1], q[2]};
  }

  std::uint16_t add_material(const Material &m, bool smooth) {
    Triple c = values(m.colour);
    for (long double &v : c)
      v *= m.kd.value;
    const fc_rgb q = q15(c, 32768, m.line, "the material's colour times Kd");
    std::unique_ptr<CoreLayers> layers = make_layers(m, smooth);
    if (!layers) {
      const auto found = material_of_.find({q.r, q.g, q.b});
      if (found != material_of_.end()) return found->second;
    }
    if (out_.materials.size() >= 0xffff)
      fail(file_, m.line, "more than 65535 different materials; merge some");
    const auto index = static_cast<std::uint16_t>(out_.materials.size());
    if (layers)
      out_.materials.push_back({q, static_cast<std::uint16_t>(layers->list.size()), layers->list.data()});
    else
      out_.materials.push_back({q, 0, nullptr});
    if (!layers) material_of_[{q.r, q.g, q.b}] = index;
    out_.layers.push_back(std::move(layers));
    return index;
  }

  /* nullptr for a matte material. */
  std::unique_ptr<CoreLayers> make_layers(const Material &m, bool smooth) const {
    auto layers = std::make_unique<CoreLayers>();
    if (smooth) layers->list.push_back({&fc_layer_smooth, nullptr});
    if (m.texture) {
      set_texture(*m.texture, m.line, *layers);
      layers->list.push_back({&fc_layer_texture, &layers->texture});
    }
    if (m.emission) {
      Triple c = values(*m.emission);
      int e = 0;
      while (largest({c}) > 1.99L && e < 7) {
        for (long double &v : c)
          v /= 2;
        e++;
      }
      layers->emission.exponent = static_cast<std::int8_t>(e);
      layers->emission.light = q15(c, 65535, m.line, "the emission");
      layers->list.push_back({&fc_layer_emission, &layers->emission});
    }
    if (m.ks.value > 0 && m.shine.value > 0) {
      const long double exponent = std::round(m.shine.value * 256);
      if (exponent < 1 || exponent > 16777216) fail(file_, m.line, "the shine is outside 0.002..65536");
      layers->phong.specular = q15({m.ks.value, m.ks.value, m.ks.value}, 65535, m.line, "Ks");
      layers->phong.shininess_q8 = static_cast<std::uint32_t>(exponent);
      layers->list.push_back({&fc_layer_phong, &layers->phong});
    }
    if (m.mirror) {
      layers->mirror.reflectance = q15(values(m.mirror->reflectance), 32768, m.line, "the mirror's reflectance");
      layers->mirror.bounces = static_cast<std::uint8_t>(m.mirror->bounces);
      layers->list.push_back({&fc_layer_mirror, &layers->mirror});
    }
    if (layers->list.empty()) return nullptr;
    if (layers->list.size() > FC_LAYERS_MAX)
      fail(file_, m.line, "a material that is smooth, textured, emitting, shiny and a mirror; leave one out");
    return layers;
  }

  void set_texture(const Texture &t, int line, CoreLayers &layers) const {
    fc_mapping &mapping = layers.mapping;
    switch (t.mapping.kind) {
      case Mapping::Kind::planar: mapping.kind = &fc_mapping_planar; break;
      case Mapping::Kind::spherical: mapping.kind = &fc_mapping_spherical; break;
      case Mapping::Kind::vertices: mapping.kind = &fc_mapping_vertices; break;
    }
    if (t.mapping.kind == Mapping::Kind::planar) {
      const Triple origin = scaled(t.mapping.origin), u = scaled(t.mapping.u), v = scaled(t.mapping.v);
      const std::optional<int> exponent = own_exponent({origin, u, v}, unit_, -31, 32);
      if (!exponent) fail(file_, line, "the texture's origin or axes are too large for the size of the scene");
      mapping.exponent = static_cast<std::int8_t>(*exponent);
      mapping.origin = on_grid(origin, unit_ + *exponent);
      mapping.u = on_grid(u, unit_ + *exponent);
      mapping.v = on_grid(v, unit_ + *exponent);
    }
    mapping.repeat_u = static_cast<std::uint8_t>(t.mapping.repeat_u);
    mapping.repeat_v = static_cast<std::uint8_t>(t.mapping.repeat_v);
    layers.texture.mapping = &layers.mapping;
    layers.texture.modulate = t.modulate;
    if (t.texels) {
      layers.texels = *t.texels;
      layers.image = {layers.texels.data(), static_cast<std::uint16_t>(t.width), static_cast<std::uint16_t>(t.height),
                      FC_TEXEL_RGB888, t.bilinear, t.clamp};
      layers.texture.pattern = &fc_texture_image;
      layers.texture.pattern_data = &layers.image;
    } else {
      for (std::size_t i = 0; i < 2; i++)
        layers.checker.colour[i] = q15(values(t.checker[i]), 32768, line, "the checker's colour");
      layers.texture.pattern = &fc_texture_checker;
      layers.texture.pattern_data = &layers.checker;
    }
  }

  /* A material, and the one for the polygons that are shaded smoothly. Made when first used, in the order of use. */
  std::uint16_t material(int index, bool smooth = false) {
    std::optional<std::uint16_t> &known = material_index_.at(2 * static_cast<std::size_t>(index) + smooth);
    if (!known) known = add_material(file_.materials.at(static_cast<std::size_t>(index)), smooth);
    return *known;
  }

  void reserve_primitives(std::size_t more, int line) {
    primitives_ += more;
    if (primitives_ > FC_PRIMITIVES_MAX)
      fail(file_, line, "this makes more than 65535 primitives; simplify the scene or split it");
  }

  void add(const Sphere &s) {
    reserve_primitives(1, s.line);
    /* A radius below half a unit would vanish, which the core refuses: the smallest sphere stands for it. */
    const std::int32_t radius = std::max<std::int32_t>(1, on_grid(scaled(s.radius), unit_));
    out_.spheres.push_back({on_grid(scaled(s.center), unit_), radius, material(s.material), s.object});
  }

  /* A normal may have any length, so it takes the power of two that leaves d most bits: 30 bits for the
   * normal, fewer only if d would need an exponent beyond 32. */
  void add(const Plane &p) {
    reserve_primitives(1, p.line);
    const Triple n = values(p.normal);
    const long double d = scaled(p.d);
    if (largest({n}) == 0) fail(file_, p.line, "the plane's normal is zero");
    int e = finest_exponent(largest({n}));
    int d_exponent = d == 0 ? 0 : std::max(0, finest_exponent(std::fabs(d)) - e - unit_);
    if (d_exponent > 32) {
      const int lost = d_exponent - 32;
      e += lost;
      d_exponent = 32;
      bool exact = true;
      for (long double c : n)
        exact = exact && std::ldexp(c, -e) == std::round(std::ldexp(c, -e));
      if (!exact && lost > 6) fail(file_, p.line, "the plane is too far away for the size of the scene");
    }
    fc_vec3 q = on_grid(n, e);
    std::int32_t q_d = on_grid(d, e + unit_ + d_exponent);
    while (q.x % 2 == 0 && q.y % 2 == 0 && q.z % 2 == 0 && (d_exponent > 0 || q_d % 2 == 0)) {
      q = {q.x / 2, q.y / 2, q.z / 2};
      if (d_exponent > 0)
        d_exponent--;
      else
        q_d /= 2;
    }
    if (q_d == 0) d_exponent = 0;
    out_.planes.push_back({q, q_d, static_cast<std::int8_t>(d_exponent), material(p.material), p.object});
  }

  /* Q14 of a unit vector; zero for a zero one. */
  static fc_normal unit_q14(const Triple &n) {
    const long double length = std::hypot(std::hypot(n[0], n[1]), n[2]);
    const auto q = [&](long double v) { return static_cast<std::int16_t>(length > 0 ? std::round(v / length * 16384) : 0); };
    return {q(n[0]), q(n[1]), q(n[2])};
  }

  static fc_uv uv_q16(const std::array<Number, 2> &uv) {
    const auto q = [](const Number &n) {
      return static_cast<std::int32_t>(std::round(std::min(std::max(n.value, -16384.0L), 16384.0L) * 65536));
    };
    return {q(uv[0]), q(uv[1])};
  }

  /* A polygon's corner, which stands at q on the grid. */
  std::uint16_t vertex(const Polygon &p, std::size_t i, const fc_vec3 &q) {
    const int line = p.line;
    const fc_normal n = p.normals.empty() ? fc_normal{} : unit_q14(values(p.normals.at(i)));
    const fc_uv t = p.uvs.empty() ? fc_uv{} : uv_q16(p.uvs.at(i));
    const std::array<std::int32_t, 8> key = {q.x, q.y, q.z, n.x, n.y, n.z, t.u, t.v};
    const auto found = vertex_of_.find(key);
    if (found != vertex_of_.end()) return found->second;
    if (out_.vertices.size() >= 0xffff)
      fail(file_, line, "this makes more than 65535 vertices; simplify the mesh or split the scene");
    const auto index = static_cast<std::uint16_t>(out_.vertices.size());
    out_.vertices.push_back(q);
    out_.normals.push_back(n);
    out_.uvs.push_back(t);
    vertex_of_[key] = index;
    return index;
  }

  void add(const Polygon &p) {
    if (p.vertices.size() > FC_PRIMITIVES_MAX) reserve_primitives(p.vertices.size(), p.line);
    const std::vector<std::array<int, 3>> triangles = triangulate(p);
    for (const std::array<int, 3> &t : triangles) {
      std::array<fc_vec3, 3> corners{};
      for (std::size_t i = 0; i < 3; i++)
        corners[i] = on_grid(scaled(p.vertices.at(static_cast<std::size_t>(t[i]))), unit_);
      if (is_flat(corners)) {
        out_.mesh.dropped++;
        continue;
      }
      reserve_primitives(1, p.line);
      fc_triangle triangle{};
      for (std::size_t i = 0; i < 3; i++)
        triangle.vertex[i] = vertex(p, static_cast<std::size_t>(t[i]), corners[i]);
      triangle.material = material(p.material, !p.normals.empty());
      triangle.object = p.object;
      out_.triangles.push_back(triangle);
    }
  }

  void add(const Light &l) {
    if (out_.lights.size() >= 0xffff) fail(file_, l.line, "more than 65535 lights; remove some");
    fc_light light{};
    if (l.directional) {
      const Triple towards = values(l.position);
      light.directional = 1;
      light.position = on_grid(towards, finest_exponent(largest({towards})));
    } else {
      const Triple position = scaled(l.position);
      const std::optional<int> exponent = own_exponent({position}, unit_, -31, 32);
      if (!exponent)
        fail(file_, l.line, "the light is too far away for the size of the scene; bring it nearer");
      light.exponent = static_cast<std::int8_t>(*exponent);
      light.position = on_grid(position, unit_ + *exponent);
    }

    const long double n = static_cast<long double>(file_.lights.size());
    Triple c = l.colour ? values(*l.colour) : Triple{1 / std::sqrt(n), 1 / std::sqrt(n), 1 / std::sqrt(n)};
    if (file_.falloff == Falloff::inverse_square && !l.directional) {
      light.inverse_square = 1;
      const long double scale =
          static_cast<long double>(file_.scale_numerator) / static_cast<long double>(file_.scale_denominator);
      for (long double &v : c)
        v *= scale * scale;
    }
    /* The largest channel gets all 16 bits: 1.0 to 1.99 times a power of two. */
    int e = 0;
    const long double m = largest({c});
    if (m > 0) {
      (void)std::frexp(m, &e);
      e -= 1;
      if (std::round(std::ldexp(m, 15 - e)) > 65535) e++;
      e = std::max(e, -40);
      if (e > 40) fail(file_, l.line, "the light is brighter than 2^41");
      for (long double &v : c)
        v = std::ldexp(v, -e);
    }
    light.intensity = q15(c, 65535, l.line, "the light's colour");
    light.intensity_exponent = static_cast<std::int8_t>(e);
    out_.lights.push_back(light);
  }

  /* Of an object's triangles; equal vertices are one here. */
  void count_edges() {
    std::map<std::tuple<std::uint16_t, std::uint16_t, std::uint16_t>, int> edges;
    for (const fc_triangle &t : out_.triangles)
      for (std::size_t i = 0; i < 3; i++) {
        const std::uint16_t a = t.vertex[i], b = t.vertex[(i + 1) % 3];
        edges[{t.object, std::min(a, b), std::max(a, b)}]++;
      }
    for (const auto &[edge, uses] : edges) {
      if (uses == 1) out_.mesh.boundary_edges++;
      if (uses > 2) out_.mesh.non_manifold_edges++;
    }
  }

  /* Runs of closed meshes and of everything else, in the author's order, each with vertices of its own; where there is light, a convex
   * mesh is a run of its own. A table costs the core some memory, so a scene that alternates often has fewer. */
  void split_triangles() {
    constexpr std::size_t most = 16;
    const std::size_t count = out_.triangles.size();
    const fc_camera &camera = out_.camera;
    const std::array<long double, 3> eye = {std::ldexp(static_cast<long double>(camera.eye.x), camera.exponent),
                                            std::ldexp(static_cast<long double>(camera.eye.y), camera.exponent),
                                            std::ldexp(static_cast<long double>(camera.eye.z), camera.exponent)};
    std::vector<std::uint8_t> cull = cull_values(out_.vertices, out_.triangles, eye);
    const auto begins_run = [&](std::size_t i) {
      return i == 0 || cull[i] != cull[i - 1] || (cull[i] > 1 && out_.triangles[i].object != out_.triangles[i - 1].object);
    };
    const auto too_many_runs = [&] {
      std::size_t runs = 0;
      for (std::size_t i = 0; i < count; i++)
        runs += begins_run(i);
      return runs > most;
    };
    if (file_.lights.empty() || too_many_runs())
      for (std::uint8_t &value : cull)
        value = std::min<std::uint8_t>(value, 1);
    if (too_many_runs()) cull.assign(count, 0);
    std::vector<fc_vec3> vertices;
    std::vector<fc_normal> normals;
    std::vector<fc_uv> uvs;
    std::map<std::uint16_t, std::uint16_t> renamed;
    for (std::size_t i = 0; i < count; i++) {
      if (begins_run(i)) {
        out_.triangle_tables.push_back({i, 0, vertices.size(), 0, cull[i]});
        renamed.clear();
      }
      TriangleTable &table = out_.triangle_tables.back();
      table.triangles++;
      for (std::uint16_t &v : out_.triangles[i].vertex) {
        const auto [found, is_new] = renamed.insert({v, static_cast<std::uint16_t>(table.vertices)});
        if (is_new) {
          vertices.push_back(out_.vertices[v]);
          normals.push_back(out_.normals[v]);
          uvs.push_back(out_.uvs[v]);
          table.vertices++;
        }
        v = found->second;
      }
    }
    out_.vertices = std::move(vertices);
    const auto any = [&](auto has) { return std::any_of(file_.polygons.begin(), file_.polygons.end(), has); };
    out_.normals = any([](const Polygon &p) { return !p.normals.empty(); }) ? std::move(normals) : std::vector<fc_normal>{};
    out_.uvs = any([](const Polygon &p) { return !p.uvs.empty(); }) ? std::move(uvs) : std::vector<fc_uv>{};
  }

  template <typename T>
  void add_table(const fc_kind *kind, const std::vector<T> &table) {
    if (table.empty()) return;
    out_.shapes.push_back({kind, table.data(), nullptr, static_cast<std::uint16_t>(table.size()), 0, nullptr, nullptr, 0});
  }

  void finish_scene() {
    add_table(&fc_kind_sphere, out_.spheres);
    add_table(&fc_kind_plane, out_.planes);
    for (const TriangleTable &table : out_.triangle_tables)
      out_.shapes.push_back({table.cull > 1 ? &fc_kind_convex : &fc_kind_triangle, out_.triangles.data() + table.triangle,
                             out_.vertices.data() + table.vertex,
                             static_cast<std::uint16_t>(table.triangles), static_cast<std::uint16_t>(table.vertices),
                             out_.normals.empty() ? nullptr : out_.normals.data() + table.vertex,
                             out_.uvs.empty() ? nullptr : out_.uvs.data() + table.vertex,
                             table.cull});
    fc_scene &scene = out_.scene;
    scene.shapes = out_.shapes.data();
    scene.shape_count = static_cast<std::uint16_t>(out_.shapes.size());
    scene.materials = out_.materials.data();
    scene.material_count = static_cast<std::uint16_t>(out_.materials.size());
    scene.lights = out_.lights.data();
    scene.light_count = static_cast<std::uint16_t>(out_.lights.size());
    scene.ambient = q15(values(file_.ambient), 65535, 0, "the ambient light");
    scene.background = q15(values(file_.background), 65535, 0, "the background colour");
    if (file_.gradient) {
      const Triple up = values(file_.gradient->up);
      if (largest({up}) == 0) fail(file_, file_.gradient->line, "the gradient's up is 0 0 0; give it a direction");
      out_.sky.push_back({&fc_sky_gradient, on_grid(up, finest_exponent(largest({up}))),
                          q15(values(file_.gradient->top), 32768, file_.gradient->line, "the gradient's colour")});
      scene.sky = out_.sky.data();
    }
    if (file_.far) {
      const long double limit = scaled(*file_.far);
      const std::optional<int> exponent = own_exponent({{limit, 0, 0}}, unit_, -31, 32);
      if (!exponent) fail(file_, 0, "the far limit is too large for the size of the scene; leave it out");
      scene.far_exponent = static_cast<std::int8_t>(*exponent);
      scene.far_limit =
          std::max<std::int32_t>(1, on_grid(limit, unit_ + *exponent)); /* 0 would mean: no limit */
    }
  }

  void set_camera() {
    const Camera &from = file_.camera;
    fc_camera &camera = out_.camera;
    const Triple eye = scaled(from.from), target = scaled(from.at), up = values(from.up);
    const std::optional<int> exponent = own_exponent({eye, target}, unit_, -31, 31);
    if (!exponent) fail(file_, from.line, "the camera is too far away for the size of the scene");
    camera.exponent = static_cast<std::int8_t>(*exponent);
    camera.eye = on_grid(eye, unit_ + *exponent);
    camera.target = on_grid(target, unit_ + *exponent);
    if (largest({up}) > 0) camera.up = on_grid(up, finest_exponent(largest({up})));
    camera.fov_rule = from.tan_half_fov ? FC_FOV_EDGES : FC_FOV_CENTRES;
    const long double pi = 3.14159265358979323846264338327950288L;
    set_tangent(from.tan_half_fov ? from.tan_half_fov->value : std::tan(from.angle_degrees.value * pi / 360));
  }

  /* The last continued-fraction convergent whose terms fit 32 bits: exact for 1/2 and 0.466, otherwise nearer
   * than a power of two as denominator comes. Euclid's algorithm on long doubles is exact, since fmod is. */
  void set_tangent(long double tangent) {
    if (!(tangent >= std::ldexp(1.0L, -16) && tangent <= std::ldexp(1.0L, 16)))
      fail(file_, file_.camera.line,
           "the field of view is outside its range (tangent of half of it 2^-16 to 2^16)");
    const long double limit = 4294967295.0L;
    long double a = tangent, b = 1, p0 = 0, q0 = 1, p1 = 1, q1 = 0;
    while (b > 0) {
      const long double rest = std::fmod(a, b);
      const long double term = std::round((a - rest) / b);
      const long double p = term * p1 + p0, q = term * q1 + q0;
      if (!(p <= limit && q <= limit)) break;
      p0 = p1, q0 = q1, p1 = p, q1 = q;
      a = b;
      b = rest;
    }
    out_.camera.tan_half_fov_numerator = static_cast<std::uint32_t>(p1);
    out_.camera.tan_half_fov_denominator = static_cast<std::uint32_t>(q1);
  }

  const SceneFile &file_;
  CoreScene out_;
  int unit_ = 0;
  std::size_t primitives_ = 0;
  std::vector<std::optional<std::uint16_t>> material_index_; /* of a SceneFile material in out_.materials: flat, smooth */
  std::map<std::tuple<std::uint16_t, std::uint16_t, std::uint16_t>, std::uint16_t> material_of_;
  std::map<std::array<std::int32_t, 8>, std::uint16_t> vertex_of_; /* position, normal, uv */
};

} // namespace

CoreScene to_core(const SceneFile &file) {
  return Converter(file).run();
}

long double world_unit(const fc_scene &scene) {
  return std::ldexp(1.0L, scene.exponent - 16);
}

fc_options to_options(const std::string &offset, const fc_scene &scene) {
  fc_options options{};
  if (offset == "exact") {
    options.offset_rule = FC_OFFSET_EXACT;
  } else if (offset == "residual") {
    options.offset_rule = FC_OFFSET_RESIDUAL;
  } else if (offset == "none") {
    options.offset_rule = FC_OFFSET_NONE;
  } else if (offset.rfind("epsilon=", 0) == 0) {
    options.offset_rule = FC_OFFSET_EPSILON;
    const char *text = offset.c_str() + 8;
    char *end = nullptr;
    const long double epsilon = std::strtold(text, &end);
    if (end == text || *end != '\0' || !(epsilon >= 0) || !std::isfinite(epsilon))
      throw UserError("--offset epsilon=N takes a distance in world units, 0 or more, such as 0.001");
    const int unit = scene.exponent - 16;
    const std::optional<int> exponent = own_exponent({{epsilon, 0, 0}}, unit, -31, 0);
    if (!exponent) throw UserError("--offset " + offset + " is larger than the scene");
    options.epsilon_exponent = static_cast<std::int8_t>(*exponent);
    options.epsilon = on_grid(epsilon, unit + *exponent);
  } else {
    throw UserError("--offset takes exact, residual, none or epsilon=N, not \"" + offset + "\"");
  }
  return options;
}

} // namespace host
