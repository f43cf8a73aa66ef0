/* Segments to lights: open ends, touching, and the exact fallbacks against the filters. */
#include <string.h>

#include "fixcast/fixcast.h"
#include "kind.h"
#include "random.h"
#include "unity.h"
#include "vectors.h"

void setUp(void) {}
void tearDown(void) {}

static const fc_material materials[] = {FC_MATTE(FC_WHITE)};
static fc_sphere spheres[1];
static fc_plane planes[1];
static fc_vec3 vertices[3];
static const fc_triangle triangles[1] = {{{0, 1, 2}, 0, 1}};
static fc_shapes shapes;
static fc_scene scene;

static void use(const fc_kind *kind, const void *items) {
  memset(&scene, 0, sizeof scene);
  shapes.kind = kind;
  shapes.items = items;
  shapes.vertices = vertices;
  shapes.vertex_count = 3;
  shapes.count = 1;
  scene.shapes = &shapes;
  scene.shape_count = 1;
  scene.materials = materials;
  scene.material_count = 1;
}

static int between(fc_vec3 a, fc_vec3 b) {
  int forth = fc_blocked(&scene, &a, &b);
  TEST_ASSERT_EQUAL_INT_MESSAGE(forth, fc_blocked(&scene, &b, &a), "from and to are not symmetric");
  return forth;
}

static void test_sphere_blocks(void) {
  memset(spheres, 0, sizeof spheres);
  spheres[0].radius = 10;
  use(&fc_kind_sphere, spheres);
  TEST_ASSERT_EQUAL_INT(1, between(vec(-20, 0, 0), vec(20, 0, 0)));
  TEST_ASSERT_EQUAL_INT(1, between(vec(-20, 10, 0), vec(20, 10, 0))); /* touching */
  TEST_ASSERT_EQUAL_INT(0, between(vec(-20, 11, 0), vec(20, 11, 0)));
  TEST_ASSERT_EQUAL_INT(0, between(vec(-20, 0, 0), vec(-10, 0, 0))); /* ends on it */
  TEST_ASSERT_EQUAL_INT(1, between(vec(-20, 0, 0), vec(-9, 0, 0)));
  TEST_ASSERT_EQUAL_INT(0, between(vec(-9, 0, 0), vec(9, 0, 0)));    /* both inside */
  TEST_ASSERT_EQUAL_INT(1, between(vec(-10, 0, 0), vec(20, 0, 0)));  /* starts on it, goes through */
  TEST_ASSERT_EQUAL_INT(0, between(vec(-9, 0, 0), vec(-10, 0, 0)));  /* from inside to the surface */
  TEST_ASSERT_EQUAL_INT(0, between(vec(-40, 0, 0), vec(-20, 0, 0))); /* stops short */
  TEST_ASSERT_EQUAL_INT(0, between(vec(0, 10, 0), vec(20, 10, 0)));  /* tangent at its end */
  TEST_ASSERT_EQUAL_INT(0, between(vec(6, 8, 0), vec(-6, 8, 0)));    /* a chord: both ends on it, inside between */
}

static void test_plane_blocks(void) {
  memset(planes, 0, sizeof planes);
  planes[0].normal.y = 3;
  planes[0].d = -30; /* y = 10 */
  use(&fc_kind_plane, planes);
  TEST_ASSERT_EQUAL_INT(1, between(vec(0, 0, 0), vec(0, 20, 0)));
  TEST_ASSERT_EQUAL_INT(1, between(vec(5, 9, 0), vec(9, 11, 0)));
  TEST_ASSERT_EQUAL_INT(0, between(vec(0, 0, 0), vec(0, 10, 0)));
  TEST_ASSERT_EQUAL_INT(0, between(vec(0, 10, 0), vec(9, 10, 9))); /* in the plane */
  TEST_ASSERT_EQUAL_INT(0, between(vec(0, 11, 0), vec(9, 15, 9)));
}

static void test_triangle_blocks(void) {
  vertices[0] = vec(0, 0, 0);
  vertices[1] = vec(100, 0, 0);
  vertices[2] = vec(0, 100, 0);
  use(&fc_kind_triangle, triangles);
  TEST_ASSERT_EQUAL_INT(1, between(vec(20, 20, -5), vec(20, 20, 5)));
  TEST_ASSERT_EQUAL_INT(1, between(vec(50, 50, -5), vec(50, 50, 5))); /* through an edge */
  TEST_ASSERT_EQUAL_INT(1, between(vec(0, 0, -5), vec(0, 0, 5)));     /* through a vertex */
  TEST_ASSERT_EQUAL_INT(0, between(vec(51, 50, -5), vec(51, 50, 5)));
  TEST_ASSERT_EQUAL_INT(0, between(vec(20, 20, 0), vec(20, 20, 5))); /* starts in it */
  TEST_ASSERT_EQUAL_INT(0, between(vec(20, 20, 1), vec(20, 20, 5)));
  TEST_ASSERT_EQUAL_INT(0, between(vec(-5, 20, 0), vec(500, 20, 0))); /* in its plane */
}

