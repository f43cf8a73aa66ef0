/*
 * The wires to a display: bytes with a command/data line, reset, time. A port (src/port) fills one in; a panel (panel.h) and
 * tests use it and know no more of the board.
 *
 * Every function returns FC_OK or a negative number: an fc_error, or the port's own code, which callers pass on unchanged.
 * After an error the bus is idle again: no transfer is under way, and the chip select is inactive.
 */
#ifndef FIXCAST_BUS_H
#define FIXCAST_BUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Called once when the bytes of an asynchronous transfer have left or it has failed, with `error` FC_OK or negative. It may run in an interrupt
 * or on another thread; the bytes are the caller's again once it has been called. */
typedef void fc_ready(void *context, int error);

/* The functions of a bus. Each returns FC_OK or a negative error of the port's, which is passed on unchanged. */
typedef struct fc_bus_ops {
  /* The fastest clock of at most `hz` (never above it), SPI mode 0 or 3 (CPOL = CPHA), eight bits, most significant first. Called
   * before the first byte and whenever either changes. Errors: FC_ERR_UNSUPPORTED when there is no such clock or mode. */
  int (*configure)(void *context, uint32_t hz, uint8_t spi_mode);
  /* The clock that the last configure() gave, in Hz as it is, not as it was asked for. 0: not known. */
  uint32_t (*clock_hz)(void *context);
  /* `count` bytes with D/C low (command) or high (data), count >= 1. Returns when the last bit has been shifted out, so that D/C may change.
   * A transfer that was started before is waited for. */
  int (*command)(void *context, const uint8_t *bytes, size_t count);
  int (*data)(void *context, const uint8_t *bytes, size_t count);
  /* Starts `count` bytes with D/C high and returns; `bytes` must stay as they are until `ready` (may be NULL) was called or wait()
   * returned. A transfer that was started before is waited for. NULL: this bus has no such thing (callers use data). */
  int (*data_start)(void *context, const uint8_t *bytes, size_t count, fc_ready *ready, void *ready_context);
  /* Until nothing is under way and the last bit has left: the error of the transfer that was. NULL when data_start is. */
  int (*wait)(void *context);
  /* Holds the panel's reset line active, or lets go. NULL: not wired (a panel then relies on its software reset). */
  int (*reset)(void *context, bool active);
  /* At least `us` microseconds. Required. */
  void (*delay_us)(void *context, uint32_t us);
  /* 0 (off) to 255 (brightest); a switched light takes anything above 0 as on. NULL: not wired. */
  int (*backlight)(void *context, uint8_t level);
  /* Until the panel's tearing-effect line says that it starts a refresh. NULL: not wired. */
  int (*wait_vsync)(void *context);
} fc_bus_ops;

/* `ops` is constant data that can be read through a pointer (on AVR: not PROGMEM). The context is the port's and must live as long as
 * anything that uses the bus. */
typedef struct fc_bus {
  const fc_bus_ops *ops;
  void *context;
} fc_bus;

#ifdef __cplusplus
}
#endif

#endif
