/* The words of OBJ and MTL lines, looked at before tinyobjloader takes them: it takes a wrong number for 0, and a huge exponent overflows in it. */
#ifndef FIXCAST_HOST_OBJ_WORDS_H
#define FIXCAST_HOST_OBJ_WORDS_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace host {

/* Throws UserError "PATH:LINE: sentence". */
[[noreturn]] void fail_line(const std::string &path, std::size_t line, const std::string &sentence);

/* Whether the line is text, and of a length that a line may have; fails otherwise. */
void check_line(const std::string &path, std::size_t number, std::string_view line);

/* The word that a line begins with; part of the line. */
std::string_view keyword_of(std::string_view line);

/* Those behind it, up to a comment. */
std::vector<std::string_view> words_behind(std::string_view keyword, std::string_view line);

/* A decimal with an exponent of at most three digits. */
bool is_number(std::string_view text);

/* Splits the leading digits off; how many. */
std::size_t take_digits(std::string_view &text);

} // namespace host

#endif
