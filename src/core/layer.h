/*
 * What a kind of layer can do, and the shading of one surface point that layers act on.
 *
 * Radiance is linear, Q39 a channel (a reflectance in Q15 times light in Q24), below FC_RADIANCE_MAX.
 */
#ifndef FC_LAYER_H
#define FC_LAYER_H

#include <stdint.h>

#include "quick.h"
#include "shade.h"

/* A surface point being shaded. */
typedef struct fc_shading {
  const fc_frame *frame;
  const fc_space *space;
  const fc_surface *surface;
  int64_t normal[3];     /* towards the ray's side, at most 30 bits */
  fc_quick normal_scale; /* 1 / |normal| */
  uint16_t diffuse[3];   /* reflectance, Q15 */
  uint64_t arriving[3];  /* light times cosine, Q39: 16 + 32 bits a light, 65535 lights and ambient stay below 2^64 */
  uint64_t added[3];     /* radiance that layers add */
  struct {
    int64_t to[3];      /* from the point, at most 30 bits */
    fc_quick to_scale;  /* 1 / |to| */
    fc_quick strength;  /* falloff and the intensity's exponent: what its colour is to be multiplied by */
    uint16_t colour[3]; /* Q15 */
  } light;              /* that at hand */
  fc_material material;
} fc_shading;

struct fc_layer_kind {
  /* Checks the data: FC_OK or an error. */
  int (*check)(const void *data);
  /* Before the lights; NULL: nothing to do. */
  void (*surface)(fc_shading *shading, const void *data);
  /* For each light that reaches the point; NULL. */
  void (*light)(fc_shading *shading, const void *data);
  /* After the lights, for a point that the eye sees; NULL. Points seen in mirrors are shaded without. */
  void (*follow)(fc_shading *shading, const void *data);
  /* Its fast forms (coat.h); NULL: such materials are shaded by rays. */
  const struct fc_coat_layer *coat;
};

/* The mask of lights that reach a completed surface, as fc_shade tells it. */
uint32_t fc_lights_reaching(const fc_frame *frame, const fc_space *space, const fc_surface *surface);

/* Shades a completed surface up to its lights, of which fc_lights_reaching gave the mask: what is left is fc_shading_radiance. */
void fc_shading_light(fc_shading *shading, const fc_frame *frame, const fc_space *space, const fc_surface *surface, uint32_t lit);

/* What leaves the point so far: of the reflectance and of the layers. */
void fc_shading_radiance(const fc_shading *shading, uint64_t radiance_q39[3]);

/* radiance[] += weight (Q15) * more[]. */
void fc_radiance_add(uint64_t radiance_q39[3], const uint16_t weight[3], const uint64_t more_q39[3]);

/* The data of a material's layer of a kind, NULL when it has none. */
const void *fc_layer_data(const fc_material *material, const fc_layer_kind *kind);

/* Calls one of a kind's functions, if it has it, for every layer of the material. */
enum {
  FC_LAYER_SURFACE,
  FC_LAYER_LIGHT,
  FC_LAYER_FOLLOW
};
void fc_layers_apply(fc_shading *shading, uint8_t which);

/* 1 / |v| for 30-bit components, 0 for a zero vector. */
fc_quick fc_inverse_length(const int64_t v[3]);

/* A colour as an array. */
static inline void fc_channels(const fc_rgb *rgb, uint16_t channel[3]) {
  channel[0] = rgb->r;
  channel[1] = rgb->g;
  channel[2] = rgb->b;
}

#endif
