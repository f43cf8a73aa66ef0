/* See core1.h. FIFOs between the cores: RP2040 data sheet 2.3.1.4. Resets: 2.13. */
#include "core1.h"

#include "launch.h"
#include "rp2040.h"

enum {
  STACK_WORDS = 640
};

static uint32_t stack[STACK_WORDS] __attribute__((aligned(8)));

void fcp_core_give(uint32_t word) {
  while ((RP_REG(SIO_FIFO_ST) & SIO_FIFO_ST_RDY) == 0) continue;
  __asm__ volatile("dmb" ::
                       : "memory");
  RP_REG(SIO_FIFO_WR) = word;
  __asm__ volatile("sev");
}

uint32_t fcp_core_take(void) {
  uint32_t word;
  while ((RP_REG(SIO_FIFO_ST) & SIO_FIFO_ST_VLD) == 0) __asm__ volatile("wfe");
  word = RP_REG(SIO_FIFO_RD);
  __asm__ volatile("dmb" ::
                       : "memory");
  return word;
}

void fcp_core_drop(void) {
  while ((RP_REG(SIO_FIFO_ST) & SIO_FIFO_ST_VLD) != 0) (void)RP_REG(SIO_FIFO_RD);
  __asm__ volatile("sev");
}

void fcp_core1_reset(void) {
  RP_SET(PSM_FRCE_OFF) = PSM_PROC1;
  while ((RP_REG(PSM_FRCE_OFF) & PSM_PROC1) == 0) continue;
  RP_CLEAR(PSM_FRCE_OFF) = PSM_PROC1;
}

void fcp_core1_start(fcp_core1_program *program) {
  fcp_launch(RP_REG(SCB_VTOR), (uint32_t)(uintptr_t)(stack + STACK_WORDS), (uint32_t)(uintptr_t)program);
}
