/*
 * The ray engine: one ray against a scene's primitives, exact. It is the definition of every picture.
 *
 * Everything here works on plain world coordinates; no frame or camera is needed. Decisions (hit, nearer,
 * blocked) are those of exact arithmetic on the integers given; values (t, position, normal, barycentrics) are
 * rounded as stated.
 */
#ifndef FIXCAST_RAY_H
#define FIXCAST_RAY_H

#include <stdbool.h>
#include <stdint.h>

#include "fixcast/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Points origin + t direction with t_min < t < t_max (both ends open, so an occluder exactly at a light does not
 * block it). t is measured in lengths of the direction, Q32.32. */
typedef struct fc_ray {
  fc_vec3 origin;     /* world coordinates */
  fc_vec3 direction;  /* any length but 0, within FC_COORDINATE_MAX */
  uint64_t t_min_q32; /* 0: just in front of the origin */
  uint64_t t_max_q32; /* UINT64_MAX: no limit; hits beyond t = 2^32 are not reported */
} fc_ray;

/* Where a ray meets the scene first. */
typedef struct fc_hit {
  uint64_t t_q32;              /* rounded from a value with relative error below 2^-57, saturated at UINT64_MAX */
  fc_vec3 position;            /* world coordinates; within 1 unit an axis of the exact point; clamped to +-FC_COORDINATE_MAX */
  fc_vec3 normal_q30;          /* unit length, towards the ray's side; within 2^-28 an axis, on a sphere of
                          * radius r within 2^-28 + 2 / r */
  uint32_t barycentric_q30[3]; /* triangles: weights of the three vertices, within 2^-29; otherwise 0 */
  uint16_t primitive;          /* number through all tables of the scene, in order */
  uint16_t object;             /* the id its author gave it */
  bool inside;                 /* the inside of a sphere, or the back of a plane or triangle (normal . direction > 0) */
} fc_hit;

/* The closest hit of the ray; the scene must have passed fc_scene_check. Equal t: the lowest primitive number. A ray through an edge that two
 * triangles share hits exactly one of them. Tangent spheres are hit. Returns 1 with *hit filled, 0 for a miss, or an error. */
int fc_intersect(const fc_scene *scene, const fc_ray *ray, fc_hit *hit);

/* Whether the open segment between two points meets any primitive; touching counts, end points do not.
 * Returns 1, 0 or an error. */
int fc_blocked(const fc_scene *scene, const fc_vec3 *from, const fc_vec3 *to);

/* How a secondary ray leaves a surface. */
typedef enum fc_offset_rule {
  FC_OFFSET_EXACT = 0,    /* lit tests start at the exact, unrounded point and skip the receiver: no offset at all */
  FC_OFFSET_RESIDUAL = 1, /* start at the rounded point, stepped by its exact residual to the ray's side */
  FC_OFFSET_EPSILON = 2,  /* start at the rounded point plus epsilon along the normal (the lectures' rule) */
  FC_OFFSET_NONE = 3      /* start at the rounded point: shows surface acne */
} fc_offset_rule;

/* Moves hit->position off its surface to the side of the ray's origin: by FC_OFFSET_RESIDUAL (at most sqrt(3) units
 * above the surface), by FC_OFFSET_EPSILON (`epsilon` in world coordinates, 0..FC_COORDINATE_MAX) or, by
 * FC_OFFSET_NONE and FC_OFFSET_EXACT, not at all. `hit` comes from fc_intersect on the same scene. */
int fc_offset(const fc_scene *scene, const fc_hit *hit, int rule, int32_t epsilon, fc_vec3 *point);

#ifdef __cplusplus
}
#endif

#endif
