/* See spi_bus.h. SPI: RP2040 data sheet 4.4, a PL022. DMA: 2.5. */
#include "spi_bus.h"

#include "clocks.h"
#include "fixcast/error.h"
#include "pins.h"
#include "rp2040.h"
#include "time.h"

enum {
  CHANNEL = 0,
  DIVIDER_MAX = 254 * 256, /* CPSDVSR (even, 2..254) times 1 + SCR (0..255) */
  GRACE_US = 1000          /* what DMA may be late by */
};

static struct {
  uint32_t mode;           /* SPO and SPH bits of CR0 */
  uint32_t prescale, rate; /* CPSDVSR, 1 + SCR */
  uint32_t word_bits;      /* what the PL022 is set to; 0: not as the three above say */
  volatile bool busy;      /* set by data_start, cleared by the interrupt */
  volatile uint32_t ended; /* transfers by DMA so far */
  volatile int error;      /* of the last transfer by DMA */
  uint64_t deadline_us;
  fc_ready *ready;
  void *ready_context;
} bus;

static uint32_t clock_hz(void *context) {
  (void)context;
  return bus.rate == 0 ? 0 : (uint32_t)FCP_SYSTEM_HZ / (bus.prescale * bus.rate);
}

/* Until the last bit has left: then D/C and CS may change. */
static void drain(void) {
  while ((RP_REG(SPI0_SR) & SPI_SR_BSY) != 0) continue;
}

/* Words of `bits` bits. The PL022 takes no change of CR0 while it is enabled. */
static void set_word(uint32_t bits) {
  if (bits == bus.word_bits) return;
  bus.word_bits = bits;
  RP_REG(SPI0_CR1) = 0;
  RP_REG(SPI0_CPSR) = bus.prescale;
  RP_REG(SPI0_CR0) = (bus.rate - 1) << SPI_CR0_SCR_SHIFT | bus.mode | (bits - 1);
  RP_REG(SPI0_CR1) = SPI_CR1_SSE;
}

/* What arrived meanwhile is nobody's: the display has no data line back. */
static void drop_received(void) {
  while ((RP_REG(SPI0_SR) & SPI_SR_RNE) != 0) (void)RP_REG(SPI0_DR);
  RP_REG(SPI0_ICR) = SPI_ICR_ROR;
}

/* A transfer has ended: the bus is idle, and the bytes are the caller's. */
static void finish(int error) {
  fc_ready *const ready = bus.ready;
  drain();
  fcp_pin_set(FCP_PIN_CS, true);
  drop_received();
  bus.error = error;
  bus.busy = false;
  bus.ended++;
  if (ready != NULL) ready(bus.ready_context, error);
}

static void stop_dma(void) {
  RP_REG(DMA_CHAN_ABORT) = 1u << CHANNEL;
  while ((RP_REG(DMA_CTRL_TRIG(CHANNEL)) & DMA_CTRL_BUSY) != 0) continue;
  RP_REG(DMA_INTS0) = 1u << CHANNEL;
}

/* Until the transfer that is under way has ended; `ready` may have started another by then. */
static int wait(void *context) {
  const uint32_t before = bus.ended;
  (void)context;
  while (bus.busy && bus.ended == before) {
    if (fcp_time_us() < bus.deadline_us) continue;
    RP_CLEAR(DMA_INTE0) = 1u << CHANNEL; /* first: stopping may raise the interrupt (erratum RP2040-E13) */
    if (bus.busy) {
      stop_dma();
      finish(FC_ERR_BUS);
    }
    RP_SET(DMA_INTE0) = 1u << CHANNEL;
  }
  return bus.error;
}

/* Until no transfer is under way: the error of the last one, which is told once. */
static int idle(void) {
  int error;
  while (bus.busy) (void)wait(NULL);
  error = bus.error;
  bus.error = FC_OK;
  return error;
}

static int configure(void *context, uint32_t hz, uint8_t spi_mode) {
  uint32_t divider, prescale, best = DIVIDER_MAX + 1, best_prescale = 0;
  (void)context;
  (void)idle();
  if (hz == 0 || (spi_mode != 0 && spi_mode != 3)) return FC_ERR_UNSUPPORTED;
  divider = ((uint32_t)FCP_SYSTEM_HZ - 1) / hz + 1; /* the smallest that is slow enough */
  for (prescale = 2; prescale <= 254; prescale += 2) {
    const uint32_t rate = (divider + prescale - 1) / prescale;
    if (rate <= 256 && prescale * rate < best) {
      best = prescale * rate;
      best_prescale = prescale;
    }
  }
  if (best_prescale == 0) return FC_ERR_UNSUPPORTED;
  bus.prescale = best_prescale;
  bus.rate = best / best_prescale;
  bus.word_bits = 0;
  bus.mode = spi_mode == 3 ? SPI_CR0_SPO | SPI_CR0_SPH : 0;
  set_word(8); /* the clock's idle level is right before CS falls */
  return FC_OK;
}

