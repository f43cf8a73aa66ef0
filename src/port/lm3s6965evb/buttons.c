#include "buttons.h"

#include "firmware.h"
#include "lm3s6965.h"

enum {
  PIN_UP = 1 << 0, /* port E */
  PIN_DOWN = 1 << 1,
  PIN_LEFT = 1 << 2,
  PIN_RIGHT = 1 << 3,
  PINS_E = PIN_UP | PIN_DOWN | PIN_LEFT | PIN_RIGHT,
  PIN_SELECT = 1 << 1 /* port F */
};

/* A button connects its pin to ground. */
static void pull_up(uint32_t port, uint32_t pins) {
  GPIO_DIR(port) &= ~pins;
  GPIO_PUR(port) |= pins;
  GPIO_DEN(port) |= pins;
}

void buttons_start(void) {
  SYSCTL_RCGC2 |= RCGC2_GPIOE | RCGC2_GPIOF;
  (void)SYSCTL_RCGC2; /* a module may be used three cycles after its clock came on */
  pull_up(GPIO_E, PINS_E);
  pull_up(GPIO_F, PIN_SELECT);
}

uint8_t buttons_read(void *context) {
  const uint32_t down = ~GPIO_DATA(GPIO_E, PINS_E);
  uint8_t held = 0;
  (void)context;
  if ((down & PIN_UP) != 0) held |= FC_BUTTON_FASTER;
  if ((down & PIN_DOWN) != 0) held |= FC_BUTTON_SLOWER;
  if ((down & PIN_LEFT) != 0) held |= FC_BUTTON_REVERSE;
  if ((down & PIN_RIGHT) != 0) held |= FC_BUTTON_PATTERN;
  if (GPIO_DATA(GPIO_F, PIN_SELECT) == 0) held |= FC_BUTTON_PAUSE;
  return held;
}
