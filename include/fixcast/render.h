/*
 * Frames and strips: set a frame up once, then render any rows of it, in any order, into the caller's memory.
 *
 * The same bits come out whatever the strip height, the order of the strips, the compiler or the machine.
 */
#ifndef FIXCAST_RENDER_H
#define FIXCAST_RENDER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fixcast/camera.h"
#include "fixcast/framebuffer.h"
#include "fixcast/ray.h"
#include "fixcast/scene.h"
#include "fixcast/transfer.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FC_SIZE_MAX UINT16_C(4096) /* largest width or height of a frame */

/* What a frame gives up for speed (docs/SPEC.md section 11 has the numbers, docs/REPORT.md what it saves on each chip). */
typedef enum fc_profile {
  FC_PROFILE_EXACT = 0,     /* nothing: as exact arithmetic decides */
  FC_PROFILE_FAST = 1,      /* visible primitives and depth exact; a channel within 4/255; where the shadow of a sphere on a plane is
                            closer to its edge than its form can tell for certain, what the form says */
  FC_PROFILE_HALF = 2,      /* a sample for each block of 2x2 pixels, itself exact; drawn by fc_render_profile */
  FC_PROFILE_INTERLACED = 3 /* a frame is every other row, exact; drawn by fc_render_profile, field 0 and 1 in turn */
} fc_profile;

/* All zero is the default. */
typedef struct fc_options {
  uint8_t offset_rule;         /* fc_offset_rule for shadow tests */
  uint8_t depth_exponent_bits; /* 0: by the scene's depth range; or 2, 3, 4 */
  int8_t epsilon_exponent;     /* -31..31 */
  uint8_t profile;             /* fc_profile */
  int32_t epsilon;             /* FC_OFFSET_EPSILON: epsilon * 2^epsilon_exponent world coordinates; 0..FC_COORDINATE_MAX */
  const fc_transfer *transfer; /* what the display makes of a level; NULL: levels are proportional to light */
} fc_options;

/* World to camera: right, up, forward as rows, and where the eye is. Private. */
typedef struct fc_view {
  int32_t row[3][3]; /* Q30 */
  int64_t eye[3];    /* world coordinates times 2^fine */
  uint8_t fine;      /* extra fraction bits of eye, 0..31 */
  int16_t shift;     /* camera grid unit = 2^shift world coordinates / 2^fine */
  int32_t focal;     /* z of every pixel's direction; x and y are whole numbers times 2^pixel_shift */
  uint8_t pixel_shift;
} fc_view;

/* A frame: the camera-space copy of a scene. Filled by fc_frame_setup; fields are private. It keeps pointers to the
 * scene's tables and the memory, which must outlive it, and is not changed by rendering (threads may share it). */
typedef struct fc_frame {
  fc_scene scene; /* the scene's own fields, copied: the tables stay where they are */
  void *memory;
  const int64_t *lights;  /* in memory: camera-space positions, three a light */
  const uint8_t *casters; /* in memory: a bit a node of the hierarchy, whether anything below casts shadows; NULL: all do */
  fc_view view;
  fc_options options;
  uint16_t width, height; /* of what is drawn: of FC_PROFILE_HALF its samples */
  uint8_t odd;            /* of FC_PROFILE_HALF: bit 0, 1: the last samples stand for one column, row */
  int64_t epsilon_grid;   /* epsilon in camera grid units */
  uint32_t depth_near;    /* camera z, in grid units, of depth value 1 */
  uint8_t depth_exponent_bits;
  uint8_t light; /* how the scan engine lights it */
  bool layered;  /* without lights: some material has layers */
  uint8_t far_shift;
  uint32_t far_low, far_high; /* near / z, Q30: beyond the far limit everywhere below, within it above */
  uint32_t far_scale;
  uint32_t light_level[3]; /* of the only light, Q15 */
} fc_frame;

/* Bytes of working memory a frame of this scene needs (16 a vertex and 2 a triangle with 144 a table, 32 a sphere, 40 a plane, 24 a light;
 * 2 bits a leaf of a hierarchy over triangles; rounded up), or an error through *error (may be NULL), then 0. */
