/* The runner: picks families, spreads their trials over threads, keeps its place in a file, shows how to
 * replay. */
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "trial.h"

namespace {

const char usage[] =
    "torture [--family N] [--trials N | --full] [--seed S] [--jobs J] [--state FILE]\n"
    "  --family N    this family only (default: all)\n"
    "  --trials N    trials of each family (default 3000)\n"
    "  --full        the long run: each family has its own number of trials, more than 10^9 in all\n"
    "  --seed S      the first trial's seed; trial i has seed S + i (default: family * 2^56)\n"
    "  --jobs J      threads (default 1)\n"
    "  --state FILE  keep the place there; an interrupted run goes on from it\n";

/* Trials that one thread takes at a time. */
struct Chunk {
  const Family *family;
  uint64_t first_seed, count;
};

struct Options {
  int family = 0, jobs = 1;
  uint64_t trials = 3000, seed = 0;
  bool full = false, seeded = false;
  std::string state;
};

struct Progress {
  std::mutex mutex;
  std::vector<char> done;
  size_t prefix = 0;                /* chunks finished, counted from the first without a gap */
  uint64_t checked = 0, before = 0; /* rays, segments, values; those of earlier runs */
  std::string failure;
  std::vector<double> seconds; /* a family, in the families' order */
  std::vector<uint64_t> family_rays, family_trials;
};

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/* FNV-1a of the program itself and the plan: a state of other code or other numbers is no place to go on
 * from. */
uint64_t fingerprint(const Options &options) {
  uint64_t h = UINT64_C(0xcbf29ce484222325);
  auto add = [&](unsigned char c) { h = (h ^ c) * UINT64_C(0x100000001b3); };
  if (std::FILE *self = std::fopen("/proc/self/exe", "rb")) {
    for (int c; (c = std::fgetc(self)) != EOF;) add(static_cast<unsigned char>(c));
    std::fclose(self);
  }
  for (uint64_t v : {static_cast<uint64_t>(options.family), options.trials, options.seed,
                     static_cast<uint64_t>(options.full)})
    for (int i = 0; i < 8; i++) add(static_cast<unsigned char>(v >> (8 * i)));
  return h;
}

void save(const std::string &path, uint64_t print_of_run, size_t prefix, uint64_t checked) {
  std::string part = path + ".part";
  std::FILE *file = std::fopen(part.c_str(), "w");
  if (file == nullptr) return;
  std::fprintf(file, "%016" PRIx64 " %zu %" PRIu64 "\n", print_of_run, prefix, checked);
  if (std::fclose(file) == 0) std::rename(part.c_str(), path.c_str());
}

bool load(const std::string &path, uint64_t print_of_run, size_t *prefix, uint64_t *checked) {
  std::FILE *file = std::fopen(path.c_str(), "r");
  if (file == nullptr) return false;
  uint64_t of = 0;
  bool good = std::fscanf(file, "%" SCNx64 " %zu %" SCNu64, &of, prefix, checked) == 3 && of == print_of_run;
  std::fclose(file);
  return good;
}

std::vector<const Family *> all_families() {
  std::vector<const Family *> all;
  for (const auto *list : {&triangle_families, &closed_mesh_families, &sphere_families, &secondary_families,
                           &depth_families, &coherence_families, &engine_families, &number_families,
                           &mirror_families})
    for (const Family &family : *list) all.push_back(&family);
  std::sort(all.begin(), all.end(), [](const Family *a, const Family *b) { return a->number < b->number; });
  return all;
}

/* Runs one trial; what went wrong, or nothing. */
std::string run_trial(const Family &family, uint64_t seed, uint64_t *checked) {
  Random random = {seed};
  try {
    *checked += family.run(random);
    return "";
  } catch (const Failure &failure) {
    return print("FAIL family %d (%s), seed %#" PRIx64 "\n", family.number, family.name, seed) +
           failure.text +
           print("\nreplay: torture --family %d --seed %#" PRIx64 " --trials 1\n", family.number, seed);
  }
}

bool number(const char *text, uint64_t *value) {
  char *end;
  *value = std::strtoull(text, &end, 0);
  return *text != '\0' && *text != '-' && *end == '\0';
}

bool parse(int argc, char **argv, Options *options) {
  for (int i = 1; i < argc; i++) {
    std::string name = argv[i];
    uint64_t value = 0;
    if (name == "--full") {
      options->full = true;
      continue;
    }
    if (i + 1 == argc) return false;
    const char *text = argv[++i];
    if (name == "--state") {
      options->state = text;
      continue;
    }
    if (!number(text, &value)) return false;
    if (name == "--family")
      options->family = static_cast<int>(value);
    else if (name == "--trials")
      options->trials = value;
    else if (name == "--jobs" && value >= 1 && value <= 256)
      options->jobs = static_cast<int>(value);
    else if (name == "--seed")
      options->seed = value, options->seeded = true;
    else
      return false;
  }
  return true;
}

} // namespace

