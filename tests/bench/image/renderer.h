/* What the bench measures, whoever renders: one frame, set up once and drawn in strips. */
#ifndef FIXCAST_BENCH_RENDERER_H
#define FIXCAST_BENCH_RENDERER_H

#include <stddef.h>
#include <stdint.h>

#ifndef WIDTH
#define WIDTH 128
#endif
#ifndef HEIGHT
#define HEIGHT 128
#endif
#ifndef STRIP_ROWS
#define STRIP_ROWS 16
#endif

/* Where a strip goes, row 0 its first row. With -DDUMP, for the comparison with the oracle on the host, pixels are
 * RGB888 and the other two are filled; otherwise they are RGB565 with the high byte first, and there are no others. */
typedef struct strip {
  uint8_t *pixels;
#ifdef DUMP
  uint16_t *object; /* 0: background */
  uint32_t *lit;    /* bit i: light i reaches the point */
#endif
} strip;

#ifdef DUMP
#define PIXEL_BYTES 3
#else
#define PIXEL_BYTES 2
#endif

/* Before anything is measured. RAM it takes besides the pixels and depth of a strip; 0: it failed and said why. */
size_t renderer_prepare(void);

/* These two are measured. 0: done. */
int renderer_setup(void);
int renderer_rows(uint16_t y, uint16_t rows, const strip *to);

/* For messages: text up to a NUL. */
void bench_put(const char *text);

#endif
