/* Frame set-up: a scene brought into camera space, in the caller's memory. */
#include <string.h>

#include "bits.h"
#include "depth.h"
#include "fixcast/error.h"
#include "fixcast/render.h"
#include "scan.h"
#include "search.h"
#include "space.h"
#include "view.h"

/* C99's alignof(int64_t): 8 mostly, 4 on i386, 1 on AVR. */
struct aligned_i64 {
  char before;
  int64_t value;
};

static FC_COLD bool aligned(const void *memory) { return (uintptr_t)memory % offsetof(struct aligned_i64, value) == 0; }

static FC_COLD size_t memory_of(const fc_scene *scene) {
  fc_space space = fc_space_of_world(scene);
  fc_cursor cursor;
  /* 16 + 6 bits a table, and 16 bits of tables */
  uint64_t bytes = scene->light_count * (uint32_t)(3 * sizeof(int64_t)) + (uint64_t)fc_search_marks(scene);
  fc_cursor_start(&cursor, &space);
  while (fc_cursor_next(&cursor)) bytes += fc_kind_of(&cursor)->memory(&cursor.group.shapes);
  return bytes < SIZE_MAX ? (size_t)bytes : SIZE_MAX;
}

FC_COLD size_t fc_frame_memory(const fc_scene *scene_rom, int *error) {
  fc_scene scene;
  int status = fc_scene_check(scene_rom);
  if (error != NULL) *error = status;
  if (status != FC_OK) return 0;
  FC_READ_ONE(&scene, scene_rom);
  return memory_of(&scene);
}

/* The finest grid on which the farthest finite geometry has coordinates below 2^30 - 16. */
static FC_COLD void choose_grid(fc_frame *frame) {
  fc_num most = fc_num_from_u64(1, 0);
  fc_space space = fc_space_of_world(&frame->scene);
  fc_cursor cursor;
  int32_t shift;
  fc_cursor_start(&cursor, &space);
  while (fc_cursor_next(&cursor)) {
    fc_num extent = fc_kind_of(&cursor)->extent(&frame->view, &cursor.group.shapes);
    if (fc_num_order_of(&extent, &most) > 0) most = extent;
  }
  shift = most.e + 63 - 30;
  if (most.m > (UINT64_C(1) << 63) - (UINT64_C(1) << 38)) shift++; /* no room for rounding */
  /* rows are Q30: finer than that there is nothing to gain */
  frame->view.shift = (int16_t)(shift < -30 ? -30 : shift);
}

static FC_COLD void place_shapes(const fc_frame *frame, unsigned char *memory) {
  fc_space space = fc_space_of_world(&frame->scene);
  fc_cursor cursor;
  fc_cursor_start(&cursor, &space);
  while (fc_cursor_next(&cursor)) fc_kind_of(&cursor)->place(&frame->view, &cursor.group.shapes, memory + cursor.bytes);
}

/* A directional light: about 2^60 units away from the eye. */
static FC_COLD void place_far(const fc_view *view, const fc_vec3 *towards, int64_t to[3]) {
  int64_t v[3];
  uint8_t i, up;
  (void)fc_load(towards, v);
  up = (uint8_t)(30 - fc_vector_bits(v));
  for (i = 0; i < 3; i++) v[i] *= INT64_C(1) << up;
  fc_view_turn(view, v, to); /* v up to 2^30 sqrt 3: below 2^61 */
}

static FC_COLD int place_lights(const fc_frame *frame, int64_t *to) {
  uint16_t i;
  for (i = 0; i < frame->scene.light_count; i++) {
    fc_light light;
    FC_READ_ONE(&light, frame->scene.lights + i);
    if (light.directional)
      place_far(&frame->view, &light.position, to + 3 * (size_t)i);
    else if (!fc_view_point(&frame->view, &light.position, light.exponent, to + 3 * (size_t)i)) return FC_ERR_LIGHT;
  }
  return FC_OK;
}

/* An only light up to four times as far away as the geometry: a grid coarser by two bits at most holds it too, and the fast forms with it.
 * Beyond that exactness is worth more. */
static FC_COLD bool coarsen_for_light(fc_frame *frame, const int64_t light[3]) {
  uint8_t bits;
  if (frame->scene.light_count != 1) return false;
  bits = fc_vector_bits(light);
  if (bits <= 30 || bits > 32) return false;
  frame->view.shift = (int16_t)(frame->view.shift + bits - 30);
  return true;
}

