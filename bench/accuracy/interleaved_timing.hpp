#pragma once
#include <algorithm>
#include <ctime>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace percuss::accuracy {

/// The minimum number of rounds and the minimum total time of a comparison. A round runs each of the compared
/// functions once or more.
struct TimingOptions {
  int min_rounds = 4;
  double min_total_s = 0.5;
  double min_work_s = 0.002;  // a short function repeats within a round until this time has passed
};

/// The processor time of this process: other work on the machine does not count.
inline double processor_s() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double processor_s_of(const std::function<void()>& work) {
  const double start_s = processor_s();
  work();
  return processor_s() - start_s;
}

/// Runs several functions in alternation and returns the best time of each, so a disturbance affects all alike. The
/// order changes in each round, because a function's time depends on the caches that its predecessor leaves. The result
/// has one time per function, in the order of `works`.
inline std::vector<double> best_interleaved_s(const std::vector<std::function<void()>>& works,
                                              const TimingOptions& timing) {
  std::vector<double> best_s(works.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> order(works.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random(1);
  double spent_s = 0;
  for (int round = 0; round < timing.min_rounds || spent_s < timing.min_total_s; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order) {
      double work_s = 0;
      do {
        const double one_s = processor_s_of(works[i]);
        best_s[i] = std::min(best_s[i], one_s);
        work_s += one_s;
      } while (work_s < timing.min_work_s);
      spent_s += work_s;
    }
  }
  return best_s;
}

}  // namespace percuss::accuracy
