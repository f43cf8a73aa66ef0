/* The words of OBJ and MTL lines. */
#include "obj_words.h"

#include <algorithm>

#include "scene_file.h"

namespace host {
namespace {

constexpr std::size_t max_line_bytes = 65536;

void take_sign(std::string_view &text) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
}

} // namespace

std::size_t take_digits(std::string_view &text) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(count);
  return count;
}

std::string_view keyword_of(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  return line.substr(0, line.find_first_of(" \t\r\n"));
}

bool is_number(std::string_view text) {
  take_sign(text);
  std::size_t digits = take_digits(text);
  if (!text.empty() && text[0] == '.') {
    text.remove_prefix(1);
    digits += take_digits(text);
  }
  if (digits == 0) return false;
  if (text.empty()) return true;
  if (text[0] != 'e' && text[0] != 'E') return false;
  text.remove_prefix(1);
  take_sign(text);
  const std::size_t exponent = take_digits(text);
  return text.empty() && exponent >= 1 && exponent <= 3;
}

void fail_line(const std::string &path, std::size_t line, const std::string &sentence) {
  throw UserError(path + ":" + std::to_string(line) + ": " + sentence);
}

void check_line(const std::string &path, std::size_t number, std::string_view line) {
  if (line.size() > max_line_bytes) fail_line(path, number, "a line of more than 65536 characters; save it as plain text");
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && byte != '\t' && byte != '\r' && byte != '\n') || byte == 0x7f)
      fail_line(path, number, "not a text file; save the model as Wavefront OBJ");
  }
}

std::vector<std::string_view> words_behind(std::string_view keyword, std::string_view line) {
  constexpr const char *blanks = " \t\r\n";
  std::vector<std::string_view> words;
  line.remove_prefix(static_cast<std::size_t>(keyword.data() - line.data()) + keyword.size());
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos && line[begin] != '#';) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
  return words;
}

} // namespace host
