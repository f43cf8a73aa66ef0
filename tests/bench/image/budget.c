/* The least program that draws a scene: what it takes is the core's and the scene's alone. */
#include "fixcast/fixcast.h"

extern const fc_scene SCENE;
#define CAMERA_OF(scene) scene##_camera
#define CAMERA(scene) CAMERA_OF(scene)
extern const fc_camera CAMERA(SCENE);

int main(void) {
  static fc_frame frame;
  static int64_t memory[3000];
  static fc_scratch scratch;
  static uint16_t pixels[128 * 8], depth[128 * 8];
  const fc_target target = {.pixels = pixels, .pitch_bytes = 256, .format = FC_RGB565_BE, .depth = depth};
  int error = fc_frame_setup(&frame, &SCENE, &CAMERA(SCENE), NULL, 128, 128, memory, sizeof memory);
  return error == FC_OK ? fc_render_rows_in(&scratch, &frame, 0, 8, &target) : error;
}
