/* The scan engine on triangles: spans of edge forms, depth by an affine near / z. */
#include <string.h>

#include "facet.h"
#include "planar.h"
#include "scan_kinds.h"

/* A vertex on the screen: neighbours share it. */
#define FC_SPOTS 8
#define FC_NO_VERTEX UINT16_C(0xffff) /* indices are less than a count of 16 bits */

typedef struct fc_spot {
  int32_t x, y;
  uint32_t near; /* as in fc_corners */
  uint16_t vertex;
  uint8_t exponent;
} fc_spot;

/* A triangle being drawn. */
typedef struct fc_brush { /* what is used most comes first: chips with short instructions reach it at once */
  fc_scan *scan;
  bool fetched; /* form holds the vertices */
  bool plain;   /* colours are final, two bytes each, and nothing else is wanted: pixels are written at once */
  bool clip;    /* the far limit may cut it */
  bool steep;   /* no affine depth */
  bool even;    /* a small triangle: in one octave and within the far limit */
  bool tinted;  /* scan->tint is that of this material */
  uint8_t high; /* tiles lie in bands of the frame, of so many rows, a power of two */
  uint16_t material;
  uint16_t colour;         /* the unlit pixel as it lies in memory */
  int16_t coder_drop;      /* what the coder was started for, or out of range */
  uint32_t open;           /* of a depth code with 16 fraction bits: up to here its rounding is open */
  uint32_t zero, step;     /* of an even triangle: the code of p = 0, with half and open / 2; a column's step */
  int32_t top, bottom;     /* rows that the whole triangle may touch */
  fc_spot spots[FC_SPOTS]; /* vertex v is kept in spot v % FC_SPOTS */
  fc_coder coder;
  fc_facet facet;
  fc_form form;
} fc_brush;

static void set_tint(fc_brush *brush) {
  uint8_t *colour = (uint8_t *)&brush->colour;
  if (brush->tinted && brush->material == brush->form.material) return;
  fc_scan_tint(brush->scan);
  brush->tinted = true;
  colour[0] = brush->scan->tint.unlit[0];
  colour[1] = brush->scan->tint.unlit[1];
  brush->material = brush->form.material;
}

static FC_COLD void fetch(fc_brush *brush) {
  if (brush->fetched) return;
  fc_triangle_fetch(&brush->scan->at->group, brush->scan->index, &brush->form);
  brush->fetched = true;
}

static void show(fc_brush *brush, uint16_t row, uint16_t column) {
  fc_scan *scan = brush->scan;
  if (brush->plain)
    fc_scan_unlit(scan, row, column, 1);
  else
    scan->mask[row * scan->words + column / 32] |= UINT32_C(1) << (column % 32);
}

/* A pixel that only the ray engine decides. */
static FC_COLD void ask(fc_brush *brush, uint16_t row, uint16_t column) {
  fetch(brush);
  if (fc_scan_exact(brush->scan, row, column)) show(brush, row, column);
}

/* near / z in Q30, of the form's values; false when it does not fit. */
static bool q30_of(uint32_t p, int16_t drop, uint32_t *q) {
  if (drop < -12 || drop > 30) return false;
  if (drop < 0 && p >> (32 + drop) != 0) return false;
  *q = drop < 0 ? p << -drop : p >> drop;
  return true;
}

/* A pixel inside the triangle, with everything that may happen to it. */
static FC_NOINLINE void careful_pixel(fc_brush *brush, uint16_t row, uint16_t column, uint32_t p) {
  const fc_frame *frame = brush->scan->frame;
  uint32_t error = brush->facet.error;
  int32_t code;
  uint16_t *depth = fc_scan_depth(brush->scan, row, column);
  if (brush->steep || p <= error || p >> 30 == 3) {
    ask(brush, row, column);
    return;
  }
  if (brush->clip) {
    int8_t within = 0;
    uint32_t q, e;
    if (q30_of(p, brush->facet.drop, &q) && q30_of(error, brush->facet.drop, &e)) {
      e += 2;
      if (q + e < frame->far_low) return;
      within = q > e && q - e > frame->far_high ? 1 : q >> 30 == 0 ? fc_scan_far(brush->scan, row, column, q, e)
                                                                   : 0;
    }
    if (within < 0) return;
    if (within == 0) {
      ask(brush, row, column);
      return;
    }
  }
  fc_coder_follow(&brush->coder, frame, p);
  code = fc_coder_code(&brush->coder, p, error);
  if (code < 0 || code == *depth) {
    ask(brush, row, column);
  } else if (code > *depth) {
    *depth = (uint16_t)code;
    show(brush, row, column);
  }
}

