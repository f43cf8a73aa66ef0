/* Start-up and semihosting for RV32 without a system. */
#include <stdint.h>

#include "semihost.h"

enum {
  SYS_WRITE0 = 0x04,
  SYS_EXIT_EXTENDED = 0x20,
  APPLICATION_EXIT = 0x20026
};

static char line[128];
static unsigned used;
int main(void);

/* The three instructions that mean semihosting; they must not be compressed or cross a page. */
static void call(uint32_t operation, const void *argument) {
  register uint32_t a0 __asm__("a0") = operation;
  register const void *a1 __asm__("a1") = argument;
  __asm__ volatile(
      ".balign 16\n.option push\n.option norvc\n"
      "slli x0, x0, 0x1f\nebreak\nsrai x0, x0, 7\n"
      ".option pop"
      : "+r"(a0)
      : "r"(a1)
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

/* The loader clears .bss and gives a stack. */
__attribute__((used)) static void start(void) { semihost_exit(main()); }

__asm__(
    ".globl _start\n_start:\n"
    ".option push\n.option norelax\nla gp, __global_pointer$\n.option pop\n"
    "andi sp, sp, -16\ncall start\n");
