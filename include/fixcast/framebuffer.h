/* Where a strip's pixels go: formats and the caller's buffers. */
#ifndef FIXCAST_FRAMEBUFFER_H
#define FIXCAST_FRAMEBUFFER_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How a pixel is stored. */
typedef enum fc_format {
  FC_RGB888 = 0,    /* three bytes, red first */
  FC_RGB565_BE = 1, /* two bytes, high byte first: what SPI panels take */
  FC_RGB565_LE = 2  /* two bytes, low byte first */
} fc_format;

/* Bytes of one pixel, or FC_ERR_FORMAT. */
int fc_format_bytes(int format);

/* Row 0 of every buffer is the first row rendered, so a strip's buffers need only hold the strip. */
typedef struct fc_target {
  void *pixels;        /* rows of `pitch_bytes`; required */
  size_t pitch_bytes;  /* at least width * bytes of a pixel */
  uint8_t format;      /* fc_format */
  uint16_t *depth;     /* rows of width depth codes; required, written. 0: nothing there, else nearer is larger */
  uint16_t *primitive; /* rows of width primitive numbers, or NULL. 0xffff: background */
  uint32_t *lit;       /* rows of width light masks, or NULL: bit i says light i (of the first 32) reaches the point;
                          * all zero when no light does; light 32 and later show as bit 31 */
} fc_target;

#ifdef __cplusplus
}
#endif

#endif
