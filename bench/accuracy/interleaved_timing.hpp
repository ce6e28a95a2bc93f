#pragma once
#include <algorithm>
#include <ctime>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace percuss::accuracy {

/// The minimum number of turns and the minimum total time of a comparison. Each task runs once or more in each turn.
struct TimingOptions {
  int min_turns = 4;
  double min_total_s = 0.5;
  double min_task_s = 0.002;  // a short task repeats within its turn until this time has passed
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

/// Runs several tasks in alternation and returns the best time of each, so a disturbance affects all alike. The order
/// changes in each turn, because a task depends on the caches that its predecessor leaves. The result has one time per
/// task, in the order of `works`.
inline std::vector<double> best_interleaved_s(const std::vector<std::function<void()>>& works,
                                              const TimingOptions& turns) {
  std::vector<double> best_s(works.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> order(works.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random(1);
  double spent_s = 0;
  for (int turn = 0; turn < turns.min_turns || spent_s < turns.min_total_s; ++turn) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order) {
      double task_s = 0;
      do {
        const double one_s = processor_s_of(works[i]);
        best_s[i] = std::min(best_s[i], one_s);
        task_s += one_s;
      } while (task_s < turns.min_task_s);
      spent_s += task_s;
    }
  }
  return best_s;
}

}  // namespace percuss::accuracy
