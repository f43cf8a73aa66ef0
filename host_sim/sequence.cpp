/* Names of the frames of a sequence. */
#include "sequence.h"

#include <cstddef>

#include "scene_file.h"

namespace host {
namespace {

/* Where the number stands: the first '%', its length, the digits to fill up to; length 0 when there is none. */
struct Place {
  std::size_t first = 0, length = 0, digits = 1;
};

Place find_place(const std::string &path) {
  Place place;
  place.first = path.find('%');
  if (place.first == std::string::npos) return place;
  const std::string rest = path.substr(place.first + 1);
  if (rest.rfind("d", 0) == 0) {
    place.length = 2;
  } else if (rest.size() >= 3 && rest[0] == '0' && rest[1] >= '1' && rest[1] <= '9' && rest[2] == 'd') {
    place.length = 4;
    place.digits = static_cast<std::size_t>(rest[1] - '0');
  }
  if (place.length == 0 || path.find('%', place.first + 1) != std::string::npos)
    throw UserError(path + ": a name for frames with a % that is not one number's place; write it as in frame_%04d.png");
  return place;
}

} // namespace

bool is_sequence_name(const std::string &path) { return find_place(path).length > 0; }

std::string sequence_name(const std::string &path, int number) {
  const Place place = find_place(path);
  if (place.length == 0) return path;
  std::string text = std::to_string(number);
  if (text.size() < place.digits) text.insert(0, place.digits - text.size(), '0');
  return path.substr(0, place.first) + text + path.substr(place.first + place.length);
}

} // namespace host
