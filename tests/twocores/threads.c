/*
 * Two threads render alternating strips of one shared frame into one framebuffer: byte for byte what one thread renders, and,
 * built with ThreadSanitizer, without a race.
 *
 * SCENES lists the baked scenes as X(name) ...; compiled with the whole core.
 */
#include <pthread.h>
#include <string.h>

#include "fixcast/fixcast.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  WIDTH = 70,
  HEIGHT = 53,
  PIXELS = WIDTH * HEIGHT,
  WORDS = 20000
};

typedef struct picture {
  uint8_t pixels[PIXELS * 3];
  uint16_t depth[PIXELS], primitive[PIXELS];
  uint32_t lit[PIXELS];
} picture;

typedef struct core {
  const fc_frame *frame;
  picture *to;
  uint16_t first, step, rows;
  int format, error;
} core;

static int64_t memory[WORDS], memory_as_made[WORDS];
static picture alone, together;

static void *draw(void *context) {
  core *c = context;
  const size_t bytes = (size_t)fc_format_bytes(c->format);
  uint16_t y;
  for (y = (uint16_t)(c->first * c->rows); y < HEIGHT && c->error == FC_OK; y = (uint16_t)(y + c->step * c->rows)) {
    const size_t at = (size_t)y * WIDTH;
    fc_target t;
    t.pixels = c->to->pixels + at * bytes;
    t.pitch_bytes = WIDTH * bytes;
    t.format = (uint8_t)c->format;
    t.depth = c->to->depth + at;
    t.primitive = c->to->primitive + at;
    t.lit = c->to->lit + at;
    c->error = fc_render_rows(c->frame, y, (uint16_t)(HEIGHT - y < c->rows ? HEIGHT - y : c->rows), &t);
  }
  return NULL;
}

static void run(const fc_scene *scene, const fc_camera *camera, int format, uint16_t rows, const char *name) {
  fc_frame frame, frame_as_made;
  core cores[2], one = {&frame, &alone, 0, 1, HEIGHT, format, FC_OK};
  pthread_t other;
  TEST_ASSERT_EQUAL_INT_MESSAGE(FC_OK, fc_frame_setup(&frame, scene, camera, NULL, WIDTH, HEIGHT, memory, sizeof memory), name);
  frame_as_made = frame;
  memcpy(memory_as_made, memory, sizeof memory);
  memset(&alone, 0x3c, sizeof alone);
  memset(&together, 0x3c, sizeof together);
  (void)draw(&one);
  cores[0] = cores[1] = one;
  cores[0].to = cores[1].to = &together;
  cores[0].rows = cores[1].rows = rows;
  cores[0].step = cores[1].step = 2;
  cores[1].first = 1;
  TEST_ASSERT_EQUAL_INT(0, pthread_create(&other, NULL, draw, &cores[1]));
  (void)draw(&cores[0]);
  TEST_ASSERT_EQUAL_INT(0, pthread_join(other, NULL));
  TEST_ASSERT_EQUAL_INT_MESSAGE(FC_OK, one.error, name);
  TEST_ASSERT_EQUAL_INT_MESSAGE(FC_OK, cores[0].error, name);
  TEST_ASSERT_EQUAL_INT_MESSAGE(FC_OK, cores[1].error, name);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&alone, &together, sizeof alone, name);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&frame_as_made, &frame, sizeof frame, name);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(memory_as_made, memory, sizeof memory, name);
}

#define X(name) \
  extern const fc_scene name; \
  extern const fc_camera name##_camera;
SCENES
#undef X

static void test_g3_two_threads_draw_one_picture(void) {
#define X(name) \
  run(&name, &name##_camera, FC_RGB565_BE, 8, #name); \
  run(&name, &name##_camera, FC_RGB888, 1, #name);
  SCENES
#undef X
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g3_two_threads_draw_one_picture);
  return UNITY_END();
}
