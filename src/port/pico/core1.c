/* See core1.h. FIFOs between the cores: RP2040 data sheet 2.3.1.4. How the ROM starts core 1: 2.8.2. */
#include "core1.h"

#include <stddef.h>

#include "rp2040.h"

enum { STACK_WORDS = 1024 };

static uint32_t stack[STACK_WORDS] __attribute__((aligned(8)));

void fcp_core_give(uint32_t word) {
  while ((RP_REG(SIO_FIFO_ST) & SIO_FIFO_ST_RDY) == 0) continue;
  __asm__ volatile("dmb" ::: "memory");
  RP_REG(SIO_FIFO_WR) = word;
  __asm__ volatile("sev");
}

uint32_t fcp_core_take(void) {
  uint32_t word;
  while ((RP_REG(SIO_FIFO_ST) & SIO_FIFO_ST_VLD) == 0) __asm__ volatile("wfe");
  word = RP_REG(SIO_FIFO_RD);
  __asm__ volatile("dmb" ::: "memory");
  return word;
}

static void drop_words(void) {
  while ((RP_REG(SIO_FIFO_ST) & SIO_FIFO_ST_VLD) != 0) (void)RP_REG(SIO_FIFO_RD);
}

void fcp_core1_launch(void (*entry)(void)) {
  const uint32_t words[6] = {0, 0, 1, RP_REG(SCB_VTOR), (uint32_t)(uintptr_t)(stack + STACK_WORDS), (uint32_t)(uintptr_t)entry};
  size_t i = 0;
  /* The ROM's loop, also when core 1 runs something since a reset of core 0 alone. */
  RP_SET(PSM_FRCE_OFF) = PSM_PROC1;
  while ((RP_REG(PSM_FRCE_OFF) & PSM_PROC1) == 0) continue;
  RP_CLEAR(PSM_FRCE_OFF) = PSM_PROC1;
  /* Each word comes back; after one that does not, from the start. Before a 0 the ROM empties its FIFO, so we empty ours, and wake it. */
  while (i < 6) {
    if (words[i] == 0) {
      drop_words();
      __asm__ volatile("sev");
    }
    fcp_core_give(words[i]);
    i = fcp_core_take() == words[i] ? i + 1 : 0;
  }
}
