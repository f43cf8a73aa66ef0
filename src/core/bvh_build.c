/*
 * Building a hierarchy: halves by counts, along the axis that leaves the two halves the smallest surfaces.
 *
 * Where a node's share ends is known beforehand (fc_bvh_share), so nodes are made in their order, without a stack.
 */
#include "bits.h"
#include "bvh.h"
#include "fixcast/error.h"
#include "quick.h"

#define MANY 2048 /* primitives */

/* C99's alignof(uint32_t). */
struct aligned_u32 {
  char before;
  uint32_t value;
};

typedef struct builder {
  const fc_bvh *bvh;
  fc_bvh_node *nodes, *boxes; /* of the tree; of the primitives in the order of `first` */
  uint16_t *order;            /* places in `boxes` while building */
} builder;

/* The deepest tree whose leaves hold two primitives or more; four where there are many, whose nodes would be most of the flash. */
static uint8_t depth_for(uint32_t count) {
  const uint8_t least = count >= MANY ? 4 : 2;
  uint8_t depth = 0;
  while (count >> depth >= 2 * (uint32_t)least) depth++;
  return depth;
}

static uint32_t node_count(uint8_t depth) { return (UINT32_C(2) << depth) - 1; }

/* 16 + 5 bits at most; where size_t has 16, SIZE_MAX stands for what is too much. */
static size_t size_of(uint32_t bytes) { return (size_t)bytes == bytes ? (size_t)bytes : SIZE_MAX; }

size_t fc_bvh_bytes(const fc_bvh *bvh) {
  if (bvh->count == 0) return 0;
  return size_of(node_count(bvh->depth) * (uint32_t)sizeof(fc_bvh_node) + bvh->count * (uint32_t)sizeof(uint16_t));
}

/* With the boxes of all primitives, which are aligned again. */
static size_t building_bytes(uint32_t count) {
  if (count == 0) return 0;
  return size_of((node_count(depth_for(count)) + count) * (uint32_t)sizeof(fc_bvh_node) + (count + 1) / 2 * (uint32_t)sizeof(uint32_t));
}

static int check(const fc_scene *scene_rom, fc_scene *scene) {
  if (scene_rom == NULL) return FC_ERR_NULL;
  FC_READ_ONE(scene, scene_rom);
  scene->bvh = NULL;
  return fc_scene_check_tables(scene);
}

size_t fc_bvh_memory(const fc_scene *scene_rom, int *error) {
  fc_scene scene;
  int status = check(scene_rom, &scene);
  if (error != NULL) *error = status;
  return status != FC_OK ? 0 : building_bytes(fc_bvh_count(&scene));
}

/* Calls for each finite primitive in turn: the next box, or false. */
static bool next_box(fc_cursor *at, uint16_t *index, int64_t low[3], int64_t high[3]) {
  while (*index >= at->group.shapes.count || fc_kind_of(at)->bounds == NULL) {
    if (!fc_cursor_next(at)) return false;
    *index = 0;
  }
  return fc_bvh_bounds(at, (*index)++, low, high);
}

/* The finest cells in which everything fits: low corners rounded down, high ones up. */
static void choose_cells(fc_bvh *bvh, const fc_space *space) {
  int64_t low[3], high[3], root_low[3] = {0, 0, 0}, root_high[3] = {0, 0, 0}, widest = 0;
  uint16_t index = 0;
  uint8_t j;
  fc_cursor at;
  bool first = true;
  fc_cursor_start(&at, space);
  while (next_box(&at, &index, low, high)) {
    for (j = 0; j < 3; j++) {
      if (first || low[j] < root_low[j]) root_low[j] = low[j];
      if (first || high[j] > root_high[j]) root_high[j] = high[j];
    }
    first = false;
  }
  for (j = 0; j < 3; j++)
    if (root_high[j] - root_low[j] > widest) widest = root_high[j] - root_low[j];
  bvh->shift = 0;
  while (FC_BVH_CELLS << bvh->shift < widest) bvh->shift++; /* at most 2^32: 17 */
  bvh->origin.x = (int32_t)root_low[0];                     /* within 2^31 */
  bvh->origin.y = (int32_t)root_low[1];
  bvh->origin.z = (int32_t)root_low[2];
}

