/*
 * What carries a panel's bytes: a board's pins, or a dry run that only writes down what would be sent.
 */
#ifndef FIXCAST_HOST_WIRE_H
#define FIXCAST_HOST_WIRE_H

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fixcast/bus.h"

namespace host {

/* Names as typed; empty: not wired. */
struct Wiring {
  struct Button {
    std::uint8_t bit; /* FC_BUTTON_ of src/firmware/firmware.h */
    std::string line;
  };
  std::string spi, dc, reset, backlight;
  std::vector<Button> buttons; /* to ground: low is pressed */
};

struct WireFigures {
  std::uint64_t sent_bytes = 0;
  double sending_seconds = 0;
};

class Wire {
public:
  Wire() = default;
  Wire(const Wire &) = delete;
  Wire &operator=(const Wire &) = delete;
  virtual ~Wire() = default; /* lines released, device closed */

  /* Valid as long as this object. */
  virtual fc_bus bus() = 0;

  /* A sentence for an error that an operation of the bus has returned. */
  virtual std::string failure(int error) const = 0;

  /* FC_BUTTON_ bits, 1 while pressed. Throws UserError. */
  virtual std::uint8_t buttons() = 0;

  /* While nothing is under way. */
  virtual WireFigures figures() const = 0;

  /* What is known of it beside the clock, for the line that says where the picture goes: "/dev/spidev0.0 in transfers of 4096 bytes". */
  virtual std::string about() const = 0;

  /* Called between frames: what was held back for a line of text is printed. */
  virtual void end_of_frame() {}

  /* Whether time passes on it: whether frames are to be paced. */
  virtual bool real() const = 0;
};

/* The board's pins. Throws UserError; always where the program was built without libgpiod. */
std::unique_ptr<Wire> open_board(const Wiring &wiring);

/* Prints each command and what follows it, as it would be sent; a total at the end of its life. */
std::unique_ptr<Wire> open_dry_run(const Wiring &wiring);

/* What the board offers: SPI devices, GPIO chips and lines. Throws UserError where the program was built without libgpiod. */
std::string describe_board();

} // namespace host

#endif
