/* What a panel's glass would show of a frame: its pixel format and dither, as a picture. */
#ifndef FIXCAST_HOST_PANEL_VIEW_H
#define FIXCAST_HOST_PANEL_VIEW_H

#include <cstdint>
#include <vector>

#include "fixcast/panel.h"
#include "frame_run.h"
#include "image.h"

namespace host {

/* The frame as the panel shows it: what fc_display_convert makes of it, decoded. `picture` must be FC_RGB565_BE, of the panel's size. A level
 * of n bits is shown as level / (2^n - 1) of full brightness. Throws UserError when the sizes differ. */
Image8 panel_picture(const fc_panel &panel, const Picture &picture);

/* A frame's FC_RGB888 pixels as FC_RGB565_BE ones by ordered dither (fc_display_dither565). */
std::vector<std::uint8_t> dithered565(const Picture &rgb888);

} // namespace host

#endif
