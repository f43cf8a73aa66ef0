/* Strips: tiles of each primitive in turn, and what their pixels have in common. */
#include "scan.h"

#include <string.h>

#include "coat.h"
#include "depth.h"
#include "fixcast/error.h"
#include "pixel.h"
#include "shade.h"
#include "sky.h"
#include "tally.h"

/* ---- one pixel, by the ray engine ---- */

/* Meets the primitive with the pixel's ray. */
static FC_COLD bool meet(const fc_scan *scan, uint16_t row, uint16_t column, int64_t d[3], fc_root *root) {
  fc_view_direction(scan->frame, (uint16_t)(scan->x + column), (uint16_t)(scan->y + row), d);
  return fc_form_meet_in(&scan->asked->room.prepared, fc_kind_of(scan->at), scan->form, fc_eye, d, root) != 0;
}

/* Whether the primitive is there, with its depth code. */
static FC_COLD bool code_at(const fc_scan *scan, uint16_t row, uint16_t column, int64_t d[3], uint16_t *code) {
  fc_root *root = &scan->asked->surface.root;
  fc_wide *w = &scan->asked->room.segment.wide;
  if (!meet(scan, row, column, d, root) || fc_too_far_in(w, scan->frame, root, d)) return false;
  *code = fc_depth_code_in(w, scan->frame, root);
  return true;
}

FC_COLD bool fc_scan_exact(const fc_scan *scan, uint16_t row, uint16_t column) {
  int64_t d[3];
  uint16_t code, *depth = fc_scan_depth(scan, row, column);
  FC_TALLY(FC_DECIDE_PIXEL, true);
  if (!code_at(scan, row, column, d, &code)) return false;
  if (code < *depth) return false;
  if (code == *depth) {
    /* whatever is drawn there, or will be: the pixel goes to the nearest of all */
    if (fc_space_nearest(&scan->space, fc_eye, d, 0, UINT64_MAX, NULL) != scan->primitive) return false;
  }
  *depth = code;
  return true;
}

FC_COLD void fc_scan_slowly(fc_scan *scan) {
  uint16_t row, column;
  for (row = scan->first_row; row <= scan->last_row; row++) {
    if (fc_scan_skips(scan, row)) continue;
    for (column = 0; column < scan->columns; column++)
      if (fc_scan_exact(scan, row, column)) scan->mask[row * scan->words + column / 32] |= UINT32_C(1) << (column % 32);
  }
}

/* The surface point behind a visible pixel. */
static FC_COLD void surface_at(const fc_scan *scan, uint16_t row, uint16_t column, int64_t d[3], fc_surface *surface) {
  surface->at = *scan->at;
  surface->form = *scan->form;
  surface->primitive = scan->primitive;
  surface->origin = fc_eye;
  surface->direction = d;
  (void)meet(scan, row, column, d, &surface->root);
  fc_surface_complete(surface);
}

FC_COLD bool fc_scan_blocked(const fc_scan *scan, uint16_t row, uint16_t column, const fc_kind *kind, const fc_form *occluder) {
  fc_segment *segment = &scan->asked->room.segment;
  fc_root *root = &scan->asked->surface.root;
  int64_t d[3];
  FC_TALLY(FC_DECIDE_LIT, true);
  (void)meet(scan, row, column, d, root);
  fc_segment_from(segment, root, d, scan->frame->lights);
  return kind->blocked(occluder, segment);
}

FC_COLD int8_t fc_scan_far(const fc_scan *scan, uint16_t row, uint16_t column, uint32_t p, uint32_t error) {
  /* near / z = p / 2^30 and |D| far = z |D| / F: within iff p^2 far^2 F^2 >= 2^60 near^2 |D|^2. As far_scale is
   * near^2 2^60 / (far^2 F^2) times 2^(28 - far_shift): p^2 / 2^28 against |D|^2 far_scale. */
  const fc_frame *frame = scan->frame;
  int64_t d[3];
  uint64_t squares, limit, have = fc_mul32(p, p) >> 8; /* p up to 2^30: below 2^52 */
  uint8_t s = frame->far_shift;
  if (frame->scene.far_limit == 0) return 1;
  if (s == FC_FAR_EXACT) return 0;
  fc_view_direction(frame, (uint16_t)(scan->x + column), (uint16_t)(scan->y + row), d);
  /* D within 2^30: below 3 * 2^60, and 32 + 32 bits */
  squares = (uint64_t)(fc_smul32((int32_t)d[0], (int32_t)d[0]) + fc_smul32((int32_t)d[1], (int32_t)d[1]) +
                       fc_smul32((int32_t)d[2], (int32_t)d[2]));
  limit = fc_mul32((uint32_t)(squares >> 30), frame->far_scale) >> s;
  {
    /* relative errors below 2^-27 in all, the square cut by 1, and 2 p error + error^2 from p */
    uint64_t slack = (limit >> 22) + ((uint64_t)frame->far_scale >> s) + (((uint64_t)2 * p + error) * error >> 8) + 4;
    if (have > limit + slack) return 1;
    if (have + slack < limit) return -1;
  }
  return 0;
}

