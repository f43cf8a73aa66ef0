/* The program's version, for --version and for what files say about their origin: the library's. */
#ifndef FIXCAST_HOST_VERSION_H
#define FIXCAST_HOST_VERSION_H

#include "fixcast/version.h"

namespace host {

inline constexpr const char *version = FC_VERSION_TEXT;

} // namespace host

#endif
