/* A firmware whose scene holds spheres and nothing else: what it links, checks/linked.py looks through. */
#include "fixcast/fixcast.h"

static const fc_material material[] FC_ROM = {FC_MATTE(FC_RGB8(200, 100, 50))};
static const fc_sphere spheres[] FC_ROM = {{FC_VEC3(0, 0, -4), FC_Q16(1), 0, 1}};
static const fc_light lights[] FC_ROM = {{.position = FC_VEC3(-3, 5, 1), .intensity = FC_GREY(0.875)}};
static const fc_shapes shapes[] FC_ROM = {FC_SPHERES(spheres)};
static const fc_scene scene FC_ROM = {
    .shapes = shapes, .shape_count = 1, .materials = material, .material_count = 1, .lights = lights, .light_count = 1};
static const fc_camera camera FC_ROM = {
    .eye = {0, 0, 0}, .target = FC_VEC3(0, 0, -1), .up = {0, 1, 0}, .tan_half_fov_numerator = 1, .tan_half_fov_denominator = 2};

int main(void) {
  static int64_t memory[256];
  static fc_scratch scratch;
  static uint16_t pixels[8 * 8], depth[8 * 8];
  fc_frame frame;
  const fc_target target = {.pixels = pixels, .pitch_bytes = 16, .format = FC_RGB565_BE, .depth = depth};
  int error = fc_frame_setup(&frame, &scene, &camera, NULL, 8, 8, memory, sizeof memory);
  if (error == FC_OK) error = fc_render_rows_in(&scratch, &frame, 0, 8, &target);
  /* the ball fills the middle and the corner is empty */
  return error == FC_OK && depth[4 * 8 + 4] != 0 && depth[0] == 0 ? 0 : 1;
}
