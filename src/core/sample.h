/*
 * What a pattern and a lens can do, and the strip that both work for.
 *
 * A lens turns a place in the frame into a ray of camera space; a pattern asks for places and hands back a pixel's radiance.
 */
#ifndef FC_SAMPLE_H
#define FC_SAMPLE_H

#include <stdbool.h>
#include <stdint.h>

#include "fixcast/sample.h"
#include "space.h"

/* One pixel, and half of one, of a place. */
#define FC_PLACE_ONE INT32_C(65536)
#define FC_PLACE_HALF INT32_C(32768)

/* What a lens keeps for a strip. */
typedef struct fc_lens_state {
  fc_num scale;   /* lengths or angles a unit of fc_lens_offset, as the lens has it */
  uint32_t angle; /* half the full angle, 2^-32 turns */
} fc_lens_state;

struct fc_lens_kind {
  /* Checks the data and fills the state. `frame` is the strip's own copy: a lens whose depth is not t times the frame's focal length sets
   * view.focal to what it is t times of. FC_OK or an error. */
  int (*prepare)(fc_lens_state *state, fc_frame *frame, const void *data);
  /* The ray of a place; components of the direction below 2^30, of the origin too. False: nothing is seen there. */
  bool (*ray)(const fc_lens_state *state, const fc_frame *frame, const int32_t place_q16[2], int64_t origin[3], int64_t direction[3]);
};

/* A strip being sampled. */
typedef struct fc_sampler {
  fc_frame frame; /* as the lens has it */
  fc_space space; /* of that copy */
  fc_sampling how;
  fc_lens_kind lens;
  fc_lens_state state;
  const fc_target *target;
  uint16_t *samples;
  uint16_t y, rows; /* of the frame */
  uint8_t pixel_bytes;
  bool centre_wanted; /* by depth, primitive or lit */
} fc_sampler;

struct fc_pattern {
  /* Whether the fields that the pattern looks at are within their ranges. */
  bool (*check)(const fc_sampling *how);
  /* Bytes of scratch memory; NULL: none. */
  size_t (*scratch)(const fc_sampling *how, uint16_t width);
  void (*strip)(const fc_sampler *sampler, void *scratch);
};

/* What a ray saw. */
typedef struct fc_seen {
  uint64_t radiance_q39[3]; /* at most FC_RADIANCE_MAX */
  uint32_t lit;
  uint16_t primitive, object, depth; /* as in fc_target; 0xffff, 0, 0 where there is nothing */
} fc_seen;

/* Traces the ray of a place. */
void fc_sample_trace(const fc_sampler *sampler, const int32_t place_q16[2], fc_seen *seen);

/* The centre of pixel x of a row of the strip. */
void fc_sample_centre(const fc_sampler *sampler, uint16_t x, uint16_t row, int32_t place_q16[2]);

/* Writes a pixel: its radiance, how many rays it took, and what its centre showed (NULL: not traced yet). */
void fc_sample_put(const fc_sampler *sampler, uint16_t x, uint16_t row, const uint64_t radiance_q39[3], uint16_t count, const fc_seen *centre);

/* A place in a pixel, each part 0..65535 from its upper left corner, before the filter moves it. */
typedef void fc_place(const fc_sampling *how, uint16_t x, uint16_t y, uint16_t index, uint32_t part_q16[2]);

/* Draws the strip with the mean of `count` rays a pixel, 1..4096, each where `place` puts it. */
void fc_sample_mean(const fc_sampler *sampler, uint16_t count, fc_place *place);

/* What lenses start from: a place's offset to the frame's centre in half pixels Q16, x to the right and y upwards; below 2^30. */
void fc_lens_offset(const fc_frame *frame, const int32_t place_q16[2], int64_t offset_q16[2]);

#endif
