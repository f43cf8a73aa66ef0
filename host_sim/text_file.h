/* Whole text files in memory. */
#ifndef FIXCAST_HOST_TEXT_FILE_H
#define FIXCAST_HOST_TEXT_FILE_H

#include <string>

namespace host {

/* The bytes of a file of at most 256 MiB. Throws UserError "PATH: what is wrong; what to do". */
std::string load_text(const std::string &path);

} // namespace host

#endif
