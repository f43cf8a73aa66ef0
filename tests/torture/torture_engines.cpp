/* The scan engine against the ray engine on small random scenes: the same primitives, lights and depth codes,
 * colours within one level, the same bits in any strips (37). */
#include <algorithm>
#include <cmath>
#include <cstring>

#include "trial.h"

extern "C" {
#include "view.h"
}

namespace {

constexpr int formats = 3;
constexpr int bytes_of[formats] = {3, 2, 2};

/* Everything of a frame, by one engine. */
struct Picture {
  std::vector<uint8_t> pixels;
  std::vector<uint16_t> depth, primitive;
  std::vector<uint32_t> lit;
};

/* A scene in world coordinates, mostly as camera space will hold it: the eye is the origin and looks along +z, so
 * that tangents, touching surfaces and lights on surfaces stay exact. */
class World {
public:
  explicit World(Random &random) : random_(random) {
    bits_ = static_cast<int>(random.within(4, 27));
    set_camera();
    const int64_t kinds = random.within(1, 7); /* a bit a kind */
    const int64_t most = random.within(1, 6);
    for (int64_t i = random.within(1, most); i > 0; i--) {
      switch (random.within(0, 2)) {
        case 0:
          if (kinds & 1) add_sphere();
          break;
        case 1:
          if (kinds & 2) add_plane();
          break;
        default:
          if (kinds & 4) add_triangle();
      }
    }
    if (spheres_.empty() && planes_.empty() && triangles_.empty()) add_sphere();
    for (int64_t i = random.within(0, 9) < 7 ? 1 : random.within(0, 3); i > 0; i--) add_light();
    add_materials();
    add_corners();
    for (fc_shapes shapes : {fc_shapes{&fc_kind_sphere, spheres_.data(), nullptr, size(spheres_), 0, nullptr, nullptr, 0, 0},
                             fc_shapes{&fc_kind_plane, planes_.data(), nullptr, size(planes_), 0, nullptr, nullptr, 0, 0},
                             fc_shapes{&fc_kind_triangle, triangles_.data(), vertices_.data(), size(triangles_), size(vertices_),
                                       normals_.empty() ? nullptr : normals_.data(), uvs_.empty() ? nullptr : uvs_.data(), 0, 0}})
      tables_.insert(tables_.begin() + random.within(0, static_cast<int64_t>(tables_.size())), shapes);
    std::memset(&scene, 0, sizeof scene);
    scene.shapes = tables_.data();
    scene.shape_count = size(tables_);
    scene.materials = materials_;
    scene.material_count = 2;
    scene.lights = lights_.data();
    scene.light_count = size(lights_);
    scene.ambient = any_rgb(random.flip() ? 4000 : 40000);
    scene.background = any_rgb(65535);
    if (random.within(0, 3) == 0) {
      /* mostly such that it cuts something */
      scene.far_limit = static_cast<int32_t>(
          std::clamp<int64_t>(coordinate(bits_) + random.within(0, INT64_C(1) << bits_), 1, coordinate_max));
      if (random.within(0, 3) == 0) scene.far_exponent = static_cast<int8_t>(random.within(-8, 8));
    }
  }
  World(const World &) = delete;
  World &operator=(const World &) = delete;

  std::string text() const;

  fc_scene scene;
  fc_camera camera;
  fc_options options;
  uint16_t width, height;

private:
  template <typename T>
  static uint16_t size(const std::vector<T> &list) {
    return static_cast<uint16_t>(list.size());
  }

  fc_rgb any_rgb(int64_t most) {
    fc_rgb c;
    c.r = static_cast<uint16_t>(random_.within(0, most));
    c.g = static_cast<uint16_t>(random_.within(0, most));
    c.b = static_cast<uint16_t>(random_.within(0, most));
    return c;
  }

  int64_t coordinate(int bits) { return random_.within(-(INT64_C(1) << bits), INT64_C(1) << bits); }

  static int32_t kept(int64_t v) {
    return static_cast<int32_t>(std::clamp<int64_t>(v, -coordinate_max, coordinate_max));
  }

