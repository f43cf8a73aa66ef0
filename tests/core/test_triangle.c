/* Triangles through the public ray engine: shared edges and vertices, degenerate and extreme cases. */
#include <string.h>

#include "fixcast/fixcast.h"
#include "kind.h"
#include "random.h"
#include "unity.h"
#include "vectors.h"

void setUp(void) {}
void tearDown(void) {}

enum {
  MOST = 12
};

static const fc_material materials[] = {FC_MATTE(FC_WHITE)};
static fc_vec3 vertices[MOST + 1];
static fc_triangle triangles[MOST];
static fc_shapes shapes;
static fc_scene scene;

static void use(uint16_t vertex_count, uint16_t count) {
  uint16_t i;
  memset(&scene, 0, sizeof scene);
  shapes.kind = &fc_kind_triangle;
  shapes.items = triangles;
  shapes.vertices = vertices;
  shapes.count = count;
  shapes.vertex_count = vertex_count;
  scene.shapes = &shapes;
  scene.shape_count = 1;
  scene.materials = materials;
  scene.material_count = 1;
  for (i = 0; i < count; i++) {
    triangles[i].material = 0;
    triangles[i].object = (uint16_t)(i + 1);
  }
}

static void set_triangle(uint16_t i, uint16_t a, uint16_t b, uint16_t c) {
  triangles[i].vertex[0] = a;
  triangles[i].vertex[1] = b;
  triangles[i].vertex[2] = c;
}

static fc_vec3 random_vec(uint8_t bits) {
  return vec(random_any_size(bits), random_any_size(bits), random_any_size(bits));
}

static int shoot(fc_vec3 origin, fc_vec3 direction, fc_hit *hit) {
  fc_ray ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.t_min_q32 = 0;
  ray.t_max_q32 = UINT64_MAX;
  return fc_intersect(&scene, &ray, hit);
}

/* How many of the triangles, each alone in the scene, the ray hits. */
static int hits_alone(fc_vec3 origin, fc_vec3 direction, uint16_t count) {
  fc_hit hit;
  int hits = 0;
  uint16_t i;
  for (i = 0; i < count; i++) {
    shapes.items = &triangles[i];
    shapes.count = 1;
    hits += shoot(origin, direction, &hit);
  }
  shapes.items = triangles;
  shapes.count = count;
  return hits;
}

static fc_vec3 add(fc_vec3 a, fc_vec3 b) { return vec(a.x + b.x, a.y + b.y, a.z + b.z); }
static fc_vec3 sub(fc_vec3 a, fc_vec3 b) { return vec(a.x - b.x, a.y - b.y, a.z - b.z); }
static fc_vec3 times(fc_vec3 a, int32_t k) { return vec(a.x * k, a.y * k, a.z * k); }

/* (a x b) . c, 22 bits each */
static int64_t volume(fc_vec3 a, fc_vec3 b, fc_vec3 c) {
  return ((int64_t)a.y * b.z - (int64_t)a.z * b.y) * c.x + ((int64_t)a.z * b.x - (int64_t)a.x * b.z) * c.y +
         ((int64_t)a.x * b.y - (int64_t)a.y * b.x) * c.z;
}

/* Family 1: a ray through a point exactly on the edge of two triangles hits exactly one of them. */
static void test_g1_shared_edge_is_hit_once(void) {
  int trial, used = 0;
  for (trial = 0; trial < 4000; trial++) {
    fc_vec3 o = random_vec(12), d = random_vec(8), p = add(o, times(d, random_within(1, 200))), v = random_vec(8);
    vertices[0] = add(p, times(v, random_within(1, 40)));
    vertices[1] = sub(p, times(v, random_within(1, 40)));
    vertices[2] = add(p, random_vec(14));
    vertices[3] = add(p, random_vec(14));
    use(4, 2);
    if (random_u64() & 1)
      set_triangle(0, 0, 1, 2);
    else
      set_triangle(0, 2, 1, 0);
    if (random_u64() & 1)
      set_triangle(1, 3, 1, 0);
    else
      set_triangle(1, 0, 3, 1);
    /* seen from the origin, the third vertices must lie on different sides of the edge's plane */
    {
      int64_t a = volume(sub(vertices[0], o), sub(vertices[1], o), sub(vertices[2], o));
      int64_t b = volume(sub(vertices[0], o), sub(vertices[1], o), sub(vertices[3], o));
      if (a == 0 || b == 0 || (a > 0) == (b > 0)) continue;
    }
    used++;
    TEST_ASSERT_EQUAL_INT(1, hits_alone(o, d, 2));
  }
  TEST_ASSERT_GREATER_THAN_INT(1000, used);
}

