/* fixcast show: a scene, turning, or the bring-up pattern, on a panel that is wired to the board. */
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "animation.h"
#include "camera_path.h"
#include "commands.h"
#include "fixcast/panel.h"
#include "frame_run.h"
#include "panel_list.h"
#include "scene_options.h"
#include "stop_signal.h"
#include "wire.h"

extern "C" {
#include "controls.h"
#include "firmware.h"
#include "orbit.h"
#include "pattern.h"
}

namespace host {
namespace {

struct ShowOptions : SceneOptions {
  std::string panel;
  Wiring wiring;
  std::vector<std::string> buttons; /* WHAT=LINE */
  fc_panel_options panel_options{};
  AnimationOptions animation;
  bool pattern = false, dry_run = false, keep = false, crc = false, half_turn = false, twelve_bit = false;
};

/* The scene as the camera goes round it and the buttons have it. */
class TurningScene : public PictureSource {
public:
  TurningScene(const SceneOptions &options, Wire &wire)
      : options_(options), scene_(load_scene(options)), orbit_(make_camera_path("orbit", scene_.file, scene_.core)), wire_(wire) {
    fc_controls_start(&controls_);
    depth_.resize(static_cast<std::size_t>(scene_.width) * static_cast<std::size_t>(scene_.height));
  }

  void begin() override {
    if (begun_) fc_controls_advance(&controls_);
    fc_controls_buttons(&controls_, wire_.buttons());
    begun_ = true;
    if (controls_.pattern) return;
    scene_.core.camera = camera(controls_.step);
    frame_ = std::make_unique<CoreFrame>(scene_.file, scene_.core, scene_.options, scene_.width, scene_.height);
  }

  void rows(std::uint16_t y, std::uint16_t rows, std::uint8_t *pixels) override {
    if (controls_.pattern) {
      fc_pattern_rows(static_cast<std::uint16_t>(scene_.width), static_cast<std::uint16_t>(scene_.height), y, rows, pixels);
      return;
    }
    fc_target target{};
    target.pixels = pixels;
    target.pitch_bytes = static_cast<std::size_t>(scene_.width) * 2;
    target.format = FC_RGB565_BE;
    target.depth = depth_.data();
    const int error = fc_render_profile(&frame_->get(), 0, y, rows, &target);
    if (error < 0) throw UserError(scene_.file.path + ": cannot render: " + fc_error_text(error));
  }

private:
  /* Converting a large scene costs more than drawing it: each view is converted once. */
  const fc_camera &camera(unsigned step) {
    if (!cameras_[step]) cameras_[step] = prepare_scene(options_, orbit_->at(static_cast<int>(step), FC_ORBIT_STEPS)).core.camera;
    return *cameras_[step];
  }

  SceneOptions options_;
  LoadedScene scene_;
  std::unique_ptr<CameraPath> orbit_;
  std::optional<fc_camera> cameras_[FC_ORBIT_STEPS];
  Wire &wire_;
  fc_controls controls_{};
  bool begun_ = false;
  std::vector<std::uint16_t> depth_;
  std::unique_ptr<CoreFrame> frame_;
};

class Pattern : public PictureSource {
public:
  Pattern(std::uint16_t width, std::uint16_t height) : width_(width), height_(height) {}

  void begin() override {}