/* ---- depth ---- */

FC_COLD void fc_coder_start(fc_coder *coder, const fc_frame *frame, int16_t drop, uint32_t p) {
  /* p in 2^29 .. 2^30-1 with no drop is the highest octave, number 2^e_bits - 1 */
  uint8_t e_bits = frame->depth_exponent_bits, m_bits = (uint8_t)(16 - e_bits);
  int32_t octave = (INT32_C(1) << e_bits) - 1 - drop;
  coder->low = UINT32_C(1) << 29;
  coder->shift = (uint8_t)(29 - m_bits);
  coder->half = UINT32_C(1) << (coder->shift - 1);
  coder->low_bits = 2 * coder->half - 1;
  coder->base = (octave - 1) * (INT32_C(1) << m_bits);
  fc_coder_follow(coder, frame, p);
}

/* Whether values from `low` on are within the far limit for certain; far_high of 1 and more says that none is. */
static bool within_far(const fc_frame *frame, int32_t low, int32_t margin, uint8_t gain) {
  if (low <= margin || frame->far_high >> 30 != 0) return false;
  return (low - margin) >> (30 - gain) != 0 || (uint32_t)(low - margin) << gain > frame->far_high;
}

/* One pixel of a row that may need care: the far limit, another octave, a rounding left open. */
static FC_COLD bool affine_pixel(const fc_scan *scan, uint16_t row, uint16_t column, int32_t p, uint8_t gain, uint32_t error,
                                 bool clip, fc_coder *coder) {
  const int32_t margin = (int32_t)error, limit = INT32_C(1) << (30 - gain);
  uint16_t *depth = fc_scan_depth(scan, row, column);
  int32_t code = -1;
  if (p < -margin) return false;
  if (p > margin) {
    if (clip && !within_far(scan->frame, p, margin, gain)) {
      int8_t within = 0;
      if (p < limit) {
        uint32_t q30 = (uint32_t)p << gain;
        if (q30 + (error << gain) < scan->frame->far_low) return false;
        within = fc_scan_far(scan, row, column, q30, error << gain);
      }
      if (within < 0) return false;
      if (within == 0) return fc_scan_exact(scan, row, column);
    }
    fc_coder_follow(coder, scan->frame, (uint32_t)p);
    code = fc_coder_code(coder, (uint32_t)p, error);
    if (code >= 0 && code != *depth) {
      if (code < *depth) return false;
      *depth = (uint16_t)code;
      return true;
    }
  }
  return fc_scan_exact(scan, row, column);
}

/* Up to 32 pixels in one octave and within the far limit, as depth codes with 16 fraction bits, half and open / 2 added;
 * returns those shown: 1 is the first. What only the ray engine can tell is left in *asked: nothing is called in the loop, which
 * leaves it all registers. */
static FC_HOT uint32_t affine_codes(uint16_t *restrict depth, uint8_t count, uint32_t at, uint32_t step, uint32_t open,
                                    uint32_t *restrict asked) {
  const uint8_t spare = (uint8_t)(32 - count);
  /* the last pixel's is the highest bit, so that the loop ends when the bit is shifted out */
  uint32_t bits = 0, rare = 0, bit = UINT32_C(1) << spare;
  open <<= 16;
  do {
    const uint32_t code = at >> 16;
    if (FC_RARELY(at << 16 <= open)) {
      rare |= bit;
    } else if (code > *depth) {
      *depth = (uint16_t)code;
      bits |= bit;
    } else if (FC_RARELY(code == *depth)) {
      rare |= bit;
    }
    at += step;
    depth++;
    bit <<= 1;
  } while (bit != 0);
  *asked = rare >> spare;
  return bits >> spare;
}

