/*
 * Compile-time knobs. Each has a default that suits a host or a von Neumann microcontroller; define a knob
 * before the first fixcast header (or on the compiler's command line) to change it.
 */
#ifndef FIXCAST_CONFIG_H
#define FIXCAST_CONFIG_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/*
 * FC_ROM: attribute of constant tables. FC_READ(to, from, bytes): copies constant data to RAM.
 *
 * Everything constant that the core looks at (scenes, kinds of shape) is read through these, so that chips
 * whose flash is not in the data address space only need the first two. Default: AVR's program memory on AVR,
 * plain memory elsewhere. Define FC_ROM_FAR with them where constant data cannot be read through a pointer.
 */
#if defined(__AVR__) && !defined(FC_READ)
#include <avr/pgmspace.h>
#define FC_ROM PROGMEM
#define FC_READ(to, from, bytes) ((void)memcpy_P((to), (from), (bytes)))
#define FC_ROM_FAR
#endif
#ifndef FC_ROM
#define FC_ROM
#endif
#ifndef FC_READ
#define FC_READ(to, from, bytes) ((void)memcpy((to), (from), (bytes)))
#endif

/* A pointer that is known to be a multiple of 4 (FC_ALIGNED4) or of 2 (FC_ALIGNED2). */
#if defined(__GNUC__) && !defined(FC_ALIGNED4)
#define FC_ALIGNED4(pointer) __builtin_assume_aligned((pointer), 4)
#define FC_ALIGNED2(pointer) __builtin_assume_aligned((pointer), 2)
#endif
#ifndef FC_ALIGNED4
#define FC_ALIGNED4(pointer) (pointer)
#define FC_ALIGNED2(pointer) (pointer)
#endif

#endif
