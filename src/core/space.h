/* Walking a scene's tables, in world coordinates or in the camera space of a frame. */
#ifndef FC_SPACE_H
#define FC_SPACE_H

#include <stdbool.h>
#include <stdint.h>

#include "fixcast/scene.h"
#include "kind.h"

/* Where exact answers are worked out, one at a time: it would crowd the stack. */
typedef struct fc_room {
  fc_segment segment; /* to a light */
  fc_prepared prepared;
  fc_form form;
  fc_root best, next; /* of the nearest hit, and of the one that is compared with it */
} fc_room;

/* Where geometry is read from. */
typedef struct fc_space {
  const fc_scene *scene;  /* in RAM */
  const void *memory;     /* camera-space copies of all tables in order; NULL: world coordinates */
  const fc_view *view;    /* with memory: what brought them there */
  const uint8_t *entered; /* bit n % 8 of byte n / 8: whether a search enters node n of the hierarchy; NULL: all are */
  fc_room *room;          /* NULL: on the stack */
} fc_space;

/* A scene in world coordinates. */
static inline fc_space fc_space_of_world(const fc_scene *scene) {
  fc_space space;
  space.scene = scene;
  space.memory = NULL;
  space.view = NULL;
  space.entered = NULL;
  space.room = NULL;
  return space;
}

/* A scene in the camera space of a frame. */
static inline fc_space fc_space_of_frame(const fc_frame *frame) {
  fc_space space;
  space.scene = &frame->scene;
  space.memory = frame->memory;
  space.view = &frame->view;
  space.entered = NULL;
  space.room = NULL;
  return space;
}

/* One table at a time: declare, fc_cursor_start, then while (fc_cursor_next(&cursor)). */
typedef struct fc_cursor {
  const fc_space *space;
  uint16_t table;
  size_t bytes; /* camera-space memory of the tables before this one */
#ifdef FC_ROM_FAR
  fc_kind kind; /* a copy: functions are called through memory that can be read */
#endif
  fc_group group;
} fc_cursor;

static inline const fc_kind *fc_kind_of(const fc_cursor *cursor) {
#ifdef FC_ROM_FAR
  return &cursor->kind;
#else
  return cursor->group.shapes.kind;
#endif
}

void fc_cursor_start(fc_cursor *cursor, const fc_space *space);
bool fc_cursor_next(fc_cursor *cursor);

/* Opens the table that holds a primitive; *index is its place there. False when there is no such primitive. */
bool fc_cursor_find(fc_cursor *cursor, const fc_space *space, uint16_t primitive, uint16_t *index);

/* What fc_scene_check asks of the tables, all but the bvh. `scene` is in RAM. */
int fc_scene_check_tables(const fc_scene *scene);

/* Whether the open segment meets any primitive but `skip` (0xffff: none is skipped). */
bool fc_space_blocked(const fc_space *space, fc_segment *segment, uint16_t skip);

/* Meets a form with a ray: fc_kind.test, on an origin of its own. */
uint8_t fc_form_meet(const fc_kind *kind, const fc_form *form, const int64_t origin[3], const int64_t direction[3], fc_root *root);

/* The same, worked out in *prepared. */
uint8_t fc_form_meet_in(fc_prepared *prepared, const fc_kind *kind, const fc_form *form, const int64_t origin[3], const int64_t direction[3],
                        fc_root *root);

/* A surface point: a primitive, a ray and the root where they meet. */
typedef struct fc_surface {
  fc_cursor at; /* the primitive's table */
  fc_form form;
  fc_root root;
  const int64_t *origin, *direction;
  int64_t point[3];  /* rounded, within point_error */
  int64_t normal[3]; /* any length, not yet turned to the ray's side */
  uint16_t primitive;
  uint32_t point_error; /* of each coordinate; UINT32_MAX: only the root says where the point is */
  bool inside;
} fc_surface;

/* Opens a primitive and meets it with a ray; false when it is missed. */
bool fc_surface_meet(fc_surface *surface, const fc_space *space, uint16_t primitive, const int64_t origin[3],
                     const int64_t direction[3]);

/* Rounds the point and finds the normal. */
void fc_surface_complete(fc_surface *surface);

/* Rounds a completed surface's point to a unit, for those who go on from there, and finds its normal anew. */
void fc_surface_round(fc_surface *surface);

/* The primitive that a ray meets first (equal t: the lowest number), 0xffff for none. With `nearest`, only roots
 * within t_min < t < t_max count, and the first is stored there; without, t > 0 is all that is asked. */
uint16_t fc_space_nearest(const fc_space *space, const int64_t origin[3], const int64_t direction[3], uint64_t t_min_q32,
                          uint64_t t_max_q32, fc_root *nearest);

/* Values of a completed surface, in the space's own axes and units. */
void fc_surface_hit(const fc_surface *surface, fc_hit *hit);

#endif