  void rows(std::uint16_t y, std::uint16_t rows, std::uint8_t *pixels) override { fc_pattern_rows(width_, height_, y, rows, pixels); }

private:
  std::uint16_t width_, height_;
};

/* WHAT=LINE to a bit and a name. */
Wiring::Button to_button(const std::string &text) {
  const std::pair<const char *, std::uint8_t> known[] = {{"pause", FC_BUTTON_PAUSE},
                                                         {"faster", FC_BUTTON_FASTER},
                                                         {"slower", FC_BUTTON_SLOWER},
                                                         {"reverse", FC_BUTTON_REVERSE},
                                                         {"pattern", FC_BUTTON_PATTERN}};
  const std::size_t equals = text.find('=');
  if (equals != std::string::npos && equals + 1 < text.size())
    for (const auto &entry : known)
      if (text.substr(0, equals) == entry.first) return {entry.second, text.substr(equals + 1)};
  throw UserError("--button " + text + ": give WHAT=LINE, WHAT one of pause, faster, slower, reverse, pattern, such as pause=GPIO5");
}

/* All that can be told from the command line alone. */
void check(const ShowOptions &options) {
  if (options.pattern != options.scene.empty())
    throw UserError(options.pattern ? "show takes a scene or --pattern, not both" : "show needs a SCENE to show, or --pattern");
  if (options.profile == "interlaced") throw UserError("--profile interlaced: show sends whole frames; take exact, fast or half");
  if (options.dry_run) return;
  if (options.wiring.spi.empty() || options.wiring.dc.empty())
    throw UserError("show needs --spi and --dc, or --dry-run; 'fixcast probe' lists what this board has");
}

std::unique_ptr<PictureSource> open_source(ShowOptions options, const fc_panel &panel, Wire &wire) {
  if (options.pattern) return std::make_unique<Pattern>(panel.width, panel.height);
  options.size = std::to_string(panel.width) + "x" + std::to_string(panel.height);
  return std::make_unique<TurningScene>(options, wire);
}

std::string rate(double per_second) {
  char text[32];
  (void)std::snprintf(text, sizeof text, "%.1f fps", per_second);
  return text;
}

std::size_t frame_bytes(const fc_display &display) {
  fc_display_capabilities can{};
  fc_display_capabilities_get(&display, &can);
  return fc_display_row_bytes(can.format, can.width) * (can.format == FC_DISPLAY_MONO8 ? can.height / 8u : can.height);
}

void say_start(const fc_panel &panel, const fc_display &display, const fc_bus &bus, const Wire &wire, std::uint32_t asked_hz) {
  fc_display_capabilities can{};
  fc_display_capabilities_get(&display, &can);
  const std::uint32_t hz = bus.ops->clock_hz(bus.context);
  const std::size_t bytes = frame_bytes(display);
  std::printf("%s, %ux%u %s, on %s\n", panel.name, static_cast<unsigned>(can.width), static_cast<unsigned>(can.height), format_name(can.format),
              wire.about().c_str());
  std::printf("clock: %lu Hz asked for, %lu Hz set; a frame has %zu bytes, so the wire allows %s\n", static_cast<unsigned long>(asked_hz),
              static_cast<unsigned long>(hz), bytes, rate(hz / 8.0 / static_cast<double>(bytes)).c_str());
  (void)std::fflush(stdout);
}

void say_end(const AnimationFigures &figures, const Wire &wire, const WireFigures &before, const StopSignal &stop) {
  const WireFigures after = wire.figures();
  const double sending = after.sending_seconds - before.sending_seconds, bytes = static_cast<double>(after.sent_bytes - before.sent_bytes);
  if (figures.stopped) std::printf("ended by %s\n", stop.name());
  if (figures.frames == 0) return;
  std::printf("%u %s in %.2f s: %s; drawing took %.1f ms a frame, sending %.1f ms", figures.frames, figures.frames == 1 ? "frame" : "frames",
              figures.seconds, rate(figures.frames / figures.seconds).c_str(), 1e3 * figures.drawing_seconds / figures.frames,
              1e3 * sending / figures.frames);
  if (sending > 0) std::printf(" (%.2f Mbit/s)", 8e-6 * bytes / sending);
  std::printf("\n");
}

/* A panel that is switched off at the end, whatever happens, unless it is kept. */
class RunningPanel {
public:
  RunningPanel(const fc_panel &panel, const fc_bus &bus, const fc_panel_options &options) {
    error = fc_panel_start(&state_, &panel, &bus, &options, &display);
    if (error != FC_OK) (void)fc_panel_stop(&state_);
    running_ = error == FC_OK;
  }

  ~RunningPanel() {
    if (running_) (void)fc_panel_stop(&state_);
  }

  RunningPanel(const RunningPanel &) = delete;
  RunningPanel &operator=(const RunningPanel &) = delete;

  int stop() {
    running_ = false;
    return fc_panel_stop(&state_);
  }

  void keep() { running_ = false; }

