#pragma once
#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace percuss {
inline namespace core {

/// The stages that ran, with calls and seconds, ordered by name. Several threads may add at the same time.
class Trace {
 public:
  struct Stage {
    std::string name;
    std::size_t calls = 0;
    double seconds = 0;
  };

  /// Runs `work`, adds one call of `stage` and its wall time, and returns the result.
  template <class Work>
  auto run(const char* stage, Work&& work) {
    const Timer timer{*this, stage};
    return std::forward<Work>(work)();
  }
  void add(const char* stage, std::size_t calls, double seconds);
  std::vector<Stage> stages() const;

 private:
  struct Timer {
    Trace& trace;
    const char* stage;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Timer();
  };
  mutable std::mutex mutex_;
  std::map<std::string, Stage> stages_;
};

}  // namespace core
}  // namespace percuss
