#pragma once
#include <algorithm>
#include <ctime>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace percuss::accuracy {

/// How long works that are compared take their turns: at least so many times each, and for so long.
struct TimingOptions {
  int least = 4;
  double least_s = 0.5;
  double each_s = 0.002;  // a short work is done again within its turn until so much has passed
};

/// This process's processor time: other work on the machine takes turns with it, and does not count.
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

/// The best time of each of several works done by turns, so that a disturbed moment neither flatters nor blames; each
/// turn has another order, as what ran before leaves caches and memory in one state or another. shapes: result as
/// `works`.
inline std::vector<double> best_interleaved_s(const std::vector<std::function<void()>>& works,
                                              const TimingOptions& turns) {
  std::vector<double> best_s(works.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> order(works.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random(1);
  double spent_s = 0;
  for (int turn = 0; turn < turns.least || spent_s < turns.least_s; ++turn) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order) {
      double turn_s = 0;
      do {
        const double one_s = processor_s_of(works[i]);
        best_s[i] = std::min(best_s[i], one_s);
        turn_s += one_s;
      } while (turn_s < turns.each_s);
      spent_s += turn_s;
    }
  }
  return best_s;
}

}  // namespace percuss::accuracy