  void set_camera() {
    std::memset(&camera, 0, sizeof camera);
    std::memset(&options, 0, sizeof options);
    camera.target.z = 1;
    camera.up.y = 1;
    if (random_.within(0, 3) == 0) { /* any other */
      camera.eye = to_core(random_.vec(std::min(bits_, 20)));
      camera.target = to_core(from_core(camera.eye) + random_.direction(8));
      do
        camera.up = to_core(random_.direction(8));
      while (is_zero(cross(from_core(camera.target) - from_core(camera.eye), from_core(camera.up))));
      if (random_.within(0, 3) == 0) camera.exponent = static_cast<int8_t>(random_.within(-6, 3));
    }
    camera.fov_rule = random_.flip() ? FC_FOV_EDGES : FC_FOV_CENTRES;
    camera.tan_half_fov_numerator = 1;
    camera.tan_half_fov_denominator = 2;
    switch (random_.within(0, 3)) {
      case 0: /* wide or narrow */
        camera.tan_half_fov_numerator = static_cast<uint32_t>(random_.within(1, 60));
        camera.tan_half_fov_denominator = static_cast<uint32_t>(random_.within(1, 60));
        break;
      case 1: /* very */
        camera.tan_half_fov_numerator = UINT32_C(1) << random_.within(0, 12);
        camera.tan_half_fov_denominator = UINT32_C(1) << random_.within(0, 12);
        break;
      default: break;
    }
    options.offset_rule = static_cast<uint8_t>(random_.within(0, 3) ? 0 : random_.within(0, 3));
    options.depth_exponent_bits = static_cast<uint8_t>(random_.flip() ? 0 : random_.within(2, 4));
    options.profile = random_.within(0, 7) ? FC_PROFILE_EXACT : FC_PROFILE_HALF; /* its samples are a frame too */
    options.epsilon = static_cast<int32_t>(random_.within(0, 100));
    width = static_cast<uint16_t>(random_.within(1, 24));
    height = static_cast<uint16_t>(random_.within(1, 24));
    switch (random_.within(0, 15)) {
      case 0: width = static_cast<uint16_t>(random_.within(25, 300)); break;
      case 1: height = static_cast<uint16_t>(random_.within(25, 100)); break;
      case 2:
        width = static_cast<uint16_t>(random_.within(2000, FC_SIZE_MAX));
        height = static_cast<uint16_t>(random_.within(1, 3));
        break;
      default: break;
    }
    if (width > 25) height = static_cast<uint16_t>(std::min<int>(height, 8));
  }

  /* A point that a pixel near the middle might see: in front, at any distance. */
  Vec ahead() {
    const int64_t z = random_.within(1, INT64_C(1) << bits_);
    const int64_t tan = std::max<int64_t>(
        1, 2 * z * static_cast<int64_t>(camera.tan_half_fov_numerator) / static_cast<int64_t>(camera.tan_half_fov_denominator));
    Vec v = {random_.within(-tan, tan), random_.within(-tan, tan), z};
    for (int i = 0; i < 3; i++) v[i] = kept(v[i]);
    return v;
  }

  Vec anywhere() {
    if (random_.within(0, 3)) return ahead();
    return {coordinate(bits_), coordinate(bits_), coordinate(bits_)};
  }

  /* A point on something that is there already. */
  bool on_something(Vec *v) {
    if (!spheres_.empty() && random_.flip()) {
      const fc_sphere &s = spheres_[static_cast<size_t>(random_.next() % spheres_.size())];
      *v = from_core(s.center);
      switch (random_.within(0, 2)) {
        case 0: (*v)[static_cast<int>(random_.within(0, 2))] += random_.flip() ? s.radius : -s.radius; break;
        case 1: /* a 2 3 6 / 7 step, a sphere's exact point where 7 divides its radius */
          *v = *v + Vec{2, 3, 6} * (random_.flip() ? s.radius / 7 : -(s.radius / 7));
          break;
        default: break; /* its center */
      }
      return fits(*v);
    }
    if (!planes_.empty() && random_.flip()) {
      const fc_plane &p = planes_[static_cast<size_t>(random_.next() % planes_.size())];
      *v = anywhere();
      for (int i = 0; i < 3; i++) {
        const int64_t n = from_core(p.normal)[i];
        if (std::llabs(n) != 1) continue;
        __int128 rest = static_cast<__int128>(p.d) * (INT64_C(1) << p.d_exponent);
        for (int j = 0; j < 3; j++)
          if (j != i) rest += static_cast<__int128>(from_core(p.normal)[j]) * (*v)[j];
        if (rest > coordinate_max || rest < -coordinate_max) return false;
        (*v)[i] = static_cast<int64_t>(n > 0 ? -rest : rest);
        return true;
      }
      return false;
    }
    if (!vertices_.empty()) {
      *v = from_core(vertices_[static_cast<size_t>(random_.next() % vertices_.size())]);
      return true;
    }
    return false;
  }

