#pragma once
#include <cstddef>
#include <functional>

namespace percuss {
inline namespace core {

/// Calls task(0) … task(count − 1), each once, on at most `threads` threads (0: all processors; 1: the calling thread,
/// in order). Tasks write only to data of their own, so that results do not depend on the number of threads.
/// errors  the first exception that a task throws
void parallel_for(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& task);

/// During its lifetime, parallel_for_cost and parallel_for_chunks on this thread use at most `threads` threads (0: all
/// processors, the default).
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  std::size_t before_;
};

/// Floating-point operations of a complex number times a real one, added to a sum.
inline constexpr std::size_t kFlopsPerProduct = 4;

/// parallel_for within the ThreadLimit of the calling thread. A loop too short to repay the start of other threads runs
/// on the calling thread. `flops`: about how many floating-point operations each task takes.
void parallel_for_cost(std::size_t count, std::size_t flops, const std::function<void(std::size_t)>& task);

/// parallel_for_cost over 0 … size − 1 in chunks of consecutive indices: task(first, count). `flops` of each index.
void parallel_for_chunks(std::size_t size, std::size_t flops,
                         const std::function<void(std::size_t first, std::size_t count)>& task);

/// Each thread except the calling one calls `initialise` once, before its first task of a parallel loop.
void set_thread_initialiser(void (*initialise)());

}  // namespace core
}  // namespace percuss
