/* The core's frame against the oracle. */
#include "compare.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "progress.h"

namespace host {
namespace {

constexpr int thread_count = 2;

/* What one row adds; rows are summed in order, so that the result doesn't depend on the threads. */
struct Row {
  Comparison sums;
  double colour_square_sum = 0;
};

struct ColourError {
  double largest = 0, square_sum = 0;
};

/* What a display of this transfer function has to be told to show a light, both in 0..255. */
double encoded(double level, const fc_transfer *transfer) {
  const double light = level / 255;
  if (transfer == &fc_transfer_gamma22) return 255 * std::pow(light, 1 / 2.2);
  if (transfer == &fc_transfer_srgb) return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
  return level;
}

ColourError colour_error(const std::uint8_t *core, const OracleAnswer &answer, const fc_transfer *transfer) {
  ColourError error;
  for (std::size_t c = 0; c < 3; c++) {
    const double difference = std::fabs(core[c] - encoded(answer.colour[c], transfer));
    error.largest = std::max(error.largest, difference);
    error.square_sum += difference * difference;
  }
  return error;
}

class Comparer {
public:
  Comparer(const SceneFile &file, const Oracle &oracle, const CoreFrame &frame, const Picture &picture)
      : oracle_(oracle),
        frame_(frame),
        picture_(picture),
        lights_(file.lights.size()),
        rows_(static_cast<std::size_t>(picture.height)),
        error_(picture.object.size()),
        truth_{picture.width, picture.height, std::vector<std::uint8_t>(3 * picture.object.size())} {}

