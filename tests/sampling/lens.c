/* Lenses against their definitions in long double: where each place of many frames looks, and from where. */
#include <math.h>
#include <string.h>

#include "../../host_sim/scenes/s1.h"
#include "random.h"
#include "sample.h"
#include "shade.h"
#include "unity.h"

void setUp(void) {}
void tearDown(void) {}

static const long double turn = 6.283185307179586476925286766559L;

static int64_t memory[64];
static fc_frame frame;
static fc_lens_state state;

static int prepare(const fc_lens_kind *kind, const void *data, uint16_t width, uint16_t height) {
  int error = fc_frame_setup(&frame, &s1, &s1_camera, NULL, width, height, memory, sizeof memory);
  return error != FC_OK ? error : kind->prepare(&state, &frame, data);
}

/* A place of the frame or up to half a pixel beyond it: any, or one of those where mistakes live. */
static void any_place(int32_t place[2]) {
  uint8_t i;
  for (i = 0; i < 2; i++) {
    const int32_t size = (i == 0 ? frame.width : frame.height) * 65536;
    switch (random_u64() % 6) {
      case 0: place[i] = size / 2; break;
      case 1: place[i] = size / 2 + random_within(-3, 3); break;
      case 2: place[i] = random_within(0, 1) * size; break;
      case 3: place[i] = random_within(-32768, size + 32768); break;
      default: place[i] = random_within(0, size); break;
    }
  }
}

static uint16_t any_size(void) { return random_u64() % 4 == 0 ? (uint16_t)random_within(1, 9) : (uint16_t)random_within(1, FC_SIZE_MAX); }

/* The angle between a ray and a vector, radians: by the sine too, which tells small ones. */
static long double angle_between(const int64_t d[3], const long double e[3]) {
  long double c[3], cross = 0, along = 0;
  uint8_t i;
  for (i = 0; i < 3; i++) {
    const uint8_t j = (uint8_t)((i + 1) % 3), k = (uint8_t)((i + 2) % 3);
    c[i] = (long double)d[j] * e[k] - (long double)d[k] * e[j];
    along += (long double)d[i] * e[i];
  }
  for (i = 0; i < 3; i++) cross += c[i] * c[i];
  return atan2l(sqrtl(cross), along);
}

/* A place's offset to the centre, in shorter half sides, to the right and upwards. */
static void offset_of(const int32_t place[2], long double offset[2]) {
  const long double half = (frame.width < frame.height ? frame.width : frame.height) / 2.0L;
  offset[0] = (place[0] / 65536.0L - frame.width / 2.0L) / half;
  offset[1] = (frame.height / 2.0L - place[1] / 65536.0L) / half;
}

static void test_pinhole_places_are_the_cameras_rays_in_between_too(void) {
  uint32_t trial;
  for (trial = 0; trial < 200000; trial++) {
    int32_t place[2];
    int64_t origin[3], direction[3];
    long double offset[2], expected[3], length;
    uint8_t i;
    if (trial % 200 == 0) TEST_ASSERT_EQUAL_INT(FC_OK, prepare(&fc_lens_pinhole, NULL, any_size(), any_size()));
    any_place(place);
    TEST_ASSERT_TRUE(fc_lens_pinhole.ray(&state, &frame, place, origin, direction));
    TEST_ASSERT_TRUE(origin[0] == 0 && origin[1] == 0 && origin[2] == 0);
    offset_of(place, offset);
    /* tan(half the field of view) is 1/2 */
    expected[0] = offset[0] / 2;
    expected[1] = offset[1] / 2;
    expected[2] = 1;
    length = sqrtl(expected[0] * expected[0] + expected[1] * expected[1] + 1);
    for (i = 0; i < 3; i++) {
      expected[i] /= length;
      TEST_ASSERT_TRUE(direction[i] > -(INT64_C(1) << 30) && direction[i] < INT64_C(1) << 30);
    }
    TEST_ASSERT_TRUE(angle_between(direction, expected) < 0x1p-27L);
  }
}

