/* Vectors and what runs before main: data from flash, zeros, an unused stack marked so that its depth can be measured. */
#include "start.h"

#include "spi_bus.h"
#include "time.h"

extern uint32_t fcp_data_image[], fcp_data_start[], fcp_data_end[], fcp_bss_start[], fcp_bss_end[];
extern uint32_t fcp_stack_start[], fcp_stack_top[];
int main(void);

enum {
  STACK_MARK = 0x5ac35ac3
};

void fcp_reset(void) {
  const uint32_t *from = fcp_data_image;
  uint32_t *to;
  for (to = fcp_data_start; to < fcp_data_end; to++) *to = *from++;
  for (to = fcp_bss_start; to < fcp_bss_end; to++) *to = 0;
  /* Up to this function's own frame. */
  for (to = fcp_stack_start; to < (uint32_t *)__builtin_frame_address(0) - 16; to++) *to = STACK_MARK;
  main();
  for (;;) __asm__ volatile("wfi");
}

uint32_t fcp_ram_bytes(void *context) {
  const uint32_t *at = fcp_stack_start;
  (void)context;
  while (at < fcp_stack_top && *at == STACK_MARK) at++;
  return (uint32_t)((uintptr_t)fcp_stack_top - (uintptr_t)at + (uintptr_t)fcp_bss_end - (uintptr_t)fcp_data_start);
}

/* A fault or an interrupt that nobody asked for: a debugger sees where; without one the processor locks up, visibly. */
static void unexpected(void) {
  for (;;) __asm__ volatile("bkpt #1");
}

typedef void (*vector)(void);
typedef struct vectors {
  const void *stack;
  vector exception[15];
  vector interrupt[26]; /* RP2040 data sheet 2.3.2 */
} vectors;

extern const vectors fcp_vectors;
__attribute__((section(".vectors"), used)) const vectors fcp_vectors = {
    .stack = fcp_stack_top,
    .exception = {fcp_reset, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected,
                  unexpected, unexpected, unexpected, unexpected, unexpected, unexpected, fcp_systick},
    .interrupt = {unexpected, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected,
                  unexpected, unexpected, unexpected, fcp_dma_interrupt, unexpected, unexpected, unexpected, unexpected,
                  unexpected, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected,
                  unexpected, unexpected},
};
