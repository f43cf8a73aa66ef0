/* The board's pins: the Linux port behind the simulator's interface. */
#include "fixcast/error.h"
#include "linux_bus.h"
#include "scene_file.h"
#include "wire.h"

namespace host {
namespace {

const char *or_null(const std::string &text) { return text.empty() ? nullptr : text.c_str(); }

struct CloseBus {
  void operator()(fc_linux_bus *bus) const { fc_linux_bus_close(bus); }
};

struct CloseInput {
  void operator()(fc_linux_input *input) const { fc_linux_input_close(input); }
};

class Board : public Wire {
public:
  explicit Board(const Wiring &wiring) : spi_(wiring.spi) {
    fc_linux_error error{};
    const fc_linux_wiring pins = {or_null(wiring.spi), or_null(wiring.dc), or_null(wiring.reset), or_null(wiring.backlight)};
    bus_.reset(fc_linux_bus_open(&pins, &error));
    if (!bus_) throw UserError(error.text);
    for (const Wiring::Button &button : wiring.buttons) {
      inputs_.push_back({button.bit, std::unique_ptr<fc_linux_input, CloseInput>(fc_linux_input_open(button.line.c_str(), &error))});
      if (!inputs_.back().line) throw UserError(error.text);
    }
  }

  fc_bus bus() override { return fc_linux_bus_ops(bus_.get()); }

  std::string failure(int error) const override {
    const fc_linux_error *told = fc_linux_bus_error(bus_.get());
    return told->code == error ? told->text : spi_ + ": " + fc_error_text(error);
  }

  std::uint8_t buttons() override {
    std::uint8_t pressed = 0;
    for (const Input &input : inputs_) {
      fc_linux_error error{};
      const int level = fc_linux_input_read(input.line.get(), &error);
      if (level < 0) throw UserError(error.text);
      if (level == 0) pressed = static_cast<std::uint8_t>(pressed | input.bit);
    }
    return pressed;
  }

  WireFigures figures() const override {
    const fc_linux_bus_figures figures = fc_linux_bus_figures_get(bus_.get());
    return {figures.sent_bytes, 1e-9 * static_cast<double>(figures.sending_ns)};
  }

  std::string about() const override {
    return spi_ + " in transfers of at most " + std::to_string(fc_linux_bus_figures_get(bus_.get()).chunk_bytes) + " bytes";
  }

  bool real() const override { return true; }

private:
  struct Input {
    std::uint8_t bit;
    std::unique_ptr<fc_linux_input, CloseInput> line;
  };

  std::string spi_;
  std::unique_ptr<fc_linux_bus, CloseBus> bus_;
  std::vector<Input> inputs_;
};

} // namespace

std::unique_ptr<Wire> open_board(const Wiring &wiring) { return std::make_unique<Board>(wiring); }

} // namespace host