/* A primitive of each kind, of any size and place. */
static void random_form(int kind, fc_form *form) {
  int i, j;
  uint8_t bits = (uint8_t)(6 + random_u64() % 24);
  memset(form, 0, sizeof *form);
  for (i = 0; i < 3; i++) {
    if (kind == 0) form->u.sphere.center[i] = random_any_size(bits);
    if (kind == 1) form->u.plane.normal[i] = random_any_size(29);
    if (kind == 2)
      for (j = 0; j < 3; j++) form->u.triangle.vertex[i][j] = random_any_size(bits);
  }
  if (kind == 0) form->u.sphere.radius = random_within(1, (int32_t)((UINT32_C(1) << bits) - 1));
  if (kind == 1)
    form->u.plane.k = form->u.plane.normal[0] * random_any_size(bits) + form->u.plane.normal[1] * random_any_size(bits) +
                      form->u.plane.normal[2] * random_any_size(bits);
}

/* On every kind of receiver and occluder, the exact form says what the filter says. */
static void test_g2_fallbacks_agree_with_filters(void) {
  static const fc_kind *const kinds[] = {&fc_kind_sphere, &fc_kind_plane, &fc_kind_triangle};
  static const int64_t eye[3] = {0, 0, 0};
  int trial, blocked = 0, used = 0;
  for (trial = 0; trial < 6000; trial++) {
    fc_form receiver = {0}, occluder = {0};
    fc_prepared prepared;
    fc_root root[2];
    fc_segment segment;
    int64_t d[3];
    uint32_t error;
    int64_t precise[3];
    int i, from = trial % 3, by = trial / 3 % 3;
    bool quick, exact;
    random_form(from, &receiver);
    random_form(by, &occluder);
    for (i = 0; i < 3; i++) d[i] = random_any_size(29);
    if (from == 0) /* aim, or most rays miss */
      for (i = 0; i < 3; i++) d[i] = receiver.u.sphere.center[i] / 2 + d[i] % (receiver.u.sphere.radius / 2 + 1);
    if (from == 2)
      for (i = 0; i < 3; i++)
        d[i] = (receiver.u.triangle.vertex[0][i] + receiver.u.triangle.vertex[1][i] + receiver.u.triangle.vertex[2][i]) / 8;
    if ((d[0] | d[1] | d[2]) == 0) continue;
    kinds[from]->prepare(&receiver, eye, &prepared);
    if (kinds[from]->test(&prepared, d, root) == 0) continue;
    for (i = 0; i < 3; i++) {
      segment.light[i] = random_any_size(30);
      if (trial & 8) segment.light[i] *= INT64_C(1) << (trial / 16 % 30); /* suns */
    }
    segment.outside = false;
    segment.root = &root[0];
    segment.direction = d;
    segment.point_error = fc_point_near(fc_root_quick(&root[0]), eye, d, segment.point);
    fc_segment_prepare(&segment);
    if (segment.point_error == UINT32_MAX) continue;
    TEST_ASSERT_TRUE(fc_point_at(fc_root_value(&root[0]), eye, d, precise));
    for (i = 0; i < 3; i++) /* that one is within 1 unit */
      TEST_ASSERT_TRUE(fc_abs64(precise[i] - segment.point[i]) <= (uint64_t)segment.point_error + 1);
    used++;
    quick = kinds[by]->blocked(&occluder, &segment);
    blocked += quick;
    error = segment.point_error;
    segment.point_error = UINT32_MAX;
    fc_segment_prepare(&segment);
    exact = kinds[by]->blocked(&occluder, &segment);
    TEST_ASSERT_EQUAL_INT(exact, quick);
    exact = kinds[from]->facing(&receiver, &segment);
    segment.point_error = error;
    fc_segment_prepare(&segment);
    quick = kinds[from]->facing(&receiver, &segment);
    TEST_ASSERT_EQUAL_INT(exact, quick);
  }
  TEST_ASSERT_GREATER_THAN_INT(2000, used);
  TEST_ASSERT_GREATER_THAN_INT(300, blocked);
}

