/* S1 by hand, as firmware would hold it; prints its golden line. */
#include <stdio.h>

#include "fixcast/fixcast.h"

static const fc_material materials[] = {
    {FC_RGB8(224, 64, 48)}, {FC_RGB8(48, 192, 80)}, {FC_RGB8(64, 96, 224)}, {FC_RGB8(192, 192, 176)}};
static const fc_sphere spheres[] = {{FC_VEC3(0, 1, -6), FC_Q16(1), 0, 1},
                                    {FC_VEC3(-1.75, 0.75, -4.5), FC_Q16(0.75), 1, 2},
                                    {FC_VEC3(1.25, 0.5, -3), FC_Q16(0.5), 2, 3}};
static const fc_plane planes[] = {{{0, 1, 0}, 0, 0, 3, 4}};
static const fc_shapes shapes[] = {FC_SPHERES(spheres), FC_PLANES(planes)};
static const fc_light lights[] = {{FC_VEC3(-3, 5, -1), FC_GREY(0.875), 0, 0, 0}};
static const fc_scene scene = {.shapes = shapes,
                               .shape_count = FC_COUNT_OF(shapes),
                               .materials = materials,
                               .material_count = FC_COUNT_OF(materials),
                               .lights = lights,
                               .light_count = FC_COUNT_OF(lights),
                               .far_limit = FC_Q16(100),
                               .ambient = FC_GREY(0.125),
                               .background = FC_RGB8(96, 144, 208)};
static const fc_camera camera = {.eye = FC_VEC3(0, 1.5, 1),
                                 .target = FC_VEC3(0, 1.5, 0),
                                 .up = {0, 1, 0},
                                 .tan_half_fov_numerator = 1,
                                 .tan_half_fov_denominator = 2};

enum { WIDTH = 128, HEIGHT = 128 };

static int64_t memory[64];
static uint8_t pixels[WIDTH * HEIGHT * 2];
static uint16_t depth[WIDTH * HEIGHT], primitive[WIDTH * HEIGHT];

int main(void) {
  fc_frame frame;
  const fc_target target = {
      .pixels = pixels, .pitch_bytes = WIDTH * 2, .format = FC_RGB565_BE, .depth = depth, .primitive = primitive};
  unsigned long crc = 0xffffffff;
  size_t i;
  int bit;
  int error = fc_frame_setup(&frame, &scene, &camera, NULL, WIDTH, HEIGHT, memory, sizeof memory);
  if (error == FC_OK) error = fc_render_rows(&frame, 0, HEIGHT, &target);
  if (error != FC_OK) {
    printf("%s\n", fc_error_text(error));
    return 1;
  }
  for (i = 0; i < sizeof pixels; i++)
    for (crc ^= pixels[i], bit = 0; bit < 8; bit++)
      crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320 : 0);
  printf("s1 128x128 0x%08lx\n", crc ^ 0xffffffff);
  return 0;
}
