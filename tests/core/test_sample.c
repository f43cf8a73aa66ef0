/* Several rays a pixel: what strips give, whatever their height; where patterns put rays; what quincunx makes of edges known in closed form. */
#include <string.h>

#include "../../host_sim/scenes/s1.h"
#include "random.h"
#include "sample.h"
#include "shade.h"
#include "unity.h"
#include "vectors.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  WIDTH = 23,
  HEIGHT = 17,
  PIXELS = WIDTH * HEIGHT,
  GUARD = 0xc3,
  SCRATCH_WORDS = 4 * (33 * 33 + WIDTH + 1)
};

static int64_t memory[64];
static fc_frame frame;
static uint32_t scratch[SCRATCH_WORDS + 2];

/* A frame's buffers. */
typedef struct picture {
  uint8_t pixels[PIXELS * 3 + 4];
  uint16_t depth[PIXELS + 2], primitive[PIXELS + 2], samples[PIXELS + 2];
  uint32_t lit[PIXELS + 1];
} picture;

static picture drawn, other;

static void set_up(void) {
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &s1, &s1_camera, NULL, WIDTH, HEIGHT, memory, sizeof memory));
}

static fc_target target_at(picture *p, uint16_t y) {
  fc_target t;
  t.pixels = p->pixels + (size_t)y * WIDTH * 3;
  t.pitch_bytes = 3 * WIDTH;
  t.format = FC_RGB888;
  t.depth = p->depth + (size_t)y * WIDTH;
  t.primitive = p->primitive + (size_t)y * WIDTH;
  t.lit = p->lit + (size_t)y * WIDTH;
  return t;
}

static void draw(picture *p, const fc_sampling *how, uint16_t strip) {
  uint16_t y;
  memset(p, GUARD, sizeof *p);
  for (y = 0; y < HEIGHT; y = (uint16_t)(y + strip)) {
    fc_target t = target_at(p, y);
    uint16_t rows = (uint16_t)(HEIGHT - y < strip ? HEIGHT - y : strip);
    int error = FC_OK;
    size_t bytes = fc_sample_scratch(&frame, how, &error);
    TEST_ASSERT_EQUAL_INT(FC_OK, error);
    TEST_ASSERT_TRUE(bytes <= SCRATCH_WORDS * sizeof scratch[0]);
    memset(scratch, GUARD, sizeof scratch); /* what a strip leaves there helps nobody */
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_sample_rows(&frame, how, y, rows, &t, p->samples + (size_t)y * WIDTH, scratch, bytes));
    TEST_ASSERT_EQUAL_HEX32(UINT32_C(0xc3c3c3c3), scratch[(bytes + 3) / 4]);
  }
}

static fc_sampling sampling_of(const fc_pattern *pattern, uint16_t count) {
  fc_sampling how = FC_SAMPLING_ONE;
  how.pattern = pattern;
  how.count = count;
  return how;
}

static const fc_pattern *const patterns[] = {&fc_pattern_one, &fc_pattern_regular, &fc_pattern_random, &fc_pattern_jittered,
                                             &fc_pattern_quincunx};

static fc_sampling usual(uint8_t pattern) {
  fc_sampling how = sampling_of(patterns[pattern], 3);
  how.depth = 2;
  how.threshold_q15 = 1024;
  return how;
}

/* ---- one ray ---- */

static void test_one_ray_a_pixel_is_the_frame_by_rays(void) {
  fc_sampling how = FC_SAMPLING_ONE;
  fc_target t = target_at(&other, 0);
  uint8_t tent;
  size_t i;
  set_up();
  memset(&other, GUARD, sizeof other);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows_by_rays(&frame, 0, HEIGHT, &t));
  for (tent = 0; tent < 4; tent++) {
    how.pattern = tent & 2 ? &fc_pattern_regular : &fc_pattern_one;
    how.count = 1;
    how.filter = tent & 1;
    draw(&drawn, &how, 5);
    TEST_ASSERT_EQUAL_MEMORY(other.pixels, drawn.pixels, sizeof drawn.pixels);
    TEST_ASSERT_EQUAL_MEMORY(other.depth, drawn.depth, sizeof drawn.depth);
    TEST_ASSERT_EQUAL_MEMORY(other.primitive, drawn.primitive, sizeof drawn.primitive);
    TEST_ASSERT_EQUAL_MEMORY(other.lit, drawn.lit, sizeof drawn.lit);
    for (i = 0; i < PIXELS; i++) TEST_ASSERT_EQUAL_UINT16(1, drawn.samples[i]);
  }
}

static void test_depth_primitive_and_lit_are_the_centres_whatever_the_pattern(void) {
  fc_target t = target_at(&other, 0);
  uint8_t i;
  set_up();
  memset(&other, GUARD, sizeof other);
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_render_rows_by_rays(&frame, 0, HEIGHT, &t));
  for (i = 0; i < 10; i++) {
    fc_sampling how = usual(i % 5);
    if (i >= 5) how.count = 2; /* no ray at the centre */
    draw(&drawn, &how, HEIGHT);
    TEST_ASSERT_EQUAL_MEMORY(other.depth, drawn.depth, sizeof drawn.depth);
    TEST_ASSERT_EQUAL_MEMORY(other.primitive, drawn.primitive, sizeof drawn.primitive);
    TEST_ASSERT_EQUAL_MEMORY(other.lit, drawn.lit, sizeof drawn.lit);
  }
}

