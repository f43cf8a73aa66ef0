#include "time.h"

#include "rp2040.h"

enum {
  PERIOD_BITS = 24
}; /* SysTick counts down through 2^24 values */

static volatile uint32_t periods; /* finished ones, times 2^24 */

void fcp_cycles_start(void) {
  RP_REG(SYST_CSR) = 0;
  RP_REG(SYST_RVR) = (1u << PERIOD_BITS) - 1;
  RP_REG(SYST_CVR) = 0; /* any write clears it; it reloads with the next cycle */
  periods = 0;
  RP_REG(SYST_CSR) = SYST_CSR_CLKSOURCE | SYST_CSR_TICKINT | SYST_CSR_ENABLE;
}

void fcp_systick(void) { periods += 1u << PERIOD_BITS; }

uint32_t fcp_cycles(void *context) {
  uint32_t high, low, pending;
  (void)context;
  /* Read again when a period ended in between. One that ended while interrupts are off has not been counted yet. */
  do {
    high = periods;
    low = RP_REG(SYST_CVR);
    pending = RP_REG(NVIC_ICSR) & NVIC_ICSR_PENDSTSET;
  } while (high != periods);
  if (pending != 0) {
    low = RP_REG(SYST_CVR);
    high += 1u << PERIOD_BITS;
  }
  return high + ((1u << PERIOD_BITS) - 1 - low);
}

uint64_t fcp_time_us(void) {
  uint32_t high = RP_REG(TIMER_TIMERAWH), low, again;
  for (;;) {
    low = RP_REG(TIMER_TIMERAWL);
    again = RP_REG(TIMER_TIMERAWH);
    if (again == high) return (uint64_t)high << 32 | low;
    high = again;
  }
}

uint32_t fcp_microseconds(void *context) {
  (void)context;
  return RP_REG(TIMER_TIMERAWL);
}

void fcp_delay_us(uint32_t us) {
  const uint64_t end = fcp_time_us() + us + 1; /* the microsecond that is under way is not a whole one */
  while (fcp_time_us() < end) continue;
}