/* Asks for the pixel whose depth this is. */
static FC_COLD void ask_at(fc_brush *brush, const uint16_t *depth) {
  uint32_t offset = (uint32_t)(depth - fc_scan_depth(brush->scan, 0, 0)), width = brush->scan->frame->width;
  uint16_t row = 0;
  for (; offset >= width; offset -= width) row++;
  ask(brush, row, (uint16_t)offset);
}

/* Codes with 16 fraction bits, half and brush->open / 2 added: the pixels between depth and end. */
static FC_NOINLINE void paint(fc_brush *brush, uint16_t *depth, const uint16_t *end, uint8_t *to, uint32_t at, uint32_t step) {
  const uint32_t open = brush->open;
  const uint16_t colour = brush->colour;
  do {
    uint32_t code = at >> 16, there = *depth;
    if (code >= there) { /* rounded upwards where it is open: what is below is hidden */
      if ((at & 0xffffu) <= open || code == there) {
        ask_at(brush, depth);
      } else {
        *depth = (uint16_t)code;
        memcpy(FC_ALIGNED2(to), &colour, sizeof colour);
      }
    }
    at += step;
    to += 2;
  } while (++depth != end);
}

/* The same for up to 32 pixels, as bits of those shown: 1 is the first. */
static FC_NOINLINE uint32_t paint_mask(fc_brush *brush, uint16_t *depth, const uint16_t *end, uint32_t at, uint32_t step) {
  const uint32_t open = brush->open;
  uint32_t bits = 0, bit = 1;
  do {
    uint32_t code = at >> 16, there = *depth;
    if (code >= there) { /* rounded upwards where it is open: what is below is hidden */
      if ((at & 0xffffu) <= open || code == there) {
        ask_at(brush, depth);
      } else {
        *depth = (uint16_t)code;
        bits |= bit;
      }
    }
    at += step;
    bit <<= 1;
  } while (++depth != end);
  return bits;
}

/* What p and its steps become in depth codes with 16 fraction bits: floors. The first without the coder's base. */
static inline uint32_t code_part(const fc_coder *coder, uint32_t p) {
  return coder->shift >= 16 ? p >> (coder->shift - 16) : p << (16 - coder->shift);
}

static uint32_t code_of(const fc_coder *coder, uint32_t p) { return code_part(coder, p) + ((uint32_t)coder->base << 16); }

static uint32_t code_step(const fc_coder *coder, uint32_t step) {
  int32_t s = fc_to_i32(step);
  if (coder->shift > 16) return (uint32_t)fc_floor_shift32(s + (INT32_C(1) << (coder->shift - 17)), (uint8_t)(coder->shift - 16));
  return step << (16 - coder->shift);
}

/* An error of p, and `steps` steps rounded to 1/2, doubled and rounded up. */
static uint32_t code_open(const fc_coder *coder, uint32_t error, uint32_t steps) {
  return 2 * (coder->shift >= 16 ? (error >> (coder->shift - 16)) + 2 : (error + 1) << (16 - coder->shift)) + steps + 2;
}

/* Sets bits of the mask from a column on. */
static void mark(fc_scan *scan, uint16_t row, uint16_t column, uint32_t bits) {
  uint32_t *mask = scan->mask + row * scan->words + column / 32;
  uint8_t shift = column % 32;
  mask[0] |= bits << shift;
  if (shift != 0 && bits >> (32 - shift) != 0) mask[1] |= bits >> (32 - shift);
}

