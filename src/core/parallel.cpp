#include "core/parallel.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace percuss {

void parallel_for(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& task) {
  if (threads == 1 || count < 2) {
    for (std::size_t i = 0; i < count; ++i) task(i);
    return;
  }
  // No more than the machine has: oneTBB would complain on standard error and use no more anyway.
  const int most = tbb::this_task_arena::max_concurrency();
  tbb::task_arena arena(threads == 0 ? most : std::min(most, static_cast<int>(threads)));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, task); });
}

}  // namespace percuss
