/* The scan engine on spheres: the silhouette and the depth from two forms along a row, light from one scalar a pixel. */
#include "ball.h"
#include "coat.h"
#include "cone.h"
#include "planar.h"
#include "scan_kinds.h"
#include "search.h"

/* ---- set-up, once a frame ---- */

static uint16_t clamp_pixel(int32_t v, uint16_t size) { return v < 0 ? 0 : v >= size ? (uint16_t)(size - 1)
                                                                                     : (uint16_t)v; }

static FC_COLD void set_window(const fc_frame *frame, const fc_window *box, fc_placed_window *window) {
  window->x0 = clamp_pixel(box->x0, frame->width);
  window->x1 = clamp_pixel(box->x1, frame->width);
  window->y0 = clamp_pixel(box->y0, frame->height);
  window->y1 = clamp_pixel(box->y1, frame->height);
}

/* The least depth of a placed sphere: two 31-bit numbers' difference. */
static int32_t front_of(const fc_placed_sphere *placed, uint16_t index) { return placed[index].center[2] - placed[index].radius; }

/* Orders the first `count` entries of placed[].order from the eye on: what is drawn later is then mostly hidden, and neither shaded
 * nor asked about its shadows. Insertion at falling distances (Shell, (3^n - 1) / 2). */
static FC_COLD void sort_by_depth(fc_placed_sphere *placed, uint16_t count) {
  static const uint16_t gaps[] FC_ROM = {29524, 9841, 3280, 1093, 364, 121, 40, 13, 4, 1};
  uint8_t g;
  for (g = 0; g < FC_COUNT_OF(gaps); g++) {
    uint16_t i, j, gap;
    FC_READ_ONE(&gap, gaps + g);
    for (i = gap; i < count; i++) {
      const uint16_t moved = placed[i].order;
      const int32_t front = front_of(placed, moved);
      for (j = i; j >= gap && front_of(placed, placed[j - gap].order) > front; j = (uint16_t)(j - gap))
        placed[j].order = placed[j - gap].order;
      placed[j].order = moved;
    }
  }
}

FC_COLD void fc_sphere_project(const fc_frame *frame, const fc_shapes *shapes, void *memory) {
  fc_placed_sphere *placed = memory;
  int64_t limit = (int64_t)fc_num_round(fc_num_from_u64((uint64_t)frame->scene.far_limit, fc_view_far_exponent(frame)), 0);
  uint16_t i, visible = 0;
  limit = limit < 0 || limit > INT64_C(1) << 40 ? INT64_C(1) << 40 : limit - 1;
  for (i = 0; i < shapes->count; i++) {
    fc_placed_sphere *p = &placed[i];
    int64_t c[3], power, square;
    fc_window box;
    fc_num factor;
    c[0] = p->center[0];
    c[1] = p->center[1];
    c[2] = p->center[2];
    p->seen = FC_SPHERE_HIDDEN;
    if (!fc_ball_window(frame, c, p->radius, &box)) continue;
    set_window(frame, &box, &p->window);
    p->seen = FC_SPHERE_ODD;
    placed[visible++].order = i;
    square = fc_small_dot(c, c);
    /* 3 * 2^60 - 1: fits */
    power = square - (int64_t)p->radius * p->radius;
    if (c[2] <= p->radius || power <= 0) continue;
    factor = fc_num_mul(fc_num_from_u64((uint64_t)power, 0), fc_num_from_u64((uint64_t)frame->view.focal, 0));
    factor = fc_num_div(fc_num_from_u64(frame->depth_near, 0), factor);
    p->factor = (uint32_t)(factor.m >> 31);
    p->exponent = (int8_t)(factor.e + 31);
    /* |C| + r beyond the limit, which is cut to whole units, or not: squares below 3 * 2^60 */
    p->seen = frame->scene.far_limit > 0 &&
                      (limit <= p->radius || (limit < INT64_C(1) << 31 && square >= (limit - p->radius) * (limit - p->radius)))
                  ? FC_SPHERE_CUT
                  : FC_SPHERE_PLAIN;
  }
  if (visible < shapes->count) placed[visible].order = FC_SPHERE_LAST;
  sort_by_depth(placed, visible);
}

FC_COLD void fc_sphere_strip(fc_scan *scan, uint16_t rows) {
  const fc_placed_sphere *placed = scan->at->group.memory;
  uint16_t i;
  for (i = 0; i < scan->at->group.shapes.count && placed[i].order != FC_SPHERE_LAST; i++) fc_scan_item(scan, placed[i].order, rows);
}

bool fc_sphere_window(const fc_frame *frame, const fc_group *group, uint16_t index, fc_window *box) {
  const fc_placed_sphere *p = (const fc_placed_sphere *)group->memory + index;
  (void)frame;
  box->x0 = p->window.x0;
  box->x1 = p->window.x1;
  box->y0 = p->window.y0;
  box->y1 = p->window.y1;
  return p->seen != FC_SPHERE_HIDDEN;
}

/* ---- light ---- */

enum {
  LIGHT_UNKNOWN,
  LIGHT_FORMS,
  LIGHT_SLOW
};
#define MANY 255
#define UNSOUGHT 254 /* nothing in the tile has faced the light yet */

typedef struct occluder_list {
  const fc_scan *scan;
  fc_ball_light *light;
  int16_t way[3];  /* from the light to the ball, short */
  uint32_t length; /* squared */
} occluder_list;

/* Products of vectors of 15 bits: below 3 * 2^30. */
static uint32_t short_square(const int16_t v[3]) {
  return (uint32_t)((int32_t)v[0] * v[0]) + (uint32_t)((int32_t)v[1] * v[1]) + (uint32_t)((int32_t)v[2] * v[2]);
}

static int64_t short_dot(const int16_t a[3], const int16_t b[3]) {
  return (int64_t)((int32_t)a[0] * b[0]) + (int32_t)a[1] * b[1] + (int32_t)a[2] * b[2];
}

/*
 * Whether a sphere may lie in the hull of the light and a ball, which is in a capsule and in a cone: the sphere misses it if it is
 * clear of either. a: from the light to the sphere, b: to the ball, floored to 15 bits; own, other: their radii and 4 for the cuts.
 */
static FC_NOINLINE bool short_between(uint32_t aa, int64_t ab, uint32_t bb, uint32_t own, uint32_t other) {
  const uint32_t sum = own + other, square = sum * sum;
  uint64_t across, along;
  uint32_t reach;
  if (sum >> 16 != 0) return true;
  /* the capsule: the distance of the sphere's center from the segment */
  if (ab <= 0) return aa <= square;
  if (ab >= bb) {
    if ((int64_t)aa + bb - 2 * ab > square) return false;
    if (ab >> 32 != 0) return true;
  } else if (aa > square && fc_mul32(aa - square, bb) > fc_mul32((uint32_t)ab, (uint32_t)ab)) {
    return false;
  }
  /* the cone: w cos > r_own + u sin, w and u across and along the axis, sin = r_other / |b|, squared and times b^4 */
  if (bb <= other * other) return true;
  across = fc_mul32(aa, bb);
  along = fc_mul32((uint32_t)ab, (uint32_t)ab);
  reach = (uint32_t)((fc_mul32(own, bb) + fc_mul32(other, (uint32_t)ab)) >> 17) + 1; /* 16 + 32 bits, two of them */
  across = across > along ? (across - along) >> 34 : 0;
  return fc_mul32((uint32_t)across, bb - other * other) <= fc_mul32(reach, reach); /* 30 + 32 bits and 32 + 32 */
}

/* A sphere's center seen from the light, floored; returns the radius, 0 when something has more than 15 bits or too few. */
static FC_COLD int16_t shorten(const fc_form *form, const int64_t light[3], uint8_t unit, int16_t center[3]) {
  const int32_t radius = (int32_t)form->u.sphere.radius >> unit;
  uint8_t i;
  for (i = 0; i < 3; i++) {
    int32_t c = fc_floor_shift32((int32_t)(form->u.sphere.center[i] - light[i]), unit); /* 31 bits */
    center[i] = (int16_t)c;
    if (center[i] != c) return 0;
  }
  return radius > INT16_MAX ? 0 : (int16_t)radius;
}

static bool add_occluder(void *context, const fc_cursor *at, uint16_t index) {
  const occluder_list *list = context;
  const fc_scan *scan = list->scan;
  fc_ball_light *light = list->light;
  fc_form *form = &scan->asked->surface.form;
  fc_window box;
  int16_t center[3], radius = 0;
  uint32_t square = 0;
  uint8_t i;
  uint16_t primitive = (uint16_t)(at->group.first + index);
  if (primitive == scan->primitive) return false;
  fc_kind_of(at)->fetch(&at->group, index, form);
  if (fc_kind_of(at)->hides == fc_sphere_hides) radius = shorten(form, scan->frame->lights, light->unit, center);
  if (radius != 0) {
    square = short_square(center);
    if (!short_between(square, short_dot(center, list->way), list->length, (uint32_t)radius + 4,
                       ((uint32_t)scan->form->u.sphere.radius >> light->unit) + 4))
      return false;
  } else if (!fc_kind_of(at)->between(scan->frame, form, scan->frame->lights, scan->form->u.sphere.center,
                                      scan->form->u.sphere.radius, &box)) {
    return false;
  }
  if (light->occluders == FC_COUNT_OF(light->occluder)) {
    light->occluders = MANY;
    return true;
  }
  light->occluder[light->occluders].primitive = primitive;
  light->occluder[light->occluders].radius = radius;
  if (radius == 0)
    set_window(scan->frame, &box, &light->occluder[light->occluders].at.window);
  else
    for (i = 0; i < 3; i++) light->occluder[light->occluders].at.center[i] = center[i];
  light->occluder[light->occluders].square = radius != 0 ? square : 0;
  light->occluders++;
  return false;
}

static FC_COLD void find_occluders(const fc_scan *scan, fc_ball_light *light) {
  fc_reach reach;
  occluder_list list;
  uint64_t most = 0;
  uint8_t i;
  list.scan = scan;
  list.light = light;
  light->occluders = 0;
  for (i = 0; i < 3; i++) most |= fc_abs64(scan->form->u.sphere.center[i] - scan->frame->lights[i]) + (uint64_t)scan->form->u.sphere.radius;
  most += most >> 10; /* a point's error, mostly */
  i = fc_bits64(most);
  light->unit = i > 15 ? (uint8_t)(i - 15) : 0;
  (void)shorten(scan->form, scan->frame->lights, light->unit, list.way); /* fits */
  list.length = short_square(list.way);
  reach.from = scan->frame->lights;
  reach.to = scan->form->u.sphere.center;
  reach.corners = 1;
  reach.radius = scan->form->u.sphere.radius;
  reach.limited = false;
  (void)fc_space_search(&scan->space, &reach, add_occluder, &list);
}

