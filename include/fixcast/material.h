/*
 * What a surface is made of: a reflectance, and layers over it.
 *
 * A material without layers is matte (Lambert). A layer names a kind, which is code, and its data; programs that name no kind do not link it. Scenes
 * are shaded in linear light; a fc_transfer turns that into the levels of a display.
 */
#ifndef FIXCAST_MATERIAL_H
#define FIXCAST_MATERIAL_H

#include <stdint.h>

#include "fixcast/vec3.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Linear colour, each channel Q1.15: 32768 is 1.0 (SPEC "Light units"). */
typedef struct fc_rgb {
  uint16_t r, g, b;
} fc_rgb;

#define FC_ONE_Q15 UINT16_C(32768)
/* A channel or colour given in 0..255, rounded to nearest Q1.15. */
#define FC_CHANNEL8(v) ((uint16_t)(((uint32_t)(v)*32768u + 127u) / 255u))
#define FC_RGB8(r, g, b) \
  { FC_CHANNEL8(r), FC_CHANNEL8(g), FC_CHANNEL8(b) }
/* A grey given as a real constant in 0..1.99: FC_GREY(0.875). */
#define FC_GREY_CHANNEL(v) ((uint16_t)((v)*32768.0 + 0.5))
#define FC_GREY(v) \
  { FC_GREY_CHANNEL(v), FC_GREY_CHANNEL(v), FC_GREY_CHANNEL(v) }

/* One kind of layer: code. Opaque; those below are all there are. */
typedef struct fc_layer_kind fc_layer_kind;

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

#define FC_LAYERS_MAX 4

#define FC_MATTE(diffuse) \
  { diffuse, 0, NULL }
#define FC_WHITE \
  { FC_ONE_Q15, FC_ONE_Q15, FC_ONE_Q15 }
#define FC_LAYERED(diffuse, layers) \
  { diffuse, FC_COUNT_OF(layers), (layers) }

/* Phong's highlight: adds specular * light * (r . v)^shininess for each light that reaches the point, r the light's direction mirrored at the normal
 * and v the direction to the eye (Phong 1975; the lectures' form, not multiplied by the cosine). Relative error below 2^-21 (shininess + 1). */
extern const fc_layer_kind fc_layer_phong;
typedef struct fc_phong {
  fc_rgb specular;        /* Q1.15 */
  uint16_t shininess_q4;  /* exponent, sixteenths: 16 is 1.0; 1 or more */
} fc_phong;

/* A perfect mirror in the normal: adds reflectance * what is seen that way, up to `bounces` mirrors in a row (those of the first mirror count);
 * the last one in the row shows its other layers only. */
extern const fc_layer_kind fc_layer_mirror;
typedef struct fc_mirror {
  fc_rgb reflectance; /* Q1.15, at most 32768 */
  uint8_t bounces;    /* 1..FC_BOUNCES_MAX */
} fc_mirror;
#define FC_BOUNCES_MAX 16

/* Light of its own: adds light * 2^exponent. It does not light other surfaces. */
extern const fc_layer_kind fc_layer_emission;
typedef struct fc_emission {
  fc_rgb light;    /* Q1.15 */
  int8_t exponent; /* 0..7 */
} fc_emission;

#ifdef __cplusplus
}
#endif

#endif