static void test_fisheye_angles_are_proportional_to_the_distance_from_the_centre(void) {
  long double worst = 0;
  uint32_t trial, seen = 0, beyond = 0;
  fc_fisheye lens = {0};
  for (trial = 0; trial < 400000; trial++) {
    int32_t place[2];
    int64_t origin[3], direction[3];
    long double offset[2], expected[3], radius, angle, off;
    bool there;
    if (trial % 100 == 0) {
      static const uint32_t angles[] = {1, 65536, 32768, 49152};
      const uint32_t any = (uint32_t)random_within(0, 7);
      lens.angle_q16 = any < 4 ? angles[any] : (uint32_t)random_within(1, 65536);
      TEST_ASSERT_EQUAL_INT(FC_OK, prepare(&fc_lens_fisheye, &lens, any_size(), any_size()));
    }
    any_place(place);
    there = fc_lens_fisheye.ray(&state, &frame, place, origin, direction);
    offset_of(place, offset);
    radius = sqrtl(offset[0] * offset[0] + offset[1] * offset[1]);
    if (!there) {
      beyond++;
      TEST_ASSERT_TRUE(radius > 1 - 1e-18L);
      continue;
    }
    seen++;
    TEST_ASSERT_TRUE(radius < 1 + 1e-18L);
    TEST_ASSERT_TRUE(origin[0] == 0 && origin[1] == 0 && origin[2] == 0);
    angle = radius * lens.angle_q16 / 65536 * turn / 2;
    expected[0] = radius > 0 ? sinl(angle) * offset[0] / radius : 0;
    expected[1] = radius > 0 ? sinl(angle) * offset[1] / radius : 0;
    expected[2] = cosl(angle);
    off = angle_between(direction, expected);
    if (off > worst) worst = off;
    TEST_ASSERT_TRUE(off < 0x1p-28L);
    TEST_ASSERT_TRUE(fabsl(sqrtl((long double)direction[0] * direction[0] + (long double)direction[1] * direction[1] +
                                 (long double)direction[2] * direction[2]) /
                               0x1p29L -
                           1) < 0x1p-28L);
  }
  TEST_ASSERT_TRUE(seen > 100000 && beyond > 100000);
  TEST_ASSERT_TRUE(worst > 0x1p-31L); /* it is compared with something */
}

static void test_panorama_places_are_longitude_and_latitude(void) {
  uint32_t trial;
  for (trial = 0; trial < 400000; trial++) {
    int32_t place[2];
    int64_t origin[3], direction[3];
    long double longitude, latitude, expected[3];
    if (trial % 200 == 0) TEST_ASSERT_EQUAL_INT(FC_OK, prepare(&fc_lens_panorama, NULL, any_size(), any_size()));
    any_place(place);
    TEST_ASSERT_TRUE(fc_lens_panorama.ray(&state, &frame, place, origin, direction));
    TEST_ASSERT_TRUE(origin[0] == 0 && origin[1] == 0 && origin[2] == 0);
    longitude = (place[0] / 65536.0L / frame.width - 0.5L) * turn;
    latitude = (0.5L - place[1] / 65536.0L / frame.height) * turn / 2;
    expected[0] = sinl(longitude) * cosl(latitude);
    expected[1] = sinl(latitude);
    expected[2] = cosl(longitude) * cosl(latitude);
    TEST_ASSERT_TRUE(angle_between(direction, expected) < 0x1p-28L);
    TEST_ASSERT_TRUE(fabsl(sqrtl((long double)direction[0] * direction[0] + (long double)direction[1] * direction[1] +
                                 (long double)direction[2] * direction[2]) /
                               0x1p29L -
                           1) < 0x1p-28L);
  }
}