/* 1 + h^2 - 2 s h in Q30 from s - h = e: Q16 * Q15, at least (1 - h)^2 > 2^-8. */
FC_INLINE uint32_t distance_square(const fc_ball_light *light, uint32_t e) {
  const uint32_t h = (uint32_t)light->h;
  return ((uint32_t)light->sum - (((e >> 8) + (h >> 8)) * (h >> 9) >> 6)) << 6;
}

/* The cosine in Q16 from s - h = e > 0. */
uint32_t fc_ball_cosine(const fc_ball_light *light, uint32_t e) {
  uint32_t g = distance_square(light, e);
  uint8_t up = 15;
  while (g < UINT32_C(1) << 30) {
    g <<= 2;
    up--;
  }
  e = ((e >> 9) * fc_rsqrt_q15(g)) >> up;
  return e > 65536 ? 65536 : e;
}

/* 1 / sqrt(1 + h^2 - 2 s h) in Q16, for h up to 1/4. */
static FC_COLD int32_t inverse_distance(const fc_ball_light *light, uint32_t e) {
  uint32_t g = distance_square(light, e);
  /* at least (3/4)^2 in Q30: one shift makes it 2^30 */
  return (int32_t)(g < UINT32_C(1) << 30 ? 2 * fc_rsqrt_q15(g << 2) : fc_rsqrt_q15(g));
}

/*
 * Where h is small, 1 / sqrt(1 - h^2 - 2 x h) hardly bends over x = s - h in 0 .. X = 1 - h: a parabola through its values at both
 * ends and the middle is off by at most 0.0481 / 6 of the third derivative in x / X, which is 15 h^3 / (1 - h)^4: 2^-10.3 at
 * h = 0.15; the values' own errors, 2^-14, come to less than 2^-13.
 */
static FC_COLD void set_curve(fc_ball_light *light) {
  const uint32_t whole = (UINT32_C(1) << 24) - (uint32_t)light->h;
  int32_t g0, g1, g2, slope, bend, r;
  light->curve[0] = 0;
  if (light->h > 2516582) return; /* 0.15 */
  g0 = inverse_distance(light, 0);
  g1 = inverse_distance(light, whole / 2);
  g2 = inverse_distance(light, whole);
  slope = 4 * g1 - 3 * g0 - g2;
  bend = 2 * (g2 - 2 * g1 + g0);
  /* 1 / X in Q15, up to 2^15.3; slope and bend below 2^15 */
  r = (int32_t)fc_recip_q31(whole >> 8 > 0xffffu ? 0xffffu : whole >> 8);
  slope = slope < 0 ? 0 : slope * r / 32768;
  bend = bend < 0 ? 0 : bend * r / 32768 * r / 32768;
  light->curve[0] = (uint32_t)g0;
  light->curve[1] = (uint32_t)slope;
  light->curve[2] = (uint32_t)bend;
}

/* p: near / z = p / 2^(30 + drop), off by at most `error`. */
static FC_COLD uint8_t set_light(const fc_scan *scan, fc_ball_light *light, int16_t drop, uint32_t error) {
  const int64_t *c = scan->form->u.sphere.center;
  int64_t d[3], step, l[3], at, most, center_light;
  int32_t s0;
  uint64_t square = 0;
  fc_quick near = fc_quick_from(1, 0), inverse, ratio, unit;
  int16_t shift, lowest, highest;
  uint32_t gap;
  uint8_t i;
  fc_scan_direction(scan, d, &step);
  for (i = 0; i < 3; i++) {
    l[i] = scan->frame->lights[i] - c[i]; /* below 2^31 */
    square += (uint64_t)(l[i] * l[i]);    /* below 3 * 2^62 */
  }
  if (square == 0) return LIGHT_SLOW;
  inverse = fc_quick_rsqrt(fc_quick_from(square, 0)); /* 1 / l */
  ratio = fc_quick_mul(inverse, fc_quick_from((uint64_t)scan->form->u.sphere.radius, 0));
  if (!fc_quick_less(ratio, near)) return LIGHT_SLOW;
  light->h = fc_quick_to_int(ratio, 24);
  /* 1 + h^2 - 2 s h is cut to 2^-13.4; from (1 - h)^2 = 2^-4 on that costs the cosine 2^-10 of itself */
  if (light->h > (INT32_C(3) << 22)) return LIGHT_SLOW;
  light->sum = (INT32_C(1) << 24) + (int32_t)(fc_smul32(light->h, light->h) >> 24);
  inverse = fc_quick_mul(inverse, fc_quick_recip(fc_quick_from((uint64_t)scan->form->u.sphere.radius, 0))); /* 1 / (r l) */
  center_light = fc_small_dot(c, l);                                                                        /* 30 + 31 bits and two: below 2^63 */
  unit = fc_quick_mul(inverse, fc_quick_from(fc_abs64(center_light), 0));
  if (!fc_quick_less(unit, fc_quick_from(64, 0))) return LIGHT_SLOW;
  s0 = fc_quick_times(inverse, center_light, 24);
  light->away = s0 + light->h;
  light->fine_margin = (int32_t)((fc_abs32(s0) + (UINT32_C(1) << 24)) >> 19) + 64;
  light->margin = (int32_t)((fc_abs32(s0) + (UINT32_C(1) << 24)) >> 13) + 64;
  /* The cosine grows by (1 - s h) / (1 + h^2 - 2 s h)^(3/2) <= 1 / (1 - h)^2 times an error of s, which may cost 2^-9, half a
   * level in 255: if 16 bits of p do not do, all are refined. */
  gap = (uint32_t)((INT32_C(1) << 24) - light->h) >> 9;
  if (light->fine_margin >= (int32_t)(gap * gap >> 15)) return LIGHT_SLOW;
  if (light->margin >= (int32_t)(gap * gap >> 15)) light->margin = INT32_MAX;
  /* D below 2^30, l below 2^31: sums of three below 2^63 */
  at = fc_small_dot(d, l);
  most = (int64_t)fc_abs64(at) / 2 + (int64_t)fc_abs64(l[0] * step) / 2 * scan->columns +
         (int64_t)fc_abs64(l[1] * step) / 2 * scan->rows + 1;
  unit = fc_quick_mul(inverse, fc_quick_from(scan->frame->depth_near, 0));
  unit = fc_quick_mul(unit, fc_quick_recip(fc_quick_from((uint64_t)scan->frame->view.focal, 0)));
  light->depth = fc_quick_mul(fc_quick_from(scan->frame->depth_near, (int16_t)(30 + drop)),
                              fc_quick_recip(fc_quick_from((uint64_t)scan->frame->view.focal, 0)));
  /* the greatest along the tile to 30 bits */
  ratio = fc_quick_mul(unit, fc_quick_from((uint64_t)most, 1));
  shift = (int16_t)(29 - (ratio.e + 32));
  light->at = fc_quick_times(unit, at, shift);
  light->dx = fc_quick_times(unit, l[0] * step, shift);
  light->dy = fc_quick_times(unit, -l[1] * step, shift);
  shift = (int16_t)(shift - 54 - drop);
  /* p's error may cost 2^-20 of s + s0, and octave + shift is a shift of -8 .. 31; a floor before the former is 2^-16, below
   * the margins where s0 is that large */
  lowest = (int16_t)(20 + fc_bits64(error));
  highest = 31;
  if (lowest < -shift - 8) lowest = (int16_t)(-shift - 8);
  if (highest > 31 - shift) highest = (int16_t)(31 - shift);
  if (lowest > highest) return LIGHT_SLOW;
  light->octave = (uint8_t)lowest;
  light->octaves = (uint8_t)(highest - lowest);
  light->shift = shift;
  set_curve(light);
  return LIGHT_FORMS;
}

/* The point that a pixel with this p shows: t D with t = near 2^(30 + drop) / (p F); returns a bound of its error an axis. */
static FC_COLD uint32_t point_at(const fc_scan *scan, const fc_ball_light *light, uint16_t row, uint16_t column, uint32_t p,
                                 int32_t point[3]) {
  const fc_quick t = fc_quick_mul(fc_quick_recip(fc_quick_from(p, 0)), light->depth);
  const int16_t up = (int16_t)(t.e + 32);
  int64_t d[3];
  uint32_t most = 0;
  uint8_t i;
  fc_view_direction(scan->frame, (uint16_t)(scan->x + column), (uint16_t)(scan->y + row), d);
  for (i = 0; i < 3; i++) {
    int32_t v = fc_smulhi32((int32_t)d[i], t.m);
    point[i] = up > 0 ? v * (INT32_C(1) << up) : fc_floor_shift32(v, (uint8_t)(up < -31 ? 31 : -up));
    most |= fc_abs32(point[i]);
  }
  /* p is good to 2^-20 (set_light), the rest to 2^-24, and the floors */
  return (most >> 19) + 2 + (up > 0 ? UINT32_C(1) << up : 0);
}

/*
 * Whether a sphere keeps the light from a point: 1, 0, or -1. a: from the light to the centre, b: to the point, in units that
 * make both and the radius 15 bits. Floored, a is off by less than sqrt(3), b by that and the point's error (floored, an
 * axis), the radius by 1: distances compare for certain beyond `slack`. With both ends clearly outside, the segment is blocked
 * iff its inner points come within the radius.
 */
static FC_NOINLINE int8_t short_hides(uint32_t aa, int64_t ab, uint32_t bb, int16_t radius, uint32_t error) {
  int32_t out, in;
  uint64_t across, square;
  int64_t apart = (int64_t)aa + bb - 2 * ab; /* |a - b|^2 */
  if (error > 2044) return -1;
  out = 2 * (int32_t)error + 8; /* sqrt(3) (1 + error + 1 + 1) + 1 < 2 error + 6.2 */
  in = radius - out;
  out += radius;
  if (aa <= (uint32_t)(out * out) || apart <= out * out) return -1;
  if (ab <= 0 || ab >= bb) return 0;                                /* the nearest point is an end */
  across = fc_mul32(aa, bb) - fc_mul32((uint32_t)ab, (uint32_t)ab); /* squared distance from the line, times bb; ab < bb */
  square = fc_mul32((uint32_t)(out * out), bb);                     /* 31 + 32 bits */
  if (across > square) return 0;
  square = in > 0 ? fc_mul32((uint32_t)(in * in), bb) : 0;
  return across < square ? 1 : -1;
}