/* ---- strips ---- */

static void test_g2_strips_of_any_height_give_the_same_bits(void) {
  uint8_t i, tent;
  uint16_t strip;
  set_up();
  for (i = 0; i < 5; i++)
    for (tent = 0; tent < 2; tent++) {
      fc_sampling how = usual(i);
      if (tent == 1 && i == 4) continue;
      how.filter = tent;
      draw(&other, &how, HEIGHT);
      for (strip = 1; strip < HEIGHT; strip = (uint16_t)(strip * 2 + 1)) {
        draw(&drawn, &how, strip);
        TEST_ASSERT_EQUAL_MEMORY(&other, &drawn, sizeof drawn); /* what is behind the buffers too */
      }
    }
}

static void test_depth_primitive_lit_and_samples_may_be_left_out(void) {
  uint8_t i, without;
  set_up();
  for (i = 0; i < 5; i++) {
    fc_sampling how = usual(i);
    draw(&other, &how, HEIGHT);
    for (without = 0; without < 16; without++) {
      fc_target t = target_at(&drawn, 0);
      memset(&drawn, GUARD, sizeof drawn);
      if (without & 1) t.depth = NULL;
      if (without & 2) t.primitive = NULL;
      if (without & 4) t.lit = NULL;
      TEST_ASSERT_EQUAL_INT(FC_OK, fc_sample_rows(&frame, &how, 0, HEIGHT, &t, without & 8 ? NULL : drawn.samples, scratch,
                                                  fc_sample_scratch(&frame, &how, NULL)));
      TEST_ASSERT_EQUAL_MEMORY(other.pixels, drawn.pixels, sizeof drawn.pixels);
      TEST_ASSERT_EQUAL_HEX16(without & 1 ? 0xc3c3 : other.depth[7], drawn.depth[7]);
      TEST_ASSERT_EQUAL_HEX16(without & 2 ? 0xc3c3 : other.primitive[7], drawn.primitive[7]);
      TEST_ASSERT_EQUAL_HEX32(without & 4 ? UINT32_C(0xc3c3c3c3) : other.lit[7], drawn.lit[7]);
      TEST_ASSERT_EQUAL_HEX16(without & 8 ? 0xc3c3 : other.samples[7], drawn.samples[7]);
    }
  }
}

/* ---- errors ---- */

static int try_it(const fc_sampling *how) {
  fc_target t = target_at(&drawn, 0);
  int error = FC_OK, asked;
  size_t bytes = fc_sample_scratch(&frame, how, &error);
  asked = fc_sample_rows(&frame, how, 0, 1, &t, NULL, scratch, sizeof scratch);
  TEST_ASSERT_EQUAL_INT(error, asked);
  if (error != FC_OK) TEST_ASSERT_EQUAL_INT(0, (int)bytes);
  return error;
}