/* Those of some pixels that the ray engine finds shown. */
static FC_COLD uint32_t ask_each(const fc_scan *scan, uint16_t row, uint16_t column, uint32_t pixels) {
  uint32_t bits = 0, bit = 1;
  for (; pixels != 0; pixels >>= 1, bit <<= 1, column++)
    if ((pixels & 1) && fc_scan_exact(scan, row, column)) bits |= bit;
  return bits;
}

/* Depth codes of pixels in one octave, with 16 fraction bits, half and open / 2 added, and the step between them. */
typedef struct affine_form {
  uint32_t at, step, open;
} affine_form;

/* A level row has one depth, so one question will do. */
static FC_COLD void ask_level(const fc_scan *scan, uint16_t row, uint16_t column, affine_form *form) {
  int64_t d[3];
  uint16_t code;
  FC_TALLY(FC_DECIDE_PIXEL, true);
  if (!code_at(scan, row, column, d, &code)) return;
  form->at = ((uint32_t)code << 16) + 0x8000u;
  form->open = 0;
}

static void set_codes(affine_form *form, uint64_t at, int64_t step, uint16_t count, uint32_t error, const fc_coder *coder) {
  /* p / 2^shift in 2^-16; p has 32 fraction bits, of which shift + 16 are dropped */
  const uint8_t drop = (uint8_t)(16 + coder->shift);
  int64_t rounded;
  uint32_t rest;
  form->at = (uint32_t)(at >> drop) + ((uint32_t)coder->base << 16);
  rounded = fc_floor_shift64(step + (INT64_C(1) << (drop - 1)), drop);
  form->step = (uint32_t)(uint64_t)rounded;
  /* what rounding takes from a step, at most half: 2^-8 of a unit, floored */
  rest = (uint32_t)(fc_abs64(fc_to_i64((uint64_t)step - ((uint64_t)rounded << drop))) >> (drop - 8));
  /* twice: the error of p, a floor, and the steps' */
  form->open = 2 * ((uint32_t)(((uint64_t)error << 16) >> coder->shift) + 2) + ((rest + 1) * count >> 7) + 1;
  form->at += 0x8000u + form->open / 2;
  if (form->open > 0x8000u) form->open = 0xffffu; /* as fc_coder_open */
}

/* Values of p that pixels of one kind have: hidden, missed or beyond the far limit for certain; or within it, in one octave below
 * saturation. near / z is monotone along a row, so a run whose ends are of a kind is of that kind. */
typedef struct affine_kind {
  int32_t low, high;
  bool hidden;
} affine_kind;

/* The kind of a pixel with this p, to which the coder is set; false when it needs a look of its own. `hidden`: below it nothing
 * shows, `sure`: from it on the far limit is out of play. */
static bool kind_of(const fc_frame *frame, int32_t p, int32_t hidden, int32_t sure, fc_coder *coder, affine_kind *kind) {
  uint32_t last;
  kind->low = INT32_MIN;
  kind->high = hidden - 1;
  kind->hidden = true;
  if (p < hidden) return true;
  if (p < sure) return false;
  fc_coder_follow(coder, frame, (uint32_t)p);
  /* codes from 1 to 65533 */
  if (coder->base < 1 || coder->base >= UINT16_MAX - 1) return false;
  last = 2 * coder->low - 1;
  if (coder->base + (int32_t)(last >> coder->shift) >= UINT16_MAX - 1)
    last = ((uint32_t)(UINT16_MAX - 1 - coder->base) << coder->shift) - 1;
  kind->low = (int32_t)coder->low > sure ? (int32_t)coder->low : sure;
  kind->high = last > INT32_MAX ? INT32_MAX : (int32_t)last;
  kind->hidden = false;
  return p >= kind->low && p <= kind->high;
}

static bool of_kind(const affine_kind *kind, uint64_t at) {
  int32_t p = fc_to_i32((uint32_t)(at >> 32));
  return p >= kind->low && p <= kind->high;
}