/* Pixels of a row that are inside for certain; p_row: the form at the row's first column. */
static void span(fc_brush *brush, uint16_t row, uint16_t first, uint16_t last, uint64_t p_row) {
  const uint64_t px = brush->facet.px;
  const uint32_t step = (uint32_t)((px + (UINT32_C(1) << 31)) >> 32), part = (uint32_t)px >> 16;
  while (first <= last) {
    uint16_t count = (uint16_t)(last - first + 1);
    uint32_t p, q, low, high;
    fc_coder *coder = &brush->coder;
    if (count > 32) count = 32;
    /* high words: 16 + 12 bits of the part */
    p = (uint32_t)(p_row >> 32) + (uint32_t)(px >> 32) * first + ((part * first + ((uint32_t)p_row >> 16)) >> 16);
    q = p + step * (uint32_t)(count - 1);
    low = p < q ? p : q;
    high = p < q ? q : p;
    if (!brush->steep && !brush->clip && low > brush->facet.error && !(high >> 31)) {
      fc_coder_follow(coder, brush->scan->frame, p);
      if (low >= coder->low && high >> 1 < coder->low && coder->base + (int32_t)(low >> coder->shift) > 1 &&
          coder->base + (int32_t)(high >> coder->shift) < UINT16_MAX - 1) {
        uint16_t *depth = fc_scan_depth(brush->scan, row, first);
        brush->open = code_open(coder, brush->facet.error, count);
        p = code_of(coder, p) + 0x8000u + brush->open / 2;
        if (brush->open > 0x8000u) brush->open = 0xffffu; /* codes below the octave are twice as fine: see fc_coder_open */
        if (brush->plain)
          paint(brush, depth, depth + count, fc_scan_pixel(brush->scan, row, first), p, code_step(coder, step));
        else
          mark(brush->scan, row, first, paint_mask(brush, depth, depth + count, p, code_step(coder, step)));
        first = (uint16_t)(first + count);
        continue;
      }
    }
    for (; count > 0; count--, p += step) careful_pixel(brush, row, first++, p);
  }
}

/* One or two edges that bound rows on the same side; forms at a column, steps away from it and down. */
typedef struct fc_flank {
  int32_t a, b, ax, bx, ay, by;
} fc_flank;

static void flank_add(fc_flank *flank, int32_t at, int32_t dx, int32_t dy) {
  flank->b = flank->a;
  flank->bx = flank->ax;
  flank->by = flank->ay;
  flank->a = at;
  flank->ax = dx;
  flank->ay = dy;
}

/* The columns of a row that may be inside, and the forms there. */
typedef struct fc_ends {
  fc_flank left, right;
  int32_t from, to, columns;
} fc_ends;

/* Edge forms that add up to a constant: at most two of them rise to the right, at most two fall. */
static void ends_start(fc_ends *ends, const int32_t at[3], const int32_t dx[3], const int32_t dy[3], uint16_t columns) {
  const int32_t never = INT32_C(1) << 30;
  const fc_flank open = {never, never, 0, 0, 0, 0};
  uint8_t i;
  ends->left = ends->right = open;
  ends->from = 0;
  ends->to = columns - 1;
  ends->columns = columns;
  for (i = 0; i < 3; i++) {
    if (dx[i] >= 0)
      flank_add(&ends->left, at[i], dx[i], dy[i]);
    else
      flank_add(&ends->right, at[i] + dx[i] * ends->to, -dx[i], dy[i]);
  }
}

/* The ends of a row are found from those of the row before. */
static inline void ends_find(fc_ends *ends) {
  fc_flank *flank = &ends->left;
  int32_t a = flank->a, b = flank->b, at = ends->from;
  const int32_t stop = ends->columns;
  if ((a | b) < 0) {
    while (at < stop && (a | b) < 0) {
      a += flank->ax;
      b += flank->bx;
      at++;
    }
  } else {
    while (at > 0 && ((a - flank->ax) | (b - flank->bx)) >= 0) {
      a -= flank->ax;
      b -= flank->bx;
      at--;
    }
  }
  flank->a = a;
  flank->b = b;
  ends->from = at;
  flank = &ends->right;
  a = flank->a;
  b = flank->b;
  at = ends->to;
  if ((a | b) < 0) {
    while (at >= 0 && (a | b) < 0) {
      a += flank->ax;
      b += flank->bx;
      at--;
    }
  } else {
    while (at < stop - 1 && ((a - flank->ax) | (b - flank->bx)) >= 0) {
      a -= flank->ax;
      b -= flank->bx;
      at++;
    }
  }
  flank->a = a;
  flank->b = b;
  ends->to = at;
}

static inline void flank_down(fc_flank *flank) {
  flank->a += flank->ay;
  flank->b += flank->by;
}

/* Asks for the pixels of a row that are not inside for certain; the others are *first .. *last. */
static FC_COLD void ask_ends(fc_brush *brush, const fc_ends *ends, int32_t certain, uint16_t row, int32_t *first, int32_t *last) {
  int32_t a = ends->left.a - certain, b = ends->left.b - certain;
  for (; *first <= *last && (a | b) < 0; a += ends->left.ax, b += ends->left.bx) ask(brush, row, (uint16_t)(*first)++);
  a = ends->right.a - certain;
  b = ends->right.b - certain;
  for (; *first <= *last && (a | b) < 0; a += ends->right.ax, b += ends->right.bx) ask(brush, row, (uint16_t)(*last)--);
}

