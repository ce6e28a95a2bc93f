#include "core/task_arena.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>

namespace percuss {

void run_in_arena(std::size_t count, std::size_t threads, void (*call)(const void* task, std::size_t i),
                  const void* task) {
  // Who waits here for others helps them, and does not begin something else that may want what waits for this. A loop
  // around this one that has failed does not end it: it would end without a word, its work half done.
  const auto run = [&] {
    tbb::task_group_context alone(tbb::task_group_context::isolated);
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(
          std::size_t{0}, count, [call, task](std::size_t i) { call(task, i); }, tbb::simple_partitioner(), alone);
    });
  };
  // No more than the machine has: oneTBB would complain on standard error and use no more anyway.
  const int most = tbb::this_task_arena::max_concurrency();
  const int wanted = threads == 0 ? most : std::min(most, static_cast<int>(threads));
  if (wanted == most) {  // the arena that this thread is in already: all its threads help with loops within loops
    run();
    return;
  }
  // Kept: threads that wait in an arena take up new work there at once, and take long to find another one.
  thread_local std::unique_ptr<tbb::task_arena> arena;
  if (!arena || arena->max_concurrency() != wanted) arena = std::make_unique<tbb::task_arena>(wanted);
  arena->execute(run);
}

}  // namespace percuss
