/* Named trials from seeds: what the volume tests are made of. */
#ifndef VOLUME_TRIALS_H
#define VOLUME_TRIALS_H

#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "vec.h"

extern "C" {
#include "fixcast/vec3.h"
}

struct Wrong {
  std::string text;
};

[[noreturn]] __attribute__((format(printf, 1, 2))) inline void wrong(const char *format, ...) {
  char buffer[2000];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  throw Wrong{buffer};
}

inline fc_vec3 to_core(Vec v) {
  return {static_cast<int32_t>(v.x), static_cast<int32_t>(v.y), static_cast<int32_t>(v.z)};
}
inline Vec from_core(fc_vec3 v) { return {v.x, v.y, v.z}; }

inline std::string text(Vec v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

/* Answers seen by the trial that runs: one that only ever sees one of them checks nothing. */
struct Answers {
  uint64_t yes = 0, no = 0;
};
inline Answers &answers() {
  static Answers all;
  return all;
}
inline void saw(bool yes) { yes ? answers().yes++ : answers().no++; }

struct Trial {
  const char *name;
  uint64_t count; /* seeds */
  void (*run)(Random &random);
};

/* Sanitizers make everything some ten times slower. */
#ifdef __SANITIZE_ADDRESS__
constexpr uint64_t trials_share = 20;
#else
constexpr uint64_t trials_share = 1;
#endif

/* PROGRAM [--only NAME --seed S]: all trials, or one of them again. */
inline int run_trials(int argc, char **argv, const std::vector<Trial> &trials) {
  const char *only = nullptr;
  uint64_t seed = 0;
  if (argc == 5 && std::strcmp(argv[1], "--only") == 0 && std::strcmp(argv[3], "--seed") == 0) {
    only = argv[2];
    seed = std::strtoull(argv[4], nullptr, 0);
  } else if (argc != 1) {
    std::fprintf(stderr, "usage: %s [--only NAME --seed S]\n", argv[0]);
    return 2;
  }
  int failed = 0, ran = 0;
  for (const Trial &trial : trials) {
    if (only != nullptr && std::strcmp(only, trial.name) != 0) continue;
    ran++;
    answers() = Answers();
    uint64_t i = only != nullptr ? seed : 0,
             end = only != nullptr ? seed + 1 : (trial.count + trials_share - 1) / trials_share;
    for (; i < end; i++) {
      Random random = {i};
      try {
        trial.run(random);
      } catch (const Wrong &w) {
        std::printf("FAIL %s, seed %llu: %s\nreplay: %s --only %s --seed %llu\n", trial.name,
                    static_cast<unsigned long long>(i), w.text.c_str(), argv[0], trial.name,
                    static_cast<unsigned long long>(i));
        failed++;
        break;
      }
    }
    if (i != end) continue;
    const uint64_t yes = answers().yes, no = answers().no;
    std::printf("%10llu  %s", static_cast<unsigned long long>(i), trial.name);
    if (yes + no > 0)
      std::printf(" (%llu yes, %llu no)", static_cast<unsigned long long>(yes),
                  static_cast<unsigned long long>(no));
    std::printf("\n");
    std::fflush(stdout);
    if (only == nullptr && yes + no > 0 && (yes < (yes + no) / 20 || no < (yes + no) / 20)) {
      std::printf("FAIL %s: hardly ever sees one of the two answers\n", trial.name);
      failed++;
    }
  }
  if (ran == 0) {
    std::fprintf(stderr, "%s: no trial of that name\n", argv[0]);
    return 2;
  }
  return failed == 0 ? 0 : 1;
}

#endif
