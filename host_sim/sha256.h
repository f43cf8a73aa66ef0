/* SHA-256 (FIPS 180-4): by which a baked file says what it was made from. */
#ifndef FIXCAST_HOST_SHA256_H
#define FIXCAST_HOST_SHA256_H

#include <string>

namespace host {

/* 64 hexadecimal digits, as sha256sum prints them. */
std::string sha256(const std::string &bytes);

} // namespace host

#endif
