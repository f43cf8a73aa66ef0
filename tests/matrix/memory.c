/* The two library functions that the core needs, for compilers that come without a C library. */
#include <stddef.h>
#include <stdint.h>

void *memcpy(void *to, const void *from, size_t bytes);
void *memset(void *to, int value, size_t bytes);

/* The barriers keep the compiler from turning these loops into calls of themselves. */
void *memcpy(void *to, const void *from, size_t bytes) {
  uint8_t *t = to;
  const uint8_t *f = from;
  while (bytes-- > 0) {
    *t++ = *f++;
    __asm__ volatile("" ::
                         : "memory");
  }
  return to;
}

void *memset(void *to, int value, size_t bytes) {
  uint8_t *t = to;
  while (bytes-- > 0) {
    *t++ = (uint8_t)value;
    __asm__ volatile("" ::
                         : "memory");
  }
  return to;
}