/* About the last of a kind among less than `end` pixels, bit by bit: steps are floored, so that it may be off by some. */
static uint16_t last_of_kind(const affine_kind *kind, uint64_t at, int64_t step, uint16_t end) {
  /* below the span as unsigned numbers: within it */
  const uint32_t span = (uint32_t)kind->high - (uint32_t)kind->low, from = (uint32_t)(at >> 32) - (uint32_t)kind->low;
  const uint32_t move = (uint32_t)fc_high_word(step);
  uint16_t count = 0, part;
  for (part = 256; part != 0; part >>= 1) {
    const uint16_t n = (uint16_t)(count + part);
    if (n < end && from + move * n <= span) count = n;
  }
  return count;
}

/* The row's pixels from `column` on, by words. */
static void affine_plain(fc_scan *scan, uint16_t row, uint16_t column, uint16_t count, affine_form *form) {
  uint32_t *mask = scan->mask + row * scan->words + (column >> 5);
  uint16_t *depth = fc_scan_depth(scan, row, column);
  while (count != 0) {
    uint8_t some = (uint8_t)(32 - (column & 31));
    uint32_t bits, asked;
    if (some > count) some = (uint8_t)count;
    bits = affine_codes(depth, some, form->at, form->step, form->open, &asked);
    if (asked != 0) bits |= ask_each(scan, row, column, asked);
    *mask++ |= bits << (column & 31);
    form->at += form->step * some;
    depth += some;
    column = (uint16_t)(column + some);
    count = (uint16_t)(count - some);
  }
}

FC_COLD void fc_scan_affine(fc_scan *scan, uint16_t row, uint16_t first, uint16_t last, int64_t value, int64_t step,
                            uint8_t gain, uint32_t error, fc_coder *coder) {
  const fc_frame *frame = scan->frame;
  const int32_t margin = (int32_t)error;
  int32_t hidden = -margin, sure = margin + 1;
  uint64_t at = (uint64_t)value;
  uint16_t column = first;
  if (scan->clip_far) {
    /* p + margin times 2^gain below far_low; p - margin above far_high, or never */
    int32_t beyond = (int32_t)(frame->far_low >> gain) - margin, within = INT32_MAX;
    if (frame->far_high >> 30 == 0) within = (int32_t)(frame->far_high >> gain) + margin + 1;
    if (beyond > hidden) hidden = beyond;
    if (within > sure) sure = within;
  }
  while (column <= last) {
    uint16_t count = (uint16_t)(last - column); /* and one */
    uint64_t next;
    affine_kind kind;
    bool known = kind_of(frame, fc_high_word(fc_to_i64(at)), hidden, sure, coder, &kind);
    if (count > 511) count = 511;
    if (!known) {
      if (affine_pixel(scan, row, column, fc_high_word(fc_to_i64(at)), gain, error, scan->clip_far, coder))
        scan->mask[row * scan->words + column / 32] |= UINT32_C(1) << (column % 32);
      column++;
      at += (uint64_t)step;
      continue;
    }
    next = at + fc_times((uint64_t)step, count);
    if (!of_kind(&kind, next)) {
      count = last_of_kind(&kind, at, step, count);
      next = at + fc_times((uint64_t)step, count);
      while (!of_kind(&kind, next)) { /* ends at 0, which is */
        count--;
        next -= (uint64_t)step;
      }
    }
    count++;
    if (!kind.hidden) {
      affine_form form;
      set_codes(&form, at, step, count, error, coder);
      if (step == 0 && (form.at & 0xffffu) <= form.open) ask_level(scan, row, column, &form);
      affine_plain(scan, row, column, count, &form);
    }
    at = next + (uint64_t)step;
    column = (uint16_t)(column + count);
  }
}

/* ---- colour ---- */

void fc_scan_unlit(const fc_scan *scan, uint16_t row, uint16_t column, uint32_t bits) {
  uint8_t *to = fc_scan_pixel(scan, row, column);
  const uint8_t step = scan->pixel_bytes, first = scan->tint.unlit[0], second = scan->tint.unlit[1], third = scan->tint.unlit[2];
  for (; bits != 0; bits >>= 1, to += step) {
    if (!(bits & 1)) continue;
    to[0] = first;
    to[1] = second;
    if (step == 3) to[2] = third;
  }
}

