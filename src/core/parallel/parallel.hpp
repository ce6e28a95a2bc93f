#pragma once
#include <cstddef>
#include <functional>

namespace percuss::inline core {

/// Calls task(0) … task(count − 1), each once, on at most `threads` threads (0: as many as the machine has; 1: here, in
/// order). Tasks write only to places of their own, so that the result does not depend on the number of threads. The
/// first exception thrown by a task is passed on.
void parallel_for(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& task);

/// While it lives, parallel_for_cost on this thread uses at most so many (0: as many as the machine has, as without
/// one).
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;
  static std::size_t here();

 private:
  std::size_t before_;
};

/// Operations of a complex number times a real one and its place in a sum, for parallel_for_cost.
inline constexpr std::size_t kFlopsPerProduct = 4;

/// parallel_for on the threads that a ThreadLimit allows, or here where the whole is too
/// little to be worth waking others. `operations`: about how many floating-point operations a task takes.
void parallel_for_cost(std::size_t count, std::size_t operations, const std::function<void(std::size_t)>& task);

/// parallel_for_cost of 0 … size − 1 in strips that follow each other: task(first, count). `operations`: of each single
/// one.
void parallel_for_chunks(std::size_t size, std::size_t operations,
                         const std::function<void(std::size_t first, std::size_t count)>& task);

/// Other threads make this call once, before they first help with a loop: for what belongs to a thread, as its memory.
void set_thread_initialiser(void (*call)());

/// Is told when a loop of its thread begins to want other threads, and when it wants them no more.
class LoopObserver {
 public:
  virtual void loop_started() = 0;
  virtual void loop_finished() = 0;

 protected:
  ~LoopObserver() = default;
};

/// From now on this thread's loops tell `watch` (nullptr: nobody); returns whom they told before.
LoopObserver* set_loop_observer(LoopObserver* observer);

}  // namespace percuss::inline core
