/*
 * Searching a hierarchy: the hull of a point and a region, swept through boxes of cells.
 *
 * The sweep. Between two boxes A and B of whole cell borders that hold the two ends, the hull at s in 0 .. 1 lies within
 * A + s (B - A), bound by bound. It meets a node's box iff some s satisfies, on every axis,
 *   A.high + s (B.high - A.high) >= low   and   A.low + s (B.low - A.low) <= high:
 * six conditions of the form s a >= b, each true from some s on or up to some s. No division: the reciprocals of the six a are
 * made once a search, rounded so that a condition is never taken for false where it is true.
 *
 * Ends are brought from camera space to cells with a margin, for the camera's rows are rounded and so is every placed vertex.
 * With R the exact rotation, A = R + E the rows, |E_ij| <= 2^-31 + 2^-58, a world point x (relative to the eye, in grid units,
 * |x| < 2^30: the grid is chosen so) is placed at v = A x + d, |d_i| <= 1/2. Taken back by A',
 *   A' v - x = (A'A - I) x + A' d,   |A'A - I| <= 2 |E| + |E|^2 < 6.01 * 2^-31 (|E| at most its Frobenius norm, 3 * 2^-31),
 * so |A' v - x| < 3.01 + 0.87 an axis. Straight lines stay straight under A', so a triangle's camera-space points come back within
 * 3.9 units of its world-space box. A sphere's radius is rounded by 1/2 and stretched by |A'| <= 1 + 2^-29: 2 units more for
 * radii below 2^30. A region's radius below 2^31 is stretched by 4 units at most. Hence:
 */
#include "bits.h"
#include "bvh.h"
#include "fixcast/error.h"
#include "quick.h"
#include "search.h"

#define MARGIN 10 /* camera grid units: 3.9 + 2 + 4 */

/* ---- ends in cells ---- */

/* Borders of cells, below 2^61. */
typedef struct cell_box {
  int64_t low[3], high[3];
} cell_box;

/* ceil(v / 2^s) */
static int64_t ceil_shift(int64_t v, uint8_t s) { return -fc_floor_shift64(-v, s); }

/* The box of some points and what lies within `radius` of them, an axis; false when they are too far away to say. */
static FC_NOINLINE bool locate(const fc_bvh *bvh, const fc_view *view, const int64_t *points, uint8_t count, int64_t radius,
                               cell_box *box) {
  int64_t origin[3], around = radius;
  uint8_t i, j, k, bits = 0, drop;
  origin[0] = bvh->origin.x;
  origin[1] = bvh->origin.y;
  origin[2] = bvh->origin.z;
  for (k = 0; k < count; k++) {
    uint8_t b = fc_vector_bits(points + 3 * k);
    if (b > bits) bits = b;
  }
  if (bits > (view == NULL ? 60 : 62)) return false;
  drop = bits > 31 ? (uint8_t)(bits - 31) : 0; /* far points in coarser units */
  if (view != NULL) {
    around = (radius + MARGIN + (INT64_C(1) << drop) - 1) >> drop;
    around = (int64_t)((uint64_t)around << 30) + (drop != 0 ? INT64_C(1) << 31 : 0);
  }
  for (i = 0; i < 3; i++) {
    int64_t low = 0, high = 0, eye = -origin[i]; /* 2^62 + 2^31 + 2^31 */
    uint8_t down = bvh->shift;
    for (k = 0; k < count; k++) {
      const int64_t *point = points + 3 * k;
      int64_t along = 0;
      /* Units of 2^(drop - 30) of the camera grid's. A column of the rows is at most 2^30 sqrt(3) in |.|_1: with floors below 2^31
       * in magnitude its dot product is below 2^61.8, an error of 1 an axis below 2^31, radius and margin below 2^61.1: the
       * sums fit. One cell is 2^down of these units. */
      if (view == NULL)
        along = point[i];
      else
        for (j = 0; j < 3; j++) along += fc_smul32(view->row[j][i], (int32_t)fc_floor_shift64(point[j], drop));
      if (k == 0 || along < low) low = along;
      if (k == 0 || along > high) high = along;
    }
    low -= around;
    high += around;
    if (view != NULL) {
      int16_t by = (int16_t)(30 - drop - view->shift + view->fine + bvh->shift);
      if (by >= 0) {
        low = fc_floor_shift64(low, (uint8_t)(by > 63 ? 63 : by));
        high = ceil_shift(high, (uint8_t)(by > 63 ? 63 : by));
      } else {
        if (fc_bits64(fc_abs64(low) | fc_abs64(high)) - by > 60) return false;
        low *= INT64_C(1) << -by;
        high *= INT64_C(1) << -by;
      }
      /* The eye, 2^61, less the origin, 2^31 * 2^31, in 2^(fine + shift) to a cell. */
      eye = view->eye[i] - fc_to_i64((uint64_t)origin[i] << view->fine);
      down = (uint8_t)(view->fine + bvh->shift);
      box->low[i] = low + fc_floor_shift64(eye, down);
      box->high[i] = high + ceil_shift(eye, down);
      if (fc_bits64(fc_abs64(box->low[i]) | fc_abs64(box->high[i])) > 61) return false;
    } else {
      box->low[i] = fc_floor_shift64(low + eye, down);
      box->high[i] = ceil_shift(high + eye, down);
    }
  }
  return true;
}

