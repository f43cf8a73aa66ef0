/*
 * The shadow of a convex mesh, as a whole: the cone from the light over its outline.
 *
 * Seen from a light outside, the averted faces of a convex mesh cover it once, and their border is a convex polygon. A line
 * from the light meets one of them iff it passes inside every edge of that polygon; so some thirty edges stand for hundreds of faces,
 * which then cast nothing on their own. A face that faces the light is not shadowed by its own mesh at all.
 *
 * Convex is what the mesh must be in camera space, after vertices are rounded: the author's margin (fc_shapes.cull) says whether it is.
 */
#include "facet.h"
#include "mesh.h"
#include "planar.h"
#include "scan_kinds.h"
#include "search.h"
#include "segment.h"
#include "triangle_shadow.h"

/* fc_shapes.cull of a margin of 1. */
#define CONVEX 2

/* In the mesh's memory, followed by a number a vertex: those before and after it on the outline, xor; 0 off the outline. */
typedef struct outline {
  int32_t low[3], high[3]; /* a box around the faces that face the light; none: low > high */
  uint16_t edge[2];        /* an edge of the outline, as an averted face runs along it */
  uint8_t known;           /* 0: the faces cast one by one */
  uint8_t clear;           /* nothing keeps the light from what faces it */
  uint8_t unused[2];
} outline;

static outline *outline_of(const void *memory, const fc_shapes *shapes) {
  return (outline *)(void *)((unsigned char *)memory + fc_mesh_bytes(shapes));
}

/* What a table's memory holds of a convex mesh whose outline is known; NULL otherwise. */
static const outline *known_outline(const fc_group *group) {
  const outline *line;
  if (group->shapes.kind != &fc_kind_convex) return NULL;
  line = outline_of(group->memory, &group->shapes);
  return line->known ? line : NULL;
}

static uint16_t *links_of(const outline *line) { return (uint16_t *)(void *)(line + 1); }

uint32_t fc_convex_memory(const fc_shapes *shapes) {
  return (fc_mesh_bytes(shapes) + (uint32_t)sizeof(outline) + shapes->vertex_count * (uint32_t)sizeof(uint16_t) + 7) / 8 * 8;
}

/* ---- finding it ---- */

/*
 * Whether the placed mesh is convex. The margin m of fc_shapes.cull is the least of (a vertex's distance from a face) / (1 + the sum of
 * |its barycentric weights there|) and of a sixteenth of a face's least height. Placing is affine but for roundings below
 * 1/2 an axis, 0.87 in all. They move a face's plane, where it passes below that vertex, by 0.87 times the sum of weights, the
 * vertex by 0.87, and turn the plane by less than 4 * 0.87 / 16 when m is a unit of the camera's grid or more: the distance
 * seen along its normal is then 0.97 of itself at least, and 0.97 > 0.87.
 */
static bool stays_convex(const fc_frame *frame, const fc_shapes *shapes) {
  return shapes->cull >= CONVEX && shapes->cull - CONVEX + frame->view.fine - frame->view.shift >= 0;
}

/* Whether the light is strictly behind a face, exactly. Light and vertices within 2^30. */
static FC_NOINLINE bool averted(const int32_t a[3], const int32_t b[3], const int32_t c[3], const int64_t light[3]) {
  int64_t ab[3], ac[3], n[3], at[3];
  int8_t turn = fc_triangle_turn(a, b, c, light);
  uint8_t j;
  if (turn != 0) return turn < 0;
  for (j = 0; j < 3; j++) {
    ab[j] = (int64_t)b[j] - a[j];
    ac[j] = (int64_t)c[j] - a[j];
    at[j] = a[j] - light[j];
  }
  fc_cross(ab, ac, n);
  return fc_i128_sign(fc_i128_dot(n, at)) < 0;
}

static void grow(outline *line, const int32_t p[3]) {
  uint8_t j;
  for (j = 0; j < 3; j++) {
    if (p[j] < line->low[j]) line->low[j] = p[j];
    if (p[j] > line->high[j]) line->high[j] = p[j];
  }
}

static bool is_averted(const uint8_t *casts, uint16_t i) { return casts[i / 8] >> (i % 8) & 1; }

