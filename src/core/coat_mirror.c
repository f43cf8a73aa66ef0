/*
 * Perfect mirrors on spheres by fast forms: one ray from a point of the ball, in short numbers with error bounds. What they leave open is
 * traced by the layer.
 */
#include "coat.h"

#include "shade.h"
#include "view.h"

/* Lengths are grid units, directions Q30. */
typedef struct path {
  int32_t point[3], way[3];
  uint32_t error;     /* of each coordinate of the point */
  uint32_t way_error; /* of the way, as a vector, Q30 */
} path;

/* Nothing is met, something is, or that is too close to tell. */
enum {
  MET_NOTHING,
  MET,
  MET_PERHAPS
};

/* t below 2^52; its error may be INT64_MAX. */
typedef struct meeting {
  int64_t t, t_error;
} meeting;

static bool is_sphere(const fc_kind *kind) { return kind->hides == fc_sphere_hides; }

static FC_COLD bool fits(const fc_scan *scan, const void *data) {
  const fc_scene *scene = &scan->frame->scene;
  fc_space space = fc_space_of_frame(scan->frame);
  fc_cursor cursor;
  fc_material material;
  uint16_t count = 0;
  (void)data;
  FC_READ_ONE(&material, scene->materials + scan->form->material);
  /* what the ball has of its own is black; a scene of few balls and planes */
  if (!is_sphere(fc_kind_of(scan->at)) || scene->bvh != NULL || (material.diffuse.r | material.diffuse.g | material.diffuse.b) != 0) return false;
  fc_cursor_start(&cursor, &space);
  while (fc_cursor_next(&cursor)) {
    if (cursor.group.shapes.count != 0 && !is_sphere(fc_kind_of(&cursor)) && fc_kind_of(&cursor)->bounds != NULL) return false;
    if (cursor.group.shapes.count > FC_COAT_SEEN) return false;
    count = (uint16_t)(count + cursor.group.shapes.count);
  }
  return count <= FC_COAT_SEEN + 1;
}

static FC_COLD void start(fc_coat *coat, const void *data) {
  const fc_scan *scan = coat->scan;
  const fc_frame *frame = scan->frame;
  fc_coat_mirror *mirror = &coat->mirror;
  fc_space space = fc_space_of_frame(frame);
  fc_cursor cursor;
  fc_mirror layer;
  fc_quick limit = fc_quick_from((uint64_t)frame->scene.far_limit, fc_view_far_exponent(frame));
  FC_READ(&layer, data, sizeof layer);
  fc_channels(&layer.reflectance, mirror->weight);
  mirror->count = 0;
  fc_cursor_start(&cursor, &space);
  while (fc_cursor_next(&cursor)) {
    uint16_t i;
    for (i = 0; i < cursor.group.shapes.count; i++) {
      fc_coat_seen *seen = &mirror->seen[mirror->count];
      if ((uint16_t)(cursor.group.first + i) == scan->primitive || mirror->count == FC_COAT_SEEN) continue;
      fc_kind_of(&cursor)->fetch(&cursor.group, i, &seen->form);
      seen->sphere = is_sphere(fc_kind_of(&cursor));
      seen->hides = fc_kind_of(&cursor)->hides;
      if (seen->sphere) {
        seen->inverse = fc_quick_recip(fc_quick_from((uint64_t)seen->form.u.sphere.radius, 0));
      } else {
        seen->lamp = seen->form.u.plane.k - fc_dot(seen->form.u.plane.normal, frame->lights);
        seen->inverse = fc_quick_rsqrt(fc_quick_from((uint64_t)fc_dot(seen->form.u.plane.normal, seen->form.u.plane.normal), 0));
      }
      mirror->count++;
    }
  }
  /* rays go up to 2^52 */
  mirror->limit = frame->scene.far_limit == 0 || limit.e > 20 ? INT64_MAX : (int64_t)fc_quick_to_u64(limit);
  mirror->depth = fc_quick_mul(fc_quick_from(frame->depth_near, (int32_t)(30 + coat->drop)),
                               fc_quick_recip(fc_quick_from((uint64_t)frame->view.focal, 0)));
  mirror->inverse = fc_quick_recip(fc_quick_from((uint64_t)scan->form->u.sphere.radius, 0));
}

