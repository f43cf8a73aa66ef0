#include "clock.h"

#include "lm3s6965.h"

enum {
  TICK_US = 10000,
  TICK_CYCLES = 500000, /* below SysTick's 2^24 */
  LDO_2V75 = 0x1b
};

static volatile uint32_t ticks;

/* The crystal's 8 MHz become 400 in the PLL, 200 behind it and 50 behind the divider, in the order of the data sheet's section 6.3. */
static void pll_start(void) {
  uint32_t rcc = SYSCTL_RCC;
  /* Revision A2 needs more voltage for its PLL (errata). DID0: class, major, minor. */
  if ((SYSCTL_DID0 & 0xffffu) == 2u) SYSCTL_LDOPCTL = LDO_2V75;
  rcc = (rcc | RCC_BYPASS) & ~(uint32_t)RCC_USESYSDIV;
  SYSCTL_RCC = rcc;
  rcc &= ~(uint32_t)(RCC_MOSCDIS | RCC_XTAL | RCC_OSCSRC);
  SYSCTL_RCC = rcc | RCC_XTAL_8MHZ | RCC_PWRDN;
  rcc = (rcc | RCC_XTAL_8MHZ) & ~(uint32_t)RCC_PWRDN;
  SYSCTL_RCC = rcc;
  rcc = (rcc & ~(uint32_t)RCC_SYSDIV) | RCC_SYSDIV_4 | RCC_USESYSDIV;
  SYSCTL_RCC = rcc;
  while ((SYSCTL_RIS & RIS_PLLLRIS) == 0) {
  }
  SYSCTL_RCC = rcc & ~(uint32_t)RCC_BYPASS;
}

void clock_start(void) {
  pll_start();
  SYST_RVR = TICK_CYCLES - 1;
  SYST_CVR = 0;
  SYST_CSR = SYST_ENABLE | SYST_TICKINT | SYST_PROCESSOR_CLOCK;
}

void clock_tick(void) { ticks++; }

/* Whole ticks, and the cycles since the last one; read again when one came in between. */
static uint32_t now(uint32_t *cycles) {
  uint32_t before, left;
  do {
    before = ticks;
    left = SYST_CVR;
    __asm__ volatile("isb" ::
                         : "memory"); /* a tick that has come is counted before it is looked at */
  } while (before != ticks);
  *cycles = TICK_CYCLES - 1 - left;
  return before;
}

uint32_t clock_cycles(void *context) {
  uint32_t cycles;
  const uint32_t whole = now(&cycles);
  (void)context;
  return whole * TICK_CYCLES + cycles;
}

uint32_t clock_microseconds(void *context) {
  uint32_t cycles;
  const uint32_t whole = now(&cycles);
  (void)context;
  return whole * TICK_US + cycles / (CPU_HZ / 1000000u);
}

void clock_delay_us(void *context, uint32_t us) {
  const uint32_t began = clock_microseconds(context);
  while (clock_microseconds(context) - began <= us) {
  }
}
