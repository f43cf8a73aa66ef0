/* Frames drawn as their profiles say: samples doubled, fields of rows. In a file of its own: who does without it links none. */
#include <string.h>

#include "fixcast/error.h"
#include "scan.h"

/* ---- half resolution ---- */

/* A row of samples becomes a row of pixels, from its end on: the same memory, or some that lies behind. */
static void widen(uint8_t *to, const uint8_t *from, uint16_t width, uint8_t unit) {
  const uint8_t *sample = from + (size_t)(width / 2) * unit;
  uint8_t *pixel = to + (size_t)(width & ~1u) * unit, i;
  if (width & 1)
    for (i = unit; i-- > 0;) pixel[i] = sample[i];
  while (pixel != to) {
    sample -= unit;
    pixel -= 2 * unit;
    if (unit == 2) {
      uint8_t a = sample[0], b = sample[1];
      pixel[0] = pixel[2] = a;
      pixel[1] = pixel[3] = b;
    } else {
      for (i = unit; i-- > 0;) pixel[i] = pixel[unit + i] = sample[i];
    }
  }
}

/* Rows of samples `sample_pitch` bytes apart become rows of pixels `pitch` bytes apart in the same memory, the last one first.
 * Row i shows row (i + y % 2) / 2 <= i of the samples, so all that is still to be read lies before what has been written. */
static void double_rows(const fc_frame *frame, uint16_t y, uint16_t rows, void *memory, size_t sample_pitch, size_t pitch,
                        uint8_t unit) {
  const uint16_t width = fc_view_columns(frame), odd = y & 1;
  uint16_t i;
  for (i = rows; i-- > 0;) {
    uint8_t *to = (uint8_t *)memory + i * pitch;
    if (i + 1 < rows && ((i + odd) & 1) == 0)
      memcpy(to, to + pitch, (size_t)width * unit);
    else
      widen(to, (const uint8_t *)memory + (size_t)((i + odd) / 2) * sample_pitch, width, unit);
  }
}

static int draw_half(const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target) {
  const uint16_t width = fc_view_columns(frame), height = fc_view_rows(frame), samples = frame->width;
  int error, bytes;
  if (target == NULL) return FC_ERR_NULL;
  bytes = fc_format_bytes(target->format);
  if (bytes < 0) return bytes;
  if (rows < 1 || y >= height || rows > height - y ||
      target->pitch_bytes < (size_t)width * (size_t)bytes)
    return FC_ERR_SIZE;
  error = fc_render_rows(frame, y / 2, (uint16_t)((y + rows - 1) / 2 - y / 2 + 1), target);
  if (error != FC_OK) return error;
  double_rows(frame, y, rows, target->pixels, target->pitch_bytes, target->pitch_bytes, (uint8_t)bytes);
  double_rows(frame, y, rows, target->depth, (size_t)samples * 2, (size_t)width * 2, 2);
  if (target->primitive != NULL)
    double_rows(frame, y, rows, target->primitive, (size_t)samples * 2, (size_t)width * 2, 2);
  if (target->lit != NULL) double_rows(frame, y, rows, target->lit, (size_t)samples * 4, (size_t)width * 4, 4);
  return FC_OK;
}

/* ---- fields ---- */

/* A row of a strip, as a strip of its own. */
static fc_target row_of(const fc_frame *frame, const fc_target *target, uint16_t row) {
  const size_t at = (size_t)row * frame->width;
  fc_target one = *target;
  one.pixels = (uint8_t *)target->pixels + row * target->pitch_bytes;
  one.depth += at;
  if (one.primitive != NULL) one.primitive += at;
  if (one.lit != NULL) one.lit += at;
  return one;
}

static int draw_field(const fc_frame *frame, uint8_t field, uint16_t y, uint16_t rows, const fc_target *target) {
  const uint16_t first = (y ^ field) & 1;
  uint16_t row;
  int bytes = fc_render_check(frame, y, rows, target);
  if (bytes < 0) return bytes;
  if (field > 1) return FC_ERR_PROFILE;
  for (row = first; row < rows; row = (uint16_t)(row + 2)) {
    const fc_target one = row_of(frame, target, row);
    fc_strip_clear(frame, 1, &one);
  }
  fc_strip_draw(frame, y, rows, target, field ^ 1);
  for (row = first; row < rows; row = (uint16_t)(row + 2)) {
    const fc_target one = row_of(frame, target, row);
    fc_strip_finish(frame, 1, &one);
  }
  return FC_OK;
}

int fc_render_profile(const fc_frame *frame, uint8_t field, uint16_t y, uint16_t rows, const fc_target *target) {
  if (frame == NULL) return FC_ERR_NULL;
  switch (frame->options.profile) {
    case FC_PROFILE_HALF: return draw_half(frame, y, rows, target);
    case FC_PROFILE_INTERLACED: return draw_field(frame, field, y, rows, target);
    default: return fc_render_rows(frame, y, rows, target);
  }
}
