/*
 * The scan engine's side of layers: a material whose layers all have fast forms for a shape is lit as a matte one, and then coloured here.
 *
 * What decides (visible, lit) is the scan engine's, layers or not; only values are made here, each with a bound that docs/SPEC.md section 5
 * states. What a form cannot promise is shaded by a ray, as all layered materials are without these forms.
 */
#ifndef FC_COAT_H
#define FC_COAT_H

#include "ball.h"
#include "layer.h"
#include "planar.h"
#include "scan.h"

/* Colours a primitive's tiles. */
struct fc_coat_kind {
  /* Whether every layer of the material has forms for the shape and the light that `scan` is set up for, the tint included. */
  bool (*fits)(const fc_scan *scan, const fc_material *material);
  /* In place of fc_planar_light. */
  void (*planar)(fc_scan *scan, const int64_t normal[3], fc_i128 k, const int64_t *hull, uint8_t corners);
  /* In place of fc_ball_draw without a coat. */
  void (*sphere)(fc_scan *scan, const fc_placed_sphere *placed);
};

/* Any layers; its functions, for kinds that draw some materials by themselves. */
extern const fc_coat_kind fc_coat_layers;
bool fc_coat_fits(const fc_scan *scan, const fc_material *material);
void fc_coat_planar(fc_scan *scan, const int64_t normal[3], fc_i128 k, const int64_t *hull, uint8_t corners);
void fc_coat_sphere(fc_scan *scan, const fc_placed_sphere *placed);

/* What a layer does with the pixels: each role at most once in a material. */
enum {
  FC_COAT_ADDS = 1,
  FC_COAT_TURNS = 2,
  FC_COAT_COLOURS = 4,
  FC_COAT_MIRRORS = 8
};

/* A tile being coloured. */
typedef struct fc_coat fc_coat;

/* What a kind of layer brings: NULL functions have nothing to do. */
typedef struct fc_coat_layer {
  const fc_coat_kind *kind; /* of a material whose first layer it is: fc_coat_layers, or what takes the rest to it */
  uint8_t role;             /* FC_COAT_... */
  bool (*fits)(const fc_scan *scan, const void *data);
  /* A tile on a plane: sets up forms; makes the cosines of a run; colours it, or adds to its colours. */
  void (*planar_start)(fc_coat *coat, const void *data);
  void (*planar_cosines)(fc_coat *coat, const void *data);
  void (*planar_run)(fc_coat *coat, const void *data);
  /* A tile of a sphere, and a run of it. */
  void (*sphere_start)(fc_coat *coat, const void *data);
  void (*sphere_run)(fc_coat *coat, const void *data);
  /* All pixels of a run that show the sphere, lit or not, after the lit ones: run.p is theirs, run.e is not. */
  void (*sphere_seen)(fc_coat *coat, const void *data);
} fc_coat_layer;

/* Up to 32 neighbouring pixels of a row. */
typedef struct fc_coat_run {
  uint16_t row, column;
  uint32_t bits;           /* those to colour; planes: the first pixel is one of them */
  uint32_t lit;            /* planes: those of them that the light reaches */
  uint8_t count;           /* planes: up to the last of them */
  uint32_t slow;           /* planes: those that a layer leaves to a ray */
  uint32_t *cosine;        /* planes: Q16, of each pixel, when fc_coat.cosines says so; 0 where the light does not reach */
  const fc_square *square; /* planes: W.W at the row's first column */
  const uint32_t *p;       /* spheres: near / z, as fc_ball_light has it */
  const uint32_t *e;       /* ... s - h in Q24, within the light's margin */
  uint32_t b, b_step;      /* ... p less the root: at the first pixel, and its steps */
} fc_coat_run;

/* Phong's highlight: c^2 = X^2 / (Y |D|^2) in integers. */
typedef struct fc_coat_phong {
  uint32_t slope[3]; /* of the specular reflectance: levels as fc_tint has them, a highlight in Q16 */
  uint32_t shininess_q8;
  uint32_t least; /* c^n is below 2^-12 where c^2 is below this, Q16, rounded down ... */
  uint32_t most;  /* ... and where log2(1 / c^2) is beyond this, Q20 */
  uint16_t row;   /* of the squares */
  fc_square x;    /* planes: X */
  fc_square d;    /* |D|^2 */
  /* spheres */
  int32_t along, along_dx, along_dy; /* D.(L - C) / l at the tile's first pixel */
  uint32_t root;                     /* p less b times root / 2^32 2^root_up: n.D */
  int8_t root_up;
  uint8_t root_down; /* 15 - root_up */
  uint8_t octave;    /* p of fewer bits tells too little */
  bool rough;        /* all of them do */
  uint32_t h;        /* r / l in Q24 */
  int32_t t0;        /* c^n is below 2^-12 where X / 2^16 is below t0 - t1 (s - h) */
  uint32_t t1;
} fc_coat_phong;

extern const fc_coat_layer fc_coat_layer_phong;

/* The barycentric weights of a triangle's vertices over a tile, times a common number: below 2^29 there. */
typedef struct fc_coat_weights {
  int32_t at[3], dx[3], dy[3]; /* at the tile's first pixel, to the next column, to the next row */
  uint16_t vertex[3];          /* in the table's vertices */
} fc_coat_weights;

/* False when rounding would tell. */
bool fc_coat_weights_set(const fc_scan *scan, fc_coat_weights *weights);

