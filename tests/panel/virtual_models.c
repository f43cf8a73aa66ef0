/* Virtual panels by name. */
#include <stddef.h>
#include <string.h>

#include "virtual_panel.h"

const virtual_model *virtual_model_named(const char *name) {
  static const virtual_model *const all[] = {&virtual_st7789_240, &virtual_st7789_135, &virtual_st7789_320,
                                             &virtual_st7789_170, &virtual_ili9341, &virtual_st7735_128,
                                             &virtual_ssd1351, &virtual_ssd0323, &virtual_ssd1327,
                                             &virtual_ssd1322, &virtual_ssd1306};
  size_t i;
  for (i = 0; i < sizeof all / sizeof *all; i++) {
    if (strcmp(all[i]->name, name) == 0) return all[i];
  }
  return NULL;
}