/* Sets the bits of averted faces, and the links: each edge between two averted faces is counted twice, which leaves nothing. */
static void sort_faces(const fc_frame *frame, const fc_shapes *shapes, const fc_placed_vertex *vertices, uint8_t *casts,
                       outline *line) {
  uint16_t *link = links_of(line), i;
  uint8_t j;
  for (i = 0; i < shapes->vertex_count; i++) link[i] = 0;
  for (j = 0; j < 3; j++) {
    line->low[j] = INT32_MAX;
    line->high[j] = INT32_MIN;
  }
  for (i = 0; i < shapes->count; i++) {
    fc_triangle copy;
    const fc_triangle *t = fc_triangle_at(shapes, i, &copy);
    const uint16_t a = t->vertex[0], b = t->vertex[1], c = t->vertex[2];
    if (i % 8 == 0) casts[i / 8] = 0;
    if (averted(vertices[a].p, vertices[b].p, vertices[c].p, frame->lights)) {
      link[a] = (uint16_t)(link[a] ^ b ^ c);
      link[b] = (uint16_t)(link[b] ^ c ^ a);
      link[c] = (uint16_t)(link[c] ^ a ^ b);
      casts[i / 8] = (uint8_t)(casts[i / 8] | 1u << (i % 8));
    } else {
      grow(line, vertices[a].p);
      grow(line, vertices[b].p);
      grow(line, vertices[c].p);
    }
  }
}

/* Whether some averted face runs from a to b. */
static bool runs(const fc_shapes *shapes, const uint8_t *casts, uint16_t a, uint16_t b) {
  uint16_t i;
  for (i = 0; i < shapes->count; i++) {
    fc_triangle copy;
    const fc_triangle *t = fc_triangle_at(shapes, i, &copy);
    if (!((t->vertex[0] == a && t->vertex[1] == b) || (t->vertex[1] == a && t->vertex[2] == b) ||
          (t->vertex[2] == a && t->vertex[0] == b)))
      continue;
    if (is_averted(casts, i)) return true;
  }
  return false;
}

/* An edge between an averted face and one that is not. */
static bool find_edge(const fc_shapes *shapes, const uint8_t *casts, outline *line) {
  const uint16_t *link = links_of(line);
  uint16_t i;
  uint8_t j;
  for (i = 0; i < shapes->count; i++) {
    fc_triangle copy;
    const fc_triangle *t = fc_triangle_at(shapes, i, &copy);
    if (!is_averted(casts, i)) continue;
    for (j = 0; j < 3; j++) {
      const uint16_t a = t->vertex[j], b = t->vertex[j == 2 ? 0 : j + 1];
      if (link[a] == 0 || link[b] == 0 || runs(shapes, casts, b, a)) continue;
      line->edge[0] = a;
      line->edge[1] = b;
      return true;
    }
  }
  return false;
}

/* Follows the outline: the vertex after `at`. */
static uint16_t follow(const uint16_t *link, uint16_t before, uint16_t at) { return link[at] ^ before; }

/* Whether the links make one round of all vertices that have one: what a convex mesh gives, and what keeps others from harm. */
static bool is_round(const outline *line, uint16_t vertices) {
  const uint16_t *link = links_of(line);
  uint16_t before = line->edge[0], at = line->edge[1], steps = 0, all = 0, i;
  for (i = 0; i < vertices; i++) all = (uint16_t)(all + (link[i] != 0));
  do {
    const uint16_t after = follow(link, before, at);
    if (after >= vertices || link[after] == 0 || ++steps > all) return false;
    before = at;
    at = after;
  } while (before != line->edge[0] || at != line->edge[1]);
  return steps == all && all >= 3;
}

/* Finds the outline of a projected mesh and clears its casting bits; false when faces have to cast one by one. */
static bool find_outline(const fc_frame *frame, const fc_shapes *shapes, void *memory) {
  const fc_placed_mesh *mesh = memory;
  uint8_t *casts = (uint8_t *)memory + (fc_mesh_casts(mesh, shapes) - (const uint8_t *)memory);
  outline *line = outline_of(memory, shapes);
  size_t i;
  line->known = line->clear = 0;
  if (frame->light != FC_LIGHT_ONE || !stays_convex(frame, shapes)) return false;
  sort_faces(frame, shapes, fc_mesh_vertices(mesh), casts, line);
  if (!find_edge(shapes, casts, line) || !is_round(line, shapes->vertex_count)) return false;
  for (i = 0; i < ((size_t)shapes->count + 7) / 8; i++) casts[i] = 0;
  line->known = 1;
  return true;
}

