/* How far a long job is and how long it will take. */
#include "progress.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include <unistd.h>

namespace host {

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (shown_) (void)std::fputs("\r\033[K", stderr);
}

void Progress::update(std::size_t done) {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (!terminal_ || seconds < 1 || done == 0 || total_ == 0) return;
  const double part = std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
  constexpr std::size_t width = 24;
  const auto full = static_cast<std::size_t>(part * width);
  const std::string bar = std::string(full, '#') + std::string(width - full, '.');
  (void)std::fprintf(stderr, "\r%s [%s] %.0f %%, %.0f s left\033[K", what_.c_str(), bar.c_str(), 100 * part,
                     seconds * (1 - part) / part);
  (void)std::fflush(stderr);
  shown_ = true;
}

} // namespace host