/* v m 2^e in Q30, for |v m 2^e| <= 1: within 2^-25 where v has 26 bits, and 2^-30 of 1 in the other direction. */
FC_INLINE int32_t unit_of(int32_t v, fc_quick scale) {
  const int32_t up = scale.e + 62;
  const int32_t product = fc_smulhi32(v, scale.m);
  return up >= 0 ? product * (INT32_C(1) << up) : fc_floor_shift32(product, (uint8_t)(up < -31 ? 31 : -up));
}

static int64_t dot30(const int32_t a[3], const int32_t b[3]) { return fc_to_i64(fc_dot32(a, b)); }

/*
 * The mirrored ray of a pixel; false when it is not good enough. Each coordinate of the point is as far off as p, of itself, and 2^-25, and
 * floors; the normal within that over r, e; and the way, D + 2 (n.v) n, within 4 e and 2^-23.
 */
static FC_NOINLINE bool reflect(const fc_coat *coat, uint16_t row, uint16_t column, uint32_t p, path *to) {
  const fc_scan *scan = coat->scan;
  const int64_t *c = scan->form->u.sphere.center;
  const fc_quick t = fc_quick_mul(fc_quick_recip(fc_quick_from(p, 0)), coat->mirror.depth);
  const int32_t up = t.e + 32;
  int64_t d[3];
  int32_t short_d[3], n[3], view[3], dn;
  const uint8_t octave = (uint8_t)(31 - fc_clz32(p));
  uint32_t most = 0, bend;
  fc_quick inverse;
  uint8_t i;
  /* radii from 2^12 on: 1 / r in Q30 is below 2^18 */
  if (octave < 20 + fc_bits64(coat->error) || up > 2 || up < -28 || coat->mirror.inverse.e > -43) return false;
  fc_view_direction(scan->frame, (uint16_t)(scan->x + column), (uint16_t)(scan->y + row), d);
  for (i = 0; i < 3; i++) short_d[i] = (int32_t)d[i];
  inverse = fc_quick_rsqrt(fc_quick_from(fc_dot32(short_d, short_d), 0));
  for (i = 0; i < 3; i++) {
    const int32_t v = fc_smulhi32(short_d[i], t.m);
    to->point[i] = up >= 0 ? v * (INT32_C(1) << up) : fc_floor_shift32(v, (uint8_t)-up);
    most |= fc_abs32(to->point[i]);
    n[i] = unit_of((int32_t)(to->point[i] - c[i]), coat->mirror.inverse); /* the sphere is in front of the eye: 31 bits */
    view[i] = unit_of(short_d[i], inverse);
  }
  to->error = (uint32_t)(fc_mul32(most, coat->error + 1) >> octave) + (most >> 25) + 6; /* below 2^31 2^-20 */
  /* e in Q30 */
  bend = (uint32_t)unit_of((int32_t)to->error, coat->mirror.inverse);
  bend += coat->mirror.inverse.e + 62 > 0 ? UINT32_C(1) << (coat->mirror.inverse.e + 62) : 1;
  if (bend >> 17 != 0) return false;
  to->way_error = 4 * bend + 128;
  dn = (int32_t)fc_floor_shift64(dot30(n, view), 30);
  if (dn >= 0) return false; /* grazing */
  for (i = 0; i < 3; i++) to->way[i] = view[i] - (int32_t)fc_floor_shift64(fc_smul32(dn, n[i]), 29);
  return true;
}

/* v e / 2^30, rounded up. */
static uint32_t part_of(uint32_t v, uint32_t e_q30) { return (uint32_t)(fc_mul32(v, e_q30) >> 30) + 1; }

/*
 * Whether a ball is missed, at a glance in 15 bits; o: C - P. Each axis and each part of the way is floored, so b is within 7, and o.o and b^2 within
 * 2 |o| times that and 14; the ray's own error, below 2^-11 of |o|, and the point's are far less than as much again in these units, or it is no miss.
 */
