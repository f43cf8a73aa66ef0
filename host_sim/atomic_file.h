/*
 * Files that appear under their name only when they are complete.
 *
 * The bytes go to a temporary file in the same directory, which then takes the name in one step; whatever
 * goes wrong, an older file of that name stays as it was and no temporary is left behind. Every error is a
 * UserError "PATH: cannot write: reason; what to do".
 */
#ifndef FIXCAST_HOST_ATOMIC_FILE_H
#define FIXCAST_HOST_ATOMIC_FILE_H

#include <string>

namespace host {

/* Writes `bytes` to `path`. */
void write_file(const std::string &path, const std::string &bytes);

/* The error of this header, for those who find a fault before anything is written. */
[[noreturn]] void fail_write(const std::string &path, const std::string &reason, const std::string &advice);

} // namespace host

#endif