static void test_orthographic_rays_are_parallel_and_start_where_the_span_says(void) {
  uint32_t trial, refused = 0;
  fc_orthographic lens = {1, 0};
  int error = FC_OK;
  for (trial = 0; trial < 400000; trial++) {
    int32_t place[2];
    int64_t origin[3], direction[3];
    long double offset[2], half;
    uint8_t i;
    if (trial % 100 == 0) {
      lens.span = random_within(1, FC_COORDINATE_MAX);
      lens.span_exponent = (int8_t)random_within(-31, 6);
      error = prepare(&fc_lens_orthographic, &lens, any_size(), any_size());
    }
    /* half the span in grid units: 2^shift / 2^fine world coordinates each */
    half = ldexpl(lens.span, lens.span_exponent - 1 + frame.view.fine - frame.view.shift);
    if (error != FC_OK) {
      const long double longer = frame.width < frame.height ? frame.height : frame.width,
                        shorter = frame.width < frame.height ? frame.width : frame.height;
      TEST_ASSERT_EQUAL_INT(FC_ERR_LENS, error);
      TEST_ASSERT_TRUE(half * (longer + 1) / shorter >= FC_COORDINATE_MAX);
      refused++;
      continue;
    }
    any_place(place);
    TEST_ASSERT_TRUE(fc_lens_orthographic.ray(&state, &frame, place, origin, direction));
    TEST_ASSERT_TRUE(direction[0] == 0 && direction[1] == 0 && direction[2] > 0 && origin[2] == 0);
    offset_of(place, offset);
    for (i = 0; i < 2; i++) {
      TEST_ASSERT_TRUE(fabsl((long double)origin[i] - offset[i] * half) <= 0.5L + 1e-9L);
      TEST_ASSERT_TRUE(origin[i] >= -FC_COORDINATE_MAX && origin[i] <= FC_COORDINATE_MAX);
    }
  }
  TEST_ASSERT_TRUE(refused > 10000 && refused < 300000);
}

static void test_orthographic_frames_the_target_as_the_pinhole_does(void) {
  uint32_t trial, made = 0;
  for (trial = 0; trial < 100000; trial++) {
    fc_camera camera = s1_camera;
    fc_orthographic lens;
    long double distance = 0, span;
    int error;
    camera.eye.x = random_any_size(29);
    camera.eye.y = random_any_size(29);
    camera.eye.z = random_any_size(29);
    camera.target.x = random_any_size(29);
    camera.target.y = camera.eye.y + random_within(-3, 3);
    camera.target.z = random_any_size(29);
    camera.exponent = (int8_t)random_within(-31, 31);
    camera.tan_half_fov_numerator = (uint32_t)random_any_size(16) + 65537;
    camera.tan_half_fov_denominator = (uint32_t)random_within(1, 65537);
    error = fc_orthographic_of_camera(&lens, &camera);
    distance = hypotl(hypotl((long double)camera.target.x - camera.eye.x, (long double)camera.target.y - camera.eye.y),
                      (long double)camera.target.z - camera.eye.z);
    span = ldexpl(2 * distance * camera.tan_half_fov_numerator / camera.tan_half_fov_denominator, camera.exponent);
    if (error != FC_OK) {
      TEST_ASSERT_TRUE(error == FC_ERR_FIELD_OF_VIEW || error == FC_ERR_LENS);
      if (error == FC_ERR_LENS) TEST_ASSERT_TRUE(span >= 0x1p60L || span < 0x1p-31L);
      continue;
    }
    made++;
    TEST_ASSERT_TRUE(lens.span >= 1 && lens.span <= FC_COORDINATE_MAX && lens.span_exponent >= -31 && lens.span_exponent <= 32);
    TEST_ASSERT_TRUE(fabsl(ldexpl(lens.span, lens.span_exponent) - span) <= span * 0x1p-29L + 0x1p-32L);
  }
  TEST_ASSERT_TRUE(made > 50000);
}

