/* Names of the frames of a sequence: "frame_%04d.png". */
#ifndef FIXCAST_HOST_SEQUENCE_H
#define FIXCAST_HOST_SEQUENCE_H

#include <string>

namespace host {

/* Whether the name holds a number's place, "%d" or "%0Nd" with N 1..9. Throws UserError for any other use of '%'. */
bool is_sequence_name(const std::string &path);

/* The name with the number in its place. */
std::string sequence_name(const std::string &path, int number);

} // namespace host

#endif
