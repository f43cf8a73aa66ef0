/*
 * One of the lectures' methods on one scene, for an emulated chip: -DSCENE=box -DMETHOD=n of the list in methods.py. Prints `crc`, of the primitive
 * numbers it sees. What is measured lies between the bench's marks: the methods in tests/rivals in float, scene and unit directions at hand; ours
 * setting up a frame and drawing it without lights.
 */
#include <cstdlib>
#include <new>

#include "picture.h"

extern "C" {
#include "semihost.h"
extern const fc_scene SCENE;
#define PASTE2(a, b) a##b
#define PASTE(a, b) PASTE2(a, b)
#define CAMERA PASTE(SCENE, _camera)
extern const fc_camera CAMERA;

#define MARK(name) \
  void name(void); \
  __attribute__((noinline)) void name(void) { __asm__ volatile("/* " #name " */" :: \
                                                                   : "memory"); }
MARK(bench_mark_other)
MARK(bench_mark_setup)
MARK(bench_mark_strips)

/* What newlib asks of a system: memory, and nothing else. */
void *_sbrk(int bytes);
void *_sbrk(int bytes) { /* the MPS2's PSRAM: a BSP tree of S2 takes more than the chip has */
  constexpr uintptr_t start = 0x21000000, size = 16 << 20;
  static uintptr_t used = 0;
  if (used + static_cast<uintptr_t>(bytes) > size) semihost_exit(4);
  used += static_cast<uintptr_t>(bytes);
  return reinterpret_cast<void *>(start + used - static_cast<uintptr_t>(bytes));
}
void _exit(int code);
void _exit(int code) { semihost_exit(code); }
int _write(int, const char *, int count);
int _write(int, const char *, int count) { return count; }
int _read(int, char *, int);
int _read(int, char *, int) { return 0; }
int _close(int);
int _close(int) { return -1; }
int _lseek(int, int, int);
int _lseek(int, int, int) { return -1; }
int _fstat(int, void *);
int _fstat(int, void *) { return -1; }
int _isatty(int);
int _isatty(int) { return 1; }
int _kill(int, int);
int _kill(int, int) { return -1; }
int _getpid(void);
int _getpid(void) { return 1; }
}

/* What the C++ library would bring: the image is linked without it. */
void *operator new(size_t bytes) { return std::malloc(bytes); } /* _sbrk ends the run before this is null */
void *operator new(size_t bytes, const std::nothrow_t &) noexcept { return std::malloc(bytes); }
void operator delete(void *memory) noexcept { std::free(memory); }
void operator delete(void *memory, size_t) noexcept { std::free(memory); }
void operator delete(void *memory, const std::nothrow_t &) noexcept { std::free(memory); }
namespace std {
const nothrow_t nothrow{};
void __throw_length_error(const char *) {
  semihost_exit(6);
  __builtin_unreachable();
}
void __throw_bad_alloc() {
  semihost_exit(6);
  __builtin_unreachable();
}
void __throw_bad_array_new_length() {
  semihost_exit(6);
  __builtin_unreachable();
}
void __throw_bad_function_call() {
  semihost_exit(6);
  __builtin_unreachable();
}
} // namespace std

namespace {

constexpr int side = 128;

Pixels ours(bool by_rays) {
  fc_scene dark = SCENE; /* seeing alone is compared */
  dark.light_count = 0;
  std::vector<int64_t> memory(fc_frame_memory(&dark, nullptr) / 8 + 1);
  Pixels primitive(side * side);
  std::vector<uint16_t> pixels(side * side), depth(side * side);
  fc_frame frame;
  fc_target target = {};
  target.pixels = pixels.data();
  target.pitch_bytes = side * 2;
  target.format = FC_RGB565_BE;
  target.depth = depth.data();
  target.primitive = primitive.data();
  bench_mark_setup();
  int error = fc_frame_setup(&frame, &dark, &CAMERA, nullptr, side, side, memory.data(), memory.size() * 8);
  bench_mark_strips();
  if (error == FC_OK) error = by_rays ? fc_render_rows_by_rays(&frame, 0, side, &target) : fc_render_rows(&frame, 0, side, &target);
  bench_mark_other();
  if (error != FC_OK) semihost_exit(5);
  return primitive;
}

template <typename Draw>
Pixels measured(Draw draw) {
  bench_mark_strips();
  Pixels pixels = draw();
  bench_mark_other();
  return pixels;
}

Pixels rival() {
  const Picture p = shapes_of(SCENE, CAMERA, side, side);
  const std::vector<Vector<float>> rays = rays_of<float>(p);
  auto hit = [&](SphereBy sphere, TriangleBy triangle) { return closest_hit<float>(p, rays, sphere, triangle); };
  return measured([&] {
    switch (METHOD) {
      case 2: return hit(SphereBy::algebra, TriangleBy::edges);
      case 3: return hit(SphereBy::geometry, TriangleBy::edges);
      case 4: return hit(SphereBy::geometry, TriangleBy::cramer);
      case 5: return hit(SphereBy::geometry, TriangleBy::plane_barycentric);
      case 6: return hit(SphereBy::geometry, TriangleBy::edges);
      case 7: return z_buffer<float>(p, 0);
      case 8: return painter<float>(p);
      case 9: return bsp<float>(p);
      default: return warnock<float>(p);
    }
  });
}

} // namespace

int main() {
  const uint32_t crc = crc_of(METHOD <= 1 ? ours(METHOD == 0) : rival());
  for (const char *text = "crc 0x"; *text != '\0'; text++) semihost_char(*text);
  for (int i = 28; i >= 0; i -= 4) semihost_char("0123456789abcdef"[(crc >> i) & 15]);
  semihost_char('\n');
  return 0;
}
