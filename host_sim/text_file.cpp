/* Whole text files in memory. */
#include "text_file.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <vector>

#include "scene_file.h"

namespace host {
namespace {

constexpr std::size_t max_file_bytes = std::size_t{256} << 20;

[[noreturn]] void fail(const std::string &path, const std::string &sentence) { throw UserError(path + ": " + sentence); }

} // namespace

std::string load_text(const std::string &path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail(path, "this is a directory; name a scene file in it");
  std::FILE *file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) fail(path, "cannot open: " + std::generic_category().message(errno) + "; check the name and its permissions");
  std::string text;
  std::vector<char> chunk(1 << 16);
  std::size_t count = 0;
  while (text.size() <= max_file_bytes && (count = std::fread(chunk.data(), 1, chunk.size(), file)) > 0) text.append(chunk.data(), count);
  const int error = std::ferror(file) != 0 ? errno : 0;
  (void)std::fclose(file);
  if (error != 0) fail(path, "cannot read: " + std::generic_category().message(error) + "; check the file and its disk");
  if (text.size() > max_file_bytes) fail(path, "larger than 256 MiB; check that this is a scene, or split it");
  return text;
}

} // namespace host
