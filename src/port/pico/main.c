#include "clocks.h"
#include "log.h"
#include "pins.h"
#include "spi_bus.h"
#include "start.h"
#include "time.h"
static void text(const char *s) { while (*s) fcp_log_put(*s++); }
static void hex(uint32_t v) { int i; for (i = 28; i >= 0; i -= 4) fcp_log_put("0123456789abcdef"[v >> i & 15]); fcp_log_put('\n'); }
static volatile int ready_count;
static void ready(void *c, int e) { (void)c; (void)e; ready_count++; }
static uint8_t strip[2][480 * 8];
static void cmd(fc_bus *b, uint8_t c, const uint8_t *d, size_t n) { b->ops->command(b->context, &c, 1); if (n) b->ops->data(b->context, d, n); }
int main(void) {
  static const uint8_t area[4] = {0, 0, 0, 239}, colmod = 0x55, madctl = 0;
  fc_bus b;
  int y, x, r;
  uint32_t c0;
  fcp_clocks_start();
  fcp_pins_start();
  fcp_log_start();
  fcp_cycles_start();
  text("boot\n");
  b = fcp_spi_bus_start();
  b.ops->reset(b.context, true);
  b.ops->delay_us(b.context, 20);
  b.ops->reset(b.context, false);
  b.ops->delay_us(b.context, 120000);
  b.ops->configure(b.context, 10000000, 0);
  hex(b.ops->clock_hz(b.context));
  cmd(&b, 0x11, 0, 0);
  b.ops->delay_us(b.context, 120000);
  cmd(&b, 0x3a, &colmod, 1);
  cmd(&b, 0x36, &madctl, 1);
  cmd(&b, 0x21, 0, 0);
  cmd(&b, 0x29, 0, 0);
  cmd(&b, 0x2a, area, 4);
  cmd(&b, 0x2b, area, 4);
  cmd(&b, 0x2c, 0, 0);
  b.ops->configure(b.context, 62500000, 0);
  hex(b.ops->clock_hz(b.context));
  c0 = fcp_cycles();
  for (y = 0; y < 240; y += 8) {
    uint8_t *s = strip[y / 8 & 1];
    for (r = 0; r < 8; r++)
      for (x = 0; x < 240; x++) { s[480 * r + 2 * x] = (uint8_t)(x); s[480 * r + 2 * x + 1] = (uint8_t)(y + r); }
    b.ops->data_start(b.context, s, 480 * 8, ready, 0);
  }
  b.ops->wait(b.context);
  hex(fcp_cycles() - c0);
  hex((uint32_t)ready_count);
  hex((uint32_t)fcp_time_us());
  hex(fcp_stack_used_bytes());
  b.ops->backlight(b.context, 255);
  text("DONE\n");
  fcp_log_wait();
  return 0;
}
