/*
 * From scene to glass: S1 rendered in strips, converted and written to each panel as a chip does it, in little memory.
 *
 * panel_scene            the tests
 * panel_scene DIRECTORY  writes what each glass shows to DIRECTORY/PANEL.ppm, to be looked at
 */
#include <stdio.h>
#include <string.h>

#include "rig.h"
#include "s1.h"
#include "unity.h"

enum {
  PIXELS = 240 * 320,
  STRIP = 8
};
static rig it;
static int64_t memory[512];
static uint8_t strip[256 * STRIP * 2], converted[256 * STRIP], whole[PIXELS * 2];
static uint16_t depth[PIXELS];
static const char *directory;

void setUp(void) {}
void tearDown(void) { rig_close(&it); }

static int setup_frame(fc_frame *frame) {
  return fc_frame_setup(frame, &s1, &s1_camera, NULL, it.can.width, it.can.height, memory, sizeof memory);
}

/* The frame in strips, each converted on its own: in place, but for one bit a pixel, which has a page of its own. */
static int draw_strips(void) {
  const size_t pitch = (size_t)it.can.width * 2, bytes = fc_display_row_bytes(it.can.format, it.can.width);
  const fc_target target = {.pixels = strip, .pitch_bytes = pitch, .format = FC_RGB565_BE, .depth = depth};
  uint8_t *const to = it.can.format == FC_DISPLAY_MONO8 ? converted : strip;
  fc_frame frame;
  uint16_t y;
  int error = setup_frame(&frame);
  for (y = 0; error == FC_OK && y < it.can.height; y = (uint16_t)(y + STRIP)) {
    const fc_area area = {0, y, it.can.width, STRIP};
    error = fc_render_rows(&frame, y, STRIP, &target);
    if (error == FC_OK)
      error = fc_display_convert(it.can.format, 0, y, it.can.width, STRIP, strip, pitch, to, bytes);
    if (error == FC_OK) error = fc_display_write(&it.display, &area, to, bytes);
  }
  return error;
}

/* The frame as one, into the rig's picture. */
static int draw_whole(void) {
  const size_t pitch = (size_t)it.can.width * 2;
  const fc_target target = {.pixels = whole, .pitch_bytes = pitch, .format = FC_RGB565_BE, .depth = depth};
  fc_frame frame;
  int error = setup_frame(&frame);
  if (error == FC_OK) error = fc_render_rows(&frame, 0, it.can.height, &target);
  if (error != FC_OK) return error;
  return fc_display_convert(it.can.format, 0, 0, it.can.width, it.can.height, whole, pitch, it.picture,
                            fc_display_row_bytes(it.can.format, it.can.width));
}

static void write_picture(void) {
  char path[300];
  FILE *file;
  uint16_t x, y;
  snprintf(path, sizeof path, "%s/%s%s.ppm", directory, it.record->name, it.options.twelve_bit ? "-12" : "");
  file = fopen(path, "wb");
  if (file == NULL) TEST_FAIL_MESSAGE("cannot write the picture: is the directory there?");
  fprintf(file, "P6\n%u %u\n255\n", it.can.width, it.can.height);
  for (y = 0; y < it.can.height; y++) {
    for (x = 0; x < it.can.width; x++) {
      const uint32_t colour = virtual_shown(it.panel, x, y);
      fputc((int)(colour >> 16), file), fputc((int)(colour >> 8 & 255), file),
          fputc((int)(colour & 255), file);
    }
  }
  if (fclose(file) != 0) TEST_FAIL_MESSAGE("cannot write the picture");
}

static void test_s1_in_strips_is_on_each_glass(void) {
  const fc_panel *const *record;
  unsigned variant;
  for (record = fc_panels; *record != NULL; record++) {
    for (variant = 0; variant < 4; variant++) {
      const bool half_turn = variant & 1, twelve_bit = variant & 2;
      const char *verdict;
      if (twelve_bit && (*record)->format12 == NULL) continue;
      rig_open(&it, *record, false, half_turn, twelve_bit);
      TEST_ASSERT_EQUAL_INT(FC_OK, rig_start(&it));
      TEST_ASSERT_EQUAL_INT(FC_OK, draw_strips());
      TEST_ASSERT_EQUAL_INT(FC_OK, draw_whole());
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(1, it.panel->windows, "window commands a frame");
      verdict = rig_verdict(&it);
      if (verdict != NULL) TEST_FAIL_MESSAGE(verdict);
      if (directory != NULL && !half_turn) write_picture();
      rig_close(&it);
    }
  }
}

int main(int count, char **arguments) {
  if (count > 1) directory = arguments[1];
  UNITY_BEGIN();
  RUN_TEST(test_s1_in_strips_is_on_each_glass);
  return UNITY_END();
}