  fc_display display{};
  int error;

private:
  fc_panel_state state_{};
  bool running_;
};

void must(const Wire &wire, int error) {
  if (error != FC_OK) throw UserError(wire.failure(error));
}

int run_show(ShowOptions options) {
  check(options);
  const fc_panel &panel = find_panel(options.panel);
  for (const std::string &button : options.buttons) options.wiring.buttons.push_back(to_button(button));
  options.panel_options.half_turn = options.half_turn;
  options.panel_options.twelve_bit = options.twelve_bit;
  if (options.twelve_bit && panel.format12 == nullptr)
    throw UserError("--twelve-bit: panel " + options.panel + " has no such format; leave it out");
  options.animation.whole_frames = options.keep;
  /* The pattern stands still, and a dry run never ends by itself. */
  const bool wait_at_end = options.pattern && options.animation.frames == 0 && !options.keep && !options.dry_run;
  if (options.animation.frames == 0 && (options.pattern || options.dry_run)) options.animation.frames = 1;

  StopSignal stop;
  const std::unique_ptr<Wire> wire = options.dry_run ? open_dry_run(options.wiring) : open_board(options.wiring);
  const std::unique_ptr<PictureSource> source = open_source(options, panel, *wire);
  if (!wire->real()) options.animation.fps = 0;
  const fc_bus bus = wire->bus();
  RunningPanel running(panel, bus, options.panel_options);
  must(*wire, running.error);
  say_start(panel, running.display, bus, *wire, options.panel_options.pixel_hz != 0 ? options.panel_options.pixel_hz : panel.pixel_hz);

  const WireFigures before = wire->figures();
  bool lit = bus.ops->backlight == nullptr;
  int light_error = FC_OK;
  const AnimationFigures figures = animate(running.display, *source, options.animation, stop, [&](unsigned frame, std::uint32_t crc) {
    wire->end_of_frame();
    if (options.crc) {
      std::printf("frame %u crc32 %08lx\n", frame, static_cast<unsigned long>(crc));
      (void)std::fflush(stdout);
    }
    if (!lit) light_error = fc_display_backlight(&running.display, 255);
    lit = true;
  });
  must(*wire, figures.error);
  must(*wire, light_error);
  if (wait_at_end && !figures.stopped) {
    std::printf("the pattern is shown until Ctrl-C\n");
    (void)std::fflush(stdout);
    stop.wait();
  }
  say_end(figures, *wire, before, stop);
  if (options.keep) running.keep();
  else must(*wire, running.stop());
  return 0;
}

} // namespace

void add_show_command(CLI::App &app, Action &action) {
  const auto options = std::make_shared<ShowOptions>();
  CLI::App *command = app.add_subcommand("show", "Show a scene, turning, on a panel wired to this board's SPI and GPIO pins");
  add_plain_scene_options(*command, *options)->required(false);
  command->add_option("--panel", options->panel, "which panel; 'fixcast panels' lists them")->required()->type_name("NAME");
  command->add_option("--spi", options->wiring.spi, "SPI device, such as /dev/spidev0.0; 'fixcast probe' lists them")->type_name("DEVICE");
  command->add_option("--dc", options->wiring.dc, "line of the panel's D/C pin: a name such as GPIO25, or CHIPLABEL:OFFSET")->type_name("LINE");
  command->add_option("--reset", options->wiring.reset, "line of the panel's reset pin; without: reset by a command")->type_name("LINE");
  command->add_option("--backlight", options->wiring.backlight, "line that switches the light, high is on")->type_name("LINE");
  command
      ->add_option("--button", options->buttons,
                   "a button to ground that steers: pause, faster, slower, reverse or pattern; may be repeated")
      ->type_name("WHAT=LINE");
  command->add_option("--hz", options->panel_options.pixel_hz, "clock for pixels; default: the panel's fastest")
      ->type_name("HZ")
      ->check(CLI::Range(1000u, 1000000000u));
  command->add_flag("--half-turn", options->half_turn, "upside down");
  command->add_flag("--twelve-bit", options->twelve_bit, "4096 dithered colours, three quarters of the bytes");
  command->add_flag("--pattern", options->pattern, "the bring-up pattern in place of a scene: red, green, blue bars, a white border, an arrow up");
  command->add_option("--fps", options->animation.fps, "at most so many frames a second; default: as many as can be")
      ->type_name("F")
      ->check(CLI::Range(0.001, 1000.0));
  command->add_option("--frames", options->animation.frames, "how many frames to show; default: until Ctrl-C, with --dry-run 1")
      ->type_name("N")
      ->check(CLI::Range(1u, 1000000000u));
  command->add_option("--strip", options->animation.strip_rows, "rows that are drawn and sent at a time; default: 16")
      ->type_name("ROWS")
      ->check(CLI::Range(1, static_cast<int>(FC_SIZE_MAX)));
  add_offset_option(*command, *options);
  add_profile_option(*command, *options);
  add_transfer_option(*command, *options);
  command->add_flag("--crc", options->crc, "print the CRC-32 of each frame's RGB565 pixels");
  command->add_flag("--keep", options->keep, "leave the last frame on the panel; default: the panel is switched off");
  command->add_flag("--dry-run", options->dry_run, "open no device; print what would be sent");
  command->callback([&action, options] { action = [options] { return run_show(*options); }; });
}

} // namespace host
