/* What each kind of shape brings to the scan engine, and the records it keeps for it in the frame's memory. */
#ifndef FC_SCAN_KINDS_H
#define FC_SCAN_KINDS_H

#include "kind.h"

/* A frame's pixels fit 16 bits. */
typedef struct fc_placed_window {
  uint16_t x0, x1, y0, y1;
} fc_placed_window;

#define FC_GAIN_NONE 255

typedef struct fc_placed_plane {
  int64_t k; /* normal . p = k */
  int32_t normal[3];
  uint32_t factor;                /* near / z = (normal . D) factor / 2^shift / 2^(62 - gain); gain FC_GAIN_NONE: out of reach */
  int32_t unit[3];                /* normal / |normal|, Q30 */
  uint8_t shift, gain, unused[2]; /* 40 bytes on every machine: memory is a multiple of 8 */
} fc_placed_plane;

typedef struct fc_placed_sphere {
  int32_t center[3], radius;
  uint32_t factor; /* near / (c F), c = |center|^2 - radius^2, is factor * 2^exponent */
  int8_t exponent; /* -123 .. 0: c is below 2^62, F below 2^30, near and c F at least 1 */
  uint8_t seen;    /* FC_SPHERE_... */
  uint16_t order;  /* the table's nearest visible sphere, the second nearest ... FC_SPHERE_LAST: there are no more */
  fc_placed_window window;
} fc_placed_sphere;

/* Not at all; in front of the eye and outside it, as the fast forms want it; the same, but some of it may lie beyond the far limit;
 * some other way. */
enum {
  FC_SPHERE_HIDDEN,
  FC_SPHERE_PLAIN,
  FC_SPHERE_CUT,
  FC_SPHERE_ODD
};

#define FC_SPHERE_LAST UINT16_MAX

typedef char fc_placed_is_whole[sizeof(fc_placed_plane) == 40 && sizeof(fc_placed_sphere) == 32 ? 1 : -1];

/* Of a strip: an item of the table; all of them, one after the other. */
void fc_scan_item(fc_scan *scan, uint16_t index, uint16_t rows);
void fc_scan_each(fc_scan *scan, uint16_t rows);

void fc_plane_draw(fc_scan *scan);
void fc_plane_project(const fc_frame *frame, const fc_shapes *shapes, void *memory);
bool fc_plane_window(const fc_frame *frame, const fc_group *group, uint16_t index, fc_window *box);
void fc_plane_shadow(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_form *form);
bool fc_plane_between(const fc_frame *frame, const fc_form *form, const int64_t light[3], const int64_t center[3],
                      int64_t radius, fc_window *window);

void fc_sphere_strip(fc_scan *scan, uint16_t rows);
void fc_sphere_draw(fc_scan *scan);
void fc_sphere_project(const fc_frame *frame, const fc_shapes *shapes, void *memory);
bool fc_sphere_window(const fc_frame *frame, const fc_group *group, uint16_t index, fc_window *box);
void fc_sphere_shadow(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_form *form);
bool fc_sphere_between(const fc_frame *frame, const fc_form *form, const int64_t light[3], const int64_t center[3],
                       int64_t radius, fc_window *window);

int8_t fc_sphere_hides(const fc_form *form, const int64_t light[3], const int32_t point[3], uint32_t error);
int8_t fc_plane_hides(const fc_form *form, const int64_t light[3], const int32_t point[3], uint32_t error);

void fc_triangle_strip(fc_scan *scan, uint16_t rows);
void fc_triangle_project(const fc_frame *frame, const fc_shapes *shapes, void *memory);
void fc_triangle_shadow(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_form *form);
bool fc_triangle_between(const fc_frame *frame, const fc_form *form, const int64_t light[3], const int64_t center[3],
                         int64_t radius, fc_window *window);

uint32_t fc_convex_memory(const fc_shapes *shapes);
void fc_convex_strip(fc_scan *scan, uint16_t rows);
void fc_convex_project(const fc_frame *frame, const fc_shapes *shapes, void *memory);
void fc_convex_cast(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_group *group);
void fc_convex_settle(const fc_frame *frame, const fc_group *group);

bool fc_triangle_casts(const fc_group *group, uint16_t index);
/* Which side of a triangle the light is on, in camera space: 1 where it faces the light, -1 where it is averted, 0 where that is too
 * close to tell at a glance. */
int8_t fc_triangle_turn(const int32_t a[3], const int32_t b[3], const int32_t c[3], const int64_t light[3]);
void fc_triangle_fetch(const fc_group *group, uint16_t index, fc_form *form);
/* (B - A) x (C - A): edges below 2^31, so each component is below 2^63. */
void fc_face_normal(const fc_form *form, int64_t n[3]);

#endif
