#include "pins.h"

#include "clocks.h"
#include "rp2040.h"

static void set_up(unsigned pin, uint32_t pad, uint32_t function) {
  RP_REG(PADS_GPIO(pin)) = pad;
  RP_REG(IO_GPIO_CTRL(pin)) = function;
}

static void output(unsigned pin, bool high) {
  fcp_pin_set(pin, high); /* the level first: no pulse when the pin starts to drive */
  RP_REG(SIO_GPIO_OE_SET) = 1u << pin;
  set_up(pin, PADS_IE | PADS_SCHMITT | PADS_DRIVE_4MA, IO_FUNCTION_SIO);
}

void fcp_pins_start(void) {
  const uint32_t button = PADS_IE | PADS_SCHMITT | PADS_PUE | PADS_DRIVE_4MA;
  const uint32_t fast = PADS_IE | PADS_SCHMITT | PADS_DRIVE_8MA | PADS_SLEWFAST; /* 16 ns a bit */
  fcp_reset_peripherals(RESETS_IO_BANK0 | RESETS_PADS_BANK0);
  output(FCP_PIN_CS, true);
  output(FCP_PIN_RESET, true);
  output(FCP_PIN_DC, true);
  output(FCP_PIN_BACKLIGHT, false);
  set_up(FCP_PIN_BUTTON_1, button, IO_FUNCTION_SIO);
  set_up(FCP_PIN_BUTTON_2, button, IO_FUNCTION_SIO);
  set_up(FCP_PIN_LOG, PADS_IE | PADS_SCHMITT | PADS_DRIVE_4MA, IO_FUNCTION_UART);
  set_up(FCP_PIN_SCK, fast, IO_FUNCTION_SPI);
  set_up(FCP_PIN_MOSI, fast, IO_FUNCTION_SPI);
}

void fcp_pin_set(unsigned pin, bool high) { RP_REG(high ? SIO_GPIO_OUT_SET : SIO_GPIO_OUT_CLR) = 1u << pin; }

unsigned fcp_buttons(void) {
  const uint32_t levels = RP_REG(SIO_GPIO_IN);
  return (~levels >> FCP_PIN_BUTTON_1 & 1u) | (~levels >> FCP_PIN_BUTTON_2 & 1u) << 1;
}
