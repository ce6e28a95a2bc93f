#pragma once
#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace percuss::inline core {

/// What ran: stage names with calls and seconds, ordered by name. Threads may add at once.
class Trace {
 public:
  struct Stage {
    std::string name;
    std::size_t calls = 0;
    double seconds = 0;
  };

  /// Runs `work`, counts one call of `stage` and its wall time, and passes the result on.
  template <class Work>
  auto run(const char* stage, Work&& work) {
    const Timer timer{*this, stage};
    return std::forward<Work>(work)();
  }
  /// The same of a part of a stage: no call is counted.
  template <class Work>
  auto run_part(const char* stage, Work&& work) {
    const Timer timer{*this, stage, 0};
    return std::forward<Work>(work)();
  }
  void add(const char* stage, std::size_t calls, double seconds);
  std::vector<Stage> stages() const;

 private:
  struct Timer {
    Trace& trace;
    const char* stage;
    std::size_t calls = 1;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Timer();
  };
  mutable std::mutex mutex_;
  std::map<std::string, Stage> stages_;
};

}  // namespace percuss::inline core
