/*
 * One frame of one renderer: what is measured lies between marks, the rest of the program does not count.
 *
 * Prints `crc 0x01234567`, `ram_bytes N` and `stack_bytes N`.
 */
#include "renderer.h"

#ifdef FIXCAST_BAREMETAL
#include "semihost.h"
#define PUT(c) semihost_char(c)
#else
#include <stdio.h>
#include <stdlib.h>
#define PUT(c) ((void)putchar(c))
#endif

/* The emulators watch for these addresses. The bodies differ so that the compiler does not make one of three. */
#define MARK(name) \
  void name(void); \
  __attribute__((noinline)) void name(void) { __asm__ volatile("/* " #name " */" :: \
                                                                   : "memory"); }
MARK(bench_mark_other)
MARK(bench_mark_setup)
MARK(bench_mark_strips)

static uint8_t pixels[STRIP_ROWS * WIDTH * PIXEL_BYTES];

void bench_put(const char *text) {
  for (; *text != '\0'; text++) PUT(*text);
}

/* By subtraction: a division would bring a helper into the image that the renderer may not need. */
static void put_decimal(uint32_t value) {
  static const uint32_t powers[] = {1000000, 100000, 10000, 1000, 100, 10, 1};
  int started = 0;
  size_t i;
  for (i = 0; i < sizeof powers / sizeof powers[0]; i++) {
    char digit = '0';
    for (; value >= powers[i]; value -= powers[i]) digit++;
    started |= digit != '0' || powers[i] == 1;
    if (started) PUT(digit);
  }
}

static void put_line(const char *name, size_t value) {
  bench_put(name);
  put_decimal((uint32_t)value);
  bench_put("\n");
}

static void put_hex(uint32_t value) {
  int i;
  for (i = 28; i >= 0; i -= 4) PUT("0123456789abcdef"[(value >> i) & 15]);
}

/* zlib's CRC-32, bit by bit; not finished with the last complement. */
static uint32_t crc32(uint32_t crc, const uint8_t *bytes, size_t count) {
  while (count-- > 0) {
    int bit;
    crc ^= *bytes++;
    for (bit = 0; bit < 8; bit++) crc = (crc >> 1) ^ (UINT32_C(0xedb88320) & -(crc & 1));
  }
  return crc;
}

/* ---- the stack's high-water mark: paint what lies below, look later how far the paint is gone ---- */

enum {
  PAINTED_BYTES = 16384,
  SPARED_BYTES = 64, /* below the stack pointer, for the painter itself */
  PAINT = 0xa5
};

#if defined(FIXCAST_BAREMETAL)
static uint8_t *stack_pointer(void) {
  uint8_t *sp;
#if defined(__arm__)
  __asm__ volatile("mov %0, sp"
                   : "=r"(sp));
#else
  __asm__ volatile("mv %0, sp"
                   : "=r"(sp));
#endif
  return sp;
}

static void paint(uint8_t *top) {
  volatile uint8_t *at;
  for (at = top - PAINTED_BYTES; at < top - SPARED_BYTES; at++) *at = PAINT;
}

/* Bytes below `top` that have been used; what is spared counts as used. */
static size_t used_below(uint8_t *top) {
  volatile uint8_t *at = top - PAINTED_BYTES;
  while (at < top - SPARED_BYTES && *at == PAINT) at++;
  return (size_t)(top - at);
}
#else
static uint8_t *stack_pointer(void) { return NULL; }
static void paint(uint8_t *top) { (void)top; }
static size_t used_below(uint8_t *top) {
  (void)top;
  return 0;
}
#endif

/* ---- the frame ---- */

static int draw(uint32_t *crc) {
  const strip to = {pixels};
  uint16_t y, rows;
  int failed;
  bench_mark_setup();
  failed = renderer_setup();
  bench_mark_other();
  for (y = 0; !failed && y < HEIGHT; y = (uint16_t)(y + rows)) {
    rows = (uint16_t)(HEIGHT - y < STRIP_ROWS ? HEIGHT - y : STRIP_ROWS);
    bench_mark_strips();
    failed = renderer_rows(y, rows, &to);
    bench_mark_other();
    *crc = crc32(*crc, pixels, (size_t)rows * WIDTH * PIXEL_BYTES);
  }
  return failed;
}

/* How often to draw it: on the host, to take its time, as often as the argument says. */
static uint32_t frames_wanted(int argc, char **argv) {
#ifdef FIXCAST_BAREMETAL
  (void)argc;
  (void)argv;
  return 1;
#else
  return argc == 2 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
#endif
}

int main(int argc, char **argv) {
  uint32_t crc = 0, frames = frames_wanted(argc, argv);
  const size_t ram_bytes = renderer_prepare();
  uint8_t *const top = stack_pointer();
  if (ram_bytes == 0) return 1;
  paint(top);
  while (frames-- > 0) {
    crc = UINT32_C(0xffffffff);
    if (draw(&crc) != 0) return 1;
  }
  put_line("stack_bytes ", used_below(top));
  put_line("ram_bytes ", ram_bytes);
  bench_put("crc 0x");
  put_hex(~crc);
  bench_put("\n");
  return 0;
}