/* Family 2: the centre of a fan that surrounds the ray. */
static void test_g1_fan_centre_is_hit_once(void) {
  static const int32_t rim[12][2] = {{10, 0}, {9, 5}, {5, 9}, {0, 10}, {-5, 9}, {-9, 5}, {-10, 0}, {-9, -5}, {-5, -9}, {0, -10}, {5, -9}, {9, -5}};
  int trial;
  for (trial = 0; trial < 1000; trial++) {
    uint16_t n = (uint16_t)random_within(3, 12), i;
    fc_vec3 u = random_vec(9), w = random_vec(9), d = random_vec(9), o = random_vec(14);
    fc_vec3 centre = add(o, times(d, random_within(1, 100)));
    if (volume(u, w, d) == 0) continue;
    use((uint16_t)(n + 1), n);
    vertices[n] = centre;
    for (i = 0; i < n; i++) {
      const int32_t *r = rim[i * 12 / n];
      /* the rim may rise or sink along the ray without leaving its place around it */
      vertices[i] = add(add(centre, add(times(u, r[0]), times(w, r[1]))), times(d, random_within(-3, 3)));
    }
    for (i = 0; i < n; i++) {
      uint16_t j = (uint16_t)((i + 1) % n);
      if (random_u64() & 1)
        set_triangle(i, n, i, j);
      else
        set_triangle(i, j, i, n);
    }
    TEST_ASSERT_EQUAL_INT(1, hits_alone(o, d, n));
  }
}

/* Family 15: vertex order and winding change nothing but `inside`. */
static void test_vertex_order_changes_nothing(void) {
  static const uint16_t order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  int trial, hits = 0;
  for (trial = 0; trial < 1000; trial++) {
    fc_vec3 o = random_vec(29), d;
    fc_hit first, hit;
    int i, result;
    for (i = 0; i < 3; i++) vertices[i] = random_vec(29);
    d = vec(vertices[0].x / 8 + vertices[1].x / 8 - o.x / 4, vertices[0].y / 8 + vertices[2].y / 8 - o.y / 4,
            vertices[1].z / 8 + vertices[2].z / 8 - o.z / 4);
    if ((d.x | d.y | d.z) == 0) continue;
    use(3, 1);
    set_triangle(0, 0, 1, 2);
    result = shoot(o, d, &first);
    hits += result;
    for (i = 1; i < 6; i++) {
      set_triangle(0, order[i][0], order[i][1], order[i][2]);
      TEST_ASSERT_EQUAL_INT(result, shoot(o, d, &hit));
      if (result == 0) continue;
      TEST_ASSERT_EQUAL_UINT64(first.t_q32, hit.t_q32);
      TEST_ASSERT_EQUAL_INT32(first.position.x, hit.position.x);
      TEST_ASSERT_EQUAL_INT32(first.normal_q30.y, hit.normal_q30.y);
      TEST_ASSERT_EQUAL_INT(i < 3 ? first.inside : !first.inside, hit.inside);
      TEST_ASSERT_EQUAL_UINT32(first.barycentric_q30[order[i][0]], hit.barycentric_q30[0]);
    }
  }
  TEST_ASSERT_GREATER_THAN_INT(100, hits);
}

/* Families 3 and 4 at full size: rays a unit or so beside an edge, where only the exact sum can tell. The expectation is
 * the sign of each edge form from 128-bit products, ties by the first component of N that is not 0. */
