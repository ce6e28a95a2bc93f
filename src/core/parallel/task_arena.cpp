#include "core/parallel/task_arena.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <memory>

#include "core/parallel/per_thread.hpp"

namespace percuss {
inline namespace core {
namespace {

// At most the processors of the machine: oneTBB warns on standard error when asked for more.
int concurrency(std::size_t threads) {
  const int most = tbb::this_task_arena::max_concurrency();
  return threads == 0 || threads > static_cast<std::size_t>(most) ? most : static_cast<int>(threads);
}

template <class Run>
void within_arena(std::size_t threads, const Run& run) {
  const int wanted = concurrency(threads);
  if (wanted == tbb::this_task_arena::max_concurrency()) {
    run();  // in the current arena: all its threads help with nested loops
    return;
  }
  // Kept: threads that wait in an arena take new work there at once, but need long to enter another arena.
  static const PerThread<std::unique_ptr<tbb::task_arena>> arenas;
  std::unique_ptr<tbb::task_arena>& arena = arenas.local();
  if (!arena || arena->max_concurrency() != wanted) arena = std::make_unique<tbb::task_arena>(wanted);
  arena->execute(run);
}

}  // namespace

void run_in_arena(std::size_t count, std::size_t threads, void (*call)(const void* task, std::size_t i),
                  const void* task) {
  within_arena(threads, [&] {
    // An outer loop that fails must not cancel this loop, which would then return before all its tasks are done.
    tbb::task_group_context own_context(tbb::task_group_context::isolated);
    // Isolated: a waiting thread never steals an outer task that depends on this loop.
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(
          std::size_t{0}, count, [call, task](std::size_t i) { call(task, i); }, tbb::simple_partitioner(),
          own_context);
    });
  });
}

}  // namespace core
}  // namespace percuss
