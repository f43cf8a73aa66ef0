/*
 * The LM3S6965EVB's bus and clocks by themselves, on the emulated chip: what fixcast/bus.h promises and a picture alone does not show.
 *
 * Prints `checks N wrong N`, each wrong one before it, then comes to fc_firmware_frame_shown.
 */
#include "clock.h"
#include "fixcast/error.h"
#include "serial.h"
#include "ssi.h"
#include "text.h"

void fc_firmware_frame_shown(void);

static const fc_text out = {serial_put, 0};
static uint32_t checks, wrong;

static void check(int holds, const char *what, uint32_t of) {
  checks++;
  if (holds) return;
  wrong++;
  fc_text_ram(&out, "wrong: ");
  fc_text_ram(&out, what);
  fc_text_ram(&out, ", ");
  fc_text_unsigned(&out, of);
  fc_text_ram(&out, "\n");
}

/* The fastest clock of at most hz that an even prescaler to 254 and a rate to 256 make of 50 MHz, by trying all; 0: none. */
static uint32_t fastest(uint32_t hz) {
  uint32_t prescaler, rate, best = 0;
  for (prescaler = 2; prescaler <= 254; prescaler += 2) {
    for (rate = 1; rate <= 256; rate++) {
      const uint32_t divider = prescaler * rate;
      if ((uint64_t)divider * hz >= CPU_HZ && CPU_HZ / divider > best) best = CPU_HZ / divider;
    }
  }
  return best;
}

static void check_clocks(void) {
  static const uint32_t asked[] = {768, 769, 800, 1000, 9600, 97655, 97657, 98000, 1000000, 3571428, 3571429,
                                   4000000, 4166666, 4166667, 10000000, 12499999, 12500000, 24999999, 25000000, 62500000, UINT32_MAX};
  const fc_bus_ops *ops = ssi_bus.ops;
  unsigned i;
  for (i = 0; i < sizeof asked / sizeof asked[0]; i++) {
    const uint32_t best = fastest(asked[i]);
    const int error = ops->configure(ssi_bus.context, asked[i], i % 2 == 0 ? 0 : 3);
    check(best == 0 ? error == FC_ERR_UNSUPPORTED : error == FC_OK, "configure's answer", asked[i]);
    if (best != 0) check(ops->clock_hz(ssi_bus.context) == best, "not the fastest clock of at most", asked[i]);
  }
  check(ops->configure(ssi_bus.context, 0, 3) == FC_ERR_UNSUPPORTED, "0 Hz", 0);
  check(ops->configure(ssi_bus.context, 4000000, 1) == FC_ERR_UNSUPPORTED, "SPI mode", 1);
  check(ops->configure(ssi_bus.context, 4000000, 2) == FC_ERR_UNSUPPORTED, "SPI mode", 2);
  check(ops->configure(ssi_bus.context, 4000000, 3) == FC_OK, "SPI mode", 3);
}

typedef struct chain {
  volatile unsigned called, to_come;
  volatile int error;
} chain;

static const uint8_t bytes[100];

/* Starts a further transfer from the interrupt, as a display with a queue would. */
static void ready(void *context, int error) {
  chain *self = context;
  self->called++;
  self->error |= error;
  if (self->to_come > 0) {
    self->to_come--;
    self->error |= ssi_bus.ops->data_start(ssi_bus.context, bytes, 5, ready, self);
  }
}

static void check_transfers(void) {
  static const uint8_t counts[] = {1, 2, 3, 4, 5, 7, 8, 9, 12, 16, 17, 100};
  const fc_bus_ops *ops = ssi_bus.ops;
  chain none = {0, 0, 0}, chained = {0, 3, 0};
  unsigned i;
  for (i = 0; i < sizeof counts; i++) {
    chain one = {0, 0, 0};
    check(ops->data_start(ssi_bus.context, bytes, counts[i], ready, &one) == FC_OK, "data_start of bytes", counts[i]);
    check(ops->wait(ssi_bus.context) == FC_OK, "wait after bytes", counts[i]);
    check(one.called == 1 && one.error == FC_OK, "ready was not called once after bytes", counts[i]);
    check(ops->data_start(ssi_bus.context, bytes, counts[i], NULL, NULL) == FC_OK, "data_start without ready of bytes", counts[i]);
    check(ops->data(ssi_bus.context, bytes, 1) == FC_OK, "data after bytes", counts[i]);
    check(one.called == 1, "ready was called for another transfer", counts[i]);
  }
  __asm__ volatile("cpsid i" ::
                       : "memory");
  check(ops->data_start(ssi_bus.context, bytes, 100, ready, &none) == FC_OK && none.called == 0, "data_start does not return at once", 0);
  __asm__ volatile("cpsie i" ::
                       : "memory");
  check(ops->wait(ssi_bus.context) == FC_OK && none.called == 1, "what was held up did not end", 0);
  check(ops->data_start(ssi_bus.context, bytes, 9, ready, &chained) == FC_OK, "data_start of a chain", 0);
  while (chained.called < 4 && clock_microseconds(0) < 2000000u) {
  }
  check(chained.called == 4 && chained.error == FC_OK, "transfers of a chain", chained.called);
  check(ops->wait(ssi_bus.context) == FC_OK && none.called == 1, "wait with nothing under way", 0);
}

static void check_time(void) {
  static const uint16_t delays[] = {1, 10, 100, 9999, 10000, 10001, 25000};
  unsigned i;
  for (i = 0; i < sizeof delays / sizeof delays[0]; i++) {
    const uint32_t us = clock_microseconds(0), cycles = clock_cycles(0);
    uint32_t took_us, took_cycles;
    ssi_bus.ops->delay_us(ssi_bus.context, delays[i]);
    took_cycles = clock_cycles(0) - cycles;
    took_us = clock_microseconds(0) - us;
    check(took_cycles >= delays[i] * 50u && took_cycles < delays[i] * 50u + 1000u, "cycles of a delay of us", delays[i]);
    check(took_us >= delays[i] && took_us < delays[i] + 20u, "microseconds of a delay of us", delays[i]);
  }
}

/* Over some ticks of 10 ms: it never goes back. */
static void check_no_step_back(void) {
  uint32_t last = clock_cycles(0), back = 0;
  const uint32_t began = last;
  while (last - began < 3000000u) {
    const uint32_t now = clock_cycles(0);
    if (now - last > 100000u) back++;
    last = now;
  }
  check(back == 0, "times that the clock went back", back);
}

int main(void) {
  clock_start();
  serial_start();
  ssi_start();
  check_clocks();
  check_transfers();
  check_time();
  check_no_step_back();
  fc_text_ram(&out, "checks ");
  fc_text_unsigned(&out, checks);
  fc_text_ram(&out, " wrong ");
  fc_text_unsigned(&out, wrong);
  fc_text_ram(&out, "\n");
  fc_firmware_frame_shown();
  return 0;
}

__attribute__((noinline)) void fc_firmware_frame_shown(void) { __asm__ volatile("" ::
                                                                                    : "memory"); }