void fc_convex_project(const fc_frame *frame, const fc_shapes *shapes, void *memory) {
  fc_mesh_project(frame, shapes, memory);
  if (!find_outline(frame, shapes, memory)) fc_mesh_set_casts(frame, shapes, memory);
}

void fc_convex_strip(fc_scan *scan, uint16_t rows) {
  const outline *line = known_outline(&scan->at->group);
  scan->clear = line != NULL && line->clear;
  fc_triangle_strip(scan, rows);
  scan->clear = false;
}

/* ---- a walk along it ---- */

/* The next edge, its ends relative to the light: declare, start with walk_start, then while (walk_next(&walk)). */
typedef struct edge_walk {
  const uint16_t *link;
  const fc_placed_vertex *vertices;
  int32_t light[3];
  int32_t a[3], b[3];
  uint16_t before, at, first;
  bool begun;
} edge_walk;

static void relative(const edge_walk *walk, uint16_t vertex, int32_t to[3]) {
  const int32_t *p = walk->vertices[vertex].p;
  to[0] = p[0] - walk->light[0]; /* 30 bits each */
  to[1] = p[1] - walk->light[1];
  to[2] = p[2] - walk->light[2];
}

static void walk_start(edge_walk *walk, const fc_frame *frame, const fc_group *group, const outline *line) {
  uint8_t j;
  walk->link = links_of(line);
  walk->vertices = fc_mesh_vertices(group->memory);
  for (j = 0; j < 3; j++) walk->light[j] = (int32_t)frame->lights[j];
  walk->before = line->edge[0];
  walk->at = walk->first = line->edge[1];
  walk->begun = false;
  relative(walk, walk->at, walk->b);
}

static bool walk_next(edge_walk *walk) {
  const uint16_t after = follow(walk->link, walk->before, walk->at);
  if (walk->begun && walk->at == walk->first) return false;
  walk->begun = true;
  walk->before = walk->at;
  walk->at = after;
  walk->a[0] = walk->b[0];
  walk->a[1] = walk->b[1];
  walk->a[2] = walk->b[2];
  relative(walk, after, walk->b);
  return true;
}

/* Whether some edge of the outline has the receiver's four corners on its outer side. Averted faces are on the side of an edge where
 * W.(A x B) is below 0. */
static FC_NOINLINE bool is_apart(edge_walk *walk, const fc_planar *receiver) {
  while (walk_next(walk)) {
    int32_t n[3];
    uint8_t i;
    const uint32_t all = fc_abs32(walk->a[0]) | fc_abs32(walk->a[1]) | fc_abs32(walk->a[2]);
    if (!fc_glance_edge(walk->a, walk->b, fc_glance_shift(all), n)) continue;
    for (i = 0; i < 4; i++) {
      const int16_t *w = receiver->corner[i];
      if (n[0] * w[0] + n[1] * w[1] + n[2] * w[2] <= FC_GLANCE_ERROR) break;
    }
    if (i == 4) return true;
  }
  return false;
}

/* ---- casting it ---- */

/* The columns of a tile's rows that may lie inside the outline, and those that do for certain. */
typedef struct outline_rows {
  uint16_t first[FC_SCAN_ROWS], last[FC_SCAN_ROWS], inner_first[FC_SCAN_ROWS], inner_last[FC_SCAN_ROWS]; /* last: one beyond */
} outline_rows;

/* Cuts columns first .. end - 1 to the inner side of an edge, and inner_first .. inner_end - 1 to where that is certain: mostly the same,
 * so that is looked for from there. */