/* A pixel whose occluders are searched for, as no list holds them. */
typedef struct pixel_question {
  const fc_scan *scan;
  uint16_t row, column;
  int32_t point[3];
  uint32_t error;
} pixel_question;

static bool hides_pixel(void *context, const fc_cursor *at, uint16_t index) {
  const pixel_question *q = context;
  const fc_kind *kind = fc_kind_of(at);
  fc_form *form = &q->scan->asked->surface.form;
  int8_t hides = -1;
  if ((uint16_t)(at->group.first + index) == q->scan->primitive) return false;
  kind->fetch(&at->group, index, form);
  if (kind->hides != NULL) hides = kind->hides(form, q->scan->frame->lights, q->point, q->error);
  return hides > 0 || (hides < 0 && fc_scan_blocked(q->scan, q->row, q->column, kind, form));
}

static FC_COLD bool occluded_by_any(const fc_scan *scan, const fc_ball_light *light, uint16_t row, uint16_t column, uint32_t p) {
  pixel_question question;
  fc_reach reach;
  int64_t to[3];
  uint8_t i;
  question.scan = scan;
  question.row = row;
  question.column = column;
  question.error = point_at(scan, light, row, column, p, question.point);
  for (i = 0; i < 3; i++) to[i] = question.point[i];
  reach.from = scan->frame->lights;
  reach.to = to;
  reach.corners = 1;
  reach.radius = question.error;
  reach.limited = false;
  return fc_space_search(&scan->space, &reach, hides_pixel, &question);
}

/*
 * The way from the light to what a pixel with this p shows, in short units, and a bound of its error an axis, as point_at in 16 bits; false
 * where they do not hold it.
 *
 * p, its reciprocal and the factor are within 2^-15 of themselves each, and t is cut to 2^-14: less than 2^-12 of the point's largest component
 * in all. Cutting D by 2^14 moves it by up to 2^14 t more; and there are two floors.
 */
static FC_COLD bool short_way(const fc_scan *scan, const fc_ball_light *light, uint16_t row, uint16_t column, uint32_t p, int16_t way[3],
                              uint32_t *error) {
  const fc_frame *frame = scan->frame;
  const uint8_t octave = (uint8_t)(31 - fc_clz32(p));
  const int32_t down = octave + light->unit - light->depth.e - 30, one = INT32_C(1) << frame->view.pixel_shift;
  int32_t d[3], t;
  uint32_t most = 0;
  uint8_t i;
  if (octave < 15 || down < 0 || down > 31) return false;
  /* 17 + 16 bits, the former at most 2^16: below 2^32 */
  t = (int32_t)((fc_recip_q31(p >> (octave - 15)) * (light->depth.m >> 16)) >> 16);
  d[0] = (2 * (scan->x + (int32_t)column) + 1 - frame->width) * one;
  d[1] = (frame->height - 2 * (scan->y + (int32_t)row) - 1) * one;
  d[2] = frame->view.focal;
  for (i = 0; i < 3; i++) {
    /* 15 + 16 bits */
    const int32_t v = fc_floor_shift32(fc_floor_shift32(d[i], 14) * t, (uint8_t)down);
    const int32_t w = v - fc_floor_shift32((int32_t)frame->lights[i], light->unit);
    way[i] = (int16_t)w;
    if (way[i] != w) return false;
    most |= fc_abs32(v);
  }
  *error = (most >> 12) + ((uint32_t)t >> down) + 4;
  return true;
}

/* The same from point_at's point. */
static FC_COLD bool fine_way(const fc_scan *scan, const fc_ball_light *light, const int32_t point[3], int16_t way[3]) {
  uint8_t i;
  for (i = 0; i < 3; i++) {
    const int32_t v = fc_floor_shift32(point[i] - (int32_t)scan->frame->lights[i], light->unit);
    way[i] = (int16_t)v;
    if (way[i] != v) return false;
  }
  return true;
}

/* Whether an occluder that has no short answer keeps the light away from the pixel with this p. */
static FC_COLD bool occluded_by(const fc_scan *scan, const fc_ball_light *light, uint8_t i, uint16_t row, uint16_t column, uint32_t p) {
  fc_cursor *cursor = &scan->asked->surface.at;
  fc_form *form = &scan->asked->surface.form;
  const fc_kind *kind;
  int32_t point[3];
  int16_t way[3];
  const uint32_t error = point_at(scan, light, row, column, p, point);
  int8_t hides = -1;
  uint16_t index;
  if (light->occluder[i].radius != 0 && fine_way(scan, light, point, way)) {
    hides = short_hides(light->occluder[i].square, short_dot(light->occluder[i].at.center, way), short_square(way),
                        light->occluder[i].radius, error >> light->unit);
    if (hides >= 0) return hides > 0;
  }
  if (!fc_cursor_find(cursor, &scan->space, light->occluder[i].primitive, &index)) return false;
  kind = fc_kind_of(cursor);
  kind->fetch(&cursor->group, index, form);
  if (kind->hides != NULL) hides = kind->hides(form, scan->frame->lights, point, error);
  return hides > 0 || (hides < 0 && fc_scan_blocked(scan, row, column, kind, form));
}

/* Whether an occluder in the list keeps the light away from the pixel with this p. */
static FC_COLD bool occluded(const fc_scan *scan, const fc_ball_light *light, uint16_t row, uint16_t column, uint32_t p) {
  int16_t way[3];
  uint32_t error = 0, length = 0;
  bool fits;
  uint8_t i;
  if (light->occluders == MANY) return occluded_by_any(scan, light, row, column, p);
  fits = short_way(scan, light, row, column, p, way, &error);
  if (fits) length = short_square(way);
  for (i = 0; i < light->occluders; i++) {
    if (light->occluder[i].radius == 0) {
      const fc_placed_window *window = &light->occluder[i].at.window;
      if (scan->x + column < window->x0 || scan->x + column > window->x1 || scan->y + row < window->y0 ||
          scan->y + row > window->y1)
        continue;
    } else if (fits) {
      const int8_t hides = short_hides(light->occluder[i].square, short_dot(light->occluder[i].at.center, way), length,
                                       light->occluder[i].radius, error);
      if (hides == 0) continue;
      if (hides > 0) return true;
    }
    if (occluded_by(scan, light, i, row, column, p)) return true;
  }
  return false;
}

/* v / 2^down, floored, for down from -8: what is scaled up is below 2^30 after it. */
static inline int32_t scaled_back(int32_t v, int16_t down) {
  return down >= 0 ? fc_floor_shift32(v, (uint8_t)down) : v * (INT32_C(1) << -down);
}

/* s - h of pixels whose p is in one octave, for face_octave. */
typedef struct facing {
  uint32_t low, margin;
  int32_t dx, away;
  uint8_t cut, down;
} facing;

/* v r / 2^16 for v within 2^30 and r up to 2^16. */
FC_INLINE int32_t times_reciprocal(int32_t v, uint32_t r) {
  return fc_floor_shift32(v, 16) * (int32_t)r + (int32_t)((((uint32_t)v & 0xffffu) * r) >> 16);
}

/* s - h of a pixel, refined. */
FC_COLD int32_t fc_ball_refined(const fc_ball_light *light, int32_t along, uint32_t p, uint8_t octave) {
  uint32_t r = fc_recip_q31(p >> (octave - 15));
  int32_t s = times_reciprocal(along, r);
  /* times 1 + rest with rest = 1 - x r, below 2^-13 */
  int32_t rest = (INT32_C(1) << 30) - (int32_t)fc_mulhi32(p << (31 - octave), r << 15);
  s += fc_floor_shift32(fc_floor_shift32(s, 17) * rest, 13);
  return scaled_back(s, (int16_t)(octave + light->shift)) - light->away;
}

/* Turns p of the pixels from here on into s - h in Q24, until one leaves the octave, or `end`: marks those within the margin,
 * which keep their p, and those that turn away. */
static FC_NOINLINE uint32_t *face_octave(const facing *of, int32_t along, uint32_t *p, const uint32_t *end, uint32_t bit,
                                         uint32_t *close, uint32_t *dark) {
  const uint32_t low = of->low, margin = of->margin;
  const int32_t dx = of->dx, away = of->away;
  const uint8_t cut = of->cut, down = of->down;
  uint32_t near = 0, averted = 0;
  do {
    uint32_t v = *p;
    int32_t e;
    if (v - low >= low) break;
    e = fc_floor_shift32(times_reciprocal(along, fc_recip_q31(v >> cut)), down) - away;
    if ((uint32_t)e + margin <= 2 * margin) {
      near |= bit;
    } else {
      if (e < 0) averted |= bit;
      *p = (uint32_t)e;
    }
    bit <<= 1;
    along = fc_to_i32((uint32_t)along + (uint32_t)dx); /* one step more than there are pixels */
  } while (++p != end);
  *close |= near;
  *dark |= averted;
  return p;
}

/* Turns p of the pixels in `bits` into s - h in Q24 (of others, too); returns those that are within the margin, or out of
 * reach, and in *averted those that do not face the light. */
static FC_NOINLINE uint32_t facing_row(const fc_ball_light *light, int32_t along, uint32_t bits, uint32_t *first, uint32_t *averted) {
  uint32_t open = 0, dark = 0, close = 0, left = bits, *p = first;
  const uint32_t *end = first + (32 - fc_clz32(bits));
  facing of;
  of.dx = light->dx;
  of.away = light->away;
  of.margin = (uint32_t)light->margin;
  for (;;) {
    uint32_t bit;
    uint8_t octave;
    int16_t down;
    for (; !(left & 1); left >>= 1) p++;
    bit = UINT32_C(1) << (p - first);
    octave = (uint8_t)(31 - fc_clz32(*p)); /* what is shown has a p */
    down = (int16_t)(octave + light->shift);
    if ((uint8_t)(octave - light->octave) > light->octaves) {
      open |= bit;
      p++;
    } else if (down < 0) {
      close |= bit;
      p++;
    } else {
      of.low = UINT32_C(1) << octave;
      of.cut = (uint8_t)(octave - 15);
      of.down = (uint8_t)down;
      p = face_octave(&of, along + of.dx * (int32_t)(p - first), p, end, bit, &close, &dark);
    }
    if (p == end) break;
    left = bits >> (p - first);
  }
  for (p = first, left = close & bits; left != 0; left >>= 1, p++) {
    int32_t e, fine = light->fine_margin;
    uint32_t bit = UINT32_C(1) << (p - first);
    if (!(left & 1)) continue;
    e = fc_ball_refined(light, along + of.dx * (int32_t)(p - first), *p, (uint8_t)(31 - fc_clz32(*p)));
    if (e >= -fine && e <= fine) open |= bit;
    if (e < 0) dark |= bit;
    *p = (uint32_t)e;
  }
  *averted = dark & bits & ~open;
  return open;
}

