#pragma once
#include <atomic>
#include <chrono>
#include <functional>
#include <vector>

namespace percuss::batch {

/// Repeats work that a fault of the machine stops: one more attempt after each of the waits. If the last attempt fails,
/// later work is tried only once, until end_of_fault(): a thousand records must not wait a thousand times. Several
/// threads may call at the same time.
class Retries {
 public:
  /// The waits must outlive the object.
  explicit Retries(const std::vector<std::chrono::milliseconds>& waits) : waits_(waits) {}

  /// errors  MachineFault: the last attempt failed; the other errors of `work`
  void run(const std::function<void()>& work);
  /// Call it after work has succeeded: later work is then repeated again.
  void end_of_fault() { fault_lasts_ = false; }

 private:
  const std::vector<std::chrono::milliseconds>& waits_;
  std::atomic<bool> fault_lasts_{false};
};

}  // namespace percuss::batch
