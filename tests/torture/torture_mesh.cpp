/* Closed meshes: rays aimed at their edges and vertices from one origin all cross them equally often,
 * modulo 2 (17). */
#include "trial.h"

namespace {

constexpr int rays_a_trial = 512, most_vertices = 16, most_faces = 28;

struct Mesh {
  Vec vertex[most_vertices];
  uint8_t face[most_faces][3];
  int vertices, faces;
  bool around_zero; /* star-shaped around (0, 0, 0) */
};

void add_face(Mesh *mesh, int a, int b, int c) {
  uint8_t *face = mesh->face[mesh->faces++];
  face[0] = static_cast<uint8_t>(a);
  face[1] = static_cast<uint8_t>(b);
  face[2] = static_cast<uint8_t>(c);
}

/* The two poles at the ends of an axis and a ring of 3 to 12 between them. */
void bipyramid(Random &random, Mesh *mesh, int64_t size) {
  static const int8_t circle[12][2] = {{10, 0}, {9, 5}, {5, 9}, {0, 10}, {-5, 9}, {-9, 5}, {-10, 0}, {-9, -5}, {-5, -9}, {0, -10}, {5, -9}, {9, -5}};
  int ring = static_cast<int>(random.within(3, 12)), turn = static_cast<int>(random.within(0, 2));
  mesh->vertices = ring + 2;
  for (int i = 0; i < ring; i++) {
    /* radial stretching keeps the ring around the axis */
    int64_t stretch = random.within(1, size);
    mesh->vertex[i] = {circle[i * 12 / ring][0] * stretch, circle[i * 12 / ring][1] * stretch, 0};
  }
  mesh->vertex[ring] = {0, 0, 10 * random.within(1, size)};
  mesh->vertex[ring + 1] = {0, 0, -10 * random.within(1, size)};
  for (int i = 0; i < ring; i++) {
    add_face(mesh, i, (i + 1) % ring, ring);
    add_face(mesh, i, ring + 1, (i + 1) % ring);
  }
  for (int i = 0; i < mesh->vertices; i++)
    for (int j = 0; j < turn; j++)
      mesh->vertex[i] = {mesh->vertex[i].y, mesh->vertex[i].z, mesh->vertex[i].x};
  mesh->around_zero = true;
}

/* A box of twelve triangles, diagonals at will; sheared, which keeps it convex. */
void box(Random &random, Mesh *mesh, int64_t size) {
  static const uint8_t side[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  Vec e[3];
  do {
    for (Vec &v : e) v = {random.within(-size, size), random.within(-size, size), random.within(-size, size)};
    if (random.flip())
      e[0] = {random.within(1, size), 0, 0}, e[1] = {0, random.within(1, size), 0},
      e[2] = {0, 0, random.within(1, size)};
  } while (dot(cross(e[0], e[1]), e[2]) == 0);
  mesh->vertices = 8;
  for (int i = 0; i < 8; i++)
    mesh->vertex[i] = e[0] * ((i & 1) ? 1 : -1) + e[1] * ((i & 2) ? 1 : -1) + e[2] * ((i & 4) ? 1 : -1);
  for (const uint8_t *s : side) {
    int k = random.flip();
    add_face(mesh, s[k], s[k + 1], s[k + 2]);
    add_face(mesh, s[k], s[k + 2], s[(k + 3) % 4]);
  }
  mesh->around_zero = true;
}

/* A ring with a hole: 4 x 3 quadrilaterals, wound around twice; vertices anywhere, so it may cross itself. */
void torus(Random &random, Mesh *mesh, int64_t size) {
  mesh->vertices = 12;
  for (int i = 0; i < 12; i++)
    mesh->vertex[i] = {random.within(-8 * size, 8 * size), random.within(-8 * size, 8 * size),
                       random.within(-8 * size, 8 * size)};
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 3; j++) {
      int a = 3 * i + j, b = 3 * ((i + 1) % 4) + j, c = 3 * i + (j + 1) % 3,
          d = 3 * ((i + 1) % 4) + (j + 1) % 3;
      if (random.flip()) {
        add_face(mesh, a, b, c);
        add_face(mesh, b, d, c);
      } else {
        add_face(mesh, a, b, d);
        add_face(mesh, a, d, c);
      }
    }
  mesh->around_zero = false;
}

/* Which side of a triangle's plane, by a determinant in an arrangement of its own. */
int side_of(Vec a, Vec b, Vec c, Vec p) {
  using Wide = __int128;
  Vec u = a - p, v = b - p, w = c - p;
  Wide d = static_cast<Wide>(u.z) * (static_cast<Wide>(v.x) * w.y - static_cast<Wide>(v.y) * w.x) -
           static_cast<Wide>(v.z) * (static_cast<Wide>(u.x) * w.y - static_cast<Wide>(u.y) * w.x) +
           static_cast<Wide>(w.z) * (static_cast<Wide>(u.x) * v.y - static_cast<Wide>(u.y) * v.x);
  return (d > 0) - (d < 0);
}

std::string text(const Mesh &mesh) {
  std::string all;
  for (int i = 0; i < mesh.faces; i++)
    all += "\n  " + oracle::text(mesh.vertex[mesh.face[i][0]]) + " " +
           oracle::text(mesh.vertex[mesh.face[i][1]]) + " " + oracle::text(mesh.vertex[mesh.face[i][2]]);
  return all;
}

uint64_t closed_mesh(Random &random) {
  Mesh mesh;
  Vec origin = {0, 0, 0};
  bool inside = random.flip(), convex = false;
  int64_t size = INT64_C(1) << random.within(0, 20);
  mesh.faces = 0;
  switch (random.within(0, 3)) {
    case 0: bipyramid(random, &mesh, size); break;
    case 1: torus(random, &mesh, size); break;
    default: box(random, &mesh, size); convex = true;
  }
  /* coordinates with no common factor of 2, and some distance from the world's origin */
  Vec place = random.vec(28);
  for (int i = 0; i < mesh.vertices; i++) mesh.vertex[i] = mesh.vertex[i] * 2 + place;
  origin = place;
  if (!mesh.around_zero || !inside) {
    /* anywhere, often in the plane of a face or in the line of an edge, but never in the surface: else
     * parity is void */
    const Vec &a = mesh.vertex[random.within(0, mesh.vertices - 1)],
              &b = mesh.vertex[random.within(0, mesh.vertices - 1)];
    if (random.flip())
      origin = a + (a - b) * random.within(1, 2);
    else
      origin = place + Vec{random.within(-9 * size, 9 * size), random.within(-9 * size, 9 * size),
                           random.within(-9 * size, 9 * size)};
  }

  fc_prepared prepared[most_faces];
  int64_t from[3] = {origin.x, origin.y, origin.z};
  for (int i = 0; i < mesh.faces; i++) {
    fc_form form{};
    for (int j = 0; j < 3; j++)
      for (int k = 0; k < 3; k++) form.u.triangle.vertex[j][k] = mesh.vertex[mesh.face[i][j]][k];
    fc_kind_triangle.prepare(&form, from, &prepared[i]);
  }

  /* what the number of crossings must be: exactly 1 from the inside of a star, 0 or 2 from outside a
   * convex body */
  int parity = -1;
  if (mesh.around_zero && inside) parity = 1;
  for (int i = 0; i < mesh.faces && convex && parity < 0; i++) {
    const Vec &a = mesh.vertex[mesh.face[i][0]], &b = mesh.vertex[mesh.face[i][1]],
              &c = mesh.vertex[mesh.face[i][2]];
    if (side_of(a, b, c, origin) * side_of(a, b, c, place) < 0) parity = 0;
  }
  convex = convex && parity == 0;
  bool star = mesh.around_zero && inside;
  /* in the surface itself there is nothing to count */
  for (int i = 0; i < mesh.faces && !star && !convex; i++) {
    const Vec &a = mesh.vertex[mesh.face[i][0]], &b = mesh.vertex[mesh.face[i][1]],
              &c = mesh.vertex[mesh.face[i][2]];
    if (side_of(a, b, c, origin) != 0) continue;
    bool in_box = true;
    for (int j = 0; j < 3; j++)
      in_box = in_box && !(origin[j] < a[j] && origin[j] < b[j] && origin[j] < c[j]) &&
               !(origin[j] > a[j] && origin[j] > b[j] && origin[j] > c[j]);
    if (in_box) return 0;
  }

  for (int i = 0; i < rays_a_trial; i++) {
    const uint8_t *face = mesh.face[random.within(0, mesh.faces - 1)];
    uint64_t kind = random.next() % 16, corner = random.next() % 3;
    Vec a = mesh.vertex[face[corner]] - origin, b = mesh.vertex[face[(corner + 1) % 3]] - origin, d = a;
    if (kind < 9) d = a * random.within(1, 7) + b * random.within(1, 7); /* through an edge */
    if (kind == 9) d = d + random.unit_step();                           /* a little beside it */
    if (kind == 10) d = random.vec(27);
    if (is_zero(d)) continue;
    while (largest(d) > coordinate_max) d = {d.x / 2, d.y / 2, d.z / 2};
    int64_t direction[3] = {d.x, d.y, d.z};
    int hits = 0;
    for (int j = 0; j < mesh.faces; j++) {
      fc_root root[2];
      hits += fc_kind_triangle.test(&prepared[j], direction, root);
    }
    if (parity < 0) parity = hits & 1;
    if ((hits & 1) != parity || (star && hits != 1) || (convex && hits > 2))
      fail("%d crossings from %s along %s; %s%s", hits, oracle::text(origin).c_str(), oracle::text(d).c_str(),
           star     ? "star-shaped around the origin: 1"
           : convex ? "outside a convex body: 0 or 2"
           : parity ? "odd before"
                    : "even before",
           text(mesh).c_str());
  }
  return rays_a_trial;
}

} // namespace

const std::vector<Family> closed_mesh_families = {
    {17, "closed meshes", 2250000, 290, closed_mesh},
};