/* Sides of the root's box that a box lies wholly beyond, a bit each. */
static uint8_t beyond(const cell_box *box) {
  uint8_t i, faces = 0;
  for (i = 0; i < 3; i++) {
    if (box->high[i] < 0) faces = (uint8_t)(faces | 1u << (2 * i));
    if (box->low[i] > FC_BVH_CELLS) faces = (uint8_t)(faces | 2u << (2 * i));
  }
  return faces;
}

#define NEAR_BITS 17

static bool far_off(const cell_box *box) {
  uint8_t i;
  for (i = 0; i < 3; i++)
    if (fc_abs64(box->low[i]) >> NEAR_BITS != 0 || fc_abs64(box->high[i]) >> NEAR_BITS != 0) return true;
  return false;
}

/* Moves a far end of the sweep towards the other one, past what is beyond one side of the root; returns how far, Q62. The sides
 * that an end is beyond are left one by one, so bisection finds where the last of them is. Halving bounds by floor and ceiling
 * gives floor((B - A) / 2^n), so each step taken loosens the box by less than 1. */
static FC_COLD uint64_t draw_near(cell_box *end, const cell_box *other) {
  uint64_t moved = 0, part = UINT64_C(1) << 62;
  cell_box step, next;
  uint8_t faces = beyond(end), i;
  bool small = false;
  if (faces == 0 || !far_off(end)) return 0;
  for (i = 0; i < 3; i++) {
    step.low[i] = other->low[i] - end->low[i]; /* below 2^62 */
    step.high[i] = other->high[i] - end->high[i];
  }
  while (!small) {
    small = true;
    part >>= 1;
    for (i = 0; i < 3; i++) {
      step.low[i] = fc_floor_shift64(step.low[i], 1);
      step.high[i] = ceil_shift(step.high[i], 1);
      if (fc_abs64(step.low[i]) >> 12 != 0 || fc_abs64(step.high[i]) >> 12 != 0) small = false;
      next.low[i] = end->low[i] + step.low[i];
      next.high[i] = end->high[i] + step.high[i];
    }
    if (faces & beyond(&next)) {
      *end = next;
      moved += part;
    }
  }
  return moved;
}

/* ---- the sweep ---- */

/* One bound: the node's is `gap` ahead of the sweep's start. */
typedef struct bound {
  int32_t start;    /* below 2^18 */
  uint32_t rise;    /* how far the sweep moves towards it, or 0; below 2^19 */
  uint32_t fall;    /* ... away from it, or 0 */
  uint32_t inverse; /* 2^31 / rise, floored; 2^31 / fall, rounded up */
} bound;