static FC_NOINLINE bool misses(const path *ray, const int32_t o[3], uint32_t radius) {
  const uint32_t r = (radius >> 15) + 2 + (ray->error >> 15);
  const uint32_t rough = 8 + (ray->way_error >> 13) + (ray->error >> 14); /* of b, for |o| below 2^15.8 */
  uint32_t oo = 0, sum = 0, slack;
  int32_t b = 0;
  uint8_t i;
  for (i = 0; i < 3; i++) {
    const int32_t v = fc_floor_shift32(o[i], 15), w = fc_floor_shift32(ray->way[i], 15); /* 2^15 at most, and the way's length */
    b += v * w;                                                                          /* |o| |R| in all: below 2^31 */
    oo += (uint32_t)(v * v);
    sum += fc_abs32(v);
  }
  b = fc_floor_shift32(b, 15);
  slack = 2 * sum * (rough + 2) + 200; /* 17 bits; way errors below 2^21 leave 8 */
  slack += r * r;
  /* outside it for certain, and behind or beside it; b^2 is at most o.o and as little more as `slack` holds */
  if (oo <= slack || oo >> 31 != 0) return false;
  return b < -(int32_t)rough || (uint32_t)(b * b) + slack < oo;
}

/*
 * A ball: b = (C - P).R, c = |C - P|^2 - r^2, met at b - sqrt(b^2 - c) where c > 0, b > 0 and b^2 >= c. With o the sum of C - P's axes, b is within
 * o times the way's error and 2 of the point's (and the way's length within its error), so b^2 - c within 2 o (that + 2 errors of the point).
 */
static FC_NOINLINE uint8_t meet_sphere(const path *ray, const fc_form *form, meeting *at) {
  int32_t o[3], b;
  int64_t c, square, least;
  uint32_t sum = 0, b_error;
  uint64_t margin;
  fc_quick root;
  uint8_t i;
  for (i = 0; i < 3; i++) {
    const int64_t v = form->u.sphere.center[i] - ray->point[i];
    if (fc_abs64(v) >> 30 != 0) return MET_PERHAPS;
    o[i] = (int32_t)v;
    sum += fc_abs32(o[i]);
  }
  if (misses(ray, o, (uint32_t)form->u.sphere.radius)) return MET_NOTHING;
  b = (int32_t)fc_floor_shift64(dot30(o, ray->way), 30);
  b_error = part_of(sum, ray->way_error) + 2 * ray->error + 2;
  /* below 3 2^60 and 2^60 */
  c = dot30(o, o) - fc_smul32((int32_t)form->u.sphere.radius, (int32_t)form->u.sphere.radius);
  margin = 2 * fc_mul32(sum, b_error + 2 * ray->error + 2); /* below 2^32 and 2^28 */
  if (c <= fc_to_i64(margin)) return MET_PERHAPS;
  if (b < 0 && (uint32_t)-b > b_error) return MET_NOTHING;
  square = fc_smul32(b, b) - c;
  if (square < -fc_to_i64(margin)) return MET_NOTHING;
  if (square <= fc_to_i64(margin) || b <= 0) return MET_PERHAPS;
  least = square - fc_to_i64(margin);
  root = fc_quick_from((uint64_t)least, 0);
  root = fc_quick_rsqrt(root);
  at->t_error = (int64_t)b_error + 4 + fc_quick_to_int(fc_quick_mul(root, fc_quick_from(margin, 0)), 0);
  root = fc_quick_mul(fc_quick_from((uint64_t)square, 0), fc_quick_rsqrt(fc_quick_from((uint64_t)square, 0)));
  b_error = (uint32_t)fc_quick_to_int(root, 0);
  at->t_error += (b_error >> 24) + 1;
  at->t = b - (int32_t)b_error;
  return at->t_error >> 20 != 0 ? MET_PERHAPS : MET;
}

/* k - n.P: 62 and 30 + 30 + 2 bits. */
static int64_t side_of(const fc_form *plane, const int32_t point[3]) {
  int32_t n[3];
  uint8_t i;
  for (i = 0; i < 3; i++) n[i] = (int32_t)plane->u.plane.normal[i];
  return plane->u.plane.k - dot30(n, point);
}

