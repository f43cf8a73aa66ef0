/* Key-framed cameras from a text file. */
#include "key_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "scene_file.h"

namespace host {
namespace {

struct RealKey {
  int frame = 0;
  std::array<double, 6> values{};
};

[[noreturn]] void fail(const std::string &path, int line, const std::string &what) {
  throw UserError(path + ":" + std::to_string(line) + ": " + what);
}

RealKey parse(const std::string &path, int line, std::istringstream &words) {
  constexpr const char *usage = "write FRAME from X Y Z at X Y Z";
  constexpr int last_frame = 100000;
  RealKey key;
  std::string word;
  if (!(words >> key.frame) || key.frame < 0 || key.frame > last_frame)
    fail(path, line, std::string("a frame number that is not 0 to 100000; ") + usage);
  for (std::size_t i = 0; i < 6; i++) {
    if (i % 3 == 0 && (!(words >> word) || word != (i == 0 ? "from" : "at")))
      fail(path, line, std::string("the word ") + (i == 0 ? "from" : "at") + " is missing; " + usage);
    char *end = nullptr;
    if (words >> word) key.values[i] = std::strtod(word.c_str(), &end);
    if (!words || end == word.c_str() || *end != '\0' || !(std::fabs(key.values[i]) < 1e30))
      fail(path, line, std::string("a coordinate that is missing or no number; ") + usage);
  }
  if (words >> word) fail(path, line, std::string("more than two points; ") + usage);
  return key;
}

/* Catmull-Rom's cubic through b (t = 0) and c (t = 2^28), rounded. Values up to 2^29: doubled coefficients up to 2^33, so that products stay
 * below 2^62. */
std::int64_t curve(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d, std::int64_t t) {
  constexpr std::int64_t half = std::int64_t{1} << 27;
  const auto times_t = [t](std::int64_t v) { return (v * t + half) >> 28; };
  std::int64_t sum = 3 * (b - c) + d - a;
  sum = times_t(sum) + 2 * a - 5 * b + 4 * c - d;
  sum = times_t(sum) + c - a;
  sum = times_t(sum);
  return b + ((sum + 1) >> 1);
}

} // namespace

CameraKey KeyFrames::at(int frame) const {
  if (frame <= keys.front().frame) return keys.front();
  if (frame >= keys.back().frame) return keys.back();
  std::size_t i = 0;
  while (keys[i + 1].frame <= frame) i++;
  const CameraKey &b = keys[i], &c = keys[i + 1];
  const CameraKey &a = i == 0 ? b : keys[i - 1], &d = i + 2 < keys.size() ? keys[i + 2] : c;
  const std::int64_t t = (std::int64_t{frame - b.frame} << 28) / (c.frame - b.frame);
  CameraKey key;
  key.frame = frame;
  for (std::size_t axis = 0; axis < 3; axis++) {
    key.from[axis] = curve(a.from[axis], b.from[axis], c.from[axis], d.from[axis], t);
    key.at[axis] = curve(a.at[axis], b.at[axis], c.at[axis], d.at[axis], t);
  }
  return key;
}

KeyFrames read_key_frames(const std::string &path) {
  std::ifstream file(path);
  if (!file) throw UserError(path + ": cannot open; --path takes orbit, turntable or a file of key frames");
  std::vector<RealKey> real;
  std::string text;
  double largest = 0;
  for (int line = 1; std::getline(file, text); line++) {
    std::istringstream words(text.substr(0, text.find('#')));
    if ((words >> std::ws).eof()) continue;
    if (real.size() == 10000) fail(path, line, "more than 10000 keys; use fewer");
    real.push_back(parse(path, line, words));
    if (real.size() > 1 && real[real.size() - 2].frame >= real.back().frame)
      fail(path, line, "a frame that is not above the one before; sort the keys");
    for (const double v : real.back().values) largest = std::max(largest, std::fabs(v));
  }
  if (real.size() < 2) throw UserError(path + ": fewer than two keys; add lines FRAME from X Y Z at X Y Z");
  KeyFrames frames;
  (void)std::frexp(largest, &frames.exponent);
  frames.exponent -= 29; /* a curve may swing out beyond its keys */
  for (const RealKey &from : real) {
    CameraKey key;
    key.frame = from.frame;
    for (std::size_t axis = 0; axis < 3; axis++) {
      key.from[axis] = std::llround(std::ldexp(from.values[axis], -frames.exponent));
      key.at[axis] = std::llround(std::ldexp(from.values[axis + 3], -frames.exponent));
    }
    frames.keys.push_back(key);
  }
  return frames;
}

} // namespace host