static void test_g2_filter_never_contradicts_the_exact_sum(void) {
  static const int64_t origin[3] = {0, 0, 0};
  int trial, hits = 0, undecided = 0;
  for (trial = 0; trial < 3000; trial++) {
    fc_form form = {0};
    fc_prepared prepared;
    fc_root root[2];
    int64_t d[3], *a = form.u.triangle.vertex[0], *b = form.u.triangle.vertex[1];
    bool inside = true;
    int i, j;
    int8_t side;
    form.u.triangle.hidden = 0;
    for (j = 0; j < 3; j++) {
      d[j] = random_any_size(28);
      a[j] = random_any_size(28);
      b[j] = 3 * d[j] - 2 * a[j] + random_within(-1, 1); /* the line a b passes 3 d / 3 within a unit */
      form.u.triangle.vertex[2][j] = random_any_size(29);
    }
    if ((d[0] | d[1] | d[2]) == 0) continue;
    fc_kind_triangle.prepare(&form, origin, &prepared);
    side = fc_i128_sign(prepared.u.triangle.side);
    for (i = 0; i < 3; i++) {
      const int64_t *n = prepared.u.triangle.edge[i];
      fc_i128 sum = fc_i128_add(fc_i128_mul(n[0], d[0]), fc_i128_add(fc_i128_mul(n[1], d[1]), fc_i128_mul(n[2], d[2])));
      int8_t sign = fc_i128_sign(sum);
      for (j = 0; j < 3 && sign == 0; j++) sign = (int8_t)((n[j] > 0) - (n[j] < 0));
      inside = inside && sign == side && side != 0;
      undecided += fc_i128_bits(sum) < 62;
    }
    hits += inside;
    TEST_ASSERT_EQUAL_INT(inside, fc_kind_triangle.test(&prepared, d, root));
  }
  TEST_ASSERT_GREATER_THAN_INT(100, hits);
  TEST_ASSERT_GREATER_THAN_INT(100, undecided);
}

/* Families 10 to 14: parallel, behind, starting in the triangle, degenerate: all missed. */
static void test_cases_that_miss(void) {
  fc_hit hit;
  use(3, 1);
  set_triangle(0, 0, 1, 2);
  vertices[0] = vec(0, 0, 10);
  vertices[1] = vec(100, 0, 10);
  vertices[2] = vec(0, 100, 10);
  TEST_ASSERT_EQUAL_INT(1, shoot(vec(20, 20, 9), vec(0, 0, 1), &hit));
  TEST_ASSERT_EQUAL_INT(0, shoot(vec(20, 20, 10), vec(0, 0, 1), &hit));
  TEST_ASSERT_EQUAL_INT(0, shoot(vec(20, 20, 11), vec(0, 0, 1), &hit));
  TEST_ASSERT_EQUAL_INT(1, shoot(vec(20, 20, 11), vec(0, 0, -1), &hit));
  TEST_ASSERT_TRUE(!hit.inside);
  TEST_ASSERT_EQUAL_INT(0, shoot(vec(-20, 20, 10), vec(1, 0, 0), &hit));
  TEST_ASSERT_EQUAL_INT(0, shoot(vec(-20, 20, 11), vec(1, 0, 0), &hit));
  vertices[2] = vec(50, 0, 10); /* a line */
  TEST_ASSERT_EQUAL_INT(0, shoot(vec(50, 0, 0), vec(0, 0, 1), &hit));
  set_triangle(0, 0, 1, 1);
  TEST_ASSERT_EQUAL_INT(0, shoot(vec(50, 0, 0), vec(0, 0, 1), &hit));
  set_triangle(0, 1, 1, 1);
  TEST_ASSERT_EQUAL_INT(0, shoot(vec(100, 0, 0), vec(0, 0, 1), &hit));
}

/* Family 9: n . D = 1; t is an exact ratio. */
static void test_grazing_ray_has_exact_t(void) {
  fc_hit hit;
  int32_t k;
  for (k = 1; k < 1000; k += 37) {
    use(3, 1);
    set_triangle(0, 0, 1, 2);
    vertices[0] = vec(-1, -1, 0);
    vertices[1] = vec(1 << 28, -1, 0);
    vertices[2] = vec(-1, 1 << 28, 0);
    TEST_ASSERT_EQUAL_INT(1, shoot(vec(0, 0, k), vec(1 << 18, 3, -1), &hit));
    TEST_ASSERT_EQUAL_UINT64((uint64_t)k << 32, hit.t_q32);
    TEST_ASSERT_EQUAL_INT32(k << 18, hit.position.x);
    TEST_ASSERT_EQUAL_INT32(0, hit.position.z);
    TEST_ASSERT_EQUAL_INT32(1 << 30, hit.normal_q30.z);
  }
}