/* A plane: the distance to it over the way's part along its normal. */
static FC_NOINLINE uint8_t meet_plane(const path *ray, const fc_coat_seen *seen, meeting *at) {
  const int32_t *unit = seen->form.u.plane.unit;
  const int64_t side = side_of(&seen->form, ray->point);
  const int32_t far = fc_quick_times(seen->inverse, side, 0), along = (int32_t)fc_floor_shift64(dot30(unit, ray->way), 30);
  const uint32_t far_error = 2 * ray->error + (fc_abs32(far) >> 24) + 2, along_error = ray->way_error + 128;
  fc_quick t, t_error;
  if (fc_abs32(far) <= far_error || fc_abs32(far) == INT32_MAX) return MET_PERHAPS;
  if (fc_abs32(along) <= 2 * along_error) return MET_PERHAPS;
  if ((far < 0) != (along < 0)) return MET_NOTHING;
  t = fc_quick_mul(fc_quick_from(fc_abs32(far), 30), fc_quick_recip(fc_quick_from(fc_abs32(along), 0)));
  /* (far's + t along's) / |along|; twice, as that is off by half of itself at most */
  t_error = fc_quick_add(fc_quick_from(far_error, 30), fc_quick_mul(t, fc_quick_from(along_error, 0)));
  t_error = fc_quick_mul(t_error, fc_quick_recip(fc_quick_from(fc_abs32(along), 1)));
  t_error = fc_quick_scale(t_error, 2);
  if (t.e > 20 || t_error.e > 20) return MET_PERHAPS;
  at->t = (int64_t)fc_quick_to_u64(t);
  at->t_error = (int64_t)fc_quick_to_u64(t_error) + (at->t >> 23) + 4;
  return MET;
}

/* What the ray meets first: MET sets *first, MET_NOTHING: nothing within the far limit. */
static FC_NOINLINE uint8_t meet(const fc_coat_mirror *mirror, const path *ray, uint8_t *first, meeting *at) {
  uint8_t i, how = MET_NOTHING;
  meeting one;
  for (i = 0; i < mirror->count; i++) {
    const uint8_t met = mirror->seen[i].sphere ? meet_sphere(ray, &mirror->seen[i].form, &one) : meet_plane(ray, &mirror->seen[i], &one);
    if (met == MET_PERHAPS) return MET_PERHAPS;
    if (met == MET_NOTHING) continue;
    if (how == MET) {
      const int64_t apart = one.t - at->t, doubt = one.t_error + at->t_error;
      if (apart <= doubt && apart >= -doubt) return MET_PERHAPS;
      if (apart > 0) continue;
    }
    how = MET;
    *at = one;
    *first = i;
  }
  if (how != MET || mirror->limit == INT64_MAX) return how;
  {
    const int64_t beyond = at->t - mirror->limit, doubt = at->t_error + (mirror->limit >> 28) + (at->t >> 22) + 1;
    if (beyond > doubt) return MET_NOTHING;
    if (beyond >= -doubt) return MET_PERHAPS;
  }
  return how;
}

/* The plane where it is far away: lit when no ball comes near the line to the light. */
static FC_NOINLINE bool light_far(const fc_coat *coat, const fc_coat_seen *seen, const int64_t point[3], int64_t error, uint32_t *cosine_q24) {
  const fc_coat_mirror *mirror = &coat->mirror;
  const int64_t *light = coat->scan->frame->lights;
  path line;
  int64_t to[3];
  fc_quick inverse, off;
  meeting at;
  uint8_t i, down;
  for (i = 0; i < 3; i++) {
    line.point[i] = (int32_t)light[i]; /* within 2^30 */
    to[i] = point[i] - light[i];
  }
  down = fc_shrink(to, to);
  if (fc_vector_bits(to) < 20) return false;
  for (i = 0; i < 3; i++) line.way[i] = (int32_t)to[i];
  inverse = fc_quick_rsqrt(fc_quick_from(fc_dot32(line.way, line.way), 0));
  for (i = 0; i < 3; i++) line.way[i] = unit_of(line.way[i], inverse);
  line.error = 0;
  /* sqrt(3) of the error and a floor */
  off = fc_quick_mul(fc_quick_from((uint64_t)(fc_floor_shift64(error, down) + 2), 31), inverse);
  if (off.e > -12) return false; /* 2^20 in Q30: the cosine is off by less than 2^-10 of itself */
  line.way_error = (uint32_t)fc_quick_to_u64(off) + 128;
  for (i = 0; i < mirror->count; i++) {
    if (&mirror->seen[i] == seen) continue;
    if (!mirror->seen[i].sphere || meet_sphere(&line, &mirror->seen[i].form, &at) != MET_NOTHING) return false;
  }
  if (meet_sphere(&line, coat->scan->form, &at) != MET_NOTHING) return false;
  inverse = fc_quick_mul(fc_quick_from(fc_abs64(seen->lamp), 0), fc_quick_scale(inverse, (int16_t)-down));
  *cosine_q24 = (uint32_t)fc_quick_to_int(fc_quick_mul(inverse, seen->inverse), 24);
  return *cosine_q24 <= UINT32_C(1) << 24;
}

