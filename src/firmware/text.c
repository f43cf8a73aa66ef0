#include "text.h"

void fc_text_rom(const fc_text *to, const char *string) {
  for (;; string++) {
    char c;
    FC_READ(&c, string, 1);
    if (c == '\0') return;
    to->put(to->context, c);
  }
}

void fc_text_ram(const fc_text *to, const char *string) {
  for (; *string != '\0'; string++) to->put(to->context, *string);
}

void fc_text_unsigned(const fc_text *to, uint32_t value) {
  char digits[10];
  uint8_t count = 0;
  do {
    digits[count++] = (char)('0' + (char)(value % 10u));
    value /= 10u;
  } while (value != 0);
  while (count > 0) to->put(to->context, digits[--count]);
}

void fc_text_signed(const fc_text *to, int32_t value) {
  if (value < 0) to->put(to->context, '-');
  fc_text_unsigned(to, value < 0 ? 0u - (uint32_t)value : (uint32_t)value);
}

void fc_text_tenths(const fc_text *to, uint32_t tenths) {
  fc_text_unsigned(to, tenths / 10u);
  to->put(to->context, '.');
  fc_text_unsigned(to, tenths % 10u);
}

void fc_text_hex(const fc_text *to, uint32_t value) {
  int8_t shift;
  for (shift = 28; shift >= 0; shift = (int8_t)(shift - 4)) {
    const uint8_t digit = (uint8_t)((value >> shift) & 15u);
    to->put(to->context, (char)(digit < 10 ? '0' + digit : 'a' - 10 + digit));
  }
}