static FC_COLD void measure_depth(fc_frame *frame) {
  uint64_t near = UINT64_MAX, far = 0;
  fc_space space = fc_space_of_frame(frame);
  fc_cursor cursor;
  fc_cursor_start(&cursor, &space);
  while (fc_cursor_next(&cursor)) fc_kind_of(&cursor)->depth_range(frame, &cursor.group, &near, &far);
  if (far == 0) near = far = 1; /* nothing to see */
  if (frame->scene.far_limit > 0) {
    fc_quick limited = fc_quick_from((uint64_t)frame->scene.far_limit, fc_view_far_exponent(frame));
    uint64_t limit = limited.e > 30 ? UINT64_MAX : fc_quick_to_u64(limited) + 1;
    if (limit < far) far = limit > near ? limit : near;
  }
  fc_depth_choose(frame, near, far);
}

/* Which hits the far limit cuts: exactly between two bounds, and by these numbers in between (scan.h). */
static FC_COLD void set_far(fc_frame *frame) {
  int64_t corner[3];
  fc_quick ratio, inverse, longest;
  int32_t low, high;
  if (frame->scene.far_limit == 0) return;
  ratio = fc_quick_mul(fc_quick_from(frame->depth_near, 0),
                       fc_quick_recip(fc_quick_from((uint64_t)frame->scene.far_limit, fc_view_far_exponent(frame))));
  fc_view_direction(frame, 0, 0, corner);
  inverse = fc_quick_recip(fc_quick_from((uint64_t)corner[2], 0));
  longest = fc_quick_from((uint64_t)fc_dot(corner, corner), 0);
  longest = fc_quick_mul(fc_quick_mul(longest, fc_quick_rsqrt(longest)), inverse);
  /* all within 2^-24 */
  low = fc_quick_to_int(ratio, 30);
  if (low >> 30 != 0) low = INT32_C(1) << 30;
  low -= (low >> 22) + 2;
  frame->far_low = low > 0 ? (uint32_t)low : 0;
  high = fc_quick_to_int(fc_quick_mul(longest, ratio), 30);
  if (high >> 30 == 0) high += (high >> 22) + 2;
  frame->far_high = high >> 30 != 0 ? UINT32_MAX : (uint32_t)high;
  ratio = fc_quick_mul(ratio, inverse);
  ratio = fc_quick_scale(fc_quick_mul(ratio, ratio), 82);
  frame->far_scale = ratio.m;
  frame->far_shift = ratio.m == 0 || ratio.e > 0 || ratio.e < -63 ? FC_FAR_EXACT : (uint8_t)-ratio.e;
}

/* round(v 2^e), e up to 14. */
static FC_COLD uint32_t level(uint16_t v, int16_t e) {
  return ((uint32_t)fc_quick_to_int(fc_quick_from(v, 0), (int16_t)(e + 1)) + 1) / 2; /* 16 + 15 bits */
}

/* Whether the scan engine's light forms hold: one light, no falloff, exact shadows, within 2^30 grid units. */
static FC_COLD void set_light(fc_frame *frame) {
  const uint64_t reach = (uint64_t)FC_COORDINATE_MAX;
  fc_light light;
  int16_t e;
  frame->light = FC_LIGHT_MANY;
  frame->layered = false;
  if (frame->scene.light_count == 0) {
    uint16_t layers = 0, i;
    frame->light = FC_LIGHT_NONE;
    for (i = 0; i < frame->scene.material_count && layers == 0; i++) FC_READ_ONE(&layers, &frame->scene.materials[i].layer_count);
    frame->layered = layers != 0;
  }
  if (frame->scene.light_count != 1 || frame->options.offset_rule != FC_OFFSET_EXACT) return;
  FC_READ_ONE(&light, frame->scene.lights);
  if (light.inverse_square || light.intensity_exponent > 14 || fc_abs64(frame->lights[0]) > reach ||
      fc_abs64(frame->lights[1]) > reach || fc_abs64(frame->lights[2]) > reach)
    return;
  e = light.intensity_exponent;
  frame->light_level[0] = level(light.intensity.r, e);
  frame->light_level[1] = level(light.intensity.g, e);
  frame->light_level[2] = level(light.intensity.b, e);
  frame->light = FC_LIGHT_ONE;
}

/* What the kinds keep for the scan engine. */
static FC_COLD void project_shapes(const fc_frame *frame) {
  fc_space space = fc_space_of_world(&frame->scene);
  fc_cursor cursor;
  fc_cursor_start(&cursor, &space);
  while (fc_cursor_next(&cursor))
    fc_kind_of(&cursor)->project(frame, &cursor.group.shapes, (unsigned char *)frame->memory + cursor.bytes);
}

