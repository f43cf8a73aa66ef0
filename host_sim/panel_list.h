/* The panels by name. */
#ifndef FIXCAST_HOST_PANEL_LIST_H
#define FIXCAST_HOST_PANEL_LIST_H

#include <string>
#include <vector>

#include "fixcast/panel.h"

namespace host {

/* "ssd1306", ... in the order of fc_panels. */
std::vector<std::string> panel_names();

/* Throws UserError with the names that exist. */
const fc_panel &find_panel(const std::string &name);

/* "rgb565" and so on. */
const char *format_name(std::uint8_t format);

/* A line a panel: name, size, format, clock. */
std::string list_panels();

} // namespace host

#endif