static void fill_boxes(const builder *b, const fc_space *space) {
  const fc_bvh *bvh = b->bvh;
  int64_t low[3], high[3], origin[3];
  uint16_t index = 0, place = 0;
  uint8_t j;
  fc_cursor at;
  origin[0] = bvh->origin.x;
  origin[1] = bvh->origin.y;
  origin[2] = bvh->origin.z;
  fc_cursor_start(&at, space);
  while (next_box(&at, &index, low, high)) {
    for (j = 0; j < 3; j++) {
      /* both below 2^32: at most 65535 cells by the choice of shift */
      uint32_t from = (uint32_t)((low[j] - origin[j]) >> bvh->shift);
      uint32_t to = (uint32_t)((high[j] - origin[j] + (INT64_C(1) << bvh->shift) - 1) >> bvh->shift);
      b->boxes[place].axis[j] = from | to << 16;
    }
    b->order[place] = place;
    place++;
  }
}

/* Twice the centre: 17 bits. */
static uint32_t key_of(const builder *b, uint16_t place, uint8_t axis) {
  uint32_t a = b->boxes[place].axis[axis];
  return (uint32_t)fc_bvh_low(a) + fc_bvh_high(a);
}

/* Reorders a share so that no centre before `middle` lies beyond one from `middle` on: a binary search for the centre in
 * the middle, from its highest bit down, each step a pass over what is still mixed. */
static void halve(const builder *b, uint32_t begin, uint32_t middle, uint32_t end, uint8_t axis) {
  uint32_t bit;
  for (bit = UINT32_C(1) << 16; bit != 0 && begin < middle && middle < end; bit >>= 1) {
    uint32_t low = begin, high = end;
    while (low < high) {
      uint16_t place = b->order[low];
      if (key_of(b, place, axis) & bit) {
        high--;
        b->order[low] = b->order[high];
        b->order[high] = place;
      } else {
        low++;
      }
    }
    if (middle < low)
      end = low;
    else
      begin = low;
  }
}

static void unite(fc_bvh_node *to, const fc_bvh_node *with) {
  uint8_t j;
  for (j = 0; j < 3; j++) {
    uint32_t a = to->axis[j], b = with->axis[j];
    uint32_t low = fc_bvh_low(a) < fc_bvh_low(b) ? fc_bvh_low(a) : fc_bvh_low(b);
    uint32_t high = fc_bvh_high(a) > fc_bvh_high(b) ? fc_bvh_high(a) : fc_bvh_high(b);
    to->axis[j] = low | high << 16;
  }
}

static void box_of(const builder *b, uint32_t begin, uint32_t end, fc_bvh_node *box) {
  uint32_t i;
  *box = b->boxes[b->order[begin]];
  for (i = begin + 1; i < end; i++) unite(box, &b->boxes[b->order[i]]);
}

/* Half the surface: three products of 16 bits. */
static uint64_t surface(const fc_bvh_node *box) {
  uint32_t size[3];
  uint8_t j;
  for (j = 0; j < 3; j++) size[j] = (uint32_t)fc_bvh_high(box->axis[j]) - fc_bvh_low(box->axis[j]);
  return (uint64_t)(size[0] * size[1]) + size[1] * size[2] + size[2] * size[0];
}

static void split(const builder *b, uint32_t begin, uint32_t middle, uint32_t end) {
  uint64_t least = UINT64_MAX;
  uint8_t axis, best = 0;
  for (axis = 0; axis < 3; axis++) {
    fc_bvh_node left, right;
    uint64_t cost;
    halve(b, begin, middle, end, axis);
    box_of(b, begin, middle, &left);
    box_of(b, middle, end, &right);
    cost = surface(&left) + surface(&right);
    if (cost < least) {
      least = cost;
      best = axis;
    }
  }
  if (best != 2) halve(b, begin, middle, end, best);
}

