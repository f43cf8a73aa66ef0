/*
 * What a kind of shape can do: the interface behind fc_kind, and the local forms it works on.
 *
 * A scene's table names its kind by a pointer to this record, so that the linker drops the kinds no scene names.
 * Forms are copies on the stack, in world coordinates (ray engine) or in camera space (frames): the same code
 * serves both.
 */
#ifndef FC_KIND_H
#define FC_KIND_H

#include <stdbool.h>
#include <stdint.h>

#include "fixcast/render.h"
#include "fixcast/scene.h"
#include "root.h"
#include "segment.h"

/* A primitive's geometry and tags. Coordinates within FC_COORDINATE_MAX. */
typedef struct fc_form {
  union {
    struct {
      int64_t center[3];
      int64_t radius;
    } sphere;
    struct {
      int64_t normal[3]; /* below 2^30 */
      int64_t k;         /* normal . p = k, below 2^62 */
      int32_t unit[3];   /* camera space only: normal / |normal|, Q30, within 2^-25 */
    } plane;
    struct {
      int64_t vertex[3][3];
      int8_t hidden; /* rays miss it where normal . (vertex - origin) has this sign; 0: both sides are hit */
    } triangle;
  } u;
  uint16_t material, object;
} fc_form;

/* A form as seen from a ray's origin: what does not depend on the direction. */
typedef struct fc_prepared {
  union {
    struct {
      int64_t oc[3]; /* center - origin */
      fc_i128 c;     /* |oc|^2 - r^2 */
    } sphere;
    struct {
      int64_t normal[3];
      fc_i128 side; /* k - normal . origin: origins up to 2^62 */
    } plane;
    struct {
      int64_t edge[3][3];   /* N_i = V_i x V_i+1, vertices relative to the origin */
      int32_t filter[3][3]; /* floor(N_i / 2^s), below 2^30 */
      int64_t normal[3];
      fc_i128 side; /* normal . V_0 */
      int8_t hidden;
    } triangle;
  } u;
} fc_prepared;

/* A table of shapes opened for reading: local copies of what may live in flash. */
typedef struct fc_group {
  fc_shapes shapes;
  uint16_t first;     /* number of its first primitive */
  const void *memory; /* camera-space copy, NULL in world space */
} fc_group;

/* Rows and columns of the frame that a form may touch, inclusive. */
typedef struct fc_window {
  int32_t x0, x1, y0, y1;
} fc_window;

/* Cuts a window to the frame; false when nothing is left. */
bool fc_window_cut(const fc_frame *frame, fc_window *window);

/* The pixels that a ball may touch; false when there are none. */
bool fc_ball_window(const fc_frame *frame, const int64_t center[3], int64_t radius, fc_window *window);

typedef struct fc_scan fc_scan;
typedef struct fc_planar fc_planar;

struct fc_kind {
  /* Checks the table's items; FC_OK or an error. */
  int (*check)(const fc_scene *scene, const fc_shapes *shapes);
  /* Bytes of camera-space memory, a multiple of 8. */
  uint32_t (*memory)(const fc_shapes *shapes);
  /* Greatest distance from the eye that the frame's grid has to hold, in units of 2^-fine world coordinates; or, where it is not within
   * 2^-21 below a power of two, any that lies between the same two and not there either: all that matters to a grid. */
  fc_num (*extent)(const fc_view *view, const fc_shapes *shapes);
  /* Brings the table into camera space. */
  void (*place)(const fc_view *view, const fc_shapes *shapes, void *memory);
  void (*fetch)(const fc_group *group, uint16_t index, fc_form *form);
  void (*prepare)(const fc_form *form, const int64_t origin[3], fc_prepared *prepared);
  /* How many roots with t > 0: 0, 1 or 2, and the first of them; the second has q = 1 instead. |direction| components below 2^30. */
  uint8_t (*test)(const fc_prepared *prepared, const int64_t direction[3], fc_root *root);
  /* Whether the open segment meets the form. */
  bool (*blocked)(const fc_form *form, fc_segment *segment);
  /* Whether the side of the form that the eye, at 0, sees faces the light. */
  bool (*facing)(const fc_form *form, fc_segment *segment);
  /* A vector along the normal at a point. */
  void (*normal)(const fc_form *form, const int64_t point[3], int64_t normal[3]);
  /* The side of the surface that a point is on: 1 where the normal points to, 0 on it, -1. Points below 2^62. */
  int8_t (*side)(const fc_form *form, const int64_t point[3]);
  /* Barycentric weights of a hit, Q30; NULL where there are none. */
  void (*weights)(const fc_prepared *prepared, const int64_t direction[3], uint32_t weight_q30[3]);
  /* Widens *near .. *far to the camera z at which the table can be seen; *near 0: may reach the eye's plane;
   * *far UINT64_MAX: unbounded. */
  void (*depth_range)(const fc_frame *frame, const fc_group *group, uint64_t *near, uint64_t *far);
  /* After the grid and the depth format are chosen: fills what the scan engine needs of the table's memory. */
  void (*project)(const fc_frame *frame, const fc_shapes *shapes, void *memory);
  /* The pixels that an item may touch, cut to the frame; false when there are none. NULL where `strip` needs none. */
  bool (*window)(const fc_frame *frame, const fc_group *group, uint16_t index, fc_window *window);
  /* Draws a tile of the primitive: depth, visibility, light (scan.h). */
  void (*draw)(fc_scan *scan);
  /* Clears the mask of a planar receiver where the form keeps its light away (planar.h). */
  void (*shadow)(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_form *form);
  /* Whether the form might come between a light and some point of a ball that is seen from outside, and in which pixels;
   * true when in doubt. The window is cut to the frame. */
  bool (*between)(const fc_frame *frame, const fc_form *form, const int64_t light[3], const int64_t center[3],
                  int64_t radius, fc_window *window);
  /* Whether the form keeps a light from a point known to within `error` an axis: 1, 0; -1 when that is not enough to tell.
   * NULL: it never is. Light and point within 2^30, error below 2^20. */
  int8_t (*hides)(const fc_form *form, const int64_t light[3], const int32_t point[3], uint32_t error);
  /* Draws the items of a table (scan->at) that touch a strip of some rows. */
  void (*strip)(fc_scan *scan, uint16_t rows);
  /* The smallest box around the form; NULL for infinite ones. */
  void (*bounds)(const fc_form *form, int64_t low[3], int64_t high[3]);
  /* Whether an item may keep the frame's only light from anything; NULL: all may. */
  bool (*casts)(const fc_group *group, uint16_t index);
  /* Clears the mask of a planar receiver where the table keeps its light away as a whole: items of such a table do not cast. NULL:
   * no table does. */
  void (*cast)(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_group *group);
  /* After every table is projected, under an only light: what the table need not be asked about in strips; or NULL. */
  void (*settle)(const fc_frame *frame, const fc_group *group);
};

#endif
