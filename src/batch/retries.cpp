#include "batch/retries.hpp"

#include <thread>

#include "core/error.hpp"

namespace percuss::batch {

void Retries::run(const std::function<void()>& work) {
  for (auto wait = waits_.begin();; ++wait) {
    try {
      return work();
    } catch (const MachineFault&) {
      // Another thread may clear fault_lasts_ at any time: only the comparison with the end keeps `wait` within waits_.
      const bool last_attempt = wait == waits_.end();
      if (last_attempt) fault_lasts_ = true;
      if (last_attempt || fault_lasts_) throw;
    }
    std::this_thread::sleep_for(*wait);
  }
}

}  // namespace percuss::batch