/* Colours the pixels of a row in `bits` from s - h > 0 of each, where the light's curve holds. */
static FC_NOINLINE void shade_curve(const fc_ball_light *light, const fc_tint *tint, uint32_t bits, const uint32_t *p, uint8_t *to) {
  const uint32_t c0 = light->curve[0], c1 = light->curve[1], c2 = light->curve[2];
  const uint32_t red = tint->base[0], green = tint->base[1], blue = tint->base[2];
  const uint32_t red_slope = tint->slope[0], green_slope = tint->slope[1], blue_slope = tint->slope[2];
  for (; bits != 0; bits >>= 1, to += 2, p++) {
    uint32_t x = *p >> 9, packed; /* Q15, at most 1 and little more */
    if (!(bits & 1)) continue;
    /* below 2^15 + 2^15 and 2^15, Q16; 2^16.3; 2^31.3 */
    x = (x * (c0 + (x * (c1 + (x * c2 >> 15)) >> 15))) >> 15;
    if (x > 65536) x = 65536;
    packed = (red + red_slope * x) >> FC_TINT_BITS << 6;
    packed = (packed | (green + green_slope * x) >> FC_TINT_BITS) << 5;
    packed |= (blue + blue_slope * x) >> FC_TINT_BITS;
    to[0] = (uint8_t)(packed >> 8);
    to[1] = (uint8_t)packed;
  }
}

/* The same for any light and format. */
static FC_NOINLINE void shade_any(const fc_ball_light *light, const fc_tint *tint, uint32_t bits, const uint32_t *p, uint8_t *to,
                                  uint8_t pixel_bytes) {
  const uint32_t whole = (UINT32_C(1) << 24) - (uint32_t)light->h;
  for (; bits != 0; bits >>= 1, to += pixel_bytes, p++)
    if (bits & 1)
      fc_tint_put(tint, fc_ball_cosine(light, *p > whole ? whole : *p), to);
}

/* Lights the pixels of a row in `bits`, given p of each and in `e` a copy that becomes s - h; returns those lit, but for what a ray has coloured. */
static uint32_t light_row(const fc_scan *scan, fc_ball_light *light, uint16_t row, uint16_t column, uint32_t bits,
                          const uint32_t *p, uint32_t *e) {
  uint32_t open, dark, bit = 1, rest;
  uint8_t i;
  open = facing_row(light, light->at + light->dx * column + light->dy * row, bits, e, &dark);
  if (light->occluders == UNSOUGHT && (bits & ~dark) != 0) find_occluders(scan, light);
  rest = light->occluders == 0 ? open : bits & ~dark;
  for (i = 0; rest != 0; rest >>= 1, bit <<= 1, i++) {
    uint16_t x = (uint16_t)(column + i);
    if (!(rest & 1)) continue;
    if (open & bit) {
      fc_scan_shade_slowly(scan, row, x, 1);
    } else if (occluded(scan, light, row, x, p[i])) {
      dark |= bit;
    }
  }
  if (dark != 0) fc_scan_unlit(scan, row, column, dark);
  bits &= ~(dark | open);
  fc_scan_lit(scan, row, column, bits);
  if (scan->tint.plain && light->curve[0] != 0)
    shade_curve(light, &scan->tint, bits, e, fc_scan_pixel(scan, row, column));
  else
    shade_any(light, &scan->tint, bits, e, fc_scan_pixel(scan, row, column), scan->pixel_bytes);
  return bits;
}

/* The same among occluders, who are asked about the points. */
static FC_COLD void light_row_among(const fc_scan *scan, fc_ball_light *light, uint16_t row, uint16_t column,
                                    uint32_t bits, const uint32_t *p, uint32_t e[32]) {
  uint32_t rest;
  uint8_t i;
  for (i = 0, rest = bits; rest != 0; i++, rest >>= 1) e[i] = p[i];
  (void)light_row(scan, light, row, column, bits, p, e);
}

/* ---- drawing ---- */

/* What a row of the sphere needs. */
typedef struct sphere_forms {
  fc_cone cone;
  int64_t b, b_dx; /* C.W in units of sqrt(f) with 32 more bits; in a word it may drift by half a unit a pixel */
  uint32_t b_step;
  uint64_t last, last_dy; /* f at the row's last column, and to the next row's */
  uint64_t sweep;         /* dxx times the steps to there */
  uint64_t bend;          /* 120 dxx */
  uint32_t ddm;           /* for root_run */
  uint32_t half;
  uint8_t fine;
  int32_t outside; /* high word of f below this: outside */
  int32_t inside;  /* above this: inside, and sqrt(f) is good */
  uint32_t error;  /* of p */
  int16_t drop;
  uint8_t lift, half_lift;
  bool clip;
} sphere_forms;

/* Takes pixels beyond the far limit out of a run; returns those that it may cut. */
static FC_COLD uint32_t clip_run(const fc_scan *scan, const sphere_forms *ball, uint16_t row, uint16_t column, const uint32_t *ps,
                                 uint32_t *p, const uint32_t *end) {
  uint32_t open = 0;
  for (; p != end; p++) {
    int8_t within = 0;
    if (ball->drop >= 0 && ball->drop < 32)
      within = fc_scan_far(scan, row, (uint16_t)(column + (uint16_t)(p - ps)), *p >> ball->drop, ball->error + 1);
    if (within == 0) open |= UINT32_C(1) << (p - ps);
    if (within <= 0) *p = 0;
  }
  return open;
}

/* Pixels that the forms leave to the ray engine. */
static FC_COLD void draw_open(const fc_scan *scan, uint16_t row, uint16_t first, uint16_t end) {
  for (; first < end; first++)
    if (fc_scan_exact(scan, row, first) && fc_scan_wants_light(scan, row, first, 1)) fc_scan_shade_slowly(scan, row, first, 1);
}

/* A row's pixels: surely inside from `from` to `to`, left to the ray engine from `first` to `end` around them. */
typedef struct sphere_row {
  uint64_t f, dx, b; /* at `from`, and then where root_run stands; wrap past the tile */
  uint16_t first, from, to, end;
} sphere_row;

/*
 * The pixels among `bits` of a word that show the sphere, where 32 bits could not tell: by all bits of the row's forms, and where
 * these leave it open by the ray engine. *rough: those of them that have no p.
 */
static FC_COLD uint32_t settle(const fc_scan *scan, const sphere_forms *ball, fc_coder *coder, uint16_t row, uint16_t column,
                               uint32_t bits, uint32_t *ps, uint32_t *rough) {
  uint32_t shown = 0, bit = 1;
  uint8_t n;
  for (n = 0; bits != 0; n++, bits >>= 1, bit <<= 1) {
    uint64_t f;
    uint32_t x;
    uint16_t *depth = fc_scan_depth(scan, row, (uint16_t)(column + n));
    int32_t code = -1;
    bool good = false;
    if (!(bits & 1)) continue;
    x = (uint32_t)column + n;
    f = (uint64_t)ball->cone.f + fc_times((uint64_t)ball->cone.dx, x);
    if (x > 1) f += fc_times((uint64_t)ball->cone.dxx, x * (x - 1) / 2);
    if (fc_to_i64(f) > ball->cone.error && !ball->clip) {
      /* sqrt(f) is off by e / (2 sqrt(f)) at most; floors of the root and of b, and the factors' cuts, 4 (set_ball) */
      uint32_t root = fc_sqrt64(f << ball->lift), p, error;
      uint64_t loss = ((uint64_t)ball->cone.error << (ball->lift - ball->half_lift)) >> (31 - fc_clz32(root)); /* 34 + 30 bits */
      p = (uint32_t)(((uint64_t)ball->b + fc_times((uint64_t)ball->b_dx, x)) >> 32) + (root >> ball->half_lift);
      if (loss < UINT32_C(1) << 24 && p != 0) {
        error = (uint32_t)loss + 8;
        fc_coder_follow(coder, scan->frame, p);
        code = fc_coder_code(coder, p, error);
        good = error <= ball->error;
        ps[n] = p;
      }
    }
    if (code >= 0 && code != *depth) {
      if (code < *depth) continue;
      *depth = (uint16_t)code;
    } else if (!fc_scan_exact(scan, row, (uint16_t)(column + n))) {
      continue;
    }
    shown |= bit;
    if (!good) *rough |= bit;
  }
  return shown;
}

/* Passes over pixels until one is surely inside, f and dx going along; returns those passed, and in *first those before one
 * that may show the sphere. */
static FC_NOINLINE uint16_t outside_run(const sphere_forms *ball, uint64_t *f_at, uint64_t *dx_at, uint16_t count,
                                        uint16_t *first) {
  uint64_t f = *f_at, dx = *dx_at;
  const uint64_t dxx = (uint64_t)ball->cone.dxx;
  const int32_t outside = ball->outside;
  uint16_t left = count, open = 0;
  for (; left != 0; left--) {
    int32_t high = fc_to_i32((uint32_t)(f >> 32));
    if (high >= outside) {
      if (high > ball->inside) break;
      if (open == 0) open = left;
    }
    f += dx;
    dx += dxx;
  }
  *f_at = f;
  *dx_at = dx;
  *first = (uint16_t)(count - (open != 0 ? open : left));
  return (uint16_t)(count - left);
}

/* f is concave along a row: r^2 < C.C - C_x^2, as the sphere lies in front of the eye, and floors leave dxx <= 0. So the pixels
 * inside are neighbours, with those left open around them. */
static FC_NOINLINE void set_row(const fc_scan *scan, const sphere_forms *ball, sphere_row *at) {
  uint64_t f = (uint64_t)ball->cone.f, dx = (uint64_t)ball->cone.dx;
  const uint64_t dxx = (uint64_t)ball->cone.dxx;
  const uint16_t columns = scan->columns;
  uint16_t first;
  at->f = f;
  at->dx = dx;
  at->from = outside_run(ball, &at->f, &at->dx, columns, &at->first);
  at->b = (uint64_t)ball->b + fc_times((uint64_t)ball->b_dx, at->from);
  at->to = at->from;
  at->end = at->first;
  if (at->first == columns) return;
  /* back from the last column: the difference to the one before */
  f = ball->last;
  dx = dxx - (dx + ball->sweep);
  at->to = (uint16_t)(columns - outside_run(ball, &f, &dx, columns, &first));
  at->end = (uint16_t)(columns - first);
  if (at->from == columns) at->from = at->to = at->end; /* none is inside */
}