static void test_lens_data_out_of_range_are_refused(void) {
  fc_orthographic span = {0, 0};
  fc_fisheye fisheye = {0};
  fc_camera camera = s1_camera;
  TEST_ASSERT_EQUAL_INT(FC_ERR_LENS, prepare(&fc_lens_orthographic, NULL, 20, 10));
  TEST_ASSERT_EQUAL_INT(FC_ERR_LENS, prepare(&fc_lens_orthographic, &span, 20, 10));
  span.span = 65536;
  TEST_ASSERT_EQUAL_INT(FC_OK, prepare(&fc_lens_orthographic, &span, 20, 10));
  span.span = -1;
  TEST_ASSERT_EQUAL_INT(FC_ERR_LENS, prepare(&fc_lens_orthographic, &span, 20, 10));
  span.span = 1;
  span.span_exponent = -32;
  TEST_ASSERT_EQUAL_INT(FC_ERR_LENS, prepare(&fc_lens_orthographic, &span, 20, 10));
  span.span_exponent = 33;
  TEST_ASSERT_EQUAL_INT(FC_ERR_LENS, prepare(&fc_lens_orthographic, &span, 20, 10));
  TEST_ASSERT_EQUAL_INT(FC_ERR_LENS, prepare(&fc_lens_fisheye, NULL, 20, 10));
  TEST_ASSERT_EQUAL_INT(FC_ERR_LENS, prepare(&fc_lens_fisheye, &fisheye, 20, 10));
  fisheye.angle_q16 = 65537;
  TEST_ASSERT_EQUAL_INT(FC_ERR_LENS, prepare(&fc_lens_fisheye, &fisheye, 20, 10));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_orthographic_of_camera(NULL, &camera));
  TEST_ASSERT_EQUAL_INT(FC_ERR_NULL, fc_orthographic_of_camera(&span, NULL));
  camera.tan_half_fov_numerator = 0;
  TEST_ASSERT_EQUAL_INT(FC_ERR_FIELD_OF_VIEW, fc_orthographic_of_camera(&span, &camera));
  camera = s1_camera;
  camera.exponent = 32;
  TEST_ASSERT_EQUAL_INT(FC_ERR_EXPONENT, fc_orthographic_of_camera(&span, &camera));
  camera = s1_camera;
  camera.target = camera.eye;
  TEST_ASSERT_EQUAL_INT(FC_ERR_CAMERA_TARGET, fc_orthographic_of_camera(&span, &camera));
  camera.eye.x = INT32_MIN;
  TEST_ASSERT_EQUAL_INT(FC_ERR_COORDINATE, fc_orthographic_of_camera(&span, &camera));
}

/* ---- what a lens shows of a scene that is known in closed form: one sphere ---- */

enum {
  SIDE = 41
};
static const fc_sphere ball[] FC_ROM = {{FC_VEC3(1, 2, -3), FC_Q16(1.5), 0, 5}};
static const fc_shapes ball_shapes[] FC_ROM = {FC_SPHERES(ball)};