/* A leaf's few in ascending order: tables are then opened once, and one scene has one hierarchy. */
static void sort(uint16_t *order, uint32_t begin, uint32_t end) {
  uint32_t i, j;
  for (i = begin + 1; i < end; i++) {
    uint16_t place = order[i];
    for (j = i; j > begin && order[j - 1] > place; j--) order[j] = order[j - 1];
    order[j] = place;
  }
}

static void make_nodes(const builder *b) {
  const fc_bvh *bvh = b->bvh;
  const uint32_t leaves = fc_bvh_leaves(bvh);
  uint32_t i, node;
  uint8_t level;
  for (level = 0; level < bvh->depth; level++)
    for (i = 0; i < UINT32_C(1) << level; i++)
      split(b, fc_bvh_share(bvh, i, level), fc_bvh_share(bvh, 2 * i + 1, (uint8_t)(level + 1)), fc_bvh_share(bvh, i + 1, level));
  for (i = 0; i < leaves; i++) {
    uint32_t begin = fc_bvh_share(bvh, i, bvh->depth), end = fc_bvh_share(bvh, i + 1, bvh->depth);
    sort(b->order, begin, end);
    box_of(b, begin, end, &b->nodes[leaves + i - 1]);
  }
  for (node = leaves - 1; node > 0; node--) {
    b->nodes[node - 1] = b->nodes[2 * node - 1];
    unite(&b->nodes[node - 1], &b->nodes[2 * node]);
  }
}

/* From places among the finite primitives to numbers through all tables. */
static void number(const builder *b, const fc_space *space) {
  uint16_t skipped = 0, place = 0, i;
  fc_cursor at;
  /* the boxes are no longer needed: the number of each place goes there */
  fc_cursor_start(&at, space);
  while (fc_cursor_next(&at)) {
    if (fc_kind_of(&at)->bounds == NULL) {
      skipped = (uint16_t)(skipped + at.group.shapes.count);
      continue;
    }
    for (i = 0; i < at.group.shapes.count; i++, place++) b->boxes[place].axis[0] = (uint32_t)place + skipped;
  }
  for (i = 0; i < b->bvh->count; i++) b->order[i] = (uint16_t)b->boxes[b->order[i]].axis[0];
}

int fc_bvh_build(fc_bvh *bvh, const fc_scene *scene_rom, void *memory, size_t memory_bytes) {
  fc_scene scene;
  fc_space space;
  builder b;
  uint32_t count;
  int error;
  if (bvh == NULL) return FC_ERR_NULL;
  error = check(scene_rom, &scene);
  if (error != FC_OK) return error;
  count = fc_bvh_count(&scene);
  if (count > 0 && (memory == NULL || memory_bytes < building_bytes(count) || building_bytes(count) == SIZE_MAX ||
                    (uintptr_t)memory % offsetof(struct aligned_u32, value) != 0))
    return FC_ERR_MEMORY;
  bvh->kind = &fc_bvh_balanced;
  bvh->nodes = NULL;
  bvh->order = NULL;
  bvh->origin.x = bvh->origin.y = bvh->origin.z = 0;
  bvh->count = (uint16_t)count;
  bvh->shift = 0;
  bvh->depth = depth_for(count);
  if (count == 0) return FC_OK;
  space = fc_space_of_world(&scene);
  choose_cells(bvh, &space);
  b.bvh = bvh;
  b.nodes = memory;
  b.order = (uint16_t *)(b.nodes + node_count(bvh->depth));
  b.boxes = (fc_bvh_node *)((uint32_t *)(void *)b.order + (count + 1) / 2);
  bvh->nodes = b.nodes;
  bvh->order = b.order;
  fill_boxes(&b, &space);
  make_nodes(&b);
  number(&b, &space);
  return FC_OK;
}
