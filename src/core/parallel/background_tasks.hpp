#pragma once
#include <cstddef>
#include <functional>
#include <memory>

namespace percuss::inline core {

class LoopObserver;

/// Work that nobody waits for yet: while it lives, other threads that the ThreadLimit here allows take up one task
/// after the other when this thread's loops leave them idle, and leave off when a loop wants them. On one thread
/// finish() does it all. Tasks write only to places of their own; what they share out stays on their thread.
class BackgroundTasks {
 public:
  BackgroundTasks(std::size_t count, std::function<void(std::size_t)> task);
  ~BackgroundTasks();  // begins no more, and waits for what has begun
  BackgroundTasks(const BackgroundTasks&) = delete;
  BackgroundTasks& operator=(const BackgroundTasks&) = delete;

  /// Does the rest and returns when all is done.
  /// errors  what a task threw; of several, the one of the lowest index
  void finish();

 private:
  class Work;
  std::shared_ptr<Work> work_;
  LoopObserver* previous_observer_;
};

}  // namespace percuss::inline core