static void test_g6_bad_arguments_are_refused_and_nothing_is_written(void) {
  fc_sampling how;
  fc_target t;
  size_t bytes, i;
  set_up();
  memset(&drawn, GUARD, sizeof drawn);
  how = sampling_of(NULL, 1);
  TEST_ASSERT_EQUAL_INT(FC_ERR_SAMPLING, try_it(&how));
  how = sampling_of(&fc_pattern_regular, 0);
  TEST_ASSERT_EQUAL_INT(FC_ERR_SAMPLING, try_it(&how));
  how.count = FC_SAMPLE_SIDE_MAX + 1;
  TEST_ASSERT_EQUAL_INT(FC_ERR_SAMPLING, try_it(&how));
  how = sampling_of(&fc_pattern_jittered, 0);
  TEST_ASSERT_EQUAL_INT(FC_ERR_SAMPLING, try_it(&how));
  how.count = FC_SAMPLE_SIDE_MAX + 1;
  TEST_ASSERT_EQUAL_INT(FC_ERR_SAMPLING, try_it(&how));
  how = sampling_of(&fc_pattern_random, 0);
  TEST_ASSERT_EQUAL_INT(FC_ERR_SAMPLING, try_it(&how));
  how.count = FC_SAMPLE_COUNT_MAX + 1;
  TEST_ASSERT_EQUAL_INT(FC_ERR_SAMPLING, try_it(&how));
  how = usual(4);
  how.depth = FC_QUINCUNX_DEPTH_MAX + 1;
  TEST_ASSERT_EQUAL_INT(FC_ERR_SAMPLING, try_it(&how));
  how = usual(4);
  how.threshold_q15 = FC_ONE_Q15 + 1;
  TEST_ASSERT_EQUAL_INT(FC_ERR_SAMPLING, try_it(&how));
  how = usual(4);
  how.filter = FC_FILTER_TENT;
  TEST_ASSERT_EQUAL_INT(FC_ERR_SAMPLING, try_it(&how));
  how = usual(1);
  how.filter = FC_FILTER_TENT + 1;
  TEST_ASSERT_EQUAL_INT(FC_ERR_SAMPLING, try_it(&how));
  how = usual(0);
  how.lens.kind = NULL;
  TEST_ASSERT_EQUAL_INT(FC_ERR_LENS, try_it(&how));

  how = usual(4);
  t = target_at(&drawn, 0);
  bytes = fc_sample_scratch(&frame, &how, NULL);
  TEST_ASSERT_TRUE(bytes > 0 && bytes <= 16 * (WIDTH + 1) + 16 * 25);
  TEST_ASSERT_EQUAL_INT(FC_ERR_MEMORY, fc_sample_rows(&frame, &how, 0, 1, &t, NULL, NULL, 0));
  TEST_ASSERT_EQUAL_INT(FC_ERR_MEMORY, fc_sample_rows(&frame, &how, 0, 1, &t, NULL, scratch, bytes - 1));
#ifndef __AVR__
  TEST_ASSERT_EQUAL_INT(FC_ERR_MEMORY, fc_sample_rows(&frame, &how, 0, 1, &t, NULL, (char *)scratch + 1, bytes));
#endif
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_sample_rows(NULL, &how, 0, 1, &t, NULL, scratch, bytes));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_sample_rows(&frame, NULL, 0, 1, &t, NULL, scratch, bytes));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_sample_rows(&frame, &how, 0, 1, NULL, NULL, scratch, bytes));
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_sample_rows(&frame, &how, HEIGHT, 1, &t, NULL, scratch, bytes));
  TEST_ASSERT_EQUAL_INT(FC_ERR_SIZE, fc_sample_rows(&frame, &how, 1, HEIGHT, &t, NULL, scratch, bytes));
  t.pixels = NULL;
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_sample_rows(&frame, &how, 0, 1, &t, NULL, scratch, bytes));
  t = target_at(&drawn, 0);
  t.format = 7;
  TEST_ASSERT_EQUAL_INT(FC_ERR_FORMAT, fc_sample_rows(&frame, &how, 0, 1, &t, NULL, scratch, bytes));
  for (i = 0; i < sizeof drawn.pixels; i++) TEST_ASSERT_EQUAL_HEX8(GUARD, drawn.pixels[i]);

  how = sampling_of(&fc_pattern_regular, FC_SAMPLE_SIDE_MAX);
  TEST_ASSERT_EQUAL_INT(FC_OK, try_it(&how));
  how = sampling_of(&fc_pattern_random, FC_SAMPLE_COUNT_MAX);
  TEST_ASSERT_EQUAL_INT(FC_OK, try_it(&how));
  how = usual(4);
  how.depth = FC_QUINCUNX_DEPTH_MAX;
  how.threshold_q15 = FC_ONE_Q15;
  TEST_ASSERT_EQUAL_INT(FC_OK, try_it(&how));
}

/* ---- where rays go: asked of a lens of the test's own, which notes places and answers in its own colours ---- */

enum {
  PLACES = 1024
};
static int32_t places[PLACES][2];
static uint32_t place_count;
static uint32_t kept_from, kept_step;  /* ray kept_from + i kept_step is places[i] */
static int32_t edge_a, edge_b, edge_c; /* the half plane a x + b y < c is seen as an object, the rest is not; Q16 */

/* The ray of the object, or none: what is seen there is then the background. */
static bool note_ray(const fc_lens_state *state, const fc_frame *of, const int32_t place_q16[2], int64_t origin[3], int64_t direction[3]) {
  (void)state;
  (void)of;
  if (place_count >= kept_from && (place_count - kept_from) % kept_step == 0 && (place_count - kept_from) / kept_step < PLACES) {
    int32_t *to = places[(place_count - kept_from) / kept_step];
    to[0] = place_q16[0];
    to[1] = place_q16[1];
  }
  place_count++;
  origin[0] = origin[1] = origin[2] = 0;
  direction[0] = direction[1] = 0;
  direction[2] = 1 << 20;
  return (int64_t)edge_a * place_q16[0] + (int64_t)edge_b * place_q16[1] < (int64_t)edge_c * 65536;
}

static int note_prepare(fc_lens_state *state, fc_frame *of, const void *data) {
  (void)state;
  (void)of;
  (void)data;
  return FC_OK;
}

static const fc_lens_kind note_lens FC_ROM = {note_prepare, note_ray};

/* A white wall in front of the eye, on black: coverage is brightness. */
static const fc_rgb white_light = FC_WHITE;
static fc_emission glow;
static fc_layer glow_layer;
static fc_material wall_material;
static const fc_plane wall[] FC_ROM = {{.normal = {0, 0, 1}, .d = FC_Q16(10), .material = 0, .object = 7}};
static const fc_shapes wall_shapes[] FC_ROM = {FC_PLANES(wall)};

static void set_up_wall(void) {
  fc_scene scene;
  memset(&scene, 0, sizeof scene);
  memset(&wall_material, 0, sizeof wall_material);
  glow.light = white_light;
  glow_layer.kind = &fc_layer_emission;
  glow_layer.data = &glow;
  wall_material.layers = &glow_layer;
  wall_material.layer_count = 1;
  scene.shapes = wall_shapes;
  scene.shape_count = 1;
  scene.materials = &wall_material;
  scene.material_count = 1;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &s1_camera, NULL, WIDTH, HEIGHT, memory, sizeof memory));
}