FC_COLD void fc_tint_put_any(const fc_tint *tint, uint32_t cosine, uint8_t *to) {
  uint8_t level[3], i;
  for (i = 0; i < 3; i++) {
    if (tint->transfer != NULL) {
      /* 31 bits: 255 levels with FC_TINT_BITS of fraction are light in Q23 times 255 */
      level[i] = fc_pixel_transfer(tint->transfer, tint->base[i] + tint->slope[i] * cosine, 255, tint->most[i]);
    } else {
      uint32_t v = fc_tint_level(tint, i, cosine);
      level[i] = v > tint->most[i] ? tint->most[i] : (uint8_t)v;
    }
  }
  fc_pixel_put(tint->format, level, to);
}

void fc_scan_lit(const fc_scan *scan, uint16_t row, uint16_t column, uint32_t bits) {
  uint32_t *lit;
  if (scan->target->lit == NULL) return;
  lit = scan->target->lit + (size_t)(scan->y - scan->strip + row) * scan->frame->width + scan->x + column;
  for (; bits != 0; bits >>= 1, lit++)
    if (bits & 1) *lit = 1;
}

FC_COLD void fc_scan_shade_slowly(const fc_scan *scan, uint16_t row, uint16_t column, uint32_t bits) {
  size_t at = (size_t)(scan->y - scan->strip + row) * scan->frame->width + scan->x + column;
  fc_surface *surface = &scan->asked->surface;
  for (; bits != 0; bits >>= 1, column++, at++) {
    int64_t d[3];
    uint64_t radiance_q39[3];
    uint32_t lit;
    if (!(bits & 1)) continue;
    if (scan->light == FC_LIGHT_ONE) FC_TALLY(FC_DECIDE_LIT, true); /* elsewhere no form promises to */
    surface_at(scan, row, column, d, surface);
    fc_shade(scan->frame, &scan->space, surface, radiance_q39, &lit);
    fc_shade_put(scan->frame, radiance_q39, scan->target->format, fc_scan_pixel(scan, row, column));
    if (scan->target->lit != NULL) scan->target->lit[at] = lit;
  }
}

bool fc_scan_wants_light(const fc_scan *scan, uint16_t row, uint16_t column, uint32_t bits) {
  size_t at = (size_t)(scan->y - scan->strip + row) * scan->frame->width + scan->x + column;
  uint32_t b;
  if (scan->target->primitive != NULL) {
    uint16_t *primitive = scan->target->primitive + at;
    for (b = bits; b != 0; b >>= 1, primitive++)
      if (b & 1) *primitive = scan->primitive;
  }
  if (scan->target->lit != NULL) {
    uint32_t *lit = scan->target->lit + at;
    for (b = bits; b != 0; b >>= 1, lit++)
      if (b & 1) *lit = 0;
  }
  if (scan->light == FC_LIGHT_ONE) return true;
  if (scan->light == FC_LIGHT_NONE)
    fc_scan_unlit(scan, row, column, bits);
  else
    fc_scan_shade_slowly(scan, row, column, bits);
  return false;
}

/* Reflectance times light, both Q15, in levels with FC_TINT_BITS of fraction, rounded; below 2^32 or it saturates. */
static FC_COLD uint32_t levels(uint16_t reflectance, uint64_t light, uint8_t most, uint8_t down) {
  /* 17 + 56 bits would overflow: lights that bright are cut */
  uint64_t product;
  if (light <= UINT16_MAX && reflectance <= FC_ONE_Q15) {
    /* 15 + 16 bits; 24 + 8 */
    return (((uint32_t)reflectance * (uint32_t)light >> 7) * most) >> down;
  }
  if (light >> 40) return UINT32_MAX;
  product = (uint64_t)reflectance * light >> 7; /* Q23 */
  if (product >> 40) return UINT32_MAX;
  product = (product * most) >> down;
  return product > UINT32_MAX ? UINT32_MAX : (uint32_t)product;
}

/* The level of a reflectance under ambient light, both at most 1: 15 + 16 bits; 24 + 8. */
static inline uint8_t short_level(uint16_t reflectance, uint16_t ambient, uint8_t most) {
  uint32_t level = ((uint32_t)reflectance * ambient >> 7) * most;
  return (uint8_t)((level + (UINT32_C(1) << (FC_TINT_BITS - 1))) >> FC_TINT_BITS);
}