static bool ends_open(const fc_ends *ends, int32_t certain) {
  return ((ends->left.a - certain) | (ends->left.b - certain) | (ends->right.a - certain) | (ends->right.b - certain)) < 0;
}

static FC_NOINLINE void walk_rows(fc_brush *brush, uint16_t columns, uint16_t rows) {
  const fc_facet *facet = &brush->facet;
  uint64_t p = facet->p;
  uint16_t row;
  fc_ends ends;
  ends_start(&ends, facet->at, facet->dx, facet->dy, columns);
  for (row = 0; row < rows; row++, p += facet->py) {
    ends_find(&ends);
    if (ends.from <= ends.to && !fc_scan_skips(brush->scan, row)) {
      int32_t first = ends.from, last = ends.to;
      if (ends_open(&ends, facet->certain)) ask_ends(brush, &ends, facet->certain, row, &first, &last);
      if (first <= last) span(brush, row, (uint16_t)first, (uint16_t)last, p);
    }
    flank_down(&ends.left);
    flank_down(&ends.right);
  }
}

/* One edge that bounds rows: its form at a column, one column further in, one row down. */
typedef struct fc_bound {
  int32_t e, inwards, down;
} fc_bound;

/* The edge between two corners, the first above: at a column and row of the tile. */
static void bound_start(fc_bound *bound, const fc_small_facet *facet, uint8_t a, uint8_t b, bool left, int32_t column,
                        int32_t row) {
  const int32_t dx = facet->x[b] - facet->x[a], dy = facet->y[b] - facet->y[a];
  const int32_t e = fc_product16(column * 65536 - facet->x[a], dy) - fc_product16(row * 65536 - facet->y[a], dx);
  bound->inwards = dy;
  bound->e = (left ? e : -e) + facet->margin;
  bound->down = left ? -dx : dx;
}

/* A small triangle shows a pixel: only now its depth and colour are wanted. False when the form tells too little. */
static FC_NOINLINE bool small_start(fc_brush *brush, const fc_placed_mesh *mesh, fc_small_facet *facet) {
  const fc_frame *frame = brush->scan->frame;
  fc_coder *coder = &brush->coder;
  uint32_t q;
  if (!fc_small_depth(facet, frame, mesh)) return false;
  brush->facet.error = facet->error;
  brush->facet.drop = facet->drop;
  brush->steep = false;
  brush->clip = brush->scan->clip_far && !(q30_of(facet->least, facet->drop, &q) && q > frame->far_high);
  if (brush->coder_drop != facet->drop) {
    fc_coder_start(coder, frame, facet->drop, UINT32_C(1) << 30);
    brush->coder_drop = facet->drop;
  }
  if (facet->most >> 31 == 0) fc_coder_follow(coder, frame, facet->most);
  /* in one octave, short of its ends */
  brush->even = !brush->clip && facet->most >> 31 == 0 && facet->least >= coder->low &&
                coder->base + (int32_t)(facet->least >> coder->shift) > 1 &&
                coder->base + (int32_t)(facet->most >> coder->shift) < UINT16_MAX - 1;
  brush->open = code_open(coder, facet->error, brush->scan->columns);
  brush->zero = ((uint32_t)coder->base << 16) + 0x8000u + brush->open / 2;
  brush->step = code_step(coder, facet->px);
  if (brush->plain) set_tint(brush);
  return true;
}

/*
 * Rows of a small triangle. Between the heights of two corners a row is bounded by one edge on either side; its ends are
 * found from those of the row before. False when the form of its depth tells too little.
 */