static void test_pictures_of_a_sphere_and_its_depths_are_those_of_the_formula(void) {
  /* The eye at 0 looking along -z, up y: camera (x, y, -z). Which way each lens' rays go is said here anew. */
  static const fc_lens_kind *const kinds[] = {&fc_lens_pinhole, &fc_lens_orthographic, &fc_lens_fisheye, &fc_lens_panorama};
  static const long double centre[3] = {1, 2, 3}, ball_radius = 1.5L;
  static uint8_t pixels[SIDE * SIDE * 3];
  static uint16_t depth[SIDE * SIDE], primitive[SIDE * SIDE];
  const fc_orthographic span = {FC_Q16(12), 0};
  const fc_fisheye fisheye = {60000};
  fc_scene scene = s1;
  fc_camera camera = s1_camera;
  uint8_t k;
  scene.shapes = ball_shapes;
  scene.shape_count = 1;
  memset(&camera.eye, 0, sizeof camera.eye);
  memset(&camera.target, 0, sizeof camera.target);
  camera.target.z = -FC_Q16(1);
  camera.tan_half_fov_numerator = 2;
  camera.tan_half_fov_denominator = 1;
  for (k = 0; k < 4; k++) {
    fc_sampling how = FC_SAMPLING_ONE;
    fc_target t;
    uint32_t hits = 0, x, y;
    memset(&t, 0, sizeof t);
    t.pixels = pixels;
    t.pitch_bytes = SIDE * 3;
    t.format = FC_RGB888;
    t.depth = depth;
    t.primitive = primitive;
    how.lens.kind = kinds[k];
    how.lens.data = k == 1 ? (const void *)&span : &fisheye;
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_frame_setup(&frame, &scene, &camera, NULL, SIDE, SIDE, memory, sizeof memory));
    TEST_ASSERT_EQUAL_INT(FC_OK, fc_sample_rows(&frame, &how, 0, SIDE, &t, NULL, NULL, 0));
    for (y = 0; y < SIDE; y++)
      for (x = 0; x < SIDE; x++) {
        const long double u = (2 * x + 1.0L) / SIDE - 1, v = 1 - (2 * y + 1.0L) / SIDE, r = hypotl(u, v);
        const uint16_t code = depth[y * SIDE + x];
        long double o[3] = {0, 0, 0}, d[3] = {0, 0, 1}, b = 0, c = 0, length, root;
        bool nothing = false;
        uint8_t i;
        if (k == 0) {
          d[0] = 2 * u;
          d[1] = 2 * v;
        } else if (k == 1) {
          o[0] = 6 * u;
          o[1] = 6 * v;
        } else if (k == 2) {
          const long double angle = r * 60000 / 65536 * turn / 2;
          d[0] = r > 0 ? sinl(angle) * u / r : 0;
          d[1] = r > 0 ? sinl(angle) * v / r : 0;
          d[2] = cosl(angle);
          nothing = r > 1;
        } else {
          d[0] = sinl(u * turn / 2) * cosl(v * turn / 4);
          d[1] = sinl(v * turn / 4);
          d[2] = cosl(u * turn / 2) * cosl(v * turn / 4);
        }
        length = sqrtl(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        for (i = 0; i < 3; i++) {
          b += d[i] / length * (centre[i] - o[i]);
          c += (centre[i] - o[i]) * (centre[i] - o[i]);
        }
        root = b * b - c + ball_radius * ball_radius;
        if (fabsl(root) < 1e-4L) continue; /* on its rim, within rounding */
        nothing = nothing || root < 0 || b < 0;
        TEST_ASSERT_EQUAL_HEX16(nothing ? 0xffff : 0, primitive[y * SIDE + x]);
        if (nothing) {
          TEST_ASSERT_EQUAL_HEX16(0, code);
        } else {
          long double t_hit = b - sqrtl(root), expected = k == 0 ? t_hit / length : t_hit, got;
          int exponent;
          const uint32_t mantissa = fc_depth_z(&frame, code, &exponent);
          hits++;
          got = ldexpl(mantissa, exponent - 16);
          /* a code's own error, and the coordinates' */
          TEST_ASSERT_TRUE(fabsl(got - expected) < expected * 0x1p-12L);
        }
      }
    TEST_ASSERT_TRUE(hits > 20 && hits < SIDE * SIDE / 2);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_pinhole_places_are_the_cameras_rays_in_between_too);
  RUN_TEST(test_fisheye_angles_are_proportional_to_the_distance_from_the_centre);
  RUN_TEST(test_panorama_places_are_longitude_and_latitude);
  RUN_TEST(test_orthographic_rays_are_parallel_and_start_where_the_span_says);
  RUN_TEST(test_orthographic_frames_the_target_as_the_pinhole_does);
  RUN_TEST(test_lens_data_out_of_range_are_refused);
  RUN_TEST(test_pictures_of_a_sphere_and_its_depths_are_those_of_the_formula);
  return UNITY_END();
}