/* Final colours of a frame without lights; false when they may exceed the format. */
static bool flat_tint(const fc_frame *frame, fc_tint *tint, const fc_material *material, uint8_t format) {
  const fc_rgb *c = &material->diffuse, *a = &frame->scene.ambient;
  uint8_t level[3];
  if (c->r > FC_ONE_Q15 || c->g > FC_ONE_Q15 || c->b > FC_ONE_Q15 || a->r > FC_ONE_Q15 || a->g > FC_ONE_Q15 || a->b > FC_ONE_Q15)
    return false;
  level[0] = short_level(c->r, a->r, tint->most[0]);
  level[1] = short_level(c->g, a->g, tint->most[1]);
  level[2] = short_level(c->b, a->b, tint->most[2]);
  fc_pixel_put(format, level, tint->unlit);
  return true;
}

FC_COLD uint32_t fc_scan_slope(const fc_scan *scan, uint16_t reflectance, uint8_t channel) {
  /* the cosine's 16 bits come off the slope; its half lost is 2^-8 level */
  const uint8_t top = scan->tint.transfer != NULL ? 255 : scan->tint.most[channel];
  return (levels(reflectance, scan->frame->light_level[channel], top, 15) + 1) >> 1;
}

/* Names what draws the material's layers by fast forms; false when nothing does. */
static FC_COLD bool find_coat(fc_scan *scan, const fc_material *material) {
  fc_layer layer;
  fc_layer_kind layer_kind;
  fc_coat_layer coat;
  fc_coat_kind kind;
  FC_READ_ONE(&layer, material->layers);
  FC_READ_ONE(&layer_kind, layer.kind);
  if (layer_kind.coat == NULL) return false;
  FC_READ_ONE(&coat, layer_kind.coat);
  FC_READ_ONE(&kind, coat.kind);
  scan->coat = coat.kind;
  return kind.fits(scan, material);
}

/* What the primitive's material makes of the light. */
FC_COLD void fc_scan_tint(fc_scan *scan) {
  const fc_frame *frame = scan->frame;
  fc_tint *tint = &scan->tint;
  uint16_t diffuse[3], ambient[3];
  uint8_t i, level[3];
  bool coats;
#ifdef FC_ROM_FAR
  fc_material copy;
  const fc_material *material = &copy;
  FC_READ_ONE(&copy, frame->scene.materials + scan->form->material);
#else
  const fc_material *material = frame->scene.materials + scan->form->material; /* a triangle's colour: no copy of its layers */
#endif
  scan->light = material->layer_count == 0 ? frame->light : FC_LIGHT_MANY;
  coats = material->layer_count != 0 && frame->light == FC_LIGHT_ONE;
  scan->coat = NULL;
  tint->transfer = frame->options.transfer;
  if (scan->light == FC_LIGHT_NONE && tint->transfer == NULL && flat_tint(frame, tint, material, scan->target->format)) return;
  diffuse[0] = material->diffuse.r;
  diffuse[1] = material->diffuse.g;
  diffuse[2] = material->diffuse.b;
  ambient[0] = frame->scene.ambient.r;
  ambient[1] = frame->scene.ambient.g;
  ambient[2] = frame->scene.ambient.b;
  tint->clamp = false;
  for (i = 0; i < 3; i++) {
    const uint8_t top = tint->transfer != NULL ? 255 : tint->most[i];
    uint32_t unlit = levels(diffuse[i], ambient[i], top, 0), most = (uint32_t)top << FC_TINT_BITS;
    if (unlit > most) unlit = most;
    if (tint->transfer != NULL) {
      tint->base[i] = unlit;
      level[i] = fc_pixel_transfer(tint->transfer, unlit, 255, tint->most[i]);
    } else {
      tint->base[i] = unlit + (UINT32_C(1) << (FC_TINT_BITS - 1));
      level[i] = (uint8_t)(tint->base[i] >> FC_TINT_BITS);
    }
    if (frame->light == FC_LIGHT_ONE) {
      uint32_t slope = fc_scan_slope(scan, diffuse[i], i);
      if (slope >= UINT32_C(0x8000)) {
        scan->light = FC_LIGHT_MANY;
        coats = false;
        slope = 0;
      }
      tint->slope[i] = slope;
      if (tint->base[i] + (slope << 16) >= most + (UINT32_C(1) << FC_TINT_BITS)) tint->clamp = true;
    }
  }
  tint->plain = !tint->clamp && tint->format == FC_RGB565_BE && tint->transfer == NULL;
  fc_pixel_put(scan->target->format, level, tint->unlit);
  if (!coats) return;
  if (find_coat(scan, material))
    scan->light = FC_LIGHT_ONE;
  else
    scan->coat = NULL;
}