static void cut_row(const fc_shadow_edge *edge, int32_t at, uint16_t columns, outline_rows *rows, uint16_t row) {
  int32_t from = rows->first[row], to = rows->last[row] - 1, inner_from = rows->inner_first[row], inner_to = rows->inner_last[row] - 1;
  fc_facet_cut(at, edge->dx, 0, columns, &from, &to);
  if (inner_from < from) inner_from = from;
  if (inner_to > to) inner_to = to;
  while (inner_from <= inner_to && at + edge->dx * inner_from < edge->certain) inner_from++;
  while (inner_from <= inner_to && at + edge->dx * inner_to < edge->certain) inner_to--;
  rows->first[row] = (uint16_t)from;
  rows->last[row] = (uint16_t)(to < from ? from : to + 1);
  rows->inner_first[row] = (uint16_t)inner_from;
  rows->inner_last[row] = (uint16_t)(inner_to < inner_from ? inner_from : inner_to + 1);
}

/* Cuts the rows to one side of an edge; false when nothing is left of them. */
static FC_NOINLINE bool cut_rows(const fc_scan *scan, const fc_shadow_edge *edge, outline_rows *rows) {
  int32_t right = edge->dx * (scan->columns - 1), down = edge->dy * (scan->rows - 1), at = edge->at;
  uint16_t row;
  bool any = false;
  if (at + (right < 0 ? right : 0) + (down < 0 ? down : 0) >= edge->certain) return true;
  for (row = 0; row <= scan->last_row; row++, at += edge->dy) {
    if (row < scan->first_row || rows->first[row] >= rows->last[row]) continue;
    /* a row on one side of the edge needs no search */
    if (at + (right > 0 ? right : 0) < 0) {
      rows->last[row] = rows->inner_last[row] = rows->first[row];
      rows->inner_first[row] = rows->first[row];
    } else if (at + (right < 0 ? right : 0) < edge->certain) {
      cut_row(edge, at, scan->columns, rows, row);
    }
    if (rows->first[row] < rows->last[row]) any = true;
  }
  return any;
}

/* What the mesh's vertices are to a receiver: all on the light's side of it, at most one in its plane; or more than that. */
enum {
  SIDE_CLEAR = 0,
  SIDE_TOUCHES = 1,
  SIDE_CROSSES = 2
};

static FC_NOINLINE uint8_t side_of_mesh(const fc_planar *receiver, const fc_group *group, uint16_t *touching) {
  const fc_placed_vertex *vertices = fc_mesh_vertices(group->memory);
  uint16_t i;
  uint8_t how = SIDE_CLEAR, j;
  int32_t n[3];
  for (j = 0; j < 3; j++) n[j] = (int32_t)receiver->normal[j];
  for (i = 0; i < group->shapes.vertex_count; i++) {
    const int32_t *p = vertices[i].p;
    /* 30 + 30 bits, three terms; further off than the slack is certain */
    int64_t side = receiver->k - (fc_product(n[0], p[0]) + fc_product(n[1], p[1]) + fc_product(n[2], p[2]));
    if (side > receiver->slack) continue;
    {
      int64_t wide[3];
      for (j = 0; j < 3; j++) wide[j] = p[j];
      side = fc_planar_side(receiver, wide);
    }
    if (side > 0) continue;
    if (side < 0 || how != SIDE_CLEAR) return SIDE_CROSSES;
    how = SIDE_TOUCHES;
    *touching = i;
  }
  return how;
}

/* The pixel that sees just this vertex, which touches the receiver there and does not shadow it, is no longer in the mask; *bit of
 * *word says where it was. */
static FC_COLD void spare(fc_scan *scan, const int32_t p[3], uint32_t **word, uint32_t *bit) {
  int64_t d[3], step;
  uint16_t row, column;
  if (p[2] <= 0) return;
  fc_scan_direction(scan, d, &step);
  for (row = 0; row <= scan->last_row; row++, d[1] -= step) {
    if (row < scan->first_row || d[1] * p[2] != p[1] * d[2]) continue; /* 30 + 31 bits */
    for (column = 0; column < scan->columns; column++, d[0] += step) {
      if (d[0] * p[2] != p[0] * d[2]) continue;
      *word = &scan->mask[row * scan->words + column / 32];
      *bit = **word & UINT32_C(1) << (column % 32);
      **word &= ~*bit;
      return;
    }
    return;
  }
}

