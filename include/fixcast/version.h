/*
 * The version of these headers: the one place where it is written; CMake and what packages the library read it from here.
 *
 * Semantic versioning: before 1.0.0 a new minor version may change an interface, a new patch version may not.
 */
#ifndef FIXCAST_VERSION_H
#define FIXCAST_VERSION_H

/* Changes with what programs must be written anew for. */
#define FC_VERSION_MAJOR 0
/* Changes with what is new. */
#define FC_VERSION_MINOR 1
/* Changes with what is mended. */
#define FC_VERSION_PATCH 0

/* The version as text, "0.1.0". */
#define FC_VERSION_TEXT FC_VERSION_JOIN(FC_VERSION_MAJOR, FC_VERSION_MINOR, FC_VERSION_PATCH)
/* The version as a number that grows with it, to compare in #if: FC_VERSION >= 100 is 0.1.0 or later. */
#define FC_VERSION (FC_VERSION_MAJOR * 10000L + FC_VERSION_MINOR * 100 + FC_VERSION_PATCH)

/* For FC_VERSION_TEXT alone. */
#define FC_VERSION_JOIN(major, minor, patch) \
  FC_VERSION_QUOTE(major) \
  "." FC_VERSION_QUOTE(minor) "." FC_VERSION_QUOTE(patch)
/* For FC_VERSION_TEXT alone. */
#define FC_VERSION_QUOTE(number) #number

#endif
