/* The renderer "fixcast": the core drawing a baked scene, -DSCENE=s1. With -DBY_RAYS the slow definition of a frame. */
#include "fixcast/fixcast.h"
#include "renderer.h"

#define PASTE2(a, b) a##b
#define PASTE(a, b) PASTE2(a, b)
#define CAMERA PASTE(SCENE, _camera)

#ifndef PROFILE
#define PROFILE 0 /* fc_profile */
#endif

#ifdef BY_RAYS
#define RENDER_ROWS fc_render_rows_by_rays
#elif PROFILE == 2 || PROFILE == 3
/* What is measured is one field. */
#define RENDER_ROWS(frame, y, rows, target) fc_render_profile(frame, 0, y, rows, target)
#else
#define RENDER_ROWS(frame, y, rows, target) fc_render_rows_in(&scratch, frame, y, rows, target)
#define USES_SCRATCH
#endif

#ifndef MEMORY_BYTES
#define MEMORY_BYTES 1048576
#endif

extern const fc_scene SCENE;
extern const fc_camera CAMERA;

static int64_t memory[MEMORY_BYTES / 8];
static uint16_t depth[STRIP_ROWS * WIDTH], primitive[STRIP_ROWS * WIDTH];
static fc_frame frame;
static fc_target target;
static fc_options options;
#ifdef USES_SCRATCH
static fc_scratch scratch;
#endif

/* The texts of fc_error_text are not part of what draws a frame: a letter has to do, A for error 1. */
static int checked(int error) {
  if (error < 0) {
    char text[] = "error A\n";
    text[6] = (char)(text[6] - 1 - error);
    bench_put(text);
  }
  return error < 0;
}

#ifndef DUMP
/* Whether the core can do without the primitive numbers; the answer is known before anything is measured. */
static int needs_primitive(void) {
  static uint8_t pixels[WIDTH * PIXEL_BYTES];
  target.pixels = pixels;
  target.primitive = NULL;
  return RENDER_ROWS(&frame, 0, 1, &target) < 0;
}
#endif

size_t renderer_prepare(void) {
  int error = FC_OK;
  size_t bytes = fc_frame_memory(&SCENE, &error);
  if (checked(error) || checked(renderer_setup())) return 0;
#if PROFILE != 0
  options.profile = PROFILE;
#endif
  target.pitch_bytes = WIDTH * PIXEL_BYTES;
  target.format = PIXEL_BYTES == 2 ? FC_RGB565_BE : FC_RGB888;
  target.depth = depth;
  bytes += sizeof frame;
#ifdef USES_SCRATCH
  bytes += sizeof scratch;
#endif
#ifdef DUMP
  target.primitive = primitive;
#else
  if (needs_primitive()) {
    target.primitive = primitive;
    bytes += sizeof primitive;
  }
#endif
  return bytes;
}

int renderer_setup(void) {
  return checked(fc_frame_setup(&frame, &SCENE, &CAMERA, &options, WIDTH, HEIGHT, memory, sizeof memory));
}

int renderer_rows(uint16_t y, uint16_t rows, const strip *to) {
  int error;
  target.pixels = to->pixels;
#ifdef DUMP
  target.lit = to->lit;
#endif
  error = RENDER_ROWS(&frame, y, rows, &target);
#if defined(DUMP) && PROFILE == 3
  /* what is judged is what a panel shows of a still scene: both */
  if (error == FC_OK) error = fc_render_profile(&frame, 1, y, rows, &target);
#endif
#ifdef DUMP
  {
    size_t i;
    for (i = 0; i < (size_t)rows * WIDTH; i++) to->object[i] = fc_object(&frame, primitive[i]);
  }
#endif
  return checked(error);
}
