#include "core/parallel/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/budget.hpp"
#include "core/parallel/task_arena.hpp"
#include "core/parallel/thread_limit.hpp"

namespace percuss {
inline namespace core {
namespace {

using Task = std::function<void(std::size_t)>;

constexpr std::size_t kMinParallelFlops = 400'000;  // about 0.1 ms; waking another thread takes a third of that
constexpr std::size_t kChunkSize = 512;

thread_local std::size_t thread_limit = 0;

std::atomic<void (*)()> thread_initialiser{nullptr};
thread_local bool thread_initialised = false;

void initialise_this_thread() {
  thread_initialised = true;
  if (const auto initialise = thread_initialiser.load()) initialise();
}

// oneTBB guarantees an order: the code before parallel_for, the tasks, the code after it. The thread sanitizer does not
// see this order in the library; these counters make it visible.
std::atomic<std::size_t> loops_begun{0}, tasks_ended{0};

// Counts an ended task, also one that throws.
struct TaskEnd {
  ~TaskEnd() { tasks_ended.fetch_add(1, std::memory_order_release); }
};
struct LoopEnd {
  ~LoopEnd() { tasks_ended.load(std::memory_order_acquire); }
};

// The tasks of one loop, and the budget of the thread that started it.
struct Loop {
  const Task& task;
  BudgetMeter* budget;
};

void run_task(const void* loop, std::size_t i) {
  loops_begun.load(std::memory_order_acquire);
  if (!thread_initialised) initialise_this_thread();
  const TaskEnd end{};
  const auto& [task, budget] = *static_cast<const Loop*>(loop);
  const CheckedBudget checked(budget);
  check_budget();
  task(i);
}

}  // namespace

void parallel_for(std::size_t count, std::size_t threads, const Task& task) {
  if (threads == 1 || count < 2) {
    for (std::size_t i = 0; i < count; ++i) {
      check_budget();
      task(i);
    }
    return;
  }
  const Loop loop{.task = task, .budget = current_budget()};
  loops_begun.fetch_add(1, std::memory_order_release);
  const LoopEnd end{};
  run_in_arena(count, threads, run_task, &loop);
}

ThreadLimit::ThreadLimit(std::size_t threads) : before_(std::exchange(thread_limit, threads)) {}
ThreadLimit::~ThreadLimit() { thread_limit = before_; }

std::size_t current_thread_limit() { return thread_limit; }

void set_thread_initialiser(void (*initialise)()) {
  thread_initialised = true;
  thread_initialiser = initialise;
}

void parallel_for_cost(std::size_t count, std::size_t flops, const Task& task) {
  const bool parallel = count > 1 && flops > kMinParallelFlops / count;
  parallel_for(count, parallel ? thread_limit : 1, [limit = thread_limit, &task](std::size_t i) {
    const ThreadLimit inherited(limit);  // for loops within the task
    task(i);
  });
}

void parallel_for_chunks(std::size_t size, std::size_t flops,
                         const std::function<void(std::size_t, std::size_t)>& task) {
  parallel_for_cost((size + kChunkSize - 1) / kChunkSize, flops * kChunkSize, [&](std::size_t chunk) {
    const std::size_t first = chunk * kChunkSize;
    task(first, std::min(kChunkSize, size - first));
  });
}

}  // namespace core
}  // namespace percuss