int main(int argc, char **argv) {
  Options options;
  if (argc == 2 && (std::strcmp(argv[1], "--help") == 0 || std::strcmp(argv[1], "-h") == 0)) {
    std::fputs(usage, stdout);
    return 0;
  }
  if (!parse(argc, argv, &options)) {
    std::fputs(usage, stderr);
    return 2;
  }

  /* the plan */
  std::vector<const Family *> families;
  for (const Family *family : all_families())
    if (options.family == 0 || options.family == family->number) families.push_back(family);
  if (families.empty()) {
    std::fprintf(stderr, "torture: no family %d\n", options.family);
    return 2;
  }
  std::vector<Chunk> plan;
  std::vector<size_t> family_of;
  double cost_all = 0;
  for (size_t f = 0; f < families.size(); f++) {
    uint64_t trials = options.full ? families[f]->trials : options.trials;
    uint64_t seed = options.seeded ? options.seed : static_cast<uint64_t>(families[f]->number) << 56;
    /* about a fifth of a second each */
    uint64_t most = std::max<uint64_t>(1, static_cast<uint64_t>(200000 / families[f]->cost));
    for (uint64_t i = 0; i < trials; i += most) {
      plan.push_back({families[f], seed + i, std::min(most, trials - i)});
      family_of.push_back(f);
      cost_all += static_cast<double>(plan.back().count) * families[f]->cost;
    }
  }

  Progress progress;
  progress.done.assign(plan.size(), 0);
  progress.seconds.assign(families.size(), 0);
  progress.family_rays.assign(families.size(), 0);
  progress.family_trials.assign(families.size(), 0);
  uint64_t print_of_run = fingerprint(options);
  if (!options.state.empty() && load(options.state, print_of_run, &progress.prefix, &progress.before) &&
      progress.prefix <= plan.size()) {
    std::printf("going on from %s: %zu of %zu parts are done\n", options.state.c_str(), progress.prefix,
                plan.size());
  } else {
    progress.prefix = 0;
    progress.before = 0;
  }
  std::fill(progress.done.begin(), progress.done.begin() + static_cast<long>(progress.prefix), 1);
  double cost_skipped = 0, cost_done = 0;
  for (size_t i = 0; i < progress.prefix; i++)
    cost_skipped += static_cast<double>(plan[i].count) * plan[i].family->cost;

  std::atomic<size_t> next(progress.prefix);
  std::atomic<bool> stop(false);
  uint64_t saved_checked = progress.before; /* of the chunks before the prefix alone */
  std::vector<uint64_t> chunk_checked(plan.size(), 0);
  auto work = [&]() {
    for (;;) {
      size_t i = next++;
      if (i >= plan.size() || stop) return;
      const Chunk &chunk = plan[i];
      uint64_t checked = 0;
      std::string failure;
      Clock::time_point start = Clock::now();
      for (uint64_t j = 0; j < chunk.count && failure.empty() && !stop; j++)
        failure = run_trial(*chunk.family, chunk.first_seed + j, &checked);
      std::lock_guard<std::mutex> lock(progress.mutex);
      progress.seconds[family_of[i]] += seconds_since(start);
      progress.family_rays[family_of[i]] += checked;
      progress.family_trials[family_of[i]] += chunk.count;
      progress.checked += checked;
      if (!failure.empty()) {
        if (progress.failure.empty()) progress.failure = failure;
        stop = true;
        return;
      }
      if (stop) return;
      chunk_checked[i] = checked;
      progress.done[i] = 1;
      cost_done += static_cast<double>(chunk.count) * chunk.family->cost;
      while (progress.prefix < plan.size() && progress.done[progress.prefix])
        saved_checked += chunk_checked[progress.prefix++];
    }
  };

  std::vector<std::thread> threads;
  Clock::time_point start = Clock::now();
  for (int i = 0; i < options.jobs; i++) threads.emplace_back(work);

  /* a terminal gets a line that moves, anything else a line a minute */
  bool terminal = isatty(STDOUT_FILENO) != 0;
  double shown = 0, stored = 0;
  while (!stop) {
    {
      std::lock_guard<std::mutex> lock(progress.mutex);
      double now = seconds_since(start);
      bool end = progress.prefix == plan.size();
      if (!options.state.empty() && (now - stored > 5 || end)) {
        save(options.state, print_of_run, progress.prefix, saved_checked);
        stored = now;
      }
      if (end) break;
      if (now - shown > (terminal ? 0.5 : 60) && progress.prefix < plan.size()) {
        double rest = cost_done > 0 ? now * (cost_all - cost_skipped - cost_done) / cost_done : 0;
        std::printf("%sfamily %d, %.0f %% done, %.3g million checks, about %.0f min %02d s to go%s",
                    terminal ? "\r" : "", plan[progress.prefix].family->number,
                    100 * (cost_skipped + cost_done) / cost_all,
                    static_cast<double>(progress.before + progress.checked) / 1e6,
                    static_cast<double>(static_cast<int>(rest / 60)), static_cast<int>(rest) % 60,
                    terminal ? "    " : "\n");
        std::fflush(stdout);
        shown = now;
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  for (std::thread &thread : threads) thread.join();
  if (terminal) std::printf("\r%79s\r", "");
  if (!progress.failure.empty()) {
    std::fputs(progress.failure.c_str(), stdout);
    return 1;
  }
  std::printf("family  trials      checks      seconds  trials/s  what\n");
  for (size_t f = 0; f < families.size(); f++) {
    if (progress.family_trials[f] == 0) continue;
    std::printf(
        "%6d  %-10" PRIu64 "  %-10" PRIu64 "  %7.2f  %8.0f  %s\n", families[f]->number,
        progress.family_trials[f], progress.family_rays[f], progress.seconds[f],
        progress.seconds[f] > 0 ? static_cast<double>(progress.family_trials[f]) / progress.seconds[f] : 0.0,
        families[f]->name);
  }
  std::printf("%" PRIu64 " checks, 0 failures\n", progress.before + progress.checked);
  if (!options.state.empty()) std::remove(options.state.c_str());
  return 0;
}