/* Pixels between two steps of the forms in 64 bits. */
#define ROOTS 16

/*
 * p of the next pixels, which are inside. Between steps f is followed in 31 bits, its difference with `fine` bits more: f is off
 * by its own cut, 15 halves from those of the difference, and 2^-fine times 15 + 105 / 2 from the rounding of both differences.
 */
static FC_NOINLINE void root_run(const sphere_forms *ball, sphere_row *at, uint32_t *to, uint8_t count) {
  const uint8_t down = (uint8_t)(33 - ball->lift), fine = ball->fine;
  const uint32_t ddm = ball->ddm, b_dx = ball->b_step;
  while (count != 0) {
    uint32_t m = (uint32_t)(at->f >> down), b = (uint32_t)((at->b + (UINT32_C(1) << 31)) >> 32), *end = to + ROOTS;
    int32_t dm = fc_to_i32((uint32_t)(uint64_t)fc_floor_shift64(fc_to_i64(at->dx), (uint8_t)(down - fine)) + ball->half);
    if (count < ROOTS) end = to + count;
    count = (uint8_t)(count - (end - to));
    do {
      uint32_t x = m << 1;
      uint8_t k = ball->half_lift;
      while (x < UINT32_C(1) << 30) {
        x <<= 2;
        k++;
      }
      *to++ = (fc_sqrt_q32(x) >> k) + b;
      m += (uint32_t)fc_floor_shift32(dm, fine);
      dm = fc_to_i32((uint32_t)dm + ddm);
      b += b_dx;
    } while (to != end);
    /* 16 on: f + 16 dx + 120 dxx */
    at->f += (at->dx << 4) + ball->bend;
    at->dx += (uint64_t)ball->cone.dxx << 4;
    at->b += (uint64_t)ball->b_dx << 4;
  }
}

/* Depth codes of an octave, for test_octave. */
typedef struct octave {
  uint32_t low, span, add, base, low_bits, open; /* p in low .. low + span - 1 */
  uint8_t shift;
} octave;

/* Depth tests from `p` on until one leaves the octave, or `end`: adds those shown, and in *open those that it can't tell. */
static FC_NOINLINE const uint32_t *test_octave(const octave *of, const uint32_t *p, const uint32_t *end, uint16_t *depth,
                                               uint32_t bit, uint32_t *shown, uint32_t *open) {
  const uint32_t low = of->low, span = of->span, add = of->add, base = of->base, low_bits = of->low_bits, may = of->open;
  const uint8_t shift = of->shift;
  uint32_t bits = 0, undecided = 0;
  do {
    uint32_t v = *p, code, there;
    if (v - low >= span) break;
    v += add;
    there = *depth;
    code = (v >> shift) + base;
    if ((v & low_bits) <= may || code == there) {
      undecided |= bit;
    } else if (code > there) {
      *depth = (uint16_t)code;
      bits |= bit;
    }
    depth++;
    bit <<= 1;
  } while (++p != end);
  *shown |= bits;
  *open |= undecided;
  return p;
}

/* Depth tests of up to 32 pixels, given p of each; 0 leaves a pixel out. Returns those shown. */
static FC_NOINLINE uint32_t test_run(const fc_scan *scan, uint16_t row, uint16_t column, const uint32_t *first, const uint32_t *end,
                                     uint32_t error, fc_coder *coder, uint32_t *undecided) {
  uint16_t *depth = fc_scan_depth(scan, row, column);
  const uint32_t *p = first;
  uint32_t shown = 0, open = 0;
  while (p != end) {
    const uint32_t bit = UINT32_C(1) << (p - first);
    const uint32_t *from = p;
    octave of;
    if (*p == 0) {
      p++;
      continue;
    }
    fc_coder_follow(coder, scan->frame, *p);
    of.low = coder->low;
    of.add = coder->half + error;
    of.base = (uint32_t)coder->base;
    of.low_bits = coder->low_bits;
    of.open = fc_coder_open(coder, error);
    of.shift = coder->shift;
    /* codes of 1 and below, and beyond 16 bits, are out of the format's range: the ray engine's */
    of.span = coder->base + (int32_t)(of.low >> of.shift) < 2 ? 0 : of.low;
    if (coder->base > UINT16_MAX) {
      of.span = 0;
    } else if (coder->base + (int32_t)((2 * of.low - 1 + of.add) >> of.shift) > UINT16_MAX) {
      uint32_t end_of_codes = (uint32_t)(UINT16_MAX + 1 - coder->base) << of.shift; /* within the octave: below 2^32 */
      of.span = end_of_codes > of.low + of.add ? end_of_codes - of.low - of.add : 0;
    }
    p = test_octave(&of, p, end, depth + (p - first), bit, &shown, &open);
    if (p == from) {
      open |= bit;
      p++;
    }
  }
  *undecided = open;
  return shown;
}

/* 2 floor(a b / 2^32) */
static FC_COLD int64_t scaled(int64_t a, int32_t b) { return 2 * fc_smul64hi(a, b); }

/* Multiplies b and sqrt(f) by factor / 2^32, so that their sum is p. */
static FC_COLD void fold(sphere_forms *ball, uint32_t factor, int64_t *b_dy, int64_t steps) {
  const int32_t once = (int32_t)(factor >> 1), twice = (int32_t)(fc_mulhi32(factor, factor) >> 1);
  ball->b = scaled(ball->b, once);
  ball->b_dx = scaled(ball->b_dx, once);
  *b_dy = scaled(*b_dy, once);
  ball->cone.f = scaled(ball->cone.f, twice);
  ball->cone.dx = scaled(ball->cone.dx, twice);
  ball->cone.dxx = scaled(ball->cone.dxx, twice);
  ball->cone.dy = scaled(ball->cone.dy, twice);
  ball->cone.dyy = scaled(ball->cone.dyy, twice);
  ball->cone.dxy = scaled(ball->cone.dxy, twice);
  /* floors of 2 in each, as in fc_cone_setup */
  ball->cone.error += 4 * steps * steps;
}

static FC_COLD void set_ball(const fc_scan *scan, const fc_placed_sphere *placed, sphere_forms *ball, int64_t *b_dy) {
  const int64_t *c = scan->form->u.sphere.center;
  int64_t d[3], step, unit;
  fc_sheaf sheaf;
  int16_t half;
  uint8_t i, gain;
  fc_scan_direction(scan, d, &step);
  for (i = 0; i < 3; i++) {
    /* twice the direction: 30 bits */
    sheaf.at[i] = (int32_t)(2 * d[i]);
    sheaf.dx[i] = sheaf.dy[i] = 0;
  }
  sheaf.dx[0] = (int32_t)(2 * step);
  sheaf.dy[1] = (int32_t)(-2 * step);
  sheaf.error = 0;
  fc_cone_setup(&ball->cone, c, scan->form->u.sphere.radius, 0, &sheaf, scan->columns, scan->rows);
  /* f = disc 2^(scale - 64) with W = 2 D, so in units of sqrt(f) b is C.W 2^(scale / 2 - 32). |C| below 2^30, |W| below
   * 2^30.8; the matrix holds an entry of at least |C|^2 / 3, so |C| 2^(scale / 2) is below 2^31.8: C.W 2^(scale / 2) is
   * below 2^62.6, and its sum with sqrt(f) is below 2^31.6. */
  half = (int16_t)(ball->cone.scale / 2);
  unit = INT64_C(2) << half;
  ball->b = fc_small_dot(c, d) * unit;
  ball->b_dx = c[0] * step * unit;
  *b_dy = -c[1] * step * unit;
  /* One column or row has no step. */
  if (scan->columns == 1) ball->b_dx = 0;
  if (scan->rows == 1) *b_dy = 0;
  fold(ball, placed->factor, b_dy, (int64_t)scan->columns + scan->rows + 1);
  /* The greatest f, r^2 |W|^2 2^(scale - 64) factor^2 2^-64, is lifted to 64 bits. */
  {
    fc_quick most, factor = fc_quick_from(placed->factor, -32);
    int64_t x = d[0] + step * scan->columns, y = d[1] - step * scan->rows;
    int32_t bits;
    if (fc_abs64(x) < fc_abs64(d[0])) x = d[0];
    if (fc_abs64(y) < fc_abs64(d[1])) y = d[1];
    most = fc_quick_from((uint64_t)(x * x + y * y + d[2] * d[2]), (int16_t)(ball->cone.scale - 62)); /* below 2^63 */
    factor = fc_quick_mul(factor, fc_quick_from((uint64_t)scan->form->u.sphere.radius, 0));
    most = fc_quick_mul(most, fc_quick_mul(factor, factor));
    /* less than 2^-26 is cut in all */
    bits = most.e + 32 + (most.m > UINT32_MAX - 256);
    ball->lift = bits < 64 ? (uint8_t)((64 - (bits < 2 ? 2 : bits)) & ~1) : 0;
    if (ball->lift > 30) ball->lift = 30;
    if (ball->lift < 2) ball->lift = 2;
    ball->half_lift = ball->lift / 2;
  }
  /* Where f > 0 sqrt(f) is at most b, and |b| is greatest at a corner: both times 2^gain so that their sum has up to 31
   * bits. A step is the difference of two pixels: below 2^63 after it. */
  {
    int64_t right = ball->b_dx * (scan->columns - 1), down = *b_dy * (scan->rows - 1);
    uint64_t low = fc_abs64(ball->b + (right < 0 ? right : 0) + (down < 0 ? down : 0));
    uint64_t high = fc_abs64(ball->b + (right > 0 ? right : 0) + (down > 0 ? down : 0));
    gain = (uint8_t)(fc_clz64((low > high ? low : high) | 1) - 2);
    if (gain > ball->half_lift) gain = ball->half_lift;
    ball->b *= INT64_C(1) << gain;
    ball->b_dx *= INT64_C(1) << gain;
    *b_dy *= INT64_C(1) << gain;
    ball->half_lift = (uint8_t)(ball->half_lift - gain);
    /* near / z = (b + sqrt f) 2^(31 - gain - scale / 2) factor 2^exponent */
    ball->drop = (int16_t) - (placed->exponent + 93 - half - gain);
  }
  ball->b_step = (uint32_t)(((uint64_t)ball->b_dx + (UINT32_C(1) << 31)) >> 32);
  ball->outside = fc_high_word(-ball->cone.error);
  /* The differences of f in 2^-fine of root_run's 31 bits: below 2^31 in the whole tile and one pixel on. */
  {
    int64_t low = ball->cone.dx, high, turn = ball->cone.dxy * scan->rows, bend = ball->cone.dxx * (scan->columns + 1);
    uint8_t bits, down = (uint8_t)(33 - ball->lift);
    high = low + (turn > 0 ? turn : 0);
    low += (turn < 0 ? turn : 0) + bend;
    bits = fc_bits64(fc_abs64(low) | fc_abs64(high));
    ball->fine = bits + 1 >= 31 + down ? 0 : (uint8_t)(30 + down - bits);
    if (ball->fine > 6) ball->fine = 6;
    if (ball->fine > down - 1) ball->fine = (uint8_t)(down - 1);
    ball->half = (UINT32_C(1) << ball->fine) >> 1;
    down = (uint8_t)(down - ball->fine);
    ball->ddm = (uint32_t)(uint64_t)fc_floor_shift64(ball->cone.dxx + (INT64_C(1) << (down - 1)), down);
    ball->bend = (uint64_t)ball->cone.dxx * 120;
  }
  /*
   * sqrt(f) is good from f = 2^(2t) on. In units of p = (b + sqrt(f)) 2^gain the form's error e costs e 2^gain / 2^t there,
   * if e is below half of f; a unit of root_run's 31 bits costs 2^16 / sqrt(2 m) / 2^half_lift = 2^(32 - t - lift / 2 - half_lift),
   * and it is off by 9 + 68 / 2^fine. t makes the former less than 32 and the latter little more, unless that would leave out more
   * than 2^-10 of the greatest f.
   */
  {
    uint8_t bits = fc_bits64((uint64_t)ball->cone.error), root = ball->lift / 2;
    const uint32_t loose = 10 + (68u >> ball->fine);
    int16_t t = (int16_t)(bits + gain - 5), most = (int16_t)(27 - root), least = (int16_t)(30 - root - ball->half_lift), cost;
    if (t < least) t = least;
    if (t > most) t = most;
    if (2 * t < bits + 1) t = (int16_t)((bits + 2) / 2);
    ball->inside = 2 * t < 32 ? 0 : (int32_t)((INT64_C(1) << 2 * t) >> 32);
    if (t < 16) t = 16; /* a whole word above 0 */
    cost = (int16_t)(32 - t - root - ball->half_lift);
    /* the root's error (32 before the shift); the two above; b's rounding and drift over 16 pixels, and the factors' cuts */
    ball->error = (32u >> ball->half_lift) + (uint32_t)((ball->cone.error << gain) >> t) + 14;
    ball->error += cost >= 0 ? loose << cost : (loose >> -cost) + 1;
  }
}

