/* Frames drawn as their profiles say: samples doubled, fields of rows. In a file of its own: who does without it links none. */
#include <string.h>

#include "fixcast/error.h"
#include "scan.h"

/* ---- half resolution ---- */

/* A row of samples becomes two rows of pixels, from its end on: the upper may begin where the samples do, or behind; they may be
 * the same. */
static void widen(uint8_t *upper, uint8_t *lower, const uint8_t *samples, uint16_t width, uint8_t unit) {
  uint16_t x = width;
  uint8_t i;
  if (x & 1) {
    const uint8_t *sample = samples + (size_t)(--x / 2) * unit;
    for (i = unit; i-- > 0;) upper[(size_t)x * unit + i] = lower[(size_t)x * unit + i] = sample[i];
  }
  samples += (size_t)(x / 2) * unit;
  upper += (size_t)x * unit;
  lower += (size_t)x * unit;
  for (; x != 0; x = (uint16_t)(x - 2)) {
    samples -= unit;
    upper -= 2 * unit;
    lower -= 2 * unit;
    for (i = unit; i-- > 0;) upper[i] = upper[unit + i] = lower[i] = lower[unit + i] = samples[i];
  }
}

/* The same for samples of two bytes and an even width, where all is aligned. */
static void widen_pairs(uint8_t *upper, uint8_t *lower, const uint8_t *samples, uint16_t width) {
  size_t at = (size_t)width * 2;
  samples += width;
  while (at != 0) {
    uint16_t sample;
    uint32_t pair;
    samples -= 2;
    memcpy(&sample, FC_ALIGNED2(samples), sizeof sample);
    pair = sample * UINT32_C(0x10001);
    at -= 4;
    memcpy(FC_ALIGNED4(upper + at), &pair, sizeof pair);
    memcpy(FC_ALIGNED4(lower + at), &pair, sizeof pair);
  }
}

/* Rows of samples `sample_pitch` bytes apart become rows of pixels `pitch` bytes apart in the same memory, the last one first.
 * Row i of the strip shows row (i + y % 2) / 2 <= i of the samples, so all that is still to be read lies before what is written. */
static void double_rows(const fc_frame *frame, uint16_t y, uint16_t rows, void *memory, size_t sample_pitch, size_t pitch,
                        uint8_t unit) {
  const uint16_t width = fc_view_columns(frame), odd = y & 1;
  const bool pairs = unit == 2 && ((uintptr_t)memory | pitch | (size_t)width * 2) % 4 == 0;
  uint16_t s = (uint16_t)((rows + odd + 1) / 2);
  while (s-- > 0) {
    const uint8_t *samples = (const uint8_t *)memory + s * sample_pitch;
    const uint32_t first = s == 0 ? 0 : 2 * (uint32_t)s - odd, second = 2 * (uint32_t)s + 1 - odd;
    uint8_t *upper = (uint8_t *)memory + first * pitch;
    uint8_t *lower = second < rows ? (uint8_t *)memory + second * pitch : upper;
    if (pairs)
      widen_pairs(upper, lower, samples, width);
    else
      widen(upper, lower, samples, width, unit);
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
  fc_scan scan;
  uint16_t row;
  int bytes = fc_render_check(frame, y, rows, target);
  if (bytes < 0) return bytes;
  if (field > 1) return FC_ERR_PROFILE;
  for (row = first; row < rows; row = (uint16_t)(row + 2)) {
    const fc_target one = row_of(frame, target, row);
    fc_strip_clear(frame, (uint16_t)(y + row), 1, &one);
  }
  fc_strip_draw(&scan, frame, y, rows, target, field ^ 1);
  for (row = first; row < rows; row = (uint16_t)(row + 2)) {
    const fc_target one = row_of(frame, target, row);
    fc_strip_finish(frame, 1, &one);
  }
  return FC_OK;
}

FC_COLD int fc_render_profile(const fc_frame *frame, uint8_t field, uint16_t y, uint16_t rows, const fc_target *target) {
  if (frame == NULL) return FC_ERR_NULL;
  switch (frame->options.profile) {
    case FC_PROFILE_HALF: return draw_half(frame, y, rows, target);
    case FC_PROFILE_INTERLACED: return draw_field(frame, field, y, rows, target);
    default: return fc_render_rows(frame, y, rows, target);
  }
}