/* Family 40: every field at its largest magnitude. */
static void test_extreme_magnitudes(void) {
  const int32_t m = FC_COORDINATE_MAX;
  fc_hit hit;
  use(3, 1);
  set_triangle(0, 0, 1, 2);
  vertices[0] = vec(-m, -m, m);
  vertices[1] = vec(m, -m, m);
  vertices[2] = vec(-m, m, m);
  /* from the far corner to (0, 0, m): exactly on the edge that a second triangle shares */
  vertices[3] = vec(m, m, m);
  use(4, 2);
  set_triangle(1, 3, 1, 2);
  TEST_ASSERT_EQUAL_INT(1, hits_alone(vec(-m, -m, -m), vec((m - 1) / 2, (m - 1) / 2, m - 1), 2));
  use(3, 1);
  TEST_ASSERT_EQUAL_INT(1, shoot(vec(0, -1, -m), vec(0, 0, m), &hit));
  TEST_ASSERT_EQUAL_UINT64(UINT64_C(2) << 32, hit.t_q32);
  TEST_ASSERT_EQUAL_INT32(m, hit.position.z);
  TEST_ASSERT_EQUAL_INT(0, shoot(vec(1, 0, -m), vec(0, 0, m), &hit));
  TEST_ASSERT_EQUAL_INT(0, shoot(vec(1, 0, -m), vec(1, 0, m), &hit));
}

/* Equal t: the lowest number. */
static void test_coincident_triangles_lowest_number(void) {
  fc_hit hit;
  use(3, 3);
  vertices[0] = vec(0, 0, 7);
  vertices[1] = vec(50, 1, 9);
  vertices[2] = vec(3, 60, 8);
  set_triangle(0, 1, 0, 2);
  set_triangle(1, 0, 1, 2);
  set_triangle(2, 2, 0, 1);
  TEST_ASSERT_EQUAL_INT(1, shoot(vec(15, 15, 0), vec(0, 0, 3), &hit));
  TEST_ASSERT_EQUAL_UINT16(0, hit.primitive);
  TEST_ASSERT_EQUAL_UINT16(1, hit.object);
}

static void test_limits_of_t_are_open(void) {
  fc_ray ray = {{0, 0, 0}, {0, 0, 5}, 0, 0};
  fc_hit hit;
  use(3, 1);
  set_triangle(0, 0, 1, 2);
  vertices[0] = vec(-9, -9, 35);
  vertices[1] = vec(9, -9, 35);
  vertices[2] = vec(0, 9, 35);
  ray.t_max_q32 = UINT64_C(7) << 32; /* the hit is at t = 7 */
  TEST_ASSERT_EQUAL_INT(0, fc_intersect(&scene, &ray, &hit));
  ray.t_max_q32++;
  TEST_ASSERT_EQUAL_INT(1, fc_intersect(&scene, &ray, &hit));
  ray.t_min_q32 = (UINT64_C(7) << 32) - 1;
  TEST_ASSERT_EQUAL_INT(1, fc_intersect(&scene, &ray, &hit));
  ray.t_min_q32++;
  TEST_ASSERT_EQUAL_INT(0, fc_intersect(&scene, &ray, &hit));
}

static void test_barycentrics_add_up(void) {
  fc_hit hit;
  use(3, 1);
  set_triangle(0, 0, 1, 2);
  vertices[0] = vec(0, 0, 4);
  vertices[1] = vec(8, 0, 4);
  vertices[2] = vec(0, 8, 4);
  TEST_ASSERT_EQUAL_INT(1, shoot(vec(1, 4, 0), vec(0, 0, 1), &hit));
  TEST_ASSERT_EQUAL_UINT32(UINT32_C(3) << 27, hit.barycentric_q30[0]);
  TEST_ASSERT_EQUAL_UINT32(UINT32_C(1) << 27, hit.barycentric_q30[1]);
  TEST_ASSERT_EQUAL_UINT32(UINT32_C(1) << 29, hit.barycentric_q30[2]);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_g1_shared_edge_is_hit_once);
  RUN_TEST(test_g1_fan_centre_is_hit_once);
  RUN_TEST(test_vertex_order_changes_nothing);
  RUN_TEST(test_g2_filter_never_contradicts_the_exact_sum);
  RUN_TEST(test_cases_that_miss);
  RUN_TEST(test_grazing_ray_has_exact_t);
  RUN_TEST(test_extreme_magnitudes);
  RUN_TEST(test_coincident_triangles_lowest_number);
  RUN_TEST(test_limits_of_t_are_open);
  RUN_TEST(test_barycentrics_add_up);
  return UNITY_END();
}