/* Samples row y, colours and `samples` (or NULL) only, and notes its places from ray `from` on, every `step`-th. */
static uint8_t row_pixels[3 * WIDTH];
static void sample_row(fc_sampling how, uint16_t y, uint32_t from, uint32_t step, uint16_t *samples) {
  fc_target t;
  memset(&t, 0, sizeof t);
  t.pixels = row_pixels;
  t.pitch_bytes = sizeof row_pixels;
  how.lens.kind = &note_lens;
  place_count = 0;
  kept_from = from;
  kept_step = step;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_sample_rows(&frame, &how, y, 1, &t, samples, scratch, sizeof scratch));
}

/* The places of pixel (x, y), `rays` in number, from its upper left corner. */
static void ask(fc_sampling how, uint32_t rays, uint16_t x, uint16_t y) {
  uint32_t i;
  TEST_ASSERT_TRUE(rays <= PLACES);
  sample_row(how, y, x * rays, 1, NULL);
  TEST_ASSERT_EQUAL_UINT32(rays * WIDTH, place_count);
  for (i = 0; i < rays; i++) {
    places[i][0] -= x * INT32_C(65536);
    places[i][1] -= y * INT32_C(65536);
  }
}

static void nothing_there(void) {
  edge_a = edge_b = edge_c = 0;
}

static void test_regular_places_are_the_centres_of_cells(void) {
  uint16_t n;
  set_up_wall();
  nothing_there();
  for (n = 1; n <= 25; n++) {
    const uint32_t count = (uint32_t)n * n;
    uint32_t i;
    ask(sampling_of(&fc_pattern_regular, n), count, 3, 5);
    for (i = 0; i < count; i++) {
      uint8_t j;
      for (j = 0; j < 2; j++) {
        /* (cell + 1/2) / n, times n and 2: an odd number of 65536ths, within the rounding */
        int32_t cell = (int32_t)(j == 0 ? i % n : i / n), off = places[i][j] * 2 * n - (2 * cell + 1) * INT32_C(65536);
        TEST_ASSERT_TRUE(off <= 0 && off > -2 * n);
      }
    }
  }
}

static void test_jittered_places_are_one_in_each_cell_and_differ_by_pixel_and_seed(void) {
  uint16_t n;
  set_up_wall();
  nothing_there();
  for (n = 1; n <= 16; n++) {
    uint8_t cells[256], seed;
    for (seed = 0; seed < 3; seed++) {
      fc_sampling how = sampling_of(&fc_pattern_jittered, n);
      const uint32_t count = (uint32_t)n * n;
      uint32_t i;
      int32_t first[2];
      how.seed = seed;
      memset(cells, 0, sizeof cells);
      ask(how, count, 3, 5);
      for (i = 0; i < count; i++) {
        TEST_ASSERT_TRUE(places[i][0] >= 0 && places[i][0] < 65536 && places[i][1] >= 0 && places[i][1] < 65536);
        /* the place is rounded down; its cell is that of the place's upper end */
        cells[((places[i][1] + 1) * n - 1) / 65536 * n + ((places[i][0] + 1) * n - 1) / 65536]++;
      }
      for (i = 0; i < count; i++) TEST_ASSERT_EQUAL_UINT8(1, cells[i]);
      first[0] = places[0][0];
      first[1] = places[0][1];
      ask(how, count, 4, 5);
      TEST_ASSERT_TRUE(places[0][0] != first[0] || places[0][1] != first[1]);
      ask(how, count, 3, 6);
      TEST_ASSERT_TRUE(places[0][0] != first[0] || places[0][1] != first[1]);
      how.seed++;
      ask(how, count, 3, 5);
      TEST_ASSERT_TRUE(places[0][0] != first[0] || places[0][1] != first[1]);
    }
  }
}

/* Chi squared of `count` things in `cells` cells, times count: sum (cells n_i - count)^2 / cells. */
static uint32_t chi_squared(const uint32_t *counts, uint32_t cells, uint32_t count) {
  uint64_t sum = 0;
  uint32_t i;
  for (i = 0; i < cells; i++) {
    int64_t d = (int64_t)counts[i] * cells - count;
    sum += (uint64_t)(d * d);
  }
  return (uint32_t)(sum / cells / count);
}

static void test_random_places_are_uniform_in_the_pixel_over_samples_over_pixels_and_over_seeds(void) {
  /* 16 x 16 cells, 255 degrees of freedom: chi squared within 255 +- 5 sqrt(510) */
  uint32_t counts[256], i, count;
  uint16_t k, x, y;
  fc_sampling how = sampling_of(&fc_pattern_random, 800);
  set_up_wall();
  nothing_there();
  for (k = 0; k < 5; k++) {
    memset(counts, 0, sizeof counts);
    how.seed = k;
    count = 800;
    ask(how, count, k, 5);
    for (i = 0; i < count; i++) counts[(places[i][1] >> 12) * 16 + (places[i][0] >> 12)]++;
    TEST_ASSERT_TRUE(chi_squared(counts, 256, count) > 142 && chi_squared(counts, 256, count) < 368);
  }
  /* the first place of pixels in a row and column, and of seeds in a row */
  how.count = 1;
  for (k = 0; k < 2; k++) {
    memset(counts, 0, sizeof counts);
    count = 0;
    for (i = 0; i < (k == 0 ? 10u : 20u); i++)
      for (y = 0; y < (k == 0 ? HEIGHT : 10); y++) {
        how.seed = k == 0 ? 12345 + 77 * i : i * 10 + y;
        sample_row(how, k == 0 ? y : 3, 0, 1, NULL);
        for (x = 0; x < WIDTH; x++, count++)
          counts[((places[x][1] & 0xffff) >> 12) * 16 + ((places[x][0] & 0xffff) >> 12)]++;
      }
    TEST_ASSERT_TRUE(chi_squared(counts, 256, count) > 142 && chi_squared(counts, 256, count) < 368);
  }
}