  void add_sphere() {
    fc_sphere s = {};
    Vec c = anywhere(), other;
    int64_t r = random_.within(1, INT64_C(1) << random_.within(0, bits_));
    switch (random_.within(0, 9)) {
      case 0: /* touches a point, of another surface perhaps */
        if (on_something(&other)) {
          const int axis = static_cast<int>(random_.within(0, 2));
          c = other;
          c[axis] += random_.flip() ? r : -r;
          if (random_.within(0, 3) == 0) c[axis] += random_.within(-1, 1);
        }
        break;
      case 1: /* the eye in it, on it, next to it */
        c = {0, 0, 0};
        c[static_cast<int>(random_.within(0, 2))] = random_.flip() ? r : -r;
        c = c + random_.vec(2);
        break;
      case 2: /* crosses the eye's plane or touches it */
        c.z = r + random_.within(-2, 2);
        break;
      case 3: /* huge, close to the eye */
        r = random_.within(1, coordinate_max / 2);
        c = {random_.any_size(bits_), random_.any_size(bits_), r + random_.within(1, INT64_C(1) << bits_)};
        break;
      case 4: /* again, grown a little or moved */
        if (!spheres_.empty()) {
          c = from_core(spheres_.back().center) + random_.vec(2);
          r = spheres_.back().radius + random_.within(-1, 1);
        }
        break;
      case 5: /* fills the picture from afar */
        r = c.z / random_.within(2, 5) + 1;
        break;
      default: break;
    }
    for (int i = 0; i < 3; i++) c[i] = kept(c[i]);
    s.center = to_core(c);
    s.radius = static_cast<int32_t>(std::clamp<int64_t>(r, 1, coordinate_max));
    s.material = static_cast<uint16_t>(random_.within(0, 1));
    s.object = 1;
    spheres_.push_back(s);
  }

  void add_plane() {
    fc_plane p = {};
    Vec n = random_.direction(static_cast<int>(random_.within(1, 8))), at;
    if (random_.flip()) n = random_.unit_step();
    if (random_.within(0, 7) == 0) n = random_.direction(29);
    p.d = kept(coordinate(bits_));
    if (on_something(&at) && random_.within(0, 2) == 0) {
      __int128 d = 0;
      for (int i = 0; i < 3; i++) d -= static_cast<__int128>(n[i]) * at[i];
      if (d <= coordinate_max && d >= -coordinate_max) p.d = kept(static_cast<int64_t>(d) + random_.within(-1, 1) * (random_.within(0, 3) == 0));
    }
    if (random_.within(0, 15) == 0) p.d_exponent = static_cast<int8_t>(random_.within(0, 8));
    if (random_.within(0, 15) == 0) p.d = 0;
    if (!planes_.empty() && random_.within(0, 7) == 0) { /* the same once more, perhaps from the other side */
      const int64_t sign = random_.flip() ? 1 : -1;
      n = from_core(planes_.back().normal) * sign;
      p.d = static_cast<int32_t>(planes_.back().d * sign);
      p.d_exponent = planes_.back().d_exponent;
    }
    p.normal = to_core(n);
    p.material = static_cast<uint16_t>(random_.within(0, 1));
    p.object = 2;
    planes_.push_back(p);
  }

