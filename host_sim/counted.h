/* What a scene's frame costs a chip, as `make bench` counted it and docs/REPORT.md says. */
#ifndef FIXCAST_HOST_COUNTED_H
#define FIXCAST_HOST_COUNTED_H

#include <string>

namespace host {

/* "101.4 instructions a pixel on Cortex-M0+, counted at 128x128" for a scene file and a profile of the report's table, "instructions not
 * counted" for any other: they are not guessed. */
std::string counted_text(const std::string &file, const std::string &profile);

} // namespace host

#endif
