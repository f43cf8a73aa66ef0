/* Ctrl-C and its kin as something to ask for. */
#include "stop_signal.h"

#include <algorithm>

namespace host {

StopSignal::StopSignal() {
  (void)sigemptyset(&waited_);
  (void)sigaddset(&waited_, SIGINT);
  (void)sigaddset(&waited_, SIGTERM);
  struct sigaction hangup {};
  if (sigaction(SIGHUP, nullptr, &hangup) == 0 && hangup.sa_handler != SIG_IGN) (void)sigaddset(&waited_, SIGHUP);
  (void)pthread_sigmask(SIG_BLOCK, &waited_, &before_);
}

StopSignal::~StopSignal() {
  /* One more that came meanwhile wants the same, and must not end what still has to be put away. */
  const timespec now{};
  while (sigtimedwait(&waited_, nullptr, &now) > 0) {
  }
  (void)pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool StopSignal::came_before(Clock::time_point time) {
  if (signal_ != 0) return true;
  for (;;) {
    const auto left = std::max(std::chrono::nanoseconds(0), std::chrono::nanoseconds(time - Clock::now()));
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
    timespec timeout{};
    timeout.tv_sec = static_cast<time_t>(seconds.count());
    timeout.tv_nsec = static_cast<long>((left - seconds).count());
    const int signal = sigtimedwait(&waited_, nullptr, &timeout);
    if (signal > 0) signal_ = signal;
    if (signal > 0 || Clock::now() >= time) return signal > 0; /* otherwise stopped and continued meanwhile */
  }
}

void StopSignal::wait() {
  while (signal_ == 0) {
    const int signal = sigwaitinfo(&waited_, nullptr);
    if (signal > 0) signal_ = signal;
  }
}

const char *StopSignal::name() const {
  switch (signal_) {
    case SIGINT: return "SIGINT";
    case SIGTERM: return "SIGTERM";
    case SIGHUP: return "SIGHUP";
    default: return "";
  }
}

} // namespace host