size_t fc_frame_memory(const fc_scene *scene, int *error);

/* Checks the scene and the camera and brings them into camera space. `memory` is the caller's, aligned for int64_t,
 * at least fc_frame_memory() bytes, and must live as long as the frame. `options` may be NULL.
 * Errors: any of fc_error; on an error the frame must not be used. */
int fc_frame_setup(fc_frame *frame, const fc_scene *scene, const fc_camera *camera, const fc_options *options,
                   uint16_t width, uint16_t height, void *memory, size_t memory_bytes);

/* Renders rows y .. y + rows - 1 with the scan engine. Returns FC_OK or an error (nothing is written then). Strips are
 * independent: two cores may draw strips of one frame at the same time, each into its own target, in any order (README). */
int fc_render_rows(const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target);

/* What a strip is drawn in, one a core that draws at the same time; nothing has to be kept there between calls. */
#define FC_SCRATCH_WORDS (sizeof(void *) > 4 ? 352 : 316)
/* What rendering works in: opaque. */
typedef struct fc_scratch {
  int64_t words[FC_SCRATCH_WORDS];
} fc_scratch;

/* The same as fc_render_rows with most of what that takes from the stack in memory of the caller's: for chips with little stack a
 * core, or an interrupt's (docs/SPEC.md section 14 has the bytes). Errors: those of fc_render_rows; FC_ERR_NULL without scratch. */
int fc_render_rows_in(fc_scratch *scratch, const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target);

/*
 * Renders rows y .. y + rows - 1 as the frame's profile says.
 *
 * FC_PROFILE_EXACT, FC_PROFILE_FAST: as fc_render_rows, `field` is not looked at.
 *
 * FC_PROFILE_HALF: the frame of (width + 1) / 2 x (height + 1) / 2 samples that fc_render_rows would draw, each doubled to the
 * right and downwards in pixels, depth, primitive and lit alike. Target and rows are of the whole frame. Any strips give the same
 * bits; a strip that begins at an odd row or has an odd number of rows draws a row of samples that its neighbour draws too.
 *
 * FC_PROFILE_INTERLACED: the rows y' of the frame with y' % 2 == field, into the rows of the target where fc_render_rows puts
 * them. The others are not written, in none of the target's buffers: what the caller left there stays. Draw field 0 and field 1
 * in turn, a frame each, into a buffer of the whole frame, or send only the rows that were drawn to a panel that keeps the
 * others. Together the fields of a still scene are the exact frame.
 *
 * Programs that don't call it are not made larger by it. Errors: those of fc_render_rows, and FC_ERR_PROFILE for a field above 1.
 */
int fc_render_profile(const fc_frame *frame, uint8_t field, uint16_t y, uint16_t rows, const fc_target *target);

/* The same as fc_render_rows by the ray engine, a ray a pixel: slow, and the definition. Visible primitives, lights that reach them and
 * depth codes are equal; colours are within one level (SPEC section 5). */
int fc_render_rows_by_rays(const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target);

/* What pixel (x, y) of the whole frame shows, in any profile: 1 with *hit filled (world coordinates; lit as in fc_target, lit may be NULL),
 * 0 for background, or an error. hit->t_q32 is the depth (camera z) in world coordinates. hit->position is
 * within 2 world coordinates plus one part in 2^28 of the distance, clamped to +-FC_COORDINATE_MAX. */
int fc_pick(const fc_frame *frame, uint16_t x, uint16_t y, fc_hit *hit, uint32_t *lit);

/* Depth codes are the floating-point form of depth_near / z: `depth_exponent_bits` exponent bits, the rest mantissa
 * with a hidden one, correctly rounded. The camera z of a code (not 0), as mantissa * 2^*exponent world coordinates,
 * mantissa in 2^31..2^32-1. Relative error of the mantissa 2^-30; of the code 2^-15, 2^-14 or 2^-13. */
uint32_t fc_depth_z(const fc_frame *frame, uint16_t code, int *exponent);

/* The object id of a primitive number, 0 where there is none (as for 0xffff, the background). */
uint16_t fc_object(const fc_frame *frame, uint16_t primitive);

#ifdef __cplusplus
}
#endif

#endif