/* Star discrepancy by its definition, over the boxes that end at places: the greatest difference of share and area, Q16. */
static uint32_t discrepancy(uint32_t count) {
  uint32_t i, j, k, worst = 0;
  for (i = 0; i < count; i++)
    for (j = 0; j < count; j++) {
      int64_t area = (int64_t)places[i][0] * places[j][1] / 65536, open = 0, closed = 0, d;
      for (k = 0; k < count; k++) {
        open += places[k][0] < places[i][0] && places[k][1] < places[j][1];
        closed += places[k][0] <= places[i][0] && places[k][1] <= places[j][1];
      }
      d = area - open * 65536 / count;
      if (d > worst) worst = (uint32_t)d;
      d = closed * 65536 / count - area;
      if (d > worst) worst = (uint32_t)d;
    }
  return worst;
}

static void test_jittered_places_are_spread_more_evenly_than_random_ones(void) {
  /* 64 places, the mean of 20 pixels */
  uint32_t jittered = 0, random = 0;
  uint16_t x;
  set_up_wall();
  nothing_there();
  for (x = 0; x < 20; x++) {
    ask(sampling_of(&fc_pattern_jittered, 8), 64, x, 2);
    jittered += discrepancy(64);
    ask(sampling_of(&fc_pattern_random, 64), 64, x, 2);
    random += discrepancy(64);
  }
  /* the literature's orders: n^-3/4 against n^-1/2; here about 0.064 against 0.14 */
  TEST_ASSERT_TRUE(jittered * 3 < random * 2);
  TEST_ASSERT_TRUE(random / 20 < 65536 / 4);
}

static void test_tent_places_have_the_density_of_a_tent(void) {
  /* In each sixteenth of -1..1 pixel around the centre: the integral of 1 - |v|, in 512ths 2 k + 1 up to 15 and down again. */
  uint32_t counts[16], i, across;
  fc_sampling how = sampling_of(&fc_pattern_regular, 64);
  set_up_wall();
  nothing_there();
  how.filter = FC_FILTER_TENT;
  for (across = 0; across < 2; across++) {
    memset(counts, 0, sizeof counts);
    sample_row(how, 0, 0, across == 0 ? 1 : 64, NULL); /* a row and a column of the first pixel's 64 x 64 */
    for (i = 0; i < 64; i++) {
      int32_t from = places[i][across] + 32768;
      TEST_ASSERT_TRUE(from >= 0 && from < 131072);
      counts[from >> 13]++;
    }
    for (i = 0; i < 16; i++) {
      int32_t share = (int32_t)(i < 8 ? 2 * i + 1 : 31 - 2 * i); /* of 128 */
      int32_t off = (int32_t)counts[i] * 2 - share;
      TEST_ASSERT_TRUE(off >= -2 && off <= 2); /* one place more or less at each border */
    }
  }
}

/* ---- quincunx ---- */

/* The brightness of pixel (x, y), 0..255, and its rays. */
static uint8_t brightness(uint8_t depth, uint16_t threshold, uint16_t x, uint16_t y, uint16_t *rays) {
  static uint16_t samples[WIDTH];
  fc_sampling how = sampling_of(&fc_pattern_quincunx, 0);
  how.depth = depth;
  how.threshold_q15 = threshold;
  sample_row(how, y, 0, 1, samples);
  *rays = samples[x];
  TEST_ASSERT_EQUAL_UINT8(row_pixels[3 * x], row_pixels[3 * x + 2]);
  return row_pixels[3 * x];
}

static void test_quincunx_weights_sum_to_one_at_every_depth(void) {
  /* all white gives white, all black black, and so does the finest mixture that can be thought of: nothing but the wall */
  uint8_t depth;
  uint16_t rays;
  set_up_wall();
  for (depth = 0; depth <= FC_QUINCUNX_DEPTH_MAX; depth++) {
    edge_a = edge_b = 0;
    edge_c = 1;
    TEST_ASSERT_EQUAL_UINT8(255, brightness(depth, 0, 3, 5, &rays));
    TEST_ASSERT_EQUAL_UINT16(2, rays);
    nothing_there();
    TEST_ASSERT_EQUAL_UINT8(0, brightness(depth, 0, 3, 5, &rays));
    TEST_ASSERT_EQUAL_UINT16(2, rays);
  }
}

/* The lecture's rule as it is written there, recursive and without memory: rays by place, weights as areas. Places and sides in 1/64 pixels,
 * areas in 1 / (8 4^depth) of the square. */
