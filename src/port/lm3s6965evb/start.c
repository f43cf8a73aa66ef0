/* Start-up: vectors, variables, a painted stack, main. */
#include "start.h"

#include "clock.h"
#include "serial.h"
#include "ssi.h"

#define PAINT UINT32_C(0xa5c35a3c)
enum {
  OWN_WORDS = 16 /* of the stack, which reset() itself may use below its frame */
};

extern uint32_t data_image[], data_start[], data_end[], bss_start[], bss_end[], ram_start[], stack_top[];
int main(void);
void reset(void);

void reset(void) {
  const uint32_t *from = data_image;
  uint32_t *to, *end = (uint32_t *)__builtin_frame_address(0) - OWN_WORDS;
  for (to = data_start; to < data_end; to++) *to = *from++;
  for (to = bss_start; to < bss_end; to++) *to = 0;
  for (to = bss_end; to < end; to++) *to = PAINT;
  (void)main();
  for (;;) __asm__ volatile("wfi");
}

uint32_t start_ram_bytes(void *context) {
  const uint32_t *deepest = bss_end;
  (void)context;
  while (deepest < stack_top && *deepest == PAINT) deepest++;
  return (uint32_t)(bss_end - ram_start + (stack_top - deepest)) * 4u;
}

/* Without this a fault would only show as a picture that stands still. */
static void fault(void) {
  const char *text = "processor fault\n";
  for (; *text != '\0'; text++) serial_put(0, *text);
  for (;;) {
  }
}

typedef void (*vector)(void);
__attribute__((section(".vectors"), used)) static const struct {
  uint32_t *stack;
  vector exceptions[15];
  vector interrupts[8];
} vectors = {stack_top,
             {reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0, fault, clock_tick},
             {fault, fault, fault, fault, fault, fault, fault, ssi_interrupt}};