static FC_NOINLINE bool walk_small_rows(fc_brush *brush, const fc_placed_mesh *mesh, fc_small_facet *facet, uint16_t columns,
                                        uint16_t rows) {
  fc_scan *scan = brush->scan;
  const int32_t certain = 2 * facet->margin + 1, end = columns;
  int32_t row = fc_floor_shift32(facet->y[0], 16) + 1, middle = fc_floor_shift32(facet->y[1], 16) + 1,
          last_row = fc_floor_shift32(facet->y[2], 16), from = 0, to = columns - 1;
  bool started = false;
  fc_bound left, right;
  if (row < 0) row = 0;
  if (last_row > rows - 1) last_row = rows - 1;
  if (row > last_row) return true;
  if (row < middle) {
    bound_start(&left, facet, 0, facet->left ? 1 : 2, true, from, row);
    bound_start(&right, facet, 0, facet->left ? 2 : 1, false, to, row);
  } else {
    bound_start(&left, facet, facet->left ? 1 : 0, 2, true, from, row);
    bound_start(&right, facet, facet->left ? 0 : 1, 2, false, to, row);
    middle = INT32_MAX;
  }
  for (;;) {
    int32_t e = left.e;
    if (e < 0) {
      do {
        e += left.inwards;
        from++;
      } while (e < 0 && from < end);
    } else {
      while (from > 0 && e - left.inwards >= 0) {
        e -= left.inwards;
        from--;
      }
    }
    left.e = e;
    e = right.e;
    if (e < 0) {
      do {
        e += right.inwards;
        to--;
      } while (e < 0 && to >= 0);
    } else {
      while (to < end - 1 && e - right.inwards >= 0) {
        e -= right.inwards;
        to++;
      }
    }
    right.e = e;
    if (from <= to) {
      int32_t first = from, last = to;
      if (!started) {
        if (!small_start(brush, mesh, facet)) return false;
        started = true;
      }
      for (; first <= last && e < certain; e += right.inwards) last--; /* open ends, asked below */
      for (e = left.e; first <= last && e < certain; e += left.inwards) first++;
      if (first != from || last != to) {
        int32_t column;
        for (column = from; column <= to; column++)
          if (column < first || column > last) ask(brush, (uint16_t)row, (uint16_t)column);
      }
      if (first <= last) {
        /* outside the triangle p may wrap: only what is inside becomes a code */
        uint32_t p = facet->p + facet->py * (uint32_t)row + facet->px * (uint32_t)first;
        if (brush->even) {
          uint16_t *depth = fc_scan_depth(scan, (uint16_t)row, (uint16_t)first);
          const uint16_t *stop = depth + (last - first + 1);
          const uint32_t at = code_part(&brush->coder, p) + brush->zero;
          if (brush->plain)
            paint(brush, depth, stop, fc_scan_pixel(scan, (uint16_t)row, (uint16_t)first), at, brush->step);
          else
            scan->mask[row] |= paint_mask(brush, depth, stop, at, brush->step) << first;
        } else {
          for (; first <= last; first++, p += facet->px) careful_pixel(brush, (uint16_t)row, (uint16_t)first, p);
        }
      }
    }
    if (row == last_row) return true;
    row++;
    left.e += left.down;
    right.e += right.down;
    if (row == middle) {
      if (facet->left)
        bound_start(&left, facet, 1, 2, true, from, row);
      else
        bound_start(&right, facet, 1, 2, false, to, row);
    }
  }
}

/* Rows of any triangle: each end by bisection. */
static FC_COLD void cut_rows(fc_brush *brush, uint16_t columns, uint16_t rows) {
  const fc_facet *facet = &brush->facet;
  int32_t at[3];
  uint64_t p = facet->p;
  uint16_t row;
  uint8_t i;
  for (i = 0; i < 3; i++) at[i] = facet->at[i];
  for (row = 0; row < rows; row++, p += facet->py) {
    int32_t first = 0, last = columns - 1, inner_first, inner_last;
    for (i = 0; i < 3; i++) fc_facet_cut(at[i], facet->dx[i], 0, columns, &first, &last);
    inner_first = first;
    inner_last = last;
    for (i = 0; i < 3; i++) fc_facet_cut(at[i], facet->dx[i], facet->certain, columns, &inner_first, &inner_last);
    if (fc_scan_skips(brush->scan, row)) {
      /* nothing */
    } else if (inner_first > inner_last) {
      for (; first <= last; first++) ask(brush, row, (uint16_t)first);
    } else {
      for (; first < inner_first; first++) ask(brush, row, (uint16_t)first);
      for (; last > inner_last; last--) ask(brush, row, (uint16_t)last);
      span(brush, row, (uint16_t)first, (uint16_t)last, p);
    }
    for (i = 0; i < 3; i++) at[i] += facet->dy[i];
  }
}

