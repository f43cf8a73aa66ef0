/*
 * What a scene is: constant tables that may live in flash, in world coordinates.
 *
 * World: right-handed; a coordinate is an int32_t within +-FC_COORDINATE_MAX that stands for
 * value * 2^(exponent - 16) world units, with one exponent for the scene (0, the default, is Q16.16).
 * Multiplying a scene by a power of two changes exponents only, so no bit of the picture changes.
 * The caller owns every table; they must live as long as any frame set up from them.
 */
#ifndef FIXCAST_SCENE_H
#define FIXCAST_SCENE_H

#include <stdint.h>

#include "fixcast/config.h"
#include "fixcast/material.h"
#include "fixcast/vec3.h"

#ifdef __cplusplus
extern "C" {
#endif

/* `material` indexes fc_scene.materials; `object` is the id a pixel reports (0 is the background's). */
typedef struct fc_sphere {
  fc_vec3 center;
  int32_t radius; /* world coordinates, 1..FC_COORDINATE_MAX */
  uint16_t material, object;
} fc_sphere;

/* The points p with normal . p + d = 0 (the lectures' form). The normal has any length but 0, and its own
 * scale: with p in world coordinates, d stands for d * 2^d_exponent, d_exponent 0..32. For a normal of plain
 * integers such as (0, 1, 0), d is a world coordinate and d_exponent is 0. */
typedef struct fc_plane {
  fc_vec3 normal;
  int32_t d;
  int8_t d_exponent;
  uint16_t material, object;
} fc_plane;

/* Indices into the vertices of its fc_shapes. Both sides are visible. A triangle without area is never hit. */
typedef struct fc_triangle {
  uint16_t vertex[3];
  uint16_t material, object;
} fc_triangle;

/* One kind of shape: code that only scenes naming it link. Opaque; the five below are all there are. */
typedef struct fc_kind fc_kind;
extern const fc_kind fc_kind_sphere;   /* items: fc_sphere */
extern const fc_kind fc_kind_plane;    /* items: fc_plane */
extern const fc_kind fc_kind_triangle; /* items: fc_triangle, with vertices */
/* The same with vertices of 16 bits (fc_short_vec3). */
extern const fc_kind fc_kind_triangle_short;
extern const fc_kind fc_kind_convex; /* items: fc_triangle, of a convex body that shadows by its outline */

/* A vertex of fc_kind_triangle_short: world coordinates / 2^vertex_shift. */
typedef struct fc_short_vec3 {
  int16_t x, y, z;
} fc_short_vec3;

/* A vertex normal, unit length, Q14. */
typedef struct fc_normal {
  int16_t x, y, z;
} fc_normal;
/* Texture coordinates of a vertex in tiles, Q16. */
typedef struct fc_uv {
  int32_t u, v; /* -2^30 .. 2^30 */
} fc_uv;

/* A table of shapes of one kind; triangles share a table of vertices. Use the macros. */
typedef struct fc_shapes {
  const fc_kind *kind;
  const void *items;    /* fc_sphere, fc_plane or fc_triangle, as the kind says */
  const void *vertices; /* fc_vec3, or fc_short_vec3 where the kind says so */
  uint16_t count, vertex_count;
  const fc_normal *normals; /* triangles: one a vertex, for fc_layer_smooth; or NULL */
  const fc_uv *uvs;         /* triangles: one a vertex, for fc_mapping_vertices; or NULL */
  uint8_t cull;             /* triangles: 1 when they close up and face outwards, so that back faces need not be drawn; otherwise 0. fc_kind_convex:
                   2 + m for a margin of 2^m coordinates or more, m 0..30; or as for triangles */
  uint8_t vertex_shift;     /* fc_kind_triangle_short: a vertex is a whole number times 2^vertex_shift, 0..15; otherwise 0 */
} fc_shapes;

/* Number of a table's items, as uint16_t. */
#define FC_COUNT_OF(table) ((uint16_t)(sizeof(table) / sizeof((table)[0])))
/* For initialisers: the fc_shapes of a table of fc_sphere. */
#define FC_SPHERES(table) \
  { &fc_kind_sphere, (table), NULL, FC_COUNT_OF(table), 0, NULL, NULL, 0, 0 }
/* For initialisers: the fc_shapes of a table of fc_plane. */
#define FC_PLANES(table) \
  { &fc_kind_plane, (table), NULL, FC_COUNT_OF(table), 0, NULL, NULL, 0, 0 }
/* For initialisers: the fc_shapes of a table of fc_triangle and its vertices. */
#define FC_TRIANGLES(vertices, table) \
  { &fc_kind_triangle, (table), (vertices), FC_COUNT_OF(table), FC_COUNT_OF(vertices), NULL, NULL, 0, 0 }
/* Triangles with attributes a vertex (either may be NULL); `closed` 1 for a closed mesh. */
#define FC_TRIANGLES_WITH(vertices, normals, uvs, table, closed) \
  { &fc_kind_triangle, (table), (vertices), FC_COUNT_OF(table), FC_COUNT_OF(vertices), (normals), (uvs), (closed), 0 }
/* Closed meshes: every edge is shared by two triangles, which run along it in opposite directions, counter-clockwise seen from
 * outside, and no triangle passes through another. Rays meet their front faces only: a back face is hidden from any eye that is
 * outside, and costs next to nothing. An eye inside looks out through them. With exact shadows a point is taken to be outside too, so
 * that only faces turned away from a light keep it off: what goes into the mesh has to come out. */
#define FC_TRIANGLES_CLOSED(vertices, table) \
  { &fc_kind_triangle, (table), (vertices), FC_COUNT_OF(table), FC_COUNT_OF(vertices), NULL, NULL, 1, 0 }
/* A convex mesh: one closed mesh, each vertex strictly below the plane of each face that it is no corner of. The margin, 2^m coordinates,
 * tells from how far away that still holds when vertices are rounded. It is at most a vertex's distance below a face, divided by 1 + the
 * sum of the magnitudes of its barycentric weights there, and at most a sixteenth of a face's least height. Shadows of such meshes cost a
 * fraction: an outline stands for all faces. `fixcast bake` finds m. Normals and uvs as above. */
#define FC_TRIANGLES_CONVEX(vertices, normals, uvs, table, m) \
  { &fc_kind_convex, (table), (vertices), FC_COUNT_OF(table), FC_COUNT_OF(vertices), (normals), (uvs), 2 + (m), 0 }

/* The same from vertices of 16 bits (fc_short_vec3): half their flash, for a scene whose every mesh allows it (`fixcast bake` knows); with
 * both widths in a scene both readers are linked. */
#define FC_TRIANGLES_SHORT(vertices, shift, normals, uvs, table, closed) \
  { &fc_kind_triangle_short, (table), (vertices), FC_COUNT_OF(table), FC_COUNT_OF(vertices), (normals), (uvs), (closed), (shift) }

/* A point light, or a directional one. `position` stands for position * 2^exponent in world coordinates (-31..32): a far sun needs a
 * coarser grid than the scene. `intensity` is Q1.15 times 2^intensity_exponent (-40..40): irradiance of a surface
 * facing the light (no falloff), or the same at a distance of one world unit (inverse square). */
typedef struct fc_light {
  fc_vec3 position;
  fc_rgb intensity;
  int8_t exponent;
  int8_t intensity_exponent;
  uint8_t inverse_square; /* 0: intensity does not fall off with distance; 1: Kepler's law */
  uint8_t directional;    /* 1: `position` is a direction, towards the light, of any length but 0; exponent and inverse_square are 0. The light
                             stands 2^60 camera grid units away: over the scene its rays differ from parallel by half a unit */
} fc_light;

/* Largest number of primitives in a scene: a pixel's primitive is kept in 16 bits, 0xffff meaning none. */
#define FC_PRIMITIVES_MAX UINT16_C(0xffff)

/* A scene: tables that the caller owns, constant, perhaps in flash, and what holds for all of it. */
typedef struct fc_scene {
  const fc_shapes *shapes;
  const fc_material *materials;
  const fc_light *lights;
  uint16_t shape_count; /* tables of shapes, not shapes; primitives are numbered through them in order */
  uint16_t material_count, light_count;
  int8_t exponent;     /* a coordinate is value * 2^(exponent - 16) world units; -60..60 */
  int8_t far_exponent; /* -31..32 */
  int32_t far_limit;   /* surfaces farther along the ray than far_limit * 2^far_exponent world coordinates
                        * are background; 0: no limit; 1..FC_COORDINATE_MAX otherwise */
  fc_rgb ambient, background;
  const fc_sky *sky;        /* instead of a plain background, or NULL; may live in flash */
  const struct fc_bvh *bvh; /* a bounding volume hierarchy of just these shapes (bvh.h), or NULL */
} fc_scene;

/* Checks every table against its documented ranges: FC_OK or an error. Frames are set up from checked scenes only;
 * call it once before using a scene with the ray engine. */
int fc_scene_check(const fc_scene *scene);

#ifdef __cplusplus
}
#endif

#endif