static uint32_t by_the_lecture(int32_t x, int32_t y, int32_t side, uint8_t depth, uint32_t *rays) {
  static const int8_t corner[4][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  const bool centre = edge_a * (x + side / 2) + edge_b * (y + side / 2) < 64 * edge_c;
  uint32_t sum = 0;
  uint8_t i;
  for (i = 0; i < 4; i++) {
    const bool at = edge_a * (x + side * corner[i][0]) + edge_b * (y + side * corner[i][1]) < 64 * edge_c;
    if (at == centre || depth == 0)
      sum += (uint32_t)(at + centre) << (2 * depth); /* an eighth each */
    else
      sum += by_the_lecture(x + side / 2 * corner[i][0], y + side / 2 * corner[i][1], side / 2, (uint8_t)(depth - 1), rays);
  }
  (*rays)++;
  return sum;
}

static void test_quincunx_is_the_lectures_rule_on_edges_of_any_slope(void) {
  uint16_t trial, rays;
  set_up_wall();
  for (trial = 0; trial < 400; trial++) {
    uint8_t depth = (uint8_t)(trial % (FC_QUINCUNX_DEPTH_MAX + 1)), level;
    uint16_t x = (uint16_t)random_within(0, WIDTH - 2), y = (uint16_t)random_within(0, HEIGHT - 2);
    uint32_t centres = 0;
    uint32_t covered;
    int32_t whole, off;
    edge_a = random_within(-300, 300);
    edge_b = random_within(-300, 300);
    /* through the pixel */
    edge_c = (int32_t)((edge_a * (x * 8 + random_within(0, 8)) + edge_b * (y * 8 + random_within(0, 8))) / 8);
    level = brightness(depth, 0, x, y, &rays);
    covered = by_the_lecture(64 * x, 64 * y, 64, depth, &centres);
    whole = INT32_C(8) << (2 * depth);
    off = 2 * (level * whole - 255 * (int32_t)covered); /* twice: half a level of rounding */
    TEST_ASSERT_TRUE(off <= whole && off >= -whole);
    /* every square has a centre of its own, and all but the first at most two corners that are not yet there */
    TEST_ASSERT_TRUE(rays >= 1 + centres && rays <= 1 + centres + 2 * (centres - 1));
  }
}

static void test_quincunx_converges_to_the_covered_area_of_a_vertical_edge(void) {
  /* the edge at k / 16 of pixel 4: covered k / 16; each halving halves the strip that is in doubt */
  uint16_t k, rays, last = 0;
  uint8_t depth;
  set_up_wall();
  for (k = 1; k < 16; k++) {
    edge_a = 16;
    edge_b = 0;
    edge_c = 16 * 4 + k;
    for (depth = 1; depth <= FC_QUINCUNX_DEPTH_MAX; depth++) {
      int32_t off = brightness(depth, 0, 4, 7, &rays) * 16 - k * 255, most = 255 * 16 / 4 >> depth;
      TEST_ASSERT_TRUE(off <= most + 16 && off >= -most - 16);
      if (depth > 1) TEST_ASSERT_TRUE(rays >= last);
      last = rays;
    }
  }
}

static void test_quincunx_asks_for_no_place_of_a_row_twice(void) {
  /* a row of pixels that the edge crosses: squares share corners within a pixel and with the next */
  uint16_t rays;
  uint32_t i, j;
  set_up_wall();
  edge_a = 3;
  edge_b = 7;
  edge_c = 70;
  (void)brightness(2, 0, 0, 5, &rays);
  TEST_ASSERT_TRUE(place_count > 4 * WIDTH && place_count <= PLACES);
  for (i = 0; i < place_count; i++)
    for (j = 0; j < i; j++)
      TEST_ASSERT_FALSE(places[i][0] == places[j][0] && places[i][1] == places[j][1]);
}

static void test_quincunx_counts_each_ray_of_the_frame_once(void) {
  fc_sampling how = usual(4);
  uint32_t sum = 0, i;
  fc_target t = target_at(&drawn, 0);
  set_up_wall();
  edge_a = 3;
  edge_b = 7;
  edge_c = 70;
  how.lens.kind = &note_lens;
  place_count = 0;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_sample_rows(&frame, &how, 0, HEIGHT, &t, drawn.samples, scratch, sizeof scratch));
  for (i = 0; i < PIXELS; i++) sum += drawn.samples[i];
  TEST_ASSERT_EQUAL_UINT32(place_count, sum);
}

static void test_quincunx_halves_where_colours_differ_by_more_than_the_threshold(void) {
  /* s1: a higher threshold never asks for more rays, and somewhere for fewer */
  uint32_t last = UINT32_MAX;
  static const uint16_t thresholds[] = {0, 64, 256, 1024, 4096, FC_ONE_Q15};
  uint8_t k;
  set_up();
  for (k = 0; k < 6; k++) {
    fc_sampling how = usual(4);
    uint32_t sum = 0, i;
    how.threshold_q15 = thresholds[k];
    draw(&drawn, &how, 4);
    for (i = 0; i < PIXELS; i++) sum += drawn.samples[i];
    TEST_ASSERT_TRUE(sum < last);
    last = sum;
  }
  TEST_ASSERT_TRUE(last > 2 * PIXELS + 100); /* objects differ whatever the threshold */
}