/* A tile's triangle is in the mask: colours and light. */
static FC_NOINLINE void finish(fc_brush *brush) {
  fc_scan *scan = brush->scan;
  int64_t n[3];
  uint16_t i;
  uint32_t any = 0;
  for (i = 0; i < scan->rows * scan->words; i++) any |= scan->mask[i];
  if (any == 0) return;
  fetch(brush);
  set_tint(brush);
  {
    /* light's forms start where the triangle's band does, whichever rows of it the strip holds */
    int32_t begin = (int32_t)scan->y & ~((int32_t)brush->high - 1), end = (int32_t)scan->y | ((int32_t)brush->high - 1);
    if (begin < brush->top) begin = brush->top;
    if (end > brush->bottom) end = brush->bottom;
    scan->first_row = (uint8_t)(scan->y - begin);
    scan->last_row = (uint8_t)(scan->first_row + scan->rows - 1);
    /* the last row first, so that none is written over before it has moved */
    for (i = scan->first_row > 0 ? scan->rows : 0; i-- > 0;)
      memcpy(scan->mask + (scan->first_row + i) * scan->words, scan->mask + i * scan->words,
             sizeof scan->mask[0] * scan->words);
    scan->rows = (uint8_t)(end - begin + 1);
    scan->y = (uint16_t)begin;
  }
  fc_face_normal(&brush->form, n);
  fc_planar_light(scan, n, fc_i128_dot(n, brush->form.u.triangle.vertex[0]), brush->form.u.triangle.vertex[0], 3);
}

/* Starts a tile. */
static void aim(fc_brush *brush, const fc_tile *tile) {
  fc_scan *scan = brush->scan;
  uint16_t i;
  scan->x = (uint16_t)tile->x0;
  scan->y = (uint16_t)tile->y0;
  scan->columns = (uint16_t)(tile->x1 - tile->x0 + 1);
  if (brush->plain) return;
  scan->rows = (uint8_t)(tile->y1 - tile->y0 + 1);
  scan->first_row = 0;
  scan->last_row = (uint8_t)(scan->rows - 1);
  scan->words = (uint8_t)((scan->columns + 31) / 32);
  for (i = 0; i < scan->rows * scan->words; i++) scan->mask[i] = 0;
}

/* The largest tile at (x, y) that a band and the masks hold. */
static void next_tile(fc_brush *brush, const fc_tile *box, int32_t x, int32_t y, fc_tile *tile) {
  int32_t rows = box->y1 - y + 1, columns = box->x1 - x + 1;
  if (!brush->plain) {
    /* as high as the widest of the row of tiles may be */
    int32_t high = FC_SCAN_ROWS, widest = box->x1 - box->x0 + 1;
    if (widest > FC_SCAN_WORDS * 32) widest = FC_SCAN_WORDS * 32;
    if (columns > widest) columns = widest;
    while (high * ((widest + 31) / 32) > FC_SCAN_WORDS) high /= 2;
    brush->high = (uint8_t)high;
    high -= y & (high - 1);
    if (rows > high) rows = high;
  }
  tile->x0 = x;
  tile->x1 = x + columns - 1;
  tile->y0 = y;
  tile->y1 = y + rows - 1;
}

/* Whether all of it is within the far limit. */
static bool beyond_doubt(const fc_frame *frame, const fc_facet *facet) {
  uint32_t q;
  return q30_of(facet->least, facet->drop, &q) && q > frame->far_high;
}

/* The coder at the tile's greatest p, and whether the far limit matters. */
static void start_depth(fc_brush *brush) {
  fc_scan *scan = brush->scan;
  brush->clip = scan->clip_far && !brush->steep && !beyond_doubt(scan->frame, &brush->facet); /* a steep one is asked everywhere */
  if (!brush->steep) fc_coder_start(&brush->coder, scan->frame, brush->facet.drop, UINT32_C(1) << 30);
  brush->coder_drop = INT16_MAX;
}

/* A small triangle, in one tile; false when the forms want more than 32 bits. */
static bool draw_small(fc_brush *brush, const fc_placed_mesh *mesh, const fc_corners *corners, const fc_tile *box,
                       const fc_tile *tile) {
  fc_small_facet facet;
  uint8_t how;
  facet.corners = corners;
  facet.box = box;
  facet.tile = tile;
  how = fc_small_edges(&facet, brush->scan->frame, brush->form.u.triangle.hidden);
  if (how != FC_FACET_SEEN) return how == FC_FACET_HIDDEN;
  brush->high = FC_SCAN_ROWS;
  aim(brush, tile);
  if (!walk_small_rows(brush, mesh, &facet, brush->scan->columns, (uint16_t)(tile->y1 - tile->y0 + 1))) return false;
  if (!brush->plain) finish(brush);
  return true;
}