/* Where rows end; steps below 2^12, and all wraps. */
static FC_COLD void set_last(sphere_forms *ball, uint64_t steps) {
  const uint64_t dxx = (uint64_t)ball->cone.dxx;
  ball->sweep = dxx * steps;
  ball->last = (uint64_t)ball->cone.f + (uint64_t)ball->cone.dx * steps + dxx * (steps * (steps - 1) / 2);
  ball->last_dy = (uint64_t)ball->cone.dy + (uint64_t)ball->cone.dxy * steps;
}

static void next_row(sphere_forms *ball, int64_t b_dy) {
  ball->last += ball->last_dy;
  ball->last_dy += (uint64_t)ball->cone.dyy;
  fc_cone_next_row(&ball->cone);
  ball->b = fc_to_i64((uint64_t)ball->b + (uint64_t)b_dy);
}

/* The same for a coat. */
static FC_NOINLINE void light_row_coated(const fc_scan *scan, const sphere_forms *ball, fc_ball_light *light, uint16_t row, uint16_t column,
                                         uint32_t bits, const uint32_t *p, uint32_t e[32], fc_ball_coat *coat) {
  uint32_t rest, lit;
  uint8_t i;
  for (i = 0, rest = bits; rest != 0; i++, rest >>= 1) e[i] = p[i];
  lit = light_row(scan, light, row, column, bits, p, e);
  if (lit != 0)
    coat->run(coat, row, column, lit, p, e,
              (uint32_t)(((uint64_t)ball->b + fc_times((uint64_t)ball->b_dx, column) + (UINT32_C(1) << 31)) >> 32), ball->b_step);
  coat->seen(coat, row, column, bits, p);
}

/* What a tile of a sphere is drawn in. */
typedef struct sphere_work {
  sphere_forms ball;
  fc_ball_light light;
  sphere_row at;
  fc_coder coder;
  int64_t b_dy;
  uint32_t p[32], e[32];
} sphere_work;

typedef char sphere_work_fits[sizeof(sphere_work) <= FC_SCAN_WORK * sizeof(int64_t) ? 1 : -1];

void fc_ball_draw(fc_scan *scan, const fc_placed_sphere *placed, fc_ball_coat *coat) {
  sphere_work *work = (void *)scan->work;
  sphere_forms *ball = &work->ball;
  fc_ball_light *light = &work->light;
  sphere_row *at = &work->at;
  uint32_t *ps = work->p;
  uint16_t row;
  uint8_t how = LIGHT_UNKNOWN;
  set_ball(scan, placed, ball, &work->b_dy);
  set_last(ball, (uint64_t)scan->columns - 1);
  ball->clip = placed->seen == FC_SPHERE_CUT;
  fc_coder_start(&work->coder, scan->frame, ball->drop, UINT32_C(1) << 29);
  for (row = 0; row <= scan->last_row; row++, next_row(ball, work->b_dy)) {
    uint16_t column;
    if (row < scan->first_row || fc_scan_skips(scan, row)) continue;
    set_row(scan, ball, at);
    if (at->first != at->from) draw_open(scan, row, at->first, at->from);
    if (at->to != at->end) draw_open(scan, row, at->to, at->end);
    for (column = at->from; column < at->to; column = (uint16_t)(column + 32)) {
      uint32_t bits, open, undecided, rough = 0;
      uint8_t count = at->to - column < 32 ? (uint8_t)(at->to - column) : 32;
      root_run(ball, at, ps, count);
      open = ball->clip ? clip_run(scan, ball, row, column, ps, ps, ps + count) : 0;
      bits = test_run(scan, row, column, ps, ps + count, ball->error, &work->coder, &undecided);
      open |= undecided;
      if (open != 0) {
        bits |= settle(scan, ball, &work->coder, row, column, open, ps, &rough);
        bits &= ~rough;
      }
      if ((bits | rough) == 0 || !fc_scan_wants_light(scan, row, column, bits | rough)) continue;
      if (rough != 0) fc_scan_shade_slowly(scan, row, column, rough);
      if (bits == 0) continue;
      if (how == LIGHT_UNKNOWN) {
        how = set_light(scan, light, ball->drop, ball->error);
        light->occluders = UNSOUGHT;
        if (coat != NULL && how != LIGHT_SLOW) coat->start(coat, light, placed, ball->drop, ball->error);
      }
      if (how == LIGHT_SLOW)
        fc_scan_shade_slowly(scan, row, column, bits);
      else if (coat != NULL)
        light_row_coated(scan, ball, light, row, column, bits, ps, work->e, coat);
      else if (light->occluders != 0)
        light_row_among(scan, light, row, column, bits, ps, work->e);
      else
        light_row(scan, light, row, column, bits, ps, ps);
    }
  }
}

/* A depth code that the sphere's pixels do not exceed. */
static FC_COLD uint16_t nearest_code(const fc_scan *scan) {
  /* z - r is at least 1, and near at most that: their quotient is within 2^-24 */
  const fc_quick z = fc_quick_from((uint64_t)(scan->form->u.sphere.center[2] - scan->form->u.sphere.radius), 0);
  const fc_quick p = fc_quick_mul(fc_quick_from(scan->frame->depth_near, 30), fc_quick_recip(z));
  uint32_t most = (uint32_t)fc_quick_to_int(p, 0), code; /* 2^30 and little more */
  fc_coder coder;
  most += (most >> 23) + 2;
  fc_coder_start(&coder, scan->frame, 0, most);
  code = (uint32_t)coder.base + ((most + coder.half) >> coder.shift) + 1;
  return code > UINT16_MAX ? UINT16_MAX : (uint16_t)code;
}

/* Whether nearer surfaces cover the tile for certain. */
static FC_COLD bool is_covered(const fc_scan *scan) {
  const uint16_t last = (uint16_t)(scan->columns - 1);
  uint16_t row, code;
  if (*fc_scan_depth(scan, scan->first_row, 0) == 0 || *fc_scan_depth(scan, scan->last_row, last) == 0) return false;
  code = nearest_code(scan);
  for (row = scan->first_row; row <= scan->last_row; row++) {
    const uint16_t *depth = fc_scan_depth(scan, row, 0), *end = depth + scan->columns;
    if (fc_scan_skips(scan, row)) continue;
    do {
      if (*depth <= code) return false;
    } while (++depth != end);
  }
  return true;
}

FC_COLD void fc_sphere_draw(fc_scan *scan) {
  const fc_placed_sphere *placed = (const fc_placed_sphere *)scan->at->group.memory + scan->index;
  uint16_t row;
  uint8_t word;
  if (placed->seen != FC_SPHERE_ODD && is_covered(scan)) return;
  if (placed->seen != FC_SPHERE_ODD) {
    if (scan->coat == NULL) {
      fc_ball_draw(scan, placed, NULL);
    } else {
      fc_coat_kind kind;
      FC_READ_ONE(&kind, scan->coat);
      kind.sphere(scan, placed);
    }
    return;
  }
  for (row = 0; row < scan->rows * scan->words; row++) scan->mask[row] = 0;
  fc_scan_slowly(scan);
  for (row = scan->first_row; row <= scan->last_row; row++)
    for (word = 0; word < scan->words; word++) {
      uint32_t bits = scan->mask[row * scan->words + word];
      if (bits != 0 && fc_scan_wants_light(scan, row, (uint16_t)(32 * word), bits))
        fc_scan_shade_slowly(scan, row, (uint16_t)(32 * word), bits);
    }
}

/* ---- shadows ---- */

