/* Animated GIF: palettes by median cut, LZW, blocks. After the GIF89a specification (CompuServe, 1990). */
#include "gif.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>

namespace host {
namespace {

constexpr std::size_t palette_size = 256;
using Colour = std::array<std::uint8_t, 3>;

std::uint32_t key_of(const Colour &c) { return std::uint32_t{c[0]} << 16 | std::uint32_t{c[1]} << 8 | c[2]; }

struct Counted {
  Colour colour;
  std::uint64_t pixels;
};

/* A run of the colours, in one box of the cube. */
struct Box {
  std::size_t first, last; /* not including last */
  std::uint64_t pixels;
  std::size_t axis; /* the longest */
  int length;       /* along it */
};

Box box_of(const std::vector<Counted> &colours, std::size_t first, std::size_t last) {
  Box box{first, last, 0, 0, -1};
  for (std::size_t i = first; i < last; i++) box.pixels += colours[i].pixels;
  for (std::size_t axis = 0; axis < 3; axis++) {
    int low = 255, high = 0;
    for (std::size_t i = first; i < last; i++) {
      low = std::min<int>(low, colours[i].colour[axis]);
      high = std::max<int>(high, colours[i].colour[axis]);
    }
    if (high - low > box.length) box.length = high - low, box.axis = axis;
  }
  return box;
}

struct Palette {
  std::vector<Colour> colours;
  std::unordered_map<std::uint32_t, std::uint8_t> index_of; /* of every colour of the frame */
};

/* The box whose length times pixels is largest is cut at its median pixel, until there are 256 or none is longer than 0. */
Palette make_palette(const Image8 &image) {
  std::map<std::uint32_t, Counted> counts; /* in the order of colours, so that nothing depends on a hash */
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
    const Colour c = {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
    counts.insert({key_of(c), {c, 0}}).first->second.pixels++;
  }
  std::vector<Counted> colours;
  for (const auto &[key, counted] : counts) colours.push_back(counted);

  std::vector<Box> boxes = {box_of(colours, 0, colours.size())};
  while (boxes.size() < palette_size) {
    Box *widest = &boxes.front();
    for (Box &box : boxes)
      if (static_cast<std::uint64_t>(box.length) * box.pixels > static_cast<std::uint64_t>(widest->length) * widest->pixels) widest = &box;
    if (widest->length == 0) break;
    const Box box = *widest;
    const auto from = colours.begin() + static_cast<std::ptrdiff_t>(box.first);
    const auto to = colours.begin() + static_cast<std::ptrdiff_t>(box.last);
    std::stable_sort(from, to, [&box](const Counted &a, const Counted &b) { return a.colour[box.axis] < b.colour[box.axis]; });
    std::size_t cut = box.first;
    for (std::uint64_t below = 0; cut + 1 < box.last && (cut == box.first || 2 * below < box.pixels); cut++) below += colours[cut].pixels;
    *widest = box_of(colours, box.first, cut);
    boxes.push_back(box_of(colours, cut, box.last));
  }

  Palette palette;
  for (std::size_t b = 0; b < boxes.size(); b++) {
    std::array<std::uint64_t, 3> sum{};
    for (std::size_t i = boxes[b].first; i < boxes[b].last; i++) {
      for (std::size_t axis = 0; axis < 3; axis++) sum[axis] += colours[i].colour[axis] * colours[i].pixels;
      palette.index_of[key_of(colours[i].colour)] = static_cast<std::uint8_t>(b);
    }
    Colour mean{};
    for (std::size_t axis = 0; axis < 3; axis++)
      mean[axis] = static_cast<std::uint8_t>((sum[axis] + boxes[b].pixels / 2) / boxes[b].pixels);
    palette.colours.push_back(mean);
  }
  return palette;
}

void put16(std::string &to, int value) {
  to += static_cast<char>(value & 0xff);
  to += static_cast<char>(value >> 8 & 0xff);
}

/* Blocks of at most 255 bytes, and an empty one. */
void put_blocks(std::string &to, const std::string &bytes) {
  for (std::size_t i = 0; i < bytes.size(); i += 255) {
    const std::string block = bytes.substr(i, 255);
    to += static_cast<char>(block.size());
    to += block;
  }
  to += '\0';
}

/* Codes of growing width, lowest bit first. */
class Lzw {
public:
  explicit Lzw(unsigned bits) : bits_(bits), clear_(1u << bits) {}

