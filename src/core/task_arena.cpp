#include "core/task_arena.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace percuss {

void run_in_arena(std::size_t count, std::size_t threads, void (*call)(const void* task, std::size_t i),
                  const void* task) {
  // No more than the machine has: oneTBB would complain on standard error and use no more anyway.
  const int most = tbb::this_task_arena::max_concurrency();
  tbb::task_arena arena(threads == 0 ? most : std::min(most, static_cast<int>(threads)));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, [call, task](std::size_t i) { call(task, i); }); });
}

}  // namespace percuss
