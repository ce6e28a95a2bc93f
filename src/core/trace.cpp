#include "core/trace.hpp"

namespace percuss {
inline namespace core {

void Trace::add(const char* stage, std::size_t calls, double seconds) {
  const std::scoped_lock lock(mutex_);
  Stage& entry = stages_[stage];
  entry.calls += calls;
  entry.seconds += seconds;
}

std::vector<Trace::Stage> Trace::stages() const {
  const std::scoped_lock lock(mutex_);
  std::vector<Stage> out;
  out.reserve(stages_.size());
  for (const auto& [name, stage] : stages_) out.push_back({name, stage.calls, stage.seconds});
  return out;
}

Trace::Timer::~Timer() {
  trace.add(stage, 1, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

}  // namespace core
}  // namespace percuss