/* The surface that is met, and how it is lit: its cosine in Q24; false when that is too close to tell. */
static FC_NOINLINE bool light_near(const fc_coat *coat, const path *ray, uint8_t first, const meeting *at, uint32_t *cosine_q24) {
  const fc_coat_mirror *mirror = &coat->mirror;
  const fc_coat_seen *seen = &mirror->seen[first];
  const int64_t *light = coat->scan->frame->lights;
  const uint32_t error = (uint32_t)(ray->error + at->t_error) + part_of((uint32_t)at->t, ray->way_error) + 2;
  int32_t point[3], to[3], n[3];
  uint32_t to_sum = 0, n_sum = 0;
  int64_t along;
  fc_quick value, inverse;
  uint8_t i;
  for (i = 0; i < 3; i++) {
    const int64_t v = ray->point[i] + fc_floor_shift64(fc_smul32((int32_t)at->t, ray->way[i]), 30);
    if (fc_abs64(v) >> 30 != 0) return false;
    point[i] = (int32_t)v;
    to[i] = (int32_t)(light[i] - v); /* below 2^31: sums below 2^32.6 */
    if (fc_abs32(to[i]) >> 30 != 0) return false;
    to_sum += fc_abs32(to[i]);
    n[i] = (int32_t)(seen->sphere ? v - seen->form.u.sphere.center[i] : seen->form.u.plane.normal[i]);
    if (seen->sphere && fc_abs32(n[i]) >> 30 != 0) return false;
    n_sum += fc_abs32(n[i]);
  }
  if (seen->sphere) {
    /* 30 + 30 bits, three of them; off by the error times the sums of both */
    along = dot30(n, to);
    if (fc_abs64(along) <= fc_mul32(n_sum, error) + fc_mul32(to_sum, error) + 3 * fc_mul32(error, error)) return false;
    if (along < 0) return true;
    if (error > (uint32_t)(seen->form.u.sphere.radius >> 10)) return false; /* the cosine's own bound: sqrt(3) 2^-10 */
    value = seen->inverse;
  } else {
    /* the ray's side, which is sure, and the light's, which is exact */
    along = (int64_t)fc_abs64(seen->lamp); /* = n.(P - L), as P is on the plane */
    value = seen->inverse;
  }
  if (error > to_sum >> 10) return false;
  for (i = 0; i <= mirror->count; i++) {
    const fc_form *form = i < mirror->count ? &mirror->seen[i].form : coat->scan->form;
    int8_t hides;
    if (i == first) continue;
    hides = i < mirror->count ? (mirror->seen[i].hides == NULL ? -1 : mirror->seen[i].hides(form, light, point, error))
                              : fc_sphere_hides(form, light, point, error);
    if (hides < 0) return false;
    if (hides > 0) return true;
  }
  inverse = fc_quick_rsqrt(fc_quick_from(fc_dot32(to, to), 0));
  value = fc_quick_mul(fc_quick_mul(fc_quick_from((uint64_t)along, 0), inverse), value);
  *cosine_q24 = (uint32_t)fc_quick_to_int(value, 24);
  if (*cosine_q24 > UINT32_C(1) << 24) *cosine_q24 = UINT32_C(1) << 24;
  return true;
}

