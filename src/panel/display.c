/* A display sink's front door: arguments are checked here, so that no sink has to, and missing talents are made up for. */
#include "fixcast/display.h"

#include "fixcast/error.h"

void fc_display_capabilities_get(const fc_display *display, fc_display_capabilities *to) {
  display->ops->capabilities(display->context, to);
}

size_t fc_display_row_bytes(uint8_t format, uint16_t width) {
  const size_t half = width / 2u + width % 2u;
  switch (format) {
    case FC_DISPLAY_RGB565: return (size_t)width * 2u;
    case FC_DISPLAY_RGB444: return width + half;
    case FC_DISPLAY_GREY4: return half;
    case FC_DISPLAY_MONO8: return width;
    default: return 0;
  }
}

/* Whether `count` places from `first` lie within `size`, both in steps of `align`. */
static bool fits(uint16_t first, uint16_t count, uint16_t size, uint8_t align) {
  return count != 0 && first < size && count <= size - first && first % align == 0 && count % align == 0;
}

/* Whether an area may be drawn; on success *can is what the display can. */
static int check(const fc_display *display, const fc_area *area, const void *pixels, size_t pitch_bytes,
                 fc_display_capabilities *can) {
  if (display == NULL || display->ops == NULL || area == NULL || pixels == NULL) return FC_ERR_NULL;
  display->ops->capabilities(display->context, can);
  if (!fits(area->x, area->width, can->width, can->x_align)) return FC_ERR_AREA;
  if (!fits(area->y, area->height, can->height, can->y_align)) return FC_ERR_AREA;
  return pitch_bytes < fc_display_row_bytes(can->format, area->width) ? FC_ERR_AREA : FC_OK;
}

int fc_display_write(const fc_display *display, const fc_area *area, const void *pixels, size_t pitch_bytes) {
  fc_display_capabilities can;
  const int error = check(display, area, pixels, pitch_bytes, &can);
  if (error != FC_OK) return error;
  return display->ops->write(display->context, area, pixels, pitch_bytes);
}

int fc_display_write_start(const fc_display *display, const fc_area *area, const void *pixels,
                           size_t pitch_bytes, fc_ready *ready, void *ready_context) {
  fc_display_capabilities can;
  int error = check(display, area, pixels, pitch_bytes, &can);
  if (error != FC_OK) return error;
  if (can.asynchronous && display->ops->write_start != NULL) {
    return display->ops->write_start(display->context, area, pixels, pitch_bytes, ready, ready_context);
  }
  error = display->ops->write(display->context, area, pixels, pitch_bytes);
  if (error == FC_OK && ready != NULL) ready(ready_context, FC_OK);
  return error;
}

int fc_display_wait(const fc_display *display) {
  if (display == NULL || display->ops == NULL) return FC_ERR_NULL;
  return display->ops->wait != NULL ? display->ops->wait(display->context) : FC_OK;
}

int fc_display_flush(const fc_display *display) {
  if (display == NULL || display->ops == NULL) return FC_ERR_NULL;
  return display->ops->flush != NULL ? display->ops->flush(display->context) : FC_ERR_UNSUPPORTED;
}

int fc_display_backlight(const fc_display *display, uint8_t level) {
  if (display == NULL || display->ops == NULL) return FC_ERR_NULL;
  return display->ops->backlight != NULL ? display->ops->backlight(display->context, level)
                                         : FC_ERR_UNSUPPORTED;
}

int fc_display_wait_vsync(const fc_display *display) {
  if (display == NULL || display->ops == NULL) return FC_ERR_NULL;
  return display->ops->wait_vsync != NULL ? display->ops->wait_vsync(display->context) : FC_ERR_UNSUPPORTED;
}