/* From screen coordinates; false when they do not tell enough. */
static FC_NOINLINE bool draw_projected(fc_brush *brush, const fc_placed_mesh *mesh, const fc_corners *corners, const fc_tile *box,
                                       const fc_tile *seen) {
  int32_t x, y;
  fc_tile tile;
  if (brush->plain) set_tint(brush);
  for (y = seen->y0; y <= seen->y1; y = tile.y1 + 1) {
    for (x = seen->x0; x <= seen->x1; x = tile.x1 + 1) {
      bool hidden;
      next_tile(brush, seen, x, y, &tile);
      if (!fc_facet_edges(&brush->facet, brush->scan->frame, corners, box, &tile, brush->form.u.triangle.hidden, &hidden))
        return false;
      if (hidden) return true;
      brush->steep = !fc_facet_depth(&brush->facet, brush->scan->frame, mesh, corners, box, &tile);
      start_depth(brush);
      aim(brush, &tile);
      walk_rows(brush, brush->scan->columns, (uint16_t)(tile.y1 - tile.y0 + 1));
      if (!brush->plain) finish(brush);
    }
  }
  return true;
}

static FC_COLD void draw_exactly(fc_brush *brush, const fc_tile *seen) {
  const int64_t eye[3] = {0, 0, 0};
  fc_prepared prepared;
  int32_t x, y;
  fc_tile tile;
  int8_t side;
  fetch(brush);
  if (brush->plain) set_tint(brush);
  fc_kind_of(brush->scan->at)->prepare(&brush->form, eye, &prepared);
  side = fc_i128_sign(prepared.u.triangle.side);
  if (side == 0 || side == brush->form.u.triangle.hidden) return;
  for (y = seen->y0; y <= seen->y1; y = tile.y1 + 1) {
    for (x = seen->x0; x <= seen->x1; x = tile.x1 + 1) {
      next_tile(brush, seen, x, y, &tile);
      aim(brush, &tile);
      if (fc_facet_exact(&brush->facet, brush->scan->frame, &prepared, &tile)) {
        brush->steep = false;
        start_depth(brush);
        cut_rows(brush, brush->scan->columns, (uint16_t)(tile.y1 - tile.y0 + 1));
      } else {
        uint16_t row, column;
        for (row = 0; row <= tile.y1 - tile.y0; row++)
          for (column = 0; column < brush->scan->columns; column++) ask(brush, row, column);
      }
      if (!brush->plain) finish(brush);
    }
  }
}

static FC_NOINLINE void fill_spot(fc_spot *spot, const fc_placed_mesh *mesh, uint16_t vertex) {
  const fc_placed_vertex *v = fc_mesh_vertices(mesh) + vertex;
  const uint32_t seen = v->seen;
  spot->vertex = vertex;
  spot->near = 0;
  if (seen != 0) {
    const uint32_t mantissa = fc_seen_mantissa(seen);
    const int32_t up = fc_seen_exponent(seen) - mesh->shift;
    spot->near = fc_mulhi32(mantissa, mesh->depth); /* at least 2^30 */
    spot->exponent = fc_seen_exponent(seen);
    spot->x = fc_mesh_screen(v->p[0], up, mantissa);
    spot->y = fc_mesh_screen(-v->p[1], up, mantissa);
  }
}

static inline void take_corner(fc_brush *brush, const fc_placed_mesh *mesh, uint16_t vertex, fc_corners *corners, uint8_t i) {
  fc_spot *spot = &brush->spots[vertex % FC_SPOTS];
  if (spot->vertex != vertex) fill_spot(spot, mesh, vertex);
  corners->x[i] = spot->x;
  corners->y[i] = spot->y;
  corners->near[i] = spot->near;
  corners->exponent[i] = spot->exponent;
}

/* Pixels whose centres may lie between the least and the greatest coordinate. */
static inline void bounds(const int32_t at[3], uint8_t fraction, uint16_t size, int32_t *low, int32_t *high) {
  int32_t a = at[0], b = at[0], middle = (size - 1) * (INT32_C(1) << (fraction - 1));
  if (at[1] < a) a = at[1];
  if (at[1] > b) b = at[1];
  if (at[2] < a) a = at[2];
  if (at[2] > b) b = at[2];
  *low = fc_floor_shift32(a + middle - FC_CORNER_ERROR - 1, fraction) + 1;
  *high = fc_floor_shift32(b + middle + FC_CORNER_ERROR, fraction);
}