  void add_triangle() {
    fc_triangle t = {};
    const auto first = static_cast<uint16_t>(vertices_.size());
    Vec a = anywhere(), b = anywhere(), c = anywhere(), at;
    if (random_.flip()) { /* small */
      b = a + random_.vec(std::max(1, bits_ - 2));
      c = a + random_.vec(std::max(1, bits_ - 2));
    }
    if (random_.within(0, 3) == 0) { /* in an axis plane, perhaps one that another surface touches */
      const int axis = static_cast<int>(random_.within(0, 2));
      if (on_something(&at)) a[axis] = at[axis];
      b[axis] = c[axis] = a[axis];
    }
    for (int i = 0; i < 3; i++) {
      a[i] = kept(a[i]);
      b[i] = kept(b[i]);
      c[i] = kept(c[i]);
    }
    vertices_.push_back(to_core(a));
    vertices_.push_back(to_core(b));
    vertices_.push_back(to_core(c));
    for (uint16_t i = 0; i < 3; i++)
      t.vertex[i] = static_cast<uint16_t>(random_.within(0, 3) == 0 ? random_.within(0, first + 2) : first + i);
    t.material = static_cast<uint16_t>(random_.within(0, 1));
    t.object = 3;
    triangles_.push_back(t);
    if (random_.within(0, 7) == 0) triangles_.push_back(t); /* twice */
  }

  void add_light() {
    Vec at = anywhere(), on;
    int exponent = 0;
    if (random_.within(0, 3) == 0 && on_something(&on)) at = on + (random_.flip() ? Vec{0, 0, 0} : random_.vec(3));
    switch (random_.within(0, 11)) {
      case 0: exponent = static_cast<int>(random_.within(-4, 12)); break;
      case 1: at = {0, 0, 0}; break;
      case 2: at = Vec{random_.any_size(28), random_.any_size(28), random_.any_size(28)}; break;
      case 3: at = random_.vec(bits_); break;
      default: break;
    }
    for (int i = 0; i < 3; i++) at[i] = kept(at[i]);
    fc_light light = light_at(at, exponent);
    light.intensity = any_rgb(random_.flip() ? 40000 : 65535);
    light.inverse_square = random_.within(0, 7) == 0;
    if (random_.within(0, 3) == 0) light.intensity_exponent = static_cast<int8_t>(random_.within(-16, 16));
    lights_.push_back(light);
  }

  void add_materials() {
    for (fc_material &material : materials_) {
      material.diffuse = any_rgb(random_.flip() ? 32768 : 65535);
      material.layer_count = 0;
      material.layers = nullptr;
    }
    /* half of the time the second has a layer: a highlight, from broad to sharper than the fast forms take, smooth normals, an image, a mirror */
    phong_.specular = any_rgb(random_.flip() ? 20000 : 65535);
    phong_.shininess_q8 = static_cast<uint32_t>(random_.within(128, 512)) << random_.within(0, 9);
    mirror_.reflectance = random_.flip() ? fc_rgb FC_WHITE : any_rgb(32768);
    mirror_.bounces = static_cast<uint8_t>(random_.within(1, 3));
    layer_ = {nullptr, nullptr};
    switch (random_.within(0, 7)) {
      case 0: layer_ = {&fc_layer_phong, &phong_}; break;
      case 1: layer_ = {&fc_layer_smooth, nullptr}; break;
      case 2: layer_ = {&fc_layer_texture, &texture_}; break;
      case 3:
        layer_ = {&fc_layer_mirror, &mirror_};
        materials_[1].diffuse = {0, 0, 0};
        break;
      default: return;
    }
    materials_[1].layers = &layer_;
    materials_[1].layer_count = 1;
  }