static int send(void *context, const uint8_t *bytes, size_t count, bool data) {
  const int error = idle();
  size_t i;
  (void)context;
  if (error != FC_OK) return error;
  set_word(8);
  fcp_pin_set(FCP_PIN_DC, data);
  fcp_pin_set(FCP_PIN_CS, false);
  for (i = 0; i < count; i++) {
    while ((RP_REG(SPI0_SR) & SPI_SR_TNF) == 0) continue;
    RP_REG(SPI0_DR) = bytes[i];
  }
  drain();
  fcp_pin_set(FCP_PIN_CS, true);
  drop_received();
  return FC_OK;
}

static int command(void *context, const uint8_t *bytes, size_t count) { return send(context, bytes, count, false); }

static int data(void *context, const uint8_t *bytes, size_t count) { return send(context, bytes, count, true); }

static int data_start(void *context, const uint8_t *bytes, size_t count, fc_ready *ready, void *ready_context) {
  const uint32_t halfwords = ((uintptr_t)bytes | count) % 2 == 0;
  const int error = idle();
  (void)context;
  if (error != FC_OK) return error;
  bus.ready = ready;
  bus.ready_context = ready_context;
  /* At most 12 clocks a byte (8 and a pause), rounded up. */
  bus.deadline_us = fcp_time_us() + GRACE_US + (uint64_t)count * (bus.prescale * bus.rate) * 12 / (FCP_SYSTEM_HZ / 1000000);
  bus.busy = true;
  set_word(halfwords ? 16 : 8);
  fcp_pin_set(FCP_PIN_DC, true);
  fcp_pin_set(FCP_PIN_CS, false);
  RP_REG(DMA_READ_ADDR(CHANNEL)) = (uint32_t)(uintptr_t)bytes;
  RP_REG(DMA_WRITE_ADDR(CHANNEL)) = SPI0_DR;
  RP_REG(DMA_TRANS_COUNT(CHANNEL)) = (uint32_t)count >> halfwords;
  /* The first byte of two is the higher half of a word on the wire. */
  RP_REG(DMA_CTRL_TRIG(CHANNEL)) = DMA_CTRL_EN | DMA_CTRL_HIGH_PRIORITY | DMA_CTRL_INCR_READ |
                                   DMA_TREQ_SPI0_TX << DMA_CTRL_TREQ_SHIFT | (uint32_t)CHANNEL << DMA_CTRL_CHAIN_TO_SHIFT |
                                   halfwords << DMA_CTRL_SIZE_SHIFT | (halfwords ? DMA_CTRL_BSWAP : 0);
  return FC_OK;
}

/* DMA has written the last word; the FIFO and the shifter still hold up to nine: 2.5 us at 62.5 MHz, and waiting for them here is what
 * makes CS and D/C right. */
void fcp_dma_interrupt(void) {
  const uint32_t errors = RP_REG(DMA_CTRL_TRIG(CHANNEL)) & DMA_CTRL_ERRORS;
  RP_REG(DMA_INTS0) = 1u << CHANNEL;
  finish(errors != 0 ? FC_ERR_BUS : FC_OK);
}

static int reset(void *context, bool active) {
  (void)context;
  (void)idle();
  fcp_pin_set(FCP_PIN_RESET, !active);
  return FC_OK;
}

static void delay_us(void *context, uint32_t us) {
  (void)context;
  fcp_delay_us(us);
}

static int backlight(void *context, uint8_t level) {
  (void)context;
  fcp_pin_set(FCP_PIN_BACKLIGHT, level != 0);
  return FC_OK;
}

static const fc_bus_ops ops = {.configure = configure,
                               .clock_hz = clock_hz,
                               .command = command,
                               .data = data,
                               .data_start = data_start,
                               .wait = wait,
                               .reset = reset,
                               .delay_us = delay_us,
                               .backlight = backlight};

fc_bus fcp_spi_bus_start(void) {
  const fc_bus result = {.ops = &ops, .context = NULL};
  fcp_reset_peripherals(RESETS_SPI0 | RESETS_DMA);
  RP_REG(SPI0_DMACR) = SPI_DMACR_TXDMAE;
  RP_REG(DMA_INTE0) = 1u << CHANNEL;
  RP_REG(NVIC_ISER) = 1u << IRQ_DMA_0;
  return result;
}