static FC_NOINLINE void draw_item(fc_brush *brush, const fc_placed_mesh *mesh, const fc_triangle *item, uint16_t rows) {
  fc_scan *scan = brush->scan;
  const fc_frame *frame = scan->frame;
  fc_corners corners;
  fc_tile box, seen;
  const int32_t last = (int32_t)scan->strip + rows - 1;
  take_corner(brush, mesh, item->vertex[0], &corners, 0);
  take_corner(brush, mesh, item->vertex[1], &corners, 1);
  take_corner(brush, mesh, item->vertex[2], &corners, 2);
  if (corners.near[0] != 0 && corners.near[1] != 0 && corners.near[2] != 0) {
    const uint8_t fraction = mesh->fraction;
    bounds(corners.y, fraction, frame->height, &box.y0, &box.y1);
    seen.y0 = box.y0 > scan->strip ? box.y0 : scan->strip;
    seen.y1 = box.y1 < last ? box.y1 : last;
    if (seen.y0 > seen.y1) return;
    bounds(corners.x, fraction, frame->width, &box.x0, &box.x1);
    seen.x0 = box.x0 > 0 ? box.x0 : 0;
    seen.x1 = box.x1 < frame->width - 1 ? box.x1 : frame->width - 1;
    if (seen.x0 > seen.x1) return;
    corners.fraction = fraction;
    brush->top = box.y0 > 0 ? box.y0 : 0;
    brush->bottom = box.y1 < frame->height - 1 ? box.y1 : frame->height - 1;
    /* small ones have no time to ask each row whether it is left out */
    if (box.x1 - box.x0 < FC_SMALL && box.y1 - box.y0 < FC_SMALL && scan->skip == FC_SKIP_NONE &&
        (brush->plain || (seen.y0 ^ seen.y1) < FC_SCAN_ROWS) && draw_small(brush, mesh, &corners, &box, &seen))
      return;
    if (draw_projected(brush, mesh, &corners, &box, &seen)) return;
  } else {
    seen.x0 = 0;
    seen.x1 = frame->width - 1;
    seen.y0 = scan->strip;
    seen.y1 = last;
    brush->top = 0;
    brush->bottom = frame->height - 1;
  }
  draw_exactly(brush, &seen);
}

void fc_triangle_strip(fc_scan *scan, uint16_t rows) {
  const fc_group *group = &scan->at->group;
  const fc_placed_mesh *mesh = group->memory;
  fc_brush brush;
  fc_bin_walk walk;
  uint8_t i;
  brush.scan = scan;
  brush.plain = scan->frame->light == FC_LIGHT_NONE && !scan->frame->layered && scan->pixel_bytes == 2 && scan->target->primitive == NULL &&
                scan->target->lit == NULL && ((uintptr_t)scan->target->pixels | scan->target->pitch_bytes) % 2 == 0;
  brush.tinted = false;
  brush.coder_drop = INT16_MAX;
  for (i = 0; i < FC_SPOTS; i++) {
    brush.spots[i].x = brush.spots[i].y = brush.spots[i].exponent = 0; /* never read unless placed, but copied */
    brush.spots[i].vertex = FC_NO_VERTEX;
  }
  brush.form.u.triangle.hidden = group->shapes.cull ? -1 : 0;
  scan->form = &brush.form;
  fc_bin_start(&walk, group, scan->strip, (uint16_t)(scan->strip + rows - 1));
  while ((scan->index = fc_bin_next(&walk)) != FC_BIN_END) {
    fc_triangle copy;
    const fc_triangle *item = fc_triangle_at(&group->shapes, scan->index, &copy);
    scan->primitive = (uint16_t)(group->first + scan->index);
    brush.fetched = false;
    brush.form.material = item->material;
    brush.form.object = item->object;
    draw_item(&brush, mesh, item, rows);
  }
}

bool fc_triangle_between(const fc_frame *frame, const fc_form *form, const int64_t light[3], const int64_t center[3],
                         int64_t radius, fc_window *window) {
  uint8_t i, j;
  window->x0 = window->y0 = 0;
  window->x1 = frame->width - 1;
  window->y1 = frame->height - 1;
  for (j = 0; j < 3; j++) {
    int64_t low = light[j] < center[j] - radius ? light[j] : center[j] - radius;
    int64_t high = light[j] > center[j] + radius ? light[j] : center[j] + radius;
    bool below = true, above = true;
    for (i = 0; i < 3; i++) {
      below = below && form->u.triangle.vertex[i][j] < low;
      above = above && form->u.triangle.vertex[i][j] > high;
    }
    if (below || above) return false;
  }
  return true;
}