  /* Normals and texture coordinates of the vertices, and what lies over a surface by them or by its place. */
  void add_corners() {
    texels_.resize(3 * 8 * 5);
    for (uint8_t &texel : texels_) texel = static_cast<uint8_t>(random_.within(0, 255));
    image_ = {texels_.data(), 8, 5, FC_TEXEL_RGB888, 1, static_cast<uint8_t>(random_.flip())};
    store_texels();
    mapping_ = {random_.flip() ? &fc_mapping_vertices : &fc_mapping_planar, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 1, 2};
    mapping_.origin = to_core(random_.vec(bits_));
    mapping_.u = to_core(random_.vec(bits_));
    mapping_.v = to_core(random_.vec(bits_));
    mapping_.u.x |= 1;
    mapping_.v.y |= 1;
    texture_ = {&mapping_, &fc_texture_image, &image_, static_cast<uint8_t>(random_.flip())};
    if (palette_.colours != nullptr) {
      texture_.pattern = &fc_texture_palette;
      texture_.pattern_data = &palette_;
    }
    const bool wild = random_.within(0, 3) == 0; /* or those of a triangle lie close together */
    Vec about = random_.direction(13);
    for (size_t i = 0; i < vertices_.size(); i++) {
      if (wild || i % 3 == 0) about = random_.direction(13);
      const Vec n = wild ? about : about + random_.vec(11);
      normals_.push_back({static_cast<int16_t>(n.x), static_cast<int16_t>(n.y), static_cast<int16_t>(n.z)});
      uvs_.push_back({static_cast<int32_t>(random_.within(-200000, 200000)), static_cast<int32_t>(random_.within(-200000, 200000))});
    }
  }

  /* How the image is stored, and whether masks tile it. By what the texels are, so that the numbers of old trials stay the same. */
  void store_texels() {
    if (texels_[1] & 1) image_.height = 4;
    switch (texels_[0] & 3) {
      case 0: break;
      case 1: /* with areas of one colour, or without */
        for (const uint8_t texel : texels_) indices_.push_back(static_cast<uint8_t>(texels_[1] & 2 ? texel >> 7 : texel % 40));
        image_.texels = indices_.data();
        palette_ = {image_, texels_.data(), 40};
        break;
      case 2:
        for (size_t i = 0; i < 40; i++) packed_.push_back(static_cast<uint16_t>(texels_[2 * i] << 8 | texels_[2 * i + 1]));
        image_.texels = packed_.data();
        image_.format = FC_TEXEL_RGB565;
        break;
      default: image_.format = FC_TEXEL_GREY8; break;
    }
  }

