/* Textbook renderers against exact visibility: how many pixels each gets wrong, as JSON. rivals [-o FILE] */
#include <cstdio>
#include <cstring>
#include <map>
#include <string>

#include "picture.h"

#define X(scene) \
  extern "C" { \
  extern const fc_scene scene; \
  extern const fc_camera scene##_camera; \
  }
SCENES
#undef X

namespace {

struct Wrong {
  size_t objects, primitives;
};

/* Where a pixel's centre lies on an edge (a room seen straight on has many), what is seen 2^-20 of a pixel beside it is right too. */
struct Truth {
  const Picture &picture;
  std::vector<Pixels> beside;
  explicit Truth(const Picture &p) : picture(p) {
    const double step = 1.0 / (1 << 20);
    for (int i = 0; i < 4; i++)
      beside.push_back(closest_hit<double>(p, rays_of<double>(p, i & 1 ? step : -step, i & 2 ? step : -step),
                                           SphereBy::geometry, TriangleBy::edges));
  }
};

Wrong count(const Truth &truth, const Pixels &pixels) {
  const Picture &picture = truth.picture;
  Wrong w = {0, 0};
  auto object = [&](uint16_t p) { return p == nothing ? 0 : picture.object[p]; };
  for (size_t i = 0; i < picture.exact.size(); i++) {
    bool primitive = pixels[i] == picture.exact[i], same = object(pixels[i]) == object(picture.exact[i]);
    for (const Pixels &b : truth.beside) {
      primitive = primitive || pixels[i] == b[i];
      same = same || object(pixels[i]) == object(b[i]);
    }
    w.primitives += !primitive;
    w.objects += !same;
  }
  return w;
}

struct Row {
  std::string method, numbers;
  Wrong wrong;
  uint32_t crc; /* of the numbers it sees, as tests/bench/methods.py finds it on a chip */
};

template <typename T>
void run(const Truth &truth, const char *numbers, std::vector<Row> *rows) {
  const Picture &p = truth.picture;
  const std::vector<Vector<T>> rays = rays_of<T>(p);
  auto add = [&](const char *method, const Pixels &pixels, uint32_t crc) {
    rows->push_back({method, numbers, count(truth, pixels), crc});
  };
  auto add_rays = [&](const char *method, const Pixels &pixels) { add(method, pixels, crc_of(pixels)); };
  if (p.has(Shape::sphere)) {
    add_rays("sphere by algebra", closest_hit<T>(p, rays, SphereBy::algebra, TriangleBy::edges));
    add_rays("sphere by geometry", closest_hit<T>(p, rays, SphereBy::geometry, TriangleBy::edges));
  }
  if (p.has(Shape::triangle)) {
    add_rays("triangle by Cramer", closest_hit<T>(p, rays, SphereBy::geometry, TriangleBy::cramer));
    add_rays("triangle by plane and barycentrics",
             closest_hit<T>(p, rays, SphereBy::geometry, TriangleBy::plane_barycentric));
    add_rays("triangle by edges", closest_hit<T>(p, rays, SphereBy::geometry, TriangleBy::edges));
  }
  if (p.has(Shape::triangle) && !p.has(Shape::plane)) {
    auto add_triangles = [&](const char *method, Pixels pixels) {
      const uint32_t crc = crc_of(pixels);
      for (size_t i = 0; i < pixels.size(); i++) /* where another shape is in front, nothing is asked */
        if (p.exact[i] != nothing && p.shapes[p.exact[i]].kind != Shape::triangle) pixels[i] = p.exact[i];
      add(method, pixels, crc);
    };
    add_triangles("z-buffer", z_buffer<T>(p, 0));
    add_triangles("z-buffer of 24 bits", z_buffer<T>(p, 24));
    add_triangles("z-buffer of 16 bits", z_buffer<T>(p, 16));
    add_triangles("painter", painter<T>(p));
    add_triangles("BSP tree", bsp<T>(p));
    add_triangles("Warnock", warnock<T>(p));
  }
}

} // namespace

int main(int argc, char **argv) {
  const char *path = nullptr;
  if (argc == 3 && std::strcmp(argv[1], "-o") == 0) {
    path = argv[2];
  } else if (argc != 1) {
    std::fprintf(stderr, "usage: %s [-o FILE]\n", argv[0]);
    return 2;
  }
  const int width = 128, height = 128;
  const std::vector<std::pair<const char *, std::pair<const fc_scene *, const fc_camera *>>> scenes = {
#define X(scene) {#scene, {&scene, &scene##_camera}},
      SCENES
#undef X
  };
  std::string json = "{\n  \"width\": 128,\n  \"height\": 128,\n  \"scenes\": {";
  int failed = 0;
  const char *comma = "";
  for (const auto &scene : scenes) {
    const Picture p = picture_of(*scene.second.first, *scene.second.second, width, height);
    const Truth truth(p);
    size_t different = 0;
    for (size_t i = 0; i < p.exact.size(); i++) different += p.ours[i] != p.exact[i];
    std::vector<Row> rows = {{"ours", "integer", {different, different}, crc_of(p.ours)}};
    run<double>(truth, "double", &rows);
    run<float>(truth, "float", &rows);
    run<Fixed>(truth, "fixed 16", &rows);
    json += std::string(comma) + "\n    \"" + scene.first + "\": [";
    comma = ",";
    const char *row_comma = "";
    for (const Row &r : rows) {
      std::printf("%-6s %-35s %-9s %6zu wrong objects, %6zu wrong primitives\n", scene.first,
                  r.method.c_str(), r.numbers.c_str(), r.wrong.objects, r.wrong.primitives);
      json += std::string(row_comma) + "\n      {\"method\": \"" + r.method + "\", \"numbers\": \"" +
              r.numbers + "\", \"wrong_objects\": " + std::to_string(r.wrong.objects) +
              ", \"wrong_primitives\": " + std::to_string(r.wrong.primitives) + ", \"crc\": " + std::to_string(r.crc) + "}";
      row_comma = ",";
      /* no straw men: in double every method is right, or it is coded wrong, but for what gives up exactness by design; ours is exact */
      const bool by_design =
          r.method == "painter" || r.method == "BSP tree" || r.method.find("bits") != std::string::npos;
      const bool sound = by_design || r.wrong.objects == 0;
      if ((r.numbers == "double" && !sound) || (r.method == "ours" && r.wrong.primitives != 0)) {
        std::printf("FAIL: %s in %s on %s\n", r.method.c_str(), r.numbers.c_str(), scene.first);
        failed++;
      }
    }
    json += "\n    ]";
  }
  json += "\n  }\n}\n";
  if (path != nullptr) {
    const std::string part = std::string(path) + ".part";
    std::FILE *file = std::fopen(part.c_str(), "w");
    const bool written = file != nullptr && std::fputs(json.c_str(), file) >= 0;
    if ((file != nullptr && std::fclose(file) != 0) || !written || std::rename(part.c_str(), path) != 0) {
      std::fprintf(stderr,
                   "rivals: cannot write %s: see whether its directory exists and may be written to\n", path);
      return 2;
    }
  }
  return failed == 0 ? 0 : 1;
}