/* Whole-number ends a unit or so off an edge or a tangent, at full size: every term of the filters' error bounds counts. */
static void test_g2_filters_hold_beside_edges_and_tangents(void) {
  int trial, blocked = 0;
  for (trial = 0; trial < 4000; trial++) {
    fc_form form = {0};
    fc_segment segment;
    const fc_kind *kind = trial & 1 ? &fc_kind_triangle : &fc_kind_sphere;
    int64_t middle[3];
    bool quick, exact;
    int j;
    memset(&segment, 0, sizeof segment);
    memset(&form, 0, sizeof form);
    for (j = 0; j < 3; j++) {
      segment.point[j] = random_any_size(28);
      segment.light[j] = random_any_size(28);
      if (trial & 2) segment.light[j] = segment.light[j] * 64 + random_within(0, 63); /* beyond the grid's range */
      middle[j] = segment.point[j] + (segment.light[j] - segment.point[j]) / (trial & 2 ? 256 : 3);
    }
    if (trial & 1) {
      for (j = 0; j < 3; j++) {
        int64_t along = random_any_size(27);
        form.u.triangle.vertex[0][j] = middle[j] + along + random_within(-1, 1);
        form.u.triangle.vertex[1][j] = middle[j] - along;
        form.u.triangle.vertex[2][j] = random_any_size(28);
      }
    } else {
      /* radius: the distance from the center to the line, within a unit */
      int64_t w[3], c[3];
      fc_num area = {0, 0}, length = {0, 0};
      for (j = 0; j < 3; j++) {
        form.u.sphere.center[j] = middle[j] + random_any_size(26);
        w[j] = segment.light[j] - segment.point[j];
        c[j] = form.u.sphere.center[j] - segment.point[j];
      }
      for (j = 0; j < 3; j++) {
        int k = (j + 1) % 3, l = (j + 2) % 3;
        fc_num term = fc_num_from_abs(fc_i128_sub(fc_i128_mul(w[k], c[l]), fc_i128_mul(w[l], c[k])));
        area = fc_num_add(area, fc_num_mul(term, term));
        term = fc_num_from_abs(fc_i128_mul(w[j], 1));
        length = fc_num_add(length, fc_num_mul(term, term));
      }
      if (length.m == 0) continue;
      form.u.sphere.radius = (int64_t)fc_num_round(fc_num_sqrt(fc_num_div(area, length)), 0) + random_within(-1, 1);
      if (form.u.sphere.radius < 1) continue;
    }
    fc_segment_prepare(&segment);
    quick = kind->blocked(&form, &segment);
    segment.point_error = UINT32_MAX;
    fc_segment_prepare(&segment);
    exact = kind->blocked(&form, &segment);
    blocked += exact;
    TEST_ASSERT_EQUAL_INT(exact, quick);
  }
  TEST_ASSERT_GREATER_THAN_INT(500, blocked);
}

/* The receiver never shadows itself, from any angle, with the exact rule. */
static void test_g9_a_sphere_does_not_shadow_itself(void) {
  static const int64_t eye[3] = {0, 0, 0};
  int trial, facing = 0;
  for (trial = 0; trial < 3000; trial++) {
    fc_form form = {0};
    fc_prepared prepared;
    fc_root root[2];
    fc_segment segment;
    int64_t d[3];
    int i;
    form.u.sphere.radius = random_within(100, 1 << 26);
    for (i = 0; i < 3; i++) {
      form.u.sphere.center[i] = random_any_size(29);
      d[i] = form.u.sphere.center[i] / 2 + random_any_size(24);
    }
    if ((d[0] | d[1] | d[2]) == 0) continue;
    fc_kind_sphere.prepare(&form, eye, &prepared);
    if (fc_i128_sign(prepared.u.sphere.c) < 0 || fc_kind_sphere.test(&prepared, d, root) == 0) continue;
    for (i = 0; i < 3; i++) segment.light[i] = random_any_size(30);
    segment.outside = false;
    segment.root = &root[0];
    segment.direction = d;
    segment.point_error = fc_point_near(fc_root_quick(&root[0]), eye, d, segment.point);
    fc_segment_prepare(&segment);
    if (!fc_kind_sphere.facing(&form, &segment)) continue;
    facing++;
    /* the exact point is on the sphere, so this runs the whole exact form, and it finds no second meeting */
    TEST_ASSERT_FALSE(fc_kind_sphere.blocked(&form, &segment));
  }
  TEST_ASSERT_GREATER_THAN_INT(300, facing);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_sphere_blocks);
  RUN_TEST(test_plane_blocks);
  RUN_TEST(test_triangle_blocks);
  RUN_TEST(test_g2_fallbacks_agree_with_filters);
  RUN_TEST(test_g2_filters_hold_beside_edges_and_tangents);
  RUN_TEST(test_g9_a_sphere_does_not_shadow_itself);
  return UNITY_END();
}
