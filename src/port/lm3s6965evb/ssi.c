#include "ssi.h"

#include "clock.h"
#include "fixcast/error.h"
#include "lm3s6965.h"

enum {
  PIN_CLOCK = 1 << 2, /* port A */
  PIN_SELECT = 1 << 3,
  PIN_RECEIVE = 1 << 4,
  PIN_TRANSMIT = 1 << 5,
  PIN_OLED_POWER = 1 << 6, /* port C */
  PIN_DATA = 1 << 7,       /* D/C */
  PIN_SD_CARD = 1 << 0,    /* port D */
  HALF_FIFO = 4            /* places */
};

/* What the interrupt has still to feed into the FIFO. */
static const uint8_t *volatile next;
static volatile size_t left;
static fc_ready *on_ready;
static void *ready_context;
static uint32_t clock_divider;

void ssi_start(void) {
  SYSCTL_RCGC1 |= RCGC1_SSI0;
  SYSCTL_RCGC2 |= RCGC2_GPIOA | RCGC2_GPIOC | RCGC2_GPIOD;
  (void)SYSCTL_RCGC2; /* a module may be used three cycles after its clock came on */
  GPIO_DIR(GPIO_D) |= PIN_SD_CARD;
  GPIO_DATA(GPIO_D, PIN_SD_CARD) = PIN_SD_CARD; /* the card on the same wires is not selected */
  GPIO_DEN(GPIO_D) |= PIN_SD_CARD;
  GPIO_DIR(GPIO_C) |= PIN_DATA | PIN_OLED_POWER;
  GPIO_DEN(GPIO_C) |= PIN_DATA | PIN_OLED_POWER;
  GPIO_DATA(GPIO_C, PIN_OLED_POWER) = 0;
  GPIO_AFSEL(GPIO_A) |= PIN_CLOCK | PIN_SELECT | PIN_RECEIVE | PIN_TRANSMIT;
  GPIO_PUR(GPIO_A) |= PIN_SELECT | PIN_CLOCK; /* while the SSI is off */
  GPIO_DEN(GPIO_A) |= PIN_CLOCK | PIN_SELECT | PIN_RECEIVE | PIN_TRANSMIT;
  NVIC_ISER0 = UINT32_C(1) << SSI0_INTERRUPT;
}

/* What comes in means nothing, but a full receive FIFO must not stop the sender. */
static void drain(void) {
  while ((SSI0_SR & SSI_SR_RNE) != 0) (void)SSI0_DR;
}

static void wait_idle(void) {
  while ((SSI0_SR & SSI_SR_BSY) != 0) {
  }
  drain();
}

static int bus_wait(void *context) {
  (void)context;
  while (left != 0) {
  }
  wait_idle();
  return FC_OK;
}

/* SSIClk = system clock / (CPSDVSR (1 + SCR)), CPSDVSR 2, 4, ... 254 [14.3.1]: every even divider that is such a product. */
static int configure(void *context, uint32_t hz, uint8_t spi_mode) {
  const uint32_t wanted = hz == 0 ? 0 : (CPU_HZ / 2u - 1u) / hz + 1u; /* half the divider, at least */
  uint32_t prescale = 0, half, best = UINT32_MAX, rate = 0;
  if (hz == 0 || (spi_mode != 0 && spi_mode != 3)) return FC_ERR_UNSUPPORTED;
  for (half = 1; half <= 127; half++) {
    const uint32_t factor = (wanted + half - 1u) / half;
    if (factor <= 256 && half * factor < best) {
      best = half * factor;
      prescale = half;
      rate = factor - 1u;
    }
  }
  if (prescale == 0) return FC_ERR_UNSUPPORTED;
  (void)bus_wait(context);
  SSI0_CR1 = 0; /* off, and a master */
  SSI0_CPSR = prescale * 2u;
  SSI0_CR0 = SSI_CR0_DSS_8 | (spi_mode == 3 ? SSI_CR0_SPO | SSI_CR0_SPH : 0u) | rate << SSI_CR0_SCR_AT;
  SSI0_CR1 = SSI_CR1_SSE;
  clock_divider = best * 2u;
  return FC_OK;
}

static uint32_t clock_hz(void *context) {
  (void)context;
  return clock_divider != 0 ? CPU_HZ / clock_divider : 0;
}

static void send(const uint8_t *bytes, size_t count, uint32_t data) {
  (void)bus_wait(NULL);
  GPIO_DATA(GPIO_C, PIN_DATA) = data;
  while (count > 0) {
    if ((SSI0_SR & SSI_SR_TNF) != 0) {
      SSI0_DR = *bytes++;
      count--;
    }
    drain();
  }
  wait_idle();
}

static int command(void *context, const uint8_t *bytes, size_t count) {
  (void)context;
  send(bytes, count, 0);
  return FC_OK;
}

static int data(void *context, const uint8_t *bytes, size_t count) {
  (void)context;
  send(bytes, count, PIN_DATA);
  return FC_OK;
}

static int data_start(void *context, const uint8_t *bytes, size_t count, fc_ready *ready, void *with) {
  (void)bus_wait(context);
  GPIO_DATA(GPIO_C, PIN_DATA) = PIN_DATA;
  on_ready = ready;
  ready_context = with;
  next = bytes;
  left = count;
  SSI0_IM = SSI_IM_TXIM; /* the FIFO is empty: the interrupt comes at once */
  return FC_OK;
}

/* Comes while at least half of the FIFO's eight places are free. There is no interrupt for the last bit: whoever wants to be told pays for waiting
 * here, at most eight bytes long; otherwise the next wait does. */
void ssi_interrupt(void) {
  const uint8_t *from = next;
  const size_t count = left;
  if (count > HALF_FIFO) {
    SSI0_DR = from[0];
    SSI0_DR = from[1];
    SSI0_DR = from[2];
    SSI0_DR = from[3];
    (void)SSI0_DR; /* as many have come in, or soon will: reading an empty FIFO does no harm */
    (void)SSI0_DR;
    (void)SSI0_DR;
    (void)SSI0_DR;
    next = from + HALF_FIFO;
    left = count - HALF_FIFO;
    return;
  }
  for (next = from + count; from != next; from++) SSI0_DR = *from;
  SSI0_IM = 0;
  left = 0; /* before `ready`, which may start the next */
  if (on_ready != NULL) {
    wait_idle();
    on_ready(ready_context, FC_OK);
  }
}

/* The OLED's 15 V. */
static int backlight(void *context, uint8_t level) {
  (void)context;
  GPIO_DATA(GPIO_C, PIN_OLED_POWER) = level != 0 ? PIN_OLED_POWER : 0u;
  return FC_OK;
}

/* The OLED's reset is the board's own. */
static const fc_bus_ops ops = {.configure = configure,
                               .clock_hz = clock_hz,
                               .command = command,
                               .data = data,
                               .data_start = data_start,
                               .wait = bus_wait,
                               .reset = NULL,
                               .delay_us = clock_delay_us,
                               .backlight = backlight,
                               .wait_vsync = NULL};
const fc_bus ssi_bus = {&ops, NULL};