typedef struct sweep {
  bound at[6];    /* low and high of each axis */
  uint32_t exit;  /* the part of the sweep that matters, Q31 */
  uint16_t round; /* 2^coarse - 1 */
  uint8_t coarse; /* cells are counted in 2^coarse */
  /* of rays: */
  uint64_t begin, end; /* Q62 of the whole way, which is t = 2^scale */
  uint8_t scale, axis; /* the axis along which it moves most */
  bool back;           /* ... downwards */
} sweep;

static void set_bound(bound *b, int64_t start, int64_t change) {
  b->start = (int32_t)start;
  b->rise = change > 0 ? (uint32_t)change : 0;
  b->fall = change < 0 ? (uint32_t)-change : 0;
  b->inverse = 0;
  if (b->rise != 0) b->inverse = (UINT32_C(1) << 31) / b->rise;
  if (b->fall != 0) b->inverse = ((UINT32_C(1) << 31) + b->fall - 1) / b->fall;
}

/* Rounds a t up to the sweep's Q31: by 2^-21 of itself, which is more than its error, and by 2^-23 for the quotient's. */
static FC_COLD uint32_t part_of(const sweep *s, fc_quick t) {
  const uint32_t one = UINT32_C(1) << 31;
  uint64_t at;
  uint32_t part;
  t.e = (int16_t)(t.e + 62 - s->scale);
  if (t.e > 30) return one; /* 2^62 or more */
  at = fc_quick_to_u64(t);
  at += (at >> 21) + 1;
  if (at >= s->end) return one;
  if (at <= s->begin) return 2;
  t = fc_quick_mul(fc_quick_from(at - s->begin, 0), fc_quick_recip(fc_quick_from(s->end - s->begin, 0)));
  part = (uint32_t)fc_quick_to_int(t, 31) + 256;
  return part > one ? one : part;
}

/* The end of a ray: farther out than anything can be, 2^31 in world space and 2^30 in a camera's. */
static FC_COLD uint8_t ray_end(const fc_reach *reach, int64_t to[3]) {
  uint8_t bits = fc_vector_bits(reach->to), from = fc_vector_bits(reach->from), i, scale;
  /* the largest component is at least 2^(33 - 1) and twice the origin's */
  scale = (uint8_t)((from > 31 ? from + 2 : 33) - bits);
  for (i = 0; i < 3; i++) to[i] = reach->from[i] + reach->to[i] * (INT64_C(1) << scale);
  return scale;
}

/* What has to be visited: everything, because the ends are far beyond what is kept of them; nothing; what is met. */
enum {
  VISIT_ALL,
  VISIT_NONE,
  VISIT_MET
};

/* A function of its own: its boxes are off the stack when visitors are called. */
static FC_NOINLINE uint8_t start(sweep *s, const fc_bvh *bvh, const fc_view *view, const fc_reach *reach) {
  cell_box from, to, whole;
  uint8_t i, bits = 0;
  if (reach->radius < 0 || reach->radius >> 31 != 0) return VISIT_ALL;
  if (!locate(bvh, view, reach->from, 1, 0, &from)) return VISIT_ALL;
  s->scale = 0;
  if (reach->corners == 0) {
    int64_t end[3];
    if (fc_vector_bits(reach->to) > 30 || fc_vector_bits(reach->from) > 56) return VISIT_ALL;
    s->scale = ray_end(reach, end);
    if (!locate(bvh, view, end, 1, 0, &to)) return VISIT_ALL;
  } else if (!locate(bvh, view, reach->to, reach->corners, reach->radius, &to)) {
    return VISIT_ALL;
  }
  whole = from;
  s->begin = draw_near(&from, &to);
  s->end = (UINT64_C(1) << 62) - draw_near(&to, &whole);
  if (s->begin >= s->end) return VISIT_NONE; /* beyond one side or another all the way */
  for (i = 0; i < 3; i++) {
    uint8_t b = fc_bits64(fc_abs64(from.low[i]) | fc_abs64(from.high[i]) | fc_abs64(to.low[i]) | fc_abs64(to.high[i]));
    if (b > bits) bits = b;
  }
  s->coarse = bits > NEAR_BITS + 1 ? (uint8_t)(bits - NEAR_BITS - 1) : 0;
  if (s->coarse > 15) return VISIT_ALL;
  s->round = (uint16_t)((1u << s->coarse) - 1);
  s->axis = 0;
  for (i = 0; i < 3; i++) {
    int64_t a, b;
    a = ceil_shift(from.high[i], s->coarse); /* at most 2^18 */
    b = ceil_shift(to.high[i], s->coarse);
    set_bound(&s->at[2 * i], a, b - a);
    a = fc_floor_shift64(from.low[i], s->coarse);
    b = fc_floor_shift64(to.low[i], s->coarse);
    set_bound(&s->at[2 * i + 1], a, a - b);
    if (s->at[2 * i].rise + s->at[2 * i].fall > s->at[2 * s->axis].rise + s->at[2 * s->axis].fall) s->axis = i;
  }
  s->back = s->at[2 * s->axis].fall != 0;
  s->exit = UINT32_C(1) << 31;
  return VISIT_MET;
}

