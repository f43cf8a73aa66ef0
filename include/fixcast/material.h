/*
 * What a surface is made of: a reflectance, and layers over it.
 *
 * A material without layers is matte (Lambert). A layer names a kind, which is code, and its data; programs that name no kind do not link it. Scenes
 * are shaded in linear light; a fc_transfer turns that into the levels of a display.
 */
#ifndef FIXCAST_MATERIAL_H
#define FIXCAST_MATERIAL_H

#include <stddef.h>
#include <stdint.h>

#include "fixcast/vec3.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Linear colour, each channel Q1.15: 32768 is 1.0 (SPEC "Light units"). */
typedef struct fc_rgb {
  uint16_t r, g, b;
} fc_rgb;

/* 1.0 of a colour channel. */
#define FC_ONE_Q15 UINT16_C(32768)
/* A channel or colour given in 0..255, rounded to nearest Q1.15. */
#define FC_CHANNEL8(v) ((uint16_t)(((uint32_t)(v)*32768u + 127u) / 255u))
/* For initialisers: a fc_rgb of three channels in 0..255. */
#define FC_RGB8(r, g, b) \
  { FC_CHANNEL8(r), FC_CHANNEL8(g), FC_CHANNEL8(b) }
/* A grey given as a real constant in 0..1.99: FC_GREY(0.875). */
#define FC_GREY_CHANNEL(v) ((uint16_t)((v)*32768.0 + 0.5))
/* For initialisers: a grey fc_rgb given as a real constant in 0..1.99. */
#define FC_GREY(v) \
  { FC_GREY_CHANNEL(v), FC_GREY_CHANNEL(v), FC_GREY_CHANNEL(v) }

/* One kind of layer: code. Opaque; those below are all there are. */
typedef struct fc_layer_kind fc_layer_kind;

/* A layer of a material: code and what it works on. */
typedef struct fc_layer {
  const fc_layer_kind *kind;
  const void *data; /* of the type that the kind says; may live in flash */
} fc_layer;

/* Layers act in their order. The radiance of a surface is
 *   reflectance * (ambient + sum of light * cosine) + what layers add. */
typedef struct fc_material {
  fc_rgb diffuse;         /* reflectance, 0..32768 a channel */
  uint16_t layer_count;   /* at most FC_LAYERS_MAX */
  const fc_layer *layers; /* may live in flash; NULL when there are none */
} fc_material;

/* Most layers of a material. */
#define FC_LAYERS_MAX 4

/* For initialisers: a fc_material without layers. */
#define FC_MATTE(diffuse) \
  { diffuse, 0, NULL }
/* For initialisers: a fc_rgb of 1.0. */
#define FC_WHITE \
  { FC_ONE_Q15, FC_ONE_Q15, FC_ONE_Q15 }
/* For initialisers: a fc_material with a table of layers. */
#define FC_LAYERED(diffuse, layers) \
  { diffuse, FC_COUNT_OF(layers), (layers) }

/* Phong's highlight: adds specular * light * (r . v)^shininess for each light that reaches the point, r the light's direction mirrored at the normal
 * and v the direction to the eye (Phong 1975; the lectures' form, not multiplied by the cosine). Relative error below 2^-21 (shininess + 1). */
extern const fc_layer_kind fc_layer_phong;
/* Data of fc_layer_phong. */
typedef struct fc_phong {
  fc_rgb specular;       /* Q1.15 */
  uint32_t shininess_q8; /* exponent: 256 is 1.0; 1 .. 2^24 */
} fc_phong;

/* A perfect mirror in the normal: adds reflectance * what is seen that way, up to `bounces` mirrors in a row (those of the first mirror count);
 * the last one in the row shows its other layers only. */
extern const fc_layer_kind fc_layer_mirror;
/* Data of fc_layer_mirror. */
typedef struct fc_mirror {
  fc_rgb reflectance; /* Q1.15, at most 32768 */
  uint8_t bounces;    /* 1..FC_BOUNCES_MAX */
} fc_mirror;
/* Most mirrors in a row. */
#define FC_BOUNCES_MAX 16

/* Light of its own: adds light * 2^exponent. It does not light other surfaces. */
extern const fc_layer_kind fc_layer_emission;
/* Data of fc_layer_emission. */
typedef struct fc_emission {
  fc_rgb light;    /* Q1.15 */
  int8_t exponent; /* 0..7 */
} fc_emission;