/* ---- strips ---- */

static FC_COLD void draw(fc_scan *scan, uint16_t rows) {
  const fc_window *box = &scan->box;
  int32_t strip_end = (int32_t)scan->strip + rows - 1, x;
  for (x = box->x0; x <= box->x1; x += FC_SCAN_WORDS * 32) {
    int32_t columns = box->x1 - x + 1, y, end, high = FC_SCAN_ROWS;
    if (columns > FC_SCAN_WORDS * 32) columns = FC_SCAN_WORDS * 32;
    scan->words = (uint8_t)((columns + 31) / 32);
    while (high * scan->words > FC_SCAN_WORDS) high /= 2; /* a power of two */
    scan->x = (uint16_t)x;
    scan->columns = (uint16_t)columns;
    /* bands of the frame, cut to the window */
    for (y = box->y0; y <= box->y1 && y <= strip_end; y = end + 1) {
      end = y | (high - 1);
      if (end > box->y1) end = box->y1;
      if (end < scan->strip) continue;
      scan->y = (uint16_t)y;
      scan->rows = (uint8_t)(end - y + 1);
      scan->first_row = (uint8_t)(y < scan->strip ? scan->strip - y : 0);
      scan->last_row = (uint8_t)((end < strip_end ? end : strip_end) - y);
      fc_kind_of(scan->at)->draw(scan);
    }
  }
}

/* Fills memory with a pattern of two 16-bit values, words at a time where it is aligned. */
static FC_HOT void fill_pairs(uint8_t *to, size_t bytes, const uint8_t pattern[4]) {
  uint8_t *end = to + bytes;
  uint32_t word;
  memcpy(&word, pattern, sizeof word);
  if ((uintptr_t)to % 4 == 0) {
    for (; end - to >= 16; to += 16) {
      memcpy(FC_ALIGNED4(to), &word, sizeof word);
      memcpy(FC_ALIGNED4(to + 4), &word, sizeof word);
      memcpy(FC_ALIGNED4(to + 8), &word, sizeof word);
      memcpy(FC_ALIGNED4(to + 12), &word, sizeof word);
    }
  }
  for (; end - to >= 2; to += 2) {
    to[0] = pattern[0];
    to[1] = pattern[1];
  }
}

/* Pixels of the background's bytes. */
static FC_COLD void fill_background(const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target) {
  const uint8_t pixel_bytes = target->format == FC_RGB888 ? 3 : 2;
  const uint8_t format = pixel_bytes == 3 ? FC_RGB888 : FC_RGB565_BE; /* as fc_strip_finish wants it */
  uint64_t radiance_q39[3];
  uint16_t x, row;
  uint8_t bytes[4];
  if (frame->scene.sky != NULL) {
    fc_target drawn = *target;
    fc_sky sky;
    fc_sky_kind kind;
    FC_READ_ONE(&sky, frame->scene.sky);
    FC_READ_ONE(&kind, sky.kind);
    drawn.format = format;
    kind.fill(frame, &sky, y, rows, &drawn);
    return;
  }
  fc_shade_background(frame, NULL, radiance_q39);
  fc_shade_put(frame, radiance_q39, format, bytes);
  if (pixel_bytes == 2) {
    bytes[2] = bytes[0];
    bytes[3] = bytes[1];
  }
  if (pixel_bytes == 2 && target->pitch_bytes == 2 * (size_t)frame->width) {
    fill_pairs((uint8_t *)target->pixels, 2 * (size_t)rows * frame->width, bytes);
    return;
  }
  for (row = 0; row < rows; row++) {
    uint8_t *to = (uint8_t *)target->pixels + row * target->pitch_bytes;
    if (pixel_bytes == 2) {
      fill_pairs(to, 2 * (size_t)frame->width, bytes);
      continue;
    }
    for (x = 0; x < frame->width; x++, to += 3) {
      to[0] = bytes[0];
      to[1] = bytes[1];
      to[2] = bytes[2];
    }
  }
}