/* What they know of each other's shadows. */
static FC_COLD void settle_shapes(const fc_frame *frame) {
  fc_space space = fc_space_of_frame(frame);
  fc_cursor cursor;
  fc_cursor_start(&cursor, &space);
  while (fc_cursor_next(&cursor))
    if (fc_kind_of(&cursor)->settle != NULL) fc_kind_of(&cursor)->settle(frame, &cursor.group);
}

/* Steps twice as long over half as many pixels: directions stay as large as they are. */
static FC_COLD void halve(fc_frame *frame) {
  frame->odd = (uint8_t)((frame->width & 1) | (frame->height & 1) << 1);
  frame->width = (uint16_t)((frame->width + 1) / 2);
  frame->height = (uint16_t)((frame->height + 1) / 2);
  frame->view.pixel_shift++;
}

static FC_COLD int check_options(const fc_options *options) {
  if (options->offset_rule > FC_OFFSET_NONE) return FC_ERR_FORMAT;
  if (options->depth_exponent_bits != 0 && (options->depth_exponent_bits < 2 || options->depth_exponent_bits > 4))
    return FC_ERR_FORMAT;
  if (options->profile > FC_PROFILE_INTERLACED) return FC_ERR_PROFILE;
  if (options->epsilon < 0 || options->epsilon > FC_COORDINATE_MAX) return FC_ERR_COORDINATE;
  if (options->epsilon_exponent < -31 || options->epsilon_exponent > 31) return FC_ERR_EXPONENT;
  return FC_OK;
}

FC_COLD int fc_frame_setup(fc_frame *frame, const fc_scene *scene, const fc_camera *camera_rom, const fc_options *options,
                           uint16_t width, uint16_t height, void *memory, size_t memory_bytes) {
  fc_camera camera;
  size_t bytes;
  int error;
  uint64_t epsilon;
  uint8_t *casters = NULL;
  if (frame == NULL || scene == NULL || camera_rom == NULL) return FC_ERR_NULL;
  if (width < 1 || height < 1 || width > FC_SIZE_MAX || height > FC_SIZE_MAX) return FC_ERR_SIZE;
  memset(frame, 0, sizeof *frame);
  if (options != NULL) frame->options = *options;
  error = check_options(&frame->options);
  if (error != FC_OK) return error;
  bytes = fc_frame_memory(scene, &error);
  if (error != FC_OK) return error;
  if (bytes > 0 && (memory == NULL || memory_bytes < bytes || bytes == SIZE_MAX || !aligned(memory))) return FC_ERR_MEMORY;
  FC_READ_ONE(&frame->scene, scene);
  FC_READ_ONE(&camera, camera_rom);
  frame->memory = memory;
  frame->width = width;
  frame->height = height;
  error = fc_view_from_camera(&frame->view, &camera, width, height);
  if (error != FC_OK) return error;
  if (frame->options.profile == FC_PROFILE_HALF) halve(frame);
  choose_grid(frame);
  if (bytes > 0) {
    const size_t mark_bytes = fc_search_marks(&frame->scene);
    size_t shape_bytes = bytes - (size_t)frame->scene.light_count * 3 * sizeof(int64_t) - mark_bytes;
    int64_t *lights = (int64_t *)memory + shape_bytes / sizeof(int64_t);
    error = place_lights(frame, lights);
    if (error == FC_OK && coarsen_for_light(frame, lights)) error = place_lights(frame, lights);
    if (error != FC_OK) return error;
    place_shapes(frame, memory);
    frame->lights = lights;
    if (mark_bytes > 0) casters = (uint8_t *)memory + (bytes - mark_bytes);
  }
  epsilon = fc_num_round(fc_num_from_u64((uint64_t)frame->options.epsilon, frame->options.epsilon_exponent),
                         frame->view.fine - frame->view.shift);
  frame->epsilon_grid = epsilon > (UINT64_C(1) << 40) ? INT64_C(1) << 40 : (int64_t)epsilon;
  measure_depth(frame);
  set_far(frame);
  set_light(frame);
  project_shapes(frame);
  if (casters != NULL && frame->light == FC_LIGHT_ONE) {
    const fc_space space = fc_space_of_frame(frame);
    fc_search_mark(&space, casters);
    frame->casters = casters;
  }
  if (frame->light == FC_LIGHT_ONE) settle_shapes(frame);
  return FC_OK;
}
