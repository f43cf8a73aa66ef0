/* The program's version, for --version and for what files say about their origin. */
#ifndef FIXCAST_HOST_VERSION_H
#define FIXCAST_HOST_VERSION_H

#ifndef FIXCAST_VERSION /* the build's, from the project's version */
#define FIXCAST_VERSION "0.0.0"
#endif

namespace host {

inline constexpr const char *version = FIXCAST_VERSION;

} // namespace host

#endif