FC_COLD void fc_strip_clear(const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target) {
  static const uint8_t zero[4] = {0, 0, 0, 0}, ones[4] = {0xff, 0xff, 0xff, 0xff};
  size_t pixels = (size_t)rows * frame->width;
  fill_pairs((uint8_t *)target->depth, 2 * pixels, zero);
  if (target->primitive != NULL) fill_pairs((uint8_t *)target->primitive, 2 * pixels, ones);
  if (target->lit != NULL) fill_pairs((uint8_t *)target->lit, 4 * pixels, zero);
  fill_background(frame, y, rows, target);
}

FC_COLD int fc_render_check(const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target) {
  int pixel_bytes;
  if (frame == NULL || target == NULL || target->pixels == NULL || target->depth == NULL) return FC_ERR_NULL;
  pixel_bytes = fc_format_bytes(target->format);
  if (pixel_bytes < 0) return pixel_bytes;
  if (rows < 1 || y >= frame->height || rows > frame->height - y ||
      target->pitch_bytes < (size_t)frame->width * (size_t)pixel_bytes)
    return FC_ERR_SIZE;
  return pixel_bytes;
}

FC_COLD void fc_scan_item(fc_scan *scan, uint16_t index, uint16_t rows) {
  const fc_group *group = &scan->at->group;
  const fc_kind *kind = fc_kind_of(scan->at);
  if (!kind->window(scan->frame, group, index, &scan->box)) return;
  if (scan->box.y1 < (int32_t)scan->strip || scan->box.y0 > (int32_t)scan->strip + rows - 1) return;
  kind->fetch(group, index, &scan->item);
  scan->form = &scan->item;
  scan->index = index;
  scan->primitive = (uint16_t)(group->first + index);
  fc_scan_tint(scan);
  draw(scan, rows);
}

FC_COLD void fc_scan_each(fc_scan *scan, uint16_t rows) {
  uint16_t index;
  for (index = 0; index < scan->at->group.shapes.count; index++) fc_scan_item(scan, index, rows);
}

FC_COLD void fc_strip_finish(const fc_frame *frame, uint16_t rows, const fc_target *target) {
  uint16_t x, y;
  if (target->format != FC_RGB565_LE) return;
  for (y = 0; y < rows; y++) {
    uint8_t *at = (uint8_t *)target->pixels + y * target->pitch_bytes;
    for (x = 0; x < frame->width; x++, at += 2) {
      uint8_t first = at[0];
      at[0] = at[1];
      at[1] = first;
    }
  }
}

FC_COLD void fc_strip_draw(fc_scan *scan, const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target, uint8_t skip) {
  fc_cursor *cursor = &scan->cursor;
  scan->frame = frame;
  scan->drawn = *target;
  /* inner loops know one order of bytes */
  if (target->format == FC_RGB565_LE) scan->drawn.format = FC_RGB565_BE;
  scan->target = &scan->drawn;
  scan->at = cursor;
  scan->asked = &scan->answer;
  scan->strip = y;
  scan->skip = skip;
  scan->clear = false;
  scan->pixel_bytes = target->format == FC_RGB888 ? 3 : 2;
  scan->clip_far = frame->scene.far_limit > 0;
  fc_pixel_most(scan->drawn.format, scan->tint.most);
  scan->tint.format = scan->drawn.format;
  scan->space = fc_space_of_frame(frame);
  scan->space.room = &scan->answer.room;
  fc_cursor_start(cursor, &scan->space);
  while (fc_cursor_next(cursor)) fc_kind_of(cursor)->strip(scan, rows);
}

typedef char fc_scratch_is_large[sizeof(fc_scan) <= sizeof(fc_scratch) ? 1 : -1];

FC_COLD int fc_render_rows_in(fc_scratch *scratch, const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target) {
  const int pixel_bytes = fc_render_check(frame, y, rows, target);
  if (pixel_bytes < 0) return pixel_bytes;
  if (scratch == NULL) return FC_ERR_NULL;
  fc_strip_clear(frame, y, rows, target);
  fc_strip_draw((fc_scan *)(void *)scratch, frame, y, rows, target, FC_SKIP_NONE);
  fc_strip_finish(frame, rows, target);
  return FC_OK;
}

FC_COLD int fc_render_rows(const fc_frame *frame, uint16_t y, uint16_t rows, const fc_target *target) {
  fc_scratch scratch;
  return fc_render_rows_in(&scratch, frame, y, rows, target);
}