/* Smooth normals: as they are, by rays, or by forms. */
enum {
  FC_SMOOTH_NOT,
  FC_SMOOTH_SLOW,
  FC_SMOOTH_FORMS
};
typedef struct fc_coat_smooth {
  int32_t at[3], dx[3], dy[3]; /* the normal, towards the eye, any length: below 2^29 in the tile, or 2^30.1 within a small triangle */
  uint8_t how;
} fc_coat_smooth;

extern const fc_coat_layer fc_coat_layer_smooth;

/* A form of the pixel: at the tile's first, to the next column, to the next row. */
typedef struct fc_coat_wide {
  int64_t at, dx, dy;
} fc_coat_wide;

/* A texture: texel coordinates X = A / Q. */
typedef struct fc_coat_axis {
  fc_coat_wide a;   /* 2^14 Q at most where it is used */
  fc_quick inverse; /* 1 / size */
  uint16_t size;    /* of the image, in texels */
} fc_coat_axis;

typedef struct fc_coat_texture {
  /* what each pixel wants, first: instructions reach few bytes */
  const uint8_t *texels;      /* of the image's format */
  const uint8_t *colours;     /* a palette's */
  uint32_t width;             /* texels */
  uint32_t mask[2];           /* size - 1; below it is not used unless `masked` */
  uint32_t base[3], slope[3]; /* of white, as fc_tint has them without the half, times 256 / 255 */
  bool masked;                /* tiles whose sizes are powers of two */
  bool clamp;
  bool sure;      /* the forms hold */
  bool plain;     /* masked, and RGB565 that no light clamps */
  uint8_t format; /* fc_texel_format */
  fc_coat_wide q; /* below 2^38 */
  fc_coat_axis axis[2];
  const fc_texture_kind *pattern;
} fc_coat_texture;

/* A run whose texel coordinates, less base and from the centre of texel 0, are known in Q16. */
typedef struct fc_coat_span {
  const fc_scan *scan;
  uint32_t bits;
  int32_t base[2];        /* below 2^14 */
  const int32_t *xy;      /* in turns, below 2^12 texels */
  const uint32_t *cosine; /* Q16 */
  uint8_t *to;
} fc_coat_span;

extern const fc_coat_layer fc_coat_layer_texture;

/* Colours a pixel from its levels with FC_TINT_BITS of fraction, not rounded yet. */
void fc_coat_put_levels(const fc_tint *tint, const uint32_t level[3], uint8_t *to);

/* Mirrors: what else is in the scene. */
#define FC_COAT_SEEN 8
typedef struct fc_coat_seen {
  fc_form form;
  bool sphere;                                                                                          /* or a plane */
  int8_t (*hides)(const fc_form *form, const int64_t light[3], const int32_t point[3], uint32_t error); /* fc_kind.hides */
  fc_quick inverse;                                                                                     /* 1 / radius or 1 / |normal| */
  int64_t lamp;                                                                                         /* planes: k - n.L, exact */
} fc_coat_seen;

typedef struct fc_coat_mirror {
  fc_coat_seen seen[FC_COAT_SEEN];
  uint8_t count;
  uint16_t weight[3]; /* reflectance, Q15 */
  int64_t limit;      /* the far limit in grid units, within 2^-28; INT64_MAX: there is none that near */
  fc_quick depth;     /* over p it is t */
  fc_quick inverse;   /* 1 / radius */
} fc_coat_mirror;

extern const fc_coat_layer fc_coat_layer_mirror;

struct fc_coat {
  fc_scan *scan;
  fc_coat_layer layer[FC_LAYERS_MAX];
  const void *data[FC_LAYERS_MAX];
  uint8_t layers;
  const fc_planar *planar; /* planes */
  const fc_cosine *cosine;
  const fc_ball_light *light; /* spheres */
  const fc_placed_sphere *placed;
  int16_t drop;
  uint32_t error;
  fc_coat_run run;
  bool lit;      /* planes: the light reaches some of the tile; otherwise planar and cosine lack W's forms */
  bool cosines;  /* planes: the run's cosines are wanted, and the tile is not coloured yet */
  bool textured; /* ... and a layer colours the run, what is not lit too */
  fc_coat_phong phong;
  fc_coat_smooth smooth;
  fc_coat_texture texture;
  fc_coat_mirror mirror;
};

/* a.b over a tile, for forms with components below 2^30 there. */
void fc_square_set(fc_square *s, const fc_sheaf *a, const fc_sheaf *b);

/* The value and differences of a form `column` columns on, in 2^down: floored value, rounded differences. Over 32 columns what follows them is within
 * 1 + 16 + 248 of the form. */
typedef struct fc_steps {
  uint32_t at, dx, dxx;
} fc_steps;
void fc_steps_start(const fc_square *s, uint16_t column, uint8_t down, fc_steps *steps);

static inline void fc_steps_next(fc_steps *s) {
  s->at += s->dx;
  s->dx += s->dxx;
}

/* The tile's directions as a sheaf: components below 2^30. */
void fc_coat_directions(const fc_scan *scan, fc_sheaf *d);

/* Colours a pixel from its cosine and a highlight, both Q16. */
void fc_coat_put(const fc_tint *tint, const uint32_t slope[3], uint32_t cosine, uint32_t highlight, uint8_t *to);

#endif
