#include "core/parallel/task_arena.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <memory>

namespace percuss::inline core {
namespace {

// No more than the machine has: oneTBB would complain on standard error and use no more anyway.
int allowed(std::size_t threads) {
  const int most = tbb::this_task_arena::max_concurrency();
  return threads == 0 || threads > static_cast<std::size_t>(most) ? most : static_cast<int>(threads);
}

template <class Run>
void within_arena(std::size_t threads, const Run& run) {
  const int wanted = allowed(threads);
  if (wanted == tbb::this_task_arena::max_concurrency()) {
    run();  // in the arena that this thread is in already: all its threads help with loops within loops
    return;
  }
  // Kept: threads that wait in an arena take up new work there at once, and take long to find another one.
  thread_local std::unique_ptr<tbb::task_arena> arena;
  if (!arena || arena->max_concurrency() != wanted) arena = std::make_unique<tbb::task_arena>(wanted);
  arena->execute(run);
}

}  // namespace

void run_in_arena(std::size_t count, std::size_t threads, void (*call)(const void* task, std::size_t i),
                  const void* task) {
  // Who waits here for others helps them, and does not begin something else that may want what waits for this. A loop
  // around this one that has failed does not end it: it would end without a word, its work half done.
  within_arena(threads, [&] {
    tbb::task_group_context alone(tbb::task_group_context::isolated);
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(
          std::size_t{0}, count, [call, task](std::size_t i) { call(task, i); }, tbb::simple_partitioner(), alone);
    });
  });
}

std::size_t arena_concurrency(std::size_t threads) { return static_cast<std::size_t>(allowed(threads)); }

void enqueue_in_arena(std::size_t threads, void (*call)(void* with), void* with) {
  within_arena(threads, [&] {
    tbb::task_arena here{tbb::task_arena::attach{}};
    here.enqueue([call, with] { call(with); });
  });
}

}  // namespace percuss::inline core
