/* Any sequence of calls on a few fixed frames: refused with the right error and nothing written, or exactly the
 * rows of the full picture. */
#include <array>
#include <cstring>
#include <memory>
#include <vector>

#include "fixcast/fixcast.h"
#include "fuzz.h"
#include "scenes.h"

namespace {

constexpr std::uint8_t filler = 0xa5;
constexpr int formats = 3;
constexpr std::array<int, formats> bytes_of_format = {3, 2, 2};

struct Setting {
  const fixed_scene &of;
  std::uint16_t width, height;
  fc_options options;
};

const std::array<Setting, 6> settings = {{{fixed_s1, 12, 9, {}},
                                          {fixed_s1, 1, 7, {FC_OFFSET_RESIDUAL, 4, 0, FC_PROFILE_EXACT, 0}},
                                          {fixed_s1, 16, 2, {FC_OFFSET_EPSILON, 2, 0, FC_PROFILE_FAST, 64}},
                                          {fixed_mesh, 12, 12, {}},
                                          {fixed_mesh, 7, 1, {FC_OFFSET_NONE, 3, 0, FC_PROFILE_EXACT, 0}},
                                          {fixed_mesh, 5, 16, {FC_OFFSET_EPSILON, 0, 20, FC_PROFILE_FAST, 0x3fffffff}}}};

/* A frame and its whole picture, made once. */
struct Reference {
  explicit Reference(const Setting &setting)
      : memory(fc_frame_memory(setting.of.scene, nullptr)), width(setting.width), height(setting.height) {
    CHECK(fc_frame_setup(&frame, setting.of.scene, setting.of.camera, &setting.options, width, height,
                         memory.get(), memory.bytes()) == FC_OK);
    const std::size_t size = static_cast<std::size_t>(width) * height;
    depth.resize(size);
    primitive.resize(size);
    lit.resize(size);
    for (int format = 0; format < formats; format++) {
      const std::size_t pitch = width * static_cast<std::size_t>(bytes_of_format[format]);
      pixels[format].resize(pitch * height);
      fc_target target{};
      target.pixels = pixels[format].data();
      target.pitch_bytes = pitch;
      target.format = static_cast<std::uint8_t>(format);
      target.depth = depth.data();
      target.primitive = primitive.data();
      target.lit = lit.data();
      CHECK(fc_render_rows(&frame, 0, height, &target) == FC_OK);
    }
    frame_as_made = frame;
    memory_as_made.assign(memory.get(), memory.get() + memory.count());
  }

