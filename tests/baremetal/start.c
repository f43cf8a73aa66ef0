/* Start-up for Cortex-M: vectors, memory, main, and main's result as the emulator's exit code. */
#include <stdint.h>

#include "semihost.h"

extern uint32_t data_image[], data_start[], data_end[], bss_start[], bss_end[], stack_top[];
int main(void);
void reset(void);

void reset(void) {
  const uint32_t *from = data_image;
  uint32_t *to;
#ifdef __ARM_FP
  *(volatile uint32_t *)0xe000ed88 |= UINT32_C(0xf) << 20; /* CPACR: the floating-point unit is off after reset */
  __asm__ volatile("dsb\n isb" ::
                       : "memory");
#endif
  for (to = data_start; to < data_end; to++) *to = *from++;
  for (to = bss_start; to < bss_end; to++) *to = 0;
  semihost_exit(main());
}

/* Without this a fault would only show as a time-out. */
static void fault(void) {
  const char *text = "processor fault\n";
  for (; *text != '\0'; text++) semihost_char(*text);
  semihost_exit(3);
}

typedef void (*vector)(void);
__attribute__((section(".vectors"), used)) static const struct {
  uint32_t *stack;
  vector exceptions[15];
} vectors = {stack_top,
             {reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0, fault, fault}};