FC_COLD bool fc_sphere_between(const fc_frame *frame, const fc_form *form, const int64_t light[3], const int64_t center[3],
                               int64_t radius, fc_window *window) {
  int32_t a[3], b[3]; /* 31 bits */
  int16_t x[3], y[3];
  uint32_t most = (uint32_t)form->u.sphere.radius | (uint32_t)radius;
  uint8_t i, bits, shift;
  window->x0 = window->y0 = 0;
  window->x1 = frame->width - 1;
  window->y1 = frame->height - 1;
  for (i = 0; i < 3; i++) {
    a[i] = (int32_t)(form->u.sphere.center[i] - light[i]);
    b[i] = (int32_t)(center[i] - light[i]);
    most |= fc_abs32(a[i]) | fc_abs32(b[i]);
  }
  bits = most == 0 ? 0 : (uint8_t)(32 - fc_clz32(most));
  shift = bits > 15 ? (uint8_t)(bits - 15) : 0;
  for (i = 0; i < 3; i++) {
    x[i] = (int16_t)fc_floor_shift32(a[i], shift);
    y[i] = (int16_t)fc_floor_shift32(b[i], shift);
  }
  return short_between(short_square(x), short_dot(x, y), short_square(y), ((uint32_t)form->u.sphere.radius >> shift) + 4,
                       ((uint32_t)radius >> shift) + 4);
}

/* Whether the sphere keeps the light from the point: 1, 0, or -1, in 15 bits. */
static FC_NOINLINE int8_t glance(const fc_form *form, const int64_t light[3], const int32_t point[3], uint32_t error) {
  int32_t a[3], b[3]; /* below 2^31 */
  int16_t x[3], y[3];
  uint32_t most = (uint32_t)form->u.sphere.radius | 1;
  uint8_t i, bits, shift;
  for (i = 0; i < 3; i++) {
    int32_t l = (int32_t)light[i];
    a[i] = (int32_t)form->u.sphere.center[i] - l;
    b[i] = point[i] - l;
    most |= fc_abs32(a[i]) | fc_abs32(b[i]);
  }
  bits = (uint8_t)(32 - fc_clz32(most));
  shift = bits > 15 ? (uint8_t)(bits - 15) : 0;
  for (i = 0; i < 3; i++) {
    x[i] = (int16_t)fc_floor_shift32(a[i], shift);
    y[i] = (int16_t)fc_floor_shift32(b[i], shift);
  }
  return short_hides(short_square(x), short_dot(x, y), short_square(y), (int16_t)((uint32_t)form->u.sphere.radius >> shift),
                     error >> shift);
}

/* The same in 29 bits. */
static FC_COLD int8_t hides_closely(const fc_form *form, const int64_t light[3], const int32_t point[3], uint32_t error) {
  /* Light outside. With w = P - L, c = C - L and q = |c|^2 - r^2 > 0 the line meets the sphere iff (w.c)^2 >= w.w q and w.c > 0,
   * and it does so before P iff its foot does, w.c < w.w, or P is inside, w.w - 2 w.c + q < 0. Vectors are cut to 29 bits
   * and sums of three products by 2^30 more, to 30. */
  int64_t c[3], w[3], cc = 0, a = 0, ww = 0, q, e_a, e_w, e_q, difference, slack;
  uint64_t most = (uint64_t)form->u.sphere.radius;
  uint8_t i, shift, bits;
  int64_t e, r;
  for (i = 0; i < 3; i++) {
    c[i] = form->u.sphere.center[i] - light[i];
    w[i] = point[i] - light[i];
    most |= fc_abs64(c[i]) | fc_abs64(w[i]);
  }
  bits = fc_bits64(most);
  shift = bits > 29 ? (uint8_t)(bits - 29) : 0;
  e = (int64_t)(error >> shift) + 2; /* of w; c's is below 1 */
  r = form->u.sphere.radius >> shift;
  for (i = 0; i < 3; i++) {
    int32_t x = (int32_t)fc_floor_shift64(c[i], shift), y = (int32_t)fc_floor_shift64(w[i], shift);
    cc += fc_smul32(x, x);
    a += fc_smul32(x, y);
    ww += fc_smul32(y, y);
    c[i] = x;
    w[i] = y;
  }
  /* |c|_1 and |w|_1 are below 2^30.6, e below 2^21 + 2 */
  q = cc - fc_smul32((int32_t)r, (int32_t)r);
  e_q = 2 * (fc_small_norm1(c) + r) + 4;
  e_w = 2 * fc_small_norm1(w) * e + 3 * e * e;
  e_a = fc_small_norm1(c) * e + fc_small_norm1(w) + 3 * e;
  if (q <= e_q) return -1;
  if (a < -e_a) return 0;
  if (a <= e_a) return -1;
  /* 30-bit values, off by these: products below 2^60 */
  a >>= 30;
  ww >>= 30;
  q >>= 30;
  e_a = (e_a >> 30) + 2;
  e_w = (e_w >> 30) + 2;
  e_q = (e_q >> 30) + 2;
  difference = a * a - ww * q;
  slack = 2 * a * e_a + e_a * e_a + ww * e_q + q * e_w + e_w * e_q;
  if (difference < -slack) return 0;
  if (a + e_a < ww - e_w) return difference > slack ? 1 : -1;
  if (a - e_a <= ww + e_w) return -1;
  /* the foot lies behind P: is P inside? */
  difference = ww - 2 * a + q;
  slack = e_w + 2 * e_a + e_q;
  return difference > slack ? 0 : difference < -slack ? 1
                                                      : -1;
}

FC_COLD int8_t fc_sphere_hides(const fc_form *form, const int64_t light[3], const int32_t point[3], uint32_t error) {
  const int8_t at_once = glance(form, light, point, error);
  return at_once >= 0 ? at_once : hides_closely(form, light, point, error);
}

/* W.(C - L) over a tile, in units of 2^32: positive where the sphere lies ahead of the light, seen along W. */
typedef struct ahead_form {
  int64_t at, dx, dy, margin;
} ahead_form;

static FC_COLD int64_t along_center(const int64_t center[3], const int32_t w[3]) {
  return fc_smul64hi(center[0], w[0]) + fc_smul64hi(center[1], w[1]) + fc_smul64hi(center[2], w[2]);
}

/* 1: everywhere, -1: nowhere, 0: here and there. */
static FC_COLD int8_t set_ahead(const fc_scan *scan, const fc_planar *receiver, const int64_t center[3], ahead_form *a) {
  /* 31 + 30 bits, less 32; floors and W's error: 3 (1 + columns + rows) + |C - L|_1 error / 2^32 */
  int64_t x, y, low, high;
  a->at = along_center(center, receiver->w.at);
  a->dx = along_center(center, receiver->w.dx);
  a->dy = along_center(center, receiver->w.dy);
  a->margin = 3 * ((int64_t)scan->columns + scan->rows + 2) + 2 * (int64_t)receiver->w.error;
  x = a->dx * scan->columns;
  y = a->dy * scan->rows;
  low = a->at + (x < 0 ? x : 0) + (y < 0 ? y : 0);
  high = a->at + (x > 0 ? x : 0) + (y > 0 ? y : 0);
  if (low > a->margin) return 1;
  return high < -a->margin ? -1 : 0;
}

/* What decides a pixel that the shadow may touch. */
typedef struct shadow_test {
  int64_t dark, lit; /* f above: in the dark; below: in the light */
  int64_t bulge;     /* f is quadratic along a row: between columns n apart it differs from the chord by at most n^2 / 8 of this */
  int8_t everywhere; /* the sphere lies ahead of the light everywhere; otherwise by: */
  bool doubted;      /* the row has pixels in `doubt` */
  ahead_form ahead;
  fc_window doubt;
  const fc_planar *receiver;
  const fc_kind *kind;
  const fc_form *form;
} shadow_test;

/* f along a row, at some column. */
typedef struct shadow_run {
  uint64_t f, dx, dxx;
} shadow_run;

/* Up to 8 pixels: those in the dark; adds to *asked those that the form leaves open. */
static FC_NOINLINE uint32_t shade_some(const fc_scan *scan, const shadow_test *test, uint16_t row, uint16_t column,
                                       uint32_t bits, const shadow_run *at, uint32_t *asked) {
  uint32_t dark = 0, open = 0, bit = 1;
  uint64_t f = at->f, dx = at->dx;
  for (; bits != 0; bits >>= 1, bit <<= 1, column++, f += dx, dx += at->dxx) {
    bool sure = fc_to_i64(f) > test->dark;
    if (!(bits & 1) || fc_to_i64(f) < test->lit) continue;
    if (test->everywhere == 0) {
      int64_t a = test->ahead.at + test->ahead.dx * column + test->ahead.dy * row;
      if (a < -test->ahead.margin) continue; /* behind the light, whatever f is */
      if (a <= test->ahead.margin) sure = false;
    }
    if (test->doubted && scan->x + column >= test->doubt.x0 && scan->x + column <= test->doubt.x1) sure = false;
    if (sure || (fc_scan_guesses(scan) && fc_to_i64(f) > 0))
      dark |= bit;
    else if (!fc_scan_guesses(scan))
      open |= bit;
  }
  *asked = open;
  return dark;
}

/* Whether f stays below `lit` all along a row. Seen as a parabola it does for certain where it opens downwards and its vertex,
 * f + (dx - dxx / 2)^2 / (2 |dxx|), lies below: words of 31 bits, rounded to the safe side. */
static FC_NOINLINE bool row_is_clear(const fc_cone *cone, int64_t lit) {
  uint32_t slope, bend, below;
  if (cone->dxx >= 0 || cone->f >= lit) return false;
  slope = (uint32_t)(fc_abs64(fc_to_i64((uint64_t)cone->dx - (uint64_t)fc_floor_shift64(cone->dxx, 1))) >> 32) + 1;
  bend = (uint32_t)(fc_abs64(cone->dxx) >> 32);
  below = (uint32_t)(((uint64_t)lit - (uint64_t)cone->f) >> 32);
  return fc_mul32(slope, slope) >> 1 < fc_mul32(bend, below);
}

static FC_COLD uint64_t square_of(const int64_t v[3]) {
  uint64_t sum = 0;
  uint8_t i;
  for (i = 0; i < 3; i++) sum += (uint64_t)(v[i] * v[i]);
  return sum;
}

