/*
 * How a Pico shares a strip between its cores (src/port/pico/cores.c), with a thread as core 1 and queues as the FIFOs between them: the same
 * pixels, depth codes, primitives and lights as one core gives, for any strips; errors of either half come out. ThreadSanitizer watches.
 * And how core 1 is started (launch.c): the thread is the boot ROM first, as the RP2040 data sheet's 2.8.2 has it, on a bad day.
 */
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "core1.h"
#include "cores.h"
#include "fixcast/fixcast.h"
#include "launch.h"
#include "s1.h"

enum {
  WIDTH = 96,
  HEIGHT = 75, /* odd */
  PIXELS = WIDTH * HEIGHT,
  FIFO_WORDS = 8,
  VECTORS = 0x10000100,
  STACK_END = 0x20001000
};

static int failures;

static void check(int holds, const char *what, unsigned rows) {
  if (holds) return;
  failures++;
  printf("FAIL: %s (strips of %u rows)\n", what, rows);
}

/* ---- what the chip has ---- */

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static struct {
  uint32_t words[FIFO_WORDS];
  unsigned first, count;
} to_core[2];
static pthread_t core1;
static fcp_core1_program *core1_program;
static unsigned launches, resets, restarts, given[2];

static unsigned this_core(void) { return launches != 0 && pthread_equal(pthread_self(), core1) ? 1 : 0; }

void fcp_core_give(uint32_t word) {
  pthread_mutex_lock(&lock);
  {
    const unsigned other = 1 - this_core();
    while (to_core[other].count == FIFO_WORDS) pthread_cond_wait(&changed, &lock);
    to_core[other].words[(to_core[other].first + to_core[other].count++) % FIFO_WORDS] = word;
    given[1 - other]++;
    pthread_cond_broadcast(&changed);
  }
  pthread_mutex_unlock(&lock);
}

uint32_t fcp_core_take(void) {
  uint32_t word;
  pthread_mutex_lock(&lock);
  {
    const unsigned own = this_core();
    while (to_core[own].count == 0) pthread_cond_wait(&changed, &lock);
    word = to_core[own].words[to_core[own].first];
    to_core[own].first = (to_core[own].first + 1) % FIFO_WORDS;
    to_core[own].count--;
    pthread_cond_broadcast(&changed);
  }
  pthread_mutex_unlock(&lock);
  return word;
}

void fcp_core_drop(void) {
  pthread_mutex_lock(&lock);
  to_core[this_core()].count = 0;
  pthread_cond_broadcast(&changed);
  pthread_mutex_unlock(&lock);
}

/* The ROM's loop: 0, 0, 1, then three words that it keeps; what does not fit starts it over. It garbles one answer of its first three rounds. */
static void rom(uint32_t kept[3]) {
  unsigned state = 0, garble[3] = {2, 5, 3};
  while (state < 6) {
    const uint32_t word = fcp_core_take();
    const int fits = state < 2 ? word == 0 : state == 2 ? word == 1
                                                        : 1;
    if (state >= 3) kept[state - 3] = word;
    state = fits ? state + 1 : word == 0 ? 1
                                         : 0;
    if (restarts < 3 && state == garble[restarts]) {
      restarts++;
      state = 0;
      fcp_core_give(word ^ 0x80u);
    } else {
      fcp_core_give(word);
    }
  }
}

static void *run_core1(void *unused) {
  uint32_t kept[3] = {0, 0, 0};
  (void)unused;
  rom(kept);
  check(kept[0] == VECTORS && kept[1] == STACK_END && kept[2] == 0x10000201, "core 1 gets its vectors, stack and code", 0);
  check(restarts == 3, "the launch starts over after each wrong answer", 0);
  core1_program();
  return NULL;
}

void fcp_core1_reset(void) { resets++; }

void fcp_core1_start(fcp_core1_program *program) {
  pthread_mutex_lock(&lock);
  core1_program = program;
  to_core[0].words[0] = 0; /* left from another life: looks like the first answer */
  to_core[0].count = 1;
  if (pthread_create(&core1, NULL, run_core1, NULL) == 0) launches++;
  pthread_mutex_unlock(&lock);
  fcp_launch(VECTORS, STACK_END, 0x10000201);
}

/* ---- the test ---- */

typedef struct picture {
  uint16_t pixels[PIXELS], depth[PIXELS], primitive[PIXELS];
  uint32_t lit[PIXELS];
} picture;

typedef int render(void *context, fc_scratch *scratch, const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target);

static int on_one_core(void *context, fc_scratch *scratch, const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target) {
  (void)context;
  (void)scratch;
  return fc_render_rows(frame, y, rows, target);
}

static int draw(render *how, const fc_frame *frame, unsigned rows, int masks, picture *to) {
  static fc_scratch scratch;
  unsigned y;
  memset(to, 0x5a, sizeof *to);
  for (y = 0; y < HEIGHT; y += rows) {
    const unsigned left = HEIGHT - y, at = y * WIDTH;
    /* clang-format off */
    const fc_target target = {.pixels = to->pixels + at, .pitch_bytes = WIDTH * 2, .format = FC_RGB565_BE, .depth = to->depth + at,
                              .primitive = masks ? to->primitive + at : NULL, .lit = masks ? to->lit + at : NULL};
    /* clang-format on */
    const int error = how(NULL, &scratch, frame, (uint16_t)y, (uint16_t)(left < rows ? left : rows), &target);
    if (error != FC_OK) return error;
  }
  return FC_OK;
}

int main(void) {
  static int64_t memory[64];
  static fc_frame frame;
  static picture one, two;
  static fc_scratch scratch;
  fc_target nowhere = {.pixels = two.pixels, .pitch_bytes = WIDTH * 2, .format = FC_RGB565_BE, .depth = two.depth};
  unsigned rows;
  if (fc_frame_setup(&frame, &s1, &s1_camera, NULL, WIDTH, HEIGHT, memory, sizeof memory) != FC_OK) {
    printf("FAIL: the frame is not set up\n");
    return 1;
  }
  fcp_cores_start();
  check(launches == 1 && resets == 1, "core 1 is started once, from reset", 0);
  for (rows = 1; rows <= HEIGHT; rows++) {
    const int masks = rows % 2 == 0;
    const unsigned before = given[1];
    check(draw(on_one_core, &frame, rows, masks, &one) == FC_OK, "one core draws", rows);
    check(draw(fcp_cores_render, &frame, rows, masks, &two) == FC_OK, "two cores draw", rows);
    check(memcmp(&one, &two, sizeof one) == 0, "two cores draw what one draws", rows);
    check(rows == 1 || given[1] - before == (HEIGHT % rows < 2 ? HEIGHT / rows : HEIGHT / rows + 1),
          "core 1 has drawn part of every strip that can be shared", rows);
  }
  check(fcp_cores_render(NULL, &scratch, &frame, HEIGHT - 1, 2, &nowhere) == FC_ERR_SIZE, "an error of the lower half comes out", 2);
  nowhere.format = 99;
  check(fcp_cores_render(NULL, &scratch, &frame, 0, 2, &nowhere) == FC_ERR_FORMAT, "an error of both halves comes out", 2);
  check(to_core[0].count == 0 && to_core[1].count == 0, "no word is left between the cores", 2);
  printf("%d failures\n", failures);
  return failures != 0;
}
