/*
 * The scene that rivals draw, in whatever numbers they calculate with: -DREAL=float, -DREAL=double or -DREAL_IS_Q16.
 * rival_scene.py writes it from the same file that `fixcast bake` reads.
 *
 * They get for nothing what fixcast's set-up has to find: unit normals, and the camera's axes.
 */
#ifndef FIXCAST_BENCH_RIVAL_SCENE_H
#define FIXCAST_BENCH_RIVAL_SCENE_H

#include <stdint.h>

#ifdef REAL_IS_Q16
typedef int32_t real;
#define R(v) ((int32_t)((v)*65536.0 + ((v) < 0 ? -0.5 : 0.5)))
#else
typedef REAL real;
#define R(v) ((real)(v))
#endif

typedef struct vec {
  real x, y, z;
} vec;

typedef struct sphere {
  vec center;
  real radius;
  uint16_t material, object;
} sphere;

/* The points p with normal . p + d = 0. */
typedef struct plane {
  vec normal;
  real d;
  uint16_t material, object;
} plane;

/* Outside anticlockwise. */
typedef struct face {
  uint16_t vertex[3];
  uint16_t material, object;
} face;

/* Colours are 0..1. Without a light, intensity is 0. Surfaces farther along the ray than far_limit are background. */
typedef struct rival_scene {
  const sphere *spheres;
  const plane *planes;
  const vec *vertices;
  const face *faces;
  const vec *materials;
  uint16_t sphere_count, plane_count, vertex_count, face_count, material_count;
  vec eye, right, up, forward;
  real tan_half_fov; /* of the shorter side */
  vec light;
  real intensity, ambient;
  vec background;
  real far_limit;
} rival_scene;

extern const rival_scene SCENE;

#endif
