/* A dry run: the byte stream of a panel, written down instead of sent. */
#include <cstdio>
#include <string>

#include <zlib.h>

#include "fixcast/error.h"
#include "wire.h"

namespace host {
namespace {

constexpr std::size_t bytes_shown = 16; /* of a command's data; of more, their number and checksum */

class DryRun : public Wire {
public:
  explicit DryRun(const Wiring &wiring) {
    ops_.configure = configure;
    ops_.clock_hz = [](void *self) { return static_cast<DryRun *>(self)->hz_; };
    ops_.command = command;
    ops_.data = data;
    ops_.delay_us = delay;
    if (!wiring.reset.empty()) ops_.reset = reset;
    if (!wiring.backlight.empty()) ops_.backlight = backlight;
  }

  ~DryRun() override {
    end_line();
    std::printf("in all: %llu commands, %llu data bytes, crc32 %08lx (two bytes a byte: D/C, value), %.1f ms of waiting; the wire takes %.1f ms\n",
                commands_, data_bytes_, stream_crc_, waited_us_ / 1e3, 1e3 * seconds_);
  }

  fc_bus bus() override { return {&ops_, this}; }

  std::string failure(int error) const override { return fc_error_text(error); }

  std::uint8_t buttons() override { return 0; }

  WireFigures figures() const override { return {commands_ + data_bytes_, seconds_}; }

  std::string about() const override { return "no wire (--dry-run)"; }

  void end_of_frame() override { end_line(); }

  bool real() const override { return false; }

private:
  static int configure(void *context, std::uint32_t hz, std::uint8_t mode) {
    DryRun &self = *static_cast<DryRun *>(context);
    self.end_line();
    self.hz_ = hz;
    std::printf("clock %lu Hz, SPI mode %d\n", static_cast<unsigned long>(hz), mode);
    return mode == 0 || mode == 3 ? FC_OK : FC_ERR_UNSUPPORTED;
  }

  static int command(void *context, const std::uint8_t *bytes, std::size_t count) {
    DryRun &self = *static_cast<DryRun *>(context);
    self.end_line();
    self.line_open_ = true;
    for (std::size_t i = 0; i < count; i++) std::printf(i == 0 ? "%02X" : " %02X", bytes[i]);
    self.commands_ += count;
    self.sent(0, bytes, count);
    return FC_OK;
  }

  static int data(void *context, const std::uint8_t *bytes, std::size_t count) {
    DryRun &self = *static_cast<DryRun *>(context);
    for (std::size_t i = 0; i < count && self.line_bytes_ + i < bytes_shown; i++)
      self.line_text_ += std::string(" ") + hex(bytes[i]);
    self.line_bytes_ += count;
    self.line_crc_ = crc32_z(self.line_crc_, bytes, count);
    self.data_bytes_ += count;
    self.sent(1, bytes, count);
    return FC_OK;
  }

  static int reset(void *context, bool active) {
    static_cast<DryRun *>(context)->end_line();
    std::printf("reset %s\n", active ? "low" : "high");
    return FC_OK;
  }

  static int backlight(void *context, std::uint8_t level) {
    static_cast<DryRun *>(context)->end_line();
    std::printf("backlight %s\n", level != 0 ? "on" : "off");
    return FC_OK;
  }

  static void delay(void *context, std::uint32_t us) {
    DryRun &self = *static_cast<DryRun *>(context);
    self.end_line();
    self.waited_us_ += us;
    std::printf("wait %g ms\n", us / 1e3);
  }

  static std::string hex(std::uint8_t byte) {
    char text[3];
    (void)std::snprintf(text, sizeof text, "%02x", byte);
    return text;
  }

  void sent(std::uint8_t dc, const std::uint8_t *bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; i++) {
      const std::uint8_t pair[2] = {dc, bytes[i]};
      stream_crc_ = crc32_z(stream_crc_, pair, sizeof pair);
    }
    if (hz_ != 0) seconds_ += 8.0 * static_cast<double>(count) / hz_;
  }

  void end_line() {
    if (!line_open_) return;
    if (line_bytes_ > bytes_shown) std::printf(" + %llu bytes, crc32 %08lx\n", line_bytes_, line_crc_);
    else std::printf("%s\n", line_text_.c_str());
    line_open_ = false;
    line_text_.clear();
    line_bytes_ = 0;
    line_crc_ = 0;
  }

  fc_bus_ops ops_{};
  std::uint32_t hz_ = 0;
  unsigned long long commands_ = 0, data_bytes_ = 0, line_bytes_ = 0;
  unsigned long stream_crc_ = 0, line_crc_ = 0;
  double waited_us_ = 0, seconds_ = 0;
  bool line_open_ = false;
  std::string line_text_;
};

} // namespace

std::unique_ptr<Wire> open_dry_run(const Wiring &wiring) { return std::make_unique<DryRun>(wiring); }

} // namespace host
