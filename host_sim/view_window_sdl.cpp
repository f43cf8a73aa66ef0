/* The viewer in an SDL2 window. */
#include <SDL.h>
#include <zlib.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "report.h"
#include "sequence.h"
#include "view_window.h"

namespace host {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::uint16_t spin_step = 512; /* 1/128 of a turn */

[[noreturn]] void fail(const char *what) {
  throw UserError(std::string(what) + ": " + SDL_GetError() + "; view needs a screen (DISPLAY or WAYLAND_DISPLAY), render does not");
}

struct Quit {
  ~Quit() { SDL_Quit(); }
};

template <typename T, void (*destroy)(T *)>
struct Destroy {
  void operator()(T *object) const { destroy(object); }
};

double milliseconds(Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); }

class Window {
public:
  Window(Viewer &viewer, const WindowOptions &options) : viewer_(viewer), options_(options), turning_(options.spin || options.frames > 0) {
    if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("no window");
    zoom_ = options.zoom > 0 ? options.zoom : fitting_zoom();
    window_.reset(SDL_CreateWindow("fixcast", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, zoom_ * viewer.width(),
                                   zoom_ * viewer.height(), SDL_WINDOW_RESIZABLE));
    if (!window_) fail("no window");
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
    renderer_.reset(SDL_CreateRenderer(window_.get(), -1, 0));
    if (!renderer_) renderer_.reset(SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_SOFTWARE));
    if (!renderer_) fail("no drawing in the window");
    texture_.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGB24, SDL_TEXTUREACCESS_STREAMING, viewer.width(), viewer.height()));
    if (!texture_) fail("no picture in the window");
  }

  int run() {
    const Clock::time_point start = Clock::now();
    while (!done_) {
      take_events();
      if (done_) break;
      if (turning_ || step_) {
        viewer_.camera().spin(spin_step);
        step_ = false;
        stale_ = true;
      }
      if (stale_) {
        show_new_picture();
        if (options_.frames > 0 && pictures_ >= options_.frames) break;
      } else if (exposed_) {
        present();
      }
      exposed_ = false;
    }
    const double seconds = milliseconds(Clock::now() - start) / 1000;
    if (options_.log || options_.frames > 0)
      (void)std::printf("%d pictures in %.2f s, %.1f a second; at most %.1f ms from input to picture, %.1f for a picture\n", pictures_,
                        seconds, pictures_ / seconds, longest_wait_, longest_picture_);
    return 0;
  }

