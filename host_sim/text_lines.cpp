/* The lines of a text. */
#include "text_lines.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "scene_file.h"

namespace host {
namespace {

constexpr std::size_t chunk_bytes = std::size_t{64} << 10, longest_line = std::size_t{128} << 10, max_file_bytes = std::size_t{256} << 20;

[[noreturn]] void fail(const std::string &path, const std::string &sentence) { throw UserError(path + ": " + sentence); }

} // namespace

TextLines::TextLines(const std::string &path, LineEnd end) : path_(path), end_(end) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail(path, "this is a directory; name a scene file in it");
  file_.reset(std::fopen(path.c_str(), "rb"));
  if (!file_) fail(path, "cannot open: " + std::generic_category().message(errno) + "; check the name and its permissions");
  read_on();
}

void TextLines::read_on() {
  std::string kept(rest_);
  kept.resize(rest_.size() + chunk_bytes);
  const std::size_t count = std::fread(&kept[rest_.size()], 1, chunk_bytes, file_.get());
  if (std::ferror(file_.get()) != 0) fail(path_, "cannot read: " + std::generic_category().message(errno) + "; check the file and its disk");
  kept.resize(rest_.size() + count);
  buffer_ = std::move(kept);
  rest_ = buffer_;
  at_end_ = count < chunk_bytes;
  bytes_ += count;
  if (bytes_ > max_file_bytes) fail(path_, "larger than 256 MiB; check that this is a scene, or split it");
}

/* Where the first line ends in what is in memory; 0 when that is not to be seen there. */
std::size_t TextLines::end_of_line() const {
  const std::size_t at = end_ == LineEnd::lf ? rest_.find('\n') : rest_.find_first_of("\r\n");
  if (at == std::string_view::npos) return at_end_ || rest_.size() > longest_line ? rest_.size() : 0;
  if (rest_[at] == '\n') return at + 1;
  if (at + 1 == rest_.size()) return at_end_ ? at + 1 : 0; /* perhaps the CR of a CR LF */
  return rest_[at + 1] == '\n' ? at + 2 : at + 1;
}

bool TextLines::next(std::string_view &line) {
  std::size_t end = 0;
  while ((end = end_of_line()) == 0) {
    if (at_end_) return false; /* nothing is left */
    read_on();
  }
  line = rest_.substr(0, end);
  rest_.remove_prefix(end);
  return true;
}

} // namespace host
