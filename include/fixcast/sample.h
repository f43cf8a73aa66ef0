/*
 * Several rays a pixel, and other cameras than the pinhole: which rays a frame is drawn by, and what becomes of them.
 *
 * A pattern says where in the frame rays are asked for, a lens turns such a place into a ray, and the mean of their linear radiance
 * is the pixel. Patterns and lenses are const records: programs that don't name one do not link it. Everything is integers and
 * nothing is remembered from strip to strip: the same bits for any strip height, on any machine.
 *
 * Places are in pixels, Q16, from the frame's top left corner to the right and downwards: pixel (x, y) has its centre at
 * (x + 1/2, y + 1/2). For the pinhole the ray at a pixel's centre is exactly that of fc_render_rows_by_rays.
 */
#ifndef FIXCAST_SAMPLE_H
#define FIXCAST_SAMPLE_H

#include "fixcast/render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- lenses ---- */

/* One kind of lens: code. Opaque; those below are all there are. */
typedef struct fc_lens_kind fc_lens_kind;

/* A lens: its kind and what that needs. */
typedef struct fc_lens {
  const fc_lens_kind *kind;
  const void *data; /* of the type that the kind says, or NULL where it says none; may live in flash */
} fc_lens;

/* The frame's own camera. No data. */
extern const fc_lens_kind fc_lens_pinhole;

/*
 * Parallel rays along the camera's forward axis, from the plane through its eye (what lies behind that plane is not seen).
 * Pixels are square; `span` * 2^span_exponent world coordinates are seen across the frame's shorter side, between its outer edges.
 * Directions are exact; origins are rounded to the camera grid, within half a unit an axis. The camera's field of view says nothing.
 * FC_ERR_LENS: the span is not positive, or the frame then reaches beyond 2^30 camera grid units, the largest extent of the scene.
 */
extern const fc_lens_kind fc_lens_orthographic;
/* Data of fc_lens_orthographic. */
typedef struct fc_orthographic {
  int32_t span;         /* 1..FC_COORDINATE_MAX */
  int8_t span_exponent; /* -31..32 */
} fc_orthographic;

/* The span with which a camera frames its target as its pinhole does (FC_FOV_EDGES): 2 |target - eye| tan(half the field of view), relative
 * error below 2^-29. Errors: FC_ERR_NULL; FC_ERR_CAMERA_TARGET, FC_ERR_FIELD_OF_VIEW, FC_ERR_COORDINATE, FC_ERR_EXPONENT as fc_frame_setup. */
int fc_orthographic_of_camera(fc_orthographic *lens, const fc_camera *camera);

/*
 * Equidistant fisheye: the angle to the forward axis is proportional to the distance from the frame's centre, and `angle_q16` is seen
 * across the shorter side, between its outer edges. Beyond that circle there is nothing: the background. The camera's field of view says
 * nothing. Directions are within 2^-28 radians of what the place says. FC_ERR_LENS: the angle is 0 or more than a whole turn.
 */
extern const fc_lens_kind fc_lens_fisheye;
/* Data of fc_lens_fisheye. */
typedef struct fc_fisheye {
  uint32_t angle_q16; /* the full angle, in whole turns Q16: 32768 is 180 degrees; 1..65536 */
} fc_fisheye;

/*
 * Equirectangular panorama: longitude -180..180 degrees across the frame, forward in its middle and right to the right of it; latitude
 * 90..-90 degrees from its top edge to its bottom edge, along the camera's up. Directions are within 2^-28 radians. No data.
 */
extern const fc_lens_kind fc_lens_panorama;

/* ---- patterns ---- */

/* One kind of pattern: code. Opaque; those below are all there are. */
typedef struct fc_pattern fc_pattern;

extern const fc_pattern fc_pattern_one;      /* the pixel's centre */
extern const fc_pattern fc_pattern_regular;  /* the centres of count x count equal cells; count 1..FC_SAMPLE_SIDE_MAX */
extern const fc_pattern fc_pattern_random;   /* `count` places, each anywhere in the pixel; count 1..FC_SAMPLE_COUNT_MAX */
extern const fc_pattern fc_pattern_jittered; /* one place anywhere in each of count x count equal cells; count 1..FC_SAMPLE_SIDE_MAX */

