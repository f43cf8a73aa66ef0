/* What the core uses of <string.h>, for compilers that come without a C library. */
#ifndef FIXCAST_TEST_STRING_H
#define FIXCAST_TEST_STRING_H

#include <stddef.h>

void *memcpy(void *to, const void *from, size_t bytes);
void *memset(void *to, int value, size_t bytes);
#undef memcpy
#define memcpy __builtin_memcpy
#undef memset
#define memset __builtin_memset

#endif
