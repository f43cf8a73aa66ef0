/* Ctrl-C and its kin as something to ask for, so that a program can finish what it is at. */
#ifndef FIXCAST_HOST_STOP_SIGNAL_H
#define FIXCAST_HOST_STOP_SIGNAL_H

#include <chrono>

#include <signal.h>

namespace host {

/*
 * While an object lives, SIGINT, SIGTERM and SIGHUP are kept until asked for (SIGHUP not where it was ignored before: nohup). Make it before any
 * thread, so that no thread takes them. No handler runs, so nothing is interrupted half-way.
 */
class StopSignal {
public:
  using Clock = std::chrono::steady_clock;

  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal &) = delete;
  StopSignal &operator=(const StopSignal &) = delete;

  /* Whether one has come, now or earlier. */
  bool came() { return came_before(Clock::now()); }

  /* Waits until one comes (true) or until `time`; at once when one has come before. */
  bool came_before(Clock::time_point time);

  /* Waits until one comes. */
  void wait();

  /* "SIGINT", or "" when none has come. */
  const char *name() const;

private:
  sigset_t waited_, before_;
  int signal_ = 0;
};

} // namespace host

#endif
