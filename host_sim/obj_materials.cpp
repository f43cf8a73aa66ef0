/* Wavefront materials. */
#include "obj_materials.h"

#include <algorithm>
#include <sstream>

#include "obj_words.h"

namespace host {
namespace {

constexpr std::size_t max_materials = 65535;

} // namespace

bool read_materials(const std::string &path, TextLines &lines, std::vector<tinyobj::material_t> &materials, std::map<std::string, int> &index) {
  std::string used, warning, error;
  std::string_view line;
  std::size_t number = 0, count = 0;
  bool textured = false;
  while (lines.next(line)) {
    number++;
    check_line(path, number, line);
    const std::string_view keyword = keyword_of(line);
    if (keyword != "newmtl" && keyword != "Kd" && keyword != "map_Kd") continue;
    if (keyword == "map_Kd") textured = true;
    const std::vector<std::string_view> words = words_behind(keyword, line);
    if (keyword == "newmtl") {
      if (words.empty()) fail_line(path, number, "newmtl without a name; write newmtl NAME");
      if (++count > max_materials) fail_line(path, number, "more than 65535 materials; remove some");
    } else if (count == 0) {
      fail_line(path, number, std::string(keyword) + " before the first newmtl; put newmtl NAME above it");
    } else if (keyword == "Kd") {
      if (!words.empty() && (words[0] == "spectral" || words[0] == "xyz")) continue; /* grey */
      if ((words.size() != 3 && words.size() != 1) || !std::all_of(words.begin(), words.end(), is_number))
        fail_line(path, number, "a colour that is not three decimal numbers; write Kd R G B");
    }
    if (keyword == "map_Kd") continue;
    used += keyword;
    for (const std::string_view word : words) used += " " + std::string(word);
    if (keyword == "Kd" && words.size() == 1) used += " " + std::string(words[0]) + " " + std::string(words[0]); /* red alone is grey */
    used += "\n";
  }
  if (count == 0) return textured; /* tinyobjloader would make one without a name */
  std::istringstream stream(used);
  tinyobj::LoadMtl(&index, &materials, &stream, &warning, &error);
  return textured;
}

} // namespace host
