/* All panels, for programs that choose one by name; a program that names one panel does not link this file. */
#include "fixcast/panel.h"

const fc_panel *const fc_panels[] FC_ROM = {&fc_panel_st7789_240, &fc_panel_st7789_135, &fc_panel_st7789_320,
                                            &fc_panel_st7789_170, &fc_panel_ili9341, &fc_panel_st7735_128,
                                            &fc_panel_ssd1351, &fc_panel_ssd0323, &fc_panel_ssd1327,
                                            &fc_panel_ssd1322, &fc_panel_ssd1306, NULL};