/* Smooth shading: triangles are shaded with their vertices' normals (fc_shapes.normals), weighted by the hit's barycentrics, instead of their
 * own. Which lights reach the point stays a matter of the flat triangle. Takes no data, and does nothing to other shapes. Within 2^-13. */
extern const fc_layer_kind fc_layer_smooth;
/* For initialisers: the layer of smooth shading. */
#define FC_SMOOTH \
  { &fc_layer_smooth, NULL }

/* How a point gets its texture coordinates (u, v): from 0 to 1 across one tile, u to the right and v downwards as the image is stored. */
typedef struct fc_mapping_kind fc_mapping_kind;
extern const fc_mapping_kind fc_mapping_planar; /* (P - origin) . u / u.u, the same with v: one tile from origin to origin + u + v; within 2^-24
                                                      of itself and of the tiles away */
/* Of the normal in world axes: u from +z over +x once around +y, v from +y down to -y; within 2^-20. */
extern const fc_mapping_kind fc_mapping_spherical;
/* Triangles: fc_shapes.uvs by the hit's barycentrics, so right in perspective; (0, 0) on other shapes. */
extern const fc_mapping_kind fc_mapping_vertices;
/* A mapping: how, and where a planar one lies. */
typedef struct fc_mapping {
  const fc_mapping_kind *kind;
  fc_vec3 origin, u, v;       /* planar: times 2^exponent, in world coordinates; u and v not 0 */
  int8_t exponent;            /* -31..32 */
  uint8_t repeat_u, repeat_v; /* what comes out is multiplied by these; 1 or more */
} fc_mapping;

/* What colour stands at (u, v). */
typedef struct fc_texture_kind fc_texture_kind;
extern const fc_texture_kind fc_texture_checker; /* two by two squares a tile, the first colour at (0, 0) */
/* A picture; data: fc_image. */
extern const fc_texture_kind fc_texture_image;
/* The same in at most 256 colours; data: fc_palette_image. */
extern const fc_texture_kind fc_texture_palette;
/* Data of fc_texture_checker. */
typedef struct fc_checker {
  fc_rgb colour[2];
} fc_checker;
/* How a fc_image stores a texel. */
typedef enum fc_texel_format {
  FC_TEXEL_RGB888 = 0, /* three bytes, red first */
  FC_TEXEL_RGB565 = 1, /* uint16_t, red on top */
  FC_TEXEL_GREY8 = 2
} fc_texel_format;
/* Levels are proportional to light. Texel (x, y) covers u in x / width .. (x + 1) / width. */
typedef struct fc_image {
  const void *texels;     /* rows from the top, without gaps; may live in flash */
  uint16_t width, height; /* 1..4096 */
  uint8_t format;         /* fc_texel_format */
  uint8_t bilinear;       /* 0: the nearest texel; 1: between the four around, weights within 2^-8 */
  uint8_t clamp;          /* 0: tiles; 1: the border's texels go on for ever */
} fc_image;

/* The same in at most 256 colours: `image.texels` are bytes, each the number of a colour; image.format is FC_TEXEL_RGB888, the colours'. */
typedef struct fc_palette_image {
  fc_image image;
  const uint8_t *colours; /* three bytes each, red first; may live in flash */
  uint16_t colour_count;  /* greater than every texel, or FC_ERR_INDEX */
} fc_palette_image;

/* A texture: what stands at a point's coordinates replaces the reflectance, or is multiplied with it. */
extern const fc_layer_kind fc_layer_texture;
/* Data of fc_layer_texture. */
typedef struct fc_texture {
  const fc_mapping *mapping;
  const fc_texture_kind *pattern;
  const void *pattern_data; /* fc_checker, fc_image or fc_palette_image */
  uint8_t modulate;         /* 0: replaces; 1: multiplies */
} fc_texture;

/* What rays see that meet nothing, instead of fc_scene.background. */
typedef struct fc_sky_kind fc_sky_kind;

/* A gradient from the background (looking against `up`) to `top` (looking along it): linear in the cosine between the ray and `up`, each channel
 * within 2^-20. */
extern const fc_sky_kind fc_sky_gradient;
/* A sky: its kind and what that needs. */
typedef struct fc_sky {
  const fc_sky_kind *kind;
  fc_vec3 up; /* world axes, any length but 0 */
  fc_rgb top;
} fc_sky;

#ifdef __cplusplus
}
#endif

#endif