/* A pixel that the outline leaves open: any face may block it. */
static FC_COLD void ask_all(fc_scan *scan, uint16_t row, int32_t column, const fc_kind *kind, const fc_group *group) {
  const uint32_t bit = UINT32_C(1) << (column % 32);
  uint16_t i;
  if (!(scan->mask[row * scan->words + column / 32] & bit)) return;
  for (i = 0; i < group->shapes.count; i++) {
    fc_form form;
    fc_triangle_fetch(group, i, &form);
    if (!fc_scan_blocked(scan, row, (uint16_t)column, kind, &form)) continue;
    fc_planar_darken(scan, row, (uint16_t)column, bit);
    return;
  }
}

static FC_COLD void cast_each(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_group *group) {
  uint16_t i;
  for (i = 0; i < group->shapes.count; i++) {
    fc_form form;
    fc_triangle_fetch(group, i, &form);
    fc_triangle_shadow(scan, receiver, kind, &form);
  }
}

static FC_NOINLINE void darken_rows(fc_scan *scan, const outline_rows *rows, const fc_kind *kind, const fc_group *group) {
  uint16_t row;
  for (row = scan->first_row; row <= scan->last_row; row++) {
    const uint16_t first = rows->inner_first[row], end = rows->inner_last[row];
    int32_t column;
    for (column = rows->first[row]; column < rows->last[row]; column++) {
      if (column == first && first < end) column = end;
      if (column < rows->last[row]) ask_all(scan, row, column, kind, group);
    }
    if (first < end) fc_shadow_darken(scan, row, first, end - 1);
  }
}

/* Where the cone meets the tile; false when it does not. */
static FC_NOINLINE bool find_rows(const fc_scan *scan, const fc_planar *receiver, edge_walk *walk, outline_rows *rows) {
  uint16_t row;
  for (row = 0; row < FC_SCAN_ROWS; row++) {
    rows->first[row] = rows->inner_first[row] = 0;
    rows->last[row] = rows->inner_last[row] = row >= receiver->top && row <= receiver->bottom ? scan->columns : 0;
  }
  while (walk_next(walk)) {
    fc_shadow_edge edge;
    if (!fc_shadow_edge_find(scan, receiver, walk->a, walk->b, -1, &edge) || !cut_rows(scan, &edge, rows)) return false;
  }
  return true;
}

static FC_NOINLINE void cast_cone(fc_scan *scan, const fc_planar *receiver, const fc_kind *kind, const fc_group *group,
                                  const outline *line, const int32_t *touching) {
  outline_rows rows;
  edge_walk walk;
  uint32_t *word = NULL, bit = 0;
  walk_start(&walk, scan->frame, group, line);
  if (!find_rows(scan, receiver, &walk, &rows)) return;
  if (touching != NULL) spare(scan, touching, &word, &bit);
  darken_rows(scan, &rows, kind, group);
  if (word != NULL) *word |= bit;
}

void fc_convex_cast(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_group *group) {
  const outline *line = known_outline(group);
  uint16_t touching = 0;
  uint8_t how;
  if (line == NULL || group->first == scan->at->group.first) return; /* light is what falls on faces that face it */
  if (receiver->w.error >> 14 == 0) {
    edge_walk walk;
    if (!receiver->corners_known) fc_planar_find_corners(receiver);
    walk_start(&walk, scan->frame, group, line);
    if (is_apart(&walk, receiver)) return;
  }
  how = side_of_mesh(receiver, group, &touching);
  if (how == SIDE_CROSSES)
    cast_each(scan, receiver, kind, group);
  else
    cast_cone(scan, receiver, kind, group, line,
              how == SIDE_TOUCHES ? fc_mesh_vertices(group->memory)[touching].p : NULL);
}

/* ---- what cannot be shadowed ---- */

typedef struct settling {
  const fc_frame *frame;
  uint16_t own; /* the table's first primitive */
  int64_t center[3], radius;
} settling;