/* ---- radiance ---- */

static void test_a_pixel_is_the_mean_of_single_rays_shaded_alone(void) {
  /* Rays through sub-pixels are rays through the pixels of a larger frame: 5 x 5 of each by a frame five times as large. */
  enum {
    N = 5
  };
  static fc_frame large;
  static int64_t large_memory[64];
  fc_sampling how = sampling_of(&fc_pattern_regular, N);
  fc_space space;
  uint16_t x, y, i, j;
  uint8_t k;
  set_up();
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&large, &s1, &s1_camera, NULL, WIDTH * N, HEIGHT * N, large_memory, sizeof large_memory));
  space = fc_space_of_frame(&large);
  draw(&drawn, &how, 6);
  for (y = 0; y < HEIGHT; y++)
    for (x = 0; x < WIDTH; x++) {
      uint64_t sum[3] = {0, 0, 0};
      for (i = 0; i < N * N; i++) {
        static const int64_t origin[3] = {0, 0, 0};
        int64_t direction[3];
        uint64_t radiance[3];
        uint32_t lit;
        uint16_t nearest;
        fc_surface surface;
        direction[0] = (2 * (x * N + i % N) + 1 - WIDTH * N) * (INT64_C(1) << large.view.pixel_shift);
        direction[1] = (HEIGHT * N - 2 * (y * N + i / N) - 1) * (INT64_C(1) << large.view.pixel_shift);
        direction[2] = large.view.focal;
        nearest = fc_space_nearest(&space, origin, direction, 0, UINT64_MAX, NULL);
        fc_shade_background(&large, direction, radiance);
        if (nearest != 0xffff && fc_surface_meet(&surface, &space, nearest, origin, direction)) {
          /* s1's far limit: 100 units, by hand: t |d| in world units */
          uint64_t square = 0;
          fc_surface_complete(&surface);
          /* the distance's square in 2^-8 units of the world: a coordinate of 100 units has 15 bits there */
          for (j = 0; j < 3; j++) {
            int64_t v = surface.point[j] / (INT64_C(1) << (8 - large.view.shift));
            square += (uint64_t)(v * v);
          }
          if (square < UINT64_C(100) * 256 * 100 * 256) fc_shade(&large, &space, &surface, radiance, &lit);
        }
        for (k = 0; k < 3; k++) sum[k] += radiance[k];
      }
      for (k = 0; k < 3; k++) {
        /* in 1/100 of a level; half a level of rounding, and places that are rounded down by 2^-16 pixels */
        int32_t level = (int32_t)(((sum[k] / (N * N)) >> 9) * 25500 >> 30), got = 100 * drawn.pixels[(y * WIDTH + x) * 3 + k];
        if (level > 25500) level = 25500;
        TEST_ASSERT_TRUE(got - level <= 52 && level - got <= 52);
      }
    }
}

/* ---- every machine ---- */

/* FNV-1a of bytes, and of numbers whatever their byte order */
static uint32_t hash_of_bytes(const uint8_t *bytes, size_t count) {
  uint32_t hash = UINT32_C(2166136261);
  while (count-- > 0) hash = (hash ^ *bytes++) * UINT32_C(16777619);
  return hash;
}

static uint32_t hash_of_numbers(const uint16_t *numbers, size_t count) {
  uint32_t hash = UINT32_C(2166136261);
  while (count-- > 0) hash = (hash ^ *numbers++) * UINT32_C(16777619);
  return hash;
}

static void test_g2_sampled_frames_have_the_same_bits_everywhere(void) {
  /* Recorded on x86-64; what they should be, the other tests and sampling_lens say. */
  static const struct expected {
    uint8_t pattern, lens, filter;
    uint32_t pixels, depth, samples;
  } expected[] = {
      {1, 0, 1, UINT32_C(0x88d25651), UINT32_C(0xeaa9db89), UINT32_C(0x31635806)},
      {2, 0, 0, UINT32_C(0xd8b1ebdd), UINT32_C(0xeaa9db89), UINT32_C(0xef8751bc)},
      {3, 0, 0, UINT32_C(0x4cece75e), UINT32_C(0xeaa9db89), UINT32_C(0x31635806)},
      {3, 0, 1, UINT32_C(0x203b7972), UINT32_C(0xeaa9db89), UINT32_C(0x31635806)},
      {4, 0, 0, UINT32_C(0x58f01b1c), UINT32_C(0xeaa9db89), UINT32_C(0x44ad86ad)},
      {4, 1, 0, UINT32_C(0x72f2602d), UINT32_C(0x86f87c91), UINT32_C(0xa7e12495)},
      {4, 2, 0, UINT32_C(0x34f2a290), UINT32_C(0xcf340acf), UINT32_C(0x31daacba)},
      {4, 3, 0, UINT32_C(0x5275fe1e), UINT32_C(0x686d1df1), UINT32_C(0xab76f3a8)},
      {2, 1, 1, UINT32_C(0x1a1530a6), UINT32_C(0x86f87c91), UINT32_C(0xef8751bc)},
      {1, 2, 0, UINT32_C(0xa02e4606), UINT32_C(0xcf340acf), UINT32_C(0x31635806)},
      {3, 3, 1, UINT32_C(0x0bee3087), UINT32_C(0x686d1df1), UINT32_C(0x31635806)},
  };
  static const fc_lens_kind *const lenses[] = {&fc_lens_pinhole, &fc_lens_orthographic, &fc_lens_fisheye, &fc_lens_panorama};
  const fc_orthographic span = {FC_Q16(5), 0};
  const fc_fisheye fisheye = {40000};
  size_t i;
  set_up();
  for (i = 0; i < sizeof expected / sizeof expected[0]; i++) {
    const struct expected *e = &expected[i];
    fc_sampling how = usual(e->pattern);
    how.lens.kind = lenses[e->lens];
    how.lens.data = e->lens == 1 ? (const void *)&span : &fisheye;
    how.filter = e->filter;
    how.seed = 7;
    draw(&drawn, &how, 6);
    TEST_ASSERT_EQUAL_HEX32(e->pixels, hash_of_bytes(drawn.pixels, PIXELS * 3));
    TEST_ASSERT_EQUAL_HEX32(e->depth, hash_of_numbers(drawn.depth, PIXELS));
    TEST_ASSERT_EQUAL_HEX32(e->samples, hash_of_numbers(drawn.samples, PIXELS));
  }
}