/*
 * Adaptive: the pixel's centre and its four corners, which the neighbours share, so two rays a pixel to begin with. Each quarter of the
 * pixel stands for the mean of its corner and the centre when they show the same object and differ by no more than the threshold;
 * otherwise it is a square of its own, with two more corners and a centre, treated alike, down to `depth` halvings. The threshold grows as
 * the area shrinks, fourfold at each halving. Every ray weighs what its area is. Corners that squares share are traced once in a
 * pixel and on the edge to its right neighbour. FC_FILTER_BOX only. Needs scratch memory. Good: depth 3, threshold FC_CHANNEL8(6).
 */
extern const fc_pattern fc_pattern_quincunx;

/* Most cells along a side of a regular or jittered pattern. */
#define FC_SAMPLE_SIDE_MAX 64
/* Most rays a pixel of a random pattern. */
#define FC_SAMPLE_COUNT_MAX 4096
/* Most halvings of a pixel by the quincunx pattern. */
#define FC_QUINCUNX_DEPTH_MAX 5

/* How rays are spread over a pixel's surroundings. */
typedef enum fc_filter {
  FC_FILTER_BOX = 0, /* the mean over the pixel */
  FC_FILTER_TENT = 1 /* weights that fall linearly to 0 at the neighbours' centres; samples are placed by that density and weigh alike, so
                        that a strip needs nothing of its neighbours */
} fc_filter;

/* How a frame is sampled. Read through FC_READ: may live in flash. */
typedef struct fc_sampling {
  const fc_pattern *pattern;
  fc_lens lens;
  uint16_t count;         /* of regular, random and jittered, as said there */
  uint16_t threshold_q15; /* of quincunx: differences of a linear channel up to this are none; 0..32768 (white). 0: all differences count */
  uint8_t depth;          /* of quincunx: 0..FC_QUINCUNX_DEPTH_MAX */
  uint8_t filter;         /* fc_filter */
  uint32_t seed;          /* of random and jittered: another seed, other places */
} fc_sampling;

/* A one-sample pinhole, to start from. */
#define FC_SAMPLING_ONE \
  { &fc_pattern_one, {&fc_lens_pinhole, NULL}, 0, 0, 0, FC_FILTER_BOX, 0 }

/* Bytes of scratch memory that fc_sample_rows needs for strips of this frame: 0, or, for quincunx, 16 for each of width + 1 corners and of
 * (2^depth + 1)^2 points of a pixel: 3.4 KB for 128 columns and depth 3. 0 also on an error, through *error (may be NULL): those of
 * fc_sample_rows. */
size_t fc_sample_scratch(const fc_frame *frame, const fc_sampling *how, int *error);

/*
 * Renders rows y .. y + rows - 1 by rays. Strips are independent, as those of fc_render_rows.
 *
 * A pixel is the mean of its rays' linear radiance. target->depth, primitive and lit are those of the ray at the pixel's centre; each
 * may be NULL here, depth too. When one is wanted and the pattern has no ray there, another is traced for them that adds nothing to the
 * pixel. Depth is the camera z for pinhole and orthographic; for fisheye and panorama the same code holds the distance from the eye.
 *
 * `samples`: rows of width, or NULL: how many rays the pixel has added. Of quincunx a corner that pixels share counts for the pixel that it
 * is the upper left corner of, those on the frame's right and bottom edges for the last pixels, and what lies on the edge to the left for
 * the pixel there. (A strip traces its uppermost corners again; they are not counted twice.)
 *
 * `scratch`: fc_sample_scratch() bytes, aligned for uint32_t; nothing of it is kept. NULL when that is 0. Two cores need one each.
 *
 * Errors: those of fc_render_rows; FC_ERR_SAMPLING: no pattern, or a count, depth, filter or threshold out of its range; FC_ERR_LENS: no
 * lens, or data out of range; FC_ERR_MEMORY. Nothing is written then.
 */
int fc_sample_rows(const fc_frame *frame, const fc_sampling *how, uint16_t y, uint16_t rows, const fc_target *target, uint16_t *samples,
                   void *scratch, size_t scratch_bytes);

#ifdef __cplusplus
}
#endif

#endif
