/* See sdk_bus.h. */
#include "sdk_bus.h"

#include "fixcast/error.h"
#include "hardware/dma.h"
#include "hardware/irq.h"
#include "hardware/spi.h"
#include "pico/stdlib.h"

static struct {
  int channel;
  uint32_t hz;
  volatile bool busy;
  fc_ready *ready;
  void *ready_context;
} bus;

/* The last bit has left: only then may CS and D/C change. */
static void end_transfer(void) {
  while (spi_is_busy(spi0)) tight_loop_contents();
  gpio_put(PIN_CS, true);
}

static void dma_done(void) {
  dma_channel_acknowledge_irq0((uint)bus.channel);
  end_transfer();
  bus.busy = false;
  if (bus.ready != NULL) bus.ready(bus.ready_context, FC_OK);
}

static int wait(void *context) {
  (void)context;
  while (bus.busy) tight_loop_contents();
  return FC_OK;
}

static int configure(void *context, uint32_t hz, uint8_t spi_mode) {
  (void)wait(context);
  if (hz == 0 || (spi_mode != 0 && spi_mode != 3)) return FC_ERR_UNSUPPORTED;
  bus.hz = spi_set_baudrate(spi0, hz);
  if (bus.hz > hz) return FC_ERR_UNSUPPORTED; /* slower than SPI0 can be */
  spi_set_format(spi0, 8, spi_mode == 3 ? SPI_CPOL_1 : SPI_CPOL_0, spi_mode == 3 ? SPI_CPHA_1 : SPI_CPHA_0, SPI_MSB_FIRST);
  return FC_OK;
}

static uint32_t clock_hz(void *context) {
  (void)context;
  return bus.hz;
}

static void begin_transfer(bool data) {
  (void)wait(NULL);
  gpio_put(PIN_DC, data);
  gpio_put(PIN_CS, false);
}

static int command(void *context, const uint8_t *bytes, size_t count) {
  (void)context;
  begin_transfer(false);
  (void)spi_write_blocking(spi0, bytes, count);
  end_transfer();
  return FC_OK;
}

static int data(void *context, const uint8_t *bytes, size_t count) {
  (void)context;
  begin_transfer(true);
  (void)spi_write_blocking(spi0, bytes, count);
  end_transfer();
  return FC_OK;
}

static int data_start(void *context, const uint8_t *bytes, size_t count, fc_ready *ready, void *ready_context) {
  dma_channel_config config = dma_channel_get_default_config((uint)bus.channel);
  (void)context;
  begin_transfer(true);
  bus.ready = ready;
  bus.ready_context = ready_context;
  bus.busy = true;
  channel_config_set_transfer_data_size(&config, DMA_SIZE_8);
  channel_config_set_dreq(&config, spi_get_dreq(spi0, true));
  dma_channel_configure((uint)bus.channel, &config, &spi_get_hw(spi0)->dr, bytes, count, true);
  return FC_OK;
}

static int reset(void *context, bool active) {
  (void)wait(context);
  gpio_put(PIN_RESET, !active);
  return FC_OK;
}

static void delay_us(void *context, uint32_t us) {
  (void)context;
  sleep_us(us);
}

static int backlight(void *context, uint8_t level) {
  (void)context;
  gpio_put(PIN_BACKLIGHT, level != 0);
  return FC_OK;
}

static void output(uint pin, bool high) {
  gpio_init(pin);
  gpio_put(pin, high);
  gpio_set_dir(pin, GPIO_OUT);
}

fc_bus sdk_bus_start(void) {
  /* clang-format off */
  static const fc_bus_ops ops = {.configure = configure, .clock_hz = clock_hz, .command = command, .data = data, .data_start = data_start,
                                 .wait = wait, .reset = reset, .delay_us = delay_us, .backlight = backlight};
  /* clang-format on */
  const fc_bus result = {.ops = &ops, .context = NULL};
  output(PIN_CS, true);
  output(PIN_DC, true);
  output(PIN_RESET, true);
  output(PIN_BACKLIGHT, false);
  (void)spi_init(spi0, 1000000);
  gpio_set_function(PIN_SCK, GPIO_FUNC_SPI);
  gpio_set_function(PIN_MOSI, GPIO_FUNC_SPI);
  bus.channel = dma_claim_unused_channel(true);
  dma_channel_set_irq0_enabled((uint)bus.channel, true);
  irq_set_exclusive_handler(DMA_IRQ_0, dma_done);
  irq_set_enabled(DMA_IRQ_0, true);
  return result;
}