private:
  int fitting_zoom() const {
    SDL_Rect screen{};
    if (SDL_GetDisplayUsableBounds(0, &screen) != 0) return 1;
    return std::clamp(std::min(screen.w * 2 / 3 / viewer_.width(), screen.h * 2 / 3 / viewer_.height()), 1, 16);
  }

  /* All that have come: one picture answers them together, so that it is never more than one picture's work behind. */
  void take_events() {
    SDL_Event event;
    bool any = turning_ || stale_ || step_ ? SDL_PollEvent(&event) != 0 : SDL_WaitEvent(&event) != 0;
    while (any && !done_) {
      const bool was_stale = stale_;
      take(event);
      if (stale_ && !was_stale) oldest_event_ = Clock::now(), waiting_ = true;
      any = SDL_PollEvent(&event) != 0;
    }
  }

  void take(const SDL_Event &event) {
    switch (event.type) {
      case SDL_QUIT: done_ = true; break;
      case SDL_WINDOWEVENT:
        exposed_ = true;
        if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED)
          zoom_ = std::max(1, std::min(event.window.data1 / viewer_.width(), event.window.data2 / viewer_.height()));
        break;
      case SDL_KEYDOWN: take_key(event.key.keysym); break;
      case SDL_MOUSEBUTTONDOWN:
        if (event.button.button != SDL_BUTTON_LEFT) break;
        press_x_ = event.button.x;
        press_y_ = event.button.y;
        viewer_.camera().begin_drag();
        break;
      case SDL_MOUSEMOTION: take_motion(event.motion); break;
      case SDL_MOUSEWHEEL:
        viewer_.camera().dolly(event.wheel.y);
        stale_ = true;
        break;
      default: break;
    }
  }

  void take_motion(const SDL_MouseMotionEvent &motion) {
    int width = 0, height = 0;
    SDL_GetWindowSize(window_.get(), &width, &height);
    const bool shift = (SDL_GetModState() & KMOD_SHIFT) != 0;
    if ((motion.state & SDL_BUTTON_LMASK) != 0 && !shift) {
      viewer_.camera().roll(press_x_, press_y_, motion.x, motion.y, width, height);
      stale_ = true;
    } else if ((motion.state & (SDL_BUTTON_LMASK | SDL_BUTTON_RMASK | SDL_BUTTON_MMASK)) != 0) {
      viewer_.camera().pan(motion.xrel, motion.yrel, zoom_ * viewer_.width(), zoom_ * viewer_.height());
      stale_ = true;
    }
  }

  void take_key(const SDL_Keysym &key) {
    static constexpr const char *layers[] = {"color", "depth", "normal", "id", "shadow", "error"};
    const int step = std::max(1, viewer_.width() / 16);
    stale_ = true; /* nearly every key changes the picture */
    if (key.sym >= SDLK_1 && key.sym <= SDLK_6) {
      viewer_.show(layers[key.sym - SDLK_1]);
      return;
    }
    switch (key.sym) {
      case SDLK_p: viewer_.next_profile(); break;
      case SDLK_o: viewer_.next_offset(); break;
      case SDLK_z: viewer_.next_depth(); break;
      case SDLK_t: viewer_.next_transfer(); break;
      case SDLK_m: viewer_.next_samples(); break;
      case SDLK_d: viewer_.toggle_panel(); break;
      case SDLK_r: viewer_.camera().reset(); break;
      case SDLK_n: step_ = true; break;
      case SDLK_SPACE: turning_ = !turning_; break;
      case SDLK_g: grid_ = !grid_; break;
      case SDLK_PLUS:
      case SDLK_EQUALS:
      case SDLK_KP_PLUS: set_zoom(zoom_ + 1); break;
      case SDLK_MINUS:
      case SDLK_KP_MINUS: set_zoom(zoom_ - 1); break;
      case SDLK_LEFT: viewer_.camera().pan(-step, 0, viewer_.width(), viewer_.height()); break;
      case SDLK_RIGHT: viewer_.camera().pan(step, 0, viewer_.width(), viewer_.height()); break;
      case SDLK_UP: viewer_.camera().pan(0, -step, viewer_.width(), viewer_.height()); break;
      case SDLK_DOWN: viewer_.camera().pan(0, step, viewer_.width(), viewer_.height()); break;
      case SDLK_PAGEUP: viewer_.camera().dolly(1); break;
      case SDLK_PAGEDOWN: viewer_.camera().dolly(-1); break;
      case SDLK_s:
        stale_ = false;
        save_shot();
        break;
      case SDLK_h:
        stale_ = false;
        (void)std::fputs(view_keys, stdout);
        (void)std::fflush(stdout);
        break;
      case SDLK_q:
      case SDLK_ESCAPE: done_ = true; break;
      default: stale_ = false;
    }
  }

  void set_zoom(int zoom) {
    zoom_ = std::clamp(zoom, 1, 32);
    SDL_SetWindowSize(window_.get(), zoom_ * viewer_.width(), zoom_ * viewer_.height());
  }

  void show_new_picture() {
    const Clock::time_point start = Clock::now();
    picture_ = viewer_.render();
    const double took = milliseconds(Clock::now() - start);
    if (SDL_UpdateTexture(texture_.get(), nullptr, picture_.rgb.data(), 3 * picture_.width) != 0) fail("cannot show the picture");
    present();
    stale_ = false;
    pictures_++;
    smoothed_ = smoothed_ == 0 ? took : 0.9 * smoothed_ + 0.1 * took;
    longest_picture_ = std::max(longest_picture_, took);
    const double wait = waiting_ ? milliseconds(Clock::now() - oldest_event_) : 0;
    longest_wait_ = std::max(longest_wait_, wait);
    waiting_ = false;
    char rate[60];
    (void)std::snprintf(rate, sizeof rate, " - %.1f ms, %.0f a second", smoothed_, 1000 / std::max(smoothed_, 0.01));
    SDL_SetWindowTitle(window_.get(), ("fixcast " + viewer_.status() + rate).c_str());
    if (options_.log) {
      const auto crc = static_cast<std::uint32_t>(crc32_z(crc32_z(0, nullptr, 0), picture_.rgb.data(), picture_.rgb.size()));
      (void)std::printf("picture %d crc %s zoom %d grid %d turning %d; %s\n", pictures_, hex_text(crc).c_str(), zoom_, grid_ ? 1 : 0,
                        turning_ ? 1 : 0, viewer_.status().c_str());
      (void)std::fflush(stdout);
    }
  }

  /* The picture in the middle of the window, by whole pixels; the grid where pixels are large enough for lines. */
  void present() {
    int width = 0, height = 0;
    SDL_GetRendererOutputSize(renderer_.get(), &width, &height);
    const SDL_Rect to = {(width - zoom_ * viewer_.width()) / 2, (height - zoom_ * viewer_.height()) / 2, zoom_ * viewer_.width(),
                         zoom_ * viewer_.height()};
    SDL_SetRenderDrawColor(renderer_.get(), 40, 40, 40, 255);
    SDL_RenderClear(renderer_.get());
    SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, &to);
    if (grid_ && zoom_ >= 3) {
      SDL_SetRenderDrawColor(renderer_.get(), 90, 90, 90, 255);
      for (int x = 0; x <= viewer_.width(); x++)
        SDL_RenderDrawLine(renderer_.get(), to.x + x * zoom_, to.y, to.x + x * zoom_, to.y + to.h - 1);
      for (int y = 0; y <= viewer_.height(); y++)
        SDL_RenderDrawLine(renderer_.get(), to.x, to.y + y * zoom_, to.x + to.w - 1, to.y + y * zoom_);
    }
    SDL_RenderPresent(renderer_.get());
  }

  /* The picture at its own size, under the first number that is free. */
  void save_shot() {
    std::error_code ignored;
    for (int number = 0; number < 10000; number++) {
      const std::string path = sequence_name(options_.shots, number);
      if (std::filesystem::exists(path, ignored)) continue;
      (void)std::printf("wrote %s\n", write_image(path, picture_).c_str());
      (void)std::fflush(stdout);
      return;
    }
  }

  Viewer &viewer_;
  const WindowOptions &options_;
  Quit quit_; /* destroyed after the three below */
  std::unique_ptr<SDL_Window, Destroy<SDL_Window, SDL_DestroyWindow>> window_;
  std::unique_ptr<SDL_Renderer, Destroy<SDL_Renderer, SDL_DestroyRenderer>> renderer_;
  std::unique_ptr<SDL_Texture, Destroy<SDL_Texture, SDL_DestroyTexture>> texture_;
  Image8 picture_;
  int zoom_ = 1, pictures_ = 0, press_x_ = 0, press_y_ = 0;
  bool turning_, done_ = false, stale_ = true, exposed_ = false, step_ = false, grid_ = false, waiting_ = false;
  double smoothed_ = 0, longest_wait_ = 0, longest_picture_ = 0;
  Clock::time_point oldest_event_;
};

} // namespace

int run_window(Viewer &viewer, const WindowOptions &options) { return Window(viewer, options).run(); }

} // namespace host