/* Narrows enter .. exit; false when the bound is never reached. Products: gap <= rise, so at most 2^31; gap < fall, so below
 * 2^31 + 2^19. */
static inline bool within(const bound *b, int32_t gap, uint32_t *enter, uint32_t *exit) {
  if (gap > 0) {
    uint32_t t;
    if ((uint32_t)gap > b->rise) return false;
    t = (uint32_t)gap * b->inverse;
    if (t > *enter) *enter = t;
  } else if ((uint32_t)-gap < b->fall) {
    uint32_t t = (uint32_t)-gap * b->inverse;
    if (t < *exit) *exit = t;
  }
  return true;
}

static bool meets(const sweep *s, const fc_bvh_node *node) {
  uint32_t enter = 0, exit = s->exit;
  const bound *b = s->at;
  uint8_t i;
  for (i = 0; i < 3; i++, b += 2) {
    int32_t low = fc_bvh_low(node->axis[i]), high = fc_bvh_high(node->axis[i]);
    if (s->coarse != 0) {
      low = low >> s->coarse;
      high = (high + s->round) >> s->coarse;
    }
    if (!within(&b[0], low - b[0].start, &enter, &exit) || !within(&b[1], b[1].start - high, &enter, &exit)) return false;
  }
  return enter <= exit;
}

/* A node where it lies, or its copy in `to`. */
static inline const fc_bvh_node *node_at(const fc_bvh *bvh, uint32_t node, fc_bvh_node *to) {
#ifdef FC_ROM_FAR
  FC_READ_ONE(to, bvh->nodes + (node - 1));
  return to;
#else
  (void)to;
  return bvh->nodes + (node - 1);
#endif
}

static uint16_t read_order(const fc_bvh *bvh, uint16_t at) {
#ifdef FC_ROM_FAR
  uint16_t primitive;
  FC_READ_ONE(&primitive, bvh->order + at);
  return primitive;
#else
  return bvh->order[at];
#endif
}

/* The child of `node` that a ray meets first, more or less. */
static uint32_t nearer_child(const fc_bvh *bvh, const sweep *s, uint32_t node) {
  fc_bvh_node copy[2];
  uint16_t a = fc_bvh_low(node_at(bvh, 2 * node, &copy[0])->axis[s->axis]);
  uint16_t b = fc_bvh_low(node_at(bvh, 2 * node + 1, &copy[1])->axis[s->axis]);
  return 2 * node + ((a > b) != s->back);
}