  Comparison run() {
    std::vector<std::thread> threads;
    for (int t = 0; t < thread_count; t++)
      threads.emplace_back([this, t] { work(t); });
    watch();
    for (std::thread &thread : threads)
      thread.join();
    if (failure_) std::rethrow_exception(failure_);
    return total();
  }

private:
  void work(int first_row) {
    try {
      for (int y = first_row; y < picture_.height && !stop_; y += thread_count) {
        for (int x = 0; x < picture_.width; x++)
          compare_pixel(x, y, rows_[static_cast<std::size_t>(y)]);
        done_++;
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      failure_ = std::current_exception();
      stop_ = true;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    finished_++;
    changed_.notify_one();
  }

  void watch() {
    Progress progress("comparing with the oracle", rows_.size());
    std::unique_lock<std::mutex> lock(mutex_);
    while (!changed_.wait_for(lock, std::chrono::milliseconds(200),
                              [this] { return finished_ == thread_count; }))
      progress.update(done_);
  }

  void compare_pixel(int x, int y, Row &row) {
    const std::size_t i =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x);
    const OraclePixel truth = oracle_.pixel(x, y);
    const std::uint8_t *rgb = &picture_.pixels[3 * i];
    if (truth.escalated) row.sums.escalated++;
    if (truth.tie) row.sums.ties++;

    /* The nearest admissible answer: object first, then light, then colour. */
    const OracleAnswer *best = nullptr;
    int best_rank = -1;
    ColourError best_error;
    for (const OracleAnswer &answer : truth.answers) {
      const bool object = answer.object == picture_.object[i];
      const int rank = !object ? 0 : same_light(picture_.lit[i], answer, lights_) ? 2
                                                                                  : 1;
      const ColourError error = colour_error(rgb, answer, frame_.get().options.transfer);
      if (rank > best_rank || (rank == best_rank && error.square_sum < best_error.square_sum)) {
        best = &answer;
        best_rank = rank;
        best_error = error;
      }
    }
    if (best_rank == 0) row.sums.wrong_id++;
    if (best_rank == 1) row.sums.wrong_shadow++;
    if (best_rank > 0 && best->object != 0) count_light_tests(picture_.lit[i], best->lit, row.sums);
    if (best_rank < 2) {
      const OracleAnswer &first = truth.answers.front();
      row.sums.wrong.push_back(
          {x, y, best_rank == 0, picture_.object[i], first.object, picture_.lit[i], first.lit});
    }
    const fc_transfer *transfer = frame_.get().options.transfer;
    std::array<double, 3> shown{};
    for (std::size_t c = 0; c < 3; c++) shown[c] = encoded(best->colour[c], transfer);
    if (best_rank == 2 && best_error.largest > 1) row.sums.off.push_back({x, y, {rgb[0], rgb[1], rgb[2]}, shown});
    error_[i] = static_cast<float>(best_error.largest);
    for (std::size_t c = 0; c < 3; c++) truth_.rgb[3 * i + c] = static_cast<std::uint8_t>(std::lround(shown[c]));
    row.colour_square_sum += best_error.square_sum;
    row.sums.colour_max = std::max(row.sums.colour_max, best_error.largest);
    if (best_rank > 0 && best->depth > 0 && !picture_.depth.empty())
      row.sums.depth_rel_max = std::max(row.sums.depth_rel_max, depth_error(picture_.depth[i], best->depth));
  }

  void count_light_tests(std::uint32_t core_lit, std::uint32_t true_lit, Comparison &sums) const {
    const std::size_t lights = std::min<std::size_t>(lights_, 31); /* the core's last bit may stand for several */
    sums.light_tests += lights;
    for (std::size_t light = 0; light < lights; light++) {
      const bool core = (core_lit >> light & 1) != 0, truth = (true_lit >> light & 1) != 0;
      if (truth && !core) sums.false_shadows++;
      if (core && !truth) sums.leaks++;
    }
  }

  double depth_error(std::uint16_t code, double true_z) const {
    if (code == 0) return 1; /* "nothing there" on a surface: as wrong as can be */
    return std::fabs(frame_.depth_z(code) - true_z) / true_z;
  }

  Comparison total() {
    Comparison sum;
    double squares = 0;
    for (const Row &row : rows_) {
      const Comparison &r = row.sums;
      sum.wrong_id += r.wrong_id;
      sum.wrong_shadow += r.wrong_shadow;
      sum.light_tests += r.light_tests;
      sum.false_shadows += r.false_shadows;
      sum.leaks += r.leaks;
      sum.escalated += r.escalated;
      sum.ties += r.ties;
      sum.colour_max = std::max(sum.colour_max, r.colour_max);
      sum.depth_rel_max = std::max(sum.depth_rel_max, r.depth_rel_max);
      sum.wrong_colour += r.off.size();
      sum.off.insert(sum.off.end(), r.off.begin(), r.off.end());
      sum.wrong.insert(sum.wrong.end(), r.wrong.begin(), r.wrong.end());
      squares += row.colour_square_sum;
    }
    sum.colour_rmse = std::sqrt(squares / static_cast<double>(picture_.pixels.size()));
    sum.error = std::move(error_);
    sum.truth = std::move(truth_);
    return sum;
  }

  const Oracle &oracle_;
  const CoreFrame &frame_;
  const Picture &picture_;
  const std::size_t lights_;
  std::vector<Row> rows_;
  std::vector<float> error_; /* these two and rows_: a row is one thread's */
  Image8 truth_;

  std::atomic<bool> stop_{false};
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_; /* of the three below */
  std::condition_variable changed_;
  int finished_ = 0;
  std::exception_ptr failure_;
};

} // namespace

bool same_light(std::uint32_t core_lit, const OracleAnswer &answer, std::size_t lights) {
  if ((core_lit != 0) != answer.any_light) return false;
  const std::uint32_t mask = lights > 32 ? 0x7fffffffu : 0xffffffffu;
  return (core_lit & mask) == (answer.lit & mask);
}

Comparison compare(const SceneFile &file, const Oracle &oracle, const CoreFrame &frame,
                   const Picture &picture) {
  return Comparer(file, oracle, frame, picture).run();
}

} // namespace host