/* The span of what a pinhole sees at its target's distance, here 2 * 4 * 3 / 6; what is no camera is refused. */
static void test_orthographic_span_of_a_camera(void) {
  /* clang-format off */
  const fc_camera right = {.eye = FC_VEC3(1, 2, 7), .target = FC_VEC3(1, 2, 3), .up = {0, 1, 0}, .tan_half_fov_numerator = 3,
                           .tan_half_fov_denominator = 6};
  /* clang-format on */
  fc_orthographic lens;
  fc_camera camera = right;
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_orthographic_of_camera(&lens, &camera));
  TEST_ASSERT_TRUE(lens.span_exponent <= 0);
  TEST_ASSERT_EQUAL_INT32(FC_Q16(4), lens.span >> -lens.span_exponent);
  TEST_ASSERT_EQUAL_INT32(lens.span, (lens.span >> -lens.span_exponent) * (INT32_C(1) << -lens.span_exponent));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_orthographic_of_camera(NULL, &camera));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_orthographic_of_camera(&lens, NULL));
  camera.eye.x = FC_COORDINATE_MAX + 1;
  TEST_ASSERT_EQUAL_INT(FC_ERR_COORDINATE, fc_orthographic_of_camera(&lens, &camera));
  camera = right;
  camera.target.y = -FC_COORDINATE_MAX - 1;
  TEST_ASSERT_EQUAL_INT(FC_ERR_COORDINATE, fc_orthographic_of_camera(&lens, &camera));
  camera = right;
  camera.exponent = 32;
  TEST_ASSERT_EQUAL_INT(FC_ERR_EXPONENT, fc_orthographic_of_camera(&lens, &camera));
  camera = right;
  camera.target = camera.eye;
  TEST_ASSERT_EQUAL_INT(FC_ERR_CAMERA_TARGET, fc_orthographic_of_camera(&lens, &camera));
  camera = right;
  camera.tan_half_fov_denominator = 0;
  TEST_ASSERT_EQUAL_INT(FC_ERR_FIELD_OF_VIEW, fc_orthographic_of_camera(&lens, &camera));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_one_ray_a_pixel_is_the_frame_by_rays);
  RUN_TEST(test_depth_primitive_and_lit_are_the_centres_whatever_the_pattern);
  RUN_TEST(test_g2_strips_of_any_height_give_the_same_bits);
  RUN_TEST(test_depth_primitive_lit_and_samples_may_be_left_out);
  RUN_TEST(test_g6_bad_arguments_are_refused_and_nothing_is_written);
  RUN_TEST(test_regular_places_are_the_centres_of_cells);
  RUN_TEST(test_jittered_places_are_one_in_each_cell_and_differ_by_pixel_and_seed);
  RUN_TEST(test_random_places_are_uniform_in_the_pixel_over_samples_over_pixels_and_over_seeds);
  RUN_TEST(test_jittered_places_are_spread_more_evenly_than_random_ones);
  RUN_TEST(test_tent_places_have_the_density_of_a_tent);
  RUN_TEST(test_quincunx_weights_sum_to_one_at_every_depth);
  RUN_TEST(test_quincunx_is_the_lectures_rule_on_edges_of_any_slope);
  RUN_TEST(test_quincunx_converges_to_the_covered_area_of_a_vertical_edge);
  RUN_TEST(test_quincunx_asks_for_no_place_of_a_row_twice);
  RUN_TEST(test_quincunx_counts_each_ray_of_the_frame_once);
  RUN_TEST(test_quincunx_halves_where_colours_differ_by_more_than_the_threshold);
  RUN_TEST(test_a_pixel_is_the_mean_of_single_rays_shaded_alone);
  RUN_TEST(test_g2_sampled_frames_have_the_same_bits_everywhere);
  RUN_TEST(test_orthographic_span_of_a_camera);
  return UNITY_END();
}