static bool search(const fc_bvh *bvh, const fc_space *space, fc_reach *reach, fc_visit *visit, void *context) {
  const uint32_t leaves = fc_bvh_leaves(bvh);
  uint32_t node = 1, done = 1; /* of each level, from the lowest bit up: is this the second child visited? */
  uint8_t what;
  bool all;
  sweep s;
  fc_cursor at;
  if (bvh->count == 0) return false;
  what = start(&s, bvh, space->view, reach);
  if (what == VISIT_NONE) return false;
  all = what == VISIT_ALL;
  if (all) reach->corners = 1; /* no order either */
  at.group.shapes.count = 0;
  at.group.first = 0;
  while (node != 0) {
    fc_bvh_node copy;
    if (!all && reach->limited) {
      s.exit = part_of(&s, reach->limit);
      reach->limited = false;
    }
    if ((space->entered == NULL || (space->entered[node >> 3] >> (node & 7) & 1)) &&
        (all || meets(&s, node_at(bvh, node, &copy)))) {
      uint16_t i, end;
      if (node < leaves) {
        node = reach->corners == 0 ? nearer_child(bvh, &s, node) : 2 * node;
        done <<= 1;
        continue;
      }
      end = fc_bvh_share(bvh, node - leaves + 1, bvh->depth);
      for (i = fc_bvh_share(bvh, node - leaves, bvh->depth); i < end; i++) {
        uint16_t primitive = read_order(bvh, i), index = (uint16_t)(primitive - at.group.first);
        if (index >= at.group.shapes.count && !fc_cursor_find(&at, space, primitive, &index)) continue;
        if (visit(context, &at, index)) return true;
      }
    }
    while (done & 1) {
      done >>= 1;
      node >>= 1;
    }
    if (node == 0) break;
    node ^= 1;
    done |= 1;
  }
  return false;
}

static FC_COLD void mark(const fc_bvh *bvh, const fc_space *space, uint8_t *bits) {
  const uint32_t leaves = fc_bvh_leaves(bvh);
  uint32_t leaf, node;
  fc_cursor at;
  for (node = 0; node < (2 * leaves + 7) / 8; node++) bits[node] = 0;
  at.group.shapes.count = 0;
  at.group.first = 0;
  for (leaf = 0; leaf < leaves; leaf++) {
    uint16_t i, end = fc_bvh_share(bvh, leaf + 1, bvh->depth);
    bool casts = false;
    for (i = fc_bvh_share(bvh, leaf, bvh->depth); i < end && !casts; i++) {
      uint16_t primitive = read_order(bvh, i), index = (uint16_t)(primitive - at.group.first);
      if (index >= at.group.shapes.count && !fc_cursor_find(&at, space, primitive, &index)) continue;
      casts = fc_kind_of(&at)->casts == NULL || fc_kind_of(&at)->casts(&at.group, index);
    }
    if (!casts) continue;
    for (node = leaves + leaf; node != 0; node >>= 1) bits[node >> 3] = (uint8_t)(bits[node >> 3] | 1u << (node & 7));
  }
}

/* ---- trust ---- */

FC_COLD uint32_t fc_bvh_count(const fc_scene *scene) {
  uint32_t count = 0;
  fc_space space;
  fc_cursor cursor;
  space = fc_space_of_world(scene);
  fc_cursor_start(&cursor, &space);
  while (fc_cursor_next(&cursor))
    if (fc_kind_of(&cursor)->bounds != NULL) count += cursor.group.shapes.count;
  return count;
}

#define SEEN_WORDS 128
#define SEEN_BITS (UINT32_C(32) * SEEN_WORDS)

/* Every number of the order once: 4096 of them at a time, marked in a bitmap. As there are as many as finite primitives, and
 * leaves_hold finds each to be one, none is missing then. */
static FC_COLD bool each_once(const fc_bvh *bvh) {
  uint32_t first, all = 0; /* all numbers' bits: none is greater */
  for (first = 0; first <= all; first += SEEN_BITS) {
    uint32_t seen[SEEN_WORDS], i;
    for (i = 0; i < SEEN_WORDS; i++) seen[i] = 0;
    for (i = 0; i < bvh->count; i++) {
      uint32_t number = read_order(bvh, (uint16_t)i), bit;
      all |= number;
      number -= first;
      if (number >= SEEN_BITS) continue; /* those below `first`, too */
      bit = UINT32_C(1) << (number & 31);
      if (seen[number >> 5] & bit) return false;
      seen[number >> 5] |= bit;
    }
  }
  return true;
}

