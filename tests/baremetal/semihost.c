#include "semihost.h"

#include <stdint.h>

enum {
  SYS_WRITE0 = 0x04,
  SYS_EXIT_EXTENDED = 0x20,
  APPLICATION_EXIT = 0x20026
};

static char line[128];
static unsigned used;

static void call(uint32_t operation, const void *argument) {
  register uint32_t r0 __asm__("r0") = operation;
  register const void *r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab"
                   : "+r"(r0)
                   : "r"(r1)
                   : "memory");
}

void semihost_flush(void) {
  line[used] = '\0';
  used = 0;
  call(SYS_WRITE0, line);
}

void semihost_char(int c) {
  line[used++] = (char)c;
  if (c == '\n' || used == sizeof line - 1) semihost_flush();
}

void semihost_exit(int code) {
  const uint32_t block[2] = {APPLICATION_EXIT, (uint32_t)code};
  if (used != 0) semihost_flush();
  call(SYS_EXIT_EXTENDED, block);
  for (;;) {
  }
}