  Random &random_;
  int bits_;
  std::vector<fc_sphere> spheres_;
  std::vector<fc_plane> planes_;
  std::vector<fc_triangle> triangles_;
  std::vector<fc_vec3> vertices_;
  std::vector<fc_light> lights_;
  std::vector<fc_shapes> tables_;
  fc_material materials_[2] = {};
  std::vector<fc_normal> normals_;
  std::vector<fc_uv> uvs_;
  std::vector<uint8_t> texels_;
  std::vector<uint8_t> indices_;
  std::vector<uint16_t> packed_;
  fc_image image_ = {};
  fc_palette_image palette_ = {};
  fc_mapping mapping_ = {};
  fc_texture texture_ = {};
  fc_phong phong_ = {};
  fc_mirror mirror_ = {};
  fc_layer layer_ = {};
};

std::string text_of(fc_vec3 v) { return print("{%ld, %ld, %ld}", static_cast<long>(v.x), static_cast<long>(v.y), static_cast<long>(v.z)); }
std::string text_of(fc_rgb c) { return print("{%u, %u, %u}", c.r, c.g, c.b); }

std::string World::text() const {
  std::string all = print("\n  %u x %u, profile %u, offset rule %u, depth exponent bits %u, epsilon %ld", width, height,
                          options.profile, options.offset_rule, options.depth_exponent_bits, static_cast<long>(options.epsilon));
  all += "\n  fc_camera: eye " + text_of(camera.eye) + " target " + text_of(camera.target) + " up " + text_of(camera.up) +
         print(" exponent %d fov_rule %u tan %lu/%lu", camera.exponent, camera.fov_rule,
               static_cast<unsigned long>(camera.tan_half_fov_numerator),
               static_cast<unsigned long>(camera.tan_half_fov_denominator));
  if (scene.far_limit > 0) all += print("\n  far limit %ld * 2^%d", static_cast<long>(scene.far_limit), scene.far_exponent);
  all += "\n  ambient " + text_of(scene.ambient) + " background " + text_of(scene.background) + " diffuse " +
         text_of(materials_[0].diffuse) + " " + text_of(materials_[1].diffuse);
  if (materials_[1].layer_count != 0 && layer_.kind != &fc_layer_phong)
    all += layer_.kind == &fc_layer_smooth ? ", smooth" : layer_.kind == &fc_layer_mirror ? ", mirror"
                                                                                          : ", image";
  if (materials_[1].layer_count != 0 && layer_.kind == &fc_layer_phong)
    all += ", Phong " + text_of(phong_.specular) + print(" ^ %lu/256", static_cast<unsigned long>(phong_.shininess_q8));
  for (const fc_light &l : lights_)
    all += "\n  light " + text_of(l.position) + print(" * 2^%d, intensity ", l.exponent) + text_of(l.intensity) +
           print(" * 2^%d%s", l.intensity_exponent, l.inverse_square ? ", inverse square" : "");
  unsigned number = 0;
  for (const fc_shapes &shapes : tables_)
    for (uint16_t i = 0; i < shapes.count; i++, number++) {
      all += print("\n  %u: ", number);
      if (shapes.kind == &fc_kind_sphere)
        all += "sphere " + text_of(spheres_[i].center) +
               print(", %ld, material %u", static_cast<long>(spheres_[i].radius), spheres_[i].material);
      else if (shapes.kind == &fc_kind_plane)
        all += "plane " + text_of(planes_[i].normal) +
               print(", d %ld * 2^%d, material %u", static_cast<long>(planes_[i].d), planes_[i].d_exponent, planes_[i].material);
      else
        all += "triangle " + text_of(vertices_[triangles_[i].vertex[0]]) + " " +
               text_of(vertices_[triangles_[i].vertex[1]]) + " " + text_of(vertices_[triangles_[i].vertex[2]]) +
               print(", material %u", triangles_[i].material);
    }
  return all;
}

void channels(const Picture &picture, size_t i, int format, int level[3]) {
  const uint8_t *at = &picture.pixels[i * static_cast<size_t>(bytes_of[format])];
  if (format == FC_RGB888) {
    for (int c = 0; c < 3; c++) level[c] = at[c];
    return;
  }
  const int packed = format == FC_RGB565_BE ? at[0] << 8 | at[1] : at[1] << 8 | at[0];
  level[0] = packed >> 11;
  level[1] = packed >> 5 & 63;
  level[2] = packed & 31;
}

/* Levels by which colours may differ: one; and where a sphere or a light's distance is only a few grid units long, what the
 * ray engine loses by rounding the point to the grid, half a unit an axis, in levels up to 256 a unit of the cosine. A highlight
 * c^n falls by 0.61 sqrt(n) a radian at most, and the mirrored ray turns twice as far as the normal. */
double tolerance(const fc_frame &frame, uint16_t primitive, size_t i) {
  const int64_t eye[3] = {0, 0, 0};
  int64_t d[3];
  fc_space space = fc_space_of_frame(&frame);
  fc_surface surface;
  fc_view_direction(&frame, static_cast<uint16_t>(i % frame.width), static_cast<uint16_t>(i / frame.width), d);
  if (frame.scene.light_count != 1 || !fc_surface_meet(&surface, &space, primitive, eye, d)) return 1;
  fc_surface_complete(&surface);
  double square = 0, turn = 0;
  for (int c = 0; c < 3; c++) {
    const double w = static_cast<double>(frame.lights[c] - surface.point[c]);
    square += w * w;
  }
  turn = 1 / std::sqrt(square + 1);
  if (fc_kind_of(&surface.at) == &fc_kind_sphere) turn += 1 / static_cast<double>(surface.form.u.sphere.radius);
  const fc_material &material = frame.scene.materials[surface.form.material];
  double steep = 1;
  if (material.layer_count != 0 && material.layers[0].kind == &fc_layer_phong)
    steep += 2 * 0.61 * std::sqrt(static_cast<const fc_phong *>(material.layers[0].data)->shininess_q8 / 256.0);
  return 1 + 256 * 0.87 * turn * steep;
}

using Render = int (*)(const fc_frame *, uint16_t, uint16_t, const fc_target *);

void render(Render engine, const fc_frame &frame, int format, const std::vector<uint16_t> &strips, Picture *to,
            bool with_primitive = true, bool with_lit = true) {
  const size_t pixels = static_cast<size_t>(frame.width) * frame.height, bytes = static_cast<size_t>(bytes_of[format]);
  to->pixels.assign(pixels * bytes, 0x55);
  to->depth.assign(pixels, 0x5555);
  to->primitive.assign(pixels, 0x5555);
  to->lit.assign(pixels, 0x55555555);
  for (size_t i = 0; i + 1 < strips.size(); i += 2) {
    const size_t first = static_cast<size_t>(strips[i]) * frame.width;
    fc_target target = {&to->pixels[first * bytes], frame.width * bytes, static_cast<uint8_t>(format),
                        &to->depth[first], with_primitive ? &to->primitive[first] : nullptr, with_lit ? &to->lit[first] : nullptr};
    const int status = engine(&frame, strips[i], strips[i + 1], &target);
    if (status != FC_OK) fail("rows %u and %u more: %s", strips[i], strips[i + 1], fc_error_text(status));
  }
}

/* A field's rows are the frame's, and the others are left as they were. */
void fields(fc_frame frame, int format, const std::vector<uint16_t> &strips, const Picture &scan, const World &world) {
  const auto bytes = static_cast<size_t>(bytes_of[format]);
  if (frame.options.profile != FC_PROFILE_EXACT) return;
  frame.options.profile = FC_PROFILE_INTERLACED;
  for (uint16_t field = 0; field < 2; field++) {
    Picture drawn;
    const Render engines[] = {
        [](const fc_frame *f, uint16_t y, uint16_t rows, const fc_target *t) { return fc_render_profile(f, 0, y, rows, t); },
        [](const fc_frame *f, uint16_t y, uint16_t rows, const fc_target *t) { return fc_render_profile(f, 1, y, rows, t); }};
    render(engines[field], frame, format, strips, &drawn);
    for (size_t i = 0; i < scan.depth.size(); i++) {
      const bool here = i / frame.width % 2 == field;
      bool right = drawn.primitive[i] == (here ? scan.primitive[i] : 0x5555) && drawn.depth[i] == (here ? scan.depth[i] : 0x5555) &&
                   drawn.lit[i] == (here ? scan.lit[i] : 0x55555555);
      for (size_t b = i * bytes; b < (i + 1) * bytes; b++) right = right && drawn.pixels[b] == (here ? scan.pixels[b] : 0x55);
      if (!right)
        fail("pixel (%u, %u) is wrong in field %u%s", static_cast<unsigned>(i % frame.width),
             static_cast<unsigned>(i / frame.width), field, world.text().c_str());
    }
  }
}

/* The fast profile shows the same primitives and depth; colours within 4/255 more where lights are the same. */
void fast(fc_frame frame, int format, const std::vector<uint16_t> &strips, const Picture &rays, const World &world) {
  Picture drawn;
  if (frame.options.profile != FC_PROFILE_EXACT) return;
  frame.options.profile = FC_PROFILE_FAST;
  render(fc_render_rows, frame, format, strips, &drawn);
  for (size_t i = 0; i < rays.depth.size(); i++) {
    int expected[3], level[3];
    bool right = drawn.primitive[i] == rays.primitive[i] && drawn.depth[i] == rays.depth[i];
    channels(rays, i, format, expected);
    channels(drawn, i, format, level);
    for (int c = 0; c < 3 && right && drawn.lit[i] == rays.lit[i]; c++) {
      const int off = std::abs(level[c] - expected[c]), more = format == FC_RGB888 ? 4 : 1;
      right = off <= 1 + more || off <= more + tolerance(frame, rays.primitive[i], i);
    }
    if (!right)
      fail("pixel (%u, %u) is wrong in the fast profile: %u %u (%d %d %d), by rays %u %u (%d %d %d)%s",
           static_cast<unsigned>(i % frame.width), static_cast<unsigned>(i / frame.width), drawn.primitive[i], drawn.depth[i],
           level[0], level[1], level[2], rays.primitive[i], rays.depth[i], expected[0], expected[1], expected[2],
           world.text().c_str());
  }
}

uint64_t engines(Random &random) {
  World world(random);
  std::vector<int64_t> memory(fc_frame_memory(&world.scene, nullptr) / sizeof(int64_t) + 1);
  fc_frame frame;
  const int status = fc_frame_setup(&frame, &world.scene, &world.camera, &world.options, world.width, world.height,
                                    memory.data(), memory.size() * sizeof(int64_t));
  if (status == FC_ERR_LIGHT) return 0;
  if (status != FC_OK) fail("fc_frame_setup: %s%s", fc_error_text(status), world.text().c_str());
  const int format = static_cast<int>(random.within(0, formats - 1));
  Picture rays, scan, strips;
  render(fc_render_rows_by_rays, frame, format, {0, frame.height}, &rays);
  render(fc_render_rows, frame, format, {0, frame.height}, &scan);
  for (size_t i = 0; i < rays.depth.size(); i++) {
    std::string wrong;
    int expected[3], level[3];
    if (scan.primitive[i] != rays.primitive[i])
      wrong = print("primitive %u, depth code %u (%u, %u by rays)", scan.primitive[i], scan.depth[i], rays.primitive[i],
                    rays.depth[i]);
    else if (scan.depth[i] != rays.depth[i])
      wrong = print("depth code %u (%u by rays), primitive %u", scan.depth[i], rays.depth[i], rays.primitive[i]);
    else if (scan.lit[i] != rays.lit[i])
      wrong = print("lights %#x (%#x by rays), primitive %u", scan.lit[i], rays.lit[i], rays.primitive[i]);
    channels(rays, i, format, expected);
    channels(scan, i, format, level);
    for (int c = 0; c < 3 && wrong.empty(); c++)
      if (std::abs(level[c] - expected[c]) > 1 && std::abs(level[c] - expected[c]) > tolerance(frame, rays.primitive[i], i))
        wrong = print("channel %d is %d (%d by rays), primitive %u, lights %#x, format %d", c, level[c], expected[c],
                      rays.primitive[i], rays.lit[i], format);
    if (!wrong.empty())
      fail("pixel (%u, %u): %s%s", static_cast<unsigned>(i % frame.width), static_cast<unsigned>(i / frame.width),
           wrong.c_str(), world.text().c_str());
  }
  /* strips of any height, in any order */
  std::vector<uint16_t> parts;
  for (uint16_t y = 0; y < frame.height;) {
    const auto rows = static_cast<uint16_t>(random.within(1, random.flip() ? 2 : frame.height - y));
    const auto kept = std::min<uint16_t>(rows, static_cast<uint16_t>(frame.height - y));
    const auto at = static_cast<long>(2 * random.within(0, static_cast<int64_t>(parts.size() / 2)));
    parts.insert(parts.begin() + at, {y, kept});
    y = static_cast<uint16_t>(y + kept);
  }
  /* ... with and without what else a target may hold */
  const bool with_primitive = random.flip(), with_lit = random.flip();
  render(fc_render_rows, frame, format, parts, &strips, with_primitive, with_lit);
  if (!with_primitive) strips.primitive = scan.primitive;
  if (!with_lit) strips.lit = scan.lit;
  for (size_t i = 0; i < scan.depth.size(); i++) {
    const auto bytes = static_cast<size_t>(bytes_of[format]);
    if (strips.primitive[i] != scan.primitive[i] || strips.depth[i] != scan.depth[i] || strips.lit[i] != scan.lit[i] ||
        std::memcmp(&strips.pixels[i * bytes], &scan.pixels[i * bytes], bytes) != 0) {
      std::string list;
      for (uint16_t part : parts) list += print(" %u", part);
      list += print(" (%d %d)", with_primitive, with_lit);
      int whole[3], part[3];
      channels(scan, i, format, whole);
      channels(strips, i, format, part);
      fail("pixel (%u, %u) depends on the strips%s: %u %u %#x (%d %d %d) whole, %u %u %#x (%d %d %d) in strips%s",
           static_cast<unsigned>(i % frame.width), static_cast<unsigned>(i / frame.width), list.c_str(),
           scan.primitive[i], scan.depth[i], scan.lit[i], whole[0], whole[1], whole[2], strips.primitive[i],
           strips.depth[i], strips.lit[i], part[0], part[1], part[2], world.text().c_str());
    }
  }
  fields(frame, format, parts, scan, world);
  fast(frame, format, parts, rays, world);
  return rays.depth.size();
}

} // namespace

const std::vector<Family> engine_families = {
    {37, "scan engine and ray engine", 200000, 4000, engines},
};