/* m.v / 4, 15 + 15 bits, within 3. */
static int32_t side_of(const int16_t m[3], const int16_t v[3]) {
  return fc_floor_shift32((int32_t)m[0] * v[0], 2) + fc_floor_shift32((int32_t)m[1] * v[1], 2) +
         fc_floor_shift32((int32_t)m[2] * v[2], 2);
}

/* The sum of the axes, and the greatest. */
static uint32_t axes_of(const int16_t v[3], uint32_t *greatest) {
  uint32_t sum = 0;
  uint8_t i;
  *greatest = 0;
  for (i = 0; i < 3; i++) {
    uint32_t size = fc_abs32(v[i]);
    sum += size;
    if (size > *greatest) *greatest = size;
  }
  return sum;
}

/*
 * The planes through the light along the tile's upper and lower edge. W in the tile is between its corners', so it lies on one side
 * of both.
 *
 * A corner w has 15 bits and is within 1 an axis, so the normal w1 x w2 is within e = 2 (w1 + w2 + 1) of their greatest axes. Cut to
 * 15 bits, m, it is within e 2^-s + 1. So m.v is within |m|_1 + (e 2^-s + 1) (|v|_1 + 3) for a v of 15 bits within 1.
 */
static FC_COLD void find_edges(fc_planar *receiver) {
  uint8_t i, k;
  if (!receiver->corners_known) fc_planar_find_corners(receiver);
  for (k = 0; k < 2; k++) {
    fc_planar_edge *edge = &receiver->edge[k];
    const int16_t *u = receiver->corner[2 * k], *v = receiver->corner[2 * k + 1];
    const int16_t *near = receiver->corner[2 - 2 * k], *next = receiver->corner[3 - 2 * k];
    int32_t wide[3], inner, other, slack;
    uint32_t most = 0, error, a, b;
    uint8_t shift;
    edge->side = 0;
    (void)axes_of(u, &a);
    (void)axes_of(v, &b);
    error = 2 * (a + b + 1);
    for (i = 0; i < 3; i++) {
      uint8_t j = (uint8_t)(i == 2 ? 0 : i + 1), h = (uint8_t)(i == 0 ? 2 : i - 1);
      wide[i] = (int32_t)u[j] * v[h] - (int32_t)u[h] * v[j]; /* products below 2^28 */
      most |= fc_abs32(wide[i]);
    }
    shift = fc_bits64(most);
    shift = shift > 15 ? (uint8_t)(shift - 15) : 0;
    error = (error >> shift) + 2;
    if (error >> 10 != 0) continue; /* all but parallel */
    for (i = 0; i < 3; i++) edge->normal[i] = (int16_t)fc_floor_shift32(wide[i], shift);
    edge->error = (uint16_t)error;
    edge->sum = axes_of(edge->normal, &edge->greatest);
    a = axes_of(near, &b);
    a += axes_of(next, &b);                                   /* more than either */
    slack = (int32_t)((edge->sum + error * (a + 3)) / 4) + 4; /* 17 bits; 10 + 18 */
    inner = side_of(edge->normal, near);
    other = side_of(edge->normal, next);
    edge->side = (int8_t)((inner > slack && other > slack) - (inner < -slack && other < -slack));
  }
  receiver->edges_known = true;
}

/* Whether a ball seen from the light at C lies clear of what the tile shows, at a glance: beyond one of these planes. */
static FC_NOINLINE bool beyond_edges(fc_planar *receiver, const int64_t center[3], int64_t radius) {
  int16_t c[3];
  uint64_t most = (uint64_t)radius;
  uint32_t c_sum, reach, greatest;
  uint8_t i, shift;
  if (!receiver->edges_known) find_edges(receiver);
  if (receiver->edge[0].side == 0 && receiver->edge[1].side == 0) return false;
  for (i = 0; i < 3; i++) most |= fc_abs64(center[i]);
  shift = fc_bits64(most);
  shift = shift > 15 ? (uint8_t)(shift - 15) : 0;
  for (i = 0; i < 3; i++) c[i] = (int16_t)fc_floor_shift64(center[i], shift);
  reach = (uint32_t)(radius >> shift) + 1;
  c_sum = axes_of(c, &greatest);
  for (i = 0; i < 2; i++) {
    const fc_planar_edge *edge = &receiver->edge[i];
    int32_t ball, at;
    if (edge->side == 0) continue;
    /* |m| is at most its longest axis and half the others: 15 + 17 bits, quartered */
    ball = (int32_t)((reach * ((edge->sum + edge->greatest) / 2 + 1)) / 4 + (edge->sum + edge->error * (c_sum + 3)) / 4) + 8;
    at = side_of(edge->normal, c);
    if (edge->side > 0 ? at < -ball : at > ball) return true;
  }
  return false;
}

/* Pixels of a word in the dark, from where the run stands; *asked: those that the form leaves open. */
static FC_NOINLINE uint32_t darken_word(const fc_scan *scan, const shadow_test *test, uint16_t row, uint16_t column, uint32_t bits,
                                        const shadow_run *from, uint32_t *asked) {
  const bool concave = fc_to_i64(from->dxx) < 0;
  const int64_t lit = test->lit, bulge = test->bulge;
  shadow_run at = *from;
  uint32_t darkened = 0;
  uint8_t k;
  for (k = 0; bits != 0; k = (uint8_t)(k + 8), bits >>= 8) {
    /* 8 on: f + 8 dx + 28 dxx */
    const uint64_t f8 = at.f + (at.dx << 3) + (at.dxx << 5) - (at.dxx << 2);
    uint32_t some = bits & 0xffu, open;
    if (concave && fc_to_i64(at.f) < lit && fc_to_i64(at.dx) <= 0) break;
    if (some != 0) {
      bool all = false;
      if (column + k + 8 <= scan->columns) {
        const bool falls = fc_to_i64(f8) < fc_to_i64(at.f);
        const int64_t low = fc_to_i64(falls ? f8 : at.f), high = fc_to_i64(falls ? at.f : f8);
        if (high < lit - (bulge << 3) || (concave && fc_to_i64(f8) < lit && fc_to_i64(at.dx + (at.dxx << 3) - at.dxx) >= 0))
          some = 0;
        else
          all = low > test->dark + (bulge << 3) && test->everywhere > 0 && !test->doubted;
      }
      if (!all && some != 0) {
        some = shade_some(scan, test, row, (uint16_t)(column + k), some, &at, &open);
        *asked |= open << k;
      }
      darkened |= some << k;
    }
    at.f = f8;
    at.dx += at.dxx << 3;
  }
  return darkened;
}

/* A row, from where the run stands: its first pixel. */
static FC_NOINLINE void darken_row(fc_scan *scan, const shadow_test *test, uint16_t row, shadow_run *at) {
  const bool concave = fc_to_i64(at->dxx) < 0;
  const int64_t lit = test->lit;
  uint16_t column = 0;
  uint8_t word;
  for (word = 0; word < scan->words; word++, column = (uint16_t)(column + 32)) {
    uint32_t bits = scan->mask[row * scan->words + word], asked = 0;
    /* 32 columns on: f + 32 dx + 496 dxx */
    const uint64_t f_next = at->f + (at->dx << 5) + (at->dxx << 9) - (at->dxx << 4), dx_next = at->dx + (at->dxx << 5);
    const int64_t least = lit - (test->bulge << 7);
    /* an ellipse: once f is below and falls, or as long as it still rises and stays below, there is nothing to find */
    if (concave && fc_to_i64(at->f) < lit && fc_to_i64(at->dx) <= 0) break;
    if (concave && word + 1 < scan->words && fc_to_i64(f_next) < lit && fc_to_i64(dx_next - at->dxx) >= 0) bits = 0;
    /* what lies past the tile does not fit */
    if (bits != 0 && (word + 1 == scan->words || fc_to_i64(at->f) >= least || fc_to_i64(f_next) >= least)) {
      uint32_t dark = darken_word(scan, test, row, column, bits, at, &asked), bit = 1;
      uint16_t x = column;
      for (; asked != 0; asked >>= 1, bit <<= 1, x++)
        if ((asked & 1) && fc_planar_blocked(scan, test->receiver, row, x, test->kind, test->form)) dark |= bit;
      if (dark != 0) fc_planar_darken(scan, row, column, dark);
    }
    at->f = f_next;
    at->dx = dx_next;
  }
}

/* What a shadow is found in. */
typedef struct shadow_work {
  fc_cone cone;
  shadow_test test;
  shadow_run run;
} shadow_work;

typedef char shadow_fits[sizeof(shadow_work) <= FC_SHADOW_WORK * sizeof(int64_t) ? 1 : -1];

void fc_sphere_shadow(fc_scan *scan, fc_planar *receiver, const fc_kind *kind, const fc_form *form) {
  const int64_t *c = form->u.sphere.center;
  int64_t center[3], radius = form->u.sphere.radius;
  shadow_work *work = (void *)receiver->work;
  fc_cone *cone = &work->cone;
  shadow_test *test = &work->test;
  uint16_t row;
  uint8_t i;
  bool known = false;
  for (i = 0; i < 3; i++) center[i] = c[i] - scan->frame->lights[i]; /* below 2^31 */
  /* squares below 2^62, three of them below 2^64 */
  if (square_of(center) <= (uint64_t)(radius * radius)) {
    fc_planar_ask(scan, kind, form); /* the light inside the sphere, or on it */
    return;
  }
  if (beyond_edges(receiver, center, radius)) return;
  test->everywhere = set_ahead(scan, receiver, center, &test->ahead);
  if (test->everywhere < 0) return;
  fc_cone_setup(cone, center, radius, 0, &receiver->w, scan->columns, scan->rows);
  test->dark = cone->error;
  test->lit = -cone->error;
  /* f, below 2^62, bends by 8 dxx over 8 columns */
  test->bulge = scan->columns < 8 ? 0 : (int64_t)fc_abs64(cone->dxx);
  test->receiver = receiver;
  test->kind = kind;
  test->form = form;
  for (row = 0; row <= scan->last_row; row++, fc_cone_next_row(cone)) {
    if (row < scan->first_row || row_is_clear(cone, test->lit)) continue;
    if (!known) {
      if (!fc_planar_faces_ball(scan, receiver, c, radius, &test->doubt)) return;
      known = true;
    }
    test->doubted = scan->y + row >= test->doubt.y0 && scan->y + row <= test->doubt.y1;
    work->run.f = (uint64_t)cone->f;
    work->run.dx = (uint64_t)cone->dx;
    work->run.dxx = (uint64_t)cone->dxx;
    darken_row(scan, test, row, &work->run);
  }
}