  std::string encode(const std::vector<std::uint8_t> &symbols) {
    restart();
    std::uint32_t prefix = symbols.front();
    for (std::size_t i = 1; i < symbols.size(); i++) {
      const std::uint32_t longer = prefix << 8 | symbols[i];
      const auto found = codes_.find(longer);
      if (found != codes_.end()) {
        prefix = found->second;
        continue;
      }
      put(prefix);
      codes_[longer] = next_++;
      if (next_ > 1u << width_ && width_ < 12) width_++;
      if (next_ == 4096) restart();
      prefix = symbols[i];
    }
    put(prefix);
    /* The reader has grown its table by the code that it just read. */
    if (++next_ > 1u << width_ && width_ < 12) width_++;
    put(clear_ + 1);
    if (held_ > 0) bytes_ += static_cast<char>(pending_ & 0xff);
    return std::move(bytes_);
  }

private:
  void restart() {
    if (width_ == 0) width_ = bits_ + 1;
    put(clear_);
    codes_.clear();
    next_ = clear_ + 2;
    width_ = bits_ + 1;
  }

  void put(std::uint32_t code) {
    pending_ |= code << held_;
    for (held_ += width_; held_ >= 8; held_ -= 8) {
      bytes_ += static_cast<char>(pending_ & 0xff);
      pending_ >>= 8;
    }
  }

  unsigned bits_, width_ = 0, held_ = 0;
  std::uint32_t clear_, next_ = 0, pending_ = 0;
  std::unordered_map<std::uint32_t, std::uint32_t> codes_; /* prefix code << 8 | symbol; prefix is below 4096 */
  std::string bytes_;
};

void put_frame(std::string &to, const Image8 &image, int centiseconds) {
  const Palette palette = make_palette(image);
  unsigned bits = 1;
  while (std::size_t{1} << bits < palette.colours.size()) bits++;
  to += std::string("\x21\xf9\x04\x04", 4); /* graphic control: leave in place */
  put16(to, centiseconds);
  to += std::string("\0\0", 2);
  to += '\x2c';
  put16(to, 0);
  put16(to, 0);
  put16(to, image.width);
  put16(to, image.height);
  to += static_cast<char>(0x80 | (bits - 1)); /* a palette of its own */
  for (std::size_t i = 0; i < std::size_t{1} << bits; i++) {
    const Colour c = i < palette.colours.size() ? palette.colours[i] : Colour{};
    for (const std::uint8_t v : c) to += static_cast<char>(v);
  }
  std::vector<std::uint8_t> symbols;
  symbols.reserve(image.rgb.size() / 3);
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
    symbols.push_back(palette.index_of.at(key_of({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]})));
  const unsigned code_bits = std::max(bits, 2u);
  to += static_cast<char>(code_bits);
  put_blocks(to, Lzw(code_bits).encode(symbols));
}

} // namespace

std::string encode_gif(const std::vector<Image8> &frames, int centiseconds, const Metadata &metadata) {
  std::string gif = "GIF89a";
  put16(gif, frames.front().width);
  put16(gif, frames.front().height);
  gif += std::string("\x70\0\0", 3); /* no common palette */
  gif += std::string("\x21\xff\x0bNETSCAPE2.0\x03\x01\0\0\0", 19);
  std::string comment;
  for (const auto &[name, text] : metadata) comment += name + ": " + text + "\n";
  if (!comment.empty()) {
    gif += "\x21\xfe";
    put_blocks(gif, comment);
  }
  for (const Image8 &frame : frames) put_frame(gif, frame, centiseconds);
  return gif + ";";
}

} // namespace host