  fc_frame frame, frame_as_made;
  fuzz::Exact<std::uint8_t> memory;
  std::vector<std::uint8_t> memory_as_made;
  std::uint16_t width, height;
  std::array<std::vector<std::uint8_t>, formats> pixels;
  std::vector<std::uint16_t> depth, primitive;
  std::vector<std::uint32_t> lit;
};

template <typename T>
void check_untouched(const fuzz::Exact<T> &buffer) {
  const auto *bytes = reinterpret_cast<const std::uint8_t *>(buffer.get());
  for (std::size_t i = 0; i < buffer.bytes(); i++) CHECK(bytes[i] == filler);
}

template <typename T>
void check_rows(const fuzz::Exact<T> &buffer, const std::vector<T> &whole, std::size_t first) {
  CHECK(std::memcmp(buffer.get(), whole.data() + first, buffer.bytes()) == 0);
}

/* What SPEC and the headers promise for these arguments. */
int expected_error(const Reference &of, std::uint16_t y, std::uint16_t rows, const fc_target &target) {
  if (target.pixels == nullptr || target.depth == nullptr) return FC_ERR_NULL;
  if (target.format >= formats) return FC_ERR_FORMAT;
  const std::size_t least = of.width * static_cast<std::size_t>(bytes_of_format[target.format]);
  if (rows < 1 || y + rows > of.height || target.pitch_bytes < least) return FC_ERR_SIZE;
  return FC_OK;
}

void render_some(fuzz::Bytes &in, const Reference &of) {
  /* mostly near the frame, sometimes anything */
  const std::uint8_t how = in.u8();
  const bool any = (how & 0xe0) == 0xe0;
  const std::uint16_t y = any ? in.u16() : static_cast<std::uint16_t>(in.u8() % (of.height + 2));
  const std::uint16_t rows = any ? in.u16() : static_cast<std::uint16_t>(in.u8() % (of.height + 2));
  fc_target target{};
  target.format = how & 0x10 ? in.u8() : static_cast<std::uint8_t>(in.u8() % formats);
  const int pixel_bytes = fc_format_bytes(target.format);
  CHECK(pixel_bytes == (target.format < formats ? bytes_of_format[target.format] : FC_ERR_FORMAT));
  const std::size_t line = of.width * static_cast<std::size_t>(pixel_bytes > 0 ? pixel_bytes : 3);
  /* A huge pitch is only ever multiplied by 0, as one row has no next one. */
  target.pitch_bytes = any && rows == 1 ? static_cast<std::size_t>(in.u64()) : line - 2 + in.u8() % 40;

  const bool fits = rows >= 1 && y + rows <= of.height && target.pitch_bytes >= line;
  const std::size_t kept_rows = fits ? rows : 1, size = kept_rows * of.width;
  const fuzz::Exact<std::uint8_t> pixels((kept_rows - 1) * target.pitch_bytes + line);
  const fuzz::Exact<std::uint16_t> depth(size), primitive(size);
  const fuzz::Exact<std::uint32_t> lit(size);
  std::memset(pixels.get(), filler, pixels.bytes());
  std::memset(depth.get(), filler, depth.bytes());
  std::memset(primitive.get(), filler, primitive.bytes());
  std::memset(lit.get(), filler, lit.bytes());
  const unsigned missing = how & 0x08 ? in.u8() : 0;
  target.pixels = missing & 1 ? nullptr : pixels.get();
  target.depth = missing & 2 ? nullptr : depth.get();
  target.primitive = missing & 4 ? nullptr : primitive.get();
  target.lit = missing & 8 ? nullptr : lit.get();

  const int error = fc_render_rows(&of.frame, y, rows, &target);
  CHECK(error == expected_error(of, y, rows, target));
  if (target.lit == nullptr || error != FC_OK) check_untouched(lit);
  if (target.primitive == nullptr || error != FC_OK) check_untouched(primitive);
  if (error != FC_OK) {
    check_untouched(pixels);
    check_untouched(depth);
    return;
  }
  const std::size_t first = static_cast<std::size_t>(y) * of.width;
  check_rows(depth, of.depth, first);
  if (target.primitive != nullptr) check_rows(primitive, of.primitive, first);
  if (target.lit != nullptr) check_rows(lit, of.lit, first);
  const std::uint8_t *whole = of.pixels[target.format].data() + y * line;
  for (std::size_t row = 0; row < rows; row++) {
    const std::uint8_t *at = pixels.get() + row * target.pitch_bytes;
    CHECK(std::memcmp(at, whole + row * line, line) == 0);
    if (row + 1 == rows) continue;
    for (std::size_t i = line; i < target.pitch_bytes; i++) CHECK(at[i] == filler);
  }
}

void pick_one(fuzz::Bytes &in, const Reference &of) {
  const std::uint8_t how = in.u8();
  const std::uint16_t x = how & 0x80 ? in.u16() : static_cast<std::uint16_t>(in.u8() % (of.width + 1));
  const std::uint16_t y = how & 0x80 ? in.u16() : static_cast<std::uint16_t>(in.u8() % (of.height + 1));
  fc_hit hit{};
  std::uint32_t lit = 0;
  const bool with_hit = (how & 1) == 0, with_lit = (how & 2) == 0;
  const int got = fc_pick(&of.frame, x, y, with_hit ? &hit : nullptr, with_lit ? &lit : nullptr);
  if (!with_hit) {
    CHECK(got == FC_ERR_NULL);
  } else if (x >= of.width || y >= of.height) {
    CHECK(got == FC_ERR_SIZE);
  } else {
    const std::size_t i = static_cast<std::size_t>(y) * of.width + x;
    CHECK(got == (of.primitive[i] != 0xffff));
    if (got == 1)
      CHECK(hit.primitive == of.primitive[i] && hit.object == fc_object(&of.frame, hit.primitive));
    if (with_lit) CHECK(lit == (got == 1 ? of.lit[i] : 0));
  }
}

void look_up(fuzz::Bytes &in, const Reference &of) {
  int exponent = 0;
  const std::uint16_t code = in.u16();
  if (code != 0) CHECK(fc_depth_z(&of.frame, code, &exponent) >> 31 == 1);
  (void)fc_object(&of.frame, in.u16());
  CHECK(fc_error_text(static_cast<int>(in.u32()))[0] != '\0');
  fc_target target{};
  CHECK(fc_render_rows(nullptr, 0, 1, &target) == FC_ERR_NULL);
  CHECK(fc_render_rows(&of.frame, 0, 1, nullptr) == FC_ERR_NULL);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t count) {
  static std::array<std::unique_ptr<Reference>, settings.size()> references;
  fuzz::Bytes in(data, count);
  const std::size_t which = in.u8() % settings.size();
  if (references[which] == nullptr) references[which] = std::make_unique<Reference>(settings[which]);
  const Reference &of = *references[which];
  for (int calls = 0; calls < 32 && !in.empty(); calls++) {
    switch (in.u8() % 8) {
      case 0: pick_one(in, of); break;
      case 1: look_up(in, of); break;
      default: render_some(in, of); break;
    }
  }
  CHECK(std::memcmp(&of.frame, &of.frame_as_made, sizeof of.frame) == 0);
  CHECK(std::memcmp(of.memory.get(), of.memory_as_made.data(), of.memory.bytes()) == 0);
  return 0;
}