/* Whether an item may come between the light and the table. */
static bool may_shadow(void *context, const fc_cursor *at, uint16_t index) {
  const settling *s = context;
  const fc_kind *kind = fc_kind_of(at);
  fc_window window;
  fc_form form;
  if (kind->casts != NULL && !kind->casts(&at->group, index)) return false;
  kind->fetch(&at->group, index, &form);
  return kind->between(s->frame, &form, s->frame->lights, s->center, s->radius, &window);
}

/* A mesh's placed vertices seen from the light, its outline and what brings them to 14 bits. */
typedef struct seen_mesh {
  const fc_group *group;
  const outline *line;
  uint8_t shift;
} seen_mesh;

static void see_mesh(const fc_frame *frame, const fc_group *group, const outline *line, seen_mesh *mesh) {
  edge_walk walk;
  uint32_t all = 0;
  mesh->group = group;
  mesh->line = line;
  walk_start(&walk, frame, group, line);
  while (walk_next(&walk)) all |= fc_abs32(walk.b[0]) | fc_abs32(walk.b[1]) | fc_abs32(walk.b[2]);
  mesh->shift = all >> 14 == 0 ? 0 : (uint8_t)(18 - fc_clz32(all));
}

/* Whether an edge of one outline has the whole other one on its outer side: both are convex, so if any line parts them, an edge of
 * the one or of the other does. */
static bool parted(const fc_frame *frame, const seen_mesh *by, const seen_mesh *other) {
  /* as for W, but off by up to 1 instead of 3/4: 147515 + 3 * 2^15 */
  const int32_t error = 246000;
  edge_walk edges, walk;
  walk_start(&edges, frame, by->group, by->line);
  while (walk_next(&edges)) {
    const uint32_t all = fc_abs32(edges.a[0]) | fc_abs32(edges.a[1]) | fc_abs32(edges.a[2]);
    int32_t n[3];
    bool outer = true;
    if (!fc_glance_edge(edges.a, edges.b, fc_glance_shift(all), n)) continue;
    walk_start(&walk, frame, other->group, other->line);
    while (outer && walk_next(&walk)) /* 15 bits each, three terms */
      outer = n[0] * fc_floor_shift32(walk.b[0], other->shift) + n[1] * fc_floor_shift32(walk.b[1], other->shift) +
                  n[2] * fc_floor_shift32(walk.b[2], other->shift) >
              error;
    if (outer) return true;
  }
  return false;
}

/* Whether other outlines may shadow a table's. */
static bool outlines_meet(const fc_frame *frame, const fc_group *group, const outline *line) {
  const fc_space space = fc_space_of_frame(frame);
  seen_mesh own, other;
  fc_cursor at;
  see_mesh(frame, group, line, &own);
  fc_cursor_start(&at, &space);
  while (fc_cursor_next(&at)) {
    if (at.group.shapes.kind != group->shapes.kind || at.group.first == group->first) continue;
    if (known_outline(&at.group) == NULL) continue;
    see_mesh(frame, &at.group, known_outline(&at.group), &other);
    if (!parted(frame, &own, &other) && !parted(frame, &other, &own)) return true;
  }
  return false;
}

void fc_convex_settle(const fc_frame *frame, const fc_group *group) {
  outline *line = (outline *)known_outline(group);
  fc_space space = fc_space_of_frame(frame);
  int64_t corners[24];
  uint64_t square = 0;
  settling s;
  fc_reach reach;
  uint8_t i;
  if (line == NULL) return;
  s.frame = frame;
  s.own = group->first;
  for (i = 0; i < 24; i++) corners[i] = (i / 3) >> (i % 3) & 1 ? line->high[i % 3] : line->low[i % 3];
  for (i = 0; i < 3; i++) {
    /* 31 bits, halved: below 2^60 */
    const int64_t side = ((int64_t)line->high[i] - line->low[i]) / 2 + 1;
    s.center[i] = ((int64_t)line->high[i] + line->low[i]) / 2;
    square += (uint64_t)(side * side);
  }
  s.radius = (int64_t)fc_sqrt64(square) + 1;
  space.entered = frame->casters;
  reach.from = frame->lights;
  reach.to = corners;
  reach.corners = 8;
  reach.radius = 0;
  reach.limited = false;
  line->clear = !fc_space_search(&space, &reach, may_shadow, &s) && !outlines_meet(frame, group, line);
}
