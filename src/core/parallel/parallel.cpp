#include "core/parallel/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/parallel/task_arena.hpp"

namespace percuss::inline core {
namespace {

using Task = std::function<void(std::size_t)>;

constexpr std::size_t kMinParallelFlops =
    400'000;  // operations, about 0.1 ms: waking another thread takes a third of that
constexpr std::size_t kChunkSize = 512;

thread_local std::size_t allowed_threads = 0;
thread_local LoopObserver* loop_observer = nullptr;

std::atomic<void (*)()> thread_initialiser{nullptr};
thread_local bool thread_initialised = false;

void initialise_this_thread() {
  thread_initialised = true;
  if (const auto call = thread_initialiser.load()) call();
}

// oneTBB orders a task after what came before parallel_for, and what follows after the task. These say so once more, to
// a thread sanitizer, which does not see into the library.
std::atomic<std::size_t> begun{0}, ended{0};

struct AtEnd {  // also of a task that throws
  void (*say)();
  ~AtEnd() { say(); }
};

struct ObservedLoop {
  LoopObserver* observer;
  explicit ObservedLoop(LoopObserver* by) : observer(by) {
    if (observer != nullptr) observer->loop_started();
  }
  ~ObservedLoop() {
    if (observer != nullptr) observer->loop_finished();
  }
  ObservedLoop(const ObservedLoop&) = delete;
  ObservedLoop& operator=(const ObservedLoop&) = delete;
};

void call_in_order(const void* task, std::size_t i) {
  begun.load(std::memory_order_acquire);
  if (!thread_initialised) initialise_this_thread();
  const AtEnd end{[] { ended.fetch_add(1, std::memory_order_release); }};
  (*static_cast<const Task*>(task))(i);
}

}  // namespace

void parallel_for(std::size_t count, std::size_t threads, const Task& task) {
  if (threads == 1 || count < 2) {
    for (std::size_t i = 0; i < count; ++i) task(i);
    return;
  }
  const ObservedLoop watched{loop_observer};
  begun.fetch_add(1, std::memory_order_release);
  const AtEnd end{[] { ended.load(std::memory_order_acquire); }};
  run_in_arena(count, threads, call_in_order, &task);
}

ThreadLimit::ThreadLimit(std::size_t threads) : before_(std::exchange(allowed_threads, threads)) {}
ThreadLimit::~ThreadLimit() { allowed_threads = before_; }
std::size_t ThreadLimit::here() { return allowed_threads; }

void set_thread_initialiser(void (*call)()) {
  thread_initialised = true;
  thread_initialiser = call;
}

LoopObserver* set_loop_observer(LoopObserver* observer) { return std::exchange(loop_observer, observer); }

void parallel_for_cost(std::size_t count, std::size_t operations, const Task& task) {
  const bool worth_it = count > 1 && operations > kMinParallelFlops / count;
  parallel_for(count, worth_it ? allowed_threads : 1, [limit = allowed_threads, &task](std::size_t i) {
    const ThreadLimit same(limit);  // for what the task shares out in its turn
    task(i);
  });
}

void parallel_for_chunks(std::size_t size, std::size_t operations,
                         const std::function<void(std::size_t, std::size_t)>& task) {
  parallel_for_cost((size + kChunkSize - 1) / kChunkSize, operations * kChunkSize, [&](std::size_t chunk) {
    const std::size_t first = chunk * kChunkSize;
    task(first, std::min(kChunkSize, size - first));
  });
}

}  // namespace percuss::inline core