/* A border of cells as a coordinate that compares with any of a primitive's box, which are below 2^31, as the border does. */
static int32_t border(int32_t origin, uint16_t cells, uint8_t shift) {
  const int64_t at = origin + ((int64_t)cells << shift); /* 32 and 33 bits */
  return at < -INT32_MAX ? -INT32_MAX : at > INT32_MAX ? INT32_MAX
                                                       : (int32_t)at;
}

static FC_COLD bool leaf_holds(const fc_bvh *bvh, const fc_space *space, uint32_t leaf, fc_cursor *at) {
  fc_bvh_node copy;
  const fc_bvh_node *node = node_at(bvh, fc_bvh_leaves(bvh) + leaf, &copy);
  int32_t box_low[3], box_high[3];
  const int32_t origin[3] = {bvh->origin.x, bvh->origin.y, bvh->origin.z};
  uint16_t i, end = fc_bvh_share(bvh, leaf + 1, bvh->depth);
  uint8_t j;
  for (j = 0; j < 3; j++) {
    box_low[j] = border(origin[j], fc_bvh_low(node->axis[j]), bvh->shift);
    box_high[j] = border(origin[j], fc_bvh_high(node->axis[j]), bvh->shift);
  }
  for (i = fc_bvh_share(bvh, leaf, bvh->depth); i < end; i++) {
    uint16_t primitive = read_order(bvh, i), index = (uint16_t)(primitive - at->group.first);
    int64_t low[3], high[3];
    if (index >= at->group.shapes.count && !fc_cursor_find(at, space, primitive, &index)) return false;
    if (!fc_bvh_bounds(at, index, low, high)) return false;
    if ((int32_t)low[0] < box_low[0] || (int32_t)low[1] < box_low[1] || (int32_t)low[2] < box_low[2] ||
        (int32_t)high[0] > box_high[0] || (int32_t)high[1] > box_high[1] || (int32_t)high[2] > box_high[2])
      return false;
  }
  return true;
}

static FC_COLD bool holds(const fc_bvh *bvh, uint32_t node, uint32_t child) {
  fc_bvh_node copy[2];
  const fc_bvh_node *outer = node_at(bvh, node, &copy[0]), *inner = node_at(bvh, child, &copy[1]);
  uint8_t j;
  for (j = 0; j < 3; j++)
    if (fc_bvh_low(inner->axis[j]) < fc_bvh_low(outer->axis[j]) || fc_bvh_high(inner->axis[j]) > fc_bvh_high(outer->axis[j]))
      return false;
  return true;
}

static FC_COLD int check(const fc_scene *scene, const fc_bvh *bvh) {
  uint32_t leaves, i;
  fc_space space;
  fc_cursor at;
  if (fc_bvh_count(scene) != bvh->count) return FC_ERR_BVH;
  if (bvh->count == 0) return FC_OK;
  if (bvh->nodes == NULL || bvh->order == NULL) return FC_ERR_NULL;
  if (bvh->depth > 15 || bvh->shift > 17) return FC_ERR_BVH;
  leaves = fc_bvh_leaves(bvh);
  if (leaves > bvh->count || !each_once(bvh)) return FC_ERR_BVH;
  space = fc_space_of_world(scene);
  at.group.shapes.count = 0;
  at.group.first = 0;
  for (i = 0; i < leaves; i++)
    if (!leaf_holds(bvh, &space, i, &at)) return FC_ERR_BVH;
  for (i = 1; i < leaves; i++)
    if (!holds(bvh, i, 2 * i) || !holds(bvh, i, 2 * i + 1)) return FC_ERR_BVH;
  return FC_OK;
}

const fc_bvh_kind fc_bvh_balanced FC_ROM = {check, search, mark};
