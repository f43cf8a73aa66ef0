/*
 * How far a long job is and how long it will take, on stderr, for a person at a terminal only.
 */
#ifndef FIXCAST_HOST_PROGRESS_H
#define FIXCAST_HOST_PROGRESS_H

#include <chrono>
#include <cstddef>
#include <string>

namespace host {

class Progress {
public:
  Progress(std::string what, std::size_t total);
  ~Progress(); /* wipes the line */
  Progress(const Progress &) = delete;
  Progress &operator=(const Progress &) = delete;

  /* `done` of the total: a bar, the percentage and the time left. Silent in the first second. */
  void update(std::size_t done);

private:
  std::string what_;
  std::size_t total_;
  bool terminal_, shown_ = false;
  std::chrono::steady_clock::time_point start_;
};

} // namespace host

#endif
