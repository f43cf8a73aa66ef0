/* Text and whole numbers, a character at a time, without a C library: what firmware says on its serial line. */
#ifndef FIXCAST_FIRMWARE_TEXT_H
#define FIXCAST_FIRMWARE_TEXT_H

#include <stdint.h>

#include "fixcast/config.h"

/* Where characters go. */
typedef struct fc_text {
  void (*put)(void *context, char c);
  void *context;
} fc_text;

/* A string constant that stays in flash, for fc_text_rom(). */
#ifdef PSTR
#define FC_TEXT(string) PSTR(string)
#else
#define FC_TEXT(string) (string)
#endif

void fc_text_rom(const fc_text *to, const char *string);
void fc_text_ram(const fc_text *to, const char *string);
void fc_text_unsigned(const fc_text *to, uint32_t value);
void fc_text_signed(const fc_text *to, int32_t value);
void fc_text_tenths(const fc_text *to, uint32_t tenths); /* 352 as 35.2 */
void fc_text_hex(const fc_text *to, uint32_t value);     /* eight digits, lower case */

#endif