static FC_NOINLINE bool light_at(const fc_coat *coat, const path *ray, uint8_t first, const meeting *at, uint32_t *cosine_q24) {
  const fc_coat_seen *seen = &coat->mirror.seen[first];
  int64_t point[3], error;
  uint8_t i;
  *cosine_q24 = 0;
  /* the ray's side is sure, and the light's exact */
  if (!seen->sphere && fc_sign64(seen->lamp) * fc_sign64(side_of(&seen->form, ray->point)) <= 0) return true;
  if (at->t >> 29 == 0 && at->t_error >> 19 == 0) return light_near(coat, ray, first, at, cosine_q24);
  if (seen->sphere) return false;
  /* below 2^52 times 2^30 */
  error = ray->error + at->t_error + fc_smul64hi(at->t, (int32_t)ray->way_error) * 4 + 8;
  for (i = 0; i < 3; i++) point[i] = ray->point[i] + fc_smul64hi(at->t, ray->way[i]) * 4;
  return light_far(coat, seen, point, error, cosine_q24);
}

/* What the mirror shows at a pixel; false when only the layer can tell. */
static FC_NOINLINE bool look(const fc_coat *coat, uint16_t row, uint16_t column, uint32_t p, uint64_t radiance_q39[3]) {
  const fc_frame *frame = coat->scan->frame;
  path ray;
  meeting at;
  uint8_t first, i;
  uint32_t cosine;
  fc_material material;
  uint16_t diffuse[3], ambient[3];
  if (!reflect(coat, row, column, p, &ray)) return false;
  switch (meet(&coat->mirror, &ray, &first, &at)) {
    case MET_PERHAPS: return false;
    case MET_NOTHING: {
      int64_t way[3];
      for (i = 0; i < 3; i++) way[i] = fc_floor_shift32(ray.way[i], 1);
      fc_shade_background(frame, way, radiance_q39);
      return true;
    }
    default: break;
  }
  FC_READ_ONE(&material, frame->scene.materials + coat->mirror.seen[first].form.material);
  if (material.layer_count != 0 || !light_at(coat, &ray, first, &at, &cosine)) return false;
  fc_channels(&material.diffuse, diffuse);
  fc_channels(&frame->scene.ambient, ambient);
  for (i = 0; i < 3; i++) {
    /* as fc_shading_radiance: Q39, and light below 2^30 */
    const uint64_t q24 = (((uint64_t)ambient[i] << 24) + fc_mul32(frame->light_level[i], cosine) + (1u << 14)) >> 15;
    radiance_q39[i] = diffuse[i] * (q24 > UINT32_MAX ? UINT32_MAX : q24);
  }
  return true;
}

static FC_NOINLINE void sphere_seen(fc_coat *coat, const void *data) {
  const fc_scan *scan = coat->scan;
  const fc_coat_run *run = &coat->run;
  const uint16_t *weight = coat->mirror.weight;
  const bool whole = weight[0] == FC_ONE_Q15 && weight[1] == FC_ONE_Q15 && weight[2] == FC_ONE_Q15;
  uint32_t bits = run->bits;
  uint8_t i;
  (void)data;
  for (i = 0; bits != 0; bits >>= 1, i++) {
    uint64_t radiance_q39[3] = {0, 0, 0}, seen_q39[3];
    const uint16_t column = (uint16_t)(run->column + i);
    if (!(bits & 1)) continue;
    if (look(coat, run->row, column, run->p[i], seen_q39)) {
      if (!whole) fc_radiance_add(radiance_q39, coat->mirror.weight, seen_q39);
      fc_shade_put(scan->frame, whole ? seen_q39 : radiance_q39, scan->target->format, fc_scan_pixel(scan, run->row, column));
    } else {
      fc_scan_shade_slowly(scan, run->row, column, 1);
    }
  }
}

const fc_coat_layer fc_coat_layer_mirror FC_ROM = {&fc_coat_layers, FC_COAT_MIRRORS, fits, NULL, NULL, NULL, start, NULL, sphere_seen};
